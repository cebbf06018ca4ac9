//! Products of tall matrices (many rows, few columns), with the same bits on every platform: nalgebra's
//! products of larger matrices fuse multiplications with additions where the processor can.

use crate::gp::lanes::{LANES, Lanes, Level, Simd, dispatch, load, splat, store};
use fearless_simd::prelude::*;
use fearless_simd::{f64x2, f64x4};
use nalgebra::DMatrix;

/// Columns of the left and the right matrix that are computed together: their sums fit the registers.
const LEFT: usize = 4;
const RIGHT: usize = 2;

fn column(matrix: &DMatrix<f64>, k: usize) -> &[f64] {
    let rows = matrix.nrows();
    &matrix.as_slice()[k * rows..(k + 1) * rows]
}

/// Rows of both matrices that are computed before the next ones: they stay in the cache for all columns.
const ROWS: usize = 256;

/// out += a^T b for `a` [N x K], `b` [N x C] and `out` [K x C].
pub fn add_tr_product(a: &DMatrix<f64>, b: &DMatrix<f64>, out: &mut DMatrix<f64>) {
    dispatch!(Level::new(), simd => add_tr_product_in(simd, a, b, out));
}

#[inline(always)]
fn add_tr_product_in<S: Simd>(simd: S, a: &DMatrix<f64>, b: &DMatrix<f64>, out: &mut DMatrix<f64>) {
    let (left, right) = (a.ncols(), b.ncols());
    for t in (0..a.nrows()).step_by(ROWS) {
        let rows = t..a.nrows().min(t + ROWS);
        for j in (0..right).step_by(RIGHT) {
            for i in (0..left).step_by(LEFT) {
                // The last column replaces those past it; their sums are not used.
                let left_columns = std::array::from_fn(|k| &column(a, (i + k).min(left - 1))[rows.clone()]);
                let right_columns = std::array::from_fn(|k| &column(b, (j + k).min(right - 1))[rows.clone()]);
                let sums = dot_products(simd, left_columns, right_columns);
                for (l, sum) in sums.iter().enumerate().take(left - i) {
                    for (r, sum) in sum.iter().enumerate().take(right - j) {
                        out[(i + l, j + r)] += sum;
                    }
                }
            }
        }
    }
}

/// Even and odd rows have separate sums: four lanes are those of two left columns.
#[inline(always)]
fn dot_products<S: Simd>(simd: S, a: [&[f64]; LEFT], b: [&[f64]; RIGHT]) -> [[f64; RIGHT]; LEFT] {
    let mut sums = [[f64x4::splat(simd, 0.0); RIGHT]; LEFT / 2];
    let [a0, a1, a2, a3] = a.map(|a| a.as_chunks::<2>());
    let [b0, b1] = b.map(|b| b.as_chunks::<2>());
    let pairs = a0.0.iter().zip(a1.0).zip(a2.0.iter().zip(a3.0)).zip(b0.0.iter().zip(b1.0));
    for (((p0, p1), (p2, p3)), (q0, q1)) in pairs {
        let (q0, q1) = (two(simd, q0, q0), two(simd, q1, q1));
        for (sum, p) in sums.iter_mut().zip([two(simd, p0, p1), two(simd, p2, p3)]) {
            sum[0] += p * q0;
            sum[1] += p * q1;
        }
    }
    let mut out = [[0.0; RIGHT]; LEFT];
    for (out, sums) in out.chunks_exact_mut(2).zip(sums) {
        for (r, sum) in sums.into_iter().enumerate() {
            let mut lanes = [0.0; 4];
            sum.store_slice(&mut lanes);
            let [even, odd, next_even, next_odd] = lanes;
            (out[0][r], out[1][r]) = (even + odd, next_even + next_odd);
        }
    }
    for (out, a) in out.iter_mut().zip([a0.1, a1.1, a2.1, a3.1]) {
        for (out, b) in out.iter_mut().zip([b0.1, b1.1]) {
            *out += a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        }
    }
    out
}

#[inline(always)]
fn two<S: Simd>(simd: S, low: &[f64; 2], high: &[f64; 2]) -> f64x4<S> {
    f64x2::from_slice(simd, low).combine(f64x2::from_slice(simd, high))
}

/// a b [N x C] for `a` [N x K] and `b` [K x C].
pub fn product(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let mut out = DMatrix::zeros(a.nrows(), b.ncols());
    add_product(a, b, &mut out);
    out
}

/// out += a b for `a` [N x K], `b` [K x C] and `out` [N x C].
pub fn add_product(a: &DMatrix<f64>, b: &DMatrix<f64>, out: &mut DMatrix<f64>) {
    dispatch!(Level::new(), simd => add_product_in(simd, a, b, out));
}

#[inline(always)]
fn add_product_in<S: Simd>(simd: S, a: &DMatrix<f64>, b: &DMatrix<f64>, out: &mut DMatrix<f64>) {
    let (rows, columns) = (a.nrows(), b.ncols());
    let whole = rows - rows % LANES;
    for t in (0..whole).step_by(LANES) {
        for j in (0..columns).step_by(RIGHT) {
            let pair = [column(b, j), column(b, (j + 1).min(columns - 1))];
            let sums = rows_times_columns(simd, a, t, pair);
            for (k, sum) in sums.into_iter().enumerate().take(columns - j) {
                let out = &mut out.as_mut_slice()[(j + k) * rows + t..][..LANES];
                store(load(simd, out) + sum, out);
            }
        }
    }
    for j in 0..columns {
        for (k, factor) in column(b, j).iter().enumerate() {
            for t in whole..rows {
                out[(t, j)] += a[(t, k)] * factor;
            }
        }
    }
}

/// [`LANES`] rows of `a` from row `t` times two columns.
#[inline(always)]
fn rows_times_columns<S: Simd>(
    simd: S,
    a: &DMatrix<f64>,
    t: usize,
    [b0, b1]: [&[f64]; RIGHT],
) -> [Lanes<S>; RIGHT] {
    let mut sums = [splat(simd, 0.0); RIGHT];
    for ((a, b0), b1) in a.as_slice().chunks_exact(a.nrows()).zip(b0).zip(b1) {
        if let Some(rows) = a.get(t..t + LANES) {
            let rows = Lanes::from_slice(simd, rows);
            sums[0] += rows * splat(simd, *b0);
            sums[1] += rows * splat(simd, *b1);
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gp::lanes::levels;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn adds_products_of_any_shape(rows in 0usize..40, left in 1usize..10, right in 1usize..6) {
            let a = DMatrix::from_fn(rows, left, |t, k| ((t * 7 + k * 3) as f64).sin());
            let b = DMatrix::from_fn(rows, right, |t, k| ((t * 5 + k) as f64).cos());
            let mut out = DMatrix::from_element(left, right, 0.5);
            add_tr_product(&a, &b, &mut out);
            assert_relative_eq!(out, (a.transpose() * &b).add_scalar(0.5), epsilon = 1e-12);
            let small = DMatrix::from_fn(left, right, |k, c| (k as f64 - c as f64) * 0.3);
            let mut out = DMatrix::from_element(rows, right, -1.0);
            add_product(&a, &small, &mut out);
            assert_relative_eq!(out, (&a * &small).add_scalar(-1.0), epsilon = 1e-12);
            assert_relative_eq!(product(&a, &small), &a * small, epsilon = 1e-12);
        }
    }

    #[test]
    fn every_level_of_instructions_computes_the_same_bits() {
        let a = DMatrix::from_fn(77, 5, |t, k| ((t * 7 + k * 3) as f64).sin());
        let b = DMatrix::from_fn(77, 3, |t, k| ((t * 5 + k) as f64).cos());
        let (mut inner, mut outer) = (DMatrix::zeros(5, 3), DMatrix::zeros(77, 3));
        add_tr_product(&a, &b, &mut inner);
        add_product(&a, &inner, &mut outer);
        for level in levels() {
            let (mut other_inner, mut other_outer) = (DMatrix::zeros(5, 3), DMatrix::zeros(77, 3));
            dispatch!(level, simd => add_tr_product_in(simd, &a, &b, &mut other_inner));
            dispatch!(level, simd => add_product_in(simd, &a, &inner, &mut other_outer));
            assert_eq!((&other_inner, &other_outer), (&inner, &outer), "{level:?}");
        }
    }
}
