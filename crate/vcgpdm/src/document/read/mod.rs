//! From the tree of a document to a model: every field is checked where it is read.

mod baseline;
mod head;
mod settings;
mod vcgpdm;

use crate::document::error::DocumentError;
use crate::json::{Field, FieldError, Value};
use crate::models::variational::Vcgpdm;
use crate::models::{ModelKind, ModelSettings, TrainedModel};

/// A model of any kind.
pub(super) fn document(value: &Value) -> Result<TrainedModel, DocumentError> {
    let head = head::head(value)?;
    match head.kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm => Ok(vcgpdm::vcgpdm(head)?.into()),
        ModelKind::MapGpdm
        | ModelKind::MapCgpdm
        | ModelKind::Tmp
        | ModelKind::DmpDiscrete
        | ModelKind::DmpRhythmic => baseline::baseline(head),
    }
}

/// A variational model. A program that asks for no other need not hold the code of the others.
pub(super) fn vcgpdm_document(value: &Value) -> Result<TrainedModel<Vcgpdm>, DocumentError> {
    let head = head::head(value)?;
    match head.kind {
        ModelKind::Vcgpdm | ModelKind::Vgpdm => vcgpdm::vcgpdm(head),
        other => Err(DocumentError::Kind { found: other.id() }),
    }
}

/// What a training of a model of any kind was asked for, and the seed.
pub(super) fn settings(field: Field, kind: ModelKind) -> Result<(ModelSettings, u32), FieldError> {
    match kind {
        ModelKind::Vcgpdm => settings::variational_settings(field)
            .map(|(settings, seed)| (ModelSettings::Vcgpdm(settings), seed)),
        ModelKind::Vgpdm => settings::variational_settings(field)
            .map(|(settings, seed)| (ModelSettings::Vgpdm(settings), seed)),
        _ => settings::baseline_settings(field, kind),
    }
}
