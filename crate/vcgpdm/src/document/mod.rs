//! The shared model as a versioned JSON document. No I/O.
//!
//! It holds what a rollout needs and no training clip: skeleton and pose mapping, column means, parts with their pose maps,
//! the dynamics into each part, couplings, the sums from which experts can be inferred again, start latents and provenance.
//! A document of another kind holds the same about the body, and under "model" what that kind needs to roll out.

mod read;
mod write;

use crate::gp::NumericsError;
use crate::json::{FieldError, JsonError, NotFinite, Value};
use crate::models::TrainedModel;
use crate::models::variational::Vcgpdm;
use crate::motion::parts::PartsError;
use thiserror::Error;

const FORMAT: &str = "vcgpdm model";
/// The first knows one kind of model, the variational one, and does not name it; the second says its "kind". A document is
/// written in the earliest version that can say it. Raised whenever an older program could no longer read the document.
const VERSION: usize = 2;
const MOST_BYTES: usize = 100 << 20;

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
    /// A model of another kind, where couplings and inducing points are asked for.
    #[error("expected a vcgpdm or vgpdm model, found a {found} model")]
    Kind {
        /// Its kind.
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

impl TrainedModel<Vcgpdm> {
    /// The model as a JSON document.
    ///
    /// # Errors
    ///
    /// When it holds a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&write::vcgpdm_document(self))
    }

    /// Reads the document of a variational model; nothing but a whole and consistent one is accepted.
    ///
    /// # Errors
    ///
    /// When the text is not such a document, with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        read::vcgpdm_document(&parsed(text)?)
    }
}

impl TrainedModel {
    /// The model as a JSON document.
    ///
    /// # Errors
    ///
    /// When it holds a number that is not finite.
    pub fn to_json(&self) -> Result<String, DocumentError> {
        text(&write::document(self))
    }

    /// Reads a document of any kind; nothing but a whole and consistent model is accepted.
    ///
    /// # Errors
    ///
    /// When the text is not such a document, with the path of the field that is wrong.
    pub fn from_json(text: &str) -> Result<Self, DocumentError> {
        read::document(&parsed(text)?)
    }
}

fn parsed(text: &str) -> Result<Value, DocumentError> {
    if text.len() > MOST_BYTES {
        return Err(DocumentError::Size { found: text.len() });
    }
    crate::json::parse(text).map_err(DocumentError::Json)
}

fn text(document: &Value) -> Result<String, DocumentError> {
    crate::json::write(document).map_err(|NotFinite(v)| DocumentError::NotFinite(v))
}

#[cfg(test)]
mod tests;
