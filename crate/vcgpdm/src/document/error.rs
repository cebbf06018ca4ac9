//! The form of a document, and why a text or a model does not have it.

use crate::gp::NumericsError;
use crate::json::{FieldError, HeadingError, JsonError};
use crate::motion::parts::PartsError;
use thiserror::Error;

/// The field "format" of a model's or a library's document.
pub const FORMAT: &str = "vcgpdm model";
/// The first knows one kind of model, the variational one, and does not name it; the second says its "kind".
/// A document is written in the earliest version that can say it. Raised whenever an older program could no
/// longer read the document.
pub(super) const SECOND: usize = 2;
/// The third also knows models of tables, "columns" in the place of "pose", libraries of primitives, and
/// models that are combinations of these.
pub(super) const VERSION: usize = 3;
/// The field "kind" of a library; that of a model is a `ModelKind`.
pub const LIBRARY: &str = "library";
/// More bytes than a model has that can be trained in a day, and few enough for a browser to read in seconds.
pub(super) const MOST_BYTES: usize = 32 << 20;

/// Why a text is not a model that can be used, or a model cannot become a text.
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
    /// JSON, but something else.
    #[error("expected a model with \"format\": \"{FORMAT}\", found {found}")]
    Format {
        /// What the document says it is.
        found: String,
    },
    /// From a later program.
    #[error(
        "expected a model of version {VERSION} or earlier, found version {found}; a newer program wrote it"
    )]
    Version {
        /// What the document says.
        found: usize,
    },
    /// A library, where a model is asked for.
    #[error(
        "expected a model, found a library of primitives: choose one of its movements, or a primitive for \
         each part"
    )]
    Library,
    /// A model, where a library is asked for.
    #[error("expected a library of primitives, found a {found} model")]
    NoLibrary {
        /// Its kind.
        found: &'static str,
    },
    /// A model of another kind, where couplings and inducing points are asked for.
    #[error("expected a vcgpdm or vgpdm model, found a {found} model")]
    Kind {
        /// Its kind.
        found: &'static str,
    },
    /// A model of a body where one of tables is asked for, or the other way round.
    #[error("expected a model of {expected}, found a model of {found}")]
    Subject {
        /// What was asked for.
        expected: &'static str,
        /// What it is about.
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
    /// The maps of the model cannot be solved for.
    #[error("the model cannot be used: {0}")]
    Numerics(#[from] NumericsError),
    /// The model to be written holds NaN or an infinity.
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
