//! The sums over rows, block by block: what a block of rows adds to the exponents, and the way back to its
//! inputs.
//!
//! A block stays in the first-level cache; within it rows go in [`Lanes`]. The exponent of psi2 splits into
//! one term for each of a and b and a product sum_q z_aq z_bq / (lambda_q + 2 s_q).

use crate::gp::gaussians::Gaussians;
use crate::gp::kernel::{Kernel, KernelAdjoint};
use crate::gp::lanes::{LANES, Lanes, Quad, Stored};
use nalgebra::DMatrix;

/// Rows in a block.
pub(super) const BLOCK: usize = 64;
/// Chunks of lanes in a block.
const CHUNKS: usize = BLOCK / LANES;

/// The lanes `c` of rows `start` to `start + len` of a column; zero past the end.
#[inline(always)]
fn lanes<Q: Quad>(matrix: &DMatrix<f64>, column: usize, start: usize, len: usize, c: usize) -> Lanes<Q> {
    let rows = &matrix.as_slice()[column * matrix.nrows() + start..][..len];
    Lanes::load(&rows[c * LANES..])
}

/// What one block of rows adds to the exponents. Rows past the end have scale 0, so they count for nothing.
///
/// Rows come as chunks of lanes; what also depends on the dimension q is at `[chunk * P + q]`, what depends
/// on the inducing input a at `[a * CHUNKS + chunk]`.
pub(super) struct Block<Q: Quad> {
    dims: usize,
    ips: usize,
    chunks: usize,
    /// n in lambda_q + n s_q: 1 for psi1, 2 for psi2.
    n: f64,
    /// Inducing inputs, row after row.
    z: Vec<f64>,
    /// 1 / (lambda_q + n s_q).
    inverse: Vec<Lanes<Q>>,
    mean: Vec<Lanes<Q>>,
    /// m_q / (lambda_q + n s_q).
    pull: Vec<Lanes<Q>>,
    /// - 1/2 sum_q m_q^2 / (lambda_q + n s_q) `[chunks]`.
    base: Vec<Lanes<Q>>,
    /// sigma^2n prod_q (lambda_q / (lambda_q + n s_q))^1/2 `[chunks]`.
    scale: Vec<Lanes<Q>>,
    /// psi2's exponent of each a alone.
    own: Vec<Lanes<Q>>,
    /// -1/2 z_aq z_bq of every pair b <= a [pairs x P].
    products: Vec<Q::Number>,
    /// z_bq of every inducing input b, ready to multiply lanes with [K x P].
    inputs: Vec<Q::Number>,
    /// Sums over the rows of psi2 of every pair so far.
    sums: Vec<Lanes<Q>>,
}

impl<Q: Quad> Block<Q> {
    pub(super) fn new(ips: usize, dims: usize) -> Self {
        Self {
            dims,
            ips,
            chunks: CHUNKS,
            n: 1.0,
            z: vec![0.0; ips * dims],
            inverse: vec![Lanes::zero(); CHUNKS * dims],
            mean: vec![Lanes::zero(); CHUNKS * dims],
            pull: vec![Lanes::zero(); CHUNKS * dims],
            base: vec![Lanes::zero(); CHUNKS],
            scale: vec![Lanes::zero(); CHUNKS],
            own: vec![Lanes::zero(); ips * CHUNKS],
            products: vec![Q::number(0.0); ips * (ips + 1) / 2 * dims],
            inputs: vec![Q::number(0.0); ips * dims],
            sums: vec![Lanes::zero(); ips * (ips + 1) / 2],
        }
    }

    #[inline(always)]
    fn z(&self, a: usize) -> &[f64] {
        &self.z[a * self.dims..(a + 1) * self.dims]
    }

    /// Sets the inducing inputs [K x P] and the sums to zero.
    pub(super) fn set_inducing_inputs(&mut self, z: &DMatrix<f64>) {
        self.sums.fill(Lanes::zero());
        let mut products = self.products.iter_mut();
        for a in 0..self.ips {
            for b in 0..=a {
                for (q, product) in (0..self.dims).zip(&mut products) {
                    *product = Q::number(-0.5 * z[(a, q)] * z[(b, q)]);
                }
            }
        }
        for a in 0..self.ips {
            for q in 0..self.dims {
                self.z[a * self.dims + q] = z[(a, q)];
                self.inputs[a * self.dims + q] = Q::number(z[(a, q)]);
            }
        }
    }

    pub(super) fn load(&mut self, x: &Gaussians, start: usize, len: usize, kernel: &Kernel, n: f64) {
        Q::run(move || {
            self.n = n;
            self.chunks = len.div_ceil(LANES);
            let amplitude = if n == 1.0 { kernel.variance } else { kernel.variance * kernel.variance };
            let (one, n) = (Lanes::splat(1.0), Lanes::splat(n));
            for c in 0..self.chunks {
                let (mut base, mut ratio) = (Lanes::zero(), one);
                for q in 0..self.dims {
                    let lambda = Lanes::splat(kernel.lambda[q]);
                    let mean = lanes(&x.mean, q, start, len, c);
                    let inverse = one / (lambda + n * lanes(&x.variance, q, start, len, c));
                    let pull = mean * inverse;
                    base = base - mean * pull;
                    ratio = ratio * (lambda * inverse);
                    let at = c * self.dims + q;
                    (self.inverse[at], self.pull[at], self.mean[at]) = (inverse, pull, mean);
                }
                self.base[c] = base * Lanes::splat(0.5);
                let mut inside = [0.0; LANES];
                inside[..LANES.min(len - c * LANES)].fill(amplitude);
                self.scale[c] = ratio.sqrt() * Lanes::load(&inside);
            }
        })
    }

    /// base + sum_q ( z_aq m_q - share z_aq^2 ) / (lambda_q + n s_q).
    #[inline(always)]
    fn exponent(&self, a: usize, c: usize, share: f64) -> Lanes<Q> {
        let mut e = self.base[c];
        let at = c * self.dims..(c + 1) * self.dims;
        for ((z, pull), inverse) in self.z(a).iter().zip(&self.pull[at.clone()]).zip(&self.inverse[at]) {
            e.add_product(Lanes::splat(*z), *pull);
            e.add_product(Lanes::splat(-share * z * z), *inverse);
        }
        e
    }

    /// psi1 of every row of the block at inducing input `a`.
    pub(super) fn psi1(&self, a: usize, out: &mut [f64]) {
        Q::run(move || {
            for (c, out) in out.chunks_mut(LANES).enumerate() {
                (self.exponent(a, c, 0.5).exp() * self.scale[c]).store(out);
            }
        })
    }

    /// The terms of psi2's exponent that belong to a or b alone; their sum is the exponent but for the pairs'
    /// products.
    pub(super) fn split_exponent(&mut self) {
        Q::run(move || {
            for a in 0..self.ips {
                for c in 0..self.chunks {
                    self.own[a * CHUNKS + c] = self.exponent(a, c, 0.25);
                }
            }
        })
    }

    /// psi2 of the block's rows, chunk after chunk and pair after pair (b <= a), into `values` [chunks x
    /// pairs], and into the sums if `count`. `spread` are the pairs' own terms of the exponent.
    pub(super) fn psi2(&mut self, spread: &[f64], values: &mut [Stored], count: bool) {
        Q::run(move || {
            let pairs = spread.len();
            for (c, values) in values.chunks_exact_mut(pairs).enumerate().take(self.chunks) {
                let inverse = &self.inverse[c * self.dims..(c + 1) * self.dims];
                let scale = self.scale[c];
                let mut terms =
                    spread.iter().zip(self.products.chunks_exact(self.dims)).zip(values).zip(&mut self.sums);
                for a in 0..self.ips {
                    let own_a = self.own[a * CHUNKS + c];
                    let own = self.own.chunks_exact(CHUNKS);
                    for (own_b, (((spread, products), value), sum)) in own.take(a + 1).zip(&mut terms) {
                        let mut e = own_a + own_b[c] + Lanes::splat(*spread);
                        for (product, inverse) in products.iter().zip(inverse) {
                            e.add_product(Lanes::of(*product), *inverse);
                        }
                        let psi2 = e.exp() * scale;
                        *value = Stored(psi2.to_array());
                        if count {
                            *sum = *sum + psi2;
                        }
                    }
                }
            }
        })
    }

    /// The sums over all rows of psi2 [K x K].
    pub(super) fn psi2_sums(&self, psi2: &mut DMatrix<f64>) {
        Q::run(move || {
            let mut sums = self.sums.iter();
            for a in 0..self.ips {
                for (b, sum) in (0..=a).zip(&mut sums) {
                    psi2[(a, b)] = sum.sum();
                    psi2[(b, a)] = psi2[(a, b)];
                }
            }
        })
    }
}

/// Sums of h = (dF/dpsi) psi over the inducing inputs, or ordered pairs of them, of one block. With c the
/// centre of an inducing input (z_a) or of a pair ((z_a + z_b) / 2): `total` = sum h, `first` = sum h c_q,
/// `second` = sum h c_q^2.
pub(super) struct PullBack<Q> {
    total: Vec<Lanes<Q>>,
    first: Vec<Lanes<Q>>,
    second: Vec<Lanes<Q>>,
    /// h of every pair, for the current chunk.
    pairs: Vec<Lanes<Q>>,
    /// Sum over b of h c_q, for the current a and chunk `[P]`.
    centred: Vec<Lanes<Q>>,
    /// dF/dz_aq / n of the block so far [K x P].
    d_z: Vec<Lanes<Q>>,
}

impl<Q: Quad> PullBack<Q> {
    pub(super) fn new(ips: usize, dims: usize) -> Self {
        Self {
            total: vec![Lanes::zero(); CHUNKS],
            first: vec![Lanes::zero(); CHUNKS * dims],
            second: vec![Lanes::zero(); CHUNKS * dims],
            pairs: vec![Lanes::zero(); ips * (ips + 1) / 2],
            centred: vec![Lanes::zero(); dims],
            d_z: vec![Lanes::zero(); ips * dims],
        }
    }

    fn clear(&mut self) {
        self.total.fill(Lanes::zero());
        self.first.fill(Lanes::zero());
        self.second.fill(Lanes::zero());
        self.d_z.fill(Lanes::zero());
    }

    pub(super) fn psi1(
        &mut self,
        block: &Block<Q>,
        psi1: &DMatrix<f64>,
        df_dpsi1: &DMatrix<f64>,
        start: usize,
        len: usize,
    ) {
        Q::run(move || {
            self.clear();
            for c in 0..block.chunks {
                for a in 0..block.ips {
                    let h = lanes(psi1, a, start, len, c) * lanes(df_dpsi1, a, start, len, c);
                    for (centred, z) in self.centred.iter_mut().zip(block.z(a)) {
                        *centred = h * Lanes::splat(*z);
                    }
                    self.collect(block, a, c, h);
                }
            }
        })
    }

    /// `values` are the block's psi2, as [`Block::psi2`] leaves them.
    pub(super) fn psi2(&mut self, block: &Block<Q>, df_dpsi2: &DMatrix<f64>, values: &[Stored]) {
        Q::run(move || {
            self.clear();
            let pairs = self.pairs.len();
            for (c, values) in values.chunks_exact(pairs).enumerate().take(block.chunks) {
                // In the order of the memory, which fetches ahead then.
                let mut both = self.pairs.iter_mut().zip(values);
                for a in 0..block.ips {
                    let column = &df_dpsi2.as_slice()[a * block.ips..];
                    for (df, (h, value)) in column[..=a].iter().zip(&mut both) {
                        *h = Lanes::splat(*df) * Lanes::from_array(&value.0);
                    }
                }
                for a in 0..block.ips {
                    let h = self.fold(block, a);
                    self.collect(block, a, c, h);
                }
            }
        })
    }

    /// Returns H, the sum over b of h, and computes those of h c_q, which are (z_aq H + sum_b h z_bq) / 2.
    #[inline(always)]
    fn fold(&mut self, block: &Block<Q>, a: usize) -> Lanes<Q> {
        let dims = block.dims;
        let mut total = Lanes::zero();
        let mut q = 0;
        while q < dims {
            let (out, inputs) = (&mut self.centred[q..], &block.inputs[q..]);
            total = match dims - q {
                1 => fold::<Q, 1>(&self.pairs, a, inputs, dims, out),
                2 | 4 => fold::<Q, 2>(&self.pairs, a, inputs, dims, out),
                _ => fold::<Q, 3>(&self.pairs, a, inputs, dims, out),
            };
            q += match dims - q {
                1 => 1,
                2 | 4 => 2,
                _ => 3,
            };
        }
        for (centred, z) in self.centred.iter_mut().zip(block.z(a)) {
            *centred = (*centred + Lanes::splat(*z) * total) * Lanes::splat(0.5);
        }
        total
    }

    /// Adds what belongs to inducing input `a` and chunk `c` to the sums.
    #[inline(always)]
    fn collect(&mut self, block: &Block<Q>, a: usize, c: usize, h: Lanes<Q>) {
        self.total[c] = self.total[c] + h;
        let at = c * block.dims..(c + 1) * block.dims;
        let d_z = &mut self.d_z[a * block.dims..(a + 1) * block.dims];
        let sums = self.first[at.clone()].iter_mut().zip(&mut self.second[at.clone()]).zip(d_z);
        let rows = block.pull[at.clone()].iter().zip(&block.inverse[at]);
        let own = self.centred.iter().zip(block.z(a));
        for ((((first, second), d_z), (pull, inverse)), (centred, z)) in sums.zip(rows).zip(own) {
            *first = *first + *centred;
            second.add_product(Lanes::splat(*z), *centred);
            d_z.add_product(*pull, h);
            *d_z = *d_z - *inverse * *centred;
        }
    }

    /// From the sums to the adjoints. The exponent is -n/2 sum_q (m_q - c_q)^2 / (lambda_q + n s_q).
    pub(super) fn scatter(
        &self,
        block: &Block<Q>,
        start: usize,
        len: usize,
        into_x: &mut Gaussians,
        into: &mut KernelAdjoint,
    ) {
        Q::run(move || {
            let n = Lanes::splat(block.n);
            let half_n = Lanes::splat(0.5 * block.n);
            let rows = into_x.mean.nrows();
            for q in 0..block.dims {
                let mut lambda = Lanes::zero();
                for c in 0..block.chunks {
                    let at = c * block.dims + q;
                    let (inverse, mean, total) = (block.inverse[at], block.mean[at], self.total[c]);
                    let (first, second) = (self.first[at], self.second[at]);
                    let pulled = mean * total - first;
                    let square = mean * (pulled - first) + second;
                    let d_mean = n * inverse * pulled;
                    let d_variance = half_n * inverse * (n * inverse * square - total);
                    lambda = lambda + d_variance;
                    let part = q * rows + start + c * LANES..q * rows + start + len;
                    let out = &mut into_x.mean.as_mut_slice()[part.clone()];
                    (Lanes::load(out) - d_mean).store(out);
                    let out = &mut into_x.variance.as_mut_slice()[part];
                    (Lanes::load(out) + d_variance).store(out);
                }
                into.lambda[q] += lambda.sum() / block.n;
                for a in 0..block.ips {
                    into.z[(a, q)] += block.n * self.d_z[a * block.dims + q].sum();
                }
            }
        })
    }
}

/// For one a: the sum over b of h, and of h z_bq for `N` dimensions q into `out`. `pairs` are h of all pairs b
/// <= a; the `inputs` of b and the next are `dims` apart.
#[inline(always)]
fn fold<Q: Quad, const N: usize>(
    pairs: &[Lanes<Q>],
    a: usize,
    inputs: &[Q::Number],
    dims: usize,
    out: &mut [Lanes<Q>],
) -> Lanes<Q> {
    // So many lanes at a time that the sums fit the registers.
    if Q::NARROW {
        let (low, [h0]) = fold_some::<Q, N, 1>(pairs, |h| [h.0[0]], a, inputs, dims);
        let (high, [h1]) = fold_some::<Q, N, 1>(pairs, |h| [h.0[1]], a, inputs, dims);
        for ((out, [low]), [high]) in out.iter_mut().zip(low).zip(high) {
            *out = Lanes([low, high]);
        }
        return Lanes([h0, h1]);
    }
    let (sums, h) = fold_some::<Q, N, 2>(pairs, |h| h.0, a, inputs, dims);
    for (out, sums) in out.iter_mut().zip(sums) {
        *out = Lanes(sums);
    }
    Lanes(h)
}

/// Sums of those `W` quads of the lanes that `chosen` gives.
#[inline(always)]
fn fold_some<Q: Quad, const N: usize, const W: usize>(
    pairs: &[Lanes<Q>],
    chosen: impl Fn(&Lanes<Q>) -> [Q; W],
    a: usize,
    inputs: &[Q::Number],
    dims: usize,
) -> ([[Q; W]; N], [Q; W]) {
    let zero = Q::splat(0.0);
    let mut sums = ([[zero; W]; N], [zero; W]);
    let mut rows = inputs.chunks(dims);
    let first = a * (a + 1) / 2;
    for (h, row) in pairs[first..=first + a].iter().zip(&mut rows) {
        add_row(&mut sums, chosen(h), row);
    }
    let mut pair = first + 2 * a + 1;
    for (b, row) in (a + 1..).zip(rows) {
        add_row(&mut sums, chosen(&pairs[pair]), row);
        pair += b + 1;
    }
    sums
}

#[inline(always)]
fn add_row<Q: Quad, const N: usize, const W: usize>(
    (sums, total): &mut ([[Q; W]; N], [Q; W]),
    h: [Q; W],
    row: &[Q::Number],
) {
    for k in 0..W {
        total[k] = total[k] + h[k];
    }
    if let Some(row) = row.first_chunk::<N>() {
        for (sum, z) in sums.iter_mut().zip(row) {
            for k in 0..W {
                sum[k] = sum[k] + Q::of(*z) * h[k];
            }
        }
    }
}
