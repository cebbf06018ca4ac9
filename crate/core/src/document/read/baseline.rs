//! Reads a model that is not variational.

use crate::document::error::DocumentError;
use crate::document::read::head::{
    Head, MOST_PARTS, MOST_SEQUENCES, frames_per_second, note, part_spec, sequence_info,
};
use crate::document::settings::read_baseline;
use crate::document::subject::Subject;
use crate::json::checks::count;
use crate::models::dmp::Dmp;
use crate::models::map::MapModel;
use crate::models::tmp::Tmp;
use crate::models::{FittedModel, Model, ModelKind, Provenance};

/// Reads the rest of the document behind its head.
pub(super) fn baseline<S: Subject>(mut head: Head<S>) -> Result<Model<S>, DocumentError> {
    let parts = head.document.get("parts")?;
    let specs = parts.list(|part| {
        let mut object = part.object()?;
        let spec = part_spec::<S>(&mut object)?;
        object.end()?;
        Ok(spec)
    })?;
    count(&parts, specs.len(), 1..=MOST_PARTS)?;
    let layout = head.mapping.layout(&specs)?;
    let columns: Vec<usize> = (0..specs.len()).map(|part| layout.columns(part).len()).collect();
    let field = head.document.get("sequences")?;
    let sequences = field.list(|item| {
        let mut object = item.object()?;
        let info = sequence_info(&mut object)?;
        object.end()?;
        Ok(info)
    })?;
    count(&field, sequences.len(), 1..=MOST_SEQUENCES)?;
    let lengths: Vec<usize> = sequences.iter().map(|sequence| sequence.frames).collect();
    let field = head.document.get("model")?;
    let count = lengths.len();
    let model = match head.kind {
        ModelKind::MapGpdm | ModelKind::MapCgpdm => {
            FittedModel::Map(Box::new(MapModel::from_field(field, &columns, lengths)?))
        }
        ModelKind::Tmp => FittedModel::Tmp(Box::new(Tmp::from_field(field, &columns, count)?)),
        kind @ (ModelKind::DmpDiscrete | ModelKind::DmpRhythmic) => {
            FittedModel::Dmp(Box::new(Dmp::from_field(field, kind, &columns, count)?))
        }
        // These kinds are read in vcgpdm.rs.
        ModelKind::Vcgpdm | ModelKind::Vgpdm => return Err(field.error("expected a baseline").into()),
    };
    let mut object = head.document.get("provenance")?.object()?;
    let engine = object.get("engine")?.text()?.to_owned();
    let (settings, seed) = read_baseline(object.get("settings")?, head.kind)?;
    let provenance = Provenance {
        engine,
        settings,
        seed,
        frames_per_second: frames_per_second(&mut object)?,
        objective: object.get("objective")?.number()?,
        plain_bound: None,
        iterations: object.get("iterations")?.whole()?,
        evaluations: 0,
        rollout_rounds: 0,
        note: note(&mut object)?,
    };
    object.end()?;
    let body = head.body(model.kind(), layout, sequences)?;
    Ok(Model { fitted: model, body, provenance })
}
