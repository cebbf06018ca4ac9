//! A kind of model with its settings chosen, trial by trial, without a look at the trial that is held out.

use crate::evaluation::effect::Errors;
use crate::evaluation::labels::Labels;
use crate::evaluation::rows::{Row, common_folds};
use crate::evaluation::stats::median;
use std::collections::BTreeMap;

/// What the chosen settings of a kind predict.
pub(super) struct Contender<'a, 'r> {
    /// The settings to choose from: of one kind, different in size alone.
    pub settings: Vec<&'a Row<'r>>,
    /// The error of the settings that are chosen for each trial.
    pub errors: Errors,
    /// Their bound, where the kind has one.
    pub bounds: BTreeMap<usize, f64>,
    /// How often each is chosen, in the order of `settings`.
    pub times: Vec<usize>,
}

impl<'a, 'r> Contender<'a, 'r> {
    /// Where the models have a bound, the settings of the highest in each fold; else those that predict the
    /// other trials best. Both can be known before the trial held out is. Only folds count that all settings
    /// have.
    pub fn new(settings: Vec<&'a Row<'r>>) -> Option<Self> {
        let folds = common_folds(&settings);
        let errors: Vec<Errors> = settings.iter().map(|row| row.errors(&folds)).collect();
        let bounds: Vec<BTreeMap<usize, f64>> = settings.iter().map(|row| row.bounds(&folds)).collect();
        let mut times = vec![0; settings.len()];
        let (mut chosen_errors, mut chosen_bounds) = (Errors::new(), BTreeMap::new());
        for fold in &folds {
            let worth = |k: usize| match bounds[k].get(fold) {
                Some(bound) => *bound,
                None => {
                    let others = errors[k].iter().filter(|(other, _)| *other != fold);
                    let others: Vec<f64> = others.map(|(_, error)| *error).collect();
                    if others.is_empty() { 0.0 } else { -median(&others) }
                }
            };
            let Some(best) = (0..settings.len()).rev().max_by(|a, b| worth(*a).total_cmp(&worth(*b))) else {
                continue;
            };
            times[best] += 1;
            chosen_errors.extend(errors[best].get(fold).map(|error| (*fold, *error)));
            chosen_bounds.extend(bounds[best].get(fold).map(|bound| (*fold, *bound)));
        }
        let found = !chosen_errors.is_empty();
        found.then_some(Self { settings, errors: chosen_errors, bounds: chosen_bounds, times })
    }

    /// The kind and the settings that are chosen most often.
    pub fn words(&self, labels: &Labels) -> String {
        let candidate = self.most_often().candidate;
        format!("{}, {}", candidate.kind().title(), labels.label(candidate))
    }

    /// The settings that are chosen most often.
    pub fn most_often(&self) -> &'a Row<'r> {
        let most = (0..self.settings.len()).rev().max_by_key(|&k| self.times[k]);
        self.settings[most.unwrap_or_default()]
    }

    /// The least error that any of the settings has in each fold: what no choice can beat.
    pub fn least(&self) -> Errors {
        let least = |fold: &usize| {
            let of_fold = self.settings.iter().filter_map(|row| row.error(*fold));
            of_fold.min_by(f64::total_cmp).map(|error| (*fold, error))
        };
        self.errors.keys().filter_map(least).collect()
    }
}
