//! Sums over the pairs of one inducing input with all others, for the adjoint of psi2.

use crate::gp::lanes::{Lanes, Simd};
use fearless_simd::f64x4;
use fearless_simd::prelude::*;

/// For one a: the sum over b of h, and of h z_bq for `N` dimensions q into `out`. `pairs` are h of all pairs
/// b <= a; the `inputs` of b and the next are `dims` apart.
#[inline(always)]
pub fn fold<S: Simd, const N: usize>(
    simd: S,
    pairs: &[Lanes<S>],
    a: usize,
    inputs: &[f64],
    dims: usize,
    out: &mut [Lanes<S>],
) -> Lanes<S> {
    // Where a register holds two numbers, the sums of all lanes need more registers than there are.
    if S::f64s::LEN == 2 {
        let halves = (
            #[inline(always)]
            |h: &Lanes<S>| h.split().0,
            #[inline(always)]
            |h: &Lanes<S>| h.split().1,
        );
        let (low, h_low) = fold_lanes::<S, f64x4<S>, N>(simd, pairs, halves.0, a, inputs, dims);
        let (high, h_high) = fold_lanes::<S, f64x4<S>, N>(simd, pairs, halves.1, a, inputs, dims);
        for ((out, low), high) in out.iter_mut().zip(low).zip(high) {
            *out = low.combine(high);
        }
        return h_low.combine(h_high);
    }
    let (sums, h) = fold_lanes::<S, Lanes<S>, N>(
        simd,
        pairs,
        #[inline(always)]
        |h| *h,
        a,
        inputs,
        dims,
    );
    for (out, sum) in out.iter_mut().zip(sums) {
        *out = sum;
    }
    h
}

/// [`fold`] of the lanes that `choose` takes: the sums of h z_bq and of h.
#[inline(always)]
fn fold_lanes<S: Simd, V: SimdFloat<S, Element = f64>, const N: usize>(
    simd: S,
    pairs: &[Lanes<S>],
    choose: impl Fn(&Lanes<S>) -> V,
    a: usize,
    inputs: &[f64],
    dims: usize,
) -> ([V; N], V) {
    let zero = V::splat(simd, 0.0);
    let mut sums = ([zero; N], zero);
    let mut rows = inputs.chunks(dims);
    let first = a * (a + 1) / 2;
    for (h, row) in pairs[first..=first + a].iter().zip(&mut rows) {
        add_row(simd, &mut sums, choose(h), row);
    }
    let mut pair = first + 2 * a + 1;
    for (b, row) in (a + 1..).zip(rows) {
        add_row(simd, &mut sums, choose(&pairs[pair]), row);
        pair += b + 1;
    }
    sums
}

#[inline(always)]
fn add_row<S: Simd, V: SimdFloat<S, Element = f64>, const N: usize>(
    simd: S,
    (sums, total): &mut ([V; N], V),
    h: V,
    row: &[f64],
) {
    *total += h;
    if let Some(row) = row.first_chunk::<N>() {
        for (sum, z) in sums.iter_mut().zip(row) {
            *sum += h * V::splat(simd, *z);
        }
    }
}
