//! The psi statistics: expectations of a kernel under Gaussian inputs, and their adjoints. Knows no bound.
//!
//! For one row with mean m, variance s and inducing inputs z (MODEL.md's symbols; Velychko et al. 2018, appendix A):
//!
//! - psi0 = sigma^2
//! - psi1_a = sigma^2 prod_q (lambda_q / (lambda_q + s_q))^1/2 exp( -1/2 sum_q (m_q - z_aq)^2 / (lambda_q + s_q) )
//! - psi2_ab = sigma^4 prod_q (lambda_q / (lambda_q + 2 s_q))^1/2
//!   exp( - sum_q (z_aq - z_bq)^2 / (4 lambda_q) - sum_q (m_q - (z_aq + z_bq) / 2)^2 / (lambda_q + 2 s_q) )
//!
//! Only the sums over rows of psi0 and psi2 are needed, and psi2 is symmetric. Rows are taken in blocks that stay in the
//! first-level cache; within a block every loop runs over rows, so that it compiles to vector instructions. The exponent
//! of psi2 splits into one term for each of a and b and a product sum_q z_aq z_bq / (lambda_q + 2 s_q). The adjoint computes
//! the exponentials again rather than store rows x K^2 of them, so memory is linear in rows.

use super::exp::exp;
use super::kernel::{Kernel, KernelAdjoint};
use nalgebra::DMatrix;

/// Rows a block; a multiple of [`LANES`].
const BLOCK: usize = 64;
/// Partial sums a reduction keeps side by side: strict addition order would forbid vector instructions.
const LANES: usize = 8;

type Row = [f64; BLOCK];

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
pub fn psi_statistics(x: &Gaussians, z: &DMatrix<f64>, kernel: &Kernel) -> PsiStatistics {
    let (rows, ips) = (x.mean.nrows(), z.nrows());
    let mut psi1 = DMatrix::zeros(rows, ips);
    let mut psi2 = DMatrix::zeros(ips, ips);
    let spread = pair_spread(z, kernel);
    let mut block = Block::new(z);
    let mut e: Row = [0.0; BLOCK];
    for start in (0..rows).step_by(BLOCK) {
        let len = BLOCK.min(rows - start);
        block.load(x, start, len, kernel, 1.0);
        for a in 0..ips {
            block.psi1(a, &mut e);
            psi1.as_mut_slice()[a * rows + start..][..len].copy_from_slice(&e[..len]);
        }
        block.load(x, start, len, kernel, 2.0);
        block.split_exponent();
        for a in 0..ips {
            for b in 0..=a {
                block.psi2(a, b, spread[(a, b)], &mut e);
                psi2[(a, b)] += sum(&e);
            }
        }
    }
    for a in 0..ips {
        for b in 0..a {
            psi2[(b, a)] = psi2[(a, b)];
        }
    }
    PsiStatistics { psi0: rows as f64 * kernel.variance, psi1, psi2 }
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
    let rows = x.mean.nrows();
    into_kernel.variance += rows as f64 * adjoint.psi0;
    let mut block = Block::new(z);
    let mut pull = PullBack::new(z);
    let spread = pair_spread(z, kernel);
    for start in (0..rows).step_by(BLOCK) {
        let len = BLOCK.min(rows - start);
        block.load(x, start, len, kernel, 1.0);
        pull.psi1(&block, &statistics.psi1, adjoint.psi1, start, len);
        pull.scatter(&block, start, len, kernel, 0.5, into_x, into_kernel);
        block.load(x, start, len, kernel, 2.0);
        block.split_exponent();
        pull.psi2(&block, &spread, adjoint.psi2, into_kernel);
        pull.scatter(&block, start, len, kernel, 1.0, into_x, into_kernel);
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

/// - sum_q (z_aq - z_bq)^2 / (4 lambda_q) [K x K].
fn pair_spread(z: &DMatrix<f64>, kernel: &Kernel) -> DMatrix<f64> {
    DMatrix::from_fn(z.nrows(), z.nrows(), |a, b| {
        -0.25 * (0..z.ncols()).map(|q| (z[(a, q)] - z[(b, q)]).powi(2) / kernel.lambda[q]).sum::<f64>()
    })
}

/// Rows `start` to `start + len` of one column.
fn column(matrix: &DMatrix<f64>, column: usize, start: usize, len: usize) -> &[f64] {
    &matrix.as_slice()[column * matrix.nrows() + start..][..len]
}

fn sum(values: &Row) -> f64 {
    let mut lanes = [0.0; LANES];
    for part in values.chunks_exact(LANES) {
        for l in 0..LANES {
            lanes[l] += part[l];
        }
    }
    lanes.iter().sum()
}

fn dot(x: &Row, y: &Row) -> f64 {
    let mut lanes = [0.0; LANES];
    for (x, y) in x.chunks_exact(LANES).zip(y.chunks_exact(LANES)) {
        for l in 0..LANES {
            lanes[l] += x[l] * y[l];
        }
    }
    lanes.iter().sum()
}

/// y += factor x.
#[inline(always)]
fn add_scaled(y: &mut Row, factor: f64, x: &Row) {
    for t in 0..BLOCK {
        y[t] += factor * x[t];
    }
}

/// What one block of rows brings to the exponents. Rows past the end have scale 0, so they count for nothing.
struct Block {
    z: Vec<Vec<f64>>,
    /// 1 / (lambda_q + n s_q), n = 1 for psi1 and 2 for psi2.
    inverse: Vec<Row>,
    mean: Vec<Row>,
    /// m_q / (lambda_q + n s_q).
    pull: Vec<Row>,
    /// - sum_q m_q^2 / (lambda_q + n s_q).
    base: Row,
    /// sigma^2n prod_q (lambda_q / (lambda_q + n s_q))^1/2.
    scale: Row,
    /// psi2's exponent of each a alone.
    own: Vec<Row>,
}

impl Block {
    fn new(z: &DMatrix<f64>) -> Self {
        let dims = z.ncols();
        Self {
            z: (0..z.nrows()).map(|a| z.row(a).iter().copied().collect()).collect(),
            inverse: vec![[0.0; BLOCK]; dims],
            mean: vec![[0.0; BLOCK]; dims],
            pull: vec![[0.0; BLOCK]; dims],
            base: [0.0; BLOCK],
            scale: [0.0; BLOCK],
            own: vec![[0.0; BLOCK]; z.nrows()],
        }
    }

    fn load(&mut self, x: &Gaussians, start: usize, len: usize, kernel: &Kernel, n: f64) {
        self.base = [0.0; BLOCK];
        let amplitude = if n == 1.0 { kernel.variance } else { kernel.variance * kernel.variance };
        let mut ratio: Row = [1.0; BLOCK];
        for q in 0..self.mean.len() {
            let lambda = kernel.lambda[q];
            let mut variance: Row = [0.0; BLOCK];
            self.mean[q] = [0.0; BLOCK];
            self.mean[q][..len].copy_from_slice(column(&x.mean, q, start, len));
            variance[..len].copy_from_slice(column(&x.variance, q, start, len));
            let (mean, inverse, pull) = (&self.mean[q], &mut self.inverse[q], &mut self.pull[q]);
            for t in 0..BLOCK {
                inverse[t] = 1.0 / (lambda + n * variance[t]);
                pull[t] = mean[t] * inverse[t];
                self.base[t] -= mean[t] * pull[t];
                ratio[t] *= lambda * inverse[t];
            }
        }
        for t in 0..BLOCK {
            self.scale[t] = amplitude * ratio[t].sqrt();
        }
        self.scale[len..].fill(0.0);
    }

    /// psi1 of every row of the block at inducing input `a`.
    fn psi1(&self, a: usize, out: &mut Row) {
        for t in 0..BLOCK {
            out[t] = 0.5 * self.base[t];
        }
        for (q, z) in self.z[a].iter().enumerate() {
            add_scaled(out, *z, &self.pull[q]);
            add_scaled(out, -0.5 * z * z, &self.inverse[q]);
        }
        for t in 0..BLOCK {
            out[t] = self.scale[t] * exp(out[t]);
        }
    }

    /// The terms of psi2's exponent that belong to a or b alone:
    /// 1/2 base + sum_q ( z_aq m_q - z_aq^2 / 4 ) / (lambda_q + 2 s_q).
    fn split_exponent(&mut self) {
        for (a, own) in self.own.iter_mut().enumerate() {
            for t in 0..BLOCK {
                own[t] = 0.5 * self.base[t];
            }
            for (q, z) in self.z[a].iter().enumerate() {
                add_scaled(own, *z, &self.pull[q]);
                add_scaled(own, -0.25 * z * z, &self.inverse[q]);
            }
        }
    }

    /// psi2_ab of every row of the block.
    #[inline(always)]
    fn psi2(&self, a: usize, b: usize, spread: f64, out: &mut Row) {
        let (own_a, own_b) = (&self.own[a], &self.own[b]);
        for t in 0..BLOCK {
            out[t] = own_a[t] + own_b[t] + spread;
        }
        for (inverse, (za, zb)) in self.inverse.iter().zip(self.z[a].iter().zip(&self.z[b])) {
            add_scaled(out, -0.5 * za * zb, inverse);
        }
        for t in 0..BLOCK {
            out[t] = self.scale[t] * exp(out[t]);
        }
    }
}

/// Sums of h = (dF/dpsi) psi over the inducing inputs, or pairs of them, of one block. With c the centre of an inducing
/// input (z_a) or of a pair ((z_a + z_b) / 2): `total` = sum h, `first` = sum h c_q, `second` = sum h c_q^2.
struct PullBack {
    total: Row,
    first: Vec<Row>,
    second: Vec<Row>,
    /// For each inducing input, the sum of h over the pairs it belongs to.
    share: Vec<Row>,
}

impl PullBack {
    fn new(z: &DMatrix<f64>) -> Self {
        Self {
            total: [0.0; BLOCK],
            first: vec![[0.0; BLOCK]; z.ncols()],
            second: vec![[0.0; BLOCK]; z.ncols()],
            share: vec![[0.0; BLOCK]; z.nrows()],
        }
    }

    fn clear(&mut self) {
        self.total = [0.0; BLOCK];
        self.first.fill([0.0; BLOCK]);
        self.second.fill([0.0; BLOCK]);
        self.share.fill([0.0; BLOCK]);
    }

    fn psi1(
        &mut self,
        block: &Block,
        psi1: &DMatrix<f64>,
        df_dpsi1: &DMatrix<f64>,
        start: usize,
        len: usize,
    ) {
        self.clear();
        for (a, z) in block.z.iter().enumerate() {
            let h = &mut self.share[a];
            let (value, weight) = (column(psi1, a, start, len), column(df_dpsi1, a, start, len));
            for ((h, value), weight) in h.iter_mut().zip(value).zip(weight) {
                *h = value * weight;
            }
            add_scaled(&mut self.total, 1.0, h);
            for (q, z) in z.iter().enumerate() {
                add_scaled(&mut self.first[q], *z, h);
                add_scaled(&mut self.second[q], z * z, h);
            }
        }
    }

    fn psi2(
        &mut self,
        block: &Block,
        spread: &DMatrix<f64>,
        df_dpsi2: &DMatrix<f64>,
        into: &mut KernelAdjoint,
    ) {
        self.clear();
        let mut h: Row = [0.0; BLOCK];
        for a in 0..block.z.len() {
            for b in 0..=a {
                block.psi2(a, b, spread[(a, b)], &mut h);
                let weight = if a == b { df_dpsi2[(a, a)] } else { 2.0 * df_dpsi2[(a, b)] };
                for value in &mut h {
                    *value *= weight;
                }
                // A pair's centre is half of each end; a pair of an inducing input with itself counts at both ends.
                add_scaled(&mut self.share[a], 0.5, &h);
                add_scaled(&mut self.share[b], 0.5, &h);
                for q in 0..block.mean.len() {
                    let (za, zb) = (block.z[a][q], block.z[b][q]);
                    add_scaled(&mut self.second[q], 0.5 * za * zb, &h);
                    let tied = 0.5 * dot(&h, &block.inverse[q]);
                    into.z[(a, q)] -= zb * tied;
                    into.z[(b, q)] -= za * tied;
                }
            }
        }
        for (a, z) in block.z.iter().enumerate() {
            add_scaled(&mut self.total, 1.0, &self.share[a]);
            for (q, z) in z.iter().enumerate() {
                add_scaled(&mut self.first[q], *z, &self.share[a]);
                add_scaled(&mut self.second[q], 0.5 * z * z, &self.share[a]);
            }
        }
    }

    /// From the sums to the adjoints. The exponent is -factor sum_q (m_q - c_q)^2 / (lambda_q + 2 factor s_q).
    #[allow(clippy::too_many_arguments)]
    fn scatter(
        &self,
        block: &Block,
        start: usize,
        len: usize,
        kernel: &Kernel,
        factor: f64,
        into_x: &mut Gaussians,
        into: &mut KernelAdjoint,
    ) {
        for q in 0..kernel.lambda.len() {
            let (inverse, pull, mean) = (&block.inverse[q], &block.pull[q], &block.mean[q]);
            let mut d_mean: Row = [0.0; BLOCK];
            let mut d_variance: Row = [0.0; BLOCK];
            for t in 0..BLOCK {
                let (i, m, total) = (inverse[t], mean[t], self.total[t]);
                d_mean[t] = -2.0 * factor * i * (m * total - self.first[q][t]);
                let square = m * m * total - 2.0 * m * self.first[q][t] + self.second[q][t];
                d_variance[t] = factor * (-i * total + 2.0 * factor * i * i * square);
            }
            into.lambda[q] += sum(&d_variance) / (2.0 * factor);
            for (out, d) in into_x.mean.view_mut((start, q), (len, 1)).iter_mut().zip(&d_mean) {
                *out += d;
            }
            for (out, d) in into_x.variance.view_mut((start, q), (len, 1)).iter_mut().zip(&d_variance) {
                *out += d;
            }
            for (a, share) in self.share.iter().enumerate() {
                into.z[(a, q)] += 2.0 * factor * dot(share, pull) - block.z[a][q] * dot(share, inverse);
            }
        }
    }
}

#[cfg(test)]
mod tests;
