//! Models of movement, and what all kinds of models share: training data, trainings, trained models,
//! rollouts.
//!
//! [`variational`] is the vCGPDM and, with one part, the vGPDM (Velychko et al. 2018). It is compared with
//! [`map`], the GPDM and CGPDM with point latents, [`tmp`], temporal movement primitives, and [`dmp`],
//! dynamic movement primitives.
//!
//! From clips to a motion: a [`Dataset`] of clips becomes [`Movements`]; [`Settings`] make a [`Learner`] of
//! the movements; the learner makes a [`FittedModel`]; a [`Model`] is a fitted model with the [`Body`] that
//! turns its columns into poses and its [`Provenance`]. Tables take the same way from `Dataset::of_tables` to
//! a [`SeriesModel`].

pub(crate) mod data;
pub mod dmp;
pub(crate) mod errors;
pub(crate) mod kinds;
pub mod library;
pub mod map;
pub(crate) mod rollout;
pub(crate) mod search;
pub mod tmp;
pub(crate) mod training;
pub mod variational;

pub use data::column_mapping::ColumnMapping;
pub use data::dataset::{Dataset, DatasetError, Source, same_body, with_bones_of};
pub use data::movements::{Movements, Sequence};
pub use data::phase::{Alignment, PhaseAxis, PhaseMap, Trial};
pub use data::sequences::SequenceInfo;
pub use data::sequences::{MOST_FRAMES, Sequences};
pub use errors::{CouplingsError, SequencesError, TrainingError};
pub use kinds::body::Body;
pub use kinds::completion::{Completion, PartCompletion};
pub use kinds::coupled::Coupled;
pub use kinds::endless::{Endless, EndlessFrames, REWINDS};
pub use kinds::fitted_model::FittedModel;
pub use kinds::health::{Ending, Health, PartPoses, best_to_show};
pub use kinds::learners::Learner;
pub use kinds::log_density::LatentLogDensity;
pub use kinds::model::{Model, SeriesModel};
#[doc(hidden)]
pub use kinds::observed::ObservedClipError;
pub use kinds::trainer::Trainer;
pub use rollout::couplings::{Reading, check_couplings, coupling_weight_matrix, coupling_weights};
#[doc(hidden)]
pub use rollout::dtw::{Score, ScoreError, dtw_mse, score_and_columns};
pub use rollout::latent_dynamics::LatentDynamics;
pub use rollout::pace::Pace;
pub use rollout::request::{
    Cut, Handles, MOST_SAMPLES, PosePush, Push, Rollout, RolloutError, RolloutRequest, TEMPOS,
};
pub use search::Setbacks;
pub use search::parameters::{Group, Kind, Parameters};
pub use search::{Phase, SearchEnd};
pub use training::cost::TrainingCost;
pub use training::interface::Training;
pub use training::kind::ModelKind;
pub use training::pose_weight::{BALANCED, POSE_WEIGHTS, POSE_WEIGHTS_TEXT, PoseWeight};
pub use training::progress::{EndReason, Progress, TrainingPhase};
pub use training::provenance::{ENGINE, Provenance};
pub use training::settings::{
    DmpSettings, MOST_BASES, MOST_DIMENSIONS, MOST_INDUCING, MOST_PRIMITIVES, MapSettings, Settings,
    TmpSettings, VariationalSettings,
};
