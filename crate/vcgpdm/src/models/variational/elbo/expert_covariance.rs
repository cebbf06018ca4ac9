//! The inducing covariance of one expert and its adjoints, which all rows share.

use crate::gp::kernel::KernelAdjoint;
use nalgebra::DMatrix;

/// The inducing covariance of the expert of one primitive, with its adjoints.
pub struct ExpertCovariance {
    pub k: DMatrix<f64>,
    /// dF/dK [K x K].
    pub k_adjoint: DMatrix<f64>,
    /// dF with respect to the inducing inputs and the kernel.
    pub kernel_adjoint: KernelAdjoint,
}

impl ExpertCovariance {
    /// For K = `ips` inducing inputs of P = `dims` dimensions.
    pub fn new(ips: usize, dims: usize) -> Self {
        Self {
            k: DMatrix::zeros(ips, ips),
            k_adjoint: DMatrix::zeros(ips, ips),
            kernel_adjoint: KernelAdjoint::zeros(ips, dims),
        }
    }
}
