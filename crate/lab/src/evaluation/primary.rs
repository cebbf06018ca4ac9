//! The primary claims: at most ten, named before any table with them was made (docs/comparison/method.md). Each is
//! a test of its own, and Holm's correction keeps the probability of any false "yes" or "no" among them below
//! 5 %. All other claims are secondary.
//!
//! Within one person, the trials are the units: the sign test of the ratios of the errors, and for fewer than
//! six trials Student's t test of their logarithms. Over several persons the persons are the units: Student's
//! t test of the median logarithm of each person.

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::effect::{Choice, Contender, Effect, Errors};
use crate::evaluation::fixed::fixed;
use crate::evaluation::labels::Labels;
use crate::evaluation::rows::{Row, is_plain, settings};
use crate::evaluation::stats::{holm, mean, mean_interval, median, sign_test, student_test, values_needed};
use crate::evaluation::summary::{Claim, ClaimAnswer};
use std::ops::Range;
use vcgpdm_core::elementary::Elementary;
use vcgpdm_core::models::ModelKind::{DmpRhythmic, MapCgpdm, MapGpdm, Tmp, Vcgpdm, Vgpdm};
use vcgpdm_core::models::{Settings, VariationalSettings};
use vcgpdm_core::plural::counted;

const BETTER_THAN_MAP: &str = "\u{201c}It is significantly better than the full-capacity (no IPs) MAP models\u{201d}: the two-part vCGPDM";
const PARTS_PAY: &str =
    "The vCGPDM predicts better than the vGPDM, which the paper says particularly of walking + waving";
pub(super) const BOUND_CHOOSES: &str = "\u{201c}The best ELBO's MSE (that is, the MSE at the maximum of the ELBO) is a fairly good predictor of the best MSE\u{201d}";
const COUPLINGS_PAY: &str = "Coupled parts predict better than the same parts without couplings";
const NOT_ONLY_LARGER: &str =
    "Parts predict better than a whole body with as many latent dimensions and inducing points in all";

pub(super) const NOT_IN_PAPERS: &str = "not in the papers";
/// A ratio of errors below this is nearly 1.
pub(super) const NEARLY: f64 = 1.1;
/// Largest p value of a decision.
pub(super) const LARGEST_P: f64 = 0.05;
/// With fewer trials the sign test cannot decide.
pub(super) const FEWEST_TRIALS: usize = 6;

/// A claim that the ratio of two errors is below a limit.
struct Question<'a> {
    claim: String,
    place: &'static str,
    names: String,
    errors: (&'a Errors, &'a Errors),
    limit: f64,
}

/// The test of a claim.
struct Test {
    found: String,
    p: f64,
    is_below: bool,
    /// The ratio of each person's median trial, if there are several persons.
    persons: Vec<Option<f64>>,
    /// How many persons with the same mean and spread would decide it, if there are several.
    needed: Option<usize>,
}

/// The primary claims for which there are results. `people` has the folds of each person; the body has this
/// number of `parts`.
pub(super) fn primary_claims(
    rows: &[Row],
    people: &[Range<usize>],
    parts: usize,
    labels: &Labels,
) -> Vec<Claim> {
    let contender = |kind: CandidateKind, choice| Contender::new(settings(rows, kind, &is_plain), choice);
    let Some(vcgpdm) = contender(Vcgpdm.into(), Choice::Rollouts) else { return Vec::new() };
    let by_bound = contender(Vcgpdm.into(), Choice::Bound);
    let others = [
        (MapGpdm.into(), BETTER_THAN_MAP, "2017, section 3.2"),
        (MapCgpdm.into(), BETTER_THAN_MAP, "2017, section 3.2"),
        (Vgpdm.into(), PARTS_PAY, "2018, section 5.3"),
        (Tmp.into(), "", "2017, section 3.2"),
        (DmpRhythmic.into(), "", "2017, section 3.2"),
        (CandidateKind::ProMp, "", NOT_IN_PAPERS),
        (CandidateKind::Ar, "", NOT_IN_PAPERS),
    ]
    .map(|(kind, claim, place)| (kind, claim, place, contender(kind, Choice::Rollouts)));
    let names = |a: &Contender, b: &Contender| format!("{} compared with {}", a.text(labels), b.text(labels));
    let mut questions = Vec::new();
    for (kind, claim, place, other) in &others {
        let Some(other) = other else { continue };
        // The sentences of the papers are about two parts.
        let (claim, place) = if parts > 2 { ("", NOT_IN_PAPERS) } else { (*claim, *place) };
        let own = || format!("The vCGPDM predicts better than the {}", kind.title());
        let claim = if claim.is_empty() { own() } else { claim.to_owned() };
        let errors = (&vcgpdm.errors, &other.errors);
        questions.push(Question { claim, place, names: names(&vcgpdm, other), errors, limit: 1.0 });
    }
    let larger = |s: &VariationalSettings| {
        let points = s.clone().with_points(parts * s.dynamics_ips, parts * s.pose_ips);
        Settings::Vgpdm(points.with_latent(parts * s.latent))
    };
    let pairs = [
        (
            COUPLINGS_PAY,
            paired(rows, &vcgpdm.settings, &|s| Settings::Vcgpdm(s.clone().with_uncoupled(true))),
        ),
        (NOT_ONLY_LARGER, paired(rows, &vcgpdm.settings, &larger)),
    ];
    for (claim, pair) in &pairs {
        let Some((plain, other)) = pair else { continue };
        let (names, errors) = (names(plain, other), (&plain.errors, &other.errors));
        let (claim, place) = ((*claim).to_owned(), NOT_IN_PAPERS);
        questions.push(Question { claim, place, names, errors, limit: 1.0 });
    }
    if let Some(by_bound) = by_bound.as_ref().filter(|contender| contender.settings.len() > 2) {
        let (claim, place, names) =
            (BOUND_CHOOSES.to_owned(), "2018, section 5.3", chosen_by_bound(by_bound));
        let errors = (&by_bound.errors, &vcgpdm.errors);
        questions.push(Question { claim, place, names, errors, limit: NEARLY });
    }
    answered(&questions, people)
}

/// The two choices of a size that a claim compares.
pub(super) fn chosen_by_bound(kind: &Contender) -> String {
    format!(
        "{}, of {} settings the one with the highest bound compared with the one with the best rollouts on the training trials",
        kind.settings[0].candidate.kind().title(),
        kind.settings.len()
    )
}

/// Models that differ from these only by `counterpart`, at the sizes that both have: the models, and their
/// counterparts. `None` without a common size.
pub(super) fn paired<'a, 'r>(
    rows: &'a [Row<'r>],
    models: &[&'a Row<'r>],
    counterpart: &dyn Fn(&VariationalSettings) -> Settings,
) -> Option<(Contender<'a, 'r>, Contender<'a, 'r>)> {
    let pair = |row: &&'a Row<'r>| {
        let wanted = Candidate::from(counterpart(row.candidate.settings()?.variational()?));
        Some((*row, rows.iter().find(|other| *other.candidate == wanted)?))
    };
    let (models, counterparts) = models.iter().filter_map(pair).unzip();
    Contender::new(models, Choice::Rollouts).zip(Contender::new(counterparts, Choice::Rollouts))
}

/// The questions with their answers, corrected for their number.
fn answered(questions: &[Question], people: &[Range<usize>]) -> Vec<Claim> {
    // Below this p value a claim is decided, whatever the p values of the others are (Holm).
    let level = LARGEST_P / questions.len() as f64;
    let tested: Vec<(&Question, Test)> =
        questions.iter().filter_map(|question| Some((question, test(question, people, level)?))).collect();
    let adjusted = holm(&tested.iter().map(|(_, test)| test.p).collect::<Vec<_>>());
    let count = tested.len();
    let claim = |((question, test), adjusted): ((&Question, Test), f64)| {
        let answer = match test.is_below {
            _ if adjusted >= LARGEST_P => ClaimAnswer::Undecided,
            true => ClaimAnswer::Yes,
            false => ClaimAnswer::No,
        };
        let needed = test.needed.filter(|_| answer == ClaimAnswer::Undecided);
        let needed = needed.map_or(String::new(), |needed| {
            format!("; with this mean and spread, {needed} persons would decide it")
        });
        Claim {
            claim: question.claim.clone(),
            place: question.place.to_owned(),
            criterion: format!(
                "the ratio of the errors is below {}: p value below 5 % by Holm's correction for {}",
                question.limit,
                counted(count, "primary claim")
            ),
            found: format!(
                "{}: {}; p value {}, corrected {}{needed}",
                question.names,
                test.found,
                percent(test.p),
                percent(adjusted)
            ),
            answer,
            primary: true,
            persons: test.persons.clone(),
        }
    };
    tested.into_iter().zip(adjusted).map(claim).collect()
}

fn percent(p: f64) -> String {
    format!("{} %", fixed(100.0 * p, if p < 0.01 { 2 } else { 1 }))
}

/// The logarithms of each person's ratios of `a` to `b`, divided by the limit.
pub(super) fn by_person(a: &Errors, b: &Errors, limit: f64, people: &[Range<usize>]) -> Vec<Vec<f64>> {
    let logarithm = |fold: usize| {
        let ratio = a.get(&fold)? / b.get(&fold)?;
        (ratio.is_finite() && ratio > 0.0).then(|| (ratio / limit).logarithm())
    };
    people.iter().map(|folds| folds.clone().filter_map(logarithm).collect()).collect()
}

/// The median of each person, as `shown`, if there are several; of each person the values of the trials. And how many
/// persons with their mean and spread would decide the claim, if it is undecided and a thousand are enough.
pub(super) fn each_person(answer: ClaimAnswer, everybody: &[Vec<f64>], shown: &dyn Fn(f64) -> f64) -> String {
    let medians: Vec<f64> = everybody.iter().filter(|own| !own.is_empty()).map(|own| median(own)).collect();
    if medians.len() < 2 {
        return String::new();
    }
    let list: Vec<String> = medians.iter().map(|own| fixed(shown(*own), 2)).collect();
    let needed = values_needed(&medians, LARGEST_P)
        .filter(|needed| answer == ClaimAnswer::Undecided && *needed > medians.len())
        .map_or(String::new(), |needed| {
            format!("; Student's t test of {needed} such persons would decide it")
        });
    format!("; medians of the persons {}{needed}", list.join(", "))
}

/// `None` without a trial that both models have. More persons would decide it at this `level`.
fn test(question: &Question, people: &[Range<usize>], level: f64) -> Option<Test> {
    let (a, b) = question.errors;
    let effect = Effect::new(a, b)?;
    let everybody = by_person(a, b, question.limit, people);
    let by_person: Vec<&Vec<f64>> = everybody.iter().filter(|logarithms| !logarithms.is_empty()).collect();
    if let [own] = by_person[..] {
        let few = own.len() < FEWEST_TRIALS;
        let p = if few { student_test(own).unwrap_or(1.0) } else { sign_test(own) };
        let middle = if few { mean(own) } else { median(own) };
        let (persons, needed) = (Vec::new(), None);
        return Some(Test { found: effect.text(), p, is_below: middle < 0.0, persons, needed });
    }
    let medians: Vec<f64> = by_person.iter().map(|own| median(own)).collect();
    let ratio = |logarithm: f64| question.limit * logarithm.exponential();
    let person = |own: &Vec<f64>| (!own.is_empty()).then(|| ratio(median(own)));
    let range = mean_interval(&medians).map_or(String::new(), |i| format!(" ({})", i.map(ratio)));
    let below = medians.iter().filter(|own| ratio(**own) < 1.0).count();
    let found = format!(
        "{} times{range} in the mean of {} persons, of each the median trial; lower in {below}; trial by trial {}",
        fixed(ratio(mean(&medians)), 2),
        medians.len(),
        effect.text()
    );
    Some(Test {
        found,
        p: student_test(&medians).unwrap_or(1.0),
        is_below: mean(&medians) < 0.0,
        persons: everybody.iter().map(person).collect(),
        needed: values_needed(&medians, level),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn errors(values: &[f64]) -> Errors {
        values.iter().copied().enumerate().collect()
    }

    fn question<'a>(a: &'a Errors, b: &'a Errors, limit: f64) -> Question<'a> {
        Question {
            claim: String::new(),
            place: "",
            names: "a compared with b".to_owned(),
            errors: (a, b),
            limit,
        }
    }

    fn one_person(trials: usize) -> Vec<Range<usize>> {
        std::iter::once(0..trials).collect()
    }

    #[test]
    fn corrects_the_answers_for_the_number_of_claims() {
        let one = errors(&[1.0; 10]);
        let lower = errors(&[0.9, 0.8, 0.95, 0.85, 0.9, 0.7, 0.9, 0.8, 0.9, 0.85]);
        let nine = errors(&[0.9, 0.8, 0.95, 0.85, 0.9, 0.7, 0.9, 0.8, 0.9, 1.2]);
        let answers = |questions: &[Question]| -> Vec<ClaimAnswer> {
            answered(questions, &one_person(10)).iter().map(|claim| claim.answer).collect()
        };
        use ClaimAnswer::{No, Undecided, Yes};
        // Nine of ten: p = 2.1 %, which is enough for one claim and too much for three.
        assert_eq!(answers(&[question(&nine, &one, 1.0)]), [Yes]);
        let three = [question(&nine, &one, 1.0), question(&one, &lower, 1.0), question(&one, &nine, 1.0)];
        assert_eq!(answers(&three), [Yes, No, No]);
        let mixed = [question(&nine, &one, 1.0), question(&one, &nine, 1.0), question(&nine, &one, 1.0)];
        assert_eq!(answers(&mixed), [Undecided; 3]);
        // A limit of 1.1 asks whether the ratio is nearly 1.
        let nearly = errors(&[1.05; 10]);
        assert_eq!(answers(&[question(&nearly, &one, 1.0), question(&nearly, &one, NEARLY)]), [No, Yes]);
        let found = &answered(&[question(&nine, &one, 1.0)], &one_person(10))[0].found;
        assert!(found.ends_with("lower in 9; p value 2.1 %, corrected 2.1 %"), "{found}");
    }

    /// Twenty trials of two persons are two observations.
    #[test]
    fn the_person_is_the_unit_where_there_are_several() {
        let one = errors(&[1.0; 20]);
        let lower = errors(&[0.8; 20]);
        let question = question(&lower, &one, 1.0);
        let trials = test(&question, &one_person(20), 0.05).unwrap();
        assert!(trials.p < 1e-5 && trials.is_below);
        // Equal ratios have no spread to compare with.
        let two = test(&question, &[0..10, 10..20], 0.05).unwrap();
        assert_relative_eq!(two.p, 1.0);
        let unequal = errors(&[[0.8; 10], [0.7; 10]].concat());
        let question = super::tests::question(&unequal, &one, 1.0);
        let two = test(&question, &[0..10, 10..20], 0.05).unwrap();
        assert!(two.p > LARGEST_P && two.is_below, "{}", two.p);
        assert!(two.found.starts_with("0.75 times ("), "{}", two.found);
        let words =
            "in the mean of 2 persons, of each the median trial; lower in 2; trial by trial 0.75 times";
        assert!(two.found.contains(words), "{}", two.found);
        // Logarithms of -0.22 and -0.36: three persons have p = 3.4 %, two have 14 %.
        assert_eq!(two.needed, Some(3));
        let rounded: Vec<Option<String>> =
            two.persons.iter().map(|own| own.map(|own| fixed(own, 3))).collect();
        assert_eq!(rounded, [Some("0.800".to_owned()), Some("0.700".to_owned())]);
        // Without trials of the second person there is one person.
        assert!(test(&question, &[0..20, 20..30], 0.05).unwrap().p < 1e-5);
    }
}
