//! The fitted model: what a rollout, a plot or a file needs. Holds no training data.

use crate::gp::linalg::Factor;
use crate::gp::{Kernel, NumericsError};
use crate::models::variational::elbo::{DynamicsSums, coupling_weights};
use crate::models::variational::elbo::{Objective, stack_offsets};
use crate::models::variational::params::Params;
use nalgebra::DMatrix;
use serde::Deserialize;

/// The pose map g^i of one part, with the posterior of its inducing outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseMap {
    /// Pose inducing inputs r [L x Q].
    pub r: DMatrix<f64>,
    /// Its kernel.
    pub kernel: Kernel,
    /// Observation noise variance beta.
    pub beta: f64,
    /// E[v] [L x D].
    pub mean: DMatrix<f64>,
    /// Covariance of every column of v [L x L].
    pub covariance: DMatrix<f64>,
}

/// One expert f^{ji}, with the posterior mean of its inducing outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedExpert {
    /// Dynamics inducing inputs z [K x pQ_j].
    pub z: DMatrix<f64>,
    /// Its kernel, of signal variance 1.
    pub kernel: Kernel,
    /// E[u] [K x Q_i].
    pub mean: DMatrix<f64>,
}

/// A trained vCGPDM, without the data it was trained on.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedModel {
    /// p.
    pub order: usize,
    /// The factor of the signal variance on the diagonal of every inducing covariance.
    pub jitter: f64,
    /// The pose map of each part [M].
    pub parts: Vec<PoseMap>,
    /// Experts by source and target: `experts[j][i]` is j's prediction about i.
    pub experts: Vec<Vec<FittedExpert>>,
    /// Covariance of every column of u into each target, its sources stacked in order [M].
    pub dynamics_covariance: Vec<DMatrix<f64>>,
    /// The sums from which the experts into each target can be inferred again under other couplings [M].
    pub sums: Vec<DynamicsSums>,
    /// Learned coupling variances [M x M], row the source, column the target.
    pub alpha: DMatrix<f64>,
    /// The latent means of the first p frames of every training sequence: `starts[sequence][part]` [p x Q].
    pub starts: Vec<Vec<DMatrix<f64>>>,
}

/// What a changed coupling does to the experts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
pub enum Reading {
    /// The experts stay as learned; only their weights change.
    #[default]
    #[serde(rename = "as learned")]
    AsLearned,
    /// The experts are what the same data would make of them under the changed couplings.
    #[serde(rename = "re-inferred")]
    ReInferred,
}

impl FittedModel {
    /// The optimal posteriors at `params`.
    pub fn fit(objective: &Objective, params: &Params) -> Result<Self, NumericsError> {
        let posteriors = objective.posteriors(params)?;
        let parts = params.parts.iter().zip(posteriors.kinematics);
        let parts = parts.map(|(part, v)| PoseMap {
            r: part.r.clone(),
            kernel: part.kernel.clone(),
            beta: part.beta,
            mean: v.mean,
            covariance: v.covariance,
        });
        let experts = params.experts.iter().enumerate().map(|(j, row)| {
            let fitted = row.iter().enumerate().map(|(i, expert)| {
                let before = (0..j).map(|l| params.experts[l][i].z.nrows()).sum();
                let mean = posteriors.dynamics[i].mean.rows(before, expert.z.nrows()).into_owned();
                FittedExpert { z: expert.z.clone(), kernel: expert.kernel.clone(), mean }
            });
            fitted.collect()
        });
        let order = objective.sequences().order();
        let starts = objective.sequences().ranges().map(|range| {
            let start = |part: &crate::models::variational::params::PartParams| {
                part.latents.mean.rows(range.start, order).into_owned()
            };
            params.parts.iter().map(start).collect()
        });
        Ok(Self {
            order,
            jitter: objective.jitter(),
            parts: parts.collect(),
            experts: experts.collect(),
            starts: starts.collect(),
            dynamics_covariance: posteriors.dynamics.into_iter().map(|u| u.covariance).collect(),
            sums: posteriors.sums,
            alpha: params.alpha.clone(),
        })
    }

    /// M.
    pub fn part_count(&self) -> usize {
        self.parts.len()
    }

    /// K_rr^-1 E[v] of a part [L x D]: what a pose is a weighted sum of.
    pub fn pose_coefficients(&self, part: usize) -> Result<DMatrix<f64>, NumericsError> {
        let map = &self.parts[part];
        let k = map.kernel.inducing_covariance(&map.r, self.jitter);
        Ok(Factor::new(&k, "covariance of the pose inducing points")?.solve(&map.mean))
    }

    /// w_j K_zz^-1 E[u^{ji}] of every source j about the target `i`, under the couplings `alpha` [M x M]: [K_j x Q_i] each.
    pub fn dynamics_coefficients(
        &self,
        i: usize,
        alpha: &DMatrix<f64>,
        reading: Reading,
    ) -> Result<Vec<DMatrix<f64>>, NumericsError> {
        let (noise, weights) = coupling_weights(alpha.column(i).as_slice());
        let experts: Vec<&FittedExpert> = self.experts.iter().map(|row| &row[i]).collect();
        let k: Vec<DMatrix<f64>> =
            experts.iter().map(|e| e.kernel.inducing_covariance(&e.z, self.jitter)).collect();
        match reading {
            Reading::AsLearned => k
                .iter()
                .zip(&experts)
                .zip(&weights)
                .map(|((k, e), w)| {
                    Ok(Factor::new(k, "covariance of the dynamics inducing points")?.solve(&e.mean) * *w)
                })
                .collect(),
            Reading::ReInferred => {
                // K^-1 E[u] = A^-1 b / n with A = K + Psi2 / n, all sources stacked.
                let offsets = stack_offsets(k.iter().map(|k| k.nrows()));
                let (psi2, b) = self.sums[i].weighted(&weights, &offsets);
                let mut a = psi2 / noise;
                for (j, k) in k.iter().enumerate() {
                    let mut block = a.view_mut((offsets[j], offsets[j]), k.shape());
                    block += k;
                }
                let all = Factor::new(&a, "covariance of the data at the dynamics inducing points")?
                    .solve(&b)
                    / noise;
                let rows = weights.iter().enumerate();
                Ok(rows.map(|(j, w)| all.rows(offsets[j], k[j].nrows()) * *w).collect())
            }
        }
    }
}
