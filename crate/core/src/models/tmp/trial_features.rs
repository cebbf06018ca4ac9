//! Features of a trial: its phases in terms of the inducing phases; and principal components over phase.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::models::data::phase::{PhaseMap, Trial};
use crate::models::tmp::kernel::PhaseKernel;
use nalgebra::{DMatrix, DVector};

fn phases(trial: &Trial, map: &PhaseMap) -> Vec<f64> {
    (0..trial.y.nrows()).map(|t| map.at(t)).collect()
}

/// Features of a trial, and their products with each other and with the trial.
#[derive(Clone, Debug)]
pub struct TrialFeatures {
    /// P [T x R].
    pub features: DMatrix<f64>,
    /// P^T P [R x R].
    pub gram: DMatrix<f64>,
    /// P^T Y [R x D].
    pub projected: DMatrix<f64>,
    /// sum_t (1 - p_t^T p_t): the variance that the inducing phases do not explain.
    pub residual: f64,
}

impl TrialFeatures {
    /// The features of a trial at the phases of `map`.
    pub fn new(kernel: &PhaseKernel, trial: &Trial, map: &PhaseMap) -> Self {
        let features = kernel.features(&phases(trial, map));
        let gram = features.tr_mul(&features);
        let residual = (trial.y.nrows() as f64 - gram.trace()).max(0.0);
        Self { gram, projected: features.tr_mul(&trial.y), residual, features }
    }

    /// The features of a `whitened` trial: its frames were `root` times the whitened ones.
    pub fn whitened(kernel: &PhaseKernel, whitened: &Trial, root: &Factor, map: &PhaseMap) -> Self {
        let plain = kernel.features(&phases(whitened, map));
        let features = root.solve_lower(&plain);
        let inverse = root.inverse();
        let terms = plain.row_iter().enumerate().map(|(t, p)| inverse[(t, t)] * (1.0 - p.norm_squared()));
        let residual = terms.sum::<f64>().max(0.0);
        Self { gram: features.tr_mul(&features), projected: features.tr_mul(&whitened.y), residual, features }
    }
}

/// Sum over trials and columns of the outer products of fitted coefficients [R x R].
pub struct CoefficientSums(DMatrix<f64>);

impl CoefficientSums {
    /// An empty sum over `inducing` inducing phases.
    pub fn new(inducing: usize) -> Self {
        Self(DMatrix::zeros(inducing, inducing))
    }

    /// Adds the columns `y` [T x D] of a trial, each fitted by ridge regression on its features and divided
    /// by the root of its `variance` `[D]`.
    pub fn add(
        &mut self,
        trial: &TrialFeatures,
        y: &DMatrix<f64>,
        variance: &DVector<f64>,
    ) -> Result<(), NumericsError> {
        let r = trial.gram.nrows();
        let ridge = &trial.gram + DMatrix::identity(r, r);
        let mut fit = Factor::new(&ridge, "phases of a trial")?.solve(&trial.features.tr_mul(y));
        for (mut column, variance) in fit.column_iter_mut().zip(variance.iter()) {
            column /= variance.sqrt();
        }
        self.0 += &fit * fit.transpose();
        Ok(())
    }
}

/// v of the `count` functions of phase that explain most of the fitted columns [R x count].
pub fn leading(sums: &CoefficientSums, count: usize) -> DMatrix<f64> {
    let r = sums.0.nrows();
    let eigen = nalgebra::SymmetricEigen::new(symmetric(sums.0.clone()));
    let mut order: Vec<usize> = (0..r).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
    // v ~ N(0, I): a primitive of prior size has a norm of sqrt(R).
    DMatrix::from_fn(r, count, |i, q| {
        let axis = eigen.eigenvectors.column(order[q % r]);
        let sign = if axis[axis.iamax()] < 0.0 { -1.0 } else { 1.0 };
        sign * (r as f64).sqrt() * axis[i]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::data::phase::PhaseAxis;

    #[test]
    fn frames_far_from_all_inducing_phases_are_not_explained() {
        let kernel = PhaseKernel::new(PhaseAxis::Trial, 0.1, (0.0, 1.0)).unwrap();
        let trial = Trial { y: DMatrix::zeros(3, 1), whole: false };
        let identity = Factor::new(&DMatrix::identity(3, 3), "noise").unwrap();
        for (start, expected) in [(9.0, 3.0), (0.3, 0.0)] {
            let map = PhaseMap { start, rate: 0.1 };
            let plain = TrialFeatures::new(&kernel, &trial, &map).residual;
            let white = TrialFeatures::whitened(&kernel, &trial, &identity, &map).residual;
            assert!((plain - expected).abs() < 0.01 && (white - plain).abs() < 1e-9, "{plain} {white}");
        }
    }
}
