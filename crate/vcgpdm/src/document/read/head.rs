//! What the documents of all kinds of models have.

use crate::document::error::{DocumentError, FORMAT, LIBRARY, VERSION};
use crate::document::subject::Subject;
use crate::json::checks::{count, tame, within};
use crate::json::{Field, FieldError, Object, Value, check_heading};
use crate::models::{Body, ModelKind, SequenceInfo};
use crate::motion::parts::{PartSpec, PartsLayout};

/// More parts than a body has.
pub(super) const MOST_PARTS: usize = 64;
/// More sequences than a training has.
pub(super) const MOST_SEQUENCES: usize = 10_000;

/// What all kinds of documents have, and the rest.
pub(super) struct Head<'a, S> {
    pub(super) document: Object<'a>,
    /// The field that names the kind.
    named: Option<Field<'a>>,
    pub(super) kind: ModelKind,
    pub(super) mapping: S,
    column_means: Vec<f64>,
    frame_time: f64,
}

impl<S> Head<'_, S> {
    /// The body, once the model is known to be of the kind that the document names.
    pub(super) fn body(
        self,
        found: ModelKind,
        layout: PartsLayout,
        sequences: Vec<SequenceInfo>,
    ) -> Result<Body<S>, DocumentError> {
        if let Some(field) = &self.named
            && found != self.kind
        {
            let message = format!("expected {}, for so many parts, found {}", found.id(), self.kind.id());
            return Err(field.error(message).into());
        }
        self.whole(layout, sequences)
    }

    /// The body, once nothing else is left in the document.
    pub(super) fn whole(
        self,
        layout: PartsLayout,
        sequences: Vec<SequenceInfo>,
    ) -> Result<Body<S>, DocumentError> {
        self.document.end()?;
        let Head { mapping, column_means, frame_time, .. } = self;
        Ok(Body { mapping, layout, column_means, frame_time, sequences })
    }
}

/// What a document is asked to be.
#[derive(Clone, Copy)]
pub(super) enum Wanted {
    Model,
    Library,
}

pub(super) fn head<S: Subject>(value: &Value, wanted: Wanted) -> Result<Head<'_, S>, DocumentError> {
    let mut document = Field::root(value).object()?;
    check_heading(&mut document, FORMAT, 1..=VERSION)?;
    // The first version had no other kind and did not name it.
    let named = document.optional("kind");
    let library = matches!(named.as_ref().map(Field::value), Some(Value::Text(id)) if id == LIBRARY);
    let kind = named.as_ref().filter(|_| !library).map_or(Ok(ModelKind::Vcgpdm), kind)?;
    match wanted {
        Wanted::Model if library => return Err(DocumentError::Library),
        Wanted::Library if !library => return Err(DocumentError::NoLibrary { found: kind.id() }),
        Wanted::Model | Wanted::Library => {}
    }
    let other = if S::FIELD == "pose" { "columns" } else { "pose" };
    if document.optional(other).is_some() {
        let word = |field: &str| if field == "pose" { "a body" } else { "tables" };
        return Err(DocumentError::Subject { expected: word(S::FIELD), found: word(other) });
    }
    let mapping = S::from_field(document.get(S::FIELD)?)?;
    let frame_time = within(document.get("frame_time")?, 1e-5..=10.0, "seconds from 0.00001 to 10")?;
    let means = document.get("column_means")?;
    let column_means = means.numbers()?;
    count(&means, column_means.len(), mapping.column_count()..=mapping.column_count())?;
    tame(&means, &column_means)?;
    Ok(Head { document, named, kind, mapping, column_means, frame_time })
}

fn kind(field: &Field) -> Result<ModelKind, FieldError> {
    let id = field.text()?;
    ModelKind::from_id(id).ok_or_else(|| {
        let known: Vec<&str> = ModelKind::ALL.into_iter().map(ModelKind::id).collect();
        let found: String = id.chars().take(60).collect();
        field.error(format!("expected one of {}, found {found:?}", known.join(", ")))
    })
}

/// The name and the joints, or columns, of a part.
pub(super) fn part_spec<S: Subject>(part: &mut Object) -> Result<PartSpec, FieldError> {
    Ok(PartSpec {
        name: part.get("name")?.text()?.to_owned(),
        joints: part.get(S::PLACES)?.list(|joint| joint.whole())?,
    })
}

/// Where a training sequence came from.
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

/// The first frame of the file that was used, and the one after the last.
fn piece_of_file(field: &Field) -> Result<(usize, usize), FieldError> {
    match field.list(|frame| frame.whole())?[..] {
        [first, end] if first < end => Ok((first, end)),
        _ => Err(field.error("expected two frames, the first before the end")),
    }
}

/// What a person wants to say about the model.
pub(super) fn note(object: &mut Object) -> Result<Option<String>, FieldError> {
    match object.optional("note") {
        Some(note) if *note.value() != Value::Null => Ok(Some(note.text()?.to_owned())),
        _ => Ok(None),
    }
}

/// The frame rate that the clips were asked to be brought to.
pub(super) fn frames_per_second(object: &mut Object) -> Result<f64, FieldError> {
    within(object.get("frames_per_second")?, 0.1..=10_000.0, "frames a second from 0.1 to 10000")
}
