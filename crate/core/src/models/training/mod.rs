//! Trainings of any kind of model: settings, cost, progress, provenance.

pub(crate) mod cost;
pub(crate) mod interface;
pub(crate) mod kind;
pub(crate) mod latents;
pub(crate) mod pose_weight;
pub(crate) mod progress;
pub(crate) mod provenance;
pub(crate) mod settings;
