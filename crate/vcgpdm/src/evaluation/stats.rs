//! Small statistics of results.

use crate::elementary::Elementary;

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

/// Ranks from 1; values that are equal share the mean of their ranks.
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

/// Spearman's rank correlation of pairs; absent where one side does not vary or there are fewer than two pairs.
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

/// The exponent k of y = c x^k: the slope of a straight line through the logarithms of positive pairs; absent where x does not
/// vary.
pub fn exponent(pairs: &[(f64, f64)]) -> Option<f64> {
    let logarithms: Vec<(f64, f64)> = pairs.iter().map(|(x, y)| (x.logarithm(), y.logarithm())).collect();
    let (x, y): (Vec<f64>, Vec<f64>) = logarithms.iter().copied().unzip();
    let (mx, my) = (mean(&x), mean(&y));
    let spread: f64 = x.iter().map(|x| (x - mx) * (x - mx)).sum();
    let product: f64 = logarithms.iter().map(|(x, y)| (x - mx) * (y - my)).sum();
    (spread > 0.0).then(|| product / spread)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn by_hand() {
        assert_eq!(mean(&[1.0, 2.0, 6.0]), 3.0);
        // Deviations -2, -1, 3: variance 14 / 2, divided by 3.
        assert_relative_eq!(standard_error(&[1.0, 2.0, 6.0]).unwrap(), (7.0f64 / 3.0).sqrt());
        assert_eq!(standard_error(&[1.0]), None);
        assert_eq!((median(&[6.0, 1.0, 2.0]), median(&[6.0, 1.0, 2.0, 3.0])), (2.0, 2.5));
        assert!(median(&[]).is_nan());
        assert_eq!(ranks(&[3.0, 1.0, 3.0, 2.0]), [3.5, 1.0, 3.5, 2.0]);
    }

    #[test]
    fn rank_correlation_sees_order_only() {
        let cubes: Vec<(f64, f64)> = (0..7).map(|k| (f64::from(k), f64::from(k).powi(3))).collect();
        assert_relative_eq!(rank_correlation(&cubes).unwrap(), 1.0);
        let falling: Vec<(f64, f64)> = cubes.iter().map(|(x, y)| (*x, -y)).collect();
        assert_relative_eq!(rank_correlation(&falling).unwrap(), -1.0);
        // Spearman 1904's formula for distinct ranks: 1 - 6 sum d^2 / (n (n^2 - 1)), here d = 1, -1, 0.
        assert_relative_eq!(rank_correlation(&[(1.0, 2.0), (2.0, 1.0), (3.0, 3.0)]).unwrap(), 0.5);
        assert_eq!(rank_correlation(&[(1.0, 2.0), (1.0, 3.0)]), None);
    }

    #[test]
    fn exponents_of_powers() {
        let powers: Vec<(f64, f64)> = [1.0, 2.0, 5.0].iter().map(|x: &f64| (*x, 3.0 * x.powf(2.7))).collect();
        assert_relative_eq!(exponent(&powers).unwrap(), 2.7, epsilon = 1e-12);
        assert_eq!(exponent(&[(2.0, 1.0), (2.0, 3.0)]), None);
    }
}
