//! Why observed columns cannot be filtered.

use crate::gp::NumericsError;
use crate::models::rollout::request::RolloutError;
use thiserror::Error;

/// Why latents cannot be inferred from observed columns.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ObservationError {
    /// The rows have another number of parts than the model.
    #[error("expected columns of {expected} parts, found {found}")]
    Parts {
        /// Parts of the model.
        expected: usize,
        /// Parts found.
        found: usize,
    },
    /// A row has another number of columns than its part.
    #[error("expected {expected} numbers of part {part} in a frame, found {found}")]
    Columns {
        /// The part, counted from 0.
        part: usize,
        /// Columns of the part.
        expected: usize,
        /// Numbers found.
        found: usize,
    },
    /// The parts have different numbers of frames.
    #[error("expected {expected} frames of part {part} as of part 0, found {found}")]
    Frames {
        /// The part, counted from 0.
        part: usize,
        /// Frames of the first part.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// There are fewer frames than one history.
    #[error("expected at least {least} frames, one for each latent state of a history, found {found}")]
    Short {
        /// The order p of the dynamics.
        least: usize,
        /// Frames found.
        found: usize,
    },
    /// A number is infinite.
    #[error("expected finite numbers of part {part} or none, found {found} in frame {frame}")]
    NotFinite {
        /// The part, counted from 0.
        part: usize,
        /// The frame, counted from 0.
        frame: usize,
        /// The number found.
        found: f64,
    },
    /// No part is given, or none is left to infer.
    #[error(
        "the given parts: expected from 1 to {} of the parts 0 to {}, found {found:?}",
        parts - 1,
        parts - 1
    )]
    Given {
        /// Parts of the model.
        parts: usize,
        /// The numbers of the given parts.
        found: Vec<usize>,
    },
    /// The given parts are cut off too early or too late.
    #[error("the cut: expected a frame from {least} to {}, found {found}", end - 1)]
    Cut {
        /// The order p of the dynamics.
        least: usize,
        /// Frames of the recording.
        end: usize,
        /// The frame found.
        found: usize,
    },
    /// The model cannot move.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
    /// A covariance could not be factorised.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

crate::coded!(ObservationError {
    Self::Rollout(reason) => reason.code(),
    Self::Numerics(_) => Numerics,
    Self::Short { .. } => Clip,
    _ => Rollout,
});
