//! Functions drawn from a Gaussian process, which can be evaluated at any input.

use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use vcgpdm_core::gp::linalg::Factor;
use vcgpdm_core::gp::{Kernel, NumericsError};

/// Jitter on the diagonal of the covariance of the supporting points.
const JITTER: f64 = 1e-6;

/// Noisy values of a function [N x C] at inputs [N x P], on which a draw is conditioned.
pub(super) struct Evidence {
    pub inputs: DMatrix<f64>,
    pub values: DMatrix<f64>,
    pub noise_variance: f64,
}

/// One draw of C independent functions of a zero-mean GP: f(x) = k(x, Z) c.
pub(super) struct DrawnFunction {
    kernel: Kernel,
    points: DMatrix<f64>,
    coefficients: DMatrix<f64>,
}

impl DrawnFunction {
    /// Draws `outputs` functions from the prior. They are exact at the `points` [K x P] and their conditional
    /// mean at other inputs, so the distance of the points should be less than a lengthscale.
    pub fn prior(
        kernel: Kernel,
        points: DMatrix<f64>,
        outputs: usize,
        random: &mut ChaCha8Rng,
    ) -> Result<Self, NumericsError> {
        let factor = factor(&kernel, &points, JITTER)?;
        // u = L e is a draw at the points, and K^-1 u = L^-T e.
        let mut coefficients = normal(points.nrows(), outputs, 1.0, random);
        factor.solve_upper_mut(&mut coefficients);
        Ok(Self { kernel, points, coefficients })
    }

    /// Makes a draw from the prior one from the posterior: interpolates the error of the draw at the
    /// evidence, and subtracts it (Matheron's rule).
    pub fn given(self, evidence: &Evidence, random: &mut ChaCha8Rng) -> Result<Self, NumericsError> {
        let Evidence { inputs, values, noise_variance } = evidence;
        let mut correction = values - self.at(inputs);
        correction -= normal(values.nrows(), values.ncols(), noise_variance.sqrt(), random);
        factor(&self.kernel, inputs, noise_variance / self.kernel.variance)?.solve_mut(&mut correction);
        let stack = |above: &DMatrix<f64>, below: &DMatrix<f64>| {
            let n = above.nrows();
            let mut stacked = DMatrix::zeros(n + below.nrows(), above.ncols());
            stacked.rows_mut(0, n).copy_from(above);
            stacked.rows_mut(n, below.nrows()).copy_from(below);
            stacked
        };
        Ok(Self {
            points: stack(&self.points, inputs),
            coefficients: stack(&self.coefficients, &correction),
            kernel: self.kernel,
        })
    }

    /// f at the rows of `x` [N x P]: [N x C].
    pub fn at(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        self.kernel.cross_covariance(x, &self.points) * &self.coefficients
    }
}

fn factor(kernel: &Kernel, points: &DMatrix<f64>, jitter: f64) -> Result<Factor, NumericsError> {
    Factor::new(&kernel.inducing_covariance(points, jitter), "covariance of a drawn function")
}

/// An isotropic kernel of variance 1 over two dimensions.
pub(super) fn rbf(lengthscale: f64) -> Kernel {
    Kernel { lambda: DVector::from_element(2, lengthscale * lengthscale), variance: 1.0 }
}

/// A square of `side` x `side` points in the plane, from -`reach` to `reach`.
pub(super) fn grid(side: usize, reach: f64) -> DMatrix<f64> {
    let place = |k: usize| reach * (2.0 * k as f64 / (side - 1) as f64 - 1.0);
    DMatrix::from_fn(side * side, 2, |k, c| place(if c == 0 { k % side } else { k / side }))
}

/// Independent normal numbers of mean 0 and this standard deviation.
pub(super) fn normal(rows: usize, columns: usize, deviation: f64, random: &mut ChaCha8Rng) -> DMatrix<f64> {
    let mut numbers = DMatrix::zeros(rows, columns);
    for number in numbers.as_mut_slice() {
        let standard: f64 = StandardNormal.sample(random);
        *number = deviation * standard;
    }
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use rand_chacha::rand_core::SeedableRng;

    #[test]
    fn draws_have_the_covariance_of_the_kernel() {
        let mut random = ChaCha8Rng::seed_from_u64(5);
        let draw = DrawnFunction::prior(rbf(1.0), grid(7, 2.4), 4000, &mut random).unwrap();
        // Between the supporting points, which are 0.8 apart.
        let x = DMatrix::from_row_slice(2, 2, &[0.3, -0.4, 1.0, 0.5]);
        let f = draw.at(&x);
        let found = &f * f.transpose() / 4000.0;
        assert_relative_eq!(found, rbf(1.0).cross_covariance(&x, &x), epsilon = 0.08);
    }

    #[test]
    fn draws_pass_through_their_evidence() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let evidence = Evidence {
            inputs: DMatrix::from_row_slice(2, 2, &[0.1, 0.2, -1.3, 0.7]),
            values: DMatrix::from_row_slice(2, 1, &[1.5, -0.5]),
            noise_variance: 1e-8,
        };
        let prior = DrawnFunction::prior(rbf(1.0), grid(7, 2.4), 1, &mut random).unwrap();
        let far = DMatrix::from_row_slice(1, 2, &[2.2, -2.3]);
        let before = prior.at(&far)[0];
        let draw = prior.given(&evidence, &mut random).unwrap();
        assert_relative_eq!(draw.at(&evidence.inputs), evidence.values, epsilon = 1e-3);
        assert!((draw.at(&far)[0] - before).abs() < 0.2, "a draw far from all evidence stays what it was");
    }
}
