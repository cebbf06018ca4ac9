//! Products of tall matrices (many rows, few columns), added to an existing matrix; they allocate nothing.

use crate::gp::lanes::{LANES, Lanes, Quad, in_widest_registers};
use nalgebra::DMatrix;

/// Columns of the left and the right matrix that are computed together: their sums then stay in registers.
const LEFT: usize = 4;
const RIGHT: usize = 2;

fn column(matrix: &DMatrix<f64>, k: usize) -> &[f64] {
    let rows = matrix.nrows();
    &matrix.as_slice()[k * rows..(k + 1) * rows]
}

/// Rows of both matrices that are computed before the next ones: they then stay in the cache for all columns.
const ROWS: usize = 256;

/// out += a^T b for `a` [N x K], `b` [N x C] and `out` [K x C].
pub fn add_tr_product(a: &DMatrix<f64>, b: &DMatrix<f64>, out: &mut DMatrix<f64>) {
    in_widest_registers!(Q => add_tr_product_in::<Q>(a, b, out));
}

fn add_tr_product_in<Q: Quad>(a: &DMatrix<f64>, b: &DMatrix<f64>, out: &mut DMatrix<f64>) {
    let (left, right) = (a.ncols(), b.ncols());
    for t in (0..a.nrows()).step_by(ROWS) {
        let rows = t..a.nrows().min(t + ROWS);
        for j in (0..right).step_by(RIGHT) {
            for i in (0..left).step_by(LEFT) {
                // Past the last column the last one is used again, and its sum is ignored.
                let left_columns = std::array::from_fn(|k| &column(a, (i + k).min(left - 1))[rows.clone()]);
                let right_columns = std::array::from_fn(|k| &column(b, (j + k).min(right - 1))[rows.clone()]);
                let sums = Q::run(|| dot_products::<Q>(left_columns, right_columns));
                for (l, sum) in sums.iter().enumerate().take(left - i) {
                    for (r, sum) in sum.iter().enumerate().take(right - j) {
                        out[(i + l, j + r)] += sum;
                    }
                }
            }
        }
    }
}

/// Rows of even and of odd number are summed apart: four numbers are those of two left columns.
#[inline(always)]
fn dot_products<Q: Quad>(a: [&[f64]; LEFT], b: [&[f64]; RIGHT]) -> [[f64; RIGHT]; LEFT] {
    let mut sums = [[Q::splat(0.0); RIGHT]; LEFT / 2];
    let [a0, a1, a2, a3] = a.map(|a| a.as_chunks::<2>());
    let [b0, b1] = b.map(|b| b.as_chunks::<2>());
    let pairs = a0.0.iter().zip(a1.0).zip(a2.0.iter().zip(a3.0)).zip(b0.0.iter().zip(b1.0));
    for (((p0, p1), (p2, p3)), (q0, q1)) in pairs {
        let two = |p: &[f64; 2], q: &[f64; 2]| Q::from_array([p[0], p[1], q[0], q[1]]);
        let (q0, q1) = (two(q0, q0), two(q1, q1));
        for (sum, p) in sums.iter_mut().zip([two(p0, p1), two(p2, p3)]) {
            sum[0] = sum[0] + p * q0;
            sum[1] = sum[1] + p * q1;
        }
    }
    let mut out = [[0.0; RIGHT]; LEFT];
    for (out, sums) in out.chunks_exact_mut(2).zip(sums) {
        for (r, sum) in sums.into_iter().enumerate() {
            let [even, odd, next_even, next_odd] = sum.to_array();
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

/// out += a b for `a` [N x K], `b` [K x C] and `out` [N x C].
pub fn add_product(a: &DMatrix<f64>, b: &DMatrix<f64>, out: &mut DMatrix<f64>) {
    in_widest_registers!(Q => add_product_in::<Q>(a, b, out));
}

fn add_product_in<Q: Quad>(a: &DMatrix<f64>, b: &DMatrix<f64>, out: &mut DMatrix<f64>) {
    let (rows, columns) = (a.nrows(), b.ncols());
    let whole = rows - rows % LANES;
    Q::run(|| {
        for t in (0..whole).step_by(LANES) {
            for j in (0..columns).step_by(RIGHT) {
                let sums = rows_times_columns::<Q>(a, t, [column(b, j), column(b, (j + 1).min(columns - 1))]);
                for (k, sum) in sums.into_iter().enumerate().take(columns - j) {
                    let out = &mut out.as_mut_slice()[(j + k) * rows + t..][..LANES];
                    (Lanes::load(out) + sum).store(out);
                }
            }
        }
    });
    for j in 0..columns {
        for (k, factor) in column(b, j).iter().enumerate() {
            for t in whole..rows {
                out[(t, j)] += a[(t, k)] * factor;
            }
        }
    }
}

/// The rows `t` to `t` + [`LANES`] of `a`, all of them there, times two columns.
#[inline(always)]
fn rows_times_columns<Q: Quad>(a: &DMatrix<f64>, t: usize, [b0, b1]: [&[f64]; RIGHT]) -> [Lanes<Q>; RIGHT] {
    let mut sums = [Lanes::zero(); RIGHT];
    for ((a, b0), b1) in a.as_slice().chunks_exact(a.nrows()).zip(b0).zip(b1) {
        if let Some(lanes) = a.get(t..t + LANES).and_then(<[f64]>::first_chunk) {
            let lanes = Lanes::from_array(lanes);
            sums[0].add_product(lanes, Lanes::splat(*b0));
            sums[1].add_product(lanes, Lanes::splat(*b1));
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gp::lanes::Narrow;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn products_of_any_shape_are_added(rows in 0usize..40, left in 1usize..10, right in 1usize..6) {
            let a = DMatrix::from_fn(rows, left, |t, k| ((t * 7 + k * 3) as f64).sin());
            let b = DMatrix::from_fn(rows, right, |t, k| ((t * 5 + k) as f64).cos());
            let mut out = DMatrix::from_element(left, right, 0.5);
            add_tr_product(&a, &b, &mut out);
            assert_relative_eq!(out, (a.transpose() * &b).add_scalar(0.5), epsilon = 1e-12);
            let small = DMatrix::from_fn(left, right, |k, c| (k as f64 - c as f64) * 0.3);
            let mut out = DMatrix::from_element(rows, right, -1.0);
            add_product(&a, &small, &mut out);
            assert_relative_eq!(out, (&a * small).add_scalar(-1.0), epsilon = 1e-12);
        }
    }

    #[test]
    fn wide_registers_compute_the_same_bits() {
        let a = DMatrix::from_fn(77, 5, |t, k| ((t * 7 + k * 3) as f64).sin());
        let b = DMatrix::from_fn(77, 3, |t, k| ((t * 5 + k) as f64).cos());
        let (mut here, mut narrow) = (DMatrix::zeros(5, 3), DMatrix::zeros(5, 3));
        add_tr_product(&a, &b, &mut here);
        add_tr_product_in::<Narrow>(&a, &b, &mut narrow);
        assert_eq!(here, narrow);
        let (mut there, mut slim) = (DMatrix::zeros(77, 3), DMatrix::zeros(77, 3));
        add_product(&a, &here, &mut there);
        add_product_in::<Narrow>(&a, &here, &mut slim);
        assert_eq!(there, slim);
    }
}
