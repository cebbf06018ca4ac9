//! The models of movement, and what they have in common: what they learn from, a training under way, a fitted
//! model that rolls out, and the body that it moves.
//!
//! [`variational`] is the vCGPDM and, of one part, the vGPDM (Velychko et al. 2018). The others are what it
//! is compared with: [`map`] the GPDM and CGPDM with point latents, [`tmp`] temporal and [`dmp`] dynamic
//! movement primitives.
//!
//! From clips to a motion: a [`Dataset`] of clips gives [`Movements`]; [`ModelSettings`] give a [`Learner`]
//! of these, and that a [`Model`]; a [`TrainedModel`] has with it the [`Body`] that turns its columns into
//! poses, and its [`Provenance`]. Tables of numbers that are no poses go the same way: `Dataset::of_tables`,
//! and a [`SeriesModel`] at the end.

pub(crate) mod body;
mod cost;
pub(crate) mod couplings;
pub(crate) mod dataset;
pub mod dmp;
pub(crate) mod flat;
pub(crate) mod health;
pub(crate) mod kind;
pub(crate) mod latent_dynamics;
mod latent_paths;
pub(crate) mod latents;
pub(crate) mod learner;
pub mod library;
pub(crate) mod live;
pub mod map;
pub(crate) mod model;
pub(crate) mod movements;
pub(crate) mod observed;
pub(crate) mod phase;
pub(crate) mod progress;
pub(crate) mod provenance;
pub(crate) mod rollout;
pub(crate) mod search;
pub(crate) mod sequences;
pub(crate) mod settings;
mod stored;
mod tables;
pub mod tmp;
pub(crate) mod trained;
mod training;
pub(crate) mod training_error;
mod trials;
pub mod variational;

pub use body::Body;
pub use cost::TrainingCost;
pub use couplings::{CouplingsError, Reading, check_couplings, coupling_weight_matrix, coupling_weights};
pub use dataset::{Dataset, DatasetError, SequenceInfo, Source, same_body, with_bones_of};
pub use flat::{Group, Kind, Parameters};
pub use health::{Health, best_to_show};
pub use kind::ModelKind;
pub use latent_dynamics::LatentDynamics;
pub use learner::Learner;
pub use live::{LiveFrames, LiveRollout};
pub use model::Model;
pub use movements::{Movements, Sequence};
pub use observed::Observed;
pub use phase::{Alignment, PhaseAxis, PhaseMap, Trial};
pub use progress::{EndReason, LearningProgress, Setbacks, TrainingPhase};
pub use provenance::{ENGINE, Provenance};
pub use rollout::{Cut, MOST_SAMPLES, Push, Rollout, RolloutError, RolloutRequest};
pub use search::{Phase, SearchEnd};
pub use sequences::{MOST_FRAMES, Sequences, SequencesError};
pub use settings::{
    DmpSettings, MOST_BASES, MOST_DIMENSIONS, MOST_INDUCING, MOST_PRIMITIVES, MapSettings, ModelSettings,
    TmpSettings, VariationalSettings,
};
pub use trained::{Fitted, SeriesModel, TrainedModel};
pub use training_error::TrainingError;
