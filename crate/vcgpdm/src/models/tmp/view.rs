//! A trial as the inducing phases see it.

use crate::models::phase::{PhaseMap, Trial};
use crate::models::tmp::kernel::PhaseKernel;
use nalgebra::DMatrix;

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
        let phases: Vec<f64> = (0..trial.y.nrows()).map(|t| map.at(t)).collect();
        let features = kernel.features(&phases);
        let gram = features.tr_mul(&features);
        let left = (trial.y.nrows() as f64 - gram.trace()).max(0.0);
        Self { gram, projected: features.tr_mul(&trial.y), left, features }
    }
}
