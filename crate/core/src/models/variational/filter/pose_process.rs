//! The pose map of a part with its uncertainty, at certain and at uncertain latents.

use crate::elementary::Elementary;
use crate::gp::exp::exp;
use crate::gp::linalg::{Factor, symmetrise};
use crate::gp::moments::{Basis, expected_kernels, expected_products};
use crate::gp::{Kernel, NumericsError};
use crate::models::variational::maps::PoseMap;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The pose map g^i of a part as a Gaussian process, given the posterior N(E\[v\], S) of its inducing outputs.
///
/// With a(x) = K^-1 k(r, x), the columns at a latent point x are independent, with means `E[v]`^T a(x) and the
/// common variance sigma^2 - k^T K^-1 k + a^T S a + beta (Titsias and Lawrence 2010). At uncertain
/// latents, the noise variance of a column replaces beta where the model has one for each column.
#[derive(Clone, Debug)]
pub(super) struct PoseProcess {
    r: DMatrix<f64>,
    kernel: Kernel,
    beta: f64,
    /// The noise variance of each column in its band `[D]`.
    column_noise: Vec<f64>,
    /// `E[v]` [L x D].
    outputs: DMatrix<f64>,
    /// K^-1 `E[v]` [L x D].
    coefficients: DMatrix<f64>,
    /// The factor of K.
    factor: Factor,
    /// S [L x L].
    covariance: DMatrix<f64>,
}

/// A Gaussian about the columns of a part in one frame.
#[derive(Clone, Debug)]
pub struct ColumnMoments {
    /// The mean `[D_i]`.
    pub mean: DVector<f64>,
    /// The covariance [D_i x D_i], the observation noise included.
    pub covariance: DMatrix<f64>,
}

/// The pose map near a latent point.
pub(super) struct Tangent {
    /// The value of each asked column.
    pub(super) values: Vec<f64>,
    /// Derivatives of the asked columns [Q x columns].
    pub(super) slopes: DMatrix<f64>,
    /// The variance of every column, the observation noise included.
    pub(super) variance: f64,
}

impl PoseProcess {
    pub(super) fn new(map: &PoseMap, jitter: f64) -> Result<Self, NumericsError> {
        let k = map.kernel().inducing_covariance(map.r(), jitter);
        let factor = Factor::new(&k, "covariance of the pose inducing points")?;
        Ok(Self {
            r: map.r().clone(),
            kernel: map.kernel().clone(),
            beta: map.beta(),
            column_noise: match map.column_noise() {
                [] => vec![map.beta(); map.mean().ncols()],
                noise => noise.to_vec(),
            },
            outputs: map.mean().clone(),
            coefficients: factor.solve(map.mean()),
            factor,
            covariance: map.covariance().clone(),
        })
    }

    /// Latent dimensions Q.
    pub(super) fn latent(&self) -> usize {
        self.r.ncols()
    }

    /// The number of columns D.
    pub(super) fn columns(&self) -> usize {
        self.coefficients.ncols()
    }

    /// Observation noise variance beta.
    pub(super) fn noise(&self) -> f64 {
        self.beta
    }

    /// Whether each column is anywhere larger than `least`: one that never changed in training is 0.
    pub(super) fn changing(&self, least: f64) -> Vec<bool> {
        self.outputs.column_iter().map(|column| column.amax() > least).collect()
    }

    /// The columns at latents `x` [T x Q]: [T x D].
    pub(super) fn observations(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        self.kernel.cross_covariance(x, &self.r) * &self.coefficients
    }

    /// Values and derivatives of these columns at a latent point x `[Q]`.
    pub(super) fn tangent(&self, x: &[f64], columns: &[usize]) -> Tangent {
        let (points, latent) = self.r.shape();
        let lambda = &self.kernel.lambda;
        let k = DVector::from_fn(points, |a, _| {
            let square: f64 = (0..latent).map(|q| (x[q] - self.r[(a, q)]).powi(2) / lambda[q]).sum();
            self.kernel.variance * exp(-0.5 * square)
        });
        let mut values = Vec::with_capacity(columns.len());
        let mut slopes = DMatrix::zeros(latent, columns.len());
        for (c, &column) in columns.iter().enumerate() {
            let mut value = 0.0;
            for (a, (k, w)) in k.iter().zip(self.coefficients.column(column).iter()).enumerate() {
                let term = k * w;
                value += term;
                for q in 0..latent {
                    slopes[(q, c)] += term * (self.r[(a, q)] - x[q]);
                }
            }
            values.push(value);
        }
        for (mut row, lambda) in slopes.row_iter_mut().zip(lambda) {
            row /= *lambda;
        }
        let mut weights = DMatrix::from_column_slice(points, 1, k.as_slice());
        self.factor.solve_mut(&mut weights);
        let explained = k.dot(&weights.column(0));
        let own = (&self.covariance * &weights).dot(&weights);
        Tangent { values, slopes, variance: self.beta + (self.kernel.variance - explained).max(0.0) + own }
    }

    /// The columns at uncertain latents with this `mean` `[Q]` and `covariance` [Q x Q]: with the
    /// psi statistics under full covariance, the mean psi1^T K^-1 `E[v]` and the covariance
    /// `E[v]`^T K^-1 (Psi2 - psi1 psi1^T) K^-1 `E[v]` + (sigma^2 - tr((K^-1 - K^-1 S K^-1) Psi2)) I + diag(noise),
    /// where noise is that of each column.
    pub(super) fn moments(
        &self,
        mean: &DVector<f64>,
        covariance: &DMatrix<f64>,
    ) -> Result<ColumnMoments, NumericsError> {
        let basis = Basis { z: &self.r, kernel: &self.kernel };
        let q = self.latent();
        let psi1 = expected_kernels(basis, mean, covariance)?.psi1;
        let twice = DMatrix::from_fn(2 * q, 2 * q, |a, b| covariance[(a % q, b % q)]);
        let mut psi2 = expected_products((basis, mean), (basis, mean), &twice)?;
        symmetrise(&mut psi2);
        let mut weights = self.factor.solve(&psi2);
        let explained = weights.trace();
        // K^-1 Psi2 K^-1 has moderate entries; those of K^-1 - K^-1 S K^-1 can be large.
        weights.transpose_mut();
        self.factor.solve_mut(&mut weights);
        let own = weights.dot(&self.covariance);
        let (gap, own) = ((self.kernel.variance - explained).max(0.0), own.max(0.0));
        psi2.ger(-1.0, &psi1, &psi1, 1.0);
        let mut spread = self.coefficients.tr_mul(&(psi2 * &self.coefficients));
        symmetrise(&mut spread);
        for d in 0..spread.nrows() {
            spread[(d, d)] = spread[(d, d)].max(0.0) + (self.column_noise[d] + gap + own);
        }
        Ok(ColumnMoments { mean: self.coefficients.tr_mul(&psi1), covariance: spread })
    }
}

impl ColumnMoments {
    /// log N(y; mean, covariance) of these columns of a row `[D_i]`, in nats.
    ///
    /// # Errors
    ///
    /// When the covariance cannot be factorised.
    pub fn log_density(&self, row: &[f64], columns: &[usize]) -> Result<f64, NumericsError> {
        let n = columns.len();
        let covariance = DMatrix::from_fn(n, n, |a, b| self.covariance[(columns[a], columns[b])]);
        let factor = Factor::new(&covariance, "covariance of the predicted columns")?;
        let mut error = DMatrix::from_fn(n, 1, |a, _| row[columns[a]] - self.mean[columns[a]]);
        factor.solve_lower_mut(&mut error);
        Ok(-0.5 * (error.norm_squared() + factor.log_determinant() + n as f64 * TAU.logarithm()))
    }
}
