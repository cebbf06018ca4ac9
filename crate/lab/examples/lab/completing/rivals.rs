//! What the filter is compared with: regressions of a part on the last frames of another one.

use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// Frames of a history, the newest included.
pub const HISTORY: usize = 5;
/// Factors of the mean variance of an input on the diagonal of a ridge regression.
const RIDGES: [f64; 6] = [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0];
/// Lengthscales of a Gaussian process in units of the middle distance of two inputs, and noise variances in
/// units of the signal variance.
const LENGTHSCALES: [f64; 3] = [0.5, 1.0, 2.0];
const NOISES: [f64; 3] = [1e-3, 1e-2, 1e-1];

/// Means and variances of the columns of a part [frames x D], and the log density of each recorded frame.
pub struct Answer {
    pub mean: DMatrix<f64>,
    pub variance: DMatrix<f64>,
    pub log_densities: Vec<f64>,
}

/// The training trials as pairs of histories and frames.
pub struct Pairs {
    inputs: DMatrix<f64>,
    targets: DMatrix<f64>,
    /// Whether each pair is from a trial with an even number.
    even: Vec<bool>,
}

/// The histories of each frame that has one, newest last [frames - HISTORY + 1 x HISTORY D].
fn histories(y: &DMatrix<f64>) -> DMatrix<f64> {
    let (d, rows) = (y.ncols(), y.nrows() + 1 - HISTORY);
    DMatrix::from_fn(rows, HISTORY * d, |t, k| y[(t + k / d, k % d)])
}

/// The observed columns with the last observed row in place of each missing one.
fn held(y: &DMatrix<f64>) -> DMatrix<f64> {
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
    /// Pairs of trials, each with the columns of the given and of the other part.
    pub fn new(trials: &[(DMatrix<f64>, DMatrix<f64>)]) -> Self {
        let rows: usize = trials.iter().map(|(given, _)| given.nrows() + 1 - HISTORY).sum();
        let mut inputs = DMatrix::zeros(rows, HISTORY * trials[0].0.ncols());
        let mut targets = DMatrix::zeros(rows, trials[0].1.ncols());
        let (mut at, mut even) = (0, Vec::new());
        for (k, (given, other)) in trials.iter().enumerate() {
            let x = histories(given);
            inputs.rows_mut(at, x.nrows()).copy_from(&x);
            targets.rows_mut(at, x.nrows()).copy_from(&other.rows(HISTORY - 1, x.nrows()));
            at += x.nrows();
            even.extend(vec![k % 2 == 0; x.nrows()]);
        }
        Self { inputs, targets, even }
    }

    fn half(&self, even: bool) -> (DMatrix<f64>, DMatrix<f64>) {
        let rows: Vec<usize> = (0..self.even.len()).filter(|&row| self.even[row] == even).collect();
        (self.inputs.select_rows(&rows), self.targets.select_rows(&rows))
    }

    /// Predictions for the observed columns `y` by the best of these fits: the one with the least error when
    /// each half of the training trials is predicted from the other. The variances are those errors.
    fn best<S: Copy>(
        &self,
        settings: &[S],
        y: &DMatrix<f64>,
        fit: impl Fn(S, &DMatrix<f64>, &DMatrix<f64>, &DMatrix<f64>) -> DMatrix<f64>,
    ) -> (DMatrix<f64>, Vec<f64>) {
        let halves = [true, false].map(|even| (self.half(even), self.half(!even)));
        let errors = |&setting: &S| {
            let mut squares = vec![0.0; self.targets.ncols()];
            for ((x, targets), (inputs, outputs)) in &halves {
                let errors = fit(setting, inputs, outputs, x) - targets;
                for (sum, column) in squares.iter_mut().zip(errors.column_iter()) {
                    *sum += column.norm_squared() / self.even.len() as f64;
                }
            }
            squares
        };
        let all = settings.iter().map(|setting| (setting, errors(setting)));
        let total = |errors: &Vec<f64>| errors.iter().sum::<f64>();
        let (setting, variance) = all.min_by(|a, b| total(&a.1).total_cmp(&total(&b.1))).unwrap();
        (fit(*setting, &self.inputs, &self.targets, &histories(&held(y))), variance)
    }

    /// Ridge regression.
    pub fn ridge(&self, y: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
        self.best(&RIDGES, y, |ridge, inputs, targets, x| {
            let mut square = inputs.tr_mul(inputs);
            let mean = square.trace() / inputs.len() as f64;
            for k in 0..square.nrows() {
                square[(k, k)] += ridge * mean;
            }
            x * square.cholesky().unwrap().solve(&inputs.tr_mul(targets))
        })
    }

    /// Gaussian process regression with all training frames, which a sparse one approximates.
    pub fn gaussian_process(&self, y: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
        let middle = middle_square(&self.inputs);
        let settings: Vec<(f64, f64)> =
            LENGTHSCALES.iter().flat_map(|l| NOISES.map(|noise| (l * l * middle, noise))).collect();
        self.best(&settings, y, |(lambda, noise), inputs, targets, x| {
            let mut k = squares(inputs, inputs).map(|square| (-0.5 * square / lambda).exp());
            for n in 0..k.nrows() {
                k[(n, n)] += noise;
            }
            let weights = k.cholesky().unwrap().solve(targets);
            squares(x, inputs).map(|square| (-0.5 * square / lambda).exp()) * weights
        })
    }

    /// The frame of the training whose history is nearest. While frames are missing, the training goes on from
    /// the last match.
    pub fn nearest(&self, y: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
        let nearest = |x: &DMatrix<f64>, inputs: &DMatrix<f64>| -> Vec<usize> {
            squares(x, inputs).row_iter().map(|row| row.transpose().argmin().0).collect()
        };
        let mut variance = vec![0.0; self.targets.ncols()];
        for even in [true, false] {
            let ((x, targets), (inputs, outputs)) = (self.half(even), self.half(!even));
            let errors = outputs.select_rows(&nearest(&x, &inputs)) - targets;
            for (sum, column) in variance.iter_mut().zip(errors.column_iter()) {
                *sum += column.norm_squared() / self.even.len() as f64;
            }
        }
        let mut places = nearest(&histories(&held(y)), &self.inputs);
        for k in 1..places.len() {
            if y[(k + HISTORY - 1, 0)].is_nan() {
                places[k] = (places[k - 1] + 1).min(self.even.len() - 1);
            }
        }
        (self.targets.select_rows(&places), variance)
    }
}

/// Squared distances of all rows of `a` from all rows of `b`.
fn squares(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let norms = |x: &DMatrix<f64>| x.row_iter().map(|row| row.norm_squared()).collect::<Vec<f64>>();
    let (of_a, of_b) = (norms(a), norms(b));
    let both = a * b.transpose();
    DMatrix::from_fn(a.nrows(), b.nrows(), |i, j| (of_a[i] + of_b[j] - 2.0 * both[(i, j)]).max(0.0))
}

fn middle_square(x: &DMatrix<f64>) -> f64 {
    let rows: Vec<usize> = (0..x.nrows()).step_by(5).collect();
    let x = x.select_rows(&rows);
    let mut all: Vec<f64> = squares(&x, &x).iter().copied().filter(|square| *square > 0.0).collect();
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

/// A prediction without covariances between columns as an answer. The first frames, without a history, take
/// the first prediction.
pub fn answer(
    (mean, variance): (DMatrix<f64>, Vec<f64>),
    recorded: &DMatrix<f64>,
    changing: &[usize],
) -> Answer {
    let rows = recorded.nrows();
    let mean = DMatrix::from_fn(rows, mean.ncols(), |t, c| mean[((t + 1).saturating_sub(HISTORY), c)]);
    let variance = DMatrix::from_fn(rows, mean.ncols(), |_, c| variance[c].max(1e-12));
    let density = |t: usize| -> f64 {
        let number = |&c: &usize| {
            let (error, variance) = (recorded[(t, c)] - mean[(t, c)], variance[(t, c)]);
            -0.5 * (error * error / variance + (TAU * variance).ln())
        };
        changing.iter().map(number).sum()
    };
    let log_densities = (0..rows).map(density).collect();
    Answer { mean, variance, log_densities }
}
