//! Coupled Gaussian process movement primitives: the vCGPDM of Velychko, Knopp and Endres (2017-2020).
//!
//! A body is split into parts; each part gets a small latent dynamical system, learned from motion capture; a product of
//! experts couples them, and the coupling variances alpha say how strongly each part drives each other part.
//!
//! ```
//! use vcgpdm::{Dataset, MotionModel, RolloutRequest, Source, Trainer, TrainingSettings, bvh, presets, samples};
//!
//! let clip = samples::clip("walk-1").ok_or("no such sample")?;
//! let parts = &presets(&clip.skeleton)[1].parts; // lower and upper body
//! let dataset = Dataset::new(&[Source { clip: &clip, first_frames: None }], parts, 30.0)?;
//!
//! let settings = TrainingSettings { max_iterations: 20, ..TrainingSettings::default() };
//! let mut trainer = Trainer::new(dataset.y.clone(), dataset.lengths(), settings)?;
//! while !trainer.step().done {}
//!
//! let model = MotionModel::trained(&dataset, &trainer, 30.0)?;
//! let rollout = model.rollout(&RolloutRequest { frames: 60, ..RolloutRequest::default() })?;
//! let motion = bvh::write(&model.clip(&rollout, "walk.bvh")?);
//! assert!(motion.starts_with("HIERARCHY"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod anatomy;
mod any_model;
pub mod baselines;
mod body;
pub mod bvh;
mod case;
mod clip;
mod dataset;
mod document;
pub mod evaluation;
mod joint_names;
mod json;
mod learner;
mod linalg;
mod model;
mod motion_model;
mod parts;
mod pose;
mod rollout;
mod rotation;
mod rows;
mod same_body;
pub mod samples;
mod skeleton;
#[cfg(all(feature = "speed", not(target_arch = "wasm32")))]
pub mod speed;
mod stage;
pub mod synthetic;
mod t_pose;
mod training;
#[cfg(target_arch = "wasm32")]
mod wasm;
mod words;

pub use any_model::{AnyModel, BaselineModel, Record};
pub use baselines::map::{
    LogDensity, MapLearner, MapModel, MapParams, MapPart, MapPoseMap, MapSettings, MapTerms,
};
pub use body::Body;
pub use case::{Case, CaseError, CaseResult};
pub use clip::{Clip, ClipError, LocalPose};
pub use dataset::{Dataset, DatasetError, SequenceInfo, Source};
pub use document::DocumentError;
pub use json::JsonError;
pub use learner::{Learner, LearningProgress, ModelKind, MovementModel, Movements, Sequence};
pub use linalg::NumericsError;
pub use model::{
    BoundTerms, DynamicsSums, Expert, FittedExpert, FittedModel, Gaussians, Group, InducingPosterior, Kernel,
    Kind, Objective, Parameters, Params, PartParams, PoseMap, Posteriors, Reading, Sequences, SequencesError,
    Workspace, coupling_weights,
};
pub use motion_model::{MotionModel, Provenance, Rollout, RolloutRequest};
pub use parts::{
    PartSpec, PartsError, PartsLayout, PartsPreset, check as check_parts, from_json as parts_from_json,
    presets,
};
pub use pose::{Column, ColumnKind, Encoded, PoseError, PoseMapping, RootStart};
pub use rollout::{Poser, Roller, RolloutError};
pub use same_body::BodyMismatch;
pub use skeleton::{Channel, FigureNode, Joint, Skeleton, SkeletonError, WorldPose};
pub use stage::{STAGE_HEIGHT, Stage, UpAxis};
pub use training::{
    Phase, Trainer, TrainingError, TrainingProgress, TrainingSettings, VariationalLearner, VariationalModel,
    schedule, starting_point,
};
