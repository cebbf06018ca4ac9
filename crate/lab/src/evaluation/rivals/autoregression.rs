//! A vector autoregression on principal components: a linear Gaussian state space model whose state is the
//! components of the last p frames (Luetkepohl 2005, chapters 2 and 3; with p = 1 the linear dynamical system of
//! Doretto et al. 2003).
//!
//! - y_t = m + V x_t + noise: V [D x C] has the first C eigenvectors of the covariance of all training frames,
//!   and the noise of each column is what they leave of its variance.
//! - x_t = c + sum_k A_k x_{t-k} + e_t with e_t ~ N(0, Q), by least squares over all training frames with p
//!   frames before them in their sequence, with a small ridge.
//!
//! A rollout begins with the components of the given frames and continues with the means. The covariance of
//! x_t, x_{t-1}, ... grows from frame to frame by `F S F' + Q`, F being the companion matrix of the A_k.

use crate::evaluation::predictor::{Forecast, Predictor};
use crate::evaluation::rivals::sequences::{Trials, check};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use vcgpdm_core::gp::linalg::Factor;
use vcgpdm_core::models::{Movements, RolloutError, TrainingError};

/// The ridge, relative to the mean of the diagonal of the regression's Gram matrix.
const RIDGE: f64 = 1e-8;
/// The smallest noise variance of a column, relative to the mean variance of all columns.
const LEAST_NOISE: f64 = 1e-6;

/// The autoregression of one movement.
pub(super) struct Autoregression {
    /// The mean m of the columns.
    mean: DVector<f64>,
    /// Principal directions V [D x C].
    directions: DMatrix<f64>,
    /// Noise variance of each column.
    noise: Vec<f64>,
    /// The A_k side by side, then c [C x (p C + 1)].
    coefficients: DMatrix<f64>,
    /// The covariance Q of the innovations [C x C].
    innovation: DMatrix<f64>,
    order: usize,
    /// Components of the given first frames of each sequence, one frame a column [C x k].
    starts: Vec<DMatrix<f64>>,
}

impl Autoregression {
    /// # Errors
    /// There are fewer columns than components, a sequence has fewer frames than the order, no sequence is a
    /// whole trial, or the regression fails.
    pub fn fit(movements: &Movements, components: usize, order: usize) -> Result<Self, TrainingError> {
        let given = Trials::new(movements, order)?;
        let highest = given.trials[0].y.ncols();
        if components > highest {
            let name = "the number of principal components";
            return Err(TrainingError::Setting { name, lowest: 1, highest, found: components });
        }
        let all = movements.as_one_part().y.swap_remove(0);
        let frames = all.nrows() as f64;
        let mean = all.row_mean().transpose();
        let centred = DMatrix::from_fn(all.nrows(), all.ncols(), |t, d| all[(t, d)] - mean[d]);
        let covariance = centred.tr_mul(&centred) / frames;
        let directions = principal(&covariance, components);
        let least = (LEAST_NOISE * covariance.trace() / highest as f64).max(f64::MIN_POSITIVE.sqrt());
        let left = &centred - &centred * &directions * directions.transpose();
        let noise = left.column_iter().map(|column| (column.norm_squared() / frames).max(least)).collect();

        let project = |y: &DMatrix<f64>| {
            directions.tr_mul(&DMatrix::from_fn(y.ncols(), y.nrows(), |d, t| y[(t, d)] - mean[d]))
        };
        let paths: Vec<DMatrix<f64>> = given.trials.iter().map(|trial| project(&trial.y)).collect();
        let width = order * components + 1;
        let (mut gram, mut cross) = (DMatrix::zeros(width, width), DMatrix::zeros(width, components));
        let mut pairs: Vec<(DVector<f64>, DVector<f64>)> = Vec::new();
        for path in &paths {
            for t in order..path.ncols() {
                pairs.push((history(path, t, order), path.column(t).into_owned()));
            }
        }
        for (before, now) in &pairs {
            gram += before * before.transpose();
            cross += before * now.transpose();
        }
        let ridge = RIDGE * gram.trace() / width as f64 + f64::MIN_POSITIVE.sqrt();
        (0..width).for_each(|k| gram[(k, k)] += ridge);
        let factor = Factor::new(&gram, "regression of a frame on the frames before it")?;
        let coefficients = factor.solve(&cross).transpose();
        let mut innovation = DMatrix::zeros(components, components);
        for (before, now) in &pairs {
            let apart = now - &coefficients * before;
            innovation += &apart * apart.transpose();
        }
        innovation /= pairs.len().saturating_sub(width).max(1) as f64;
        let starts = given.starts().iter().map(project).collect();
        Ok(Self { mean, directions, noise, coefficients, innovation, order, starts })
    }

    /// The components of each frame [C x frames], the given frames first.
    fn path(&self, sequence: usize, frames: usize) -> Result<DMatrix<f64>, RolloutError> {
        check(self.starts.len(), sequence, frames)?;
        let start = &self.starts[sequence];
        let mut path = DMatrix::zeros(start.nrows(), frames.max(start.ncols()));
        path.columns_mut(0, start.ncols()).copy_from(start);
        for t in start.ncols()..frames {
            let next = &self.coefficients * history(&path, t, self.order);
            path.set_column(t, &next);
        }
        Ok(path.columns(0, frames).into_owned())
    }

    /// All columns [frames x D] at these components.
    fn columns(&self, path: &DMatrix<f64>) -> DMatrix<f64> {
        let mut y = path.tr_mul(&self.directions.transpose());
        for mut row in y.row_iter_mut() {
            row += self.mean.transpose();
        }
        y
    }
}

impl Predictor for Autoregression {
    fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        Ok(vec![self.columns(&self.path(sequence, frames)?)])
    }

    fn forecast(&self, sequence: usize, frames: usize) -> Result<Option<Forecast>, RolloutError> {
        let path = self.path(sequence, frames)?;
        let (c, height) = (path.nrows(), self.order * path.nrows());
        let mut companion = DMatrix::zeros(height, height);
        companion.rows_mut(0, c).copy_from(&self.coefficients.columns(0, height));
        companion.view_mut((c, 0), (height - c, height - c)).fill_with_identity();
        let mut covariance = DMatrix::zeros(height, height);
        let mut variances = DMatrix::zeros(frames, self.noise.len());
        for t in 0..frames {
            if t >= self.starts[sequence].ncols() {
                covariance = &companion * covariance * companion.transpose();
                let mut now = covariance.view_mut((0, 0), (c, c));
                now += &self.innovation;
            }
            let spread = &self.directions * covariance.view((0, 0), (c, c));
            for (d, noise) in self.noise.iter().enumerate() {
                variances[(t, d)] = spread.row(d).dot(&self.directions.row(d)).max(0.0) + noise;
            }
        }
        Ok(Some(Forecast { means: vec![self.columns(&path)], variances: vec![variances] }))
    }

    /// All numbers of the model, and p frames of components.
    fn stored_numbers(&self) -> usize {
        let (d, c) = self.directions.shape();
        d + d * c + self.noise.len() + self.coefficients.len() + c * (c + 1) / 2 + self.order * c
    }
}

/// The eigenvectors of the `count` largest eigenvalues [D x count].
fn principal(covariance: &DMatrix<f64>, count: usize) -> DMatrix<f64> {
    let eigen = SymmetricEigen::new(covariance.clone());
    let mut order: Vec<usize> = (0..eigen.eigenvalues.len()).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
    eigen.eigenvectors.select_columns(&order[..count])
}

/// The components of the `order` frames before frame `t`, the last one first, and a 1 [p C + 1].
fn history(path: &DMatrix<f64>, t: usize, order: usize) -> DVector<f64> {
    let before = (1..=order).flat_map(|k| path.column(t - k).iter().copied().collect::<Vec<_>>());
    DVector::from_iterator(order * path.nrows() + 1, before.chain([1.0]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::rivals::testing::{movements, noise};
    use approx::assert_relative_eq;

    /// A rotation that loses 2 % a frame, around a place that is not 0.
    fn spiral(frames: usize, seed: u64, deviation: f64) -> DMatrix<f64> {
        let (sine, cosine) = 0.3_f64.sin_cos();
        let driven = noise(frames, 2, seed) * deviation;
        let mut y = DMatrix::zeros(frames, 2);
        let (mut a, mut b) = (1.0, 0.2 * seed as f64);
        for t in 0..frames {
            y[(t, 0)] = a + 3.0;
            y[(t, 1)] = b - 1.0;
            (a, b) = (
                0.98 * (cosine * a - sine * b) + driven[(t, 0)],
                0.98 * (sine * a + cosine * b) + driven[(t, 1)],
            );
        }
        y
    }

    #[test]
    fn recovers_a_known_process() {
        let trials: Vec<_> = (0..20).map(|seed| (spiral(400, seed, 0.1), true)).collect();
        let model = Autoregression::fit(&movements(&trials), 2, 1).unwrap();
        let v = &model.directions;
        let a = v * model.coefficients.columns(0, 2) * v.transpose();
        let (sine, cosine) = 0.3_f64.sin_cos();
        let truth = DMatrix::from_row_slice(2, 2, &[cosine, -sine, sine, cosine]) * 0.98;
        assert!((&a - &truth).amax() < 0.01, "{a}");
        let q = v * &model.innovation * v.transpose();
        assert!((&q - DMatrix::identity(2, 2) * 0.01).amax() < 5e-4, "{q}");
        // Far ahead, the forecast is the stationary distribution: variance q / (1 - 0.98^2) around the place.
        let far = model.forecast(0, 700).unwrap().unwrap();
        let stationary = 0.01 / (1.0 - 0.98 * 0.98);
        assert!((far.means[0][(699, 0)] - 3.0).abs() < 0.1 && (far.means[0][(699, 1)] + 1.0).abs() < 0.1);
        for d in 0..2 {
            assert_relative_eq!(far.variances[0][(699, d)], stationary, max_relative = 0.1);
        }
    }

    #[test]
    fn few_frames_do_not_make_the_noise_smaller() {
        let noise = |seed| {
            let trials = [(spiral(12, seed, 0.1), true)];
            Autoregression::fit(&movements(&trials), 2, 1).unwrap().innovation.trace() / 2.0
        };
        let mean = (0..200).map(noise).sum::<f64>() / 200.0;
        assert!((mean / 0.01 - 1.0).abs() < 0.1, "{mean}");
    }

    /// A circle needs two frames of history if only one of its columns is seen.
    #[test]
    fn two_frames_of_history_continue_a_sine() {
        let sine =
            |frames: usize, start: f64| DMatrix::from_fn(frames, 1, |t, _| (0.2 * t as f64 + start).sin());
        let trials = [(sine(100, 0.0), true), (sine(80, 1.0), true), (sine(5, 2.0), false)];
        let error = |order: usize| {
            let model = Autoregression::fit(&movements(&trials), 1, order).unwrap();
            let made = model.rollout(2, 90).unwrap().swap_remove(0);
            (&made - sine(90, 2.0)).norm_squared() / made.nrows() as f64
        };
        assert!(error(2) < 1e-6 && error(1) > 0.1, "{} {}", error(2), error(1));
    }

    #[test]
    fn refuses_what_the_data_do_not_allow() {
        let trials = [(spiral(40, 0, 0.0), true), (spiral(2, 1, 0.0), false)];
        let says = |components, order| {
            Autoregression::fit(&movements(&trials), components, order).err().unwrap().to_string()
        };
        assert_eq!(says(3, 1), "the number of principal components must be from 1 to 2, found 3");
        assert!(says(1, 3).starts_with("sequence 1"), "{}", says(1, 3));
    }
}
