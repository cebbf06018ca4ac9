//! Correlation of bound and error over the sizes of a kind of model: figure 1 of the supplement of Velychko
//! et al. (2017), and on the training trials figure 6B of Velychko et al. (2018).

use crate::evaluation::candidate::CandidateKind;
use crate::evaluation::labels::Labels;
use crate::evaluation::rows::{Row, common_folds, groups};
use crate::evaluation::stats::{correlation_p_value, rank_correlation};
use crate::evaluation::summary::{BoundAndError, Correlation};
use std::collections::BTreeSet;

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
    let point = |row: &&Row| {
        let (bound, mse) = (row.bound(&folds)?, error(row, &folds)?);
        Some(BoundAndError { label: labels.label(row.candidate), bound, mse })
    };
    let points: Vec<BoundAndError> = rows.iter().filter_map(point).collect();
    let pairs: Vec<(f64, f64)> = points.iter().map(|p| (p.bound, p.mse)).collect();
    let rank = (pairs.len() > 2).then(|| rank_correlation(&pairs)).flatten()?;
    let chance = correlation_p_value(&pairs)?;
    let model = rows[0].candidate.kind();
    Some(Correlation { model, label, settings: points.len(), folds: folds.len(), rank, chance, points })
}
