//! The inducing points of a fitted model, and their weight for latents.

use crate::gp::Kernel;
use crate::models::variational::maps::{FittedExpert, PoseMap};
use crate::models::variational::model::Vcgpdm;
use nalgebra::DMatrix;
use thiserror::Error;

/// Why there is no such part, expert or inducing point.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum InducingError {
    /// There is no such part.
    #[error("expected a part from 0 to {}, found {found}", count.saturating_sub(1))]
    Part {
        /// Parts there are.
        count: usize,
        /// The one asked for, counted from 0.
        found: usize,
    },
    /// There is no such inducing point.
    #[error("expected an inducing point from 0 to {}, found {found}", count.saturating_sub(1))]
    Point {
        /// Inducing points there are.
        count: usize,
        /// The one asked for, counted from 0.
        found: usize,
    },
    /// The latents are not whole rows.
    #[error("expected rows of {columns} latents, found {found} numbers")]
    Latents {
        /// Latent dimensions Q.
        columns: usize,
        /// Numbers found.
        found: usize,
    },
}

impl Vcgpdm {
    /// The pose map of a part, counted from 0.
    ///
    /// # Errors
    ///
    /// When there is no such part.
    pub fn pose_map(&self, part: usize) -> Result<&PoseMap, InducingError> {
        self.parts.get(part).ok_or(InducingError::Part { count: self.part_count(), found: part })
    }

    /// The expert by which the part `source` predicts the part `target`, both counted from 0.
    ///
    /// # Errors
    ///
    /// When there is no such part.
    pub fn expert(&self, source: usize, target: usize) -> Result<&FittedExpert, InducingError> {
        let part = |found| InducingError::Part { count: self.part_count(), found };
        self.experts.get(source).ok_or_else(|| part(source))?.get(target).ok_or_else(|| part(target))
    }

    /// The weight of the pose inducing point `index` of a part for each latent point [frames x Q, row after
    /// row]: the kernel over its variance, k(x, r) / sigma^2, 0 to 1.
    ///
    /// # Errors
    ///
    /// When there is no such part or point, or the latents are not whole rows.
    pub fn pose_ip_weights(
        &self,
        part: usize,
        index: usize,
        latents: &[f64],
    ) -> Result<Vec<f64>, InducingError> {
        let map = self.pose_map(part)?;
        kernel_weights(map.kernel(), map.r(), index, latents, map.r().ncols(), 0)
    }

    /// The weight of the dynamics inducing point `index` of an expert for each frame of the source's latent
    /// path [frames x Q, row after row]: k(history, z), 0 to 1; 0 for the first frames, which have no
    /// history.
    ///
    /// # Errors
    ///
    /// When there is no such part or point, or the latents are not whole rows.
    pub fn dynamics_ip_weights(
        &self,
        source: usize,
        target: usize,
        index: usize,
        latents: &[f64],
    ) -> Result<Vec<f64>, InducingError> {
        let expert = self.expert(source, target)?;
        let columns = expert.z().ncols() / self.order;
        kernel_weights(expert.kernel(), expert.z(), index, latents, columns, self.order)
    }
}

/// k(window, z_index) / sigma^2 for the window of each row of `columns` latents: the row itself for a `lag`
/// of 0, otherwise the `lag` rows before it.
fn kernel_weights(
    kernel: &Kernel,
    z: &DMatrix<f64>,
    index: usize,
    latents: &[f64],
    columns: usize,
    lag: usize,
) -> Result<Vec<f64>, InducingError> {
    if index >= z.nrows() {
        return Err(InducingError::Point { count: z.nrows(), found: index });
    }
    if !latents.len().is_multiple_of(columns) {
        return Err(InducingError::Latents { columns, found: latents.len() });
    }
    let mut weights = vec![0.0; latents.len() / columns];
    let point = z.rows(index, 1).into_owned();
    for (t, weight) in weights.iter_mut().enumerate().skip(lag) {
        let window = &latents[(t - lag) * columns..][..z.ncols()];
        let window = DMatrix::from_row_slice(1, z.ncols(), window);
        *weight = kernel.cross_covariance(&window, &point)[(0, 0)] / kernel.variance;
    }
    Ok(weights)
}

crate::coded!(InducingError => Model);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::variational::testing::fitted;
    use approx::assert_relative_eq;

    #[test]
    fn a_point_has_weight_one_for_itself() {
        let model = fitted(1);
        let r = model.parts[0].r();
        let latents: Vec<f64> = r.row(1).iter().chain(r.row(0).iter()).copied().collect();
        let weights = model.pose_ip_weights(0, 1, &latents).unwrap();
        assert_relative_eq!(weights[0], 1.0, epsilon = 1e-12);
        assert!(weights[1] < 1.0);

        // A dynamics point has weight for the frame after its history.
        let z = model.experts[0][1].z();
        let history: Vec<f64> = z.row(2).iter().copied().collect();
        let columns = z.ncols() / model.order;
        let path: Vec<f64> = history.iter().copied().chain(vec![0.5; columns]).collect();
        let weights = model.dynamics_ip_weights(0, 1, 2, &path).unwrap();
        assert_eq!(weights.len(), model.order + 1);
        assert!(weights[..model.order].iter().all(|weight| *weight == 0.0));
        assert_relative_eq!(weights[model.order], 1.0, epsilon = 1e-12);
    }

    #[test]
    fn refuses_parts_and_points_that_do_not_exist() {
        let model = fitted(1);
        let words = |refused: Result<Vec<f64>, InducingError>| refused.unwrap_err().to_string();
        assert_eq!(words(model.pose_ip_weights(2, 0, &[])), "expected a part from 0 to 1, found 2");
        assert_eq!(words(model.dynamics_ip_weights(0, 5, 0, &[])), "expected a part from 0 to 1, found 5");
        let most = model.parts[0].r().nrows() - 1;
        assert_eq!(
            words(model.pose_ip_weights(0, most + 1, &[])),
            format!("expected an inducing point from 0 to {most}, found {}", most + 1)
        );
        let columns = model.parts[0].r().ncols();
        assert_eq!(
            words(model.pose_ip_weights(0, 0, &vec![0.0; columns + 1])),
            format!("expected rows of {columns} latents, found {} numbers", columns + 1)
        );
    }
}
