//! Fitted MAP models, which predict by exact conditional means.
//!
//! `E[x^i_t]` = sum_j w_ji^2 k^{ji}(x^j_{-t}, X^j) C_i^-1 X^i and `E[y^i_t]` = k^i(x^i_t, X^i) (K^i + beta^i
//! I)^-1 Y^i: both are sums over all training frames with coefficients that are computed once.

use crate::gp::{Kernel, KernelSum, NumericsError};
use crate::models::data::sequences::Sequences;
use crate::models::map::density::{Dynamics, LogDensity};
use crate::models::map::params::MapParams;
use crate::models::rollout::couplings::{check_couplings, coupling_weights};
use crate::models::rollout::latent_dynamics::LatentDynamics;
use crate::models::rollout::request::{RolloutError, check_frames};
use crate::models::training::kind::ModelKind;
use nalgebra::DMatrix;

/// The pose map of one part.
#[derive(Clone, Debug, PartialEq)]
pub struct MapPoseMap {
    /// The latents of all training frames [N x Q].
    pub latents: DMatrix<f64>,
    /// Its kernel.
    pub kernel: Kernel,
    /// (K + beta I)^-1 Y [N x D].
    pub coefficients: DMatrix<f64>,
}

/// A trained MAP GPDM (one part) or MAP CGPDM.
#[derive(Clone, Debug)]
pub struct MapModel {
    sequences: Sequences,
    parts: Vec<MapPoseMap>,
    dynamics: Vec<Vec<Kernel>>,
    coefficients: Vec<DMatrix<f64>>,
    linear: DMatrix<f64>,
    alpha: DMatrix<f64>,
    latent_dynamics: LatentDynamics,
    poses: Vec<KernelSum>,
}

impl MapModel {
    /// The model at `params`.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn fit(density: &LogDensity, params: &MapParams) -> Result<Self, NumericsError> {
        let poses = density.pose_coefficients(params)?;
        let latents: Vec<&DMatrix<f64>> = params.parts.iter().map(|part| &part.latents).collect();
        let parts = params.parts.iter().zip(poses).map(|(part, coefficients)| MapPoseMap {
            latents: part.latents.clone(),
            kernel: part.kernel.clone(),
            coefficients,
        });
        Ok(Self::new(
            density.sequences().clone(),
            parts.collect(),
            params.dynamics.clone(),
            Dynamics::from(params).coefficients(density.sequences(), &latents)?,
            params.linear.clone(),
            params.alpha.clone(),
        ))
    }

    /// The model with the kernels `dynamics[source][target]`, the `coefficients[target]` C_i^-1 X^i [R x
    /// Q_i], `linear[source][target]` (or [0 x 0]) and `alpha[source][target]`.
    pub fn new(
        sequences: Sequences,
        parts: Vec<MapPoseMap>,
        dynamics: Vec<Vec<Kernel>>,
        coefficients: Vec<DMatrix<f64>>,
        linear: DMatrix<f64>,
        alpha: DMatrix<f64>,
    ) -> Self {
        let histories: Vec<DMatrix<f64>> = parts.iter().map(|p| sequences.windows(&p.latents)).collect();
        let sums = coefficients.iter().enumerate().map(|(i, c)| {
            let weights = coupling_weights(alpha.column(i).as_slice()).1;
            let sum = |(j, w): (usize, &f64)| {
                let (h, c) = (&histories[j], c * (w * w));
                let sum = KernelSum::new(h, &dynamics[j][i], &c);
                match linear.get((j, i)) {
                    Some(theta) => sum.with_slope(&(h.tr_mul(&c) * *theta)),
                    None => sum,
                }
            };
            weights.iter().enumerate().map(sum).collect()
        });
        let latent = parts.iter().map(|part| part.latents.ncols()).collect();
        let latent_dynamics = LatentDynamics::new(sequences.order(), latent, sums.collect());
        let maps = parts.iter().map(|part| KernelSum::new(&part.latents, &part.kernel, &part.coefficients));
        let poses = maps.collect();
        Self { sequences, parts, dynamics, coefficients, linear, alpha, latent_dynamics, poses }
    }

    /// The model with other coupling variances [M x M]. The experts are integrated out, so that its predictions
    /// are the exact means under `alpha`, given all training frames.
    ///
    /// # Errors
    ///
    /// When `alpha` is not [M x M] and positive, or a covariance cannot be factorised.
    pub fn with_alpha(&self, alpha: DMatrix<f64>) -> Result<Self, RolloutError> {
        check_couplings(&alpha, self.parts.len())?;
        let dynamics = Dynamics { kernels: &self.dynamics, linear: &self.linear, alpha: &alpha };
        let latents: Vec<&DMatrix<f64>> = self.parts.iter().map(|part| &part.latents).collect();
        let coefficients = dynamics.coefficients(&self.sequences, &latents)?;
        let (sequences, parts) = (self.sequences.clone(), self.parts.clone());
        Ok(Self::new(sequences, parts, self.dynamics.clone(), coefficients, self.linear.clone(), alpha))
    }

    /// The training sequences in the rows of the latents.
    pub fn sequences(&self) -> &Sequences {
        &self.sequences
    }

    /// The pose map of each part `[M]`.
    pub fn parts(&self) -> &[MapPoseMap] {
        &self.parts
    }

    /// Kernels of the dynamics, `dynamics[source][target]`.
    pub fn dynamics(&self) -> &[Vec<Kernel>] {
        &self.dynamics
    }

    /// C_i^-1 X^i of the dynamics into each part [R x Q_i].
    pub fn coefficients(&self) -> &[DMatrix<f64>] {
        &self.coefficients
    }

    /// Variances of the linear terms of the dynamics [M x M], row the source, column the target; [0 x 0]
    /// without them.
    pub fn linear(&self) -> &DMatrix<f64> {
        &self.linear
    }

    /// Learned coupling variances [M x M], row the source, column the target.
    pub fn alpha(&self) -> &DMatrix<f64> {
        &self.alpha
    }

    /// The latent path of every part [frames x Q_i] from the first latents of a training sequence.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is 0 or too large.
    pub fn latents(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        check_frames(frames)?;
        let count = self.sequences.lengths().len();
        let range = self.sequences.ranges().nth(sequence);
        let first = range.ok_or(RolloutError::Sequence { count, found: sequence })?.start;
        let order = self.sequences.order();
        let start = self.parts.iter().map(|part| part.latents.rows(first, order).into_owned());
        self.latent_dynamics.path(&start.collect::<Vec<_>>(), frames)
    }

    /// The kind of model: a MAP CGPDM, or a MAP GPDM if it has one part.
    pub fn kind(&self) -> ModelKind {
        if self.parts.len() == 1 { ModelKind::MapGpdm } else { ModelKind::MapCgpdm }
    }

    /// Centred columns of each part [frames x D_i], starting as the training sequence `sequence` starts.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is 0 or too large.
    pub fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        let latents = self.latents(sequence, frames)?;
        Ok(self.poses.iter().zip(&latents).map(|(pose, x)| pose.at_rows(x)).collect())
    }

    /// The number of stored numbers from which one sequence can be rolled out: all training latents, the
    /// coefficients of all maps, kernels and couplings.
    pub fn stored_numbers(&self) -> usize {
        let poses =
            self.parts.iter().map(|p| p.latents.len() + p.coefficients.len() + p.kernel.lambda.len() + 1);
        let kernels = self.dynamics.iter().flatten().map(|kernel| kernel.lambda.len());
        let coefficients = self.coefficients.iter().map(|c| c.len());
        poses.chain(kernels).chain(coefficients).sum::<usize>() + self.linear.len() + self.alpha.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::map::density::tests::random_map_case;
    use approx::assert_relative_eq;

    /// E[new | training] = c^T C^-1 targets, from the joint covariance of training rows and one new row.
    fn conditional_mean(joint: &DMatrix<f64>, targets: &DMatrix<f64>) -> DMatrix<f64> {
        let n = targets.nrows();
        let inverse = joint.view((0, 0), (n, n)).into_owned().try_inverse().unwrap();
        joint.view((n, 0), (1, n)) * inverse * targets
    }

    fn with_row(x: &DMatrix<f64>, row: &DMatrix<f64>) -> DMatrix<f64> {
        let mut all = x.clone().insert_row(x.nrows(), 0.0);
        all.row_mut(x.nrows()).copy_from(&row.row(0));
        all
    }

    #[test]
    fn one_step_is_the_mean_of_the_joint_gaussian_given_the_training_frames() {
        for seed in 0..4 {
            let (mut params, density) = random_map_case(seed);
            let learned = MapModel::fit(&density, &params).unwrap();
            assert_eq!(
                learned.with_alpha(params.alpha.clone()).unwrap().coefficients(),
                learned.coefficients()
            );
            let without_linear = MapModel { linear: DMatrix::zeros(0, 0), ..learned.clone() };
            assert_eq!(learned.stored_numbers(), without_linear.stored_numbers() + params.linear.len());
            params.alpha *= 3.0;
            params.alpha[(0, 0)] *= 0.1;
            let (model, sequences) = (learned.with_alpha(params.alpha.clone()).unwrap(), density.sequences());
            assert!(model.with_alpha(-&params.alpha).is_err());
            let order = sequences.order();
            let path = model.latents(0, order + 1).unwrap();
            let y = model.rollout(0, order + 1).unwrap();
            for (i, part) in params.parts.iter().enumerate() {
                let (noise, weights) = coupling_weights(params.alpha.column(i).as_slice());
                let rows = sequences.transitions();
                let mut joint = DMatrix::identity(rows + 1, rows + 1) * noise;
                for (j, source) in params.parts.iter().enumerate() {
                    // The new row's history is the first training row's: the start of the first sequence.
                    let histories = sequences.windows(&source.latents);
                    let all = with_row(&histories, &histories.rows(0, 1).into_owned());
                    let linear = &all * all.transpose() * params.linear_term(j, i).unwrap_or(0.0);
                    let kernel = params.dynamics[j][i].cross_covariance(&all, &all);
                    joint += (kernel + linear) * weights[j].powi(2);
                }
                let expected = conditional_mean(&joint, &sequences.lagged(&part.latents, 0));
                assert_relative_eq!(path[i].rows(order, 1).into_owned(), expected, epsilon = 1e-8);

                let all = with_row(&part.latents, &path[i].rows(order, 1).into_owned());
                let noise = DMatrix::identity(all.nrows(), all.nrows()) * part.beta;
                let joint = part.kernel.cross_covariance(&all, &all) + noise;
                let expected = conditional_mean(&joint, &density.observations()[i]);
                assert_relative_eq!(y[i].rows(order, 1).into_owned(), expected, epsilon = 1e-8);
            }
        }
    }
}
