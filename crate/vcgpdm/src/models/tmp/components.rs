//! Principal components over phase: the functions of phase that explain most of the columns.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use crate::models::tmp::trial_features::TrialFeatures;
use nalgebra::{DMatrix, DVector};

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
