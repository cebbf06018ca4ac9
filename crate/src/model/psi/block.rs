//! The sums over rows, block by block: what a block of rows brings to the exponents, and what comes back from them.
//!
//! A block stays in the first-level cache. Within it rows go in lanes of eight that stay in registers, so every loop compiles
//! to vector instructions, native and wasm, and adds in the same order in both. The exponent of psi2 splits into one term for
//! each of a and b and a product sum_q z_aq z_bq / (lambda_q + 2 s_q).

use super::Gaussians;
use crate::model::exp::exp;
use crate::model::kernel::{Kernel, KernelAdjoint};
use nalgebra::DMatrix;

/// Rows that are worked on side by side.
pub(super) const LANES: usize = 8;
/// Rows a block.
pub(super) const BLOCK: usize = 64;

/// One number for each of [`LANES`] rows.
pub(super) type Lanes = [f64; LANES];

const ZERO: Lanes = [0.0; LANES];

/// y += factor x.
#[inline(always)]
fn add_scaled(y: &mut Lanes, factor: f64, x: &Lanes) {
    for l in 0..LANES {
        y[l] += factor * x[l];
    }
}

/// y += x z.
#[inline(always)]
fn add_product(y: &mut Lanes, x: &Lanes, z: &Lanes) {
    for l in 0..LANES {
        y[l] += x[l] * z[l];
    }
}

#[inline(always)]
fn sum(x: &Lanes) -> f64 {
    ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]))
}

/// The lanes `c` of rows `start` to `start + len` of a column; zero past the end.
#[inline(always)]
fn lanes(matrix: &DMatrix<f64>, column: usize, start: usize, len: usize, c: usize) -> Lanes {
    let rows = &matrix.as_slice()[column * matrix.nrows() + start..][..len];
    let rows = &rows[c * LANES..len.min((c + 1) * LANES)];
    let mut out = ZERO;
    out[..rows.len()].copy_from_slice(rows);
    out
}

/// What one block of rows brings to the exponents. Rows past the end have scale 0, so they count for nothing.
///
/// Rows come as chunks of lanes; what also depends on the dimension q stands at `[chunk * P + q]`.
pub(super) struct Block {
    dims: usize,
    chunks: usize,
    /// n in lambda_q + n s_q: 1 for psi1, 2 for psi2.
    n: f64,
    /// Inducing inputs, row after row.
    z: Vec<f64>,
    /// 1 / (lambda_q + n s_q).
    inverse: Vec<Lanes>,
    mean: Vec<Lanes>,
    /// m_q / (lambda_q + n s_q).
    pull: Vec<Lanes>,
    /// - sum_q m_q^2 / (lambda_q + n s_q) [chunks].
    base: Vec<Lanes>,
    /// sigma^2n prod_q (lambda_q / (lambda_q + n s_q))^1/2 [chunks].
    scale: Vec<Lanes>,
    /// psi2's exponent of each a alone, at `[a * BLOCK / LANES + chunk]`.
    own: Vec<Lanes>,
}

impl Block {
    pub(super) fn new(z: &DMatrix<f64>) -> Self {
        let (ips, dims, chunks) = (z.nrows(), z.ncols(), BLOCK / LANES);
        Self {
            dims,
            chunks,
            n: 1.0,
            z: z.transpose().as_slice().to_vec(),
            inverse: vec![ZERO; chunks * dims],
            mean: vec![ZERO; chunks * dims],
            pull: vec![ZERO; chunks * dims],
            base: vec![ZERO; chunks],
            scale: vec![ZERO; chunks],
            own: vec![ZERO; ips * chunks],
        }
    }

    fn z(&self, a: usize) -> &[f64] {
        &self.z[a * self.dims..(a + 1) * self.dims]
    }

    fn ips(&self) -> usize {
        self.z.len() / self.dims.max(1)
    }

    pub(super) fn load(&mut self, x: &Gaussians, start: usize, len: usize, kernel: &Kernel, n: f64) {
        self.n = n;
        self.chunks = len.div_ceil(LANES);
        let amplitude = if n == 1.0 { kernel.variance } else { kernel.variance * kernel.variance };
        for c in 0..self.chunks {
            let (mut base, mut ratio) = (ZERO, [1.0; LANES]);
            for q in 0..self.dims {
                let lambda = kernel.lambda[q];
                let mean = lanes(&x.mean, q, start, len, c);
                let variance = lanes(&x.variance, q, start, len, c);
                let (mut inverse, mut pull) = (ZERO, ZERO);
                for l in 0..LANES {
                    inverse[l] = 1.0 / (lambda + n * variance[l]);
                    pull[l] = mean[l] * inverse[l];
                    base[l] -= mean[l] * pull[l];
                    ratio[l] *= lambda * inverse[l];
                }
                let at = c * self.dims + q;
                (self.inverse[at], self.pull[at], self.mean[at]) = (inverse, pull, mean);
            }
            self.base[c] = base;
            for l in 0..LANES {
                self.scale[c][l] = if c * LANES + l < len { amplitude * ratio[l].sqrt() } else { 0.0 };
            }
        }
    }

    /// 1/2 base + sum_q ( z_aq m_q - share z_aq^2 ) / (lambda_q + n s_q).
    #[inline(always)]
    fn exponent(&self, a: usize, c: usize, share: f64) -> Lanes {
        let mut e = ZERO;
        add_scaled(&mut e, 0.5, &self.base[c]);
        let at = c * self.dims..(c + 1) * self.dims;
        for ((z, pull), inverse) in self.z(a).iter().zip(&self.pull[at.clone()]).zip(&self.inverse[at]) {
            add_scaled(&mut e, *z, pull);
            add_scaled(&mut e, -share * z * z, inverse);
        }
        e
    }

    /// scale exp(e).
    #[inline(always)]
    fn finish(&self, mut e: Lanes, c: usize) -> Lanes {
        let scale = &self.scale[c];
        for l in 0..LANES {
            e[l] = scale[l] * exp(e[l]);
        }
        e
    }

    /// psi1 of every row of the block at inducing input `a`.
    pub(super) fn psi1(&self, a: usize, out: &mut [f64]) {
        for (c, out) in out.chunks_mut(LANES).enumerate() {
            out.copy_from_slice(&self.finish(self.exponent(a, c, 0.5), c)[..out.len()]);
        }
    }

    /// The terms of psi2's exponent that belong to a or b alone; their sum is the exponent but for the pairs' products.
    pub(super) fn split_exponent(&mut self) {
        for a in 0..self.ips() {
            for c in 0..self.chunks {
                self.own[a * (BLOCK / LANES) + c] = self.exponent(a, c, 0.25);
            }
        }
    }

    /// -1/2 z_aq z_bq into `products`.
    fn pair_products(&self, a: usize, b: usize, products: &mut [f64]) {
        for ((product, za), zb) in products.iter_mut().zip(self.z(a)).zip(self.z(b)) {
            *product = -0.5 * za * zb;
        }
    }

    /// psi2_ab of one chunk of rows.
    #[inline(always)]
    fn psi2(&self, a: usize, b: usize, c: usize, spread: f64, products: &[f64]) -> Lanes {
        let (own_a, own_b) = (&self.own[a * (BLOCK / LANES) + c], &self.own[b * (BLOCK / LANES) + c]);
        let mut e = ZERO;
        for l in 0..LANES {
            e[l] = own_a[l] + own_b[l] + spread;
        }
        for (product, inverse) in products.iter().zip(&self.inverse[c * self.dims..(c + 1) * self.dims]) {
            add_scaled(&mut e, *product, inverse);
        }
        self.finish(e, c)
    }

    /// The sum over the block's rows of psi2_ab; its summands are added to `kept`.
    pub(super) fn psi2_sum(&self, a: usize, b: usize, spread: f64, kept: Option<&mut Vec<Lanes>>) -> f64 {
        let mut products = vec![0.0; self.dims];
        self.pair_products(a, b, &mut products);
        let mut total = ZERO;
        let mut keep = kept;
        for c in 0..self.chunks {
            let value = self.psi2(a, b, c, spread, &products);
            add_scaled(&mut total, 1.0, &value);
            if let Some(kept) = &mut keep {
                kept.push(value);
            }
        }
        sum(&total)
    }
}

/// Sums of h = (dF/dpsi) psi over the inducing inputs, or pairs of them, of one block. With c the centre of an inducing
/// input (z_a) or of a pair ((z_a + z_b) / 2): `total` = sum h, `first` = sum h c_q, `second` = sum h c_q^2.
pub(super) struct PullBack {
    total: Vec<Lanes>,
    first: Vec<Lanes>,
    second: Vec<Lanes>,
    /// For each inducing input, the sum of h over the pairs it belongs to, at `[a * BLOCK / LANES + chunk]`.
    share: Vec<Lanes>,
}

impl PullBack {
    pub(super) fn new(z: &DMatrix<f64>) -> Self {
        let chunks = BLOCK / LANES;
        Self {
            total: vec![ZERO; chunks],
            first: vec![ZERO; chunks * z.ncols()],
            second: vec![ZERO; chunks * z.ncols()],
            share: vec![ZERO; chunks * z.nrows()],
        }
    }

    pub(super) fn psi1(
        &mut self,
        block: &Block,
        psi1: &DMatrix<f64>,
        df_dpsi1: &DMatrix<f64>,
        start: usize,
        len: usize,
    ) {
        self.second.fill(ZERO);
        self.share.fill(ZERO);
        for a in 0..block.ips() {
            for c in 0..block.chunks {
                let h = &mut self.share[a * (BLOCK / LANES) + c];
                add_product(h, &lanes(psi1, a, start, len, c), &lanes(df_dpsi1, a, start, len, c));
            }
        }
        self.gather(block, 1.0);
    }

    /// `kept` holds the block's psi2 when the forward pass kept it.
    pub(super) fn psi2(
        &mut self,
        block: &Block,
        spread: &DMatrix<f64>,
        df_dpsi2: &DMatrix<f64>,
        kept: Option<&[Lanes]>,
        into: &mut KernelAdjoint,
    ) {
        self.second.fill(ZERO);
        self.share.fill(ZERO);
        let mut products = vec![0.0; block.dims];
        let mut tied = vec![ZERO; block.dims];
        let mut kept = kept.map(|kept| kept.chunks_exact(block.chunks));
        for a in 0..block.ips() {
            for b in 0..=a {
                block.pair_products(a, b, &mut products);
                tied.fill(ZERO);
                let weight = if a == b { df_dpsi2[(a, a)] } else { 2.0 * df_dpsi2[(a, b)] };
                let values = kept.as_mut().and_then(Iterator::next);
                for c in 0..block.chunks {
                    let mut h = match values {
                        Some(values) => values[c],
                        None => block.psi2(a, b, c, spread[(a, b)], &products),
                    };
                    for h in &mut h {
                        *h *= weight;
                    }
                    // A pair's centre is half of each end; a pair of an inducing input with itself counts at both ends.
                    add_scaled(&mut self.share[a * (BLOCK / LANES) + c], 0.5, &h);
                    add_scaled(&mut self.share[b * (BLOCK / LANES) + c], 0.5, &h);
                    let at = c * block.dims..(c + 1) * block.dims;
                    let sums = self.second[at.clone()].iter_mut().zip(&mut tied);
                    for ((second, tied), (product, inverse)) in
                        sums.zip(products.iter().zip(&block.inverse[at]))
                    {
                        add_scaled(second, -*product, &h);
                        add_product(tied, &h, inverse);
                    }
                }
                for (q, tied) in tied.iter().enumerate() {
                    let tied = 0.5 * sum(tied);
                    into.z[(a, q)] -= block.z(b)[q] * tied;
                    into.z[(b, q)] -= block.z(a)[q] * tied;
                }
            }
        }
        self.gather(block, 0.5);
    }

    /// Total and first moments from the shares; `own` is how much of a share's square belongs to the second moment.
    fn gather(&mut self, block: &Block, own: f64) {
        self.total.fill(ZERO);
        self.first.fill(ZERO);
        for a in 0..block.ips() {
            for c in 0..block.chunks {
                let share = self.share[a * (BLOCK / LANES) + c];
                add_scaled(&mut self.total[c], 1.0, &share);
                for (q, z) in block.z(a).iter().enumerate() {
                    add_scaled(&mut self.first[c * block.dims + q], *z, &share);
                    add_scaled(&mut self.second[c * block.dims + q], own * z * z, &share);
                }
            }
        }
    }

    /// From the sums to the adjoints. The exponent is -n/2 sum_q (m_q - c_q)^2 / (lambda_q + n s_q).
    pub(super) fn scatter(
        &self,
        block: &Block,
        start: usize,
        len: usize,
        into_x: &mut Gaussians,
        into: &mut KernelAdjoint,
    ) {
        let n = block.n;
        let rows = into_x.mean.nrows();
        for q in 0..block.dims {
            let mut lambda = ZERO;
            for c in 0..block.chunks {
                let at = c * block.dims + q;
                let (inverse, mean, total) = (&block.inverse[at], &block.mean[at], &self.total[c]);
                let (first, second) = (&self.first[at], &self.second[at]);
                let (mut d_mean, mut d_variance) = (ZERO, ZERO);
                for l in 0..LANES {
                    let (i, m) = (inverse[l], mean[l]);
                    d_mean[l] = -n * i * (m * total[l] - first[l]);
                    let square = m * m * total[l] - 2.0 * m * first[l] + second[l];
                    d_variance[l] = 0.5 * n * (n * i * i * square - i * total[l]);
                }
                add_scaled(&mut lambda, 1.0 / n, &d_variance);
                let (from, count) = (q * rows + start + c * LANES, LANES.min(len - c * LANES));
                let out = &mut into_x.mean.as_mut_slice()[from..from + count];
                out.iter_mut().zip(&d_mean).for_each(|(out, d)| *out += d);
                let out = &mut into_x.variance.as_mut_slice()[from..from + count];
                out.iter_mut().zip(&d_variance).for_each(|(out, d)| *out += d);
            }
            into.lambda[q] += sum(&lambda);
        }
        for a in 0..block.ips() {
            for q in 0..block.dims {
                let (mut pulled, mut held) = (ZERO, ZERO);
                for c in 0..block.chunks {
                    let share = &self.share[a * (BLOCK / LANES) + c];
                    add_product(&mut pulled, share, &block.pull[c * block.dims + q]);
                    add_product(&mut held, share, &block.inverse[c * block.dims + q]);
                }
                into.z[(a, q)] += n * sum(&pulled) - block.z(a)[q] * sum(&held);
            }
        }
    }
}
