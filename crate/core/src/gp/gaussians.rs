//! Uncertain inputs with Gaussian distributions.

use nalgebra::DMatrix;

/// Independent Gaussians, one for each row and dimension: the distribution of N uncertain inputs of P
/// dimensions.
#[derive(Clone, Debug, PartialEq)]
pub struct Gaussians {
    /// Means mu [N x P].
    pub mean: DMatrix<f64>,
    /// Variances S [N x P].
    pub variance: DMatrix<f64>,
}

impl Gaussians {
    /// All entries zero, for `rows` inputs of `dims` dimensions; adjoints are added to them.
    pub fn zeros(rows: usize, dims: usize) -> Self {
        Self { mean: DMatrix::zeros(rows, dims), variance: DMatrix::zeros(rows, dims) }
    }

    /// Sets all entries to zero.
    pub fn set_zero(&mut self) {
        self.mean.fill(0.0);
        self.variance.fill(0.0);
    }
}
