//! What the filter is compared with: regressions of a part on the last frames of the others.

use crate::completing::answer::Answer;
use nalgebra::DMatrix;
use std::f64::consts::TAU;
use vcgpdm::gp::NumericsError;
use vcgpdm::internals::{Elementary, Factor};

/// Frames of a history, the newest included.
pub const HISTORY: usize = 5;
/// Factors of the mean variance of an input on the diagonal of a ridge regression.
const RIDGES: [f64; 6] = [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0];
/// Lengthscales of a Gaussian process in units of the middle distance of two inputs, and noise variances in
/// units of the signal variance.
const LENGTHSCALES: [f64; 3] = [0.5, 1.0, 2.0];
const NOISES: [f64; 3] = [1e-3, 1e-2, 1e-1];
/// Inducing inputs of the sparse Gaussian process: training histories at equal distances.
const INDUCING: usize = 100;
/// The least variance of a column, in squared units of the columns.
const LEAST_VARIANCE: f64 = 1e-12;

/// Columns of all frames with a history [frames - HISTORY + 1 x D], and their variances `[D]`.
type Prediction = (DMatrix<f64>, Vec<f64>);

/// The training trials as pairs of histories and frames.
struct Pairs {
    inputs: DMatrix<f64>,
    targets: DMatrix<f64>,
    /// Whether each pair is from a trial with an even number.
    even: Vec<bool>,
}

/// The histories of each frame that has one, newest last [frames - HISTORY + 1 x HISTORY D].
fn histories(y: &DMatrix<f64>) -> DMatrix<f64> {
    let (d, rows) = (y.ncols(), (y.nrows() + 1).saturating_sub(HISTORY));
    DMatrix::from_fn(rows, HISTORY * d, |t, k| y[(t + k / d, k % d)])
}

/// The observed columns with the last observed row in place of each missing one.
fn filled(y: &DMatrix<f64>) -> DMatrix<f64> {
    let mut y = y.clone();
    for t in 1..y.nrows() {
        if y[(t, 0)].is_nan() {
            let last = y.row(t - 1).into_owned();
            y.set_row(t, &last);
        }
    }
    y
}

impl Pairs {
    /// Pairs of trials, each with the columns of the given parts and of the other part.
    fn new(trials: &[(DMatrix<f64>, DMatrix<f64>)]) -> Self {
        let (given, other) = trials.first().map_or((0, 0), |(given, other)| (given.ncols(), other.ncols()));
        let histories: Vec<DMatrix<f64>> = trials.iter().map(|(given, _)| histories(given)).collect();
        let rows: usize = histories.iter().map(DMatrix::nrows).sum();
        let (mut inputs, mut targets) = (DMatrix::zeros(rows, HISTORY * given), DMatrix::zeros(rows, other));
        let (mut at, mut even) = (0, Vec::new());
        for (k, (x, (_, other))) in histories.iter().zip(trials).enumerate() {
            inputs.rows_mut(at, x.nrows()).copy_from(x);
            targets.rows_mut(at, x.nrows()).copy_from(&other.rows(other.nrows() - x.nrows(), x.nrows()));
            at += x.nrows();
            even.extend(vec![k % 2 == 0; x.nrows()]);
        }
        Self { inputs, targets, even }
    }

    fn half(&self, even: bool) -> (DMatrix<f64>, DMatrix<f64>) {
        let rows: Vec<usize> = (0..self.even.len()).filter(|&row| self.even[row] == even).collect();
        (self.inputs.select_rows(&rows), self.targets.select_rows(&rows))
    }

    /// The mean squared error of every column when each half of the training trials is predicted from the
    /// other. `fit` predicts from inputs and outputs the outputs of other inputs.
    fn errors(
        &self,
        fit: impl Fn(&DMatrix<f64>, &DMatrix<f64>, &DMatrix<f64>) -> Result<DMatrix<f64>, NumericsError>,
    ) -> Result<Vec<f64>, NumericsError> {
        let mut squares = vec![0.0; self.targets.ncols()];
        for even in [true, false] {
            let ((x, targets), (inputs, outputs)) = (self.half(even), self.half(!even));
            let errors = fit(&inputs, &outputs, &x)? - targets;
            for (sum, column) in squares.iter_mut().zip(errors.column_iter()) {
                *sum += column.norm_squared() / self.even.len() as f64;
            }
        }
        Ok(squares)
    }

    /// The setting with the least error of one half of the training trials predicted from the other, and these
    /// errors.
    fn chosen<S: Copy>(
        &self,
        settings: &[S],
        fit: impl Fn(S, &DMatrix<f64>, &DMatrix<f64>, &DMatrix<f64>) -> Result<DMatrix<f64>, NumericsError>,
    ) -> Result<(S, Vec<f64>), NumericsError> {
        let (mut best, mut least) = ((settings[0], Vec::new()), f64::INFINITY);
        for &setting in settings {
            let errors = self.errors(|inputs, outputs, x| fit(setting, inputs, outputs, x))?;
            let total = errors.iter().sum();
            if best.1.is_empty() || total < least {
                (best, least) = ((setting, errors), total);
            }
        }
        Ok(best)
    }
}

/// Regressions of a part on the others, with settings and variances from the training trials: chosen once for
/// all columns that are observed later.
pub struct Regressions {
    pairs: Pairs,
    /// The factor of the ridge, and the variances.
    ridge: (f64, Vec<f64>),
    /// Lengthscale squared and noise variance of the sparse Gaussian process, and the variances.
    process: ((f64, f64), Vec<f64>),
    /// The variances of the nearest neighbour.
    nearest: Vec<f64>,
}

impl Regressions {
    /// Learns from trials, each with the columns of the given parts and of the other part.
    pub fn new(trials: &[(DMatrix<f64>, DMatrix<f64>)]) -> Result<Self, NumericsError> {
        let pairs = Pairs::new(trials);
        let middle = middle_square(&pairs.inputs);
        let settings: Vec<(f64, f64)> =
            LENGTHSCALES.iter().flat_map(|l| NOISES.map(|noise| (l * l * middle, noise))).collect();
        let ridge = pairs.chosen(&RIDGES, ridge_regression)?;
        let process = pairs.chosen(&settings, sparse_regression)?;
        let nearest = pairs.errors(|inputs, outputs, x| Ok(outputs.select_rows(&nearest(x, inputs))))?;
        Ok(Self { pairs, ridge, process, nearest })
    }

    /// Predictions for the observed columns `y`: of ridge regression, of the sparse Gaussian process and of the
    /// nearest neighbour, which is the training frame with the nearest history. While frames are missing, it
    /// goes on along the training from the last match.
    pub fn predict(&self, y: &DMatrix<f64>) -> Result<[Prediction; 3], NumericsError> {
        let Pairs { inputs, targets, even } = &self.pairs;
        let x = histories(&filled(y));
        let ridge = ridge_regression(self.ridge.0, inputs, targets, &x)?;
        let process = sparse_regression(self.process.0, inputs, targets, &x)?;
        let mut places = nearest(&x, inputs);
        for k in 1..places.len() {
            if y[(k + HISTORY - 1, 0)].is_nan() {
                places[k] = (places[k - 1] + 1).min(even.len() - 1);
            }
        }
        Ok([
            (ridge, self.ridge.1.clone()),
            (process, self.process.1.clone()),
            (targets.select_rows(&places), self.nearest.clone()),
        ])
    }
}

/// The row of `inputs` that is nearest to each row of `x`.
fn nearest(x: &DMatrix<f64>, inputs: &DMatrix<f64>) -> Vec<usize> {
    squares(x, inputs).row_iter().map(|row| row.transpose().argmin().0).collect()
}

/// Ridge regression at inputs `x`, with the ridge as a factor of the mean variance of an input.
fn ridge_regression(
    ridge: f64,
    inputs: &DMatrix<f64>,
    targets: &DMatrix<f64>,
    x: &DMatrix<f64>,
) -> Result<DMatrix<f64>, NumericsError> {
    let mut square = inputs.tr_mul(inputs);
    let mean = square.trace() / inputs.len() as f64;
    for k in 0..square.nrows() {
        square[(k, k)] += ridge * mean;
    }
    Ok(x * Factor::new(&square, "ridge regression")?.solve(&inputs.tr_mul(targets)))
}

/// The mean of a sparse Gaussian process at inputs `x`, with the lengthscale squared and the noise variance
/// in units of the signal variance.
fn sparse_regression(
    (lambda, noise): (f64, f64),
    inputs: &DMatrix<f64>,
    targets: &DMatrix<f64>,
    x: &DMatrix<f64>,
) -> Result<DMatrix<f64>, NumericsError> {
    let (rows, count) = (inputs.nrows(), inputs.nrows().min(INDUCING));
    let points: Vec<usize> = (0..count).map(|k| k * rows / count).collect();
    let inducing = inputs.select_rows(&points);
    let kernel =
        |x: &DMatrix<f64>| squares(x, &inducing).map(|square| (-0.5 * square / lambda).exponential());
    let of_inputs = kernel(inputs);
    let precision = of_inputs.tr_mul(&of_inputs) + kernel(&inducing) * noise;
    let factor = Factor::new(&precision, "sparse Gaussian process regression")?;
    Ok(kernel(x) * factor.solve(&of_inputs.tr_mul(targets)))
}

/// Squared distances of all rows of `a` from all rows of `b`.
fn squares(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let norms = |x: &DMatrix<f64>| x.row_iter().map(|row| row.norm_squared()).collect::<Vec<f64>>();
    let (of_a, of_b) = (norms(a), norms(b));
    let both = a * b.transpose();
    DMatrix::from_fn(a.nrows(), b.nrows(), |i, j| (of_a[i] + of_b[j] - 2.0 * both[(i, j)]).max(0.0))
}

/// The median of the squared distances of every fifth row from the others; 1 if all rows are equal.
fn middle_square(x: &DMatrix<f64>) -> f64 {
    let rows: Vec<usize> = (0..x.nrows()).step_by(5).collect();
    let x = x.select_rows(&rows);
    let mut all: Vec<f64> = squares(&x, &x).iter().copied().filter(|square| *square > 0.0).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(1.0)
}

/// A prediction without covariances between columns as an answer. The first frames, without a history, take
/// the first prediction.
pub fn answer((mean, variance): Prediction, recorded: &DMatrix<f64>, changing: &[usize]) -> Answer {
    let rows = recorded.nrows();
    let mean = DMatrix::from_fn(rows, mean.ncols(), |t, c| mean[((t + 1).saturating_sub(HISTORY), c)]);
    let variance = DMatrix::from_fn(rows, mean.ncols(), |_, c| variance[c].max(LEAST_VARIANCE));
    let density = |t: usize| -> f64 {
        let number = |&c: &usize| {
            let (error, variance) = (recorded[(t, c)] - mean[(t, c)], variance[(t, c)]);
            -0.5 * (error * error / variance + (TAU * variance).logarithm())
        };
        changing.iter().map(number).sum()
    };
    let log_densities = (0..rows).map(density).collect();
    Answer { mean, variance, log_densities }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Two trials in which the other part is a linear function of the given one a frame ago.
    fn trials() -> Vec<(DMatrix<f64>, DMatrix<f64>)> {
        let trial = |phase: f64| {
            let given = DMatrix::from_fn(60, 2, |t, c| (0.3 * t as f64 + phase + c as f64).sin());
            let other = DMatrix::from_fn(60, 1, |t, _| if t == 0 { 0.0 } else { 2.0 * given[(t - 1, 0)] });
            (given, other)
        };
        (0..4).map(|k| trial(0.4 * k as f64)).collect()
    }

    /// Every rival finds the function, and its variance is about its error.
    #[test]
    fn rivals_predict_what_follows_from_the_history() {
        let trials = trials();
        let (test, training) = trials.split_last().unwrap();
        let predictions = Regressions::new(training).unwrap().predict(&test.0).unwrap();
        for (predicted, most) in predictions.into_iter().zip([1e-3, 1e-3, 0.2]) {
            let answer = answer(predicted, &test.1, &[0]);
            let error = (answer.mean.rows(HISTORY, 50) - test.1.rows(HISTORY, 50)).norm_squared() / 50.0;
            assert!(error < most, "{error}");
            assert!(answer.variance[(0, 0)] < 2.0 * most, "{}", answer.variance[(0, 0)]);
        }
    }

    /// With all training histories as inducing inputs it is the regression itself.
    #[test]
    fn the_sparse_regression_with_all_points_is_the_whole_one() {
        let trials = trials();
        let (test, training) = trials.split_last().unwrap();
        let few: Vec<_> =
            training.iter().map(|(x, y)| (x.rows(0, 20).into_owned(), y.rows(0, 20).into_owned())).collect();
        let pairs = Pairs::new(&few);
        assert!(pairs.inputs.nrows() <= INDUCING);
        let (lambda, noise, x) = (middle_square(&pairs.inputs), 1e-2, histories(&test.0));
        let kernel = |a: &DMatrix<f64>| squares(a, &pairs.inputs).map(|s| (-0.5 * s / lambda).exp());
        let n = pairs.inputs.nrows();
        let noisy = kernel(&pairs.inputs) + DMatrix::identity(n, n) * noise;
        let whole = kernel(&x) * noisy.cholesky().unwrap().solve(&pairs.targets);
        let sparse = sparse_regression((lambda, noise), &pairs.inputs, &pairs.targets, &x).unwrap();
        assert_relative_eq!(whole, sparse, epsilon = 1e-2);
    }

    #[test]
    fn the_last_observed_row_stays_in_place_of_missing_ones() {
        let y = DMatrix::from_column_slice(4, 1, &[1.0, f64::NAN, f64::NAN, 2.0]);
        assert_eq!(filled(&y).as_slice(), [1.0, 1.0, 1.0, 2.0]);
    }
}
