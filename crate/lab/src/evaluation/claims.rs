//! The secondary claims about the models, most of them of the papers, checked with results.
//!
//! A claim is a sentence of a paper. Our criterion is about an interval, and the answer is "yes" or "no" only
//! if the whole interval agrees.

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::candidate_text::size_numbers;
use crate::evaluation::correlation::{by_preference, correlation, training_correlation};
use crate::evaluation::effect::{Choice, Contender, Effect, Errors};
use crate::evaluation::fixed::fixed;
use crate::evaluation::labels::Labels;
use crate::evaluation::primary::{self, NEARLY, NOT_IN_PAPERS, by_person, each_person, paired};
use crate::evaluation::rows::{Row, common_folds, groups, is_plain, settings};
use crate::evaluation::stats::{Interval, times_needed};
use crate::evaluation::summary::{Claim, ClaimAnswer, Correlation, Growth};
use std::collections::BTreeSet;
use std::ops::{Not, Range};
use vcgpdm_core::elementary::Elementary;
use vcgpdm_core::models::ModelKind::{DmpDiscrete, DmpRhythmic, MapCgpdm, MapGpdm, Tmp, Vcgpdm, Vgpdm};
use vcgpdm_core::models::{ModelKind, Settings, VariationalSettings};
use vcgpdm_core::plural::counted;

/// A sentence of a paper, with its year and section.
struct Sentence(&'static str, &'static str);

const MAP_IS_WORSE_TOO: Sentence =
    Sentence("The vCGPDM predicts better than MAP models that the papers did not try", NOT_IN_PAPERS);
const BEST: Sentence = Sentence(
    "\u{201c}Of all tested models, the 2-part vCGPDM performs best in terms of MSE.\u{201d}",
    "2017, section 3.2",
);
const BEST_OF_MORE_PARTS: Sentence =
    Sentence("The vCGPDM predicts better than every other model", NOT_IN_PAPERS);
const THREE_PARTS_GAIN_NOTHING: Sentence = Sentence(
    "\u{201c}The vCGPDM with three parts for 'passing a bottle' does not show a clear advantage over the monolithic model\u{201d}",
    "2018, section 5.3",
);
const THREE_PARTS_EQUAL_TMP: Sentence =
    Sentence("\u{201c}... and is on par with the TMP model.\u{201d}", "2018, section 5.3");
const BOUND_CHOOSES: Sentence = Sentence(primary::BOUND_CHOOSES, "2018, section 5.3");
const BOUND_CORRELATES_AT_POINTS: Sentence = Sentence(
    "\u{201c}The negative correlation between ELBO and MSE for a given number of LVM IPs is clearly visible.\u{201d}",
    "2017, supplement, section 4, figure 1",
);
const BOUND_CORRELATES: Sentence = Sentence(
    "\u{201c}The negative correlation between MSE and ELBO is clearly visible.\u{201d}",
    "2017, section 3.2",
);
const BOUND_CHOOSES_SPLITS: Sentence = Sentence(
    "\u{201c}To compare two parametric models, we can compute the ratio of their probabilities, known as Bayes factor.\u{201d} Here: of one part and several",
    "2020, section 2.2",
);
const BOUND_TELLS_TRAINING: Sentence = Sentence(
    "\u{201c}MSE and therefore confusion rate can be predicted well from ELBO if ELBO > 28,500.\u{201d} Here: the MSE on the training data, at any bound.",
    "2018, figure 6B",
);
const DYNAMICS_COUNT_MORE: Sentence = Sentence(
    "\u{201c}Additional dynamics IPs contribute more to the reduction of the MSE than latent-to-observed IPs.\u{201d}",
    "2018, figure 6B",
);
/// A number near which the papers found the smallest error.
struct Optimum {
    sentence: Sentence,
    /// The number.
    best: usize,
    /// What is counted.
    what: &'static str,
    kinds: &'static [ModelKind],
}

const OPTIMA: [Optimum; 4] = [
    Optimum {
        sentence: Sentence(
            "\u{201c}The MSE optima were near 10\u{2013}15 IPs for both the walking and the walking + waving datasets\u{201d}",
            "2018, section 5.3",
        ),
        best: 12,
        what: "inducing points of dynamics and of poses",
        kinds: &[Vcgpdm, Vgpdm],
    },
    Optimum {
        sentence: Sentence(
            "\u{201c}For the TMPs, we used up to 10 primitives; the MSE optimum was located at approximately six.\u{201d}",
            "2018, section 5.3",
        ),
        best: 6,
        what: "primitives",
        kinds: &[Tmp],
    },
    Optimum {
        sentence: Sentence(
            "\u{201c}For the DMPs, we used between 1 and 50 basis functions, and the lowest MSE was found around 15.\u{201d}",
            "2018, section 5.3",
        ),
        best: 15,
        what: "bases",
        kinds: &[DmpDiscrete, DmpRhythmic],
    },
    Optimum {
        sentence: Sentence(
            "\u{201c}The minimal predictive MSE, which is reached with 25 basis functions and increases from there on\u{201d}: DMP",
            "2019, section 4.2",
        ),
        best: 25,
        what: "bases",
        kinds: &[DmpDiscrete, DmpRhythmic],
    },
];
const TMP_CORRELATES: Sentence = Sentence(
    "\u{201c}MSE and ELBO of TMP models have similar predictive capabilities, as they are highly correlated in the investigated parameter regime.\u{201d}",
    "2019, section 4.3",
);
const LINEAR: Sentence = Sentence(
    "\u{201c}The linear learning time scaling of the vCGPDM is evident, ...\u{201d}",
    "2017, supplement, section 5",
);
const CUBIC: Sentence =
    Sentence("\u{201c}... whereas the MAP CGPDM shows cubic scaling.\u{201d}", "2017, supplement, section 5");

const LOWER: &str = "the error on the trial held out is lower: the interval of the ratio is below 1";
const OTHER_ORDERS: Sentence =
    Sentence("Dynamics of order 2 predict better than those of another order", NOT_IN_PAPERS);

/// Claims with their answers, and the folds of each person.
struct Claims<'a>(Vec<Claim>, &'a [Range<usize>]);

impl Claims<'_> {
    fn add(&mut self, sentence: &Sentence, criterion: &str, found: String, answer: ClaimAnswer) {
        let Sentence(claim, place) = sentence;
        let (claim, place, criterion) = ((*claim).to_owned(), (*place).to_owned(), criterion.to_owned());
        self.0.push(Claim { claim, place, criterion, found, answer, primary: false, persons: Vec::new() });
    }

    /// The ratio of errors as text, and whether it is below the limit. `None` without a trial that both have.
    fn compared(&self, a: &Errors, b: &Errors, limit: f64) -> Option<(String, ClaimAnswer)> {
        let effect = Effect::new(a, b)?;
        let answer = effect.is_below(limit);
        let persons = by_person(a, b, limit, self.1);
        let ratio = |logarithm: f64| limit * logarithm.exponential();
        Some((effect.text() + &each_person(answer, &persons, &ratio), answer))
    }

    /// Adds the claim that the errors of `a` are lower than `limit` times those of `b`.
    fn add_lower(&mut self, what: (&Sentence, &str), a: &Errors, b: &Errors, limit: f64, names: &str) {
        if let Some((text, answer)) = self.compared(a, b, limit) {
            self.add(what.0, what.1, format!("{names}: {text}"), answer);
        }
    }

    /// A correlation as text, and whether it is below 0.
    fn correlated(&self, c: &Correlation) -> (String, ClaimAnswer) {
        let interval = c.interval.map_or(String::new(), |interval| format!(" ({interval})"));
        let (rank, trials) = (fixed(c.rank, 2), counted(c.folds, "trial"));
        let (model, label, settings) = (c.model.title(), &c.label, c.settings);
        let answer = ClaimAnswer::below(c.interval, 0.0);
        let own = |folds: &Range<usize>| c.trials.range(folds.clone()).map(|(_, rank)| *rank).collect();
        let persons = each_person(answer, &self.1.iter().map(own).collect::<Vec<_>>(), &|rank| rank);
        (
            format!("{model}{label}: {rank}{interval} over {settings} settings (mean of {trials}){persons}"),
            answer,
        )
    }

    /// Adds the claim that the rank correlations of bound and error are all below 0.
    fn add_correlations(&mut self, sentence: &Sentence, criterion: &str, all: &[Correlation]) {
        let (texts, answers): (Vec<_>, Vec<_>) = all.iter().map(|c| self.correlated(c)).unzip();
        let Some(answer) = answers.into_iter().max() else { return };
        self.add(sentence, criterion, texts.join("; "), answer);
    }

    fn add_exponent(
        &mut self,
        sentence: &Sentence,
        criterion: &str,
        growth: &Growth,
        limit: f64,
        answer: impl Fn(ClaimAnswer) -> ClaimAnswer,
    ) {
        let power = |exponent: Option<f64>, interval: Option<Interval>| {
            let (exponent, interval) = exponent.zip(interval)?;
            Some((format!("{exponent:.2} ({interval})"), interval))
        };
        let iteration = power(growth.exponent, growth.interval);
        let whole = power(growth.training_exponent, growth.training_interval);
        if let (Some((iteration, _)), Some((whole, interval))) = (iteration, whole) {
            let answer = answer(ClaimAnswer::below(Some(interval), limit));
            let needed = times_needed(interval, growth.points.len(), limit)
                .filter(|_| answer == ClaimAnswer::Undecided)
                .map_or(String::new(), |times| {
                    let numbers = times * growth.points.len();
                    format!("; with the same range and spread, {numbers} numbers of frames would decide it")
                });
            let converged = growth.converged.map_or(String::new(), |share| {
                format!("; {:.0} % of these trainings converged", 100.0 * share)
            });
            let found = format!(
                "time of a training grows with the power {whole} of the frames, of an iteration with the power {iteration}, {} numbers of frames{converged}{needed}",
                growth.points.len()
            );
            self.add(sentence, criterion, found, answer);
        }
    }
}

/// The claims for which there are results.
pub(super) fn secondary_claims(
    rows: &[Row],
    people: &[Range<usize>],
    parts: usize,
    growth: &[Growth],
    labels: &Labels,
) -> Vec<Claim> {
    let contender = |kind: ModelKind, choice| Contender::new(settings(rows, kind, &is_plain), choice);
    let (vcgpdm, vgpdm) = (contender(Vcgpdm, Choice::Rollouts), contender(Vgpdm, Choice::Rollouts));
    let by_bound = (contender(Vcgpdm, Choice::Bound), contender(Vgpdm, Choice::Bound));
    let mut claims = Claims(Vec::new(), people);
    if let Some(vcgpdm) = &vcgpdm {
        against_map(&mut claims, vcgpdm, rows, labels);
        let sentence = if parts > 2 { &BEST_OF_MORE_PARTS } else { &BEST };
        against_all(&mut claims, sentence, vcgpdm, rows, labels);
    }
    other_orders(&mut claims, rows, [&vcgpdm, &vgpdm], labels);
    if let (Some(parts), Some(whole)) = &by_bound {
        let (preferred, other) = by_preference(parts, whole);
        let criterion =
            "of the split in parts and the whole body, the one with the higher bound has the lower error";
        let names = "the preferred one compared with the other";
        claims.add_lower((&BOUND_CHOOSES_SPLITS, criterion), &preferred, &other, 1.0, names);
    }
    for (by_rollouts, by_bound) in [(&vcgpdm, &by_bound.0), (&vgpdm, &by_bound.1)] {
        if let (Some(by_rollouts), Some(by_bound)) = (by_rollouts, by_bound)
            && by_bound.settings.len() > 2
        {
            bound_and_error(&mut claims, by_bound, by_rollouts, labels);
        }
    }
    for claim in &OPTIMA {
        claim.kinds.iter().for_each(|kind| optimum(&mut claims, rows, *kind, claim));
    }
    // The number that the bound chooses would count twice.
    let given = |c: &Candidate| matches!(c, Candidate::Model(Settings::Tmp(s)) if s.primitives.is_some());
    let criterion = "the rank correlation over the numbers of primitives, within each trial, is below 0 in the mean: its interval is";
    let found = correlation(&settings(rows, Tmp, &given), String::new(), labels);
    claims.add_correlations(&TMP_CORRELATES, criterion, found.as_slice());
    for growth in growth {
        match growth.model {
            CandidateKind::Model(Vcgpdm) => {
                let criterion = "the exponent is below 1.2";
                claims.add_exponent(&LINEAR, criterion, growth, 1.2, |answer| answer);
            }
            CandidateKind::Model(MapCgpdm) => {
                let criterion = "the exponent is above 2, more than quadratic: it reaches 3 only with more frames than these";
                claims.add_exponent(&CUBIC, criterion, growth, 2.0, ClaimAnswer::not);
            }
            _ => {}
        }
    }
    claims.0
}

/// The claims of the papers about three parts, compared with the whole body and with the TMP.
pub(super) fn three_part_claims(rows: &[Row], labels: &Labels) -> Vec<Claim> {
    let contender = |kind: ModelKind| Contender::new(settings(rows, kind, &is_plain), Choice::Rollouts);
    let mut claims = Claims(Vec::new(), &[]);
    let Some(three) = contender(Vcgpdm) else { return claims.0 };
    let mut add = |sentence, criterion, other: Option<Contender>, answer: fn(&Effect) -> ClaimAnswer| {
        let Some(other) = other else { return };
        if let Some(effect) = Effect::new(&three.errors, &other.errors) {
            let found =
                format!("{} compared with {}: {}", three.text(labels), other.text(labels), effect.text());
            claims.add(sentence, criterion, found, answer(&effect));
        }
    };
    let criterion = "the error is not lower by a tenth or more: the interval of the ratio is above 1 / 1.1";
    let no_gain = |effect: &Effect| !effect.is_below(1.0 / NEARLY);
    add(&THREE_PARTS_GAIN_NOTHING, criterion, contender(Vgpdm), no_gain);
    let criterion =
        "the errors differ by less than a tenth: the interval of the ratio is from 1 / 1.1 to 1.1";
    add(&THREE_PARTS_EQUAL_TMP, criterion, contender(Tmp), |effect| {
        (!effect.is_below(1.0 / NEARLY)).max(effect.is_below(NEARLY))
    });
    claims.0
}

/// The vCGPDM compared with the forms of both MAP models that the papers did not try. The others are in primary
/// claims.
fn against_map(claims: &mut Claims, parts: &Contender, rows: &[Row], labels: &Labels) {
    for kind in [MapGpdm, MapCgpdm] {
        let others = rows.iter().filter(|row| row.candidate.kind() == kind && !is_plain(row.candidate));
        for map in groups(others).into_iter().filter_map(|group| Contender::new(group, Choice::Rollouts)) {
            let names = format!("{} compared with {}", parts.text(labels), map.text(labels));
            claims.add_lower((&MAP_IS_WORSE_TOO, LOWER), &parts.errors, &map.errors, 1.0, &names);
        }
    }
}

/// Models of order 2 compared with the same models of order 1 and 3.
fn other_orders(claims: &mut Claims, rows: &[Row], models: [&Option<Contender>; 2], labels: &Labels) {
    for model in models.into_iter().flatten() {
        let parts = model.settings[0].candidate.kind() == Vcgpdm;
        for order in [1, 3] {
            let other = |s: &VariationalSettings| {
                let settings = s.clone().with_order(order);
                if parts { Settings::Vcgpdm(settings) } else { Settings::Vgpdm(settings) }
            };
            if let Some((plain, other)) = paired(rows, &model.settings, &other) {
                let names = format!("{} compared with {}", plain.text(labels), other.text(labels));
                claims.add_lower((&OTHER_ORDERS, LOWER), &plain.errors, &other.errors, 1.0, &names);
            }
        }
    }
}

/// The vCGPDM compared with every other model: it is the best if it is better than each, and not if one is
/// better.
fn against_all(claims: &mut Claims, sentence: &Sentence, parts: &Contender, rows: &[Row], labels: &Labels) {
    let mut answers = Vec::new();
    let mut found = Vec::new();
    for kind in CandidateKind::all().filter(|kind| *kind != Vcgpdm) {
        let Some(other) = Contender::new(settings(rows, kind, &is_plain), Choice::Rollouts) else {
            continue;
        };
        let Some(effect) = Effect::new(&parts.errors, &other.errors) else { continue };
        let range = effect.interval().map_or(String::new(), |i| format!(" ({i})"));
        let middle = if effect.median_interval.is_some() { effect.median } else { effect.mean };
        let answer = effect.is_below(1.0);
        let persons = by_person(&parts.errors, &other.errors, 1.0, claims.1);
        let persons = each_person(answer, &persons, &Elementary::exponential);
        found.push(format!(
            "{} times{range} {}, lower in {} of {}{}",
            fixed(middle, 2),
            other.text(labels),
            effect.wins,
            effect.folds,
            persons.replace("; ", ", ")
        ));
        answers.push(answer);
    }
    let Some(answer) = answers.into_iter().max() else { return };
    let criterion = "its error is lower than that of every other model";
    claims.add(sentence, criterion, found.join("; "), answer);
}

/// The relation of bound and error, over the sizes of a kind.
fn bound_and_error(claims: &mut Claims, kind: &Contender, by_rollouts: &Contender, labels: &Labels) {
    // That of the vCGPDM is a primary claim.
    let is_primary = kind.settings[0].candidate.kind() == Vcgpdm;
    if !is_primary {
        let names = primary::chosen_by_bound(kind);
        let criterion = "choosing by the bound costs less than a tenth, compared with choosing by rollouts: the interval of the ratio is below 1.1";
        claims.add_lower((&BOUND_CHOOSES, criterion), &kind.errors, &by_rollouts.errors, NEARLY, &names);
    }
    let first = claims.0.len();
    let poses = |row: &Row| size_numbers(row.candidate).1;
    let at_poses = |number: usize| {
        let rows: Vec<&Row> = kind.settings.iter().copied().filter(|row| poses(row) == number).collect();
        correlation(&rows, format!(", {number} pose points"), labels)
    };
    let numbers: BTreeSet<usize> = kind.settings.iter().map(|row| poses(row)).collect();
    let given: Vec<Correlation> = numbers.into_iter().filter_map(at_poses).collect();
    let criterion = "at each number of pose points, the rank correlation over the dynamics inducing points, within each trial, is below 0 in the mean: its interval is";
    claims.add_correlations(&BOUND_CORRELATES_AT_POINTS, criterion, &given);
    let criterion = "the rank correlation over all sizes together, within each trial, is below 0 in the mean: its interval is";
    let is_other = |all: &Correlation| given.iter().all(|one| one.settings < all.settings);
    let all = correlation(&kind.settings, ", all sizes".to_owned(), labels).filter(is_other);
    claims.add_correlations(&BOUND_CORRELATES, criterion, all.as_slice());
    let criterion = "any relation, not a good prediction: the rank correlation over the inducing points, within each trial, is below 0 in the mean: its interval is";
    let training = training_correlation(&kind.settings, labels);
    claims.add_correlations(&BOUND_TELLS_TRAINING, criterion, training.as_slice());
    dynamics_or_poses(claims, &kind.settings, labels);
    for claim in claims.0.iter_mut().skip(first).filter(|_| !is_primary) {
        claim.claim.push_str(" Said of the vCGPDM.");
    }
}

/// Whether inducing points help more in the dynamics than in the pose maps: k dynamics and l pose points
/// compared with l and k, for the largest difference of k and l that was tried both ways.
fn dynamics_or_poses(claims: &mut Claims, rows: &[&Row], labels: &Labels) {
    let numbers = |row: &Row| size_numbers(row.candidate);
    let turned = |row: &Row| {
        let (dynamics, poses) = numbers(row);
        rows.iter().find(|other| numbers(other) == (poses, dynamics))
    };
    let most_dynamics = rows.iter().filter(|row| numbers(row).0 > numbers(row).1 && turned(row).is_some());
    let Some(dynamics) = most_dynamics.max_by_key(|row| numbers(row).0 - numbers(row).1) else { return };
    let Some(poses) = turned(dynamics) else { return };
    let folds = common_folds(&[dynamics, poses]);
    let names = format!(
        "{}, on the training trials, {} compared with {}",
        dynamics.candidate.kind().title(),
        labels.label(dynamics.candidate),
        labels.label(poses.candidate)
    );
    let (a, b) = (dynamics.training_errors(&folds), poses.training_errors(&folds));
    let criterion = "with the same number of inducing points, more in the dynamics give a lower error: the interval of the ratio is below 1";
    claims.add_lower((&DYNAMICS_COUNT_MORE, criterion), &a, &b, 1.0, &names);
}

/// Whether the error is smallest near a number: higher with the fewest, and with the most.
fn optimum(claims: &mut Claims, rows: &[Row], kind: ModelKind, optimum: &Optimum) {
    let Optimum { sentence, best, what, .. } = optimum;
    // Points of dynamics and poses change together; a number that the bound chooses is none.
    let is_given = |candidate: &Candidate| {
        let (number, poses) = size_numbers(candidate);
        is_plain(candidate) && number > 0 && (poses == 0 || poses == number)
    };
    let rows = settings(rows, kind, &is_given);
    let number = |row: &Row| size_numbers(row.candidate).0;
    let middle = rows.iter().min_by_key(|row| number(row).abs_diff(*best));
    let (few, many) = (rows.iter().min_by_key(|row| number(row)), rows.iter().max_by_key(|row| number(row)));
    let (Some(middle), Some(few), Some(many)) = (middle, few, many) else { return };
    let (a, b, c) = (number(few), number(middle), number(many));
    if !(a < b && b < c) {
        return;
    }
    let folds = common_folds(&[few, middle, many]);
    let least = middle.errors(&folds);
    let with_least = |row: &Row| claims.compared(&row.errors(&folds), &least, 1.0);
    let (Some(fewer), Some(more)) = (with_least(few), with_least(many)) else { return };
    let texts = format!("{a} {what} compared with {b}: {}; {c} compared with {b}: {}", fewer.0, more.0);
    let (found, answer) = (format!("{}: {texts}", kind.title()), (!fewer.1).max(!more.1));
    let criterion = format!(
        "of the numbers tried, the fewest and the most have a higher error than the one nearest to {best}"
    );
    claims.add(sentence, &criterion, found, answer);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each person's median is the mean of two logarithms: -0.06 and -0.18. Five such persons have p = 2.9 %.
    #[test]
    fn says_how_many_persons_would_decide() {
        let errors = |values: [f64; 4]| values.into_iter().enumerate().collect::<Errors>();
        let (a, b, people) = (errors([0.8, 1.1, 0.7, 1.0]), errors([1.0; 4]), [0..2, 2..4]);
        let (text, answer) = Claims(Vec::new(), &people).compared(&a, &b, 1.0).unwrap();
        assert_eq!(answer, ClaimAnswer::Undecided);
        let five = "; Student's t test of 5 such persons would decide it";
        assert!(text.ends_with(five), "{text}");
        let trials = [-0.12, 0.0, -0.36, 0.0].into_iter().enumerate().collect();
        let interval = Some(Interval { low: -0.3, high: 0.1, level: 0.95 });
        let (model, label, points) = (Vcgpdm.into(), String::new(), Vec::new());
        let correlation =
            Correlation { model, label, settings: 3, folds: 4, rank: -0.12, interval, points, trials };
        let mut claims = Claims(Vec::new(), &people);
        claims.add_correlations(&BOUND_CORRELATES, "", &[correlation]);
        assert!(claims.0[0].found.ends_with(five), "{}", claims.0[0].found);
    }
}
