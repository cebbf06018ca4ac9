//! From a model's settings to a training of it.

use crate::models::data::movements::Movements;
use crate::models::dmp::{Canonical, DmpLearner};
use crate::models::map::MapLearner;
use crate::models::tmp::TmpLearner;
use crate::models::training::error::TrainingError;
use crate::models::training::learner::Learner;
use crate::models::training::settings::ModelSettings;
use crate::models::variational::VariationalLearner;

impl ModelSettings {
    /// A training, ready to begin. Models of the whole body see the columns of all parts as one part.
    ///
    /// # Errors
    ///
    /// When a setting is out of its range, or these movements cannot be learned from.
    pub fn learner(&self, movements: &Movements, seed: u32) -> Result<Box<dyn Learner>, TrainingError> {
        Ok(match self {
            ModelSettings::Vcgpdm(s) => Box::new(VariationalLearner::new(movements.clone(), s, seed)?),
            ModelSettings::Vgpdm(s) => Box::new(VariationalLearner::new(movements.as_one_part(), s, seed)?),
            ModelSettings::MapGpdm(s) => Box::new(MapLearner::new(movements.as_one_part(), s, seed)?),
            ModelSettings::MapCgpdm(s) => Box::new(MapLearner::new(movements.clone(), s, seed)?),
            ModelSettings::Tmp(s) => Box::new(TmpLearner::new(movements, s)?),
            ModelSettings::DmpDiscrete(s) => Box::new(DmpLearner::new(movements, Canonical::Discrete, s)?),
            ModelSettings::DmpRhythmic(s) => Box::new(DmpLearner::new(movements, Canonical::Rhythmic, s)?),
        })
    }
}
