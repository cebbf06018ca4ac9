//! Correlation of bound and error over the sizes of a kind of model: figure 1 of the supplement of Velychko
//! et al. (2017), and on the training trials figure 6B of Velychko et al. (2018).

use crate::evaluation::candidate::CandidateKind;
use crate::evaluation::effect::Errors;
use crate::evaluation::effect::{Choice, Contender};
use crate::evaluation::labels::Labels;
use crate::evaluation::rows::{Row, common_folds, groups, is_plain, settings};
use crate::evaluation::stats::{bootstrap_interval, mean, rank_correlation};
use crate::evaluation::summary::{BoundAndError, Correlation, Evidence};
use std::collections::BTreeSet;
use vcgpdm::models::ModelKind;

/// One correlation for every kind of model and all its settings but the size.
pub(super) fn correlations(rows: &[Row], labels: &Labels) -> Vec<Correlation> {
    let mut correlations = Vec::new();
    for kind in CandidateKind::all() {
        let groups = groups(rows.iter().filter(|row| row.candidate.kind() == kind));
        let several = groups.len() > 1;
        for group in &groups {
            let label = if several { labels.without_size(group[0].candidate) } else { String::new() };
            correlations.extend(correlation(group, label, labels));
        }
    }
    correlations
}

/// Over the folds that all of these candidates have; absent for fewer than three candidates.
pub(super) fn correlation(rows: &[&Row], label: String, labels: &Labels) -> Option<Correlation> {
    with_error(rows, label, labels, &|row, folds| row.mse(folds))
}

/// The same with the error on the training trials.
pub(super) fn training_correlation(rows: &[&Row], labels: &Labels) -> Option<Correlation> {
    with_error(rows, String::new(), labels, &|row, folds| row.training_mse(folds))
}

fn with_error(
    rows: &[&Row],
    label: String,
    labels: &Labels,
    error: &dyn Fn(&Row, &BTreeSet<usize>) -> Option<f64>,
) -> Option<Correlation> {
    let folds = common_folds(rows);
    let pair = |row: &&Row, folds: &BTreeSet<usize>| Some((row.bound(folds)?, error(row, folds)?));
    // A trial that is hard, or long, has other errors and bounds than the others: ranks within a trial do not
    // mix them.
    let within = |fold: &usize| {
        let of_fold = BTreeSet::from([*fold]);
        let pairs: Vec<(f64, f64)> = rows.iter().filter_map(|row| pair(row, &of_fold)).collect();
        (pairs.len() > 2).then(|| rank_correlation(&pairs)).flatten()
    };
    let ranks: Vec<f64> = folds.iter().filter_map(within).collect();
    let point = |row: &&Row| {
        let (bound, mse) = pair(row, &folds)?;
        Some(BoundAndError { label: labels.label(row.candidate), bound, mse })
    };
    let points: Vec<BoundAndError> = rows.iter().filter_map(point).collect();
    let model = rows.first()?.candidate.kind();
    let (rank, interval) = (mean(&ranks), bootstrap_interval(&ranks));
    let (settings, folds) = (points.len(), ranks.len());
    (folds > 0).then_some(Correlation { model, label, settings, folds, rank, interval, points })
}

/// One entry for each fold that both models have. Both are of the same frames and columns, with a noise for
/// each part or one for all. Models with weighted pose terms do not count: their training did not maximise
/// the bound on the evidence.
pub(super) fn evidence(rows: &[Row], name: &dyn Fn(usize) -> String) -> Vec<Evidence> {
    let contender = |kind| Contender::new(settings(rows, kind, &is_plain), Choice::Bound);
    let (Some(parts), Some(whole)) = (contender(ModelKind::Vcgpdm), contender(ModelKind::Vgpdm)) else {
        return Vec::new();
    };
    let of_fold = |(fold, bound): (&usize, &f64)| {
        let (a, b) = (parts.errors.get(fold)?, whole.errors.get(fold)?);
        let log_bayes_factor = bound - whole.bounds.get(fold)?;
        (*b > 0.0).then(|| Evidence { trial: name(*fold), log_bayes_factor, error_ratio: a / b })
    };
    parts.bounds.iter().filter_map(of_fold).collect()
}

/// In each fold, the error of the split with the higher bound, and that of the other split.
pub(super) fn by_preference(parts: &Contender, whole: &Contender) -> (Errors, Errors) {
    let mut sides = (Errors::new(), Errors::new());
    for (fold, bound) in &parts.bounds {
        let Some(other) = whole.bounds.get(fold) else { continue };
        let (Some(a), Some(b)) = (parts.errors.get(fold), whole.errors.get(fold)) else { continue };
        let (preferred, other) = if bound > other { (a, b) } else { (b, a) };
        sides.0.insert(*fold, *preferred);
        sides.1.insert(*fold, *other);
    }
    sides
}
