//! The upper end of a set of numbers, robust against a few outliers.

/// The 95th percentile and the maximum; both are 0 for an empty list.
pub(crate) fn upper_end(mut values: Vec<f64>) -> (f64, f64) {
    values.sort_unstable_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    let at = |place: usize| values.get(place).copied().unwrap_or(0.0);
    (at(last * 95 / 100), at(last))
}
