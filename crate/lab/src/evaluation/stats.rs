//! Small statistics of results.

use crate::evaluation::fixed::fixed;
use serde::Serialize;
use std::fmt;
use vcgpdm_core::elementary::Elementary;

/// The mean; NaN without values.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The median, the mean of the middle two of an even number; NaN without values.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len();
    if n == 0 { f64::NAN } else { 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]) }
}

/// The standard error of the mean; absent for fewer than two values.
pub fn standard_error(values: &[f64]) -> Option<f64> {
    let n = values.len() as f64;
    let m = mean(values);
    let squares: f64 = values.iter().map(|v| (v - m) * (v - m)).sum();
    (values.len() > 1).then(|| (squares / (n - 1.0) / n).sqrt())
}

/// Ranks from 1; equal values share the mean of their ranks.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut first = 0;
    while first < order.len() {
        let same = order[first..].iter().take_while(|k| values[**k] == values[order[first]]).count();
        for k in &order[first..first + same] {
            ranks[*k] = first as f64 + 0.5 * (same as f64 + 1.0);
        }
        first += same;
    }
    ranks
}

/// Spearman's rank correlation of pairs; absent if one side is constant or there are fewer than two pairs.
pub fn rank_correlation(pairs: &[(f64, f64)]) -> Option<f64> {
    let (a, b): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
    let (a, b) = (ranks(&a), ranks(&b));
    let (ma, mb) = (mean(&a), mean(&b));
    let product = |x: &[f64], mx: f64, y: &[f64], my: f64| -> f64 {
        x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum()
    };
    let spread = (product(&a, ma, &a, ma) * product(&b, mb, &b, mb)).sqrt();
    (spread > 0.0).then(|| product(&a, ma, &b, mb) / spread)
}

/// The exponent k of y = c x^k: the slope of a straight line through the logarithms of positive pairs; absent
/// if x is constant.
pub fn exponent(pairs: &[(f64, f64)]) -> Option<f64> {
    let logarithms: Vec<(f64, f64)> = pairs.iter().map(|(x, y)| (x.logarithm(), y.logarithm())).collect();
    let (x, y): (Vec<f64>, Vec<f64>) = logarithms.iter().copied().unzip();
    let (mx, my) = (mean(&x), mean(&y));
    let spread: f64 = x.iter().map(|x| (x - mx) * (x - mx)).sum();
    let product: f64 = logarithms.iter().map(|(x, y)| (x - mx) * (y - my)).sum();
    (spread > 0.0).then(|| product / spread)
}

/// An interval for a number, and the probability that such an interval covers the number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The confidence level, 0.95 or a little more.
    pub level: f64,
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} to {}", fixed(self.low, 2), fixed(self.high, 2))
    }
}

impl Interval {
    /// The interval of an increasing function of the number.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self { low: f(self.low), high: f(self.high), level: self.level }
    }
}

/// The smallest confidence level of the intervals.
const LEVEL: f64 = 0.95;

/// Confidence interval of the median, between two of the values, by the sign test: it assumes no
/// distribution, and one extreme value cannot move it far. Absent for fewer than six values, which give no
/// interval of 95 %.
pub fn median_interval(values: &[f64]) -> Option<Interval> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len();
    // The probability that fewer than k of n coins show heads, for growing k.
    let (mut term, mut below, mut found) = (0.5_f64.powi(i32::try_from(n).ok()?), 0.0, None);
    for k in 1..=n / 2 {
        below += term;
        term *= (n - k + 1) as f64 / k as f64;
        let level = 1.0 - 2.0 * below;
        if level < LEVEL {
            break;
        }
        found = Some(Interval { low: sorted[k - 1], high: sorted[n - k], level });
    }
    found
}

/// Student's confidence interval of the mean of normal values; absent for fewer than two.
pub fn mean_interval(values: &[f64]) -> Option<Interval> {
    let reach = standard_error(values)? * student_quantile(values.len() - 1);
    let middle = mean(values);
    Some(Interval { low: middle - reach, high: middle + reach, level: LEVEL })
}

/// The number x with P(|t| < x) = 95 % for a Student t of `freedom` degrees of freedom.
pub fn student_quantile(freedom: usize) -> f64 {
    let (mut low, mut high) = (0.0, 20.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if student_within(middle, freedom) < LEVEL { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// P(|t| < x) for a Student t of `freedom` degrees of freedom, in closed form (Abramowitz and Stegun 1964,
/// 26.7.3 and 26.7.4).
fn student_within(x: f64, freedom: usize) -> f64 {
    let even = freedom.is_multiple_of(2);
    let angle = x.arctangent((freedom as f64).sqrt());
    let (sine, cosine) = angle.sine_cosine();
    let (mut term, mut sum) = (if even { 1.0 } else { cosine }, 0.0);
    let mut k = if even { 1 } else { 2 };
    while k < freedom {
        sum += term;
        term *= cosine * cosine * k as f64 / (k + 1) as f64;
        k += 2;
    }
    if even { sine * sum } else { 2.0 / std::f64::consts::PI * (angle + sine * sum) }
}

/// The two-sided p value of the sign test of a median of 0; values of 0 do not count.
pub fn sign_test(values: &[f64]) -> f64 {
    let (below, above) =
        (values.iter().filter(|v| **v < 0.0).count(), values.iter().filter(|v| **v > 0.0).count());
    let n = below + above;
    let mut term = i32::try_from(n).map_or(0.0, |n| 0.5_f64.powi(n));
    let mut tail = 0.0;
    for k in 0..=below.min(above) {
        tail += term;
        term *= (n - k) as f64 / (k + 1) as f64;
    }
    (2.0 * tail).min(1.0)
}

/// The two-sided p value of Student's t test of a mean of 0; absent for fewer than two values, or equal ones.
pub fn student_test(values: &[f64]) -> Option<f64> {
    let error = standard_error(values).filter(|error| *error > 0.0)?;
    Some((1.0 - student_within((mean(values) / error).abs(), values.len() - 1)).max(0.0))
}

/// The smallest number of values with this mean and standard deviation whose [`student_test`] has a p value below
/// `level`; absent for fewer than two values, equal ones, and where more than a thousand are needed.
pub fn values_needed(values: &[f64], level: f64) -> Option<usize> {
    let error = standard_error(values).filter(|error| *error > 0.0)?;
    let effect = (mean(values) / error).abs() / (values.len() as f64).sqrt();
    (2..=1000).find(|n| 1.0 - student_within(effect * (*n as f64).sqrt(), n - 1) < level)
}

/// Holm's correction: the p values of tests that are made together, so that any false rejection has at most
/// the probability of the level (Holm 1979).
pub fn holm(p_values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..p_values.len()).collect();
    order.sort_by(|a, b| p_values[*a].total_cmp(&p_values[*b]));
    let mut adjusted = vec![1.0; p_values.len()];
    let mut least = 0.0_f64;
    for (place, test) in order.into_iter().enumerate() {
        least = least.max((p_values.len() - place) as f64 * p_values[test]).min(1.0);
        adjusted[test] = least;
    }
    adjusted
}

/// [`exponent`] with Student's interval of the slope; no interval for fewer than three pairs.
pub fn exponent_interval(pairs: &[(f64, f64)]) -> Option<(f64, Option<Interval>)> {
    let slope = exponent(pairs)?;
    let points: Vec<(f64, f64)> = pairs.iter().map(|(x, y)| (x.logarithm(), y.logarithm())).collect();
    let (x, y): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
    let (mx, my) = (mean(&x), mean(&y));
    let squares: f64 = points.iter().map(|(x, y)| (y - my - slope * (x - mx)).powi(2)).sum();
    let spread: f64 = x.iter().map(|x| (x - mx).powi(2)).sum();
    let interval = (points.len() > 2).then(|| {
        let freedom = points.len() - 2;
        let reach = student_quantile(freedom) * (squares / freedom as f64 / spread).sqrt();
        Interval { low: slope - reach, high: slope + reach, level: LEVEL }
    });
    Some((slope, interval))
}

/// An exponent of `points` points has this interval. How many times as many points, with the same spread round their
/// line, would give an interval without the limit; absent where more than a thousand times are needed.
pub fn times_needed(interval: Interval, points: usize, limit: f64) -> Option<usize> {
    let middle = 0.5 * (interval.low + interval.high);
    let error = (interval.high - middle) / student_quantile(points.checked_sub(2).filter(|n| *n > 0)?);
    let reach = |times: usize| student_quantile(times * points - 2) * error / (times as f64).sqrt();
    (1..=1000).find(|times| (middle - limit).abs() > reach(*times))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn computes_means_medians_and_ranks_as_by_hand() {
        assert_eq!(mean(&[1.0, 2.0, 6.0]), 3.0);
        // Deviations -2, -1, 3: variance 14 / 2, divided by 3.
        assert_relative_eq!(standard_error(&[1.0, 2.0, 6.0]).unwrap(), (7.0f64 / 3.0).sqrt());
        assert_eq!(standard_error(&[1.0]), None);
        assert_eq!((median(&[6.0, 1.0, 2.0]), median(&[6.0, 1.0, 2.0, 3.0])), (2.0, 2.5));
        assert!(median(&[]).is_nan());
        assert_eq!(ranks(&[3.0, 1.0, 3.0, 2.0]), [3.5, 1.0, 3.5, 2.0]);
    }

    #[test]
    fn rank_correlation_depends_only_on_the_order() {
        let cubes: Vec<(f64, f64)> = (0..7).map(|k| (f64::from(k), f64::from(k).powi(3))).collect();
        assert_relative_eq!(rank_correlation(&cubes).unwrap(), 1.0);
        let falling: Vec<(f64, f64)> = cubes.iter().map(|(x, y)| (*x, -y)).collect();
        assert_relative_eq!(rank_correlation(&falling).unwrap(), -1.0);
        // Spearman 1904's formula for distinct ranks: 1 - 6 sum d^2 / (n (n^2 - 1)), here d = 1, -1, 0.
        assert_relative_eq!(rank_correlation(&[(1.0, 2.0), (2.0, 1.0), (3.0, 3.0)]).unwrap(), 0.5);
        assert_eq!(rank_correlation(&[(1.0, 2.0), (1.0, 3.0)]), None);
    }

    #[test]
    fn finds_the_exponent_of_a_power() {
        let powers: Vec<(f64, f64)> = [1.0, 2.0, 5.0].iter().map(|x: &f64| (*x, 3.0 * x.powf(2.7))).collect();
        assert_relative_eq!(exponent(&powers).unwrap(), 2.7, epsilon = 1e-12);
        assert_eq!(exponent(&[(2.0, 1.0), (2.0, 3.0)]), None);
    }

    /// By hand with the published points of t: 0.88 of four points is 0.32 away from 1.2; twice as many reach 0.15.
    #[test]
    fn says_how_many_trainings_decide_an_exponent() {
        let interval = Interval { low: 0.5, high: 1.26, level: LEVEL };
        assert_eq!(times_needed(interval, 4, 1.2), Some(2));
        assert_eq!(times_needed(interval, 4, 1.3), Some(1));
        assert_eq!((times_needed(interval, 4, 0.88), times_needed(interval, 2, 1.2)), (None, None));
    }

    #[test]
    fn gives_the_intervals_of_published_tables() {
        // Two-sided 95 % points of Student's t.
        for (freedom, quantile) in [(1, 12.706), (2, 4.303), (3, 3.182), (6, 2.447), (9, 2.262), (30, 2.042)]
        {
            assert_relative_eq!(student_quantile(freedom), quantile, epsilon = 1e-3);
        }
        let ten: Vec<f64> = (1..=10).map(f64::from).collect();
        // The sign test: P(fewer than 2 of 10 heads) = 11 / 1024.
        let found = median_interval(&ten).unwrap();
        assert_eq!((found.low, found.high, found.level), (2.0, 9.0, 1.0 - 22.0 / 1024.0));
        assert_eq!(median_interval(&ten[..6]).map(|i| (i.low, i.high)), Some((1.0, 6.0)));
        assert_eq!(median_interval(&ten[..5]), None);
        // One extreme value changes nothing.
        let extreme: Vec<f64> = ten.iter().map(|v| if *v == 10.0 { 1e9 } else { *v }).collect();
        assert_eq!(median_interval(&extreme), Some(found));
        let found = mean_interval(&[1.0, 2.0, 6.0]).unwrap();
        assert_relative_eq!(found.high, 3.0 + 4.3027 * (7.0f64 / 3.0).sqrt(), epsilon = 1e-3);
    }

    #[test]
    fn gives_the_p_values_of_published_tables() {
        // 1 of 8 below: 2 (1 + 8) / 256. A tie does not count.
        let one = [-1.0, 1.0, 2.0, 3.0, 0.5, 1.0, 4.0, 2.0];
        assert_relative_eq!(sign_test(&one), 18.0 / 256.0);
        assert_relative_eq!(sign_test(&[&one[..], &[0.0]].concat()), 18.0 / 256.0);
        assert_eq!((sign_test(&[]), sign_test(&[1.0]), sign_test(&[1.0, -1.0])), (1.0, 1.0, 1.0));
        // Mean 1, standard error 1 / sqrt(3), so t = 1.732: p = 0.2254 for two degrees of freedom.
        assert_relative_eq!(student_test(&[0.0, 1.0, 2.0]).unwrap(), 0.2254, epsilon = 1e-4);
        assert_eq!(student_test(&[1.0, 1.0]), None);
        // At the 95 % points the p value is 5 %.
        for freedom in [1, 2, 5, 8] {
            assert_relative_eq!(student_within(student_quantile(freedom), freedom), 0.95, epsilon = 1e-9);
        }
    }

    #[test]
    fn corrects_tests_that_are_made_together() {
        // Holm (1979): times 4, 3, 2, 1 from the smallest on, and never smaller than the one before.
        let found = holm(&[0.03, 0.01, 0.04, 0.005]);
        for (found, expected) in found.iter().zip([0.06, 0.03, 0.06, 0.02]) {
            assert_relative_eq!(*found, expected, epsilon = 1e-12);
        }
        assert_eq!((holm(&[0.9, 0.8]), holm(&[])), (vec![1.0, 1.0], vec![]));
    }

    #[test]
    fn gives_an_interval_of_the_exponent() {
        let pairs = [(1.0, 1.0), (2.0, 2.2), (4.0, 3.9), (8.0, 8.1)];
        let (slope, interval) = exponent_interval(&pairs).unwrap();
        let interval = interval.unwrap();
        assert!(
            interval.low < 1.0 && interval.high > 1.0 && interval.high - interval.low < 0.5,
            "{slope} {interval:?}"
        );
        assert_eq!(exponent_interval(&pairs[..2]).unwrap().1, None);
    }
}
