//! Stored inducing outputs of a process.

use crate::elementary::Elementary;
use crate::gp::bound::{BoundAdjoint, SparseGp};
use crate::gp::linalg::{Factor, NumericsError};
use crate::gp::tall::product;
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// Inducing outputs N(m, S) in each of C columns that were learned from other rows and are fixed.
///
/// The expected log density of R new rows under them, with the symbols of [`crate::gp::bound`], is
///
/// G = - R C/2 log(2 pi n) - ( c2 + C psi0 - 2 tr(b^T K^-1 m) - tr(Psi2 H) ) / (2n),
///
/// H = C ( K^-1 - K^-1 S K^-1 ) - K^-1 m m^T K^-1.
///
/// Constants of the stored outputs are left out: if these are optimal for the same rows, G is larger than the
/// collapsed bound by KL( N(m, S) || N(0, K) ).
#[derive(Clone, Debug)]
pub struct StoredOutputs {
    /// K^-1 m [K x C].
    coefficients: DMatrix<f64>,
    /// H [K x K].
    certainty: DMatrix<f64>,
    pub(super) adjoint: BoundAdjoint,
}

impl StoredOutputs {
    /// Outputs with the `coefficients` K^-1 m [K x C] under the covariance `k` of the inducing outputs, and A
    /// = K + Psi2 / n of the rows that they were learned from. K^-1 S K^-1 = A^-1: the inverse of A is more
    /// exact than two products with K^-1.
    ///
    /// # Errors
    ///
    /// When K or A is not positive definite, even with jitter.
    pub fn new(
        k: &DMatrix<f64>,
        a: &DMatrix<f64>,
        coefficients: DMatrix<f64>,
    ) -> Result<Self, NumericsError> {
        let inverse = |matrix: &DMatrix<f64>, what: &'static str| {
            let mut inverse = DMatrix::zeros(matrix.nrows(), matrix.nrows());
            Factor::new(matrix, what)?.inverse_into(&mut inverse);
            Ok::<_, NumericsError>(inverse)
        };
        let columns = coefficients.ncols() as f64;
        let information = inverse(k, "covariance of the inducing points")?
            - inverse(a, "covariance of the data at the inducing points")?;
        let certainty = information * columns - product(&coefficients, &coefficients.transpose());
        let (points, columns) = coefficients.shape();
        Ok(Self { coefficients, certainty, adjoint: BoundAdjoint::zeros(points, columns) })
    }

    /// The optimal outputs for the rows of `gp`.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn best(gp: &SparseGp<'_>) -> Result<Self, NumericsError> {
        let a = gp.k + gp.psi2 / gp.noise;
        let coefficients = Factor::new(&a, "covariance of the data at the inducing points")?.solve(gp.b);
        Self::new(gp.k, &a, coefficients / gp.noise)
    }

    /// K, the number of inducing points.
    pub fn points(&self) -> usize {
        self.coefficients.nrows()
    }

    /// K^-1 m [K x C].
    pub fn coefficients(&self) -> &DMatrix<f64> {
        &self.coefficients
    }

    /// The adjoint of the last [`bound_and_adjoint`](Self::bound_and_adjoint).
    pub(super) fn adjoint(&self) -> &BoundAdjoint {
        &self.adjoint
    }

    /// c2 + C psi0 - 2 tr(b^T K^-1 m) - tr(Psi2 H).
    fn misfit(&self, gp: &SparseGp<'_>) -> f64 {
        gp.second_moment + gp.b.ncols() as f64 * gp.psi0
            - 2.0 * gp.b.dot(&self.coefficients)
            - gp.psi2.dot(&self.certainty)
    }

    /// G, in nats.
    pub(super) fn bound(&self, gp: &SparseGp<'_>) -> f64 {
        let numbers = gp.rows as f64 * gp.b.ncols() as f64;
        -0.5 * numbers * (TAU * gp.noise).logarithm() - 0.5 * self.misfit(gp) / gp.noise
    }

    /// G, in nats, and its adjoint. K is fixed: its adjoint is 0.
    pub(super) fn bound_and_adjoint(&mut self, gp: &SparseGp<'_>) -> f64 {
        let (numbers, n) = (gp.rows as f64 * gp.b.ncols() as f64, gp.noise);
        self.adjoint.noise = -0.5 * numbers / n + 0.5 * self.misfit(gp) / (n * n);
        self.adjoint.psi2.zip_apply(&self.certainty, |out, h| *out = 0.5 * h / n);
        self.adjoint.b.zip_apply(&self.coefficients, |out, v| *out = v / n);
        self.adjoint.psi0 = -0.5 * gp.b.ncols() as f64 / n;
        self.adjoint.second_moment = -0.5 / n;
        self.bound(gp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gp::bound::BoundWorkspace;
    use crate::gp::testing::{Example, scalars_agree};
    use approx::assert_relative_eq;

    /// The optimal outputs for the rows of the example.
    fn stored(e: &Example) -> StoredOutputs {
        StoredOutputs::best(&e.gp()).unwrap()
    }

    #[test]
    fn optimal_outputs_differ_from_the_collapsed_bound_by_their_divergence() {
        let e = Example::new(4);
        let collapsed = e.gp().bound(&mut BoundWorkspace::new(4, 3)).unwrap();
        let best = e.gp().posterior().unwrap();
        let inverse = e.k.clone().try_inverse().unwrap();
        let divergence = 1.5
            * ((e.k.determinant() / best.covariance.determinant()).ln() - 4.0
                + (&inverse * &best.covariance).trace())
            + 0.5 * best.mean.dot(&(&inverse * &best.mean));
        assert_relative_eq!(stored(&e).bound(&e.gp()) - divergence, collapsed, max_relative = 1e-10);
    }

    #[test]
    fn adjoint_agrees_with_differences() {
        let e = Example::new(4);
        let mut stored = stored(&e);
        let value = stored.bound_and_adjoint(&e.gp());
        assert_eq!(value, stored.bound(&e.gp()));
        let difference = |change: &dyn Fn(&mut Example, f64)| {
            let bound = |h: f64| {
                let mut moved = Example::new(4);
                change(&mut moved, h);
                stored.bound(&moved.gp())
            };
            (bound(1e-6) - bound(-1e-6)) / 2e-6
        };
        let adjoint = &stored.adjoint;
        for i in 0..4 {
            for j in 0..4 {
                let d = difference(&|e, h| e.psi2[(i, j)] += h);
                assert_relative_eq!(adjoint.psi2[(i, j)], d, epsilon = 1e-6, max_relative = 1e-6);
                assert_eq!(adjoint.k[(i, j)], 0.0);
            }
            for c in 0..3 {
                let d = difference(&|e, h| e.b[(i, c)] += h);
                assert_relative_eq!(adjoint.b[(i, c)], d, epsilon = 1e-6, max_relative = 1e-6);
            }
        }
        scalars_agree(adjoint, difference);
    }
}
