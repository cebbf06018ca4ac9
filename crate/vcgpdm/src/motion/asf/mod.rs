//! Acclaim files, the form in which the CMU database keeps its recordings: one skeleton (`.asf`) for each
//! person, and motions (`.amc`).
//!
//! A bone of an ASF file turns at its start and reaches to its end; a joint of BVH stands where it turns. So
//! each bone becomes a joint at the end of its parent bone, under the name that the usual BVH conversions of
//! these recordings give it. Lengths are in the file's units.
//!
//! The conversions in circulation have a frame at rest first, and leave out the bones of the thorax and the
//! hands: their neck and shoulders stand where the thorax begins, and their fingers where the hand begins.
//! All else is the same to the digits that they write.

mod error;
mod file;
mod motion;
mod skeleton;
#[cfg(test)]
mod tests;

pub use error::AsfError;
pub use file::File;

use crate::motion::clip::sha256;
use crate::motion::recording::Recording;

/// Frames a second of the CMU recordings. The files themselves do not say it.
pub const CMU_RATE: f64 = 120.0;

/// Reads a motion (AMC) of a skeleton (ASF), `rate` frames a second. The recording has the motion's name; its
/// hash is that of both files, one after the other.
///
/// # Errors
///
/// When one of them is no such file, or they do not belong together; with the file and the line.
pub fn read(asf: File, amc: File, rate: f64) -> Result<Recording, AsfError> {
    let body = skeleton::read(asf)?;
    let values = motion::read(amc, &body)?;
    Ok(Recording {
        name: amc.name.to_owned(),
        skeleton: body.skeleton,
        frame_time: 1.0 / rate,
        values,
        warnings: Vec::new(),
        sha256: sha256(&[asf.bytes, amc.bytes].concat()),
    })
}
