//! Reads the fields that documents of all kinds have.

use crate::document::error::{DocumentError, FORMAT, LIBRARY, VERSION};
use crate::document::subject::Subject;
use crate::json::checks::{bounded, count, within};
use crate::json::{Field, FieldError, Object, Value, check_heading};
use crate::models::{Body, ModelKind, SequenceInfo};
use crate::motion::parts::{PartSpec, PartsLayout};
use crate::plural::counted;

/// Largest number of parts.
pub(super) const MOST_PARTS: usize = 64;
/// Largest number of training sequences.
pub(super) const MOST_SEQUENCES: usize = 10_000;

/// The fields that all kinds of documents have, and the object with the other fields.
pub(super) struct Head<'a, S> {
    pub(super) document: Object<'a>,
    /// The field that names the kind; `None` in version 1.
    kind_field: Option<Field<'a>>,
    pub(super) kind: ModelKind,
    pub(super) mapping: S,
    column_means: Vec<f64>,
    frame_time: f64,
}

impl<S> Head<'_, S> {
    /// The body, for a model of the kind `found`, which must be the kind that the document names.
    pub(super) fn body(
        self,
        found: ModelKind,
        layout: PartsLayout,
        sequences: Vec<SequenceInfo>,
    ) -> Result<Body<S>, DocumentError> {
        if let Some(field) = &self.kind_field
            && found != self.kind
        {
            let parts = counted(layout.parts().len(), "part");
            let message = format!("expected {} for {parts}, found {}", found.id(), self.kind.id());
            return Err(field.error(message).into());
        }
        self.finish(layout, sequences)
    }

    /// The body. Refuses a document with other fields.
    pub(super) fn finish(
        self,
        layout: PartsLayout,
        sequences: Vec<SequenceInfo>,
    ) -> Result<Body<S>, DocumentError> {
        self.document.end()?;
        let Head { mapping, column_means, frame_time, .. } = self;
        Ok(Body { mapping, layout, column_means, frame_time, sequences })
    }
}

/// What the caller expects.
#[derive(Clone, Copy)]
pub(super) enum Expected {
    Model,
    Library,
}

pub(super) fn head<S: Subject>(value: &Value, expected: Expected) -> Result<Head<'_, S>, DocumentError> {
    let mut document = Field::root(value).object()?;
    check_heading(&mut document, FORMAT, 1..=VERSION)?;
    // A document without this field is a variational model.
    let kind_field = document.optional("kind");
    let library = matches!(kind_field.as_ref().map(Field::value), Some(Value::Text(id)) if id == LIBRARY);
    let kind = kind_field.as_ref().filter(|_| !library).map_or(Ok(ModelKind::Vcgpdm), kind)?;
    match expected {
        Expected::Model if library => return Err(DocumentError::Library),
        Expected::Library if !library => return Err(DocumentError::NoLibrary { found: kind.id() }),
        Expected::Model | Expected::Library => {}
    }
    let other = if S::FIELD == "pose" { "columns" } else { "pose" };
    if document.optional(other).is_some() {
        let subject = |field: &str| if field == "pose" { "a body" } else { "tables" };
        return Err(DocumentError::Subject { expected: subject(S::FIELD), found: subject(other) });
    }
    let mapping = S::from_field(document.get(S::FIELD)?)?;
    let frame_time = within(document.get("frame_time")?, 1e-5..=10.0, "seconds from 0.00001 to 10")?;
    let means = document.get("column_means")?;
    let column_means = means.numbers()?;
    count(&means, column_means.len(), mapping.column_count()..=mapping.column_count())?;
    bounded(&means, &column_means)?;
    Ok(Head { document, kind_field, kind, mapping, column_means, frame_time })
}

fn kind(field: &Field) -> Result<ModelKind, FieldError> {
    let id = field.text()?;
    ModelKind::from_id(id).ok_or_else(|| {
        let ids: Vec<&str> = ModelKind::ALL.into_iter().map(ModelKind::id).collect();
        let found: String = id.chars().take(60).collect();
        field.error(format!("expected one of {}, found {found:?}", ids.join(", ")))
    })
}

/// Reads the name and the joints, or columns, of a part.
pub(super) fn part_spec<S: Subject>(part: &mut Object) -> Result<PartSpec, FieldError> {
    Ok(PartSpec {
        name: part.get("name")?.text()?.to_owned(),
        joints: part.get(S::PLACES)?.list(|joint| joint.whole())?,
    })
}

/// Reads the origin of a training sequence.
pub(super) fn sequence_info(sequence: &mut Object) -> Result<SequenceInfo, FieldError> {
    Ok(SequenceInfo {
        name: sequence.get("clip")?.text()?.to_owned(),
        sha256: sequence.get("sha256")?.text()?.to_owned(),
        frames: sequence.get("frames")?.whole()?,
        rests_from: match sequence.optional("rests_from") {
            Some(seconds) if *seconds.value() != Value::Null => Some(within(seconds, 0.0..=1e9, "seconds")?),
            _ => None,
        },
        piece: match sequence.optional("piece") {
            Some(piece) if *piece.value() != Value::Null => Some(piece_of_file(&piece)?),
            _ => None,
        },
        bones_of: match sequence.optional("bones_of") {
            Some(first) if *first.value() != Value::Null => Some(first.text()?.to_owned()),
            _ => None,
        },
        whole: match sequence.optional("whole") {
            Some(whole) => whole.boolean()?,
            None => true,
        },
    })
}

/// Reads the first frame of a piece and the one after its last.
fn piece_of_file(field: &Field) -> Result<(usize, usize), FieldError> {
    match field.list(|frame| frame.whole())?[..] {
        [first, end] if first < end => Ok((first, end)),
        _ => Err(field.error("expected two frames, the first before the end")),
    }
}

/// Reads the user's note on the model.
pub(super) fn note(object: &mut Object) -> Result<Option<String>, FieldError> {
    match object.optional("note") {
        Some(note) if *note.value() != Value::Null => Ok(Some(note.text()?.to_owned())),
        _ => Ok(None),
    }
}

/// Reads the frame rate that the training asked for.
pub(super) fn frames_per_second(object: &mut Object) -> Result<f64, FieldError> {
    within(object.get("frames_per_second")?, 0.1..=10_000.0, "frames a second from 0.1 to 10000")
}
