//! The collapsed sparse bound of one Gaussian process, with its adjoint. It depends on no kernel.
//!
//! Titsias (2009) and Titsias and Lawrence (2010) for one process that explains R rows of C target columns
//! with noise variance n; for one expert, equation (A35) of Velychko et al. (2018), with the trace term of
//! (A34) counted for every column:
//!
//! F = - R C/2 log(2 pi n) - c2 / (2n) + C/2 ( log|K| - log|A| ) + tr( b^T A^-1 b ) / (2 n^2) - C gap / (2n)
//!
//! with A = K + Psi2 / n, gap = psi0 - tr(K^-1 Psi2) and c2 the sum of the expected squares of all targets.
//! All is computed in the coordinates in which K = L L^T is the identity: A = L ( I + B / n ) L^T with
//! B = L^-1 Psi2 L^-T. I + B / n is well conditioned for every K.
//!
//! ```
//! use nalgebra::{DMatrix, dvector};
//! use vcgpdm_core::gp::bound::{BoundWorkspace, SparseGp};
//! use vcgpdm_core::gp::psi::{PairWorkspace, PsiStatistics, Purpose};
//! use vcgpdm_core::gp::{Gaussians, Kernel};
//!
//! // Twenty points on a sine with certain inputs, and five inducing points.
//! let x = DMatrix::from_fn(20, 1, |t, _| 0.3 * t as f64);
//! let y = x.map(f64::sin);
//! let z = DMatrix::from_fn(5, 1, |k, _| 1.4 * k as f64);
//! let kernel = Kernel { lambda: dvector![1.0], variance: 1.0 };
//!
//! let inputs = Gaussians { mean: x, variance: DMatrix::zeros(20, 1) };
//! let mut psi = PsiStatistics::new(20, 5, 1);
//! psi.compute(&inputs, &z, &kernel, Purpose::Value, &mut PairWorkspace::default());
//!
//! let gp = SparseGp {
//!     k: &kernel.inducing_covariance(&z, 1e-6),
//!     psi2: &psi.psi2,
//!     b: &psi.psi1.tr_mul(&y),
//!     psi0: psi.psi0,
//!     second_moment: y.norm_squared(),
//!     rows: 20,
//!     noise: 0.01,
//! };
//! let mut workspace = BoundWorkspace::new(5, 1);
//! let bound = gp.bound(&mut workspace)?;
//! // With too little noise the model explains the data worse.
//! assert!(bound > SparseGp { noise: 1e-4, ..gp }.bound(&mut workspace)?);
//! # Ok::<(), vcgpdm_core::gp::NumericsError>(())
//! ```

use crate::elementary::Elementary;
use crate::gp::linalg::{Factor, NumericsError, symmetric};
use crate::gp::tall::{add_tr_product, product};
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// The arguments of the bound of one Gaussian process: K inducing points, R rows, C target columns.
#[derive(Clone, Copy, Debug)]
pub struct SparseGp<'a> {
    /// Covariance of the inducing outputs, K [K x K].
    pub k: &'a DMatrix<f64>,
    /// Sum over rows of psi2 [K x K].
    pub psi2: &'a DMatrix<f64>,
    /// b = sum over rows of psi1^T `E[target]` [K x C].
    pub b: &'a DMatrix<f64>,
    /// Sum over rows of psi0.
    pub psi0: f64,
    /// c2, the sum over rows and columns of `E[target^2]`.
    pub second_moment: f64,
    /// The number of rows R.
    pub rows: usize,
    /// Noise variance n of the targets.
    pub noise: f64,
}

/// dF with respect to the arguments of the bound, the fields of [`SparseGp`].
#[derive(Clone, Debug)]
pub struct BoundAdjoint {
    /// dF/dK [K x K].
    pub k: DMatrix<f64>,
    /// dF/dPsi2 [K x K].
    pub psi2: DMatrix<f64>,
    /// dF/db [K x C].
    pub b: DMatrix<f64>,
    /// dF/dpsi0.
    pub psi0: f64,
    /// dF/dc2.
    pub second_moment: f64,
    /// dF/dn.
    pub noise: f64,
}

impl BoundAdjoint {
    /// For K = `inducing` points and C = `columns` target columns.
    pub(crate) fn zeros(inducing: usize, columns: usize) -> Self {
        Self {
            k: DMatrix::zeros(inducing, inducing),
            psi2: DMatrix::zeros(inducing, inducing),
            b: DMatrix::zeros(inducing, columns),
            psi0: 0.0,
            second_moment: 0.0,
            noise: 0.0,
        }
    }
}

/// The best Gaussian q(v) of the inducing outputs; every column has the same covariance.
#[derive(Clone, Debug)]
pub struct InducingPosterior {
    /// Mean K A^-1 b / n [K x C].
    pub mean: DMatrix<f64>,
    /// Covariance K A^-1 K [K x K].
    pub covariance: DMatrix<f64>,
}

/// Memory for the bound of one Gaussian process and its adjoint: computing them again allocates nothing.
#[derive(Debug)]
pub struct BoundWorkspace {
    k: Factor,
    /// B = L^-1 Psi2 L^-T.
    whitened: DMatrix<f64>,
    inner_matrix: DMatrix<f64>,
    /// Of I + B / n.
    inner: Factor,
    /// L^-1 b.
    b: DMatrix<f64>,
    /// (I + B / n)^-1 L^-1 b.
    c: DMatrix<f64>,
    c_transposed: DMatrix<f64>,
    cct: DMatrix<f64>,
    /// (I + B / n)^-1.
    inverse: DMatrix<f64>,
    pub(super) adjoint: BoundAdjoint,
}

impl BoundWorkspace {
    /// For K = `inducing` points and C = `columns` target columns.
    pub fn new(inducing: usize, columns: usize) -> Self {
        let square = || DMatrix::zeros(inducing, inducing);
        let wide = || DMatrix::zeros(inducing, columns);
        Self {
            k: Factor::default(),
            whitened: square(),
            inner_matrix: square(),
            inner: Factor::default(),
            b: wide(),
            c: wide(),
            c_transposed: DMatrix::zeros(columns, inducing),
            cct: square(),
            inverse: square(),
            adjoint: BoundAdjoint::zeros(inducing, columns),
        }
    }

    /// The adjoint of the last [`SparseGp::bound_and_adjoint`].
    pub fn adjoint(&self) -> &BoundAdjoint {
        &self.adjoint
    }
}

impl SparseGp<'_> {
    /// The bound, in nats.
    ///
    /// # Errors
    ///
    /// K or A is not positive definite, even with jitter, or not finite.
    pub fn bound(&self, workspace: &mut BoundWorkspace) -> Result<f64, NumericsError> {
        let BoundWorkspace { k, whitened, inner_matrix, inner, b, c, .. } = workspace;
        let (rows, columns, n) = (self.rows as f64, self.b.ncols() as f64, self.noise);
        k.refactor(self.k, "covariance of the inducing points")?;
        whitened.copy_from(self.psi2);
        k.whiten_mut(whitened);
        inner_matrix.copy_from(whitened);
        *inner_matrix /= n;
        for a in 0..inner_matrix.nrows() {
            inner_matrix[(a, a)] += 1.0;
        }
        inner.refactor(inner_matrix, "covariance of the data at the inducing points")?;
        b.copy_from(self.b);
        k.solve_lower_mut(b);
        c.copy_from(b);
        inner.solve_mut(c);
        let gap = self.psi0 - whitened.trace();
        let bound = -0.5 * rows * columns * (TAU * n).logarithm()
            - 0.5 * self.second_moment / n
            - 0.5 * columns * inner.log_determinant()
            + 0.5 * b.dot(c) / (n * n)
            - 0.5 * columns * gap / n;
        Ok(bound)
    }

    /// The bound, in nats. Its adjoint is then [`BoundWorkspace::adjoint`].
    ///
    /// # Errors
    ///
    /// As [`bound`](Self::bound).
    pub fn bound_and_adjoint(&self, workspace: &mut BoundWorkspace) -> Result<f64, NumericsError> {
        let bound = self.bound(workspace)?;
        let BoundWorkspace {
            k: k_factor, whitened, inner, b, c, c_transposed, cct, inverse, adjoint, ..
        } = workspace;
        let (rows, columns, n) = (self.rows as f64, self.b.ncols() as f64, self.noise);
        inner.inverse_into(inverse);
        c.transpose_to(c_transposed);
        cct.fill(0.0);
        add_tr_product(c_transposed, c_transposed, cct);
        for k in 0..whitened.len() {
            let identity = if k % (whitened.nrows() + 1) == 0 { 1.0 } else { 0.0 };
            let shrunk = identity - inverse[k];
            adjoint.psi2[k] = 0.5 * columns / n * shrunk - 0.5 / (n * n * n) * cct[k];
            adjoint.k[k] = 0.5 * columns * shrunk - 0.5 / (n * n) * cct[k] - 0.5 * columns / n * whitened[k];
        }
        k_factor.unwhiten_mut(&mut adjoint.psi2);
        k_factor.unwhiten_mut(&mut adjoint.k);
        adjoint.b.copy_from(c);
        k_factor.solve_upper_mut(&mut adjoint.b);
        adjoint.b /= n * n;
        adjoint.psi0 = -0.5 * columns / n;
        adjoint.second_moment = -0.5 / n;
        let gap = self.psi0 - whitened.trace();
        adjoint.noise = -0.5 * rows * columns / n
            + 0.5 * self.second_moment / (n * n)
            + 0.5 * columns * inverse.dot(whitened) / (n * n)
            - b.dot(c) / (n * n * n)
            + 0.5 * cct.dot(whitened) / (n * n * n * n)
            + 0.5 * columns * gap / (n * n);
        Ok(bound)
    }

    /// The best posterior of the inducing outputs (Velychko et al. 2018, A36), without K^-1.
    ///
    /// # Errors
    ///
    /// A is not positive definite, even with jitter, or not finite.
    pub fn posterior(&self) -> Result<InducingPosterior, NumericsError> {
        let a =
            Factor::new(&(self.k + self.psi2 / self.noise), "covariance of the data at the inducing points")?;
        let mean = product(self.k, &a.solve(self.b)) / self.noise;
        let covariance = symmetric(product(self.k, &a.solve(self.k)));
        Ok(InducingPosterior { mean, covariance })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gp::linalg::symmetric;
    use crate::gp::testing::{Example, scalars_agree};
    use approx::assert_relative_eq;

    #[test]
    fn bound_agrees_with_the_formula() {
        let e = Example::new(4);
        let gp = e.gp();
        let a = &e.k + &e.psi2 / gp.noise;
        let inverse = a.clone().try_inverse().unwrap();
        let gap = gp.psi0 - (e.k.clone().try_inverse().unwrap() * &e.psi2).trace();
        let n = gp.noise;
        let expected = -9.0 * 3.0 / 2.0 * (TAU * n).ln() - gp.second_moment / (2.0 * n)
            + 1.5 * (e.k.determinant().ln() - a.determinant().ln())
            + (e.b.transpose() * inverse * &e.b).trace() / (2.0 * n * n)
            - 1.5 * gap / n;
        let mut workspace = BoundWorkspace::new(4, 3);
        assert_relative_eq!(gp.bound(&mut workspace).unwrap(), expected, max_relative = 1e-11);
        assert_relative_eq!(gp.bound_and_adjoint(&mut workspace).unwrap(), expected, max_relative = 1e-11);
    }

    #[test]
    fn adjoint_agrees_with_differences() {
        let e = Example::new(4);
        let mut workspace = BoundWorkspace::new(4, 3);
        e.gp().bound_and_adjoint(&mut workspace).unwrap();
        let adjoint = workspace.adjoint();
        let h = 1e-6;
        let difference = |change: &dyn Fn(&mut Example, f64)| {
            let (mut up, mut down) = (Example::new(4), Example::new(4));
            change(&mut up, h);
            change(&mut down, -h);
            let bound = |e: &Example| e.gp().bound(&mut BoundWorkspace::new(4, 3)).unwrap();
            (bound(&up) - bound(&down)) / (2.0 * h)
        };
        for i in 0..4 {
            for j in 0..=i {
                let bump = |m: &mut DMatrix<f64>, h: f64| {
                    m[(i, j)] += h;
                    if i != j {
                        m[(j, i)] += h;
                    }
                };
                let twice = if i == j { 1.0 } else { 2.0 };
                let dk = difference(&|e, h| bump(&mut e.k, h));
                assert_relative_eq!(twice * adjoint.k[(i, j)], dk, epsilon = 1e-6, max_relative = 1e-6);
                let dpsi2 = difference(&|e, h| bump(&mut e.psi2, h));
                assert_relative_eq!(twice * adjoint.psi2[(i, j)], dpsi2, epsilon = 1e-6, max_relative = 1e-6);
            }
            for c in 0..3 {
                let db = difference(&|e, h| e.b[(i, c)] += h);
                assert_relative_eq!(adjoint.b[(i, c)], db, epsilon = 1e-6, max_relative = 1e-6);
            }
        }
        scalars_agree(adjoint, difference);
    }

    #[test]
    fn posterior_agrees_with_the_formula() {
        let e = Example::new(4);
        let posterior = e.gp().posterior().unwrap();
        let inverse = (&e.k + &e.psi2 / 0.3).try_inverse().unwrap();
        assert_relative_eq!(posterior.mean, &e.k * &inverse * &e.b / 0.3, epsilon = 1e-10);
        assert_relative_eq!(posterior.covariance, symmetric(&e.k * inverse * &e.k), epsilon = 1e-10);
    }
}
