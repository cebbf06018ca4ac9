//! Models of any kind: their training, the fitted numbers with the body, and their motions, also those without an end,
//! with their health.

pub(crate) mod body;
pub(crate) mod completion;
pub(crate) mod coupled;
mod dragged;
pub(crate) mod endless;
pub(crate) mod fitted_model;
pub(crate) mod health;
pub(crate) mod learners;
pub(crate) mod log_density;
pub(crate) mod model;
mod movers;
pub(crate) mod observed;
pub(in crate::models) mod own_rollouts;
pub(crate) mod reach;
pub(crate) mod trainer;
