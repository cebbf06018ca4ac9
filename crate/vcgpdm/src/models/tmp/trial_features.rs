//! Features of a trial: its phases in terms of the inducing phases.

use crate::gp::linalg::Factor;
use crate::models::data::phase::{PhaseMap, Trial};
use crate::models::tmp::kernel::PhaseKernel;
use nalgebra::DMatrix;

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
