//! The training that belongs to the settings of each kind of model.

use crate::models::data::movements::Movements;
use crate::models::dmp::{Canonical, DmpLearner};
use crate::models::map::MapLearner;
use crate::models::tmp::TmpLearner;
use crate::models::training::error::TrainingError;
use crate::models::training::learner::Learner;
use crate::models::training::settings::Settings;
use crate::models::variational::VariationalLearner;

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
