//! Format and versions of documents, and the errors of reading and writing them.

use crate::gp::NumericsError;
use crate::json::{FieldError, HeadingError, JsonError};
use crate::motion::parts::PartsError;
use thiserror::Error;

/// The field "format" of a model's or a library's document.
pub const FORMAT: &str = "vcgpdm model";
/// Version 1 has no field "kind" and contains variational models alone; version 2 has other kinds too. Each
/// document is written in the earliest version that suffices, so that older programs can read it.
pub(super) const SECOND: usize = 2;
/// Version 3 adds models of tables, with "columns" instead of "pose", libraries of primitives, and
/// combinations of primitives.
pub(super) const THIRD: usize = 3;
/// Version 4 adds the noise variance of each column of a part.
pub(super) const VERSION: usize = 4;
/// The field "kind" of a library; that of a model is a `ModelKind`.
pub const LIBRARY: &str = "library";
/// Size limit: more than a model that trains for a day, and few enough bytes for a browser to read in
/// seconds.
pub(super) const MOST_BYTES: usize = 32 << 20;

/// Why a document cannot be read or written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DocumentError {
    /// Larger than any model.
    #[error("expected a model of at most {} megabytes, found {found} bytes", MOST_BYTES >> 20)]
    Size {
        /// Bytes found.
        found: usize,
    },
    /// Not JSON.
    #[error("expected a model as JSON: {0}")]
    Json(JsonError),
    /// JSON of another format.
    #[error("expected a model with \"format\": \"{FORMAT}\", found {found}")]
    Format {
        /// Its field "format".
        found: String,
    },
    /// Written by a newer program.
    #[error(
        "expected a model of version {VERSION} or earlier, found version {found}; a newer program wrote it"
    )]
    Version {
        /// Its version.
        found: usize,
    },
    /// A library instead of a model.
    #[error(
        "expected a model, found a library of primitives: choose one of its movements, or a primitive for \
         each part"
    )]
    Library,
    /// A model instead of a library.
    #[error("expected a library of primitives, found a {found} model")]
    NoLibrary {
        /// Its kind.
        found: &'static str,
    },
    /// A model of another kind instead of a variational model.
    #[error("expected a vcgpdm or vgpdm model, found a {found} model")]
    Kind {
        /// Its kind.
        found: &'static str,
    },
    /// A model of a body instead of one of tables, or the reverse.
    #[error("expected a model of {expected}, found a model of {found}")]
    Subject {
        /// The expected subject.
        expected: &'static str,
        /// The subject found.
        found: &'static str,
    },
    /// A field is missing, of the wrong type or out of its range.
    #[error("at {path}: {message}")]
    Field {
        /// The field's path.
        path: String,
        /// What was expected and found.
        message: String,
    },
    /// The parts do not fit the body.
    #[error("at parts: {0}")]
    Parts(#[from] PartsError),
    /// A matrix of the model cannot be factorised.
    #[error("the model cannot be used: {0}")]
    Numerics(#[from] NumericsError),
    /// The model to write has NaN or an infinity.
    #[error("the model cannot be written: expected finite numbers, found {0}")]
    NotFinite(f64),
}

impl From<FieldError> for DocumentError {
    fn from(FieldError { path, message }: FieldError) -> Self {
        DocumentError::Field { path, message }
    }
}

impl From<HeadingError> for DocumentError {
    fn from(error: HeadingError) -> Self {
        match error {
            HeadingError::Format { found } => Self::Format { found },
            HeadingError::Newer { found } => Self::Version { found },
            HeadingError::Field(field) => field.into(),
        }
    }
}

crate::coded!(DocumentError => Model);
