//! Motion: bodies, clips and BVH files, and the poses of a clip as rows of numbers that a model can learn
//! from.
//!
//! [`bvh::read`] returns a [`Recording`], the content of the file. [`Recording::into_clip`] makes it a
//! [`Clip`], without the T-pose that some files put before the motion. A [`pose::PoseMapping`] turns the
//! poses of a clip into rows of Y and back. [`parts`] says which columns of Y belong to which part of the
//! body, and [`measures`] computes swing, speed and phase of the limbs. [`samples`] are clips that the
//! project makes itself.
//!
//! ```
//! use vcgpdm_core::motion::pose::PoseMapping;
//! use vcgpdm_core::motion::{bvh, samples};
//!
//! let clip = samples::clip("walk-1").ok_or("no such sample")?.resample(30.0)?;
//! let mapping = PoseMapping::new(&clip);
//! let encoded = mapping.encode(&clip)?;
//! assert_eq!(encoded.y.ncols(), 6 + 3 * (clip.skeleton.joints.len() - 1));
//!
//! let decoded = mapping.decode(&encoded.y, &encoded.start, clip.frame_time)?;
//! assert!((&decoded.values - &clip.values).amax() < 1e-9);
//! assert!(bvh::write(&decoded).starts_with("HIERARCHY"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod anatomy;
pub mod asf;
mod bones;
pub mod bvh;
mod carrying_root;
pub(crate) mod clip;
mod counterparts;
mod foreign;
mod joint_names;
pub mod landmarks;
mod limbs;
pub mod measures;
pub mod parts;
mod period;
mod plain_names;
pub mod pose;
mod recorded_bones;
mod recording;
mod root_units;
mod rotation;
mod same_body;
pub mod samples;
pub mod skeleton;
pub mod stage;
mod stage_axes;
#[cfg(test)]
mod testing;
mod transfer;
mod up_axis;

pub use clip::{Clip, ClipError, sha256};
pub use foreign::foreign_format;
pub(crate) use foreign::table_of_program;
pub use period::{Period, RHYTHMIC, period};
pub use recording::{Recording, UnknownJoint};
pub use same_body::BodyMismatch;
pub use skeleton::Skeleton;

#[cfg(test)]
mod tests;
