//! Why a training could not start.

use crate::gp::NumericsError;
use crate::models::data::sequences::{SequencesError, too_short};
use crate::models::library::{CombinationError, PlanError};
use crate::models::variational::RepertoireError;
use crate::words::counted;
use thiserror::Error;

/// Why training could not start.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TrainingError {
    /// A setting is out of its range.
    #[error("{name} must be from {lowest} to {highest}, found {found}")]
    Setting {
        /// What the setting is called.
        name: &'static str,
        /// Smallest value.
        lowest: usize,
        /// Largest value.
        highest: usize,
        /// The value asked for.
        found: usize,
    },
    /// There is nothing to do.
    #[error("expected at least one phase in the schedule, found none")]
    NoPhases,
    /// There is no part.
    #[error("expected at least one part, found none")]
    NoParts,
    /// Observations and sequences do not fit each other.
    #[error("part {part} has {} of observations, but the sequences have {expected}", counted(*found, "frame"))]
    Frames {
        /// Counted from 0.
        part: usize,
        /// Frames of the sequences.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// Other parts than those that were learned before.
    #[error("expected observations of {expected} parts, found {found}")]
    Parts {
        /// Parts there are.
        expected: usize,
        /// Parts found.
        found: usize,
    },
    /// Other columns than those that were learned before.
    #[error("part {part} has {}, expected {expected}", counted(*found, "column"))]
    Columns {
        /// Counted from 0.
        part: usize,
        /// Columns that were learned.
        expected: usize,
        /// Columns found.
        found: usize,
    },
    /// Primitives that cannot be combined.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// No sequence is a whole movement.
    #[error("expected at least one whole movement to learn from, found none")]
    NoWhole,
    /// A sequence holds too little to learn from.
    #[error("sequence {sequence} {}", too_few(*found, *expected))]
    Short {
        /// Counted from 0.
        sequence: usize,
        /// Fewest frames.
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
    /// Movements and shared parts that do not fit the data.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The bound cannot be computed at the starting point.
    #[error("training could not start: {0}")]
    Numerics(#[from] NumericsError),
}

impl TrainingError {
    /// The sequence that the error is about, counted from 0; `None` when it is about all of them.
    pub fn sequence(&self) -> Option<usize> {
        self.of_sequence().map(|(sequence, _)| sequence)
    }

    /// The sequence that the error is about, and what is wrong with it, in words that follow its name.
    pub(crate) fn of_sequence(&self) -> Option<(usize, String)> {
        match self {
            TrainingError::Short { sequence, expected, found } => {
                Some((*sequence, too_few(*found, *expected)))
            }
            TrainingError::Sequences(SequencesError::TooShort { index, frames, order }) => {
                Some((*index, too_short(*frames, *order)))
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
