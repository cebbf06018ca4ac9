//! Fitted models of any kind.

use crate::models::dmp::Dmp;
use crate::models::map::MapModel;
use crate::models::rollout::request::{Handles, RolloutError};
use crate::models::tmp::Tmp;
use crate::models::training::kind::ModelKind;
use crate::models::variational::{BoundTerms, Vcgpdm};
use nalgebra::DMatrix;

/// A fitted model of any kind, without its training data. (A MAP model has the latents of all training
/// frames, because its predictions are sums over them.)
#[derive(Clone, Debug)]
pub enum FittedModel {
    /// A vCGPDM or, with one part, a vGPDM.
    Vcgpdm(Box<Vcgpdm>),
    /// A CGPDM with point estimates of its latents or, with one part, a GPDM.
    Map(Box<MapModel>),
    /// Temporal movement primitives.
    Tmp(Box<Tmp>),
    /// Dynamic movement primitives.
    Dmp(Box<Dmp>),
}

impl FittedModel {
    /// The kind of model.
    pub fn kind(&self) -> ModelKind {
        match self {
            FittedModel::Vcgpdm(model) => model.kind(),
            FittedModel::Map(model) => model.kind(),
            FittedModel::Tmp(_) => ModelKind::Tmp,
            FittedModel::Dmp(model) => model.kind(),
        }
    }

    /// Centred columns of each part [frames x D_i], starting as the training sequence `sequence` starts.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is 0 or too large.
    pub fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        self.rollout_with(sequence, frames, &Handles::default())
    }

    /// As [`rollout`](Self::rollout), of a TMP or DMP under `handles` of centred columns in the order of the parts.
    ///
    /// # Errors
    ///
    /// As [`rollout`](Self::rollout), and when the kind has no such handles.
    pub fn rollout_with(
        &self,
        sequence: usize,
        frames: usize,
        handles: &Handles,
    ) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        match self {
            FittedModel::Tmp(model) => model.rollout(sequence, frames, handles),
            FittedModel::Dmp(model) => model.rollout(sequence, frames, handles),
            _ if *handles != Handles::default() => Err(RolloutError::Handles { found: self.kind().id() }),
            FittedModel::Vcgpdm(model) => model.rollout(sequence, frames),
            FittedModel::Map(model) => model.rollout(sequence, frames),
        }
    }

    /// The number of stored numbers from which one sequence can be rolled out. Column means and body are the
    /// same for all kinds of models and do not count.
    pub fn stored_numbers(&self) -> usize {
        match self {
            FittedModel::Vcgpdm(model) => model.stored_numbers(),
            FittedModel::Map(model) => model.stored_numbers(),
            FittedModel::Tmp(model) => model.stored_numbers(),
            FittedModel::Dmp(model) => model.stored_numbers(),
        }
    }

    /// The terms of the bound, for a vCGPDM or vGPDM.
    pub fn terms(&self) -> Option<&BoundTerms> {
        match self {
            FittedModel::Vcgpdm(model) => Some(&model.terms),
            FittedModel::Map(_) | FittedModel::Tmp(_) | FittedModel::Dmp(_) => None,
        }
    }

    /// The bound on the log evidence, in nats, for a kind of model that has one.
    pub fn bound(&self) -> Option<f64> {
        match self {
            FittedModel::Vcgpdm(model) => Some(model.bound()),
            FittedModel::Tmp(model) => Some(model.bound),
            FittedModel::Map(_) | FittedModel::Dmp(_) => None,
        }
    }
}
