//! A kind of model whose settings are chosen for each trial without its data.

use crate::evaluation::effect::Errors;
use crate::evaluation::labels::Labels;
use crate::evaluation::rows::{Row, common_folds};
use crate::evaluation::stats::median;
use std::collections::BTreeMap;

/// A kind of model with the errors of its chosen settings.
pub(super) struct Contender<'a, 'r> {
    /// The settings to choose from: of one kind, different only in size.
    pub settings: Vec<&'a Row<'r>>,
    /// The error of the settings that are chosen for each trial.
    pub errors: Errors,
    /// The bound of these settings, if the kind has a bound.
    pub bounds: BTreeMap<usize, f64>,
    /// How often each setting is chosen, in the order of `settings`.
    pub counts: Vec<usize>,
}

impl<'a, 'r> Contender<'a, 'r> {
    /// In each fold, the settings with the highest bound; without a bound, those that predict the other
    /// trials best. Neither needs the trial held out. Only folds count that all settings have.
    pub fn new(settings: Vec<&'a Row<'r>>) -> Option<Self> {
        let folds = common_folds(&settings);
        let errors: Vec<Errors> = settings.iter().map(|row| row.errors(&folds)).collect();
        let bounds: Vec<BTreeMap<usize, f64>> = settings.iter().map(|row| row.bounds(&folds)).collect();
        let mut counts = vec![0; settings.len()];
        let (mut chosen_errors, mut chosen_bounds) = (Errors::new(), BTreeMap::new());
        for fold in &folds {
            let value = |k: usize| match bounds[k].get(fold) {
                Some(bound) => *bound,
                None => {
                    let others = errors[k].iter().filter(|(other, _)| *other != fold);
                    let others: Vec<f64> = others.map(|(_, error)| *error).collect();
                    if others.is_empty() { 0.0 } else { -median(&others) }
                }
            };
            let Some(best) = (0..settings.len()).rev().max_by(|a, b| value(*a).total_cmp(&value(*b))) else {
                continue;
            };
            counts[best] += 1;
            chosen_errors.extend(errors[best].get(fold).map(|error| (*fold, *error)));
            chosen_bounds.extend(bounds[best].get(fold).map(|bound| (*fold, *bound)));
        }
        (!chosen_errors.is_empty()).then_some(Self {
            settings,
            errors: chosen_errors,
            bounds: chosen_bounds,
            counts,
        })
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

    /// The smallest error of any of the settings in each fold: no choice can be better.
    pub fn smallest_errors(&self) -> Errors {
        let smallest = |fold: &usize| {
            let of_fold = self.settings.iter().filter_map(|row| row.error(*fold));
            of_fold.min_by(f64::total_cmp).map(|error| (*fold, error))
        };
        self.errors.keys().filter_map(smallest).collect()
    }
}
