//! Why a text is not a study.

use thiserror::Error;
use vcgpdm::internals::json::{FieldError, HeadingError, JsonError};

/// The field "format" of a study's document.
pub(super) const FORMAT: &str = "vcgpdm study";
/// Raised whenever an older program could no longer read the document.
pub(super) const VERSION: usize = 1;
/// More bytes than thousands of movements at 60 frames a second.
pub(super) const MOST_BYTES: usize = 64 << 20;

/// Why a text is not a study, or a study cannot be shown.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum StudyError {
    /// Larger than any study.
    #[error("expected a study of at most {} megabytes, found {found} bytes", MOST_BYTES >> 20)]
    Size {
        /// Bytes found.
        found: usize,
    },
    /// Not JSON.
    #[error("expected a study as JSON: {0}")]
    Json(JsonError),
    /// JSON, but something else.
    #[error("expected a study with \"format\": \"{FORMAT}\", found {found}")]
    Format {
        /// What the document says it is.
        found: String,
    },
    /// From a later program.
    #[error("expected a study of version {VERSION}, found version {found}; a newer program wrote it")]
    Version {
        /// What the document says.
        found: usize,
    },
    /// A field is missing, of the wrong type or out of its range.
    #[error("at {path}: {message}")]
    Field {
        /// The field's path.
        path: String,
        /// What was expected and found.
        message: String,
    },
    /// A number that JSON cannot hold.
    #[error("the study cannot be written: expected finite numbers, found {0}")]
    NotFinite(f64),
    /// There is no such movement.
    #[error("expected a movement of the study, found {0}")]
    Stimulus(String),
}

impl From<FieldError> for StudyError {
    fn from(FieldError { path, message }: FieldError) -> Self {
        StudyError::Field { path, message }
    }
}

impl From<HeadingError> for StudyError {
    fn from(error: HeadingError) -> Self {
        match error {
            HeadingError::Format { found } => Self::Format { found },
            HeadingError::Newer { found } => Self::Version { found },
            HeadingError::Field(field) => field.into(),
        }
    }
}
