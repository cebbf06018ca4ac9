//! Why a golden case could not be read or evaluated.

use thiserror::Error;
use vcgpdm::gp::NumericsError;
use vcgpdm::models::variational::RepertoireError;
use vcgpdm::models::{RolloutError, SequencesError};

/// Why a case could not be read or evaluated.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CaseError {
    /// Not JSON of the expected form.
    #[error("at {path}: {message}")]
    Form {
        /// The field's path.
        path: String,
        /// What was expected and found.
        message: String,
    },
    /// Shapes that do not fit each other.
    #[error("at {path}: expected {expected}, found {found}")]
    Shape {
        /// The field's path.
        path: String,
        /// What would fit.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// Lengths that cannot be used.
    #[error(transparent)]
    Sequences(#[from] SequencesError),
    /// Movements and primitives that do not fit each other.
    #[error(transparent)]
    Repertoire(#[from] RepertoireError),
    /// The bound could not be computed.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
    /// A rollout could not be made.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
}
