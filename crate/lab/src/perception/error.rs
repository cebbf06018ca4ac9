//! Why a text is not a study.

use thiserror::Error;
use vcgpdm_core::json::{FieldError, HeadingError, JsonError};

/// The field "format" of a study's document.
pub(super) const FORMAT: &str = "vcgpdm study";
/// The version of the document. It is raised when older programs cannot read the document any more.
pub(super) const VERSION: usize = 1;
/// Largest document; thousands of movements at 60 frames a second are smaller.
pub(super) const MOST_BYTES: usize = 64 << 20;

/// Why a text is not a study, or a study cannot be shown.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum StudyError {
    /// The document is too large.
    #[error("expected a study of at most {} megabytes, found {found} bytes", MOST_BYTES >> 20)]
    Size {
        /// Bytes found.
        found: usize,
    },
    /// The text is not JSON.
    #[error("expected a study as JSON: {0}")]
    Json(JsonError),
    /// The JSON is another document.
    #[error("expected a study with \"format\": \"{FORMAT}\", found {found}")]
    Format {
        /// The format of the document.
        found: String,
    },
    /// A newer version wrote the document.
    #[error("expected a study of version {VERSION}, found version {found}; a newer program wrote it")]
    Version {
        /// The version of the document.
        found: usize,
    },
    /// A field is missing, of the wrong type or out of its range.
    #[error("at {path}: {message}")]
    Field {
        /// The field's path.
        path: String,
        /// The expectation, and the value found.
        message: String,
    },
    /// A number that JSON cannot hold.
    #[error("the study cannot be written: expected finite numbers, found {0}")]
    NotFinite(f64),
    /// There is no movement of this id.
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

vcgpdm_core::coded!(StudyError => Study);
