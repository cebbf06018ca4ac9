//! Where a primitive comes from, and what it keeps of movements that are not in its library.

use crate::models::data::sequence_info::SequenceInfo;
use crate::models::fitted::provenance::Provenance;
use nalgebra::DMatrix;

/// Where a primitive comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    /// The training that it was learned in; of one that was learned again, that training.
    pub training: Provenance,
    /// The sequences that it learned from.
    pub clips: Vec<SequenceInfo>,
    /// The primitive of another library that it was learned again from; `None`: it was learned from clips
    /// where it stands.
    pub relearned: Option<Relearned>,
}

/// What a primitive was learned again from.
#[derive(Clone, Debug, PartialEq)]
pub struct Relearned {
    /// The name of the primitive there.
    pub primitive: String,
    /// What its training there learned from.
    pub clips: Vec<SequenceInfo>,
    /// Which frames it was learned again from.
    pub frames: FramesFrom,
}

/// Where the frames come from that a primitive is learned again from. A primitive holds no clips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FramesFrom {
    /// Clips that somebody gave.
    Clips,
    /// The poses, under its own pose maps, of the latents that it had in training: those clips without what
    /// its pose maps do not show.
    Remembered,
    /// Rollouts of the movements that it came with: what it does, rather than what it saw.
    Generated,
}

impl FramesFrom {
    /// As documents and the terminal name it.
    pub fn id(self) -> &'static str {
        match self {
            Self::Clips => "clips",
            Self::Remembered => "remembered",
            Self::Generated => "generated",
        }
    }

    /// The one of that name.
    pub fn from_id(id: &str) -> Option<Self> {
        [Self::Clips, Self::Remembered, Self::Generated].into_iter().find(|from| from.id() == id)
    }
}

/// What a primitive keeps of a movement that used it and whose other primitives are not in its library: how
/// much its predictions were worth there, and where all parts were.
#[derive(Clone, Debug, PartialEq)]
pub struct Excerpt {
    /// The movement's name.
    pub movement: String,
    /// Coupling variances of the primitive's predictions about each part `[M]`.
    pub alpha: Vec<f64>,
    /// The latent means of the movement's sequences, `starts[sequence][part]` [T x Q_i].
    pub starts: Vec<Vec<DMatrix<f64>>>,
}
