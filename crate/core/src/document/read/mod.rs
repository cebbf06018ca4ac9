//! Reads models from documents. Every field is checked where it is read.

mod baseline;
mod head;
mod library;
mod vcgpdm;

use crate::document::error::DocumentError;
use crate::document::read::head::Expected;
use crate::document::subject::Subject;
use crate::json::Value;
use crate::models::library::TrainedLibrary;
use crate::models::{Model, ModelKind};

/// Whether the document is that of a model of tables.
pub(super) fn has_columns(value: &Value) -> bool {
    matches!(value, Value::Object(fields) if fields.iter().any(|(name, _)| name == "columns"))
}

/// Reads a model of any kind.
pub(super) fn document<S: Subject>(value: &Value) -> Result<Model<S>, DocumentError> {
    let head = head::head::<S>(value, Expected::Model)?;
    match head.kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm => vcgpdm::vcgpdm(head),
        ModelKind::MapGpdm
        | ModelKind::MapCgpdm
        | ModelKind::Tmp
        | ModelKind::DmpDiscrete
        | ModelKind::DmpRhythmic => baseline::baseline(head),
    }
}

/// Reads a variational model. A program that reads no other kind does not contain the code of the others.
pub(super) fn vcgpdm_document(value: &Value) -> Result<Model, DocumentError> {
    let head = head::head(value, Expected::Model)?;
    match head.kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm => vcgpdm::vcgpdm(head),
        other => Err(DocumentError::Kind { found: other.id() }),
    }
}

/// Reads a library of primitives.
pub(super) fn library_document(value: &Value) -> Result<TrainedLibrary, DocumentError> {
    library::library(head::head(value, Expected::Library)?)
}
