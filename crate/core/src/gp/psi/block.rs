//! The sums over rows, block by block: the exponents of a block of rows, and the adjoints of its inputs.
//!
//! A block fits the first-level cache; its rows are computed in [`Lanes`]. The exponent of psi2 splits into
//! one term for each of a and b and a product sum_q z_aq z_bq / (lambda_q + 2 s_q).

use crate::gp::exp::exp_lanes;
use crate::gp::gaussians::Gaussians;
use crate::gp::kernel::{Kernel, KernelAdjoint};
use crate::gp::lanes::{LANES, Lanes, Simd, Stored, load, splat, store, sum};
use crate::gp::psi::fold::fold;
use fearless_simd::prelude::*;
use nalgebra::DMatrix;

/// Rows in a block.
pub(super) const BLOCK: usize = 64;
/// Chunks of lanes in a block.
const CHUNKS: usize = BLOCK / LANES;

/// The lanes `c` of a column, from the `rows` that start at the first number, as many as the second number
/// says; zero past the end.
#[inline(always)]
fn lanes<S: Simd>(simd: S, matrix: &DMatrix<f64>, column: usize, rows: (usize, usize), c: usize) -> Lanes<S> {
    let (start, len) = rows;
    let rows = &matrix.as_slice()[column * matrix.nrows() + start..][..len];
    load(simd, &rows[c * LANES..])
}

/// The terms of the exponents of one block of rows. Rows past the end have scale 0.
///
/// Rows are in chunks of lanes. Numbers of a dimension q are at `[chunk * P + q]`, numbers of an inducing
/// input a at `[a * CHUNKS + chunk]`.
pub(super) struct Block<S: Simd> {
    simd: S,
    dims: usize,
    ips: usize,
    chunks: usize,
    /// n in lambda_q + n s_q: 1 for psi1, 2 for psi2.
    n: f64,
    /// Inducing inputs, row after row.
    z: Vec<f64>,
    /// 1 / (lambda_q + n s_q).
    inverse: Vec<Lanes<S>>,
    mean: Vec<Lanes<S>>,
    /// m_q / (lambda_q + n s_q).
    pull: Vec<Lanes<S>>,
    /// - 1/2 sum_q m_q^2 / (lambda_q + n s_q) `[chunks]`.
    base: Vec<Lanes<S>>,
    /// sigma^2n prod_q (lambda_q / (lambda_q + n s_q))^1/2 `[chunks]`.
    scale: Vec<Lanes<S>>,
    /// psi2's exponent of each a alone.
    own: Vec<Lanes<S>>,
    /// -1/2 z_aq z_bq of every pair b <= a [pairs x P].
    products: Vec<f64>,
    /// Sums over the rows of psi2 of every pair so far.
    sums: Vec<Lanes<S>>,
}

impl<S: Simd> Block<S> {
    pub(super) fn new(simd: S, ips: usize, dims: usize) -> Self {
        Self {
            simd,
            dims,
            ips,
            chunks: CHUNKS,
            n: 1.0,
            z: vec![0.0; ips * dims],
            inverse: vec![splat(simd, 0.0); CHUNKS * dims],
            mean: vec![splat(simd, 0.0); CHUNKS * dims],
            pull: vec![splat(simd, 0.0); CHUNKS * dims],
            base: vec![splat(simd, 0.0); CHUNKS],
            scale: vec![splat(simd, 0.0); CHUNKS],
            own: vec![splat(simd, 0.0); ips * CHUNKS],
            products: vec![0.0; ips * (ips + 1) / 2 * dims],
            sums: vec![splat(simd, 0.0); ips * (ips + 1) / 2],
        }
    }

    #[inline(always)]
    fn z(&self, a: usize) -> &[f64] {
        &self.z[a * self.dims..(a + 1) * self.dims]
    }

    /// Sets the inducing inputs [K x P] and the sums to zero.
    pub(super) fn set_inducing_inputs(&mut self, z: &DMatrix<f64>) {
        self.sums.fill(splat(self.simd, 0.0));
        let mut products = self.products.iter_mut();
        for a in 0..self.ips {
            for b in 0..=a {
                for (q, product) in (0..self.dims).zip(&mut products) {
                    *product = -0.5 * z[(a, q)] * z[(b, q)];
                }
            }
        }
        for a in 0..self.ips {
            for q in 0..self.dims {
                self.z[a * self.dims + q] = z[(a, q)];
            }
        }
    }

    pub(super) fn load(&mut self, x: &Gaussians, start: usize, len: usize, kernel: &Kernel, n: f64) {
        let (simd, rows) = (self.simd, (start, len));
        simd.vectorize(
            #[inline(always)]
            move || {
                self.n = n;
                self.chunks = len.div_ceil(LANES);
                let amplitude = if n == 1.0 { kernel.variance } else { kernel.variance * kernel.variance };
                let (one, n) = (splat(simd, 1.0), splat(simd, n));
                for c in 0..self.chunks {
                    let (mut base, mut ratio) = (splat(simd, 0.0), one);
                    for q in 0..self.dims {
                        let lambda = splat(simd, kernel.lambda[q]);
                        let mean = lanes(simd, &x.mean, q, rows, c);
                        let inverse = one / (lambda + n * lanes(simd, &x.variance, q, rows, c));
                        let pull = mean * inverse;
                        base -= mean * pull;
                        ratio *= lambda * inverse;
                        let at = c * self.dims + q;
                        (self.inverse[at], self.pull[at], self.mean[at]) = (inverse, pull, mean);
                    }
                    self.base[c] = base * splat(simd, 0.5);
                    let mut inside = [0.0; LANES];
                    inside[..LANES.min(len - c * LANES)].fill(amplitude);
                    self.scale[c] = ratio.sqrt() * load(simd, &inside);
                }
            },
        )
    }

    /// base + sum_q ( z_aq m_q - share z_aq^2 ) / (lambda_q + n s_q).
    #[inline(always)]
    fn exponent(&self, a: usize, c: usize, share: f64) -> Lanes<S> {
        let simd = self.simd;
        let mut e = self.base[c];
        let at = c * self.dims..(c + 1) * self.dims;
        for ((z, pull), inverse) in self.z(a).iter().zip(&self.pull[at.clone()]).zip(&self.inverse[at]) {
            e += splat(simd, *z) * *pull;
            e += splat(simd, -share * z * z) * *inverse;
        }
        e
    }

    /// psi1 of every row of the block at inducing input `a`.
    pub(super) fn psi1(&self, a: usize, out: &mut [f64]) {
        self.simd.vectorize(
            #[inline(always)]
            move || {
                for (c, out) in out.chunks_mut(LANES).enumerate() {
                    store(exp_lanes(self.exponent(a, c, 0.5)) * self.scale[c], out);
                }
            },
        )
    }

    /// The terms of psi2's exponent that belong to a or b alone; their sum is the exponent but for the pairs'
    /// products.
    pub(super) fn split_exponent(&mut self) {
        self.simd.vectorize(
            #[inline(always)]
            move || {
                for a in 0..self.ips {
                    for c in 0..self.chunks {
                        self.own[a * CHUNKS + c] = self.exponent(a, c, 0.25);
                    }
                }
            },
        )
    }

    /// psi2 of the block's rows, chunk after chunk and pair after pair (b <= a), into `values` [chunks x
    /// pairs], and into the sums if `count`. `spread` are the pairs' own terms of the exponent.
    pub(super) fn psi2(&mut self, spread: &[f64], values: &mut [Stored], count: bool) {
        let simd = self.simd;
        simd.vectorize(
            #[inline(always)]
            move || {
                let pairs = spread.len();
                for (c, values) in values.chunks_exact_mut(pairs).enumerate().take(self.chunks) {
                    let inverse = &self.inverse[c * self.dims..(c + 1) * self.dims];
                    let scale = self.scale[c];
                    let mut terms = spread
                        .iter()
                        .zip(self.products.chunks_exact(self.dims))
                        .zip(values)
                        .zip(&mut self.sums);
                    for a in 0..self.ips {
                        let own_a = self.own[a * CHUNKS + c];
                        let own = self.own.chunks_exact(CHUNKS);
                        for (own_b, (((spread, products), value), sum)) in own.take(a + 1).zip(&mut terms) {
                            let mut e = own_a + own_b[c] + splat(simd, *spread);
                            for (product, inverse) in products.iter().zip(inverse) {
                                e += splat(simd, *product) * *inverse;
                            }
                            let psi2 = exp_lanes(e) * scale;
                            psi2.store_slice(&mut value.0);
                            if count {
                                *sum += psi2;
                            }
                        }
                    }
                }
            },
        )
    }

    /// The sums over all rows of psi2 [K x K].
    pub(super) fn psi2_sums(&self, psi2: &mut DMatrix<f64>) {
        self.simd.vectorize(
            #[inline(always)]
            move || {
                let mut sums = self.sums.iter().map(|total| sum(*total));
                for a in 0..self.ips {
                    for (b, sum) in (0..=a).zip(&mut sums) {
                        psi2[(a, b)] = sum;
                        psi2[(b, a)] = psi2[(a, b)];
                    }
                }
            },
        )
    }
}

/// Sums of h = (dF/dpsi) psi over the inducing inputs, or ordered pairs of them, of one block. With c the
/// centre of an inducing input (z_a) or of a pair ((z_a + z_b) / 2): `total` = sum h, `first` = sum h c_q,
/// `second` = sum h c_q^2.
pub(super) struct PullBack<S: Simd> {
    simd: S,
    total: Vec<Lanes<S>>,
    first: Vec<Lanes<S>>,
    second: Vec<Lanes<S>>,
    /// h of every pair, for the current chunk.
    pairs: Vec<Lanes<S>>,
    /// Sum over b of h c_q, for the current a and chunk `[P]`.
    centred: Vec<Lanes<S>>,
    /// dF/dz_aq / n of the block so far [K x P].
    d_z: Vec<Lanes<S>>,
}

impl<S: Simd> PullBack<S> {
    pub(super) fn new(simd: S, ips: usize, dims: usize) -> Self {
        Self {
            simd,
            total: vec![splat(simd, 0.0); CHUNKS],
            first: vec![splat(simd, 0.0); CHUNKS * dims],
            second: vec![splat(simd, 0.0); CHUNKS * dims],
            pairs: vec![splat(simd, 0.0); ips * (ips + 1) / 2],
            centred: vec![splat(simd, 0.0); dims],
            d_z: vec![splat(simd, 0.0); ips * dims],
        }
    }

    fn clear(&mut self) {
        self.total.fill(splat(self.simd, 0.0));
        self.first.fill(splat(self.simd, 0.0));
        self.second.fill(splat(self.simd, 0.0));
        self.d_z.fill(splat(self.simd, 0.0));
    }

    pub(super) fn psi1(
        &mut self,
        block: &Block<S>,
        psi1: &DMatrix<f64>,
        df_dpsi1: &DMatrix<f64>,
        start: usize,
        len: usize,
    ) {
        let (simd, rows) = (self.simd, (start, len));
        simd.vectorize(
            #[inline(always)]
            move || {
                self.clear();
                for c in 0..block.chunks {
                    for a in 0..block.ips {
                        let h = lanes(simd, psi1, a, rows, c) * lanes(simd, df_dpsi1, a, rows, c);
                        for (centred, z) in self.centred.iter_mut().zip(block.z(a)) {
                            *centred = h * splat(simd, *z);
                        }
                        self.collect(block, a, c, h);
                    }
                }
            },
        )
    }

    /// `values` are the block's psi2, as [`Block::psi2`] leaves them.
    pub(super) fn psi2(&mut self, block: &Block<S>, df_dpsi2: &DMatrix<f64>, values: &[Stored]) {
        let simd = self.simd;
        simd.vectorize(
            #[inline(always)]
            move || {
                self.clear();
                let pairs = self.pairs.len();
                for (c, values) in values.chunks_exact(pairs).enumerate().take(block.chunks) {
                    // In the order of the memory, which fetches ahead then.
                    let mut both = self.pairs.iter_mut().zip(values);
                    for a in 0..block.ips {
                        let column = &df_dpsi2.as_slice()[a * block.ips..];
                        for (df, (h, value)) in column[..=a].iter().zip(&mut both) {
                            *h = splat(simd, *df) * Lanes::from_slice(simd, &value.0);
                        }
                    }
                    for a in 0..block.ips {
                        let h = self.fold(block, a);
                        self.collect(block, a, c, h);
                    }
                }
            },
        )
    }

    /// Returns H, the sum over b of h, and computes those of h c_q, which are (z_aq H + sum_b h z_bq) / 2.
    #[inline(always)]
    fn fold(&mut self, block: &Block<S>, a: usize) -> Lanes<S> {
        let simd = self.simd;
        let dims = block.dims;
        let mut total = splat(simd, 0.0);
        let mut q = 0;
        while q < dims {
            let (out, inputs) = (&mut self.centred[q..], &block.z[q..]);
            total = match dims - q {
                1 => fold::<S, 1>(simd, &self.pairs, a, inputs, dims, out),
                2 | 4 => fold::<S, 2>(simd, &self.pairs, a, inputs, dims, out),
                _ => fold::<S, 3>(simd, &self.pairs, a, inputs, dims, out),
            };
            q += match dims - q {
                1 => 1,
                2 | 4 => 2,
                _ => 3,
            };
        }
        for (centred, z) in self.centred.iter_mut().zip(block.z(a)) {
            *centred = (*centred + splat(simd, *z) * total) * splat(simd, 0.5);
        }
        total
    }

    /// Adds what belongs to inducing input `a` and chunk `c` to the sums.
    #[inline(always)]
    fn collect(&mut self, block: &Block<S>, a: usize, c: usize, h: Lanes<S>) {
        let simd = self.simd;
        self.total[c] += h;
        let at = c * block.dims..(c + 1) * block.dims;
        let d_z = &mut self.d_z[a * block.dims..(a + 1) * block.dims];
        let sums = self.first[at.clone()].iter_mut().zip(&mut self.second[at.clone()]).zip(d_z);
        let rows = block.pull[at.clone()].iter().zip(&block.inverse[at]);
        let own = self.centred.iter().zip(block.z(a));
        for ((((first, second), d_z), (pull, inverse)), (centred, z)) in sums.zip(rows).zip(own) {
            *first += *centred;
            *second += splat(simd, *z) * *centred;
            *d_z = *d_z + *pull * h - *inverse * *centred;
        }
    }

    /// From the sums to the adjoints. The exponent is -n/2 sum_q (m_q - c_q)^2 / (lambda_q + n s_q).
    pub(super) fn scatter(
        &self,
        block: &Block<S>,
        start: usize,
        len: usize,
        into_x: &mut Gaussians,
        into: &mut KernelAdjoint,
    ) {
        let simd = self.simd;
        simd.vectorize(
            #[inline(always)]
            move || {
                let n = splat(simd, block.n);
                let half_n = splat(simd, 0.5 * block.n);
                let rows = into_x.mean.nrows();
                for q in 0..block.dims {
                    let mut lambda = splat(simd, 0.0);
                    for c in 0..block.chunks {
                        let at = c * block.dims + q;
                        let (inverse, mean, total) = (block.inverse[at], block.mean[at], self.total[c]);
                        let (first, second) = (self.first[at], self.second[at]);
                        let pulled = mean * total - first;
                        let square = mean * (pulled - first) + second;
                        let d_mean = n * inverse * pulled;
                        let d_variance = half_n * inverse * (n * inverse * square - total);
                        lambda += d_variance;
                        let part = q * rows + start + c * LANES..q * rows + start + len;
                        let out = &mut into_x.mean.as_mut_slice()[part.clone()];
                        store(load(simd, out) - d_mean, out);
                        let out = &mut into_x.variance.as_mut_slice()[part];
                        store(load(simd, out) + d_variance, out);
                    }
                    into.lambda[q] += sum(lambda) / block.n;
                    for a in 0..block.ips {
                        into.z[(a, q)] += block.n * sum(self.d_z[a * block.dims + q]);
                    }
                }
            },
        )
    }
}
