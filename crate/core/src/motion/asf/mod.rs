//! Acclaim files, the form in which the CMU database keeps its recordings: one skeleton (`.asf`) for each
//! person, and motions (`.amc`).
//!
//! A bone of an ASF file turns about its start, a joint of BVH about its own position. So each bone becomes a
//! joint at the end of its parent bone, with the name from the usual BVH conversions of these recordings.
//! Lengths are in the file's units.
//!
//! The usual conversions begin with a frame at rest, and omit the bones of the thorax and the hands: neck and
//! shoulders are at the start of the thorax, fingers at the start of the hand. All other numbers are equal up
//! to their written digits.

mod file;
mod motion;
mod skeleton;
#[cfg(test)]
mod tests;

pub use file::AsfError;
pub use file::File;

use crate::motion::clip::sha256;
use crate::motion::recording::Recording;

/// Frames a second of the CMU recordings. The files do not contain it.
pub const CMU_RATE: f64 = 120.0;

/// Reads a motion (AMC) of a skeleton (ASF) at `rate` frames a second. The recording has the motion's name;
/// its hash is that of the bytes of both files in this order.
///
/// # Errors
///
/// An [`AsfError`] with file and line, when a file is invalid or the two do not belong together.
pub fn read(asf: File, amc: File, rate: f64) -> Result<Recording, AsfError> {
    let body = skeleton::read(asf)?;
    let (values, warnings) = motion::read(amc, &body)?;
    Ok(Recording {
        name: amc.name.to_owned(),
        skeleton: body.skeleton,
        frame_time: 1.0 / rate,
        values,
        warnings,
        sha256: sha256(&[asf.bytes, amc.bytes].concat()),
    })
}
