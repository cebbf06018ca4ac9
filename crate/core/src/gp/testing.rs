//! A Gaussian process with made-up numbers, for tests of its bounds.

use crate::gp::bound::{BoundAdjoint, SparseGp};
use approx::assert_relative_eq;
use nalgebra::DMatrix;

const ROWS: usize = 9;

/// The matrices of a process with nine rows and three columns.
#[derive(Clone)]
pub struct Example {
    pub k: DMatrix<f64>,
    pub psi2: DMatrix<f64>,
    pub b: DMatrix<f64>,
    /// psi0, the second moment c2 and the noise.
    pub scalars: [f64; 3],
}

impl Example {
    /// A process with this number of inducing `points`.
    pub fn new(points: usize) -> Self {
        let root = DMatrix::from_fn(points, points, |i, j| ((3 * i + 5 * j) as f64).sin());
        let phi = DMatrix::from_fn(ROWS, points, |i, j| ((2 * i + 3 * j) as f64).cos());
        Self {
            k: &root * root.transpose() + DMatrix::identity(points, points) * 0.4,
            psi2: phi.tr_mul(&phi) + DMatrix::identity(points, points) * 0.1,
            b: DMatrix::from_fn(points, 3, |i, j| ((i + 4 * j) as f64).sin()),
            scalars: [40.0, 7.0, 0.3],
        }
    }

    pub fn gp(&self) -> SparseGp<'_> {
        let [psi0, second_moment, noise] = self.scalars;
        SparseGp { k: &self.k, psi2: &self.psi2, b: &self.b, psi0, second_moment, rows: ROWS, noise }
    }
}

/// Compares the adjoints of the scalars with central differences of a bound of changed examples.
pub fn scalars_agree<F>(adjoint: &BoundAdjoint, mut difference: F)
where
    F: FnMut(&dyn Fn(&mut Example, f64)) -> f64,
{
    let scalars = [adjoint.psi0, adjoint.second_moment, adjoint.noise];
    for (k, analytic) in scalars.into_iter().enumerate() {
        let d = difference(&|e, h| e.scalars[k] += h);
        assert_relative_eq!(analytic, d, epsilon = 1e-6, max_relative = 1e-6);
    }
}
