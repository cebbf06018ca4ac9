//! Expected kernels of Gaussian inputs with a full covariance: the psi statistics of
//! Velychko et al. 2018, appendix B, for inputs of dependent dimensions. For independent dimensions
//! [`psi`](crate::gp::psi) computes the same, and faster.

use crate::elementary::Elementary;
use crate::gp::linalg::Factor;
use crate::gp::{Kernel, NumericsError};
use nalgebra::{DMatrix, DVector};

/// A kernel with its inducing inputs z [K x P].
#[derive(Clone, Copy, Debug)]
pub struct Basis<'a> {
    /// Inducing inputs [K x P].
    pub z: &'a DMatrix<f64>,
    /// The kernel over P dimensions.
    pub kernel: &'a Kernel,
}

/// Expectations of a kernel under an uncertain input x ~ N(m, V).
#[derive(Clone, Debug)]
pub struct ExpectedKernels {
    /// `E[k(x, z_a)]` `[K]`.
    pub psi1: DVector<f64>,
    /// (V + Lambda)^-1 (z_a - m), a column each [P x K]: for every h that is jointly Gaussian with x,
    /// cov(h, k(x, z_a)) = cov(h, x) times this column times psi1_a.
    pub pulls: DMatrix<f64>,
}

/// The expectations of one kernel under x ~ N(`mean` `[P]`, `covariance` [P x P]).
///
/// psi1_a = sigma^2 |Lambda|^(1/2) |V + Lambda|^(-1/2) exp( -1/2 (z_a - m)^T (V + Lambda)^-1 (z_a - m) )
///
/// # Errors
///
/// When the covariance is not positive semidefinite, or holds numbers that are not finite.
pub fn expected_kernels(
    basis: Basis,
    mean: &DVector<f64>,
    covariance: &DMatrix<f64>,
) -> Result<ExpectedKernels, NumericsError> {
    let mut spread = covariance.clone();
    add_diagonal(&mut spread, 0, &basis.kernel.lambda);
    let factor = Factor::new(&spread, "covariance of the uncertain latents")?;
    let distances = distances(basis.z, mean);
    let pulls = factor.solve(&distances);
    let scale =
        basis.kernel.variance * (0.5 * (log_product(basis.kernel) - factor.log_determinant())).exponential();
    let psi1 = DVector::from_fn(basis.z.nrows(), |a, _| {
        scale * (-0.5 * distances.column(a).dot(&pulls.column(a))).exponential()
    });
    Ok(ExpectedKernels { psi1, pulls })
}

/// `E[k(x, z_a) k'(x', z'_b)]` [K x K'] of two kernels whose inputs are jointly Gaussian, with means `[P]`
/// and `[P']` and the covariance `joint` [(P + P') x (P + P')] of both. If both are the same input, all four
/// blocks are equal.
///
/// With y = (x, x'), its covariance V and W = diag(Lambda, Lambda'), the product of the kernels is a Gaussian
/// in y: sigma^2 sigma'^2 |W|^(1/2) |V + W|^(-1/2) exp( -1/2 d^T (V + W)^-1 d ), d = (z_a, z'_b) - `E[y]`.
///
/// # Errors
///
/// When the covariance is not positive semidefinite, or holds numbers that are not finite.
pub fn expected_products(
    first: (Basis, &DVector<f64>),
    second: (Basis, &DVector<f64>),
    joint: &DMatrix<f64>,
) -> Result<DMatrix<f64>, NumericsError> {
    let ((basis, mean), (other, other_mean)) = (first, second);
    let p = basis.z.ncols();
    let mut spread = joint.clone();
    add_diagonal(&mut spread, 0, &basis.kernel.lambda);
    add_diagonal(&mut spread, p, &other.kernel.lambda);
    let factor = Factor::new(&spread, "covariance of the uncertain latents")?;
    // L^-1 d = L^-1 (z_a - m, 0) + L^-1 (0, z'_b - m'): the quadratic form of a pair needs one dot
    // product.
    let whitened = |distances: DMatrix<f64>, at: usize| {
        let mut tall = DMatrix::zeros(spread.nrows(), distances.ncols());
        tall.rows_mut(at, distances.nrows()).copy_from(&distances);
        factor.solve_lower_mut(&mut tall);
        tall
    };
    let (a, b) = (whitened(distances(basis.z, mean), 0), whitened(distances(other.z, other_mean), p));
    let squares = |m: &DMatrix<f64>| m.column_iter().map(|column| column.norm_squared()).collect::<Vec<_>>();
    let (a2, b2) = (squares(&a), squares(&b));
    let log_w = log_product(basis.kernel) + log_product(other.kernel);
    let scale = basis.kernel.variance
        * other.kernel.variance
        * (0.5 * (log_w - factor.log_determinant())).exponential();
    let product = |i: usize, j: usize| {
        let both = a.column(i).dot(&b.column(j));
        scale * (-0.5 * (a2[i] + b2[j]) - both).exponential()
    };
    Ok(DMatrix::from_fn(a.ncols(), b.ncols(), product))
}

/// z_a - m, a column each [P x K].
fn distances(z: &DMatrix<f64>, mean: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(z.ncols(), z.nrows(), |q, a| z[(a, q)] - mean[q])
}

/// log |Lambda|.
fn log_product(kernel: &Kernel) -> f64 {
    kernel.lambda.iter().map(|lambda| lambda.logarithm()).sum()
}

fn add_diagonal(matrix: &mut DMatrix<f64>, at: usize, values: &DVector<f64>) {
    for (q, value) in values.iter().enumerate() {
        matrix[(at + q, at + q)] += value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::dvector;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    fn example() -> (Kernel, DMatrix<f64>, Kernel, DMatrix<f64>) {
        let kernel = Kernel { lambda: dvector![0.9, 2.0], variance: 1.0 };
        let other = Kernel { lambda: dvector![1.4], variance: 0.7 };
        let z = DMatrix::from_row_slice(3, 2, &[0.1, -0.4, 1.2, 0.3, -0.8, 0.9]);
        (kernel, z, other, DMatrix::from_row_slice(2, 1, &[0.5, -0.7]))
    }

    /// The covariance of three inputs: two of the first kernel, one of the second.
    fn joint() -> DMatrix<f64> {
        let a = DMatrix::from_row_slice(3, 3, &[0.5, 0.1, -0.2, 0.0, 0.4, 0.3, 0.0, 0.0, 0.6]);
        &a * a.transpose()
    }

    #[test]
    fn expectations_agree_with_averages_of_draws() {
        let (kernel, z, other, z2) = example();
        let (first, second) = (Basis { z: &z, kernel: &kernel }, Basis { z: &z2, kernel: &other });
        let (mean, mean2, joint) = (dvector![0.2, -0.1], dvector![0.4], joint());
        let expected = expected_kernels(first, &mean, &joint.view((0, 0), (2, 2)).into_owned()).unwrap();
        let products = expected_products((first, &mean), (second, &mean2), &joint).unwrap();
        let covariances = joint.view((2, 0), (1, 2)) * &expected.pulls;

        let root = joint.clone().cholesky().unwrap().unpack();
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let draws = 200_000;
        let (mut psi1, mut both, mut with_h) = (DVector::zeros(3), DMatrix::zeros(3, 2), DVector::zeros(3));
        for _ in 0..draws {
            let noise = DVector::from_fn(3, |_, _| StandardNormal.sample(&mut rng));
            let y: DVector<f64> = &root * noise;
            let x = DMatrix::from_row_slice(1, 2, &[mean[0] + y[0], mean[1] + y[1]]);
            let k = kernel.cross_covariance(&x, &z).transpose();
            let k2 = other.cross_covariance(&DMatrix::from_element(1, 1, mean2[0] + y[2]), &z2);
            psi1 += k.column(0);
            with_h += k.column(0) * y[2];
            both += &k * k2;
        }
        let count = f64::from(draws);
        // Half a percent is more than four standard errors of these averages.
        assert_relative_eq!(psi1 / count, expected.psi1, epsilon = 3e-3);
        assert_relative_eq!(both / count, products, epsilon = 3e-3);
        for a in 0..3 {
            assert_relative_eq!(with_h[a] / count, covariances[(0, a)] * expected.psi1[a], epsilon = 3e-3);
        }
    }

    #[test]
    fn independent_dimensions_give_the_psi_statistics() {
        let (kernel, z, ..) = example();
        let basis = Basis { z: &z, kernel: &kernel };
        let (mean, variance) = (dvector![0.3, -0.5], dvector![0.2, 0.05]);
        let v = DMatrix::from_diagonal(&variance);
        let joint = DMatrix::from_fn(4, 4, |r, c| v[(r % 2, c % 2)]);
        let psi1 = expected_kernels(basis, &mean, &v).unwrap().psi1;
        let psi2 = expected_products((basis, &mean), (basis, &mean), &joint).unwrap();
        // Equations (A16) and (A17) of Velychko et al. 2018, for a diagonal S.
        for a in 0..3 {
            let (mut scale, mut form) = (1.0, 0.0);
            for q in 0..2 {
                let wide = kernel.lambda[q] + variance[q];
                scale *= (kernel.lambda[q] / wide).sqrt();
                form += (mean[q] - z[(a, q)]).powi(2) / wide;
            }
            assert_relative_eq!(psi1[a], scale * (-0.5 * form).exp(), epsilon = 1e-13);
            for b in 0..3 {
                let (mut scale, mut form) = (1.0, 0.0);
                for q in 0..2 {
                    let wide = kernel.lambda[q] + 2.0 * variance[q];
                    scale *= (kernel.lambda[q] / wide).sqrt();
                    form += (z[(a, q)] - z[(b, q)]).powi(2) / (4.0 * kernel.lambda[q])
                        + (mean[q] - (z[(a, q)] + z[(b, q)]) / 2.0).powi(2) / wide;
                }
                assert_relative_eq!(psi2[(a, b)], scale * (-form).exp(), epsilon = 1e-13);
            }
        }
    }

    #[test]
    fn a_certain_input_gives_the_kernel_itself() {
        let (kernel, z, other, z2) = example();
        let (mean, mean2) = (dvector![0.2, -0.1], dvector![0.4]);
        let (first, second) = (Basis { z: &z, kernel: &kernel }, Basis { z: &z2, kernel: &other });
        let products = expected_products((first, &mean), (second, &mean2), &DMatrix::zeros(3, 3)).unwrap();
        let k = kernel.cross_covariance(&DMatrix::from_row_slice(1, 2, mean.as_slice()), &z);
        let k2 = other.cross_covariance(&DMatrix::from_row_slice(1, 1, mean2.as_slice()), &z2);
        assert_relative_eq!(products, k.tr_mul(&k2), epsilon = 1e-14);
    }
}
