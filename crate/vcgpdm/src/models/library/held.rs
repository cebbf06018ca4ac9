//! What a library brings to a training of new frames in which some of it stays as it is: [`CouplingTrainer`]
//! and [`ImportTrainer`].
//!
//! [`CouplingTrainer`]: crate::models::library::CouplingTrainer
//! [`ImportTrainer`]: crate::models::library::ImportTrainer

use crate::gp::stored_outputs::StoredOutputs;
use crate::gp::{Gaussians, NumericsError};
use crate::models::data::sequences::Sequences;
use crate::models::library::Library;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::{Expert, PartParams, PoseMap, StoredMaps, first_variance};
use nalgebra::DMatrix;

impl Library {
    /// The inducing outputs of the pose maps and of these primitives, stacked in this order, to be kept.
    pub(super) fn stored(&self, uses: &[usize]) -> Result<StoredMaps, NumericsError> {
        let mut maps = StoredMaps { kinematics: Vec::new(), dynamics: Vec::new() };
        for (i, (map, psi2)) in self.parts.iter().zip(&self.pose_sums).enumerate() {
            let k = map.kernel().inducing_covariance(map.r(), self.jitter);
            let a = &k + psi2 / map.beta();
            maps.kinematics.push(StoredOutputs::new(&k, &a, map.coefficients(self.jitter)?)?);
            maps.dynamics.push(self.kept(i, uses)?);
        }
        Ok(maps)
    }

    /// The pose maps as parameters, with the latents that come nearest to new observations `y` [N x D_i] of
    /// each part.
    pub(super) fn parts_near(&self, y: &[DMatrix<f64>], sequences: &Sequences) -> Vec<PartParams> {
        let part = |(mean, map): (DMatrix<f64>, &PoseMap)| {
            let s = first_variance(&mean, sequences);
            let variance = DMatrix::from_element(mean.nrows(), mean.ncols(), s);
            PartParams {
                latents: Gaussians { mean, variance },
                r: map.r().clone(),
                kernel: map.kernel().clone(),
                beta: map.beta(),
            }
        };
        self.latents_near(y).into_iter().zip(&self.parts).map(part).collect()
    }

    /// The experts of these primitives as parameters, by primitive and target.
    pub(super) fn experts_of(&self, uses: &[usize]) -> Vec<Vec<Expert>> {
        let experts = |a: &usize| {
            let fitted = self.primitives[*a].experts.iter().map(|expert| &expert.fitted);
            fitted.map(|e| Expert { z: e.z().clone(), kernel: e.kernel().clone() }).collect()
        };
        uses.iter().map(experts).collect()
    }

    /// Latent dimensions of the part that has most.
    pub(super) fn largest_latent(&self) -> usize {
        self.latent_dimensions().into_iter().max().unwrap_or(0)
    }

    /// The settings of a training that learns these `experts` or nothing but their couplings, as its
    /// provenance has them.
    pub(super) fn settings_of(&self, experts: &[Vec<Expert>], max_iterations: usize) -> VariationalSettings {
        VariationalSettings {
            latent: self.largest_latent(),
            order: self.order,
            dynamics_ips: experts.iter().flatten().map(|expert| expert.z.nrows()).max().unwrap_or(1),
            pose_ips: self.parts.iter().map(|map| map.r().nrows()).max().unwrap_or(1),
            max_iterations,
        }
    }
}
