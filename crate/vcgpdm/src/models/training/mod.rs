//! Trainings of any kind of model: settings, cost, progress, errors.

pub(crate) mod cost;
pub(crate) mod error;
pub(crate) mod kind;
pub(crate) mod latents;
pub(crate) mod learner;
pub(crate) mod learners;
pub(crate) mod parameters;
pub(crate) mod pose_weight;
pub(crate) mod progress;
pub(crate) mod settings;
pub(crate) mod trainer;
