//! Rollouts from observed first frames, compared with rollouts from first frames that were trained on.

use crate::evaluation::candidate::CandidateKind;
use crate::evaluation::effect::Effect;
use crate::evaluation::labels::Labels;
use crate::evaluation::results::Results;
use crate::evaluation::rows::rows;
use crate::evaluation::stats::Interval;
use crate::evaluation::summary::{ClaimAnswer, Spread};
use serde::Serialize;

/// Observing is no worse than training if it has less than this multiple of the error: our threshold.
pub const NO_WORSE: f64 = 1.1;

/// A candidate whose rollouts start from first frames of the trial held out: trained on as a sequence, and
/// observed by a model that was trained without them. Over the trials that have both.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ObservedStarts {
    /// Its kind of model.
    pub model: CandidateKind,
    /// The settings that differ from other candidates, in a few words.
    pub label: String,
    /// Mean squared error after dynamic time warping when the frames were trained on.
    pub trained_on: Spread,
    /// The same error when they are observed.
    pub observed: Spread,
    /// The observed error divided by the other one: the median over the trials, for fewer than six trials the
    /// geometric mean.
    pub ratio: f64,
    /// Its interval; absent for a single trial.
    pub interval: Option<Interval>,
    /// Whether the ratio is below [`NO_WORSE`].
    pub no_worse: ClaimAnswer,
    /// Seconds of a training with the frames.
    pub training_seconds: Spread,
    /// Seconds of observing the frames and of the rollout, when there is a model already.
    pub observing_seconds: Spread,
}

impl ObservedStarts {
    /// The comparison of every candidate that has both, in the order of tables.
    pub fn of(several: &[&Results]) -> Vec<Self> {
        let labels = Labels::of_several(several);
        let rows = rows(several);
        let starts = rows.iter().filter_map(|row| {
            let observed = row.values(&|o| o.observed_start.map(|start| start.dtw_mse));
            let trained_on = row.values(&|o| o.observed_start.map(|_| o.score.dtw_mse));
            let observing = row.values(&|o| o.observed_start.map(|start| start.seconds));
            let training = row.values(&|o| o.observed_start.map(|_| o.seconds));
            let effect = Effect::new(&observed, &trained_on)?;
            let spread = |values: &std::collections::BTreeMap<usize, f64>| {
                Spread::new(&values.values().copied().collect::<Vec<f64>>())
            };
            Some(Self {
                model: row.candidate.kind(),
                label: labels.label(row.candidate),
                trained_on: spread(&trained_on)?,
                observed: spread(&observed)?,
                ratio: effect.middle(),
                interval: effect.interval(),
                no_worse: effect.is_below(NO_WORSE),
                training_seconds: spread(&training)?,
                observing_seconds: spread(&observing)?,
            })
        });
        starts.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::outcome::ObservedStart;
    use crate::evaluation::testing::{finished, outcome, results, variational};
    use approx::assert_relative_eq;
    use vcgpdm::models::{ModelKind, Settings};

    #[test]
    fn compares_only_trials_that_have_both() {
        let candidate = || Settings::Vcgpdm(variational(8));
        let with = |fold: usize, mse: f64, observed: Option<f64>| {
            let start = observed.map(|dtw_mse| ObservedStart { dtw_mse, seconds: 0.5 });
            let outcome =
                crate::evaluation::Outcome { observed_start: start, ..outcome(mse, None, 100, 8.0) };
            finished(candidate(), fold, 6, 0, outcome)
        };
        let ratios = [1.0, 0.9, 1.05, 1.0, 0.95, 1.02];
        let mut jobs: Vec<_> = ratios
            .iter()
            .enumerate()
            .map(|(k, ratio)| with(k, 0.2 * (k + 1) as f64, Some(ratio * 0.2 * (k + 1) as f64)))
            .collect();
        jobs.push(with(6, 99.0, None));
        let results = results(7, &jobs);
        let found = ObservedStarts::of(&[&results]);
        assert_eq!(found.len(), 1);
        let row = &found[0];
        assert_eq!((row.model, row.observed.count, row.trained_on.count), (ModelKind::Vcgpdm.into(), 6, 6));
        assert_relative_eq!(row.trained_on.mean, 0.7, epsilon = 1e-12);
        assert_relative_eq!(row.ratio, 1.0, epsilon = 1e-12);
        assert_eq!(row.no_worse, ClaimAnswer::Yes);
        assert_relative_eq!(row.training_seconds.mean - row.observing_seconds.mean, 7.5);
        // Without observed starts there is no row.
        assert!(ObservedStarts::of(&[&crate::evaluation::testing::results(7, &jobs[6..])]).is_empty());
    }
}
