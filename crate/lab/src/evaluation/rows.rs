//! Scores per candidate and fold. Candidates are compared over the folds that all of them have.

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::candidate_text::{size_numbers, without_size};
use crate::evaluation::details::{Bands, Compared, Details};
use crate::evaluation::outcome::{Outcome, share_converged};
use crate::evaluation::results::Results;
use crate::evaluation::stats::{mean, median};
use crate::evaluation::summary::{DetailMeans, ModelSummary, Spread, TermMeans};
use std::collections::{BTreeMap, BTreeSet};
use vcgpdm_core::models::Settings;
use vcgpdm_core::models::variational::BoundTerms;

/// A candidate that was trained on all other trials, with at least one outcome.
pub(super) struct Row<'a> {
    pub candidate: &'a Candidate,
    /// By the trial held out; one outcome a seed.
    outcomes: BTreeMap<usize, Vec<&'a Outcome>>,
}

/// Whether a MAP model is neither balanced nor has a linear term, and a variational model has neither
/// weighted pose terms nor couplings that are off.
pub(super) fn is_plain(candidate: &Candidate) -> bool {
    let Some(settings) = candidate.settings() else { return true };
    match settings {
        Settings::MapGpdm(s) | Settings::MapCgpdm(s) => !s.balanced && !s.linear,
        Settings::Vcgpdm(s) | Settings::Vgpdm(s) => s.pose_weight.is_plain() && !s.uncoupled,
        Settings::Tmp(_) | Settings::DmpDiscrete(_) | Settings::DmpRhythmic(_) => true,
    }
}

/// Candidates that were trained on all other trials, in the order of tables: by model, and by size among
/// those that differ only in size. The numbers of the folds go on from one comparison to the next.
pub(super) fn rows<'a>(several: &[&'a Results]) -> Vec<Row<'a>> {
    let mut rows: Vec<Row> = Vec::new();
    let mut before = 0;
    for results in several {
        let trials = results.setting().trials.len();
        let others = trials.saturating_sub(1);
        for finished in results.finished().iter().filter(|f| f.job.training_trials == others) {
            let Some(outcome) = &finished.outcome else { continue };
            let candidate = &finished.job.candidate;
            let place = rows.iter().position(|row| row.candidate == candidate).unwrap_or_else(|| {
                rows.push(Row { candidate, outcomes: BTreeMap::new() });
                rows.len() - 1
            });
            rows[place].outcomes.entry(before + finished.job.held_out).or_default().push(outcome);
        }
        before += trials;
    }
    // The order in which jobs finished is random.
    let groups: Vec<Candidate> = rows.iter().map(|row| without_size(row.candidate)).collect();
    rows.sort_by_cached_key(|row| {
        let (kind, alike) = (row.candidate.kind(), without_size(row.candidate));
        (kind.place(), groups.iter().position(|other| *other == alike), size_numbers(row.candidate))
    });
    rows
}

/// The folds that all of these rows have.
pub(super) fn common_folds(rows: &[&Row]) -> BTreeSet<usize> {
    rows.iter().map(|row| row.folds()).reduce(|a, b| &a & &b).unwrap_or_default()
}

/// Groups of rows that differ only in size, in the order of the rows.
pub(super) fn groups<'a, 'r: 'a>(rows: impl Iterator<Item = &'a Row<'r>>) -> Vec<Vec<&'a Row<'r>>> {
    let mut groups: Vec<(Candidate, Vec<&Row>)> = Vec::new();
    for row in rows {
        let key = without_size(row.candidate);
        match groups.iter_mut().find(|(other, _)| *other == key) {
            Some((_, group)) => group.push(row),
            None => groups.push((key, vec![row])),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

/// The rows of a kind that differ only in size: of several such groups the one with most results, among equal
/// ones the first. `wanted` says which groups count.
pub(super) fn settings<'a, 'r>(
    rows: &'a [Row<'r>],
    kind: impl Into<CandidateKind>,
    wanted: &dyn Fn(&Candidate) -> bool,
) -> Vec<&'a Row<'r>> {
    let kind = kind.into();
    let chosen = |row: &&Row| row.candidate.kind() == kind && wanted(row.candidate);
    let runs = |group: &Vec<&Row>| group.iter().map(|row| row.runs()).sum::<usize>();
    groups(rows.iter().filter(chosen)).into_iter().rev().max_by_key(runs).unwrap_or_default()
}

impl Row<'_> {
    fn folds(&self) -> BTreeSet<usize> {
        self.outcomes.keys().copied().collect()
    }

    /// Number of outcomes.
    pub fn runs(&self) -> usize {
        self.outcomes.values().map(Vec::len).sum()
    }

    /// The mean over the seeds of each of these folds that has a value.
    fn means(&self, folds: &BTreeSet<usize>, value: &dyn Fn(&Outcome) -> Option<f64>) -> Vec<f64> {
        let fold = |fold: &usize| {
            let values: Vec<f64> = self.outcomes.get(fold)?.iter().filter_map(|o| value(o)).collect();
            (!values.is_empty()).then(|| mean(&values))
        };
        folds.iter().filter_map(fold).collect()
    }

    /// The mean over these folds; absent without a value.
    fn mean(&self, folds: &BTreeSet<usize>, value: &dyn Fn(&Outcome) -> Option<f64>) -> Option<f64> {
        let means = self.means(folds, value);
        (!means.is_empty()).then(|| mean(&means))
    }

    /// The means over the seeds by fold, for folds with a value.
    fn by_fold(
        &self,
        folds: &BTreeSet<usize>,
        value: &dyn Fn(&Outcome) -> Option<f64>,
    ) -> BTreeMap<usize, f64> {
        let of_fold = |fold: usize| self.mean(&BTreeSet::from([fold]), value);
        folds.iter().filter_map(|fold| Some((*fold, of_fold(*fold)?))).collect()
    }

    /// The mean bound over these folds; absent without one.
    pub fn bound(&self, folds: &BTreeSet<usize>) -> Option<f64> {
        self.mean(folds, &|o| o.bound)
    }

    /// The mean error over these folds; absent without a fold.
    pub fn mse(&self, folds: &BTreeSet<usize>) -> Option<f64> {
        self.mean(folds, &|o| Some(o.score.dtw_mse))
    }

    /// The mean error on the training trials over these folds; absent if unknown.
    pub fn training_mse(&self, folds: &BTreeSet<usize>) -> Option<f64> {
        self.mean(folds, &|o| o.training_mse)
    }

    /// The median error over these folds; absent without a fold.
    pub fn mse_median(&self, folds: &BTreeSet<usize>) -> Option<f64> {
        let errors = self.means(folds, &|o| Some(o.score.dtw_mse));
        (!errors.is_empty()).then(|| median(&errors))
    }

    /// The errors of these folds, means over seeds.
    pub fn errors(&self, folds: &BTreeSet<usize>) -> BTreeMap<usize, f64> {
        self.by_fold(folds, &|o| Some(o.score.dtw_mse))
    }

    /// The error of a fold, the mean over its seeds.
    pub fn error(&self, fold: usize) -> Option<f64> {
        self.mse(&BTreeSet::from([fold]))
    }

    /// The errors on the training trials in these folds, means over seeds, as far as known.
    pub fn training_errors(&self, folds: &BTreeSet<usize>) -> BTreeMap<usize, f64> {
        self.by_fold(folds, &|o| o.training_mse)
    }

    /// The bounds of these folds, means over seeds, as far as there are any.
    pub fn bounds(&self, folds: &BTreeSet<usize>) -> BTreeMap<usize, f64> {
        self.by_fold(folds, &|o| o.bound)
    }

    /// Means over the folds whose outcomes have details.
    fn details(&self) -> Option<DetailMeans> {
        let folds = self.folds();
        let mean = |value: &dyn Fn(&Details) -> Option<f64>| {
            self.mean(&folds, &|outcome| outcome.details.as_ref().and_then(value))
        };
        let first = self.outcomes.values().flatten().find_map(|outcome| outcome.details.as_ref())?;
        let parts = 0..first.own_path.len();
        let of_parts = |value: &dyn Fn(&Details) -> &Vec<f64>| {
            parts.clone().map_while(|part| mean(&|d| value(d).get(part).copied())).collect()
        };
        let bands = |value: &dyn Fn(&Bands) -> f64| mean(&|d| d.bands.as_ref().map(value));
        let slide = mean(&|d| d.foot_slide.predicted).zip(mean(&|d| d.foot_slide.recorded));
        Some(DetailMeans {
            first_half_second: of_parts(&|d| &d.first_half_second),
            own_path: of_parts(&|d| &d.own_path),
            speed: mean(&|d| Some(d.speed.predicted / d.speed.recorded).filter(|ratio| ratio.is_finite()))?,
            foot_slide: slide.map(|(predicted, recorded)| Compared { predicted, recorded }),
            still_at_20_s: mean(&|d| Some(f64::from(u8::from(d.still_at_20_s))))?,
            bands: bands(&|b| b.within_50)
                .zip(bands(&|b| b.within_95))
                .zip(bands(&|b| b.log_density))
                .map(|((within_50, within_95), log_density)| Bands { within_50, within_95, log_density }),
            folds: self.means(&folds, &|outcome| outcome.details.as_ref().map(|_| 1.0)).len(),
        })
    }

    /// The row of a table, over all its own folds. `stands_for` is the number of candidates that it
    /// represents.
    pub fn summary(&self, label: String, stands_for: usize) -> Option<ModelSummary> {
        let folds = self.folds();
        let spread = |value: &dyn Fn(&Outcome) -> Option<f64>| Spread::new(&self.means(&folds, value));
        let terms = |value: &dyn Fn(&BoundTerms) -> f64| Some(spread(&|o| o.terms.as_ref().map(value))?.mean);
        let parts = self.outcomes.values().flatten().map(|o| o.part_errors.len()).max().unwrap_or(0);
        Some(ModelSummary {
            model: self.candidate.kind(),
            candidate: self.candidate.clone(),
            label,
            mse: spread(&|o| Some(o.score.dtw_mse))?,
            mse_median: self.mse_median(&folds)?,
            training_mse: spread(&|o| o.training_mse),
            variance: spread(&|o| Some(o.score.variance))?.mean,
            bound: spread(&|o| o.bound),
            seconds: spread(&|o| Some(o.seconds))?,
            stored_numbers: spread(&|o| Some(o.stored_numbers as f64))?,
            converged: share_converged(self.outcomes.values().flatten().copied()),
            terms: terms(&|t| t.kinematics.iter().sum())
                .zip(terms(&BoundTerms::dynamics_elbo))
                .map(|(pose, dynamics)| TermMeans { pose, dynamics }),
            part_errors: (0..parts)
                .map_while(|k| Some(spread(&|o| o.part_errors.get(k).copied())?.mean))
                .collect(),
            details: self.details(),
            folds: folds.len(),
            runs: self.runs(),
            stands_for,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::testing::{finished, outcome, results, variational};
    use vcgpdm_core::models::{DmpSettings, TmpSettings};

    #[test]
    fn orders_rows_by_model_and_size_whichever_finished_first() {
        let vgpdm = |ips| Candidate::from(Settings::Vgpdm(variational(ips)));
        let dmp = |bases| Settings::DmpRhythmic(DmpSettings { bases }).into();
        let tmp =
            |primitives, normalised_time| Settings::Tmp(TmpSettings { primitives, normalised_time }).into();
        let order =
            [vgpdm(5), vgpdm(10), tmp(None, false), tmp(Some(4), false), tmp(None, true), dmp(25), dmp(100)];
        let job = |place: usize| finished(order[place].clone(), 0, 1, 0, outcome(1.0, None, 100, 1.0));
        let came = results(2, &[5, 3, 6, 1, 2, 0, 4].map(job));
        let rows = rows(&[&came]);
        let found: Vec<_> = rows.iter().map(|row| row.candidate.clone()).collect();
        assert_eq!(found, order);
    }
}
