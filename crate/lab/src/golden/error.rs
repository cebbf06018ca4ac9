//! Why a golden case could not be read or evaluated.

use thiserror::Error;
use vcgpdm::gp::NumericsError;
use vcgpdm::models::variational::RepertoireError;
use vcgpdm::models::{RolloutError, SequencesError};

/// Why a case could not be read or evaluated.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CaseError {
    /// The text is not JSON of the expected form.
    #[error("at {path}: {message}")]
    Form {
        /// The field's path.
        path: String,
        /// The expectation, and the value found.
        message: String,
    },
    /// Shapes do not fit each other.
    #[error("at {path}: expected {expected}, found {found}")]
    Shape {
        /// The field's path.
        path: String,
        /// The shape expected.
        expected: String,
        /// The shape found.
        found: String,
    },
    /// Lengths cannot be used.
    #[error(transparent)]
    Sequences(#[from] SequencesError),
    /// Movements and primitives do not fit each other.
    #[error(transparent)]
    Repertoire(#[from] RepertoireError),
    /// The bound could not be computed.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
    /// A rollout could not be made.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
}
