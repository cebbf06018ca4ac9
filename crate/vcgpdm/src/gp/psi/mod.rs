//! The psi statistics: expectations of a kernel under Gaussian inputs, and their adjoints. Knows no bound.
//!
//! For one row with mean m, variance s and inducing inputs z (MODEL.md's symbols; Velychko et al. 2018, appendix A):
//!
//! - psi0 = sigma^2
//! - psi1_a = sigma^2 prod_q (lambda_q / (lambda_q + s_q))^1/2 exp( -1/2 sum_q (m_q - z_aq)^2 / (lambda_q + s_q) )
//! - psi2_ab = sigma^4 prod_q (lambda_q / (lambda_q + 2 s_q))^1/2
//!   exp( - sum_q (z_aq - z_bq)^2 / (4 lambda_q) - sum_q (m_q - (z_aq + z_bq) / 2)^2 / (lambda_q + 2 s_q) )
//!
//! Only the sums over rows of psi0 and psi2 are needed, and psi2 is symmetric. How the sums are taken: [`block`].

mod block;
mod gaussians;
mod statistics;

pub use gaussians::Gaussians;
pub use statistics::{PairRoom, PsiAdjoint, PsiStatistics, Purpose};

#[cfg(test)]
mod tests;
