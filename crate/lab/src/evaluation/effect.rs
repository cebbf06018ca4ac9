//! How much the error changes with the model, trial by trial, and which candidate represents each kind of model.

use crate::evaluation::fixed::fixed;
use crate::evaluation::labels::Labels;
use crate::evaluation::rows::{Row, common_folds};
use crate::evaluation::stats::{Interval, mean, mean_interval, median, median_interval};
use crate::evaluation::summary::ClaimAnswer;
use std::collections::BTreeMap;
use vcgpdm_core::elementary::Elementary;

/// Errors by the trial held out.
pub type Errors = BTreeMap<usize, f64>;

/// The ratio of the errors of two models, over the trials that both have.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Trials that both have.
    pub folds: usize,
    /// Number of trials in which the error is lower.
    pub wins: usize,
    /// The median ratio.
    pub median: f64,
    /// Interval of the median; absent for fewer than six trials.
    pub median_interval: Option<Interval>,
    /// The geometric mean of the ratios.
    pub mean: f64,
    /// Interval of the geometric mean, by Student's t of the logarithms; absent for a single trial.
    pub mean_interval: Option<Interval>,
}

impl Effect {
    /// The errors `a` divided by the errors `b`; absent without a trial that both have.
    pub fn new(a: &Errors, b: &Errors) -> Option<Self> {
        let ratio = |(fold, a): (&usize, &f64)| {
            let ratio = a / b.get(fold)?;
            (ratio.is_finite() && ratio > 0.0).then(|| ratio.logarithm())
        };
        let logarithms: Vec<f64> = a.iter().filter_map(ratio).collect();
        (!logarithms.is_empty()).then(|| Self {
            folds: logarithms.len(),
            wins: logarithms.iter().filter(|l| **l < 0.0).count(),
            median: median(&logarithms).exponential(),
            median_interval: median_interval(&logarithms).map(|i| i.map(f64::exponential)),
            mean: mean(&logarithms).exponential(),
            mean_interval: mean_interval(&logarithms).map(|i| i.map(f64::exponential)),
        })
    }

    /// The interval that decides: that of the median, for fewer than six trials that of the mean.
    pub fn interval(&self) -> Option<Interval> {
        self.median_interval.or(self.mean_interval)
    }

    /// Whether the ratio is below `limit`: decided only if the whole interval is on one side of it.
    pub fn is_below(&self, limit: f64) -> ClaimAnswer {
        ClaimAnswer::below(self.interval(), limit)
    }

    /// The effect as text.
    pub fn text(&self) -> String {
        let range = |interval: &Option<Interval>| interval.map_or(String::new(), |i| format!(" ({i})"));
        format!(
            "{} times{} in the median of {} {}, {} times{} in the mean; lower in {}",
            fixed(self.median, 2),
            range(&self.median_interval),
            self.folds,
            if self.folds == 1 { "trial" } else { "trials" },
            fixed(self.mean, 2),
            range(&self.mean_interval),
            self.wins
        )
    }
}

/// How the settings of a kind are chosen. No rule uses the trial held out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Choice {
    /// The smallest error of rollouts on the trials trained on: one rule for kinds with and without a bound.
    Rollouts,
    /// The highest bound.
    Bound,
}

/// A kind of model with the errors of its chosen settings.
pub(super) struct Contender<'a, 'r> {
    /// The settings to choose from: of one kind, different only in size.
    pub settings: Vec<&'a Row<'r>>,
    /// The error of the settings that are chosen for each trial.
    pub errors: Errors,
    /// The bound of these settings, if the kind has a bound.
    pub bounds: BTreeMap<usize, f64>,
    /// How often each setting is chosen, in the order of `settings`.
    counts: Vec<usize>,
}

impl<'a, 'r> Contender<'a, 'r> {
    /// Chooses in each fold that all settings have. `None` if no fold has the numbers that the choice needs.
    pub fn new(settings: Vec<&'a Row<'r>>, choice: Choice) -> Option<Self> {
        let folds = common_folds(&settings);
        let values: Vec<BTreeMap<usize, f64>> = settings
            .iter()
            .map(|row| match choice {
                Choice::Rollouts => row.training_errors(&folds).into_iter().map(|(k, v)| (k, -v)).collect(),
                Choice::Bound => row.bounds(&folds),
            })
            .collect();
        let mut counts = vec![0; settings.len()];
        let (mut errors, mut bounds) = (Errors::new(), BTreeMap::new());
        for fold in &folds {
            let of_fold = (0..settings.len()).rev().filter_map(|k| Some((k, *values[k].get(fold)?)));
            let Some((best, _)) = of_fold.max_by(|a, b| a.1.total_cmp(&b.1)) else { continue };
            counts[best] += 1;
            errors.extend(settings[best].error(*fold).map(|error| (*fold, error)));
            bounds.extend(settings[best].bound(&[*fold].into()).map(|bound| (*fold, bound)));
        }
        (!errors.is_empty()).then_some(Self { settings, errors, bounds, counts })
    }

    /// The kind and the settings that are chosen most often, as text.
    pub fn text(&self, labels: &Labels) -> String {
        let candidate = self.most_often().candidate;
        format!("{}, {}", candidate.kind().title(), labels.label(candidate))
    }

    /// The settings that are chosen most often.
    pub fn most_often(&self) -> &'a Row<'r> {
        let most = (0..self.settings.len()).rev().max_by_key(|&k| self.counts[k]);
        self.settings[most.unwrap_or_default()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn errors(values: &[f64]) -> Errors {
        values.iter().copied().enumerate().collect()
    }

    #[test]
    fn one_extreme_trial_does_not_decide() {
        let b = errors(&[1.0; 10]);
        let mut a = errors(&[0.9, 0.8, 0.95, 0.85, 0.9, 0.7, 0.9, 0.8, 0.9, 0.85]);
        let calm = Effect::new(&a, &b).unwrap();
        assert_eq!((calm.wins, calm.is_below(1.0)), (10, ClaimAnswer::Yes));
        a.insert(9, 300.0);
        let extreme = Effect::new(&a, &b).unwrap();
        assert_eq!((extreme.wins, extreme.is_below(1.0)), (9, ClaimAnswer::Yes));
        // The mean follows the extreme trial.
        assert!(extreme.mean > 1.5 && extreme.mean_interval.unwrap().high > 4.0, "{extreme:?}");
        assert!(
            extreme.text().starts_with("0.90 times (0.80 to 0.95) in the median of 10 trials, 1.5"),
            "{}",
            extreme.text()
        );
    }

    #[test]
    fn few_or_mixed_trials_decide_nothing() {
        let b = errors(&[1.0; 10]);
        let mixed = errors(&[0.9, 1.1, 0.8, 1.2, 0.9, 1.1, 0.95, 1.05, 0.9, 1.1]);
        assert_eq!(Effect::new(&mixed, &b).unwrap().is_below(1.0), ClaimAnswer::Undecided);
        let one = Effect::new(&errors(&[0.1]), &b).unwrap();
        assert_eq!((one.folds, one.is_below(1.0)), (1, ClaimAnswer::Undecided));
        // Four trials: by Student's t of the logarithms.
        let four = Effect::new(&errors(&[1.5, 1.6, 1.4, 1.5]), &b).unwrap();
        assert!(four.median_interval.is_none());
        assert_eq!((four.is_below(1.0), four.is_below(2.0)), (ClaimAnswer::No, ClaimAnswer::Yes));
        assert_eq!(Effect::new(&errors(&[]), &b), None);
    }
}
