//! Room for what belongs to one expert, whichever rows it is seen through.

use crate::gp::kernel::KernelAdjoint;
use nalgebra::DMatrix;

/// What belongs to the expert of one primitive.
pub struct ExpertRoom {
    pub k: DMatrix<f64>,
    /// dF/dK [K x K].
    pub k_adjoint: DMatrix<f64>,
    /// With respect to its inducing inputs and kernel.
    pub kernel_adjoint: KernelAdjoint,
}

impl ExpertRoom {
    /// For K = `ips` inducing inputs of P = `dims` dimensions.
    pub fn new(ips: usize, dims: usize) -> Self {
        Self {
            k: DMatrix::zeros(ips, ips),
            k_adjoint: DMatrix::zeros(ips, ips),
            kernel_adjoint: KernelAdjoint::zeros(ips, dims),
        }
    }
}
