//! From the tree of a document to a model: every field is checked where it is read.

mod baseline;
mod head;
mod library;
mod settings;
mod vcgpdm;

use crate::document::error::DocumentError;
use crate::document::read::head::Wanted;
use crate::document::subject::Subject;
use crate::json::{Field, FieldError, Value};
use crate::models::library::TrainedLibrary;
use crate::models::{Model, ModelKind, Settings};

/// Whether the document is about tables.
pub(super) fn is_of_columns(value: &Value) -> bool {
    matches!(value, Value::Object(fields) if fields.iter().any(|(name, _)| name == "columns"))
}

/// A model of any kind.
pub(super) fn document<S: Subject>(value: &Value) -> Result<Model<S>, DocumentError> {
    let head = head::head::<S>(value, Wanted::Model)?;
    match head.kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm => vcgpdm::vcgpdm(head),
        ModelKind::MapGpdm
        | ModelKind::MapCgpdm
        | ModelKind::Tmp
        | ModelKind::DmpDiscrete
        | ModelKind::DmpRhythmic => baseline::baseline(head),
    }
}

/// A variational model. A program that asks for no other need not hold the code of the others.
pub(super) fn vcgpdm_document(value: &Value) -> Result<Model, DocumentError> {
    let head = head::head(value, Wanted::Model)?;
    match head.kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm => vcgpdm::vcgpdm(head),
        other => Err(DocumentError::Kind { found: other.id() }),
    }
}

/// What a training of a model of any kind was asked for, and the seed.
pub(super) fn settings(field: Field, kind: ModelKind) -> Result<(Settings, u32), FieldError> {
    match kind {
        ModelKind::Vcgpdm => {
            settings::variational_settings(field).map(|(settings, seed)| (Settings::Vcgpdm(settings), seed))
        }
        ModelKind::Vgpdm => {
            settings::variational_settings(field).map(|(settings, seed)| (Settings::Vgpdm(settings), seed))
        }
        _ => settings::baseline_settings(field, kind),
    }
}

/// A library of primitives.
pub(super) fn library_document(value: &Value) -> Result<TrainedLibrary, DocumentError> {
    library::library(head::head(value, Wanted::Library)?)
}
