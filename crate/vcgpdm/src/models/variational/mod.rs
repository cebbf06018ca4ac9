//! The vCGPDM and, of one part, the vGPDM: parameters, the bound and its gradient, training, the posterior.

pub(crate) mod elbo;
pub(crate) mod inducing;
pub(crate) mod learner;
pub(crate) mod params;
pub(crate) mod posterior;
pub(crate) mod start;
#[cfg(test)]
pub mod testing;
pub(crate) mod trainer;

pub use crate::gp::bound::InducingPosterior;
pub use elbo::{
    BoundTerms, DynamicsSums, Objective, Posteriors, Workspace, coupling_weight_matrix, coupling_weights,
};
pub use inducing::InducingError;
pub use learner::{VariationalLearner, VariationalModel};
pub use params::{Expert, Params, PartParams};
pub use posterior::{FittedExpert, FittedModel, PoseMap, Reading};
pub use start::starting_point;
pub use trainer::{Trainer, TrainingPhase, TrainingProgress, schedule};
