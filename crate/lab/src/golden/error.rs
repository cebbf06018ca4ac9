//! Errors from reading or evaluating a golden case.

use thiserror::Error;
use vcgpdm_core::gp::NumericsError;
use vcgpdm_core::models::variational::RepertoireError;
use vcgpdm_core::models::{RolloutError, SequencesError};

/// An error from reading or evaluating a case.
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
    /// The shapes of two inputs do not agree.
    #[error("at {path}: expected {expected}, found {found}")]
    Shape {
        /// The field's path.
        path: String,
        /// The shape expected.
        expected: String,
        /// The shape found.
        found: String,
    },
    /// The lengths are invalid.
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
