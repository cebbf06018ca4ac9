//! The ARD squared exponential kernel: values and adjoints.

use crate::gp::exp::exp;
use nalgebra::{DMatrix, DVector};

/// An ARD squared exponential kernel over P input dimensions (Velychko et al. 2018, A9: "ARD RBF"). The papers
/// call that of the pose maps a radial basis function; ours has a lengthscale for each dimension there too.
///
/// k(x, x') = variance * exp( -1/2 sum_q (x_q - x'_q)^2 / lambda_q )
///
/// ```
/// use nalgebra::{DMatrix, dvector};
/// use vcgpdm_core::gp::Kernel;
///
/// // Lengthscale 2 in the first dimension, 1 in the second: lambda holds their squares.
/// let kernel = Kernel { lambda: dvector![4.0, 1.0], variance: 0.5 };
/// let x = DMatrix::from_row_slice(1, 2, &[0.0, 0.0]);
/// let z = DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 0.0, 1.0]);
/// let k = kernel.cross_covariance(&x, &z);
/// // One lengthscale away in either dimension.
/// assert!((k[(0, 0)] - 0.5 * (-0.5_f64).exp()).abs() < 1e-12);
/// assert!((k[(0, 1)] - k[(0, 0)]).abs() < 1e-12);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Kernel {
    /// Squared lengthscales, one per input dimension `[P]`.
    pub lambda: DVector<f64>,
    /// Signal variance sigma^2. It is 1 for every dynamics kernel: otherwise a larger scale of an expert
    /// with a smaller weight would be the same model, and the couplings would have no meaning.
    pub variance: f64,
}

impl Kernel {
    /// The covariance of the inducing inputs `z` [K x P] with themselves, with `jitter` times the variance on
    /// its diagonal.
    pub fn inducing_covariance(&self, z: &DMatrix<f64>, jitter: f64) -> DMatrix<f64> {
        let mut k = DMatrix::zeros(z.nrows(), z.nrows());
        self.inducing_covariance_into(z, jitter, &mut k);
        k
    }

    /// Writes the [`inducing_covariance`](Self::inducing_covariance) into `k` [K x K].
    pub fn inducing_covariance_into(&self, z: &DMatrix<f64>, jitter: f64, k: &mut DMatrix<f64>) {
        let n = z.nrows();
        // Column by column below the diagonal: the inner loops then read contiguous memory.
        for b in 0..n {
            let column = &mut k.as_mut_slice()[b * n + b + 1..(b + 1) * n];
            column.fill(0.0);
            for q in 0..z.ncols() {
                let (at, lambda) = (z[(b, q)], self.lambda[q]);
                for (d2, x) in column.iter_mut().zip(&z.as_slice()[q * n + b + 1..(q + 1) * n]) {
                    *d2 += (x - at) * (x - at) / lambda;
                }
            }
            for d2 in column {
                *d2 = self.variance * exp(-0.5 * *d2);
            }
            k[(b, b)] = self.variance * (1.0 + jitter);
        }
        k.fill_upper_triangle_with_lower_triangle();
    }

    /// The covariance of the points `x` [N x P] with the inducing inputs `z` [K x P]: [N x K].
    pub fn cross_covariance(&self, x: &DMatrix<f64>, z: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(x.nrows(), z.nrows(), |t, a| {
            let d2: f64 = (0..z.ncols()).map(|q| (x[(t, q)] - z[(a, q)]).powi(2) / self.lambda[q]).sum();
            self.variance * exp(-0.5 * d2)
        })
    }

    /// The backward pass of [`inducing_covariance`](Self::inducing_covariance): from `df_dk` [K x K]
    /// (symmetric), dF with respect to the covariance `k`, to dF with respect to `z` and the kernel, which is
    /// added to `into`.
    pub fn inducing_covariance_adjoint(
        &self,
        z: &DMatrix<f64>,
        k: &DMatrix<f64>,
        jitter: f64,
        df_dk: &DMatrix<f64>,
        into: &mut KernelAdjoint,
    ) {
        let n = z.nrows();
        let mut total = 0.0;
        for a in 0..n {
            total += df_dk[(a, a)] * (1.0 + jitter) * self.variance;
            for b in 0..a {
                let h = 2.0 * df_dk[(a, b)] * k[(a, b)];
                total += h;
                for q in 0..z.ncols() {
                    let d = (z[(a, q)] - z[(b, q)]) / self.lambda[q];
                    into.z[(a, q)] -= h * d;
                    into.z[(b, q)] += h * d;
                    into.lambda[q] += 0.5 * h * d * d;
                }
            }
        }
        into.variance += total / self.variance;
    }

    /// The backward pass of [`inducing_covariance`](Self::inducing_covariance) without jitter, for many
    /// points `x` [N x P]: three products of matrices instead of loops over pairs. `df_dk` [N x N]
    /// (symmetric) is overwritten.
    pub fn covariance_adjoint(
        &self,
        x: &DMatrix<f64>,
        k: &DMatrix<f64>,
        df_dk: &mut DMatrix<f64>,
    ) -> KernelAdjoint {
        df_dk.component_mul_assign(k);
        // h_ab = dF/dk_ab k_ab: sum_b h_ab (x_a - x_b) = x_a sum_b h_ab - (h x)_a.
        let rows = df_dk.column_sum();
        let hx = &*df_dk * x;
        let mut adjoint = KernelAdjoint::zeros(x.nrows(), x.ncols());
        for q in 0..x.ncols() {
            for a in 0..x.nrows() {
                let pull = x[(a, q)] * rows[a] - hx[(a, q)];
                adjoint.z[(a, q)] = -2.0 * pull / self.lambda[q];
                adjoint.lambda[q] += x[(a, q)] * pull;
            }
            adjoint.lambda[q] /= self.lambda[q] * self.lambda[q];
        }
        adjoint.variance = rows.sum() / self.variance;
        adjoint
    }
}

/// dF with respect to a kernel and its inducing inputs, where F is any function of the covariances.
#[derive(Clone, Debug)]
pub struct KernelAdjoint {
    /// dF/dz [K x P].
    pub z: DMatrix<f64>,
    /// dF/dlambda `[P]`.
    pub lambda: DVector<f64>,
    /// dF/dvariance.
    pub variance: f64,
}

impl KernelAdjoint {
    /// All zero, for `ips` inducing inputs of `dims` dimensions.
    pub fn zeros(ips: usize, dims: usize) -> Self {
        Self { z: DMatrix::zeros(ips, dims), lambda: DVector::zeros(dims), variance: 0.0 }
    }

    /// Adds these derivatives to those of a gradient that has the form of `z` and a kernel.
    pub fn add_to(&self, z: &mut DMatrix<f64>, kernel: &mut Kernel) {
        *z += &self.z;
        kernel.lambda += &self.lambda;
        kernel.variance += self.variance;
    }

    /// Sets all entries to zero.
    pub fn set_zero(&mut self) {
        self.z.fill(0.0);
        self.lambda.fill(0.0);
        self.variance = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn example() -> (Kernel, DMatrix<f64>) {
        let kernel = Kernel { lambda: nalgebra::dvector![0.7, 2.1], variance: 1.3 };
        let z = DMatrix::from_row_slice(3, 2, &[0.1, -0.4, 1.2, 0.3, -0.8, 0.9]);
        (kernel, z)
    }

    #[test]
    fn inducing_covariance_agrees_with_the_cross_covariance() {
        let (kernel, z) = example();
        assert_relative_eq!(
            kernel.inducing_covariance(&z, 0.0),
            kernel.cross_covariance(&z, &z),
            epsilon = 1e-14
        );
    }

    #[test]
    fn adjoint_agrees_with_differences() {
        let (kernel, z) = example();
        let g = DMatrix::from_row_slice(3, 3, &[0.3, -0.2, 0.7, -0.2, 1.1, 0.4, 0.7, 0.4, -0.5]);
        let jitter = 1e-2;
        let f = |kernel: &Kernel, z: &DMatrix<f64>| kernel.inducing_covariance(z, jitter).dot(&g);
        let mut adjoint = KernelAdjoint::zeros(3, 2);
        kernel.inducing_covariance_adjoint(
            &z,
            &kernel.inducing_covariance(&z, jitter),
            jitter,
            &g,
            &mut adjoint,
        );
        let h = 1e-6;
        for a in 0..3 {
            for q in 0..2 {
                let (mut up, mut down) = (z.clone(), z.clone());
                up[(a, q)] += h;
                down[(a, q)] -= h;
                let difference = (f(&kernel, &up) - f(&kernel, &down)) / (2.0 * h);
                assert_relative_eq!(adjoint.z[(a, q)], difference, epsilon = 1e-8);
            }
        }
        for q in 0..2 {
            let (mut up, mut down) = (kernel.clone(), kernel.clone());
            up.lambda[q] += h;
            down.lambda[q] -= h;
            assert_relative_eq!(adjoint.lambda[q], (f(&up, &z) - f(&down, &z)) / (2.0 * h), epsilon = 1e-8);
        }
        let (mut up, mut down) = (kernel.clone(), kernel.clone());
        up.variance += h;
        down.variance -= h;
        assert_relative_eq!(adjoint.variance, (f(&up, &z) - f(&down, &z)) / (2.0 * h), epsilon = 1e-8);
    }

    #[test]
    fn both_adjoints_agree() {
        let (kernel, z) = example();
        let g = DMatrix::from_row_slice(3, 3, &[0.3, -0.2, 0.7, -0.2, 1.1, 0.4, 0.7, 0.4, -0.5]);
        let k = kernel.inducing_covariance(&z, 0.0);
        let mut expected = KernelAdjoint::zeros(3, 2);
        kernel.inducing_covariance_adjoint(&z, &k, 0.0, &g, &mut expected);
        let adjoint = kernel.covariance_adjoint(&z, &k, &mut g.clone());
        assert_relative_eq!(adjoint.z, expected.z, epsilon = 1e-12);
        assert_relative_eq!(adjoint.lambda, expected.lambda, epsilon = 1e-12);
        assert_relative_eq!(adjoint.variance, expected.variance, epsilon = 1e-12);
    }
}
