//! What the results of an evaluation say: the table of models, bound against error, time against frames.

use crate::evaluation::claims::{Claim, claims};
use crate::evaluation::cross_validation::Outcome;
use crate::evaluation::labels::Labels;
use crate::evaluation::results::{Finished, Results};
use crate::evaluation::rows::{Row, common_folds, groups, rows};
use crate::evaluation::stats::{exponent, mean, rank_correlation};
use crate::models::{ModelKind, ModelSettings};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// A mean over folds; seeds of the same fold are averaged first.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Spread {
    /// The mean.
    pub mean: f64,
    /// Its standard error; absent for a single fold.
    pub standard_error: Option<f64>,
    /// Folds.
    pub count: usize,
}

/// One model with its settings: a row of figure 4 of Velychko et al. (2018).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct ModelSummary {
    /// The kind's id.
    pub model: String,
    /// Its settings.
    pub candidate: ModelSettings,
    /// Those that set it apart, in a few words.
    pub label: String,
    /// Mean squared error after dynamic time warping, in the squared units of the columns.
    pub mse: Spread,
    /// Its median over the folds: a single rollout that goes astray does not move it.
    pub mse_median: f64,
    /// The error of a prediction that does not move.
    pub variance: f64,
    /// The bound on the log evidence, in nats, where the model has one.
    pub bound: Option<Spread>,
    /// Seconds of a training.
    pub seconds: Spread,
    /// Numbers that must be kept to roll out.
    pub stored_numbers: Spread,
    /// Trials held out.
    pub folds: usize,
    /// Trainings.
    pub runs: usize,
}

/// One setting in figure 6B of Velychko et al. (2018).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoundAndError {
    /// The setting, in a few words.
    pub label: String,
    /// Mean bound, in nats.
    pub bound: f64,
    /// Mean error.
    pub mse: f64,
}

/// Bound and error of one kind of model over its inducing points (primitives of the TMP), all other settings being the same: figure 6B of Velychko et al. (2018).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Correlation {
    /// The kind's id.
    pub model: String,
    /// What these settings have in common, in a few words, where the kind has several such groups; else empty.
    pub label: String,
    /// How many settings.
    pub settings: usize,
    /// Trials held out that all of these settings have: bounds and errors are means over these.
    pub folds: usize,
    /// Spearman's rank correlation of bound and error.
    pub rank: f64,
    /// The settings.
    pub points: Vec<BoundAndError>,
}

/// Frames trained on, and how long that took.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FramesAndTime {
    /// Frames trained on.
    pub frames: f64,
    /// Seconds an iteration.
    pub seconds: f64,
}

/// Learning time of one model over the frames trained on: figure 2 of the supplement of Velychko et al. (2017).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Growth {
    /// The kind's id.
    pub model: String,
    /// Its settings, in a few words.
    pub label: String,
    /// Fewer and more frames.
    pub points: Vec<FramesAndTime>,
    /// k where time grows as frames to the power k.
    pub exponent: Option<f64>,
}

/// What the results of an evaluation say.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// Every model with every setting.
    pub models: Vec<ModelSummary>,
    /// For every kind of model with a bound and at least three settings that differ in size alone.
    pub correlations: Vec<Correlation>,
    /// For every kind of model that was trained on at least three numbers of trials.
    pub growth: Vec<Growth>,
    /// Those about which there are results.
    pub claims: Vec<Claim>,
}

impl Comparison {
    /// Of these results.
    pub fn of(results: &Results) -> Self {
        let (rows, labels) = (rows(results), Labels::of(results));
        let growth = growth(results, &labels);
        let claims = claims(&rows, results.setting.trials.len(), &growth, &labels);
        let models = rows.iter().filter_map(|row| row.summary(labels.label(row.candidate))).collect();
        Self { models, correlations: correlations(&rows, &labels), growth, claims }
    }
}

/// Of every kind and all settings but its size.
fn correlations(rows: &[Row], labels: &Labels) -> Vec<Correlation> {
    let of = |kind: ModelKind| {
        let groups = groups(rows.iter().filter(|row| row.candidate.kind() == kind));
        let several = groups.len() > 1;
        let one = |group: &Vec<&Row>| {
            let label = if several { labels.besides_size(group[0].candidate) } else { String::new() };
            correlation(group, label, labels)
        };
        groups.iter().filter_map(one).collect::<Vec<_>>()
    };
    ModelKind::ALL.into_iter().flat_map(of).collect()
}

/// Over the folds that all of these settings of a kind have; absent for fewer than three.
pub(super) fn correlation(rows: &[&Row], label: String, labels: &Labels) -> Option<Correlation> {
    let folds = common_folds(rows);
    let point = |row: &&Row| {
        let (bound, mse) = (row.bound(&folds)?, row.mse(&folds)?);
        Some(BoundAndError { label: labels.label(row.candidate), bound, mse })
    };
    let points: Vec<BoundAndError> = rows.iter().filter_map(point).collect();
    let pairs: Vec<(f64, f64)> = points.iter().map(|p| (p.bound, p.mse)).collect();
    let rank = (pairs.len() > 2).then(|| rank_correlation(&pairs)).flatten()?;
    let model = rows[0].candidate.kind().id().to_owned();
    Some(Correlation { model, label, settings: points.len(), folds: folds.len(), rank, points })
}

/// Outcomes of a candidate by the number of trials trained on, each with the trial held out.
type Course<'a> = BTreeMap<usize, Vec<(usize, &'a Outcome)>>;

/// Of each kind the candidate that was trained on most numbers of trials; only folds that all of these have are compared.
fn growth(results: &Results, labels: &Labels) -> Vec<Growth> {
    let mut courses: Vec<(&ModelSettings, Course)> = Vec::new();
    for Finished { job, outcome, .. } in &results.finished {
        let Some(outcome) = outcome else { continue };
        let place = courses.iter().position(|(other, _)| **other == job.candidate).unwrap_or_else(|| {
            courses.push((&job.candidate, Course::new()));
            courses.len() - 1
        });
        courses[place].1.entry(job.training_trials).or_default().push((job.held_out, outcome));
    }
    let of = |kind: ModelKind| {
        let of_kind = courses.iter().filter(|(candidate, _)| candidate.kind() == kind);
        let (candidate, course) = of_kind.max_by_key(|(_, course)| course.len())?;
        let folds =
            |of: &Vec<(usize, &Outcome)>| of.iter().map(|(fold, _)| *fold).collect::<BTreeSet<usize>>();
        let common = course.values().map(folds).reduce(|a, b| &a & &b)?;
        let point = |of: &Vec<(usize, &Outcome)>| {
            let shared = of.iter().filter(|(fold, _)| common.contains(fold));
            let (frames, seconds): (Vec<f64>, Vec<f64>) =
                shared.map(|(_, o)| (o.frames as f64, o.seconds / o.iterations.max(1) as f64)).unzip();
            (!frames.is_empty()).then(|| FramesAndTime { frames: mean(&frames), seconds: mean(&seconds) })
        };
        let points: Vec<FramesAndTime> = course.values().filter_map(point).collect();
        let pairs: Vec<(f64, f64)> =
            points.iter().map(|p| (p.frames, p.seconds)).filter(|(_, seconds)| *seconds > 0.0).collect();
        (points.len() > 2).then(|| Growth {
            model: kind.id().to_owned(),
            label: labels.label(candidate),
            points,
            exponent: exponent(&pairs),
        })
    };
    ModelKind::ALL.into_iter().filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::dtw::Score;
    use crate::evaluation::results::{Job, Setting, Trial};
    use crate::models::{MapSettings, VariationalSettings};
    use approx::assert_relative_eq;

    fn setting(trials: usize) -> Setting {
        let trial = |k: usize| Trial { name: format!("walk {k}"), sha256: format!("sha {k}"), piece: None };
        Setting {
            trials: (0..trials).map(trial).collect(),
            parts: vec![],
            frames_per_second: 30.0,
            start_frames: 5,
        }
    }

    fn variational(ips: usize) -> VariationalSettings {
        VariationalSettings { latent: 3, order: 2, dynamics_ips: ips, pose_ips: ips, max_iterations: 100 }
    }

    fn point(balanced: bool) -> MapSettings {
        MapSettings { latent: 3, order: 2, max_iterations: 100, balanced }
    }

    fn finished(
        candidate: ModelSettings,
        held_out: usize,
        training_trials: usize,
        seed: u32,
        outcome: Outcome,
    ) -> Finished {
        let job = Job { candidate, held_out, training_trials, seed };
        Finished { job, engine: "vcgpdm".to_owned(), outcome: Some(outcome), failure: None }
    }

    fn outcome(dtw_mse: f64, bound: Option<f64>, frames: usize, seconds: f64) -> Outcome {
        Outcome {
            score: Score { dtw_mse, mse: 2.0 * dtw_mse, variance: 0.05 },
            bound,
            objective: 0.0,
            iterations: 10,
            seconds,
            frames,
            stored_numbers: 700,
            reason: None,
        }
    }

    #[test]
    fn seeds_are_averaged_before_folds() {
        let mut results = Results::new(setting(3));
        let candidate = || ModelSettings::Vgpdm(variational(8));
        for (fold, seed, mse) in [(1, 0, 1.0), (1, 1, 3.0), (2, 0, 6.0)] {
            results.finished.push(finished(candidate(), fold, 2, seed, outcome(mse, Some(10.0), 100, 1.0)));
        }
        // Trained on fewer trials: no row of the table.
        results.finished.push(finished(candidate(), 3, 1, 0, outcome(100.0, Some(10.0), 50, 1.0)));
        let found = Comparison::of(&results);
        assert_eq!(found.models.len(), 1);
        let row = &found.models[0];
        assert_eq!((row.folds, row.runs, row.mse.count), (2, 3, 2));
        // Folds 2 and 6: mean 4, standard error |6 - 2| / 2.
        assert_relative_eq!(row.mse.mean, 4.0);
        assert_relative_eq!(row.mse.standard_error.unwrap(), 2.0);
        assert_relative_eq!(row.mse_median, 4.0);
        assert!(found.claims.is_empty() && found.correlations.is_empty() && found.growth.is_empty());
    }

    #[test]
    fn the_claims_use_the_setting_that_the_bound_prefers() {
        let mut results = Results::new(setting(2));
        let mut add = |candidate: ModelSettings, mse: f64, bound: Option<f64>| {
            results.finished.push(finished(candidate, 1, 1, 0, outcome(mse, bound, 100, 1.0)));
        };
        // The bound prefers 12, though 16 happens to predict better.
        for (ips, mse, bound) in [(8, 0.5, 1.0), (12, 0.3, 3.0), (16, 0.2, 2.0)] {
            add(ModelSettings::Vcgpdm(variational(ips)), mse, Some(bound));
            add(ModelSettings::Vgpdm(variational(ips)), mse, Some(bound));
        }
        add(ModelSettings::MapGpdm(point(false)), 0.4, None);
        add(ModelSettings::MapCgpdm(point(false)), 0.5, None);
        add(ModelSettings::MapGpdm(point(true)), 0.25, None);
        add(ModelSettings::MapCgpdm(point(true)), 0.5, None);
        let found = Comparison::of(&results);
        let holds: Vec<bool> = found.claims.iter().map(|claim| claim.holds).collect();
        // Better than plain MAP models, not than balanced ones; not the best of all; ratio 1 of parts and whole; 0.3 is not
        // nearly 0.2; correlations of (1, 3, 2) with (0.5, 0.3, 0.2).
        assert_eq!(holds, [true, false, false, true, false, false, false, false], "{:?}", found.claims);
        assert!(found.claims[1].found.contains("0.30000"), "{:?}", found.claims);
        assert!(found.claims[2].found.contains("0.20000: vgpdm, 16 + 16"), "{:?}", found.claims);
        assert!(found.claims[4].found.contains("1.50 times"), "{:?}", found.claims);
        assert_relative_eq!(found.correlations[0].rank, -0.5);
    }

    /// What a cancelled run leaves: the hard trials 2 and 3 are there for the first model alone.
    #[test]
    fn models_are_compared_over_the_trials_that_all_of_them_have() {
        let mut results = Results::new(setting(3));
        let mut add = |candidate: ModelSettings, fold: usize, mse: f64| {
            results.finished.push(finished(candidate, fold, 2, 0, outcome(mse, Some(1.0), 100, 1.0)));
        };
        for (fold, mse) in [(1, 0.2), (2, 0.9), (3, 0.9)] {
            add(ModelSettings::Vcgpdm(variational(12)), fold, mse);
        }
        add(ModelSettings::Vgpdm(variational(12)), 1, 0.25);
        add(ModelSettings::MapGpdm(point(false)), 1, 0.4);
        add(ModelSettings::MapCgpdm(point(false)), 1, 0.5);
        let found = Comparison::of(&results);
        let holds: Vec<bool> = found.claims.iter().map(|claim| claim.holds).collect();
        assert_eq!(holds, [true, true, true], "{:?}", found.claims);
        assert!(found.claims[1].found.starts_with("MSE 0.20000; of the others at best 0.25000"));
        assert!(found.claims.iter().all(|claim| claim.found.ends_with(" (over 1 of 3 trials)")));
        // The table shows all that each of them has.
        assert_eq!((found.models[0].folds, found.models[1].folds), (3, 1));
        assert_relative_eq!(found.models[0].mse.mean, 2.0 / 3.0);
        // Held against another trial than all others, a model says nothing.
        for finished in results.finished.iter_mut().filter(|f| f.job.candidate.kind() == ModelKind::Vgpdm) {
            finished.job.held_out = 2;
        }
        let found = Comparison::of(&results);
        let claims: Vec<&str> = found.claims.iter().map(|claim| &claim.claim[..15]).collect();
        assert_eq!(claims, ["Parts cost no p"], "over trial 2, which both of them have");
    }

    #[test]
    fn bound_and_error_are_correlated_over_the_trials_that_all_settings_have() {
        let mut results = Results::new(setting(3));
        let mut add = |ips: usize, fold: usize, mse: f64, bound: f64| {
            let candidate = ModelSettings::Vgpdm(variational(ips));
            results.finished.push(finished(candidate, fold, 2, 0, outcome(mse, Some(bound), 100, 1.0)));
        };
        // Fold 1: the higher the bound, the lower the error. Fold 2 is longer, so that its bounds are higher, and hard.
        for (ips, mse, bound) in [(4, 0.3, 10.0), (8, 0.2, 20.0), (12, 0.1, 30.0)] {
            add(ips, 1, mse, bound);
        }
        add(4, 2, 0.9, 500.0);
        add(8, 2, 0.8, 600.0);
        let found = Comparison::of(&results);
        let correlation = &found.correlations[0];
        assert_relative_eq!(correlation.rank, -1.0);
        assert_eq!((correlation.settings, correlation.folds), (3, 1));
        assert_eq!(correlation.points.iter().map(|p| p.bound).collect::<Vec<_>>(), [10.0, 20.0, 30.0]);
        // Chosen on fold 1, where 12 is best, though the mean bound of 8 over its folds is higher.
        assert!(found.claims[0].found.starts_with("vgpdm over 3 settings: 1.00 times"), "{:?}", found.claims);
        // A setting that has only another trial: nothing to compare.
        results.finished[0].job.held_out = 3;
        results.finished.retain(|f| f.job.held_out != 2);
        let found = Comparison::of(&results);
        assert!(found.correlations.is_empty() && found.claims.is_empty(), "{:?}", found.claims);
    }

    #[test]
    fn settings_besides_the_size_are_never_mixed() {
        let mut results = Results::new(setting(2));
        let mut add = |ips: usize, max_iterations: usize, fold: usize, mse: f64, bound: f64| {
            let candidate = ModelSettings::Vgpdm(VariationalSettings { max_iterations, ..variational(ips) });
            results.finished.push(finished(candidate, fold, 1, 0, outcome(mse, Some(bound), 100, 1.0)));
        };
        // A few iterations find worse models; those of many iterations have more results.
        for (ips, mse, bound) in [(4, 0.7, 1.0), (8, 0.8, 2.0), (12, 0.9, 3.0)] {
            add(ips, 10, 1, mse, bound);
        }
        for (ips, mse, bound) in [(4, 0.3, 11.0), (8, 0.2, 12.0), (12, 0.1, 13.0)] {
            add(ips, 800, 1, mse, bound);
            add(ips, 800, 2, mse, bound);
        }
        let found = Comparison::of(&results);
        let groups: Vec<(&str, f64)> = found.correlations.iter().map(|c| (&c.label[..], c.rank)).collect();
        assert_eq!(
            groups.iter().map(|(label, _)| *label).collect::<Vec<_>>(),
            ["10 iterations", "800 iterations"]
        );
        assert_relative_eq!(groups[0].1, 1.0);
        assert_relative_eq!(groups[1].1, -1.0);
        assert_eq!(found.models[5].label, "12 + 12 inducing points, 800 iterations");
        assert_eq!(
            found.models[5].candidate,
            ModelSettings::Vgpdm(VariationalSettings { max_iterations: 800, ..variational(12) })
        );
        let said: Vec<&str> = found.claims.iter().map(|claim| &claim.found[..]).collect();
        assert_eq!(said, ["vgpdm over 3 settings: 1.00 times", "vgpdm over 3 settings: -1.00"]);
    }

    #[test]
    fn time_is_compared_over_the_same_folds_and_settings() {
        let mut results = Results::new(setting(5));
        for count in 1..=4usize {
            let frames = 100 * count;
            let cubic = (frames as f64).powi(3) * 1e-6;
            results.finished.push(finished(
                ModelSettings::MapCgpdm(point(false)),
                1,
                count,
                0,
                outcome(1.0, None, frames, cubic),
            ));
            let linear = frames as f64 * 1e-3;
            let vcgpdm = || ModelSettings::Vcgpdm(variational(12));
            results.finished.push(finished(vcgpdm(), 1, count, 0, outcome(1.0, Some(1.0), frames, linear)));
        }
        // Another fold that has only the most trials, and another setting: neither tells how time grows.
        let odd = || outcome(1.0, Some(1.0), 400, 1e6);
        results.finished.push(finished(ModelSettings::Vcgpdm(variational(12)), 2, 4, 0, odd()));
        results.finished.push(finished(ModelSettings::Vcgpdm(variational(16)), 1, 4, 0, odd()));
        let found = Comparison::of(&results);
        let exponents: Vec<f64> = found.growth.iter().map(|g| g.exponent.unwrap()).collect();
        assert_relative_eq!(exponents[0], 1.0, epsilon = 1e-9);
        assert_relative_eq!(exponents[1], 3.0, epsilon = 1e-9);
        assert_relative_eq!(found.growth[0].points[3].seconds, 0.04);
        assert!(
            found.claims.iter().filter(|c| c.claim.contains("time")).all(|c| c.holds),
            "{:?}",
            found.claims
        );
    }
}
