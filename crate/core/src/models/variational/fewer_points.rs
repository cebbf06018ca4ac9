//! A fitted model with fewer inducing points. Latents and kernels stay as trained; the inducing outputs that
//! remain are inferred again from the same data.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, block_diagonal, symmetric};
use crate::models::rollout::couplings::coupling_weights;
use crate::models::variational::elbo::DynamicsSums;
use crate::models::variational::inducing::InducingError;
use crate::models::variational::maps::{FittedExpert, PoseMap};
use crate::models::variational::model::{ExternalEvidence, Vcgpdm};
use nalgebra::DMatrix;
use thiserror::Error;

/// The inducing points that a model keeps, by index. Each map keeps at least one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct KeptPoints {
    /// Pose inducing points of each part `[M]`.
    pub poses: Vec<Vec<usize>>,
    /// Dynamics inducing points of each expert, `dynamics[source][target]`.
    pub dynamics: Vec<Vec<Vec<usize>>>,
}

/// Why a model cannot keep these inducing points.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum KeptPointsError {
    /// There is no such part or point.
    #[error(transparent)]
    Inducing(#[from] InducingError),
    /// A map has no list, or keeps no point, or keeps a point twice.
    #[error("expected at least one inducing point for each map, each point once")]
    List,
    /// A covariance could not be factorised.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

/// The data of one process as its inducing outputs see them.
struct Evidence {
    /// Covariance K of the inducing outputs.
    k: DMatrix<f64>,
    /// A = K + Psi2 / n.
    a: DMatrix<f64>,
    /// b / n [K x C].
    b: DMatrix<f64>,
}

/// The optimal inducing outputs, and the part of the bound that depends on the inducing points.
struct Solved {
    mean: DMatrix<f64>,
    covariance: DMatrix<f64>,
    bound: f64,
}

impl Evidence {
    fn keep(&self, rows: &[usize]) -> Self {
        Self { k: square(&self.k, rows), a: square(&self.a, rows), b: self.b.select_rows(rows) }
    }

    fn solve(&self) -> Result<Solved, NumericsError> {
        let k = Factor::new(&self.k, "covariance of the inducing points")?;
        let a = Factor::new(&self.a, "covariance of the data at the inducing points")?;
        let coefficients = a.solve(&self.b);
        let columns = self.b.ncols() as f64;
        // tr(K^-1 Psi2) / n = tr(K^-1 A) - tr(I)
        let explained = k.solve(&self.a).trace() - self.k.nrows() as f64;
        let bound = 0.5 * columns * (k.log_determinant() - a.log_determinant() + explained)
            + 0.5 * self.b.dot(&coefficients);
        Ok(Solved { mean: &self.k * coefficients, covariance: symmetric(&self.k * a.solve(&self.k)), bound })
    }
}

fn square(matrix: &DMatrix<f64>, rows: &[usize]) -> DMatrix<f64> {
    matrix.select_rows(rows).select_columns(rows)
}

impl Vcgpdm {
    /// The model with these inducing points only. The posteriors of their outputs are the optimal ones for
    /// the data of the training, and the terms of the bound follow; latents, kernels, noise and couplings
    /// stay.
    ///
    /// # Errors
    ///
    /// When a map would have no point, there is no such point, or a covariance cannot be factorised.
    pub fn with_points(&self, kept: &KeptPoints) -> Result<Self, KeptPointsError> {
        self.check_points(kept)?;
        let mut model = self.clone();
        for (part, rows) in kept.poses.iter().enumerate() {
            model.keep_poses(part, rows)?;
        }
        for target in 0..self.part_count() {
            model.keep_dynamics(self, target, &kept.dynamics)?;
        }
        Ok(model)
    }

    fn check_points(&self, kept: &KeptPoints) -> Result<(), KeptPointsError> {
        let m = self.part_count();
        if kept.poses.len() != m || kept.dynamics.len() != m || kept.dynamics.iter().any(|row| row.len() != m)
        {
            return Err(KeptPointsError::List);
        }
        let poses = kept.poses.iter().zip(&self.parts).map(|(rows, map)| (rows, map.r().nrows()));
        let dynamics = kept.dynamics.iter().flatten().zip(self.experts.iter().flatten());
        for (rows, count) in poses.chain(dynamics.map(|(rows, expert)| (rows, expert.z().nrows()))) {
            if let Some(&found) = rows.iter().find(|row| **row >= count) {
                return Err(InducingError::Point { count, found }.into());
            }
            let mut once = rows.clone();
            once.sort_unstable();
            once.dedup();
            if once.is_empty() || once.len() < rows.len() {
                return Err(KeptPointsError::List);
            }
        }
        Ok(())
    }

    fn keep_poses(&mut self, part: usize, rows: &[usize]) -> Result<(), NumericsError> {
        let map = &self.parts[part];
        if rows.len() == map.r().nrows() {
            return Ok(());
        }
        let k = map.kernel().inducing_covariance(map.r(), self.jitter);
        // cov(v) = K A^-1 K and E[v] = K A^-1 b / n.
        let a = symmetric(
            &k * Factor::new(map.covariance(), "covariance of the pose inducing outputs")?.solve(&k),
        );
        let b = &a * map.coefficients(self.jitter)?;
        let all = Evidence { k, a, b };
        let kept = all.keep(rows).solve()?;
        self.terms.kinematics[part] += kept.bound - all.solve()?.bound;
        let (r, kernel) = (map.r().select_rows(rows), map.kernel().clone());
        let noise = map.column_noise().to_vec();
        self.parts[part] = PoseMap::new(r, kernel, map.beta(), kept.mean, kept.covariance, self.jitter)?
            .with_column_noise(noise);
        Ok(())
    }

    /// Keeps points of the experts about a target. `from` is the model with all points.
    fn keep_dynamics(
        &mut self,
        from: &Self,
        target: usize,
        kept: &[Vec<Vec<usize>>],
    ) -> Result<(), NumericsError> {
        let offsets = from.offsets(target);
        let rows: Vec<usize> = kept
            .iter()
            .zip(&offsets)
            .flat_map(|(row, offset)| row[target].iter().map(move |point| offset + point))
            .collect();
        if rows.len() == offsets[from.part_count()] {
            return Ok(());
        }
        let (noise, weights) = coupling_weights(from.alpha.column(target).as_slice());
        let (psi2, b) = from.sums[target].weighted(&weights, &offsets);
        let k = block_diagonal(from.experts.iter().map(|row| row[target].k()));
        let mut all = Evidence { a: &k + psi2 / noise, b: b / noise, k };
        if let Some(external) = from.external.get(target) {
            all.a += &external.precision;
            all.b += &external.b;
            self.external[target] = ExternalEvidence {
                precision: square(&external.precision, &rows),
                b: external.b.select_rows(&rows),
            };
        }
        let solved = all.keep(&rows).solve()?;
        self.terms.dynamics[target] += solved.bound - all.solve()?.bound;
        let sums = &from.sums[target];
        self.sums[target] =
            DynamicsSums { psi2: square(&sums.psi2, &rows), psi1_mu: sums.psi1_mu.select_rows(&rows) };
        let mut at = 0;
        for (source, row) in kept.iter().enumerate() {
            let (expert, points) = (&from.experts[source][target], &row[target]);
            let (z, kernel) = (expert.z().select_rows(points), expert.kernel().clone());
            let mean = solved.mean.rows(at, points.len()).into_owned();
            self.experts[source][target] = FittedExpert::new(z, kernel, mean, self.jitter)?;
            at += points.len();
        }
        self.dynamics_covariance[target] = solved.covariance;
        Ok(())
    }
}

crate::coded!(KeptPointsError { Self::Numerics(_) => Numerics, _ => Model });

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::variational::testing::{fitted, random_case};
    use approx::assert_relative_eq;

    fn all_points(model: &Vcgpdm) -> KeptPoints {
        let points = |count: usize| (0..count).collect::<Vec<_>>();
        KeptPoints {
            poses: model.parts.iter().map(|map| points(map.r().nrows())).collect(),
            dynamics: model
                .experts
                .iter()
                .map(|row| row.iter().map(|expert| points(expert.z().nrows())).collect())
                .collect(),
        }
    }

    #[test]
    fn with_fewer_points_it_is_the_fit_with_these_points() {
        let (mut params, objective) = random_case(1);
        let model = fitted(1);
        let mut kept = all_points(&model);
        kept.poses[0] = vec![3, 0, 1];
        kept.dynamics[1][0] = vec![0, 2, 4];
        let fewer = model.with_points(&kept).unwrap();

        params.parts[0].r = params.parts[0].r.select_rows(&kept.poses[0]);
        params.experts[1][0].z = params.experts[1][0].z.select_rows(&kept.dynamics[1][0]);
        let terms = objective.terms(&params).unwrap();
        let refitted = Vcgpdm::at_optimum(&objective, &params, terms).unwrap();
        let close = |a: &DMatrix<f64>, b: &DMatrix<f64>| {
            assert_relative_eq!(a, b, epsilon = 1e-8, max_relative = 1e-7);
        };
        close(fewer.parts[0].mean(), refitted.parts[0].mean());
        close(fewer.parts[0].covariance(), refitted.parts[0].covariance());
        for (a, b) in fewer.experts.iter().flatten().zip(refitted.experts.iter().flatten()) {
            close(a.mean(), b.mean());
        }
        for (a, b) in fewer.dynamics_covariance.iter().zip(&refitted.dynamics_covariance) {
            close(a, b);
        }
        for (a, b) in fewer.sums.iter().zip(&refitted.sums) {
            close(&a.psi2, &b.psi2);
            close(&a.psi1_mu, &b.psi1_mu);
        }
        assert_relative_eq!(fewer.bound(), refitted.bound(), epsilon = 1e-6, max_relative = 1e-9);
        assert!(fewer.bound() < model.bound());

        // It is the same when the rows are external evidence.
        let mut outside = model.clone();
        for (target, sums) in outside.sums.iter_mut().enumerate() {
            let (noise, weights) = coupling_weights(model.alpha.column(target).as_slice());
            let (precision, b) = sums.weighted(&weights, &model.offsets(target));
            outside.external.push(ExternalEvidence { precision: precision / noise, b: b / noise });
            *sums = DynamicsSums::zeros(sums.psi2.nrows(), sums.psi1_mu.ncols());
        }
        let again = outside.with_points(&kept).unwrap();
        for (a, b) in again.experts.iter().flatten().zip(fewer.experts.iter().flatten()) {
            close(a.mean(), b.mean());
        }
    }

    #[test]
    fn with_all_points_it_is_the_same_model() {
        let model = fitted(3);
        assert_eq!(model.with_points(&all_points(&model)).unwrap(), model);
    }

    #[test]
    fn refuses_points_that_do_not_exist_and_maps_without_points() {
        let model = fitted(1);
        let refused = |change: &dyn Fn(&mut KeptPoints)| {
            let mut kept = all_points(&model);
            change(&mut kept);
            model.with_points(&kept).unwrap_err().to_string()
        };
        let most = model.parts[0].r().nrows() - 1;
        let point = format!("expected an inducing point from 0 to {most}, found 99");
        assert_eq!(refused(&|kept| kept.poses[0][0] = 99), point);
        let list = "expected at least one inducing point for each map, each point once";
        assert_eq!(refused(&|kept| kept.poses[1].clear()), list);
        assert_eq!(refused(&|kept| kept.dynamics[0][1] = vec![2, 2]), list);
        assert_eq!(refused(&|kept| kept.dynamics.truncate(1)), list);
    }
}
