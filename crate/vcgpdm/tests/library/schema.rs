//! Compares docs/model.schema.json with the reader: written documents are valid, and both refuse the same
//! changes of shape.

use crate::documents::DOCUMENTS;
use boon::{Compiler, SchemaIndex, Schemas};
use serde_json::{Map, Value, json};
use vcgpdm::document::Document;
use vcgpdm::models::library::TrainedLibrary;
use vcgpdm::models::{
    Dataset, DmpSettings, MapSettings, PoseWeight, Settings, Source, TmpSettings, Trainer,
    VariationalSettings,
};
use vcgpdm::motion::{parts, samples};

/// The compiled schema.
struct Schema {
    schemas: Schemas,
    index: SchemaIndex,
}

impl Schema {
    fn new() -> Self {
        let text = include_str!("../../../../docs/model.schema.json");
        let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
        compiler.add_resource("model.schema.json", serde_json::from_str(text).unwrap()).unwrap();
        let index = compiler.compile("model.schema.json", &mut schemas).unwrap();
        Self { schemas, index }
    }

    fn refusal(&self, document: &Value) -> Option<String> {
        self.schemas.validate(document, self.index).err().map(|error| format!("{error:#}"))
    }
}

fn reader_refusal(document: &Value) -> Option<String> {
    let text = document.to_string();
    match document["kind"] == "library" {
        true => TrainedLibrary::from_json(&text).err().map(|error| error.to_string()),
        false => Document::from_json(&text).err().map(|error| error.to_string()),
    }
}

/// All fields of a document as JSON pointers, and the first two items of each list.
fn places(value: &Value, at: &str, found: &mut Vec<String>) {
    found.push(at.to_owned());
    match value {
        Value::Object(fields) => {
            for (name, field) in fields {
                places(field, &format!("{at}/{name}"), found);
            }
        }
        Value::Array(items) => {
            for (k, item) in items.iter().enumerate().take(2) {
                places(item, &format!("{at}/{k}"), found);
            }
        }
        _ => {}
    }
}

fn same_type(a: &Value, b: &Value) -> bool {
    std::mem::discriminant(a) == std::mem::discriminant(b)
}

/// Replacements for a value, and whether each changes its shape: the others change only a number or a length.
fn changes(value: &Value) -> Vec<(Value, bool)> {
    let others =
        [Value::Null, json!(true), json!("x"), json!(3), json!([]), json!({}), json!(-1), json!(0.5)];
    let mut changed: Vec<(Value, bool)> = others
        .into_iter()
        .filter(|other| other != value)
        .map(|other| {
            let shape = !same_type(&other, value);
            (other, shape)
        })
        .collect();
    if let Value::Object(fields) = value {
        let mut more = fields.clone();
        more.insert("unknown".to_owned(), json!(1));
        changed.push((Value::Object(more), true));
        for name in fields.keys() {
            let rest: Map<String, Value> = fields
                .iter()
                .filter(|(other, _)| *other != name)
                .map(|(n, v)| (n.clone(), v.clone()))
                .collect();
            changed.push((Value::Object(rest), true));
        }
    }
    changed
}

#[test]
#[ignore = "seldom: npm test -- --all"]
fn the_schema_and_the_reader_accept_and_refuse_the_same() {
    let schema = Schema::new();
    let (mut refused_both, mut numbers) = (0, 0);
    for (kind, text) in DOCUMENTS {
        let document: Value = serde_json::from_str(text).unwrap();
        assert_eq!(schema.refusal(&document), None, "{kind}");
        assert_eq!(reader_refusal(&document), None, "{kind}");
        let mut found = Vec::new();
        places(&document, "", &mut found);
        for place in found {
            for (other, shape) in changes(document.pointer(&place).unwrap()) {
                let mut changed = document.clone();
                *changed.pointer_mut(&place).unwrap() = other.clone();
                let (by_schema, by_reader) = (schema.refusal(&changed), reader_refusal(&changed));
                let message = || format!("{kind} at {place} with {other}: {by_schema:?}, {by_reader:?}");
                // A document that the reader accepts is valid.
                assert!(by_schema.is_none() || by_reader.is_some(), "{}", message());
                // The schema cannot check which joint is the root.
                if shape && !place.ends_with("/parent") {
                    assert!(by_schema.is_some() == by_reader.is_some(), "{}", message());
                    refused_both += usize::from(by_schema.is_some());
                }
                numbers += usize::from(!shape && by_schema.is_some());
            }
        }
    }
    assert!(refused_both > 5000 && numbers > 300, "{refused_both} shapes and {numbers} numbers were refused");
}

#[test]
fn documents_of_new_trainings_are_valid() {
    let schema = Schema::new();
    let first = include_str!("../../../../www/first/model.json");
    assert_eq!(schema.refusal(&serde_json::from_str(first).unwrap()), None);
    let clips = ["walk-1", "walk-2"].map(|id| samples::clip(id).unwrap().cut(0, 60).unwrap());
    let source = |k: usize, first_frames| Source { clip: &clips[k], first_frames };
    let sources = [source(0, None), source(1, Some(20))];
    let preset = |k: usize| parts::presets(&clips[0].skeleton)[k].parts.clone();
    let variational = VariationalSettings {
        latent: 2,
        dynamics_ips: 4,
        pose_ips: 4,
        max_iterations: 3,
        ..Default::default()
    };
    let point =
        MapSettings { latent: 2, max_iterations: 3, balanced: true, linear: true, ..Default::default() };
    for (k, settings) in [
        (0, Settings::Vgpdm(variational.clone())),
        (1, Settings::Vcgpdm(variational.clone())),
        (
            0,
            Settings::Vgpdm(VariationalSettings { pose_weight: PoseWeight::Balanced, ..variational.clone() }),
        ),
        (
            1,
            Settings::Vcgpdm(VariationalSettings {
                pose_weight: PoseWeight::Fixed(0.1),
                uncoupled: true,
                ..variational
            }),
        ),
        (1, Settings::MapCgpdm(point.clone())),
        (0, Settings::MapGpdm(point)),
        (1, Settings::Tmp(TmpSettings { primitives: Some(2), normalised_time: true })),
        (1, Settings::DmpDiscrete(DmpSettings { bases: 4 })),
        (1, Settings::DmpRhythmic(DmpSettings { bases: 4 })),
    ] {
        let dataset = Dataset::new(&sources, &preset(k), 30.0).unwrap();
        let mut trainer = Trainer::new(&dataset, &settings, 0).unwrap();
        trainer.run();
        let mut trained = trainer.finish().unwrap();
        trained.provenance.note = Some("a note".to_owned());
        trained.body.sequences[1].rests_from = Some(0.5);
        let document = serde_json::from_str(&trained.to_json().unwrap()).unwrap();
        assert_eq!(schema.refusal(&document), None, "{}", trained.kind().id());
    }
}
