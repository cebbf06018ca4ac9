//! What the trainings of all kinds of models have in common.

use crate::gp::NumericsError;
use crate::models::data::movements::Movements;
use crate::models::dmp::{Canonical, DmpLearner};
use crate::models::fitted::fitted_model::FittedModel;
use crate::models::map::MapLearner;
use crate::models::tmp::TmpLearner;
use crate::models::training::error::TrainingError;
use crate::models::training::progress::Progress;
use crate::models::training::settings::Settings;
use crate::models::variational::VariationalLearner;
use nalgebra::DMatrix;

/// A training of one kind of model. Its caller loops and may stop at any iteration: the best so far is kept.
pub trait Learner {
    /// One iteration. After the end it does nothing.
    fn step(&mut self) -> Progress;

    /// Uses `threads` threads from now on, where the kind of model can. The result is the same to the last bit.
    #[cfg(feature = "threads")]
    fn use_threads(&mut self, _threads: usize) {}

    /// Settings that are more than the data allow and were reduced, as sentences without a full stop.
    fn notices(&self) -> &[String] {
        &[]
    }

    /// Allows `iterations` more, where the kind of model can.
    fn extend(&mut self, _iterations: usize) {}

    /// Latent means of a part at the best so far [N x Q_i], where the kind of model has any.
    fn latents(&self, _part: usize) -> Option<DMatrix<f64>> {
        None
    }

    /// How far training is.
    fn progress(&self) -> Progress;

    /// The best model so far.
    ///
    /// # Errors
    ///
    /// When a covariance of the model cannot be factorised.
    fn model(&self) -> Result<FittedModel, NumericsError>;
}

impl Settings {
    /// A training, ready to begin. Models of the whole body see the columns of all parts as one part.
    ///
    /// # Errors
    ///
    /// When a setting is out of its range, or these movements cannot be learned from.
    pub fn learner(&self, movements: &Movements, seed: u32) -> Result<Box<dyn Learner>, TrainingError> {
        Ok(match self {
            Settings::Vcgpdm(s) => Box::new(VariationalLearner::new(movements.clone(), s, seed)?),
            Settings::Vgpdm(s) => Box::new(VariationalLearner::new(movements.as_one_part(), s, seed)?),
            Settings::MapGpdm(s) => Box::new(MapLearner::new(movements.as_one_part(), s, seed)?),
            Settings::MapCgpdm(s) => Box::new(MapLearner::new(movements.clone(), s, seed)?),
            Settings::Tmp(s) => Box::new(TmpLearner::new(movements, s)?),
            Settings::DmpDiscrete(s) => Box::new(DmpLearner::new(movements, Canonical::Discrete, s)?),
            Settings::DmpRhythmic(s) => Box::new(DmpLearner::new(movements, Canonical::Rhythmic, s)?),
        })
    }
}
