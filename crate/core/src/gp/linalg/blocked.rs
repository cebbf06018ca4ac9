//! Cholesky factor and inverse of large matrices by recursion on their halves: nearly all work is then in
//! products of matrices.

use nalgebra::{Cholesky, DMatrix, DMatrixView, DMatrixViewMut, Dyn};

/// Largest size that is not divided: below it, recursion costs more than it saves.
const LEAF: usize = 64;

/// The Cholesky factor of a symmetric `matrix` [n x n], if it is positive definite.
pub fn factorise(mut matrix: DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
    cholesky(&mut matrix.as_view_mut()).then(|| Cholesky::pack_dirty(matrix))
}

/// Replaces the lower triangle of a symmetric `a` [n x n] by its Cholesky factor; the rest is unchanged.
/// False if `a` is not positive definite.
fn cholesky(a: &mut DMatrixViewMut<f64>) -> bool {
    let n = a.nrows();
    if n <= LEAF {
        return cholesky_of_leaf(a);
    }
    let h = n / 2;
    if !cholesky(&mut a.view_mut((0, 0), (h, h))) {
        return false;
    }
    // L21 = A21 L11^-T, stored transposed: its rows are then contiguous in memory.
    let mut transposed = a.view((h, 0), (n - h, h)).transpose();
    solve_lower(&a.view((0, 0), (h, h)), &mut transposed.as_view_mut());
    let below = transposed.transpose();
    a.view_mut((h, 0), (n - h, h)).copy_from(&below);
    let mut rest = a.view_mut((h, h), (n - h, n - h));
    add_product(-1.0, &below.as_view(), &transposed.as_view(), &mut rest);
    cholesky(&mut rest)
}

fn cholesky_of_leaf(a: &mut DMatrixViewMut<f64>) -> bool {
    let n = a.nrows();
    for j in 0..n {
        for k in 0..j {
            let factor = -a[(j, k)];
            let (before, mut column) = a.columns_range_pair_mut(k, j);
            column.rows_mut(j, n - j).axpy(factor, &before.rows(j, n - j), 1.0);
        }
        let diagonal = a[(j, j)];
        // NaN compares false and so is refused too.
        if !(diagonal > 0.0 && diagonal.is_finite()) {
            return false;
        }
        let root = diagonal.sqrt();
        a.view_mut((j, j), (n - j, 1)).scale_mut(1.0 / root);
        a[(j, j)] = root;
    }
    true
}

/// Replaces `b` [n x m] by L^-1 `b`; only the lower triangle of `l` [n x n] is read.
pub fn solve_lower(l: &DMatrixView<f64>, b: &mut DMatrixViewMut<f64>) {
    let (n, m) = b.shape();
    if n <= LEAF {
        // The diagonal of a Cholesky factor is positive: there is no division by zero.
        l.solve_lower_triangular_unchecked_mut(b);
        return;
    }
    let h = n / 2;
    solve_lower(&l.view((0, 0), (h, h)), &mut b.view_mut((0, 0), (h, m)));
    let (above, mut below) = b.rows_range_pair_mut(..h, h..);
    below.gemm(-1.0, &l.view((h, 0), (n - h, h)), &above, 1.0);
    solve_lower(&l.view((h, h), (n - h, n - h)), &mut b.view_mut((h, 0), (n - h, m)));
}

/// (L L^T)^-1; only the lower triangle of `l` [n x n] is read.
pub fn inverse(l: &DMatrix<f64>) -> DMatrix<f64> {
    let mut w = l.lower_triangle();
    invert_lower(&mut w.as_view_mut());
    let mut out = DMatrix::zeros(l.nrows(), l.nrows());
    gram(&w.as_view(), &mut out.as_view_mut());
    out.fill_upper_triangle_with_lower_triangle();
    out
}

/// Replaces a lower triangular `l`, zeros above its diagonal, by its inverse.
fn invert_lower(l: &mut DMatrixViewMut<f64>) {
    let n = l.nrows();
    if n <= LEAF {
        let mut inverse = DMatrix::identity(n, n);
        l.solve_lower_triangular_unchecked_mut(&mut inverse);
        l.copy_from(&inverse);
        return;
    }
    let h = n / 2;
    invert_lower(&mut l.view_mut((0, 0), (h, h)));
    invert_lower(&mut l.view_mut((h, h), (n - h, n - h)));
    let half = l.view((h, 0), (n - h, h)) * l.view((0, 0), (h, h));
    let below = l.view((h, h), (n - h, n - h)) * half;
    l.view_mut((h, 0), (n - h, h)).copy_from(&-below);
}

/// Writes the lower triangle of W^T W to `out`, for a lower triangular `w` with zeros above its diagonal.
fn gram(w: &DMatrixView<f64>, out: &mut DMatrixViewMut<f64>) {
    let n = w.nrows();
    if n <= LEAF {
        out.gemm(1.0, &w.transpose(), w, 0.0);
        return;
    }
    let h = n / 2;
    gram(&w.view((0, 0), (h, h)), &mut out.view_mut((0, 0), (h, h)));
    gram(&w.view((h, h), (n - h, n - h)), &mut out.view_mut((h, h), (n - h, n - h)));
    let below = w.view((h, 0), (n - h, h));
    add_product(1.0, &below.transpose().as_view(), &below, &mut out.view_mut((0, 0), (h, h)));
    out.view_mut((h, 0), (n - h, h)).gemm(1.0, &w.view((h, h), (n - h, n - h)).transpose(), &below, 0.0);
}

/// Adds `factor` times the product `a` [n x k] `b` [k x n], which is symmetric, to the lower triangle of
/// `out` [n x n]; above the diagonal, to some entries.
fn add_product(factor: f64, a: &DMatrixView<f64>, b: &DMatrixView<f64>, out: &mut DMatrixViewMut<f64>) {
    let (n, k) = a.shape();
    if n <= LEAF {
        out.gemm(factor, a, b, 1.0);
        return;
    }
    let h = n / 2;
    add_product(factor, &a.rows(0, h), &b.columns(0, h), &mut out.view_mut((0, 0), (h, h)));
    let (below, left) = (a.view((h, 0), (n - h, k)), b.columns(0, h));
    out.view_mut((h, 0), (n - h, h)).gemm(factor, &below, &left, 1.0);
    add_product(factor, &below, &b.columns(h, n - h), &mut out.view_mut((h, h), (n - h, n - h)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn covariance(n: usize) -> DMatrix<f64> {
        let distance = |i: usize, j: usize| (i as f64 - j as f64) / 9.0;
        DMatrix::from_fn(n, n, |i, j| (-0.5 * distance(i, j).powi(2)).exp() + if i == j { 0.1 } else { 0.0 })
    }

    #[test]
    fn factorises_and_inverts_all_sizes() {
        for n in [1, 2, LEAF, LEAF + 1, 2 * LEAF + 1, 301] {
            let a = covariance(n);
            let mut l = a.clone();
            assert!(cholesky(&mut l.as_view_mut()));
            let lower = l.lower_triangle();
            assert_relative_eq!(&lower * lower.transpose(), a, epsilon = 1e-12);
            assert_relative_eq!(&a * inverse(&l), DMatrix::identity(n, n), epsilon = 1e-11);
        }
    }

    #[test]
    fn refuses_a_matrix_that_is_not_positive_definite() {
        for bad in [0, LEAF, 299] {
            for value in [-1.0, f64::NAN] {
                let mut a = covariance(300);
                a[(bad, bad)] = value;
                assert!(!cholesky(&mut a.as_view_mut()));
            }
        }
    }

    #[test]
    fn refuses_a_matrix_whose_last_pivot_is_0() {
        assert!(factorise(DMatrix::from_element(2, 2, 4.0)).is_none());
    }
}
