//! A trained model: the fitted numbers of any kind of model, the body that it moves, and how it was made.

pub(crate) mod body;
pub(crate) mod coupled;
pub(crate) mod fitted_model;
pub(crate) mod model;
pub(crate) mod provenance;
pub(crate) mod stored;
