//! Origins of primitives, and excerpts of movements that are not in their library.

use crate::models::data::sequences::SequenceInfo;
use crate::models::training::provenance::Provenance;
use nalgebra::DMatrix;
use serde::Serialize;

/// Origin of a primitive.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    /// The training that the primitive was learned in, or learned again in.
    pub training: Provenance,
    /// The sequences that the primitive learned from.
    pub clips: Vec<SequenceInfo>,
    /// The primitive of another library from which it was learned again; `None`: it was learned in the
    /// training of a library.
    pub relearned: Option<Relearned>,
}

/// The source of a primitive that was learned again.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "RelearnedFrom"))]
pub struct Relearned {
    /// The name of the primitive in the other library.
    pub primitive: String,
    /// The clips of its training in the other library.
    pub clips: Vec<SequenceInfo>,
    /// The frames that it was learned again from.
    pub frames: FramesFrom,
}

/// The source of the frames when a primitive is learned again. "clips": clips given by the caller;
/// "remembered": the poses of its training latents; "generated": rollouts of its movements in the other
/// library.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "ImportFrames"))]
pub enum FramesFrom {
    /// Clips.
    Clips,
    /// The poses of the primitive's training latents under its own pose maps: nearly its training clips.
    Remembered,
    /// Rollouts of the movements of its library.
    Generated,
}

impl FramesFrom {
    /// Its name in documents and in the terminal.
    pub fn id(self) -> &'static str {
        match self {
            Self::Clips => "clips",
            Self::Remembered => "remembered",
            Self::Generated => "generated",
        }
    }

    /// The source of this name.
    pub fn from_id(id: &str) -> Option<Self> {
        [Self::Clips, Self::Remembered, Self::Generated].into_iter().find(|from| from.id() == id)
    }
}

/// Excerpt of a movement that used a primitive but is not in the primitive's library: couplings and latents.
#[derive(Clone, Debug, PartialEq)]
pub struct Excerpt {
    /// The movement's name.
    pub movement: String,
    /// Coupling variances of the primitive's predictions about each part `[M]`.
    pub alpha: Vec<f64>,
    /// The latent means of the movement's sequences, `starts[sequence][part]` [T x Q_i].
    pub starts: Vec<Vec<DMatrix<f64>>>,
}
