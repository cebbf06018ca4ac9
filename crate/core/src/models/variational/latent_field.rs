//! How sure a model is at points of a latent space, and where its dynamics lead from there.

use crate::gp::NumericsError;
use crate::gp::linalg::Factor;
use crate::json::rows;
use crate::models::rollout::request::{RolloutError, RolloutRequest};
use crate::models::variational::maps::PoseMap;
use crate::models::variational::model::Vcgpdm;
use nalgebra::DMatrix;
use serde::Serialize;

/// What a model knows at points of the latent space of a part.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct LatentField {
    /// The share of the prior variance of the pose map that is left at each point `[N]`: near 0 where the
    /// pose is certain, 1 far from all pose inducing points.
    pub pose_variance: Vec<f64>,
    /// The share of the prior variance of the dynamics that is left at each point `[N]`.
    pub dynamics_variance: Vec<f64>,
    /// The mean next latents minus the point [N x Q].
    #[serde(serialize_with = "rows::serialize")]
    #[cfg_attr(feature = "types", ts(type = "number[][]"))]
    pub steps: DMatrix<f64>,
}

impl Vcgpdm {
    /// The field at `points` [N x Q_i] of the latent space of a part, under the couplings of a request.
    ///
    /// Dynamics of order p need a history. It is that of the nearest frame of `path` [frames x Q_i, each
    /// part], moved so that it ends at the point; the histories of the other parts are those of that frame.
    ///
    /// # Errors
    ///
    /// When the path or the points have other dimensions than the model, the path has less than p frames, the
    /// couplings do not fit the model, or a covariance cannot be factorised.
    pub fn latent_field(
        &self,
        part: usize,
        points: &DMatrix<f64>,
        path: &[DMatrix<f64>],
        request: &RolloutRequest,
    ) -> Result<LatentField, RolloutError> {
        let map = self.parts.get(part).ok_or(RolloutError::Part { count: self.part_count(), found: part })?;
        self.check_field(part, points, path)?;
        let dynamics = self.predictive_dynamics(request.alpha_or(&self.alpha), request.reading)?;
        let target = &dynamics.targets[part];
        let prior: f64 = target.weights.iter().map(|w| w * w).sum();
        let mut steps = DMatrix::zeros(points.nrows(), points.ncols());
        let mut dynamics_variance = Vec::with_capacity(points.nrows());
        for (n, point) in points.row_iter().enumerate() {
            let squared = |t: usize| (path[part].row(t) - point).norm_squared();
            let nearest = (self.order - 1..path[part].nrows())
                .min_by(|&a, &b| squared(a).total_cmp(&squared(b)))
                .unwrap_or(self.order - 1);
            let offset = point - path[part].row(nearest);
            let first = nearest + 1 - self.order;
            let histories: Vec<Vec<f64>> = path
                .iter()
                .enumerate()
                .map(|(j, x)| {
                    let rows = (first..=nearest).map(|t| x.row(t).into_owned());
                    let rows = rows.map(|row| if j == part { row + &offset } else { row });
                    rows.flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect()
                })
                .collect();
            let product = target.predict(&|j| &histories[j]).product;
            for (q, mean) in product.mean.iter().enumerate() {
                steps[(n, q)] = mean - point[q];
            }
            dynamics_variance.push((product.variance - target.noise) / prior);
        }
        Ok(LatentField {
            pose_variance: variance_shares(map, points, self.jitter)?,
            dynamics_variance,
            steps,
        })
    }

    /// The share of the prior variance of a part's pose map that is left at each of `points` [N x Q_i].
    ///
    /// # Errors
    ///
    /// When there is no such part, the points have other dimensions, or a covariance cannot be factorised.
    pub fn pose_variance(&self, part: usize, points: &DMatrix<f64>) -> Result<Vec<f64>, RolloutError> {
        let map = self.parts.get(part).ok_or(RolloutError::Part { count: self.part_count(), found: part })?;
        let (found_rows, found_columns) = points.shape();
        let columns = map.r().ncols();
        if found_columns != columns {
            return Err(RolloutError::Start { part, rows: found_rows, columns, found_rows, found_columns });
        }
        Ok(variance_shares(map, points, self.jitter)?)
    }

    fn check_field(
        &self,
        part: usize,
        points: &DMatrix<f64>,
        path: &[DMatrix<f64>],
    ) -> Result<(), RolloutError> {
        let latent = self.latent_dimensions();
        let shape = |part: usize, found_rows: usize, found_columns: usize| {
            let (rows, columns) = (self.order, latent[part]);
            RolloutError::Start { part, rows, columns, found_rows, found_columns }
        };
        for j in 0..latent.len() {
            let (rows, columns) = path.get(j).map_or((0, 0), |x| x.shape());
            if columns != latent[j] || rows < self.order || rows != path[part].nrows() {
                return Err(shape(j, rows, columns));
            }
        }
        match points.ncols() == latent[part] {
            true => Ok(()),
            false => Err(shape(part, points.nrows(), points.ncols())),
        }
    }
}

/// The variance of g(x) under the posterior of v, as a share of the prior variance [N]: with k = k(r, x),
/// (sigma^2 - k^T K^-1 k + k^T K^-1 S K^-1 k) / sigma^2.
fn variance_shares(map: &PoseMap, x: &DMatrix<f64>, jitter: f64) -> Result<Vec<f64>, NumericsError> {
    let (kernel, r) = (map.kernel(), map.r());
    let factor =
        Factor::new(&kernel.inducing_covariance(r, jitter), "covariance of the pose inducing points")?;
    let k = kernel.cross_covariance(r, x);
    let solved = factor.solve(&k);
    let spread = map.covariance() * &solved;
    let columns = k.column_iter().zip(solved.column_iter()).zip(spread.column_iter());
    Ok(columns
        .map(|((k, solved), spread)| {
            ((kernel.variance - k.dot(&solved) + solved.dot(&spread)) / kernel.variance).clamp(0.0, 1.0)
        })
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::variational::testing::fitted;
    use approx::assert_relative_eq;

    fn scene() -> (Vcgpdm, RolloutRequest, Vec<DMatrix<f64>>) {
        let model = fitted(3);
        let request = RolloutRequest { frames: 12, ..RolloutRequest::default() };
        let path = model.path(&request).unwrap();
        (model, request, path)
    }

    #[test]
    fn on_the_path_the_step_is_that_of_the_rollout() {
        let (model, request, path) = scene();
        let dynamics = model.predictive_dynamics(&model.alpha, request.reading).unwrap();
        for part in 0..model.part_count() {
            let field = model.latent_field(part, &path[part], &path, &request).unwrap();
            let (noise, weights) = (dynamics.targets[part].noise, &dynamics.targets[part].weights);
            let prior: f64 = weights.iter().map(|w| w * w).sum();
            for t in model.order - 1..11 {
                let taken = path[part].row(t + 1) - path[part].row(t);
                assert_relative_eq!(
                    field.steps.row(t).into_owned(),
                    taken,
                    epsilon = 1e-9,
                    max_relative = 1e-7
                );
                let predicted = &dynamics.predict(&path, t + 1).unwrap()[part].product;
                let variance = noise + prior * field.dynamics_variance[t];
                assert_relative_eq!(variance, predicted.variance, max_relative = 1e-9);
            }
        }
    }

    #[test]
    fn at_an_inducing_point_the_variance_is_that_of_its_output() {
        let (model, request, path) = scene();
        for (part, map) in model.parts.iter().enumerate() {
            let field = model.latent_field(part, map.r(), &path, &request).unwrap();
            assert_eq!(model.pose_variance(part, map.r()), Ok(field.pose_variance.clone()));
            for (share, variance) in field.pose_variance.iter().zip(map.covariance().diagonal().iter()) {
                assert_relative_eq!(*share, variance / map.kernel().variance, epsilon = 1e-4);
            }
        }
    }

    #[test]
    fn far_away_the_pose_is_unknown_and_only_the_other_parts_predict() {
        let (model, request, path) = scene();
        let near = model.latent_field(0, &path[0], &path, &request).unwrap();
        let far = model.latent_field(0, &path[0].add_scalar(1e3), &path, &request).unwrap();
        for (far, near) in far.dynamics_variance.iter().zip(&near.dynamics_variance) {
            assert!(far > near, "{far} compared with {near}");
        }
        for share in far.pose_variance {
            assert_relative_eq!(share, 1.0, epsilon = 1e-9);
        }
    }

    #[test]
    fn refuses_points_of_other_dimensions_and_parts_that_do_not_exist() {
        let (model, request, path) = scene();
        let wide = DMatrix::zeros(2, path[0].ncols() + 1);
        assert!(model.latent_field(0, &wide, &path, &request).is_err());
        assert!(model.latent_field(9, &path[0], &path, &request).is_err());
        assert!(model.latent_field(0, &path[0], &path[..1], &request).is_err());
        assert!(model.pose_variance(0, &wide).is_err() && model.pose_variance(9, &path[0]).is_err());
    }

    #[test]
    fn a_path_of_one_history_is_enough_and_a_shorter_one_is_not() {
        let (model, request, path) = scene();
        let field = |frames: usize| {
            let short: Vec<_> = path.iter().map(|x| x.rows(0, frames).into_owned()).collect();
            model.latent_field(0, &short[0], &short, &request)
        };
        let taken = path[0].row(model.order) - path[0].row(model.order - 1);
        let step = field(model.order).unwrap().steps.row(model.order - 1).into_owned();
        assert_relative_eq!(step, taken, epsilon = 1e-9, max_relative = 1e-7);
        assert!(field(model.order - 1).is_err());
    }
}
