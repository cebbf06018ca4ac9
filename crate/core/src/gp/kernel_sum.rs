//! A weighted sum of kernels, prepared for many evaluations.

use crate::gp::Kernel;
use crate::gp::exp::exp;
use nalgebra::DMatrix;

/// f(x) = sum_a k(x, z_a) c_a, with inputs z [K x P] and coefficients c [K x C], plus a linear function if
/// one is added: the form of every mean prediction of a Gaussian process.
#[derive(Clone, Debug, PartialEq)]
pub struct KernelSum {
    /// Inputs z divided by the lengthscales, row after row [K x P].
    scaled: Vec<f64>,
    inverse_lengthscales: Vec<f64>,
    /// Coefficients times the signal variance, row after row [K x C].
    coefficients: Vec<f64>,
    outputs: usize,
    /// The linear function, row after row [P x C]; empty without one.
    slope: Vec<f64>,
}

impl KernelSum {
    /// The sum over inputs `z` [K x P] with `coefficients` [K x C].
    pub fn new(z: &DMatrix<f64>, kernel: &Kernel, coefficients: &DMatrix<f64>) -> Self {
        let inverse_lengthscales: Vec<f64> = kernel.lambda.iter().map(|l| 1.0 / l.sqrt()).collect();
        let mut scaled = Vec::with_capacity(z.len());
        for row in z.row_iter() {
            scaled.extend(row.iter().zip(&inverse_lengthscales).map(|(z, i)| z * i));
        }
        let mut weighted = Vec::with_capacity(coefficients.len());
        for row in coefficients.row_iter() {
            weighted.extend(row.iter().map(|c| c * kernel.variance));
        }
        Self {
            scaled,
            inverse_lengthscales,
            coefficients: weighted,
            outputs: coefficients.ncols(),
            slope: Vec::new(),
        }
    }

    /// This sum plus the linear function x -> `slope`^T x, `slope` [P x C].
    pub fn with_slope(mut self, slope: &DMatrix<f64>) -> Self {
        self.slope = slope.transpose().as_slice().to_vec();
        self
    }

    /// This sum times a `weight`.
    pub fn weighted(&self, weight: f64) -> Self {
        let mut sum = self.clone();
        sum.coefficients.iter_mut().chain(&mut sum.slope).for_each(|c| *c *= weight);
        sum
    }

    /// f at every row of `x` [T x P]: [T x C].
    pub fn at_rows(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        let mut row = vec![0.0; x.ncols()];
        let mut scratch = row.clone();
        let mut values = vec![0.0; self.outputs];
        let mut out = DMatrix::zeros(x.nrows(), self.outputs);
        for t in 0..x.nrows() {
            for (value, x) in row.iter_mut().zip(x.row(t).iter()) {
                *value = *x;
            }
            values.fill(0.0);
            self.add_to(&row, &mut scratch, &mut values);
            for (c, value) in values.iter().enumerate() {
                out[(t, c)] = *value;
            }
        }
        out
    }

    /// Adds f(x) `[C]` to `out`; `scratch` holds at least P numbers.
    pub(crate) fn add_to(&self, x: &[f64], scratch: &mut [f64], out: &mut [f64]) {
        let dims = self.inverse_lengthscales.len();
        for (x, slope) in x.iter().zip(self.slope.chunks_exact(self.outputs)) {
            for (out, s) in out.iter_mut().zip(slope) {
                *out += x * s;
            }
        }
        let scratch = &mut scratch[..dims];
        for ((s, x), i) in scratch.iter_mut().zip(x).zip(&self.inverse_lengthscales) {
            *s = x * i;
        }
        for (z, c) in self.scaled.chunks_exact(dims).zip(self.coefficients.chunks_exact(self.outputs)) {
            let d2: f64 = z.iter().zip(scratch.iter()).map(|(z, x)| (x - z) * (x - z)).sum();
            let k = exp(-0.5 * d2);
            for (out, c) in out.iter_mut().zip(c) {
                *out += k * c;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::dvector;

    #[test]
    fn agrees_with_the_cross_covariance_times_the_coefficients() {
        let kernel = Kernel { lambda: dvector![0.7, 2.0], variance: 1.6 };
        let z = DMatrix::from_fn(4, 2, |a, p| ((3 * a + p) as f64).sin());
        let c = DMatrix::from_fn(4, 3, |a, q| ((a + 5 * q) as f64).cos());
        let x = DMatrix::from_fn(5, 2, |t, p| ((t * 2 + p) as f64 * 0.3).cos());
        let sum = KernelSum::new(&z, &kernel, &c);
        let expected = kernel.cross_covariance(&x, &z) * &c;
        assert_relative_eq!(sum.at_rows(&x), expected, epsilon = 1e-13);
        assert_relative_eq!(sum.weighted(0.25).at_rows(&x), &expected * 0.25, epsilon = 1e-13);
        let slope = DMatrix::from_fn(2, 3, |p, q| (p + 3 * q) as f64);
        let with = sum.with_slope(&slope).weighted(2.0);
        assert_relative_eq!(with.at_rows(&x), (expected + &x * slope) * 2.0, epsilon = 1e-12);
    }
}
