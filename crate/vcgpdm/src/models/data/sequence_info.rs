//! Origins of the sequences of a data set.

use serde::Serialize;

/// The clip or table that a sequence came from.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SequenceInfo {
    /// The clip's name.
    pub name: String,
    /// The clip's content hash.
    pub sha256: String,
    /// Frames of the sequence.
    pub frames: usize,
    /// Seconds from its first frame until the body rests; `None`: it moves until its end, or this is not
    /// known.
    pub rests_from: Option<f64>,
    /// The frames of the file that were used, as in [`Clip::piece`](crate::motion::Clip::piece); `None`: all,
    /// or this is not known.
    pub piece: Option<(usize, usize)>,
    /// The name of the clip whose bones it was given; `None`: it has its own, or this is not known.
    pub bones_of: Option<String>,
    /// Whether it has all frames of the clip; false: only the first ones.
    pub whole: bool,
}
