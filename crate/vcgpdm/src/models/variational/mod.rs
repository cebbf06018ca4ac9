//! The vCGPDM and, of one part, the vGPDM: parameters, the bound and its gradient, training, the fitted model.

pub(crate) mod elbo;
mod familiarity;
pub(crate) mod inducing;
pub(crate) mod learner;
pub(crate) mod model;
pub(crate) mod params;
pub(crate) mod start;
#[cfg(test)]
pub mod testing;
pub(crate) mod trainer;

pub use crate::gp::bound::InducingPosterior;
pub use crate::models::flat::LARGEST_COUPLING;
pub use elbo::{BoundTerms, DynamicsSums, Objective, Posteriors, Workspace};
pub use inducing::InducingError;
pub use learner::VariationalLearner;
pub use model::{FittedExpert, PoseMap, Vcgpdm};
pub use params::{Expert, Params, PartParams};
pub use start::starting_point;
pub use trainer::{Trainer, TrainingProgress, schedule};
