//! Start of a [`CouplingTrainer`](crate::models::library::CouplingTrainer): a training on new clips in which the
//! pose maps and the primitives of a library are fixed.

use crate::gp::linalg::stacked;
use crate::gp::stored_outputs::StoredOutputs;
use crate::gp::{Gaussians, NumericsError};
use crate::models::data::sequences::SequenceInfo;
use crate::models::data::sequences::Sequences;
use crate::models::library::{EncodedClip, Library, TrainedLibrary};
use crate::models::training::pose_weight::PoseWeight;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::{Expert, PartParams, PoseMap, StoredMaps, first_variance};
use nalgebra::DMatrix;

impl TrainedLibrary {
    /// The weight of the pose terms in the library's training, which trainings on new frames share.
    pub(super) fn pose_weight(&self) -> PoseWeight {
        self.provenance.settings.variational().map(|settings| settings.pose_weight).unwrap_or_default()
    }
}

impl Library {
    /// The columns of each part [N x D_i] of these clips, stacked, and the sequences.
    pub(super) fn stack_clips<'a>(
        &self,
        clips: impl Iterator<Item = &'a EncodedClip> + Clone,
    ) -> (Vec<DMatrix<f64>>, Vec<SequenceInfo>) {
        let parts = 0..self.part_count();
        let y = parts.map(|part| stacked(clips.clone().map(|clip| &clip.y[part]))).collect();
        (y, clips.map(|clip| clip.info.clone()).collect())
    }

    /// The inducing outputs of the pose maps and of these primitives, stacked in this order, as fixed outputs
    /// of the training.
    pub(super) fn fixed_outputs(&self, uses: &[usize]) -> Result<StoredMaps, NumericsError> {
        let mut maps = StoredMaps { kinematics: Vec::new(), dynamics: Vec::new() };
        for (i, (map, psi2)) in self.parts.iter().zip(&self.pose_sums).enumerate() {
            let k = map.kernel().inducing_covariance(map.r(), self.jitter);
            let a = &k + psi2 / map.beta();
            maps.kinematics.push(StoredOutputs::new(&k, &a, map.coefficients(self.jitter)?)?);
            maps.dynamics.push(self.fixed_dynamics_outputs(i, uses)?);
        }
        Ok(maps)
    }

    /// The pose maps as parameters, with the latents whose poses are nearest to new observations `y` [N x
    /// D_i] of each part.
    pub(super) fn starting_parts(&self, y: &[DMatrix<f64>], sequences: &Sequences) -> Vec<PartParams> {
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
        self.nearest_latents(y).into_iter().zip(&self.parts).map(part).collect()
    }

    /// The experts of these primitives as parameters, by primitive and target.
    pub(super) fn expert_parameters(&self, uses: &[usize]) -> Vec<Vec<Expert>> {
        let experts = |a: &usize| {
            let fitted = self.primitives[*a].experts.iter().map(|expert| &expert.fitted);
            fitted.map(|e| Expert { z: e.z().clone(), kernel: e.kernel().clone() }).collect()
        };
        uses.iter().map(experts).collect()
    }

    /// The largest number of latent dimensions of a part.
    pub(super) fn largest_latent(&self) -> usize {
        self.latent_dimensions().into_iter().max().unwrap_or(0)
    }

    /// Settings of a training with these `experts`, for its provenance.
    pub(super) fn training_settings(
        &self,
        experts: &[Vec<Expert>],
        pose_weight: PoseWeight,
        max_iterations: usize,
    ) -> VariationalSettings {
        VariationalSettings {
            latent: self.largest_latent(),
            order: self.order,
            dynamics_ips: experts.iter().flatten().map(|expert| expert.z.nrows()).max().unwrap_or(1),
            pose_ips: self.parts.iter().map(|map| map.r().nrows()).max().unwrap_or(1),
            max_iterations,
            pose_weight,
            uncoupled: false,
            own_rollouts: false,
        }
    }
}
