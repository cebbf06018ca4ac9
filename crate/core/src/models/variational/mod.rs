//! The vCGPDM and, of one part, the vGPDM: parameters, the bound and its gradient, training, the fitted
//! model.

mod column_noise;
mod cycle;
mod disturbances;
pub(crate) mod elbo;
mod familiarity;
mod fewer_points;
mod filter;
mod first_latents;
mod futures;
pub(crate) mod inducing;
mod latent_field;
pub(crate) mod learner;
pub(crate) mod maps;
pub(crate) mod model;
mod moments;
mod own_rollouts;
pub(crate) mod params;
pub(crate) mod predictive;
pub(crate) mod repertoire;
pub(crate) mod start;
#[cfg(test)]
pub mod testing;
pub(crate) mod trainer;

pub use crate::gp::bound::InducingPosterior;
pub use crate::models::errors::RepertoireError;
pub use crate::models::search::parameters::LARGEST_COUPLING;
pub use crate::models::training::progress::BoundTerms;
pub use cycle::{Cycle, CyclePlace};
pub(crate) use elbo::stack_offsets;
pub use elbo::{DynamicsSums, Objective, Posteriors, StoredMaps, Workspace};
pub(in crate::models) use familiarity::Familiarity;
pub use fewer_points::{KeptPoints, KeptPointsError};
pub use filter::{ColumnMoments, CompletionScore, Filter, Filtered, ObservationError};
pub use inducing::InducingError;
pub use latent_field::LatentField;
pub use learner::VariationalLearner;
pub use maps::{FittedExpert, PoseMap};
pub(in crate::models) use maps::{FittedMaps, expert_offsets};
pub use model::{ExternalEvidence, Vcgpdm};
pub use moments::{Belief, LatentMoments};
pub use params::{Expert, Params, PartParams};
pub use predictive::{PartPredictions, Prediction, PredictiveDynamics};
pub use repertoire::{Movement, Repertoire};
pub(crate) use start::first_variance;
pub use start::starting_point;
pub use trainer::{VariationalTrainer, schedule};
