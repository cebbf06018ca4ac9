//! Inputs that are known up to a Gaussian.

use nalgebra::DMatrix;

/// Independent Gaussians, one a row and dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct Gaussians {
    /// Means [rows x P].
    pub mean: DMatrix<f64>,
    /// Variances [rows x P].
    pub variance: DMatrix<f64>,
}

impl Gaussians {
    /// All zero: a place to add adjoints to.
    pub fn zeros(rows: usize, dims: usize) -> Self {
        Self { mean: DMatrix::zeros(rows, dims), variance: DMatrix::zeros(rows, dims) }
    }

    /// Sets all entries to zero.
    pub fn set_zero(&mut self) {
        self.mean.fill(0.0);
        self.variance.fill(0.0);
    }
}
