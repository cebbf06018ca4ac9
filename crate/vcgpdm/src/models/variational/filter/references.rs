//! The latent paths along which a model moved in training.

use crate::models::rollout::couplings::Reading;
use crate::models::rollout::request::RolloutError;
use crate::models::variational::model::Vcgpdm;
use nalgebra::DMatrix;

/// Frames of a rollout that stands for a sequence of which the model has only the first frames.
const ROLLED_OUT: usize = 120;

/// A latent path [frames x Q_i] of each part for every training sequence: the trained latents, or, of a model
/// that stores only the first ones, a rollout from them.
pub(super) fn reference_paths(model: &Vcgpdm) -> Result<Vec<Vec<DMatrix<f64>>>, RolloutError> {
    let dynamics = model.dynamics(&model.alpha, Reading::AsLearned)?;
    let path = |start: &Vec<DMatrix<f64>>| {
        let stored = start.first().map_or(0, DMatrix::nrows);
        if stored > model.order { Ok(start.clone()) } else { dynamics.path(start, ROLLED_OUT) }
    };
    model.starts.iter().map(path).collect()
}
