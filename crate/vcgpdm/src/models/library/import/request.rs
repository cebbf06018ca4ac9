//! Requests for imports, and errors.

use crate::gp::NumericsError;
use crate::models::data::dataset::DatasetError;
use crate::models::library::{
    CombinationError, EncodedClip, FramesFrom, LibraryError, Misfit, TrainedLibrary,
};
use crate::models::rollout::request::RolloutError;
use crate::models::training::error::TrainingError;
use crate::motion::pose::PoseError;
use nalgebra::DMatrix;
use std::ops::Range;
use thiserror::Error;

/// Why an import cannot begin.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The primitives move another body, or other parts of it.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// There are no frames to learn from.
    #[error("the file keeps no movement to learn its primitives again from: expected clips")]
    NoFrames,
    /// Clips are of one movement, in which a part uses one primitive, but the donor has several.
    #[error("expected one primitive of {part} to be learned again from clips, found {found}")]
    Several {
        /// The part.
        part: String,
        /// Primitives of the part.
        found: usize,
    },
    /// A part without a new primitive needs a companion.
    #[error(
        "expected a primitive of {part} in this library to take part with those that are learned \
         again, found none"
    )]
    NoCompanion {
        /// The part.
        part: String,
    },
    /// A companion does not belong to its part.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// A clip does not fit the host.
    #[error(transparent)]
    Clips(#[from] LibraryError),
    /// A movement of the donor cannot be rolled out.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
    /// A movement of the donor cannot be turned into poses.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// Training cannot start.
    #[error(transparent)]
    Training(#[from] TrainingError),
    /// Training cannot start because of one clip.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// A covariance of the host cannot be factorised.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

/// The frames from which an import learns.
#[derive(Clone, Copy, Debug)]
pub enum ImportFrames<'a> {
    /// Clips of the movement, as columns of the host.
    Clips(&'a [EncodedClip]),
    /// See `FramesFrom::Remembered`.
    Remembered,
    /// See `FramesFrom::Generated`.
    Generated,
}

impl ImportFrames<'_> {
    /// The source of the frames, for the origin of the new primitives.
    pub fn source(self) -> FramesFrom {
        match self {
            Self::Clips(_) => FramesFrom::Clips,
            Self::Remembered => FramesFrom::Remembered,
            Self::Generated => FramesFrom::Generated,
        }
    }
}

/// Request for an import.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportRequest {
    /// The companion of each part `[M]`: the primitive of the host that the part uses in movements for which
    /// the donor has no primitive of the part. `None` where no movement needs one.
    pub companions: Vec<Option<usize>>,
    /// Most iterations of the training.
    pub max_iterations: usize,
    /// The seed of everything random: which frames the inducing inputs start at.
    pub seed: u32,
}

/// A movement of the training.
pub(super) struct ImportedMovement {
    pub name: String,
    /// Its sequences.
    pub sequences: Range<usize>,
    /// The primitive of each part: first the companions are counted, then the new primitives.
    pub uses: Vec<usize>,
}

impl TrainedLibrary {
    /// The frames that an import of this library learns from without clips: poses of its latents, or rollouts
    /// where it stores only the first frames of a sequence.
    pub fn import_frames(&self) -> ImportFrames<'static> {
        let is_whole = |start: &Vec<DMatrix<f64>>| start.iter().all(|x| x.nrows() > self.library.order);
        match (0..self.library.primitives.len()).all(|a| self.library.starts_of(a).any(is_whole)) {
            true => ImportFrames::Remembered,
            false => ImportFrames::Generated,
        }
    }

    /// Default companions for an import of `donor` `[M]`: the primitive of each part that has the name of a
    /// movement or primitive of the donor, or else the first of the part.
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
