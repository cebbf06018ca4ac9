//! Logistic regression with a ceiling: how often a movement is taken for the natural one, from a score of its
//! model (Knopp et al. 2019, equations 8 to 10).

use std::sync::{Arc, Mutex, PoisonError};
use vcgpdm::internals::Elementary;
use vcgpdm::internals::Optimizer;

/// Weights stay in this box: where a score tells all answers apart, the best weight would be infinite.
const LARGEST: f64 = 30.0;
/// What the optimiser takes for one unit, in nats per trial. It ends where the gradient is a millionth of a
/// unit; where a score nearly tells all answers apart, the likelihood still rises long after it is flat to a
/// millionth of a nat.
const UNIT: f64 = 1e-8;
/// Iterations of a search over two weights; it ends long before.
const MOST_ITERATIONS: usize = 500;
/// Searches start flat, falling and rising: with a ceiling there may be several maxima.
const STARTS: [f64; 3] = [0.0, 1.0, -1.0];

/// How often movements of that score were taken for the natural one.
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
        // Where all scores say the same: the rate of all, within the ceiling.
        let share = ((hits + 0.5) / (trials + 1.0) / ceiling).clamp(0.02, 0.98);
        let flat = ((1.0 - share) / share).logarithm();
        let mut best = (f64::INFINITY, [flat, 0.0]);
        for start in STARTS {
            let found = search(points, ceiling, [flat, start]);
            if found.0 < best.0 {
                best = found;
            }
        }
        Self { ceiling, weights: best.1 }
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
    /// tell both.
    pub fn errors(&self, points: &[Point]) -> Option<[f64; 2]> {
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
        let determinant = a * c - b * b;
        (determinant > 1e-9 * a * c && a > 0.0).then(|| [(c / determinant).sqrt(), (a / determinant).sqrt()])
    }
}

/// The least negative log likelihood from there, in units of all trials together, and its weights.
fn search(points: &[Point], ceiling: f64, start: [f64; 2]) -> (f64, [f64; 2]) {
    let best = Arc::new(Mutex::new((f64::INFINITY, start)));
    let (seen, own) = (Arc::clone(&best), points.to_vec());
    let unit = UNIT * points.iter().map(|point| point.trials).sum::<f64>().max(1.0);
    let evaluate = move |x: &[f64]| {
        let weights = [x[0], x[1]];
        let (mut value, mut gradient) = (0.0, vec![0.0; 2]);
        for point in &own {
            let (log_likelihood, slope) = log_likelihood(point, ceiling, weights);
            value -= log_likelihood / unit;
            gradient[0] -= slope / unit;
            gradient[1] -= slope * point.score / unit;
        }
        let mut best = seen.lock().unwrap_or_else(PoisonError::into_inner);
        if value < best.0 {
            *best = (value, weights);
        }
        (value, gradient)
    };
    let boxes = [(-LARGEST, LARGEST); 2].into_iter();
    let mut optimizer = Optimizer::new(start.to_vec(), boxes, Box::new(evaluate));
    let mut iterations = 0;
    while optimizer.step() && iterations < MOST_ITERATIONS {
        iterations += 1;
    }
    *best.lock().unwrap_or_else(PoisonError::into_inner)
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
    let of_rest =
        if x > 0.0 { 1.0 / ((1.0 - ceiling) * small + 1.0) } else { small / (1.0 - ceiling + small) };
    let value = hits * (ceiling.logarithm() - whole) + (trials - hits) * (rest - whole);
    (value, -hits * rising + (trials - hits) * (of_rest - rising))
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

    /// Answers of observers who follow the curve.
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
    fn the_slope_is_that_of_the_likelihood() {
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
    fn simulated_observers_give_back_their_weights() {
        let (mut inside, mut count) = (0, 0);
        for (weights, ceiling) in [([0.0, 1.5], 0.5), ([-1.0, 0.8], 0.5), ([0.5, -2.0], 0.6)] {
            let truth = Curve { ceiling, weights };
            for seed in 0..20 {
                let points = simulated(&truth, &scores(20), 158, seed);
                let found = Curve::fit(&points, ceiling);
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

    /// The best curve is steep, and the likelihood nearly flat on the way there. How steep the curve was
    /// found to be once depended on where the optimiser happened to stop.
    #[test]
    fn a_score_that_nearly_tells_answers_apart_has_its_steep_curve() {
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
    fn answers_that_a_score_tells_apart_stay_in_the_box() {
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
