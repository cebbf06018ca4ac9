//! Where a sequence of a data set came from.

use serde::Serialize;

/// Where a sequence came from.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SequenceInfo {
    /// The clip's name.
    pub name: String,
    /// The clip's content hash.
    pub sha256: String,
    /// Frames of the sequence.
    pub frames: usize,
    /// Seconds from its first frame to where its body comes to rest; `None`: it moves to its end, or is not
    /// known.
    pub rests_from: Option<f64>,
    /// The frames of the file that were used, as [`Clip::piece`](crate::motion::Clip::piece) has them;
    /// `None`: all, or not known.
    pub piece: Option<(usize, usize)>,
    /// The name of the clip whose bones it was given; `None`: it kept its own, or not known.
    pub bones_of: Option<String>,
    /// Whether all of the clip's frames are there; else only its first ones are.
    pub whole: bool,
}
