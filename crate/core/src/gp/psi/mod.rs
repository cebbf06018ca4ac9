//! The psi statistics: expectations of a kernel under Gaussian inputs, and their adjoints.
//!
//! For one row with mean m, variances s and inducing inputs z (Velychko et al. 2018, appendix B: A13, A16 and
//! A17 with a diagonal covariance; lambda and sigma^2 are those of the [`Kernel`](crate::gp::Kernel)):
//!
//! - psi0 = sigma^2
//! - psi1_a = sigma^2 prod_q (lambda_q / (lambda_q + s_q))^1/2 exp( -1/2 sum_q (m_q - z_aq)^2 / (lambda_q +
//!   s_q) )
//! - psi2_ab = sigma^4 prod_q (lambda_q / (lambda_q + 2 s_q))^1/2
//!   exp( - sum_q (z_aq - z_bq)^2 / (4 lambda_q) - sum_q (m_q - (z_aq + z_bq) / 2)^2 / (lambda_q + 2 s_q) )
//!
//! Only the sums over rows of psi0 and psi2 are needed, and psi2 is symmetric.
//!
//! ```
//! use nalgebra::{DMatrix, dvector};
//! use vcgpdm_core::gp::psi::{PairWorkspace, PsiStatistics, Purpose};
//! use vcgpdm_core::gp::{Gaussians, Kernel};
//!
//! let kernel = Kernel { lambda: dvector![1.0], variance: 1.0 };
//! let z = DMatrix::from_column_slice(2, 1, &[0.0, 1.0]);
//! // One certain input, and one uncertain input.
//! let x = Gaussians {
//!     mean: DMatrix::from_column_slice(2, 1, &[0.0, 0.0]),
//!     variance: DMatrix::from_column_slice(2, 1, &[0.0, 3.0]),
//! };
//! let mut psi = PsiStatistics::new(2, 2, 1);
//! psi.compute(&x, &z, &kernel, Purpose::Value, &mut PairWorkspace::default());
//! assert_eq!(psi.psi0, 2.0);
//! // For a certain input psi1 is the kernel itself; uncertainty flattens it.
//! assert!((psi.psi1[(0, 0)] - 1.0).abs() < 1e-12 && (psi.psi1[(1, 0)] - 0.5).abs() < 1e-12);
//! ```

mod block;
mod fold;
mod statistics;

pub use statistics::{PairWorkspace, PsiAdjoint, PsiStatistics, Purpose};

#[cfg(test)]
mod tests;
