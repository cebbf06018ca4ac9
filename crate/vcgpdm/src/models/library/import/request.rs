//! What an import is asked for, and why it cannot be made.

use crate::gp::NumericsError;
use crate::models::data::dataset::DatasetError;
use crate::models::library::{
    CombinationError, FramesFrom, LibraryError, Misfit, ObservedClip, TrainedLibrary,
};
use crate::models::rollout::request::RolloutError;
use crate::models::training::error::TrainingError;
use crate::motion::pose::PoseError;
use nalgebra::DMatrix;
use std::ops::Range;
use thiserror::Error;

/// Why primitives cannot be learned again.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// They move another body, or other parts of it.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// There are no frames to learn from.
    #[error("the file keeps no movement to learn its primitives again from: expected clips")]
    NoFrames,
    /// Clips show one movement, in which a part uses one primitive.
    #[error("expected one primitive of {part} to be learned again from clips, found {found}")]
    Several {
        /// The part.
        part: String,
        /// How many there are.
        found: usize,
    },
    /// Nothing stands in for a part that brings no primitive of its own.
    #[error(
        "expected a primitive of {part} in this library to take part with those that are learned again, found none"
    )]
    NoCompanion {
        /// The part.
        part: String,
    },
    /// What stands in for the other parts does not fit them.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// The clips cannot be looked at by this library.
    #[error(transparent)]
    Clips(#[from] LibraryError),
    /// A movement of the other library cannot be made.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
    /// A movement of the other library cannot be turned into poses.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// Training cannot start.
    #[error(transparent)]
    Training(#[from] TrainingError),
    /// The frames cannot be learned from, as they are in a clip.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// What stays cannot be solved for.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

/// The frames that primitives are learned again from.
#[derive(Clone, Copy, Debug)]
pub enum ImportFrames<'a> {
    /// Clips of the movement, as this library sees them.
    Clips(&'a [ObservedClip]),
    /// `FramesFrom::Remembered`.
    Remembered,
    /// `FramesFrom::Generated`.
    Generated,
}

impl ImportFrames<'_> {
    /// As it is kept.
    pub fn from(self) -> FramesFrom {
        match self {
            Self::Clips(_) => FramesFrom::Clips,
            Self::Remembered => FramesFrom::Remembered,
            Self::Generated => FramesFrom::Generated,
        }
    }
}

/// What is asked of an import.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportRequest {
    /// The primitive of this library that stands in for each part, in movements to which the part brings none
    /// of its own `[M]`; `None` where none is needed.
    pub companions: Vec<Option<usize>>,
    /// Most iterations of the training.
    pub max_iterations: usize,
    /// The seed of everything random: which frames the inducing inputs start at.
    pub seed: u32,
}

/// A movement of the training.
pub(super) struct Planned {
    pub name: String,
    /// Which of the sequences.
    pub which: Range<usize>,
    /// Places among the companions and, after them, the new primitives.
    pub uses: Vec<usize>,
}

impl TrainedLibrary {
    /// What this library can show of its movements without a clip: what it remembers, or, where it keeps only
    /// the first frames of what a primitive learned from, what it generates.
    pub fn own_frames(&self) -> ImportFrames<'static> {
        let is_whole = |start: &Vec<DMatrix<f64>>| start.iter().all(|x| x.nrows() > self.library.order);
        match (0..self.library.primitives.len()).all(|a| self.library.starts_of(a).any(is_whole)) {
            true => ImportFrames::Remembered,
            false => ImportFrames::Generated,
        }
    }

    /// The primitives of this library that stand in, when nobody says which, for parts that bring none of
    /// their own `[M]`: of each part one that is called as a movement or primitive of `donor`, else the
    /// first.
    pub fn companions(&self, donor: &TrainedLibrary) -> Vec<Option<usize>> {
        let movements = donor.library.movements.iter().map(|movement| &movement.name);
        let primitives = donor.library.primitives.iter();
        let excerpts = primitives.clone().flat_map(|primitive| &primitive.excerpts);
        let names = movements.chain(excerpts.map(|excerpt| &excerpt.movement));
        let names: Vec<&String> = names.chain(primitives.map(|primitive| &primitive.name)).collect();
        let own = &self.library.primitives;
        let companion = |part: usize| {
            let of_part = || (0..own.len()).filter(move |a| own[*a].part == part);
            of_part().find(|a| names.contains(&&own[*a].name)).or_else(|| of_part().next())
        };
        (0..self.library.part_count()).map(companion).collect()
    }
}
