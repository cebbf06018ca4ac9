//! Log density of observations under a Gaussian process of any covariance, with its adjoints.
//!
//! log N(T; 0, C) over the columns of T = - R c/2 log(2 pi) - c/2 log|C| - 1/2 tr( T^T C^-1 T ), for R rows
//! and c columns (Rasmussen & Williams 2006, 5.8 and 5.9).

use crate::elementary::Elementary;
use crate::gp::NumericsError;
use crate::gp::linalg::Factor;
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// Adjoints of log N(T; 0, C).
pub struct DensityAdjoint {
    /// dF/dC = 1/2 ( C^-1 T T^T C^-1 - c C^-1 ) [R x R], symmetric.
    pub covariance: DMatrix<f64>,
    /// dF/dT = - C^-1 T [R x c].
    pub targets: DMatrix<f64>,
}

fn value(factor: &Factor, targets: &DMatrix<f64>) -> f64 {
    let (rows, columns) = (targets.nrows() as f64, targets.ncols() as f64);
    let fit = factor.solve_lower(targets).norm_squared();
    -0.5 * (rows * columns * TAU.logarithm() + columns * factor.log_determinant() + fit)
}

/// log N(`targets`; 0, `covariance`), in nats; `covariance` [R x R] has the noise on its diagonal.
pub fn log_density(
    covariance: &DMatrix<f64>,
    targets: &DMatrix<f64>,
    what: &'static str,
) -> Result<f64, NumericsError> {
    Ok(value(&Factor::of_large(covariance, what)?, targets))
}

/// The log density with its adjoints.
pub fn log_density_and_adjoint(
    covariance: &DMatrix<f64>,
    targets: &DMatrix<f64>,
    what: &'static str,
) -> Result<(f64, DensityAdjoint), NumericsError> {
    let factor = Factor::of_large(covariance, what)?;
    let mut inverse = factor.inverse();
    let solved = &inverse * targets;
    inverse.gemm(0.5, &solved, &solved.transpose(), -0.5 * targets.ncols() as f64);
    let adjoint = DensityAdjoint { covariance: inverse, targets: -solved };
    Ok((value(&factor, targets), adjoint))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn example() -> (DMatrix<f64>, DMatrix<f64>) {
        let root = DMatrix::from_fn(5, 5, |i, j| ((3 * i + 5 * j) as f64).sin());
        let covariance = &root * root.transpose() + DMatrix::identity(5, 5) * 0.3;
        (covariance, DMatrix::from_fn(5, 2, |i, j| ((i + 4 * j) as f64).cos()))
    }

    #[test]
    fn value_agrees_with_the_formula() {
        let (c, t) = example();
        let expected = -0.5
            * (10.0 * TAU.ln()
                + 2.0 * c.determinant().ln()
                + (t.transpose() * c.clone().try_inverse().unwrap() * &t).trace());
        assert_relative_eq!(log_density(&c, &t, "test").unwrap(), expected, max_relative = 1e-12);
        let both = log_density_and_adjoint(&c, &t, "test").unwrap();
        assert_relative_eq!(both.0, expected, max_relative = 1e-12);
    }

    #[test]
    fn adjoint_agrees_with_differences() {
        let (c, t) = example();
        let (_, adjoint) = log_density_and_adjoint(&c, &t, "test").unwrap();
        let h = 1e-6;
        let f = |c: &DMatrix<f64>, t: &DMatrix<f64>| log_density(c, t, "test").unwrap();
        for i in 0..5 {
            for j in 0..=i {
                let bumped = |h: f64| {
                    let mut c = c.clone();
                    c[(i, j)] += h;
                    c[(j, i)] = c[(i, j)];
                    f(&c, &t)
                };
                let twice = if i == j { 1.0 } else { 2.0 };
                let difference = (bumped(h) - bumped(-h)) / (2.0 * h);
                assert_relative_eq!(
                    twice * adjoint.covariance[(i, j)],
                    difference,
                    epsilon = 1e-7,
                    max_relative = 1e-7
                );
            }
            for j in 0..2 {
                let bumped = |h: f64| {
                    let mut t = t.clone();
                    t[(i, j)] += h;
                    f(&c, &t)
                };
                let difference = (bumped(h) - bumped(-h)) / (2.0 * h);
                assert_relative_eq!(adjoint.targets[(i, j)], difference, epsilon = 1e-7, max_relative = 1e-7);
            }
        }
    }
}
