//! The distance of latents from those of the training.

use crate::gp::NumericsError;
use crate::gp::linalg::Factor;
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
        parts.map(|(map, x)| explained(map, x, self.jitter)).collect()
    }
}

fn explained(map: &PoseMap, x: &DMatrix<f64>, jitter: f64) -> Result<Vec<f64>, NumericsError> {
    let (kernel, r) = (map.kernel(), map.r());
    let k = kernel.inducing_covariance(r, jitter);
    let factor = Factor::new(&k, "covariance of the pose inducing points")?;
    // With K = L L^T the share is |L^-1 k(r, x)|^2 / sigma^2.
    let mut whitened = kernel.cross_covariance(r, x);
    factor.solve_lower_mut(&mut whitened);
    Ok(whitened.column_iter().map(|column| column.norm_squared() / kernel.variance).collect())
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
