//! What came of each candidate, fold by fold, so that candidates are compared over trials that all of them have.

use crate::evaluation::cross_validation::Outcome;
use crate::evaluation::results::Results;
use crate::evaluation::stats::{mean, median, standard_error};
use crate::evaluation::summary::{ModelSummary, Spread};
use crate::models::{ModelKind, ModelSettings};
use std::collections::{BTreeMap, BTreeSet};

/// A candidate that was trained on all other trials, with at least one outcome.
pub(super) struct Row<'a> {
    pub candidate: &'a ModelSettings,
    /// By the trial held out; one outcome a seed.
    outcomes: BTreeMap<usize, Vec<&'a Outcome>>,
}

/// Candidates that were trained on all other trials, in the order of tables.
pub(super) fn rows(results: &Results) -> Vec<Row<'_>> {
    let others = results.setting().trials.len().saturating_sub(1);
    let mut rows: Vec<Row> = Vec::new();
    for finished in results.finished().iter().filter(|f| f.job.training_trials == others) {
        let Some(outcome) = &finished.outcome else { continue };
        let candidate = &finished.job.candidate;
        let place = rows.iter().position(|row| row.candidate == candidate).unwrap_or_else(|| {
            rows.push(Row { candidate, outcomes: BTreeMap::new() });
            rows.len() - 1
        });
        rows[place].outcomes.entry(finished.job.held_out).or_default().push(outcome);
    }
    rows.sort_by_key(|row| ModelKind::ALL.iter().position(|kind| *kind == row.candidate.kind()));
    rows
}

/// The trials held out that all of these have.
pub(super) fn common_folds(rows: &[&Row]) -> BTreeSet<usize> {
    rows.iter().map(|row| row.folds()).reduce(|a, b| &a & &b).unwrap_or_default()
}

/// Puts together the rows that differ in their size alone, in the order in which they come.
pub(super) fn groups<'a, 'r: 'a>(rows: impl Iterator<Item = &'a Row<'r>>) -> Vec<Vec<&'a Row<'r>>> {
    let mut groups: Vec<(ModelSettings, Vec<&Row>)> = Vec::new();
    for row in rows {
        let key = row.candidate.without_size();
        match groups.iter_mut().find(|(other, _)| *other == key) {
            Some((_, group)) => group.push(row),
            None => groups.push((key, vec![row])),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

impl Row<'_> {
    fn folds(&self) -> BTreeSet<usize> {
        self.outcomes.keys().copied().collect()
    }

    /// How many outcomes there are.
    pub fn runs(&self) -> usize {
        self.outcomes.values().map(Vec::len).sum()
    }

    /// The mean over the seeds of each of these folds, where there is a value.
    fn means(&self, folds: &BTreeSet<usize>, value: &dyn Fn(&Outcome) -> Option<f64>) -> Vec<f64> {
        let fold = |fold: &usize| {
            let values: Vec<f64> = self.outcomes.get(fold)?.iter().filter_map(|o| value(o)).collect();
            (!values.is_empty()).then(|| mean(&values))
        };
        folds.iter().filter_map(fold).collect()
    }

    /// The mean bound over these folds; absent without one.
    pub fn bound(&self, folds: &BTreeSet<usize>) -> Option<f64> {
        let bounds = self.means(folds, &|o| o.bound);
        (!bounds.is_empty()).then(|| mean(&bounds))
    }

    /// The mean error over these folds; absent without a fold.
    pub fn mse(&self, folds: &BTreeSet<usize>) -> Option<f64> {
        let errors = self.means(folds, &|o| Some(o.score.dtw_mse));
        (!errors.is_empty()).then(|| mean(&errors))
    }

    /// The median error over these folds; absent without a fold.
    pub fn mse_median(&self, folds: &BTreeSet<usize>) -> Option<f64> {
        let errors = self.means(folds, &|o| Some(o.score.dtw_mse));
        (!errors.is_empty()).then(|| median(&errors))
    }

    /// Over all folds that it has itself.
    pub fn summary(&self, label: String) -> Option<ModelSummary> {
        let folds = self.folds();
        let spread = |value: &dyn Fn(&Outcome) -> Option<f64>| -> Option<Spread> {
            let means = self.means(&folds, value);
            (!means.is_empty()).then(|| Spread {
                mean: mean(&means),
                standard_error: standard_error(&means),
                count: means.len(),
            })
        };
        Some(ModelSummary {
            model: self.candidate.kind(),
            candidate: self.candidate.clone(),
            label,
            mse: spread(&|o| Some(o.score.dtw_mse))?,
            mse_median: self.mse_median(&folds)?,
            variance: spread(&|o| Some(o.score.variance))?.mean,
            bound: spread(&|o| o.bound),
            seconds: spread(&|o| Some(o.seconds))?,
            stored_numbers: spread(&|o| Some(o.stored_numbers as f64))?,
            folds: folds.len(),
            runs: self.runs(),
        })
    }
}
