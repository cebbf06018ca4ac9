//! Errors at the start of a training.

use crate::gp::NumericsError;
use crate::models::data::sequences::{SequencesError, too_few_for_order};
use crate::models::library::{CombinationError, PlanError};
use crate::models::training::pose_weight::POSE_WEIGHTS_TEXT;
use crate::models::variational::RepertoireError;
use crate::plural::counted;
use thiserror::Error;

/// Why a training could not start.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TrainingError {
    /// A setting is out of its range.
    #[error("{name} must be from {lowest} to {highest}, found {found}")]
    Setting {
        /// The name of the setting.
        name: &'static str,
        /// Smallest value.
        lowest: usize,
        /// Largest value.
        highest: usize,
        /// The value asked for.
        found: usize,
    },
    /// The weight of the pose terms is out of its range.
    #[error("the weight of the pose terms must be {POSE_WEIGHTS_TEXT}, found {found}")]
    PoseWeight {
        /// The weight asked for.
        found: f64,
    },
    /// The schedule is empty.
    #[error("expected at least one phase in the schedule, found none")]
    NoPhases,
    /// There is no part.
    #[error("expected at least one part, found none")]
    NoParts,
    /// Observations and sequences do not fit each other.
    #[error(
        "part {part} has {} of observations, but the sequences have {expected}",
        counted(*found, "frame")
    )]
    Frames {
        /// The part, counted from 0.
        part: usize,
        /// Frames of the sequences.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// The number of parts is not that of the model.
    #[error("expected observations of {expected} parts, found {found}")]
    Parts {
        /// Number of parts of the model.
        expected: usize,
        /// Number of parts found.
        found: usize,
    },
    /// A part does not have the columns that were learned.
    #[error("part {part} has {}, expected {expected}", counted(*found, "column"))]
    Columns {
        /// The part, counted from 0.
        part: usize,
        /// Columns that were learned.
        expected: usize,
        /// Columns found.
        found: usize,
    },
    /// The primitives cannot be combined.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// No sequence is a whole movement.
    #[error("expected at least one whole movement to learn from, found none")]
    NoWhole,
    /// A sequence has too few frames.
    #[error("sequence {sequence} {}", too_few(*found, *expected))]
    Short {
        /// The sequence, counted from 0.
        sequence: usize,
        /// The fewest frames.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// The sequences cannot be trained on.
    #[error(transparent)]
    Sequences(#[from] SequencesError),
    /// Movements and primitives do not fit each other.
    #[error(transparent)]
    Repertoire(#[from] RepertoireError),
    /// The plan of a library does not fit the data.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The bound cannot be computed at the starting point.
    #[error("training could not start: {0}")]
    Numerics(#[from] NumericsError),
}

impl TrainingError {
    /// The sequence that causes the error, counted from 0; `None` when it is not a single sequence.
    pub fn sequence(&self) -> Option<usize> {
        self.sequence_problem().map(|(sequence, _)| sequence)
    }

    /// The sequence that causes the error, and its problem, to follow its name in a message.
    pub(crate) fn sequence_problem(&self) -> Option<(usize, String)> {
        match self {
            TrainingError::Short { sequence, expected, found } => {
                Some((*sequence, too_few(*found, *expected)))
            }
            TrainingError::Sequences(SequencesError::TooShort { index, frames, order }) => {
                Some((*index, too_few_for_order(*frames, *order)))
            }
            _ => None,
        }
    }
}

fn too_few(found: usize, expected: usize) -> String {
    format!("has {}; expected at least {expected}", counted(found, "frame"))
}

/// Checks that a setting of the given name is from 1 to `highest`.
pub(crate) fn in_range(name: &'static str, found: usize, highest: usize) -> Result<(), TrainingError> {
    if (1..=highest).contains(&found) {
        return Ok(());
    }
    Err(TrainingError::Setting { name, lowest: 1, highest, found })
}

crate::coded!(TrainingError {
    Self::Setting { .. } | Self::PoseWeight { .. } => Settings,
    Self::Numerics(_) => Numerics,
    _ => Training,
});
