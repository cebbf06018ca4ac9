//! The distance of latents from those of the training, and the density of paths.

use crate::elementary::Elementary;
use crate::gp::linalg::Factor;
use crate::gp::{Kernel, NumericsError};
use crate::models::rollout::request::RolloutError;
use crate::models::variational::maps::PoseMap;
use crate::models::variational::model::Vcgpdm;
use crate::models::variational::predictive::PredictiveDynamics;
use nalgebra::DMatrix;
use std::f64::consts::TAU;

impl Vcgpdm {
    /// For each part and each row of its latents [frames x Q_i], the share of the prior variance of its pose
    /// map that the inducing points explain, k(x, r) K_rr^-1 k(r, x) / sigma^2: near 1 close to the training,
    /// near 0 far away, where every prediction is the mean pose.
    ///
    /// # Errors
    ///
    /// When a covariance of inducing points cannot be factorised.
    pub fn familiarity(&self, latents: &[DMatrix<f64>]) -> Result<Vec<Vec<f64>>, NumericsError> {
        let parts = self.parts.iter().zip(latents);
        parts.map(|(map, x)| Ok(Familiarity::new(map, self.jitter)?.shares(x))).collect()
    }
}

/// The inducing points of the pose map of one part.
#[derive(Clone, Debug)]
pub(in crate::models) struct Familiarity {
    r: DMatrix<f64>,
    kernel: Kernel,
    factor: Factor,
}

impl Familiarity {
    /// # Errors
    ///
    /// When the covariance of the inducing points cannot be factorised.
    pub(in crate::models) fn new(map: &PoseMap, jitter: f64) -> Result<Self, NumericsError> {
        let (kernel, r) = (map.kernel().clone(), map.r().clone());
        let k = kernel.inducing_covariance(&r, jitter);
        Ok(Self { factor: Factor::new(&k, "covariance of the pose inducing points")?, r, kernel })
    }

    /// The explained share of the prior variance at latents `[Q_i]`.
    pub(in crate::models) fn share(&self, x: &[f64]) -> f64 {
        self.shares(&DMatrix::from_row_slice(1, x.len(), x)).first().copied().unwrap_or(0.0)
    }

    fn shares(&self, x: &DMatrix<f64>) -> Vec<f64> {
        // With K = L L^T the share is |L^-1 k(r, x)|^2 / sigma^2.
        let mut whitened = self.kernel.cross_covariance(&self.r, x);
        self.factor.solve_lower_mut(&mut whitened);
        whitened.column_iter().map(|column| column.norm_squared() / self.kernel.variance).collect()
    }
}

impl PredictiveDynamics {
    /// The mean of log p(x_t | the p frames before) over the frames of latent paths of all parts
    /// [frames x Q_i], in nats a frame: of each frame, the sum over the parts of the log density under the
    /// product of experts. `None` if no path has more than p frames.
    ///
    /// # Errors
    ///
    /// When a path has other dimensions than the model.
    pub fn mean_log_density(&self, paths: &[Vec<DMatrix<f64>>]) -> Result<Option<f64>, RolloutError> {
        let (mut sum, mut frames) = (0.0, 0_u32);
        for path in paths {
            for t in self.order..path.first().map_or(0, DMatrix::nrows) {
                for (x, prediction) in path.iter().zip(self.predict(path, t)?) {
                    let product = prediction.product;
                    let square = |(q, mean): (usize, &f64)| (x[(t, q)] - mean).powi(2);
                    let apart: f64 = product.mean.iter().enumerate().map(square).sum();
                    let dimensions = product.mean.len() as f64;
                    sum -= 0.5 * apart / product.variance;
                    sum -= 0.5 * dimensions * (TAU * product.variance).logarithm();
                }
                frames += 1;
            }
        }
        Ok((frames > 0).then(|| sum / f64::from(frames)))
    }
}

#[cfg(test)]
mod tests {
    use crate::models::variational::testing::fitted;
    use nalgebra::DMatrix;

    #[test]
    fn inducing_points_are_familiar_and_distant_latents_are_not() {
        let model = fitted(2);
        let at = |far: f64| -> Vec<DMatrix<f64>> {
            model.parts.iter().map(|part| part.r().add_scalar(far)).collect()
        };
        for shares in model.familiarity(&at(0.0)).unwrap() {
            assert!(shares.iter().all(|share| (share - 1.0).abs() < 1e-3), "{shares:?}");
        }
        for shares in model.familiarity(&at(1000.0)).unwrap() {
            assert!(shares.iter().all(|share| *share < 1e-6), "{shares:?}");
        }
        let near = model.familiarity(&at(0.3)).unwrap();
        assert!(near.iter().flatten().all(|share| (0.0..=1.0 + 1e-9).contains(share)), "{near:?}");
    }
}

#[cfg(test)]
mod path_density_tests {
    use crate::models::rollout::couplings::Reading;
    use crate::models::variational::testing::fitted;
    use approx::assert_relative_eq;
    use std::f64::consts::TAU;

    #[test]
    fn a_rollout_is_likeliest_under_its_own_couplings() {
        let model = fitted(1);
        let start = model.start(0, 0).unwrap();
        let learned = model.predictive_dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let path = |alpha| model.dynamics(alpha, Reading::AsLearned).unwrap().path(&start, 12).unwrap();
        let own = path(&model.alpha);
        let density = learned.mean_log_density(std::slice::from_ref(&own)).unwrap().unwrap();
        // Each frame of a mean rollout is the mean of its prediction: only the variances count.
        let mut expected = 0.0;
        for t in model.order..12 {
            for (x, prediction) in own.iter().zip(learned.predict(&own, t).unwrap()) {
                expected -= 0.5 * x.ncols() as f64 * (TAU * prediction.product.variance).ln() / 10.0;
            }
        }
        assert_relative_eq!(density, expected, epsilon = 1e-9);
        // One number that is off by 0.3 in the last of ten frames, as exact as its prediction.
        let mut off = own.clone();
        off[0][(11, 0)] += 0.3;
        let variance = learned.predict(&own, 11).unwrap()[0].product.variance;
        let lost = density - learned.mean_log_density(&[off]).unwrap().unwrap();
        assert_relative_eq!(lost, 0.5 * 0.09 / variance / 10.0, max_relative = 1e-9);
        let other = path(&model.alpha.map_with_location(|from, to, a| if from == to { a } else { 50.0 * a }));
        assert!(learned.mean_log_density(&[other]).unwrap().unwrap() < density);
        assert_eq!(learned.mean_log_density(&[start]).unwrap(), None);
    }
}
