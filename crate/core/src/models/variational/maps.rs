//! The maps of a fitted model: pose maps and experts, with the posteriors of their inducing outputs.

use crate::gp::bound::InducingPosterior;
use crate::gp::linalg::Factor;
use crate::gp::{Kernel, KernelSum, NumericsError};
use crate::models::variational::column_noise::column_noise;
use crate::models::variational::elbo::{Objective, Posteriors, stack_offsets};
use crate::models::variational::params::{Expert, Params, PartParams};
use nalgebra::DMatrix;

/// The pose map g^i of one part, with the posterior of its inducing outputs v: y = `k(x, r) K_rr^-1 E[v]`.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseMap {
    r: DMatrix<f64>,
    kernel: Kernel,
    beta: f64,
    column_noise: Vec<f64>,
    mean: DMatrix<f64>,
    covariance: DMatrix<f64>,
    /// k(x, r) K_rr^-1 `E[v]`.
    sum: KernelSum,
}

impl PoseMap {
    /// A map with inducing inputs `r` [L x Q], its kernel, the observation noise variance `beta`, the `mean`
    /// `E[v]` [L x D] and the `covariance` of every column of v [L x L]. `jitter` times the signal variance
    /// is added to the diagonal of K_rr.
    ///
    /// # Errors
    ///
    /// When K_rr cannot be factorised.
    pub fn new(
        r: DMatrix<f64>,
        kernel: Kernel,
        beta: f64,
        mean: DMatrix<f64>,
        covariance: DMatrix<f64>,
        jitter: f64,
    ) -> Result<Self, NumericsError> {
        let k = kernel.inducing_covariance(&r, jitter);
        let coefficients = Factor::new(&k, "covariance of the pose inducing points")?.solve(&mean);
        let sum = KernelSum::new(&r, &kernel, &coefficients);
        Ok(Self { r, kernel, beta, column_noise: Vec::new(), mean, covariance, sum })
    }

    /// The map with these noise variances of the columns `[D]`; if empty, beta is that of each column.
    pub fn with_column_noise(mut self, column_noise: Vec<f64>) -> Self {
        self.column_noise = column_noise;
        self
    }

    /// The map of a part at its parameters, with the posterior of v there.
    pub(super) fn fitted(
        part: &PartParams,
        v: &InducingPosterior,
        jitter: f64,
    ) -> Result<Self, NumericsError> {
        let (mean, covariance) = (v.mean.clone(), v.covariance.clone());
        Self::new(part.r.clone(), part.kernel.clone(), part.beta, mean, covariance, jitter)
    }

    /// Pose inducing inputs r [L x Q].
    pub fn r(&self) -> &DMatrix<f64> {
        &self.r
    }

    /// The kernel of the map.
    pub fn kernel(&self) -> &Kernel {
        &self.kernel
    }

    /// Observation noise variance beta.
    pub fn beta(&self) -> f64 {
        self.beta
    }

    /// The noise variance of each column `[D]`, measured on training sequences that the map did not see: the
    /// bands of columns use it in place of beta. Empty in models of earlier versions.
    pub fn column_noise(&self) -> &[f64] {
        &self.column_noise
    }

    /// Whether both maps give the same columns at the same latents. Their noise variances of columns may differ.
    pub(in crate::models) fn is_same_map(&self, other: &Self) -> bool {
        other == &self.clone().with_column_noise(other.column_noise.clone())
    }

    /// Mean `E[v]` of the inducing outputs [L x D].
    pub fn mean(&self) -> &DMatrix<f64> {
        &self.mean
    }

    /// Covariance of every column of the inducing outputs v [L x L].
    pub fn covariance(&self) -> &DMatrix<f64> {
        &self.covariance
    }

    /// K_rr^-1 `E[v]` [L x D], by which the kernels of a latent point are multiplied; `jitter` as in
    /// [`new`](Self::new).
    ///
    /// # Errors
    ///
    /// When K_rr cannot be factorised.
    pub(in crate::models) fn coefficients(&self, jitter: f64) -> Result<DMatrix<f64>, NumericsError> {
        let k = self.kernel.inducing_covariance(&self.r, jitter);
        Ok(Factor::new(&k, "covariance of the pose inducing points")?.solve(&self.mean))
    }

    /// Count of numbers needed for a prediction with the map: inducing inputs, posterior means, kernel.
    pub(in crate::models) fn stored_numbers(&self) -> usize {
        self.r.len() + self.mean.len() + self.kernel.lambda.len() + 1
    }

    /// The columns of the part at its latents `x` [T x Q]: [T x D], without the column means.
    pub fn observations(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        self.sum.at_rows(x)
    }
}

/// The expert f^{ji}, the prediction of part j about part i, with the posterior mean of its inducing outputs
/// u: f(x) = `k(x, z) K_zz^-1 E[u]`.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedExpert {
    z: DMatrix<f64>,
    kernel: Kernel,
    mean: DMatrix<f64>,
    /// K_zz [K x K].
    k: DMatrix<f64>,
    /// k(x, z) K_zz^-1 `E[u]`, which no coupling changes.
    sum: KernelSum,
}

impl FittedExpert {
    /// An expert with inducing inputs `z` [K x pQ_j], its kernel of signal variance 1, and the `mean` `E[u]`
    /// [K x Q_i]. `jitter` is added to the diagonal of K_zz.
    ///
    /// # Errors
    ///
    /// When K_zz cannot be factorised.
    pub fn new(
        z: DMatrix<f64>,
        kernel: Kernel,
        mean: DMatrix<f64>,
        jitter: f64,
    ) -> Result<Self, NumericsError> {
        let k = kernel.inducing_covariance(&z, jitter);
        let coefficients = Factor::new(&k, "covariance of the dynamics inducing points")?.solve(&mean);
        let sum = KernelSum::new(&z, &kernel, &coefficients);
        Ok(Self { z, kernel, mean, k, sum })
    }

    /// Dynamics inducing inputs z [K x pQ_j], oldest state first.
    pub fn z(&self) -> &DMatrix<f64> {
        &self.z
    }

    /// The kernel of the expert; its signal variance is 1.
    pub fn kernel(&self) -> &Kernel {
        &self.kernel
    }

    /// Mean `E[u]` of the inducing outputs [K x Q_i].
    pub fn mean(&self) -> &DMatrix<f64> {
        &self.mean
    }

    /// Count of numbers needed for a prediction with the expert: inducing inputs, posterior means, kernel.
    pub(in crate::models) fn stored_numbers(&self) -> usize {
        self.z.len() + self.mean.len() + self.kernel.lambda.len()
    }

    /// f(x) = `k(x, z) K_zz^-1 E[u]`.
    pub(in crate::models) fn sum(&self) -> &KernelSum {
        &self.sum
    }

    /// K_zz [K x K].
    pub(in crate::models) fn k(&self) -> &DMatrix<f64> {
        &self.k
    }
}

/// The maps of a model: those of the parts, and of each primitive's experts.
pub(in crate::models) struct FittedMaps {
    /// The pose map of each part `[M]`.
    pub(in crate::models) parts: Vec<PoseMap>,
    /// Experts by primitive and target.
    pub(in crate::models) experts: Vec<Vec<FittedExpert>>,
}

impl FittedMaps {
    /// The maps at `params` of an objective, where these are the posteriors of their inducing outputs.
    pub(in crate::models) fn new(
        params: &Params,
        posteriors: &Posteriors,
        objective: &Objective,
    ) -> Result<Self, NumericsError> {
        let jitter = objective.jitter();
        let parts = params.parts.iter().zip(&posteriors.kinematics).enumerate().map(|(i, (part, v))| {
            let noise = column_noise(objective, params, i)?;
            Ok(PoseMap::fitted(part, v, jitter)?.with_column_noise(noise))
        });
        let offsets: Vec<_> = (0..params.part_count()).map(|i| expert_offsets(params, i)).collect();
        let expert = |a: usize, (i, expert): (usize, &Expert)| {
            let mean = posteriors.dynamics[i].mean.rows(offsets[i][a], expert.z.nrows()).into_owned();
            FittedExpert::new(expert.z.clone(), expert.kernel.clone(), mean, jitter)
        };
        let row = |(a, row): (usize, &Vec<Expert>)| row.iter().enumerate().map(|e| expert(a, e)).collect();
        let experts = params.experts.iter().enumerate().map(row);
        Ok(Self { parts: parts.collect::<Result<_, _>>()?, experts: experts.collect::<Result<_, _>>()? })
    }
}

/// The places where the experts about part `i` start in the stack of all primitives, then its height.
pub(in crate::models) fn expert_offsets(params: &Params, i: usize) -> Vec<usize> {
    stack_offsets(params.experts.iter().map(|row| row[i].z.nrows()))
}
