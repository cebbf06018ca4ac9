//! Small statistics of results.

use crate::evaluation::fixed::fixed;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use serde::Serialize;
use std::fmt;
use vcgpdm::internals::Elementary;

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

/// A confidence interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
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
    let even = freedom.is_multiple_of(2);
    // P(|t| < x) in closed form (Abramowitz and Stegun 1964, 26.7.3 and 26.7.4).
    let within = |x: f64| {
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
    };
    let (mut low, mut high) = (0.0, 20.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if within(middle) < LEVEL { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Up to this number of pairs, all orders are tried.
const ALL_ORDERS: usize = 7;
/// Number of random orders for more pairs.
const RANDOM_ORDERS: usize = 20_000;

/// One-sided p value of a negative rank correlation, by permutation: the share of the orders of one side
/// whose rank correlation is at most that of these pairs.
pub fn correlation_p_value(pairs: &[(f64, f64)]) -> Option<f64> {
    let found = rank_correlation(pairs)?;
    let (a, mut b): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
    let (mut low, mut all) = (0_usize, 0_usize);
    let mut count = |b: &[f64]| {
        let pairs: Vec<(f64, f64)> = a.iter().copied().zip(b.iter().copied()).collect();
        all += 1;
        low += usize::from(rank_correlation(&pairs).is_some_and(|rank| rank <= found + 1e-12));
    };
    if b.len() <= ALL_ORDERS {
        each_order(&mut b, 0, &mut count);
    } else {
        let mut rng = ChaCha8Rng::seed_from_u64(0);
        count(&b);
        for _ in 0..RANDOM_ORDERS {
            for k in (1..b.len()).rev() {
                let other = (rng.next_u64() % (k as u64 + 1)) as usize;
                b.swap(k, other);
            }
            count(&b);
        }
    }
    Some(low as f64 / all as f64)
}

/// Calls `visit` with every order of the values after the first `fixed`.
fn each_order(values: &mut [f64], fixed: usize, visit: &mut impl FnMut(&[f64])) {
    if fixed + 1 >= values.len() {
        visit(values);
        return;
    }
    for k in fixed..values.len() {
        values.swap(fixed, k);
        each_order(values, fixed + 1, visit);
        values.swap(fixed, k);
    }
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
    fn computes_the_p_value_of_a_rank_correlation() {
        let falling: Vec<(f64, f64)> = (0..5).map(|k| (f64::from(k), -f64::from(k))).collect();
        assert_relative_eq!(correlation_p_value(&falling).unwrap(), 1.0 / 120.0);
        // Of five pairs, 27 of 120 orders have -0.5 or less.
        let some = |b: [f64; 5]| (0..5).map(|k| (f64::from(k), b[k as usize])).collect::<Vec<_>>();
        let rank = some([4.0, 2.0, 5.0, 3.0, 1.0]);
        assert_relative_eq!(rank_correlation(&rank).unwrap(), -0.5);
        assert_relative_eq!(correlation_p_value(&rank).unwrap(), 27.0 / 120.0);
        // Many pairs: by random orders, the same every time.
        let many: Vec<(f64, f64)> = (0..12).map(|k| (f64::from(k), f64::from((k * 5) % 12))).collect();
        let p = correlation_p_value(&many).unwrap();
        assert_eq!(correlation_p_value(&many), Some(p));
        assert!((0.1..1.0).contains(&p), "{p}");
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
