//! The sums over rows that q(u) needs, under any coupling; the covariance of experts.

use crate::gp::kernel::KernelAdjoint;
use nalgebra::DMatrix;

/// The sums over t that q(u) of one target part needs, under any coupling: psi2 blocks and psi1^T mu without
/// weights.
///
/// The dynamics of a target stack the sources in order.
#[derive(Clone, Debug, PartialEq)]
pub struct DynamicsSums {
    /// psi2^{jj} on the diagonal, psi1^{jT} psi1^k off it [sum K x sum K].
    pub psi2: DMatrix<f64>,
    /// psi1^{jT} mu_t [sum K x Q_i].
    pub psi1_mu: DMatrix<f64>,
}

/// Where blocks of these heights start when stacked; one entry more than there are blocks.
pub fn stack_offsets(sizes: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut offsets = vec![0];
    for size in sizes {
        offsets.push(offsets[offsets.len() - 1] + size);
    }
    offsets
}

impl DynamicsSums {
    /// Sums of no rows, for a stack of this `height` and Q_i = `latent` dimensions.
    pub fn zeros(height: usize, latent: usize) -> Self {
        Self { psi2: DMatrix::zeros(height, height), psi1_mu: DMatrix::zeros(height, latent) }
    }

    /// Psi2 and b of the stacked sources under the coupling weights w: blocks w_j w_k psi2^{jk} and w_j
    /// psi1^{jT} mu. `offsets` says where each source starts in the stack, and ends with its height.
    pub fn weighted(&self, weights: &[f64], offsets: &[usize]) -> (DMatrix<f64>, DMatrix<f64>) {
        let mut out = (self.psi2.clone(), self.psi1_mu.clone());
        self.weighted_into(weights, offsets, &mut out.0, &mut out.1);
        out
    }

    /// Writes [`weighted`](Self::weighted) into existing matrices.
    pub(super) fn weighted_into(
        &self,
        weights: &[f64],
        offsets: &[usize],
        psi2: &mut DMatrix<f64>,
        b: &mut DMatrix<f64>,
    ) {
        for (j, w_j) in weights.iter().enumerate() {
            let (at, size) = (offsets[j], offsets[j + 1] - offsets[j]);
            for (k, w_k) in weights.iter().enumerate() {
                let (place, shape) = ((at, offsets[k]), (size, offsets[k + 1] - offsets[k]));
                psi2.view_mut(place, shape)
                    .zip_apply(&self.psi2.view(place, shape), |out, v| *out = w_j * w_k * v);
            }
            b.rows_mut(at, size).zip_apply(&self.psi1_mu.rows(at, size), |out, v| *out = w_j * v);
        }
    }
}

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
