//! Recorded motion: skeletons, clips, BVH files, poses as rows of numbers, and the parts of a body.

pub(crate) mod anatomy;
pub mod bvh;
pub(crate) mod clip;
pub(crate) mod joint_names;
pub(crate) mod parts;
pub(crate) mod pose;
pub(crate) mod rotation;
pub(crate) mod same_body;
pub mod samples;
pub(crate) mod skeleton;
pub(crate) mod stage;
pub(crate) mod t_pose;

pub use clip::{Clip, ClipError, LocalPose};
pub use parts::{
    PartSpec, PartsError, PartsLayout, PartsPreset, check as check_parts, from_json as parts_from_json,
    presets,
};
pub use pose::{Column, ColumnKind, Encoded, PoseError, PoseMapping, RootStart};
pub use same_body::BodyMismatch;
pub use skeleton::{Channel, FigureNode, Joint, Skeleton, SkeletonError, WorldPose};
pub use stage::{STAGE_HEIGHT, Stage, UpAxis};
