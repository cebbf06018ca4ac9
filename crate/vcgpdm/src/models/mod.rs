//! The models of movement, and what they have in common: what they learn from, a training under way, a fitted model that
//! rolls out, and the body that it moves.
//!
//! [`variational`] is the vCGPDM and, of one part, the vGPDM (Velychko et al. 2018). The others are what it is compared with:
//! [`map`] the GPDM and CGPDM with point latents, [`tmp`] temporal and [`dmp`] dynamic movement primitives.

pub(crate) mod any_model;
pub(crate) mod body;
pub(crate) mod dataset;
pub mod dmp;
pub(crate) mod flat;
pub(crate) mod kind;
pub(crate) mod latents;
pub(crate) mod learner;
pub mod map;
pub(crate) mod motion_model;
pub(crate) mod movements;
pub(crate) mod period;
pub(crate) mod phase;
pub(crate) mod rollout;
pub(crate) mod search;
pub(crate) mod sequences;
pub(crate) mod settings;
mod stored;
pub mod tmp;
mod training;
pub(crate) mod training_error;
mod trials;
pub mod variational;

pub use any_model::{AnyModel, BaselineModel, Record};
pub use body::Body;
pub use dataset::{Dataset, DatasetError, SequenceInfo, Source};
pub use flat::{Group, Kind, Parameters};
pub use kind::ModelKind;
pub use learner::{Learner, LearningProgress, MovementModel};
pub use motion_model::{ENGINE, MotionModel, Provenance, Rollout, RolloutRequest};
pub use movements::{Movements, Sequence};
pub use period::{Period, period};
pub use phase::{Alignment, PhaseAxis, PhaseMap, Trial};
pub use rollout::{Poser, Roller, RolloutError};
pub use search::{EndReason, Phase};
pub use sequences::{Sequences, SequencesError};
pub use settings::{DmpSettings, MapSettings, ModelSettings, TmpSettings, VariationalSettings};
pub use training_error::TrainingError;
