//! Stored documents with one value changed: each is read, or refused with an error.

use super::Lines;
use crate::documents::{DOCUMENTS, is_library};
use serde_json::{Value, json};
use vcgpdm_core::document::Document;
use vcgpdm_core::models::library::TrainedLibrary;

/// The place of each value in a document, as JSON pointers: of lists the first and the last item.
fn places(value: &Value, at: &str, places: &mut Vec<String>) {
    places.push(at.to_owned());
    match value {
        Value::Array(items) => {
            let last = items.len().saturating_sub(1);
            for (k, item) in items.iter().enumerate().filter(|(k, _)| [0, last].contains(k)) {
                self::places(item, &format!("{at}/{k}"), places);
            }
        }
        Value::Object(fields) => {
            for (name, field) in fields {
                self::places(field, &format!("{at}/{}", name.replace('/', "~1")), places);
            }
        }
        _ => {}
    }
}

/// Values in place of another one.
fn changed(value: &Value) -> Vec<Value> {
    match value {
        Value::Number(_) => vec![json!(0), json!(-1), json!(1e13), json!(0.5), json!(1e-200), json!("x")],
        Value::Array(items) => {
            let mut longer = items.clone();
            longer.extend(items.last().cloned());
            vec![items.iter().skip(1).cloned().collect(), Value::Array(longer), json!([])]
        }
        Value::Object(fields) => {
            let without = |name: &String| {
                let others = fields.iter().filter(|(other, _)| *other != name);
                Value::Object(others.map(|(name, value)| (name.clone(), value.clone())).collect())
            };
            let mut more = fields.clone();
            more.insert("other".to_owned(), json!(1));
            fields.keys().map(without).chain([Value::Object(more)]).collect()
        }
        _ => vec![json!(""), json!("x"), json!(1), Value::Null],
    }
}

pub fn documents() -> Lines {
    let mut lines = Lines::default();
    for (name, text) in DOCUMENTS {
        let document: Value = serde_json::from_str(text).unwrap();
        let mut all = Vec::new();
        places(&document, "", &mut all);
        for place in all {
            for other in changed(document.pointer(&place).unwrap()) {
                let mut changed = document.clone();
                *changed.pointer_mut(&place).unwrap() = other;
                let text = changed.to_string();
                let error = if is_library(name) {
                    TrainedLibrary::from_json(&text).err().map(|error| error.to_string())
                } else {
                    Document::from_json(&text).err().map(|error| error.to_string())
                };
                lines.0.push(format!("{name} {place}: {}", error.unwrap_or_else(|| "read".to_owned())));
            }
        }
    }
    lines
}
