//! One recorded motion: a skeleton and its channel values, row by row.

use crate::skeleton::Skeleton;
use nalgebra::DMatrix;

/// A motion clip, as read from a BVH file or rolled out from a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// The file's name, for messages and provenance.
    pub name: String,
    /// The body.
    pub skeleton: Skeleton,
    /// Seconds from one frame to the next.
    pub frame_time: f64,
    /// Channel values [frames x channels], in the order of the joints and of each joint's channels (degrees, file units).
    pub values: DMatrix<f64>,
    /// What was odd about the file but could be read.
    pub warnings: Vec<String>,
    /// SHA-256 of the file's bytes in lower-case hexadecimal; of the written text for a clip that never was a file.
    pub sha256: String,
}
