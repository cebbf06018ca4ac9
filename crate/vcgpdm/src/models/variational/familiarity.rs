//! The distance of latents from those of the training.

use crate::gp::linalg::Factor;
use crate::gp::{Kernel, NumericsError};
use crate::models::variational::maps::PoseMap;
use crate::models::variational::model::Vcgpdm;
use nalgebra::DMatrix;

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
