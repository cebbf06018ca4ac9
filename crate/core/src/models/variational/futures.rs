//! Sampled rollouts: at every frame the next latents are drawn from the predictions of the experts.

use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::rollout::request::RolloutError;
use crate::models::variational::predictive::PredictiveDynamics;
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

impl PredictiveDynamics {
    /// A latent path of every part [frames x Q_i] that begins with the `start` of each part, p frames or more,
    /// and then draws x^i_t ~ N(mean, variance) of the product of experts, all parts advancing together. The
    /// functions are drawn anew at every frame. The same `seed` gives the same path.
    ///
    /// # Errors
    ///
    /// When the start latents are not p or more frames of Q_i numbers for each part.
    pub fn sample(
        &self,
        start: &[DMatrix<f64>],
        frames: usize,
        seed: u64,
    ) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut paths = LatentPaths::new(start, self.order, &self.latent)?;
        while paths.frames() < frames {
            let mut next = Vec::with_capacity(self.targets.len());
            for predictions in self.next(&paths) {
                let deviation = predictions.product.variance.sqrt();
                let mut x = predictions.product.mean;
                for x in &mut x {
                    let noise: f64 = StandardNormal.sample(&mut rng);
                    *x += deviation * noise;
                }
                next.push(x);
            }
            paths.append(&next);
        }
        Ok(paths.matrices(0..frames))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::Reading;
    use crate::models::variational::testing::fitted;

    #[test]
    fn a_seed_determines_the_future() {
        let model = fitted(1);
        let dynamics = model.predictive_dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let start = &model.start(0, 0).unwrap();
        let future = |seed| dynamics.sample(start, 20, seed).unwrap();
        assert_eq!(future(4), future(4));
        let (one, other) = (future(4), future(5));
        for part in 0..2 {
            assert_eq!(one[part].rows(0, 2), start[part]);
            assert!((&one[part] - &other[part]).rows(2, 18).iter().all(|d| *d != 0.0));
        }
    }
    #[test]
    fn a_step_adds_the_noise_of_the_seed_to_the_mean() {
        let model = fitted(1);
        let dynamics = model.predictive_dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let start = &model.start(0, 0).unwrap();
        let future = dynamics.sample(start, 3, 4).unwrap();
        let predictions = dynamics.next(&LatentPaths::new(start, dynamics.order, &dynamics.latent).unwrap());
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        for (path, predictions) in future.iter().zip(predictions) {
            for (x, mean) in path.row(2).iter().zip(&predictions.product.mean) {
                let noise: f64 = StandardNormal.sample(&mut rng);
                assert_eq!(*x, mean + predictions.product.variance.sqrt() * noise);
            }
        }
    }
}
