//! Trained models: the fitted numbers of any kind of model, the body, and the provenance.

pub(crate) mod body;
pub(crate) mod completion;
pub(crate) mod coupled;
mod dragged;
pub(crate) mod fitted_model;
pub(crate) mod model;
pub(crate) mod observed;
pub(in crate::models) mod own_rollouts;
pub(crate) mod provenance;
