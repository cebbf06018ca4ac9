//! The training that belongs to the settings of each kind of model.

use crate::gp::NumericsError;
use crate::models::data::movements::Movements;
use crate::models::dmp::{Dmp, DmpLearner};
use crate::models::errors::TrainingError;
use crate::models::kinds::fitted_model::FittedModel;
use crate::models::map::MapLearner;
use crate::models::tmp::TmpLearner;
use crate::models::training::interface::Training;
use crate::models::training::settings::Settings;
use crate::models::variational::VariationalLearner;

/// A training of any kind of model. The caller loops and may stop after any iteration; the best model so far is kept.
pub trait Learner: Training {
    /// The best model so far.
    ///
    /// # Errors
    ///
    /// When a covariance of the model cannot be factorised.
    fn model(&self) -> Result<FittedModel, NumericsError>;
}

impl Learner for VariationalLearner {
    fn model(&self) -> Result<FittedModel, NumericsError> {
        Ok(FittedModel::Vcgpdm(Box::new(self.trainer.model()?)))
    }
}

impl Learner for MapLearner {
    fn model(&self) -> Result<FittedModel, NumericsError> {
        Ok(FittedModel::Map(Box::new(self.fitted()?)))
    }
}

impl Learner for TmpLearner {
    fn model(&self) -> Result<FittedModel, NumericsError> {
        Ok(FittedModel::Tmp(Box::new(self.fitted()?)))
    }
}

impl Learner for DmpLearner {
    fn model(&self) -> Result<FittedModel, NumericsError> {
        Ok(FittedModel::Dmp(Box::new(self.fitted()?)))
    }
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
            Settings::DmpDiscrete(s) => Box::new(DmpLearner::new(movements, Dmp::discrete, s)?),
            Settings::DmpRhythmic(s) => Box::new(DmpLearner::new(movements, Dmp::rhythmic, s)?),
        })
    }
}
