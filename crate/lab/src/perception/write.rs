//! Writes a study as a JSON tree.

use crate::perception::error::VERSION;
use crate::perception::stimulus::{Generated, MovementSource, Scores, Stimulus};
use crate::perception::study::{Figure, Study};
use vcgpdm_core::document::write_settings;
use vcgpdm_core::json::Value;
use vcgpdm_core::models::variational::BoundTerms;

/// The whole study.
pub(super) fn document(study: &Study) -> Value {
    Value::object([
        ("format", Value::text(Study::FORMAT)),
        ("version", Value::whole(VERSION)),
        ("title", Value::text(&study.title)),
        ("look", Value::text(study.look.id())),
        ("seconds", Value::Number(study.seconds)),
        ("cross_seconds", Value::Number(study.cross_seconds)),
        ("texts", study.texts.value()),
        ("design", study.design.value()),
        ("frames_per_second", Value::whole(study.frames_per_second)),
        ("metres_per_unit", Value::Number(study.unit)),
        ("figure", figure(study)),
        ("stimuli", Value::list(&study.stimuli, |stimulus| movement(stimulus, true))),
    ])
}

/// The figure and the movements, without design, texts, marks, and errors on the training trials, which studies
/// of earlier versions lack.
pub(super) fn content(study: &Study) -> Value {
    Value::object([
        ("frames_per_second", Value::whole(study.frames_per_second)),
        ("metres_per_unit", Value::Number(study.unit)),
        ("figure", figure(study)),
        ("stimuli", Value::list(&study.stimuli, |stimulus| movement(stimulus, false))),
    ])
}

fn figure(study: &Study) -> Value {
    let Figure { names, parents, joints, landmarks } = &study.figure;
    let mut fields = vec![
        ("names", Value::list(names, |name| Value::text(name))),
        ("parents", Value::list(parents, |parent| parent.map_or(Value::Null, Value::whole))),
        ("joints", Value::whole(*joints)),
        ("height", Value::Number(study.height)),
    ];
    fields.extend(landmarks.head.map(|head| ("head", Value::whole(head))));
    fields.extend(landmarks.feet.map(|feet| ("feet", Value::wholes(&feet))));
    fields.push(("dots", Value::wholes(&landmarks.dots)));
    Value::Object(named(fields))
}

/// A movement; `whole`: with its mark and the error on the training trials.
fn movement(stimulus: &Stimulus, whole: bool) -> Value {
    let mut fields = vec![("id", Value::text(&stimulus.id))];
    match &stimulus.source {
        MovementSource::Natural { seen } => {
            fields.push(("kind", Value::text("natural")));
            fields.push(("trial", Value::text(&stimulus.trial)));
            fields.push(("seen", Value::Bool(*seen)));
        }
        MovementSource::Generated(generated) => {
            let Generated { candidate, seed, failed, scores } = &**generated;
            fields.push(("kind", Value::text("generated")));
            fields.push(("trial", Value::text(&stimulus.trial)));
            fields.push(("failed", Value::Bool(whole && *failed)));
            fields.push(("model", Value::text(candidate.kind().id())));
            fields.push(("settings", write_settings(candidate, *seed)));
            fields.push(("scores", scores_value(scores, whole)));
        }
    }
    fields.push(("speed", Value::Number(stimulus.speed)));
    fields.push(("frames", Value::whole(stimulus.movement.frames())));
    fields.push(("places", Value::text(stimulus.movement.text())));
    Value::Object(named(fields))
}

fn scores_value(scores: &Scores, whole: bool) -> Value {
    let Scores { mse, dtw_mse, training_mse, bound, terms } = scores;
    let mut fields = vec![("mse", Value::Number(*mse)), ("dtw_mse", Value::Number(*dtw_mse))];
    fields.extend(training_mse.filter(|_| whole).map(|error| ("training_mse", Value::Number(error))));
    fields.extend(bound.map(|bound| ("bound", Value::Number(bound))));
    fields.extend(terms.as_ref().map(|terms| {
        let BoundTerms { kinematics, dynamics, initial, entropy } = terms;
        let terms = Value::object([
            ("kinematics", Value::numbers(kinematics)),
            ("dynamics", Value::numbers(dynamics)),
            ("initial", Value::Number(*initial)),
            ("entropy", Value::Number(*entropy)),
        ]);
        ("terms", terms)
    }));
    Value::Object(named(fields))
}

fn named(fields: Vec<(&str, Value)>) -> Vec<(String, Value)> {
    fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}
