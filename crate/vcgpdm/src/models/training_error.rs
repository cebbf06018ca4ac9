//! Why a training could not start.

use crate::gp::NumericsError;
use crate::models::sequences::SequencesError;
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
    /// No sequence is a whole movement.
    #[error("expected at least one whole movement to learn from, found none")]
    NoWhole,
    /// A sequence holds too little to learn from.
    #[error("sequence {sequence} has {}; expected at least {expected}", counted(*found, "frame"))]
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
    /// The bound cannot be computed at the starting point.
    #[error("training could not start: {0}")]
    Numerics(#[from] NumericsError),
}

impl TrainingError {
    /// The sequence that the error is about, counted from 0; `None` when it is about all of them.
    pub fn sequence(&self) -> Option<usize> {
        match self {
            TrainingError::Short { sequence: found, .. }
            | TrainingError::Sequences(SequencesError::TooShort { index: found, .. }) => Some(*found),
            _ => None,
        }
    }
}

/// Checks that a setting of the given name is from 1 to `highest`.
pub(crate) fn in_range(name: &'static str, found: usize, highest: usize) -> Result<(), TrainingError> {
    if (1..=highest).contains(&found) {
        return Ok(());
    }
    Err(TrainingError::Setting { name, lowest: 1, highest, found })
}
