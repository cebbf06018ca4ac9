//! A kind of model whose settings are chosen for each trial without its data.

use crate::evaluation::effect::Errors;
use crate::evaluation::labels::Labels;
use crate::evaluation::rows::{Row, common_folds};
use std::collections::BTreeMap;

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
