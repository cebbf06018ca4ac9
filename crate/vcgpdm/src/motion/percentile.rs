//! The upper end of a set of numbers, where a few outliers must not count.

/// The value that 95 of 100 values do not exceed, and the largest value; both are 0 where there are no
/// values.
pub(crate) fn upper_end(mut values: Vec<f64>) -> (f64, f64) {
    values.sort_unstable_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    let at = |place: usize| values.get(place).copied().unwrap_or(0.0);
    (at(last * 95 / 100), at(last))
}
