//! The collapsed sparse bound of one Gaussian process, with its adjoints. Knows no kernel.
//!
//! Titsias 2009 and Titsias & Lawrence 2010; equation (A27) of Velychko et al. 2018 with its trace term for every column:
//!
//! F = - R C/2 log(2 pi n) - c2 / (2n) + C/2 ( log|K| - log|A| ) + tr( b^T A^-1 b ) / (2 n^2) - C gap / (2n)
//!
//! with A = K + Psi2 / n and gap = psi0 - tr(K^-1 Psi2). Everything is computed in the coordinates in which K = L L^T is the
//! identity: A = L ( I + B / n ) L^T with B = L^-1 Psi2 L^-T, which is well conditioned whatever K is.

use crate::linalg::{Factor, NumericsError};
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// What the bound of one Gaussian process depends on: M inducing points, R rows, C target columns.
pub struct SparseGp<'a> {
    /// Covariance of the inducing outputs, K [M x M].
    pub k: &'a DMatrix<f64>,
    /// Sum over rows of psi2 [M x M].
    pub psi2: &'a DMatrix<f64>,
    /// b = sum over rows of psi1^T E[target] [M x C].
    pub b: &'a DMatrix<f64>,
    /// Sum over rows of psi0.
    pub psi0: f64,
    /// Sum over rows and columns of E[target^2].
    pub second_moment: f64,
    /// R.
    pub rows: usize,
    /// Observation variance n.
    pub noise: f64,
}

/// dF with respect to the arguments of the bound.
#[derive(Debug)]
pub struct BoundAdjoint {
    /// dF/dK [M x M].
    pub k: DMatrix<f64>,
    /// dF/dPsi2 [M x M].
    pub psi2: DMatrix<f64>,
    /// dF/db [M x C].
    pub b: DMatrix<f64>,
    /// dF/dpsi0.
    pub psi0: f64,
    /// dF/dc2.
    pub second_moment: f64,
    /// dF/dn.
    pub noise: f64,
}

/// The optimal q(v) of the inducing outputs; every column has the same covariance.
#[derive(Clone, Debug)]
pub struct InducingPosterior {
    /// K A^-1 b / n [M x C].
    pub mean: DMatrix<f64>,
    /// K A^-1 K [M x M].
    pub covariance: DMatrix<f64>,
}

/// What value, adjoint and posterior share.
struct Whitened {
    k: Factor,
    /// B = L^-1 Psi2 L^-T.
    whitened: DMatrix<f64>,
    /// I + B / n.
    inner: Factor,
    /// (I + B / n)^-1 L^-1 b.
    c: DMatrix<f64>,
    /// tr(b^T A^-1 b).
    fit: f64,
}

impl SparseGp<'_> {
    fn whitened(&self) -> Result<Whitened, NumericsError> {
        let k = Factor::new(self.k, "covariance of the inducing points")?;
        let whitened = k.whiten(self.psi2);
        let mut inner = &whitened / self.noise;
        for a in 0..inner.nrows() {
            inner[(a, a)] += 1.0;
        }
        let inner = Factor::new(&inner, "covariance of the data at the inducing points")?;
        let b = k.solve_lower(self.b);
        let c = inner.solve(&b);
        let fit = b.dot(&c);
        Ok(Whitened { k, whitened, inner, c, fit })
    }

    fn value(&self, w: &Whitened) -> f64 {
        let (rows, columns, n) = (self.rows as f64, self.b.ncols() as f64, self.noise);
        let gap = self.psi0 - w.whitened.trace();
        -0.5 * rows * columns * (TAU * n).ln()
            - 0.5 * self.second_moment / n
            - 0.5 * columns * w.inner.log_determinant()
            + 0.5 * w.fit / (n * n)
            - 0.5 * columns * gap / n
    }

    /// The bound, in nats.
    pub fn bound(&self) -> Result<f64, NumericsError> {
        Ok(self.value(&self.whitened()?))
    }

    /// The bound, in nats, and its adjoint.
    pub fn bound_and_adjoint(&self) -> Result<(f64, BoundAdjoint), NumericsError> {
        let w = self.whitened()?;
        let (rows, columns, n) = (self.rows as f64, self.b.ncols() as f64, self.noise);
        let size = self.k.nrows();
        let inverse = w.inner.inverse();
        let cct = &w.c * w.c.transpose();
        let identity = DMatrix::identity(size, size);
        let psi2 = (&identity - &inverse) * (0.5 * columns / n) - &cct * (0.5 / (n * n * n));
        let k = (&identity - &inverse) * (0.5 * columns)
            - &cct * (0.5 / (n * n))
            - &w.whitened * (0.5 * columns / n);
        let gap = self.psi0 - w.whitened.trace();
        let noise = -0.5 * rows * columns / n
            + 0.5 * self.second_moment / (n * n)
            + 0.5 * columns * inverse.dot(&w.whitened) / (n * n)
            - w.fit / (n * n * n)
            + 0.5 * cct.dot(&w.whitened) / (n * n * n * n)
            + 0.5 * columns * gap / (n * n);
        let adjoint = BoundAdjoint {
            k: w.k.unwhiten(&k),
            psi2: w.k.unwhiten(&psi2),
            b: w.k.solve_upper(&w.c) / (n * n),
            psi0: -0.5 * columns / n,
            second_moment: -0.5 / n,
            noise,
        };
        Ok((self.value(&w), adjoint))
    }

    /// The optimal posterior of the inducing outputs (Velychko et al. 2018, A26), without ever forming K^-1.
    pub fn posterior(&self) -> Result<InducingPosterior, NumericsError> {
        let a =
            Factor::new(&(self.k + self.psi2 / self.noise), "covariance of the data at the inducing points")?;
        let mean = self.k * a.solve(self.b) / self.noise;
        let covariance = crate::linalg::symmetric(self.k * a.solve(self.k));
        Ok(InducingPosterior { mean, covariance })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linalg::symmetric;
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
    }

    #[test]
    fn value_is_the_formula_as_written() {
        let e = Example::new();
        let gp = e.gp();
        let a = &e.k + &e.psi2 / gp.noise;
        let inverse = a.clone().try_inverse().unwrap();
        let gap = gp.psi0 - (e.k.clone().try_inverse().unwrap() * &e.psi2).trace();
        let n = gp.noise;
        let expected = -9.0 * 3.0 / 2.0 * (TAU * n).ln() - gp.second_moment / (2.0 * n)
            + 1.5 * (e.k.determinant().ln() - a.determinant().ln())
            + (e.b.transpose() * inverse * &e.b).trace() / (2.0 * n * n)
            - 1.5 * gap / n;
        assert_relative_eq!(gp.bound().unwrap(), expected, max_relative = 1e-11);
        assert_relative_eq!(gp.bound_and_adjoint().unwrap().0, expected, max_relative = 1e-11);
    }

    #[test]
    fn adjoint_agrees_with_differences() {
        let e = Example::new();
        let (_, adjoint) = e.gp().bound_and_adjoint().unwrap();
        let h = 1e-6;
        let difference = |change: &dyn Fn(&mut Example, f64)| {
            let (mut up, mut down) = (Example::new(), Example::new());
            change(&mut up, h);
            change(&mut down, -h);
            (up.gp().bound().unwrap() - down.gp().bound().unwrap()) / (2.0 * h)
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
        let scalars = [adjoint.psi0, adjoint.second_moment, adjoint.noise];
        for (k, analytic) in scalars.into_iter().enumerate() {
            let d = difference(&|e, h| e.scalars[k] += h);
            assert_relative_eq!(analytic, d, epsilon = 1e-6, max_relative = 1e-6);
        }
    }

    #[test]
    fn posterior_is_the_formula_as_written() {
        let e = Example::new();
        let posterior = e.gp().posterior().unwrap();
        let inverse = (&e.k + &e.psi2 / 0.3).try_inverse().unwrap();
        assert_relative_eq!(posterior.mean, &e.k * &inverse * &e.b / 0.3, epsilon = 1e-10);
        assert_relative_eq!(posterior.covariance, symmetric(&e.k * inverse * &e.k), epsilon = 1e-10);
    }
}
