//! A trial as the inducing phases see it.

use crate::gp::linalg::Factor;
use crate::models::data::phase::{PhaseMap, Trial};
use crate::models::tmp::kernel::PhaseKernel;
use nalgebra::DMatrix;

fn phases(trial: &Trial, map: &PhaseMap) -> Vec<f64> {
    (0..trial.y.nrows()).map(|t| map.at(t)).collect()
}

/// What a trial looks like from the inducing phases.
#[derive(Clone, Debug)]
pub struct View {
    /// P [T x R].
    pub features: DMatrix<f64>,
    /// P^T P [R x R].
    pub gram: DMatrix<f64>,
    /// P^T Y [R x D].
    pub projected: DMatrix<f64>,
    /// sum_t (1 - p_t^T p_t): the variance that the inducing phases leave.
    pub left: f64,
}

impl View {
    /// Of a trial that lies at `map`.
    pub fn new(kernel: &PhaseKernel, trial: &Trial, map: &PhaseMap) -> Self {
        let features = kernel.features(&phases(trial, map));
        let gram = features.tr_mul(&features);
        let left = (trial.y.nrows() as f64 - gram.trace()).max(0.0);
        Self { gram, projected: features.tr_mul(&trial.y), left, features }
    }

    /// The same of a trial that is `whitened` already: its frames were `root` times white ones.
    pub fn whitened(kernel: &PhaseKernel, whitened: &Trial, root: &Factor, map: &PhaseMap) -> Self {
        let plain = kernel.features(&phases(whitened, map));
        let features = root.solve_lower(&plain);
        let inverse = root.inverse();
        let left = plain.row_iter().enumerate().map(|(t, p)| inverse[(t, t)] * (1.0 - p.norm_squared()));
        let left = left.sum::<f64>().max(0.0);
        Self { gram: features.tr_mul(&features), projected: features.tr_mul(&whitened.y), left, features }
    }
}
