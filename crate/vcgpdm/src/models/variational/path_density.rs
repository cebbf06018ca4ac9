//! How likely a latent path is under the dynamics of a model.

use crate::elementary::Elementary;
use crate::models::rollout::request::RolloutError;
use crate::models::variational::predictive::PredictiveDynamics;
use nalgebra::DMatrix;
use std::f64::consts::TAU;

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
        let other = path(&model.alpha.map_with_location(|from, to, a| if from == to { a } else { 50.0 * a }));
        assert!(learned.mean_log_density(&[other]).unwrap().unwrap() < density);
        assert_eq!(learned.mean_log_density(&[start]).unwrap(), None);
    }
}
