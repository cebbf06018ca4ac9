//! Cholesky factors of covariances: the jitter ladder, solves, log-determinants.

mod blocked;

use nalgebra::{Cholesky, DMatrix, Dyn};
use thiserror::Error;

/// A covariance that stayed indefinite after all the jitter that the ladder allows.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum NumericsError {
    /// The matrix holds NaN or an infinity.
    #[error("the {what} has a value that is not a finite number")]
    NotFinite {
        /// Which matrix it was, in the model's terms.
        what: &'static str,
    },
    /// No rung of the jitter ladder made the factorisation succeed.
    #[error(
        "the {what} ({size} x {size}) is not positive definite, even with jitter {jitter:e} on its diagonal"
    )]
    NotPositiveDefinite {
        /// Which matrix it was, in the model's terms.
        what: &'static str,
        /// Its number of rows.
        size: usize,
        /// The largest jitter that was tried.
        jitter: f64,
    },
}

const FIRST_RUNG: f64 = 1e-6;
const RUNGS: usize = 10;

/// The lower Cholesky factor of a symmetric positive definite matrix.
#[derive(Clone, Debug)]
pub struct Factor {
    cholesky: Cholesky<f64, Dyn>,
}

impl Factor {
    /// Factorises `matrix` [n x n]. Only after a failure is jitter added: 1e-6 of the mean diagonal, times 10 up to 10 times.
    pub fn new(matrix: &DMatrix<f64>, what: &'static str) -> Result<Self, NumericsError> {
        if matrix.iter().any(|v| !v.is_finite()) {
            return Err(NumericsError::NotFinite { what });
        }
        if let Some(cholesky) = factorise(matrix.clone()) {
            return Ok(Self { cholesky });
        }
        let size = matrix.nrows();
        let mean_diagonal = matrix.trace().abs() / size.max(1) as f64;
        let mut jitter = FIRST_RUNG * mean_diagonal.max(f64::MIN_POSITIVE);
        for _ in 0..RUNGS {
            let mut shifted = matrix.clone();
            for k in 0..size {
                shifted[(k, k)] += jitter;
            }
            if let Some(cholesky) = factorise(shifted) {
                return Ok(Self { cholesky });
            }
            jitter *= 10.0;
        }
        Err(NumericsError::NotPositiveDefinite { what, size, jitter: jitter / 10.0 })
    }

    /// log |matrix|.
    pub fn log_determinant(&self) -> f64 {
        let l = self.cholesky.l_dirty();
        2.0 * (0..l.nrows()).map(|k| l[(k, k)].ln()).sum::<f64>()
    }

    /// matrix^-1 `rhs`.
    pub fn solve(&self, rhs: &DMatrix<f64>) -> DMatrix<f64> {
        self.cholesky.solve(rhs)
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
        self.cholesky.l_dirty().tr_solve_lower_triangular_unchecked_mut(&mut x);
        x
    }

    /// L^-1 `m` L^-T of a symmetric `m`.
    pub fn whiten(&self, m: &DMatrix<f64>) -> DMatrix<f64> {
        let half = self.solve_lower(m);
        symmetric(self.solve_lower(&half.transpose()))
    }

    /// L^-T `m` L^-1 of a symmetric `m`.
    pub fn unwhiten(&self, m: &DMatrix<f64>) -> DMatrix<f64> {
        let half = self.solve_upper(m);
        symmetric(self.solve_upper(&half.transpose()))
    }

    /// matrix^-1.
    pub fn inverse(&self) -> DMatrix<f64> {
        if self.cholesky.l_dirty().nrows() > blocked::LEAF {
            return blocked::inverse(self.cholesky.l_dirty());
        }
        symmetric(self.cholesky.inverse())
    }
}

fn factorise(mut matrix: DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
    if matrix.nrows() <= blocked::LEAF {
        return Cholesky::new(matrix);
    }
    blocked::cholesky(&mut matrix.as_view_mut()).then(|| Cholesky::pack_dirty(matrix))
}

/// (m + m^T) / 2, which takes the rounding out of a matrix that is symmetric by construction.
pub fn symmetric(m: DMatrix<f64>) -> DMatrix<f64> {
    let t = m.transpose();
    (m + t) * 0.5
}

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
        assert_relative_eq!(&k * f.inverse(), DMatrix::identity(3, 3), epsilon = 1e-12);
        assert_relative_eq!(f.log_determinant(), k.determinant().ln(), epsilon = 1e-12);
    }

    #[test]
    fn whitening_and_unwhitening_are_congruences() {
        let k = covariance();
        let f = Factor::new(&k, "test").unwrap();
        assert_relative_eq!(f.whiten(&k), DMatrix::identity(3, 3), epsilon = 1e-12);
        assert_relative_eq!(f.unwhiten(&DMatrix::identity(3, 3)), f.inverse(), epsilon = 1e-12);
    }

    #[test]
    fn a_singular_covariance_climbs_the_ladder() {
        let k = DMatrix::from_element(4, 4, 1.0);
        assert!(Factor::new(&k, "test").unwrap().log_determinant().is_finite());
    }

    #[test]
    fn an_indefinite_matrix_is_an_error_that_names_it() {
        let k = DMatrix::from_diagonal(&nalgebra::dvector![1.0, -1.0]);
        let error = Factor::new(&k, "covariance of the inducing points").unwrap_err().to_string();
        assert!(error.contains("covariance of the inducing points (2 x 2)"), "{error}");
        let nan = DMatrix::from_element(1, 1, f64::NAN);
        assert_eq!(Factor::new(&nan, "x").unwrap_err(), NumericsError::NotFinite { what: "x" });
    }
}
