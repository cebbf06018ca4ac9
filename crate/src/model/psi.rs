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

use super::kernel::{Kernel, KernelAdjoint};
use super::lanes::{LANES, Lanes};
use block::{BLOCK, Block, PullBack};
use nalgebra::DMatrix;

/// Most numbers that the forward pass keeps of psi2's summands for the adjoint (32 MB); beyond, they are computed again.
const MOST_KEPT: usize = 4 << 20;

/// Independent Gaussians, one a row and dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct Gaussians {
    /// Means [rows x P].
    pub mean: DMatrix<f64>,
    /// Variances [rows x P].
    pub variance: DMatrix<f64>,
}

impl Gaussians {
    /// All zero: a place to add adjoints to.
    pub fn zeros(rows: usize, dims: usize) -> Self {
        Self { mean: DMatrix::zeros(rows, dims), variance: DMatrix::zeros(rows, dims) }
    }
}

/// The psi statistics of K inducing inputs.
#[derive(Clone, Debug)]
pub struct PsiStatistics {
    /// Sum over rows of psi0.
    pub psi0: f64,
    /// psi1 [rows x K].
    pub psi1: DMatrix<f64>,
    /// Sum over rows of psi2 [K x K], symmetric.
    pub psi2: DMatrix<f64>,
    /// psi2's summands, block after block and pair after pair, when an adjoint will ask for them; or nothing.
    kept: Vec<Lanes>,
}

/// Whether an adjoint will follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Only the values are wanted.
    Value,
    /// [`psi_adjoint`] will be called.
    Gradient,
}

/// dF with respect to the psi statistics.
pub struct PsiAdjoint<'a> {
    /// dF/dpsi0.
    pub psi0: f64,
    /// dF/dpsi1 [rows x K].
    pub psi1: &'a DMatrix<f64>,
    /// dF/dpsi2 [K x K], symmetric, every entry counted once.
    pub psi2: &'a DMatrix<f64>,
}

/// psi0, psi1 and psi2 of the inputs `x` [rows x P] at the inducing inputs `z` [K x P].
pub fn psi_statistics(x: &Gaussians, z: &DMatrix<f64>, kernel: &Kernel, purpose: Purpose) -> PsiStatistics {
    let (rows, ips) = (x.mean.nrows(), z.nrows());
    let pairs = ips * (ips + 1) / 2;
    let keep = purpose == Purpose::Gradient && (rows + LANES) * pairs <= MOST_KEPT;
    let blocks = if keep { rows.div_ceil(LANES) } else { BLOCK / LANES };
    let mut kept = vec![Lanes::ZERO; blocks * pairs];
    let mut psi1 = DMatrix::zeros(rows, ips);
    let mut psi2 = DMatrix::zeros(ips, ips);
    let spread = pair_spread(z, kernel);
    let mut block = Block::new(z);
    for start in (0..rows).step_by(BLOCK) {
        let len = BLOCK.min(rows - start);
        block.load(x, start, len, kernel, 1.0);
        for a in 0..ips {
            block.psi1(a, &mut psi1.as_mut_slice()[a * rows + start..][..len]);
        }
        block.load(x, start, len, kernel, 2.0);
        block.split_exponent();
        let first = if keep { start / LANES * pairs } else { 0 };
        let values = &mut kept[first..first + block.chunks() * pairs];
        block.psi2(&spread, values);
        let mut sums = values.chunks_exact(block.chunks());
        for a in 0..ips {
            for b in 0..=a {
                let values = sums.next().unwrap_or_default();
                psi2[(a, b)] += values.iter().fold(Lanes::ZERO, |sum, value| sum + *value).sum();
            }
        }
    }
    for a in 0..ips {
        for b in 0..a {
            psi2[(b, a)] = psi2[(a, b)];
        }
    }
    if !keep {
        kept.clear();
    }
    PsiStatistics { psi0: rows as f64 * kernel.variance, psi1, psi2, kept }
}

/// Turns the adjoint of [`psi_statistics`] into those of its arguments and adds them to `into_x` and `into_kernel`.
pub fn psi_adjoint(
    x: &Gaussians,
    z: &DMatrix<f64>,
    kernel: &Kernel,
    statistics: &PsiStatistics,
    adjoint: &PsiAdjoint,
    into_x: &mut Gaussians,
    into_kernel: &mut KernelAdjoint,
) {
    let (rows, pairs) = (x.mean.nrows(), z.nrows() * (z.nrows() + 1) / 2);
    into_kernel.variance += rows as f64 * adjoint.psi0;
    let mut block = Block::new(z);
    let mut pull = PullBack::new(z);
    let spread = pair_spread(z, kernel);
    let mut again = Vec::new();
    for start in (0..rows).step_by(BLOCK) {
        let len = BLOCK.min(rows - start);
        block.load(x, start, len, kernel, 1.0);
        pull.psi1(&block, &statistics.psi1, adjoint.psi1, start, len, into_kernel);
        pull.scatter(&block, start, len, into_x, into_kernel);
        block.load(x, start, len, kernel, 2.0);
        if statistics.kept.is_empty() {
            block.split_exponent();
            again.resize(block.chunks() * pairs, Lanes::ZERO);
            block.psi2(&spread, &mut again);
            pull.psi2(&block, adjoint.psi2, &again, into_kernel);
        } else {
            let first = start / LANES * pairs;
            let kept = &statistics.kept[first..first + block.chunks() * pairs];
            pull.psi2(&block, adjoint.psi2, kept, into_kernel);
        }
        pull.scatter(&block, start, len, into_x, into_kernel);
    }
    // The parts that do not depend on the row: psi1 and psi2 carry sigma^2 and sigma^4, and the pairs' own distance.
    let psi1_total = adjoint.psi1.dot(&statistics.psi1);
    let psi2_total = adjoint.psi2.dot(&statistics.psi2);
    into_kernel.variance += (psi1_total + 2.0 * psi2_total) / kernel.variance;
    for q in 0..z.ncols() {
        let lambda = kernel.lambda[q];
        into_kernel.lambda[q] += 0.5 * (psi1_total + psi2_total) / lambda;
        for a in 0..z.nrows() {
            for b in 0..a {
                let h = 2.0 * adjoint.psi2[(a, b)] * statistics.psi2[(a, b)];
                let d = (z[(a, q)] - z[(b, q)]) / lambda;
                into_kernel.lambda[q] += 0.25 * h * d * d;
                into_kernel.z[(a, q)] -= 0.5 * h * d;
                into_kernel.z[(b, q)] += 0.5 * h * d;
            }
        }
    }
}

/// - sum_q (z_aq - z_bq)^2 / (4 lambda_q) of every pair b <= a.
fn pair_spread(z: &DMatrix<f64>, kernel: &Kernel) -> Vec<f64> {
    let pairs = (0..z.nrows()).flat_map(|a| (0..=a).map(move |b| (a, b)));
    let spread = |(a, b)| (0..z.ncols()).map(|q| (z[(a, q)] - z[(b, q)]).powi(2) / kernel.lambda[q]).sum::<f64>();
    pairs.map(|pair| -0.25 * spread(pair)).collect()
}

#[cfg(test)]
mod tests;
