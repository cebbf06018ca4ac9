//! The inducing outputs of a process: at their optimum, so that they drop out of the bound, or as they were learned before.

use crate::elementary::Elementary;
use crate::gp::bound::{BoundAdjoint, BoundWorkspace, SparseGp};
use crate::gp::linalg::{Factor, NumericsError};
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// Where the inducing outputs of a process come from, with the room for its bound.
pub enum Outputs {
    /// Those that explain the rows best: the collapsed bound.
    Best(Box<BoundWorkspace>),
    /// Those of a stored process, which stay as they are.
    Stored(Box<StoredOutputs>),
}

impl Outputs {
    /// The bound, in nats.
    pub fn bound(&mut self, gp: &SparseGp<'_>) -> Result<f64, NumericsError> {
        match self {
            Self::Best(workspace) => gp.bound(workspace),
            Self::Stored(stored) => Ok(stored.bound(gp)),
        }
    }

    /// The bound, in nats, and its adjoint, which stays here.
    pub fn bound_and_adjoint(&mut self, gp: &SparseGp<'_>) -> Result<f64, NumericsError> {
        match self {
            Self::Best(workspace) => gp.bound_and_adjoint(workspace),
            Self::Stored(stored) => Ok(stored.bound_and_adjoint(gp)),
        }
    }

    /// The adjoint computed last.
    pub fn adjoint(&self) -> &BoundAdjoint {
        match self {
            Self::Best(workspace) => workspace.adjoint(),
            Self::Stored(stored) => &stored.adjoint,
        }
    }
}

/// Inducing outputs N(m, S) in each of C columns that were learned from other rows and stay as they are.
///
/// The expected log density of R new rows under them, with the symbols of [`crate::gp::bound`], is
///
/// G = - R C/2 log(2 pi n) - ( c2 + C psi0 - 2 tr(b^T K^-1 m) - tr(Psi2 H) ) / (2n),
///
/// H = C ( K^-1 - K^-1 S K^-1 ) - K^-1 m m^T K^-1.
///
/// Constants of the stored outputs themselves are left out: where they are the best ones for these very rows, G is larger than the
/// collapsed bound by KL( N(m, S) || N(0, K) ).
#[derive(Clone, Debug)]
pub struct StoredOutputs {
    /// K^-1 m [K x C].
    coefficients: DMatrix<f64>,
    /// H [K x K].
    certainty: DMatrix<f64>,
    adjoint: BoundAdjoint,
}

impl StoredOutputs {
    /// Outputs with the `coefficients` K^-1 m [K x C] under the covariance `k` of the inducing outputs, and A = K + Psi2 / n of the rows
    /// that they were learned from, so that K^-1 S K^-1 = A^-1: inverting that is more exact than multiplying S by K^-1 twice.
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
        let known = inverse(k, "covariance of the inducing points")?
            - inverse(a, "covariance of the data at the inducing points")?;
        let certainty = known * columns - &coefficients * coefficients.transpose();
        let (points, columns) = coefficients.shape();
        Ok(Self { coefficients, certainty, adjoint: BoundAdjoint::zeros(points, columns) })
    }

    /// The outputs that explain the rows of `gp` best.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn best(gp: &SparseGp<'_>) -> Result<Self, NumericsError> {
        let a = gp.k + gp.psi2 / gp.noise;
        let coefficients = Factor::new(&a, "covariance of the data at the inducing points")?.solve(gp.b);
        Self::new(gp.k, &a, coefficients / gp.noise)
    }

    /// c2 + C psi0 - 2 tr(b^T K^-1 m) - tr(Psi2 H).
    fn misfit(&self, gp: &SparseGp<'_>) -> f64 {
        gp.second_moment + gp.b.ncols() as f64 * gp.psi0
            - 2.0 * gp.b.dot(&self.coefficients)
            - gp.psi2.dot(&self.certainty)
    }

    fn bound(&self, gp: &SparseGp<'_>) -> f64 {
        let numbers = gp.rows as f64 * gp.b.ncols() as f64;
        -0.5 * numbers * (TAU * gp.noise).logarithm() - 0.5 * self.misfit(gp) / gp.noise
    }

    /// What does not move has no adjoint: that of K stays 0.
    fn bound_and_adjoint(&mut self, gp: &SparseGp<'_>) -> f64 {
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
    use approx::assert_relative_eq;

    struct Example {
        k: DMatrix<f64>,
        psi2: DMatrix<f64>,
        b: DMatrix<f64>,
        scalars: [f64; 3],
    }

    impl Example {
        fn new() -> Self {
            let root = DMatrix::from_fn(4, 4, |i, j| ((3 * i + 5 * j) as f64).sin());
            let phi = DMatrix::from_fn(9, 4, |i, j| ((2 * i + 3 * j) as f64).cos());
            Self {
                k: &root * root.transpose() + DMatrix::identity(4, 4) * 0.4,
                psi2: phi.tr_mul(&phi) + DMatrix::identity(4, 4) * 0.1,
                b: DMatrix::from_fn(4, 3, |i, j| ((i + 4 * j) as f64).sin()),
                scalars: [40.0, 7.0, 0.3],
            }
        }

        fn gp(&self) -> SparseGp<'_> {
            let [psi0, second_moment, noise] = self.scalars;
            SparseGp { k: &self.k, psi2: &self.psi2, b: &self.b, psi0, second_moment, rows: 9, noise }
        }

        /// The best outputs for these rows.
        fn stored(&self) -> StoredOutputs {
            StoredOutputs::best(&self.gp()).unwrap()
        }
    }

    #[test]
    fn the_best_outputs_stored_miss_the_collapsed_bound_by_their_divergence() {
        let e = Example::new();
        let collapsed = e.gp().bound(&mut BoundWorkspace::new(4, 3)).unwrap();
        let best = e.gp().posterior().unwrap();
        let inverse = e.k.clone().try_inverse().unwrap();
        let divergence = 1.5
            * ((e.k.determinant() / best.covariance.determinant()).ln() - 4.0
                + (&inverse * &best.covariance).trace())
            + 0.5 * best.mean.dot(&(&inverse * &best.mean));
        assert_relative_eq!(e.stored().bound(&e.gp()) - divergence, collapsed, max_relative = 1e-10);
    }

    #[test]
    fn adjoint_agrees_with_differences() {
        let e = Example::new();
        let mut stored = e.stored();
        let value = stored.bound_and_adjoint(&e.gp());
        assert_eq!(value, stored.bound(&e.gp()));
        let difference = |change: &dyn Fn(&mut Example, f64)| {
            let bound = |h: f64| {
                let mut moved = Example::new();
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
        let scalars = [adjoint.psi0, adjoint.second_moment, adjoint.noise];
        for (k, analytic) in scalars.into_iter().enumerate() {
            let d = difference(&|e, h| e.scalars[k] += h);
            assert_relative_eq!(analytic, d, epsilon = 1e-6, max_relative = 1e-6);
        }
    }
}
