//! Cholesky factors of covariances, with jitter where a covariance is singular: solves, log-determinants.

mod blocked;

use crate::elementary::Elementary;
use nalgebra::{Cholesky, DMatrix, Dyn};
use std::cell::Cell;
use thiserror::Error;

/// Why a covariance could not be factorised, or a result cannot be used.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum NumericsError {
    /// The matrix holds NaN or an infinity.
    #[error("the {what} has a value that is not a finite number")]
    NotFinite {
        /// The name of the matrix in the model.
        what: &'static str,
    },
    /// The matrix is not positive definite, even with the largest jitter on its diagonal.
    #[error(
        "the {what} ({size} x {size}) is not positive definite, even with jitter {jitter:e} on its diagonal"
    )]
    NotPositiveDefinite {
        /// The name of the matrix in the model.
        what: &'static str,
        /// Its number of rows.
        size: usize,
        /// The largest jitter that was tried.
        jitter: f64,
    },
}

/// The first jitter, relative to the mean of the diagonal; each next one is 10 times as large.
const FIRST_JITTER: f64 = 1e-6;
const MOST_JITTERS: usize = 10;

thread_local! {
    static JITTERED: Cell<usize> = const { Cell::new(0) };
}

/// Runs `work` and counts the factorisations in it that needed jitter.
pub fn counting_jittered<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = JITTERED.get();
    let done = work();
    (done, JITTERED.get() - before)
}

/// Adds the factorisations of another thread that needed jitter to the count of this thread.
#[cfg(feature = "threads")]
pub fn add_jittered(count: usize) {
    JITTERED.set(JITTERED.get() + count);
}

/// The lower Cholesky factor of a symmetric positive definite matrix.
#[derive(Clone, Debug)]
pub struct Factor {
    cholesky: Cholesky<f64, Dyn>,
}

impl Factor {
    /// Factorises `matrix` [n x n]. After a failure jitter is added to the diagonal, in up to 10 steps: 1e-6
    /// of the mean of the diagonal, then 10 times as much at each step.
    pub fn new(matrix: &DMatrix<f64>, what: &'static str) -> Result<Self, NumericsError> {
        let mut factor = Self::default();
        factor.refactor(matrix, what)?;
        Ok(factor)
    }

    /// As [`new`](Self::new), but faster for hundreds of rows.
    pub fn of_large(matrix: &DMatrix<f64>, what: &'static str) -> Result<Self, NumericsError> {
        let mut factor = Self::default();
        factor.refactor_by(blocked::factorise, matrix, what)?;
        Ok(factor)
    }

    /// Replaces this factor by that of `matrix`, as [`new`](Self::new). Allocates nothing if the size is the
    /// same and no jitter is needed.
    pub fn refactor(&mut self, matrix: &DMatrix<f64>, what: &'static str) -> Result<(), NumericsError> {
        self.refactor_by(Cholesky::new, matrix, what)
    }

    fn refactor_by(
        &mut self,
        factorise: fn(DMatrix<f64>) -> Option<Cholesky<f64, Dyn>>,
        matrix: &DMatrix<f64>,
        what: &'static str,
    ) -> Result<(), NumericsError> {
        if matrix.iter().any(|v| !v.is_finite()) {
            return Err(NumericsError::NotFinite { what });
        }
        let mut memory = std::mem::take(self).cholesky.unpack_dirty();
        if memory.shape() == matrix.shape() {
            memory.copy_from(matrix);
        } else {
            memory = matrix.clone();
        }
        if let Some(cholesky) = factorise(memory) {
            self.cholesky = cholesky;
            return Ok(());
        }
        JITTERED.set(JITTERED.get() + 1);
        let size = matrix.nrows();
        let mean_diagonal = matrix.trace().abs() / size.max(1) as f64;
        let mut jitter = FIRST_JITTER * mean_diagonal.max(f64::MIN_POSITIVE);
        for _ in 0..MOST_JITTERS {
            let mut shifted = matrix.clone();
            for k in 0..size {
                shifted[(k, k)] += jitter;
            }
            if let Some(cholesky) = factorise(shifted) {
                self.cholesky = cholesky;
                return Ok(());
            }
            jitter *= 10.0;
        }
        Err(NumericsError::NotPositiveDefinite { what, size, jitter: jitter / 10.0 })
    }

    /// log |matrix|.
    pub fn log_determinant(&self) -> f64 {
        let l = self.cholesky.l_dirty();
        2.0 * (0..l.nrows()).map(|k| l[(k, k)].logarithm()).sum::<f64>()
    }

    /// L, with L L^T = matrix.
    pub fn lower(&self) -> DMatrix<f64> {
        self.cholesky.l()
    }

    /// matrix^-1 `rhs`.
    pub fn solve(&self, rhs: &DMatrix<f64>) -> DMatrix<f64> {
        self.cholesky.solve(rhs)
    }

    /// `x` becomes matrix^-1 x.
    pub fn solve_mut(&self, x: &mut DMatrix<f64>) {
        self.cholesky.solve_mut(x);
    }

    /// `x` becomes L^-1 x.
    pub fn solve_lower_mut(&self, x: &mut DMatrix<f64>) {
        // The diagonal of a Cholesky factor is positive: there is no division by zero.
        self.cholesky.l_dirty().solve_lower_triangular_unchecked_mut(x);
    }

    /// `x` becomes L^-T x.
    pub fn solve_upper_mut(&self, x: &mut DMatrix<f64>) {
        self.cholesky.l_dirty().tr_solve_lower_triangular_unchecked_mut(x);
    }

    /// A symmetric `m` becomes L^-1 m L^-T.
    pub fn whiten_mut(&self, m: &mut DMatrix<f64>) {
        self.solve_lower_mut(m);
        m.transpose_mut();
        self.solve_lower_mut(m);
        symmetrise(m);
    }

    /// A symmetric `m` becomes L^-T m L^-1.
    pub fn unwhiten_mut(&self, m: &mut DMatrix<f64>) {
        self.solve_upper_mut(m);
        m.transpose_mut();
        self.solve_upper_mut(m);
        symmetrise(m);
    }

    /// L^-1 `rhs`.
    pub fn solve_lower(&self, rhs: &DMatrix<f64>) -> DMatrix<f64> {
        let mut x = rhs.clone();
        blocked::solve_lower(&self.cholesky.l_dirty().as_view(), &mut x.as_view_mut());
        x
    }

    /// L^-T `rhs`.
    pub fn solve_upper(&self, rhs: &DMatrix<f64>) -> DMatrix<f64> {
        let mut x = rhs.clone();
        self.solve_upper_mut(&mut x);
        x
    }

    /// matrix^-1, also fast for hundreds of rows.
    pub fn inverse(&self) -> DMatrix<f64> {
        blocked::inverse(self.cholesky.l_dirty())
    }

    /// `m` [n x n] becomes matrix^-1.
    pub fn inverse_into(&self, m: &mut DMatrix<f64>) {
        m.fill_with_identity();
        self.solve_mut(m);
        symmetrise(m);
    }
}

impl Default for Factor {
    /// The factor of the matrix of no rows.
    fn default() -> Self {
        Self { cholesky: Cholesky::pack_dirty(DMatrix::zeros(0, 0)) }
    }
}

/// `m` becomes (m + m^T) / 2, which removes rounding errors from a matrix that is symmetric by construction.
pub fn symmetrise(m: &mut DMatrix<f64>) {
    for a in 0..m.nrows() {
        for b in 0..a {
            let mean = 0.5 * (m[(a, b)] + m[(b, a)]);
            m[(a, b)] = mean;
            m[(b, a)] = mean;
        }
    }
}

/// (m + m^T) / 2.
pub fn symmetric(mut m: DMatrix<f64>) -> DMatrix<f64> {
    symmetrise(&mut m);
    m
}

/// A matrix with these square blocks on its diagonal and 0 in all other places.
pub fn block_diagonal<'a>(blocks: impl IntoIterator<Item = &'a DMatrix<f64>>) -> DMatrix<f64> {
    let blocks: Vec<_> = blocks.into_iter().collect();
    let height = blocks.iter().map(|block| block.nrows()).sum();
    let mut all = DMatrix::zeros(height, height);
    let mut at = 0;
    for block in blocks {
        all.view_mut((at, at), block.shape()).copy_from(block);
        at += block.nrows();
    }
    all
}

/// Matrices of equal width, one below the other; without any, a matrix without rows and columns.
pub fn stacked<'a>(blocks: impl IntoIterator<Item = &'a DMatrix<f64>>) -> DMatrix<f64> {
    let blocks: Vec<_> = blocks.into_iter().collect();
    let width = blocks.first().map_or(0, |block| block.ncols());
    let mut all = DMatrix::zeros(blocks.iter().map(|block| block.nrows()).sum(), width);
    let mut at = 0;
    for block in blocks {
        all.rows_mut(at, block.nrows()).copy_from(block);
        at += block.nrows();
    }
    all
}

crate::coded!(NumericsError => Numerics);

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn covariance() -> DMatrix<f64> {
        DMatrix::from_row_slice(3, 3, &[4.0, 1.0, 0.5, 1.0, 3.0, 0.2, 0.5, 0.2, 2.0])
    }

    #[test]
    fn solves_invert_the_matrix() {
        let k = covariance();
        let f = Factor::new(&k, "test").unwrap();
        let rhs = DMatrix::from_fn(3, 2, |i, j| (i + 2 * j) as f64);
        assert_relative_eq!(&k * f.solve(&rhs), rhs, epsilon = 1e-12);
        let mut inverse = DMatrix::zeros(3, 3);
        f.inverse_into(&mut inverse);
        assert_relative_eq!(&k * inverse, DMatrix::identity(3, 3), epsilon = 1e-12);
        assert_relative_eq!(f.log_determinant(), k.determinant().ln(), epsilon = 1e-12);
    }

    #[test]
    fn jitter_is_a_share_of_the_mean_diagonal() {
        // Its last pivot is exactly 0.
        let singular = DMatrix::from_element(2, 2, 4.0);
        let factor = Factor::new(&singular, "test").unwrap();
        let shifted = singular + DMatrix::identity(2, 2) * (4.0 * FIRST_JITTER);
        assert_relative_eq!(factor.log_determinant(), shifted.determinant().ln(), epsilon = 1e-6);
    }

    #[test]
    fn whitening_and_unwhitening_agree_with_products() {
        let k = covariance();
        let f = Factor::new(&k, "test").unwrap();
        let mut white = k.clone();
        f.whiten_mut(&mut white);
        assert_relative_eq!(white, DMatrix::identity(3, 3), epsilon = 1e-12);
        f.unwhiten_mut(&mut white);
        assert_relative_eq!(&k * white, DMatrix::identity(3, 3), epsilon = 1e-12);
    }

    #[test]
    fn a_singular_covariance_gets_jitter() {
        let k = DMatrix::from_element(4, 4, 1.0);
        let (factor, jittered) = counting_jittered(|| Factor::new(&k, "test").unwrap());
        assert!(factor.log_determinant().is_finite());
        assert_eq!(jittered, 1);
        assert_eq!(counting_jittered(|| Factor::new(&covariance(), "test").unwrap()).1, 0);
    }

    #[test]
    fn a_factor_can_be_used_again_after_a_failure() {
        let mut f = Factor::new(&covariance(), "test").unwrap();
        f.refactor(&DMatrix::from_element(2, 2, f64::NAN), "test").unwrap_err();
        f.refactor(&DMatrix::identity(2, 2), "test").unwrap();
        assert_eq!(f.log_determinant(), 0.0);
    }

    #[test]
    fn refuses_an_indefinite_matrix_and_names_it() {
        let k = DMatrix::from_diagonal(&nalgebra::dvector![1.0, -1.0]);
        let error = Factor::new(&k, "covariance of the inducing points").unwrap_err().to_string();
        assert!(error.contains("covariance of the inducing points (2 x 2)"), "{error}");
        let nan = DMatrix::from_element(1, 1, f64::NAN);
        assert_eq!(Factor::new(&nan, "x").unwrap_err(), NumericsError::NotFinite { what: "x" });
    }
}
