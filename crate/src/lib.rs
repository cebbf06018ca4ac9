//! Coupled Gaussian process movement primitives: the vCGPDM of Velychko, Knopp and Endres (2017-2020).
//!
//! A body is split into parts; each part gets a small latent dynamical system, learned from motion capture; a product of
//! experts couples them, and the coupling variances alpha say how strongly each part drives each other part.

mod anatomy;
pub mod bvh;
mod case;
mod clip;
pub mod evaluation;
mod joint_names;
mod linalg;
mod model;
mod pose;
mod rollout;
mod rotation;
mod rows;
pub mod samples;
mod skeleton;
mod stage;
mod t_pose;
mod training;

pub use case::{Case, CaseError, CaseResult};
pub use clip::{Clip, ClipError, LocalPose};
pub use linalg::NumericsError;
pub use model::{
    BoundTerms, DynamicsSums, Expert, FittedExpert, FittedModel, Gaussians, Group, InducingPosterior, Kernel,
    Kind, Objective, Params, PartParams, PoseMap, Posteriors, Reading, Sequences, SequencesError,
    coupling_weights,
};
pub use pose::{Column, ColumnKind, Encoded, PoseError, PoseMapping, RootStart};
pub use rollout::{Poser, Roller, RolloutError};
pub use skeleton::{BodyMismatch, Channel, FigureNode, Joint, Skeleton, SkeletonError, WorldPose};
pub use stage::{STAGE_HEIGHT, Stage, UpAxis};
pub use training::{Trainer, TrainingError, TrainingProgress, TrainingSettings};
