//! Logistic regression with a ceiling: how often a movement is taken for the natural one, from a score of its
//! model (Knopp et al. 2019, equations 8 to 10).

use crate::evaluation::stats::mean;
use vcgpdm_core::elementary::Elementary;

/// Fewest settings of a curve.
const FEWEST_SETTINGS: usize = 3;
/// Number of points of a drawn curve.
pub(super) const DRAWN: usize = 61;

/// Largest absolute value of a weight: where a score separates all answers, the best weight would be
/// infinite.
const LARGEST: f64 = 30.0;
/// A search ends when no weight changes by more than this, and usually within 20 iterations.
const SMALLEST_STEP: f64 = 1e-13;
const MOST_ITERATIONS: usize = 500;
/// Relative rounding error of a log likelihood.
const ROUNDING: f64 = 1e-14;
/// Least damping of a step, and least information: they keep the information matrix regular.
const LEAST_DAMPING: f64 = 1e-10;
const LEAST_INFORMATION: f64 = 1e-12;
/// First slopes of the searches: flat, falling and rising. With a ceiling there may be several maxima.
const STARTS: [f64; 3] = [0.0, 1.0, -1.0];

/// How scores are standardised: minus their mean, over their standard deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Standard {
    pub centre: f64,
    pub scale: f64,
    low: f64,
    high: f64,
}

impl Standard {
    /// Absent for too few scores, or if all are equal.
    pub fn of(scores: &[f64]) -> Option<Self> {
        let centre = mean(scores);
        let squares: f64 = scores.iter().map(|score| (score - centre) * (score - centre)).sum();
        let scale = (squares / scores.len().max(1) as f64).sqrt();
        let [low, high] = [f64::min, f64::max].map(|of| scores.iter().copied().fold(centre, of));
        let fits = scores.len() >= FEWEST_SETTINGS && scale.is_finite() && scale > 1e-12 * centre.abs();
        fits.then_some(Self { centre, scale, low, high })
    }

    /// The standardised score.
    pub fn of_score(&self, score: f64) -> f64 {
        (score - self.centre) / self.scale
    }

    /// Points of a curve over the standardised score, from the lowest to the highest score.
    pub fn drawn(&self, curve: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        let scores = (0..DRAWN).map(|k| self.low + (self.high - self.low) * k as f64 / (DRAWN - 1) as f64);
        scores.map(|score| (score, curve(self.of_score(score)))).collect()
    }
}

/// How often movements of one score were taken for the natural one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Point {
    /// The standardised score.
    pub score: f64,
    pub hits: f64,
    pub trials: f64,
}

/// p = ceiling / (1 + exp(w0 + w1 score)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Curve {
    pub ceiling: f64,
    pub weights: [f64; 2],
}

impl Curve {
    /// The curve of the highest likelihood.
    pub fn fit(points: &[Point], ceiling: f64) -> Self {
        let (hits, trials) = points
            .iter()
            .fold((0.0, 0.0), |(hits, trials), point| (hits + point.hits, trials + point.trials));
        // The flat curve has the mean rate of all points.
        let share = ((hits + 0.5) / (trials + 1.0) / ceiling).clamp(0.02, 0.98);
        let flat = ((1.0 - share) / share).logarithm();
        let starts = STARTS.map(|slope| Self { ceiling, weights: [flat, slope] });
        let found = starts.map(|start| start.rise(points));
        let best = found.into_iter().reduce(|best, other| if other.1 > best.1 { other } else { best });
        best.map_or(starts[0], |(curve, _)| curve)
    }

    /// Fisher scoring from this curve: a curve of the highest likelihood nearby, and its log likelihood. A
    /// step that lowers the likelihood is damped.
    fn rise(mut self, points: &[Point]) -> (Self, f64) {
        let mut value = self.log_likelihood(points);
        let mut damping = LEAST_DAMPING;
        for _ in 0..MOST_ITERATIONS {
            let next = self.step(points, damping);
            let next_value = next.log_likelihood(points);
            if next_value >= value - ROUNDING * value.abs() {
                let change = |k: usize| (next.weights[k] - self.weights[k]).abs();
                let small = change(0).max(change(1)) < SMALLEST_STEP;
                (self, value) = (next, next_value);
                if small {
                    break;
                }
                damping = (0.1 * damping).max(LEAST_DAMPING);
            } else {
                damping *= 10.0;
            }
        }
        (self, value)
    }

    /// The curve after one damped step of Fisher scoring. A weight at its limit whose step would cross it
    /// stays.
    fn step(&self, points: &[Point], damping: f64) -> Self {
        let [a, b, c] = self.information(points);
        let [a, c] = [a, c].map(|diagonal| diagonal * (1.0 + damping) + LEAST_INFORMATION);
        let mut gradient = [0.0; 2];
        for point in points {
            let slope = log_likelihood(point, self.ceiling, self.weights).1;
            gradient[0] += slope;
            gradient[1] += slope * point.score;
        }
        let [g0, g1] = gradient;
        let stays = |k: usize| self.weights[k].abs() >= LARGEST && self.weights[k] * gradient[k] > 0.0;
        let determinant = a * c - b * b;
        let step = match (stays(0), stays(1)) {
            (false, false) => [(c * g0 - b * g1) / determinant, (a * g1 - b * g0) / determinant],
            (stays0, stays1) => [if stays0 { 0.0 } else { g0 / a }, if stays1 { 0.0 } else { g1 / c }],
        };
        let weights = [0, 1].map(|k| (self.weights[k] + step[k]).clamp(-LARGEST, LARGEST));
        Self { ceiling: self.ceiling, weights }
    }

    /// The probability of being taken for the natural one.
    pub fn rate(&self, score: f64) -> f64 {
        let [w0, w1] = self.weights;
        self.ceiling * falling(w0 + w1 * score)
    }

    /// The log likelihood of all answers.
    pub fn log_likelihood(&self, points: &[Point]) -> f64 {
        points.iter().map(|point| log_likelihood(point, self.ceiling, self.weights).0).sum()
    }

    /// The standard errors of both weights, from the expected information; absent where the answers do not
    /// determine both.
    pub fn errors(&self, points: &[Point]) -> Option<[f64; 2]> {
        let [a, b, c] = self.information(points);
        let determinant = a * c - b * b;
        (determinant > 1e-9 * a * c && a > 0.0).then(|| [(c / determinant).sqrt(), (a / determinant).sqrt()])
    }

    /// The expected information of (w0, w0), (w0, w1) and (w1, w1).
    fn information(&self, points: &[Point]) -> [f64; 3] {
        let [w0, w1] = self.weights;
        let (mut a, mut b, mut c) = (0.0, 0.0, 0.0);
        for Point { score, trials, .. } in points {
            let share = falling(w0 + w1 * score);
            let (rate, slope) = (self.ceiling * share, self.ceiling * share * (1.0 - share));
            let information = trials * slope * slope / (rate * (1.0 - rate)).max(1e-300);
            a += information;
            b += information * score;
            c += information * score * score;
        }
        [a, b, c]
    }
}

/// The log likelihood of a point's answers, and its derivative by w0 + w1 score.
fn log_likelihood(point: &Point, ceiling: f64, weights: [f64; 2]) -> (f64, f64) {
    let x = weights[0] + weights[1] * point.score;
    let Point { hits, trials, .. } = *point;
    // p = c / (1 + e^x) and 1 - p = (1 - c + e^x) / (1 + e^x), by e^-|x|, which cannot overflow.
    let small = (-x.abs()).exponential();
    let (whole, rest) = if x > 0.0 {
        (x + (1.0 + small).logarithm(), x + ((1.0 - ceiling) * small + 1.0).logarithm())
    } else {
        ((1.0 + small).logarithm(), (1.0 - ceiling + small).logarithm())
    };
    let rising = 1.0 - falling(x);
    let rest_share =
        if x > 0.0 { 1.0 / ((1.0 - ceiling) * small + 1.0) } else { small / (1.0 - ceiling + small) };
    let value = hits * (ceiling.logarithm() - whole) + (trials - hits) * (rest - whole);
    (value, -hits * rising + (trials - hits) * (rest_share - rising))
}

/// 1 / (1 + e^x).
fn falling(x: f64) -> f64 {
    let small = (-x.abs()).exponential();
    if x > 0.0 { small / (1.0 + small) } else { 1.0 / (1.0 + small) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    /// Answers of simulated observers who follow the curve.
    fn simulated(curve: &Curve, scores: &[f64], trials: usize, seed: u64) -> Vec<Point> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut uniform = || random.next_u32() as f64 / f64::from(u32::MAX);
        let point = |&score: &f64| {
            let hits = (0..trials).filter(|_| uniform() < curve.rate(score)).count();
            Point { score, hits: hits as f64, trials: trials as f64 }
        };
        scores.iter().map(point).collect()
    }

    fn scores(count: usize) -> Vec<f64> {
        (0..count).map(|k| 3.4 * (k as f64 / (count - 1) as f64 - 0.5)).collect()
    }

    #[test]
    fn the_slope_agrees_with_differences_of_the_likelihood() {
        for ceiling in [0.3, 0.5, 1.0] {
            for x in [-40.0, -3.0, -0.1, 0.1, 2.0, 40.0] {
                let point = Point { score: 0.0, hits: 3.0, trials: 7.0 };
                let value = |x: f64| log_likelihood(&point, ceiling, [x, 5.0]).0;
                let slope = log_likelihood(&point, ceiling, [x, 5.0]).1;
                let numeric = (value(x + 1e-5) - value(x - 1e-5)) / 2e-5;
                assert!((slope - numeric).abs() < 1e-4, "{ceiling} {x}: {slope} {numeric}");
                let rate = Curve { ceiling, weights: [x, 0.0] }.rate(1.0);
                if x.abs() < 5.0 {
                    assert_relative_eq!(value(x), 3.0 * rate.ln() + 4.0 * (1.0 - rate).ln(), epsilon = 1e-9);
                }
            }
        }
    }

    #[test]
    fn finds_the_weights_of_simulated_observers() {
        let (mut inside, mut count) = (0, 0);
        for (weights, ceiling) in [([0.0, 1.5], 0.5), ([-1.0, 0.8], 0.5), ([0.5, -2.0], 0.6)] {
            let truth = Curve { ceiling, weights };
            for seed in 0..20 {
                let points = simulated(&truth, &scores(20), 158, seed);
                let found = Curve::fit(&points, ceiling);
                let slopes = points.iter().map(|point| log_likelihood(point, ceiling, found.weights).1);
                assert!(slopes.sum::<f64>().abs() < 1e-9);
                let errors = found.errors(&points).unwrap();
                for k in 0..2 {
                    let off = (found.weights[k] - weights[k]).abs() / errors[k];
                    assert!(off < 4.0, "{weights:?}, seed {seed}: {found:?} +- {errors:?}");
                    inside += usize::from(off < 1.96);
                    count += 1;
                }
                assert!(found.log_likelihood(&points) >= truth.log_likelihood(&points));
            }
        }
        // 95 % of the intervals hold the truth.
        assert!((0.9..1.0).contains(&(inside as f64 / count as f64)), "{inside} of {count}");
    }

    /// The best curve is steep, and the likelihood nearly flat around it. An earlier search stopped too soon.
    #[test]
    fn finds_the_steep_curve_of_a_score_that_nearly_separates_the_answers() {
        let points = [-1.0, 1.0].map(|score| Point {
            score,
            hits: if score < 0.0 { 499.0 } else { 1e-4 },
            trials: 1000.0,
        });
        let curve = Curve::fit(&points, 0.5);
        // Both rates are met by a curve within the box.
        for point in &points {
            let rate = point.hits / point.trials;
            assert_relative_eq!(curve.rate(point.score), rate, max_relative = 1e-4);
        }
    }

    #[test]
    fn weights_stay_in_the_box_where_a_score_separates_the_answers() {
        let apart: Vec<Point> = scores(10)
            .into_iter()
            .map(|score| Point { score, hits: if score < 0.0 { 50.0 } else { 0.0 }, trials: 50.0 })
            .collect();
        let curve = Curve::fit(&apart, 1.0);
        assert!(curve.weights.iter().all(|weight| weight.abs() <= LARGEST));
        assert!(curve.rate(-0.5) > 0.99 && curve.rate(0.5) < 0.01, "{curve:?}");
        let none = Curve::fit(&[Point { score: 0.0, hits: 0.0, trials: 9.0 }], 0.5);
        assert!(none.rate(0.0) < 0.05 && none.errors(&[]).is_none());
        assert!(Curve::fit(&[], 0.5).rate(0.0).is_finite());
    }
}
