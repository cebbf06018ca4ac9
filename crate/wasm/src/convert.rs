//! Values of the library in JavaScript and back. Fields are snake_case in the library and in files, camelCase in JavaScript;
//! this is the only place that knows. Absent options are `null`.

use crate::error::{ErrorCode, VcgpdmError};
use js_sys::{Array, Object, Reflect, Symbol};
use nalgebra::DMatrix;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_wasm_bindgen::Serializer;
use wasm_bindgen::prelude::*;

/// A value for JavaScript.
pub fn to_js<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, VcgpdmError> {
    let serializer = Serializer::new().serialize_missing_as_null(true).serialize_maps_as_objects(true);
    let failed = |reason| VcgpdmError::new(ErrorCode::Numerics, reason);
    let value = value.serialize(&serializer).map_err(|reason| failed(words(&reason)))?;
    renamed(&value, &|field| Ok(camel(field))).map_err(failed)
}

/// A value from JavaScript. The error has this code; its words begin with `what` the value is.
pub fn from_js<T: DeserializeOwned>(code: ErrorCode, what: &str, value: &JsValue) -> Result<T, VcgpdmError> {
    let failed = |reason| VcgpdmError::new(code, format!("{what}: {reason}"));
    let value = renamed(value, &snake).map_err(failed)?;
    serde_wasm_bindgen::from_value(value).map_err(|reason| failed(words(&reason)))
}

/// The numbers of a matrix, row after row.
pub fn flat(matrix: &DMatrix<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

/// The rows of a matrix.
pub fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// A copy in which every field of every object has another name.
fn renamed(value: &JsValue, name: &dyn Fn(&str) -> Result<String, String>) -> Result<JsValue, String> {
    if Array::is_array(value) {
        let items: &Array = value.unchecked_ref();
        // Numbers have no fields, and there may be many.
        if items.get(0).as_f64().is_some() {
            return Ok(value.clone());
        }
        let copy = Array::new();
        for item in items.iter() {
            copy.push(&renamed(&item, name)?);
        }
        return Ok(copy.into());
    }
    let has_fields = value.is_object() && !Reflect::has(value, &Symbol::iterator()).unwrap_or(false);
    if !has_fields {
        return Ok(value.clone());
    }
    let (object, copy): (&Object, _) = (value.unchecked_ref(), Object::new());
    for entry in Object::entries(object).iter() {
        let entry: Array = entry.unchecked_into();
        let field = name(&entry.get(0).as_string().unwrap_or_default())?;
        // A new plain object refuses no field.
        let _ = Reflect::set(&copy, &field.into(), &renamed(&entry.get(1), name)?);
    }
    Ok(copy.into())
}

/// "dynamics_ips" as "dynamicsIps".
fn camel(field: &str) -> String {
    let mut words = field.split('_');
    let first = words.next().unwrap_or_default().to_owned();
    words.fold(first, |mut name, word| {
        let mut letters = word.chars();
        name.extend(letters.next().map(|letter| letter.to_ascii_uppercase()));
        name.push_str(letters.as_str());
        name
    })
}

/// "dynamicsIps" as "dynamics_ips".
fn snake(field: &str) -> Result<String, String> {
    if field.contains('_') {
        return Err(format!("expected fields in camelCase, found `{field}`; write `{}`", camel(field)));
    }
    let mut name = String::new();
    for letter in field.chars() {
        if letter.is_ascii_uppercase() {
            name.push('_');
        }
        name.push(letter.to_ascii_lowercase());
    }
    Ok(name)
}

/// What was wrong with a value, its fields named as JavaScript knows them: serde puts them in backticks.
fn words(reason: &serde_wasm_bindgen::Error) -> String {
    let text = reason.to_string();
    let pieces = text.trim_start_matches("Error: ").split('`').enumerate();
    let pieces: Vec<String> =
        pieces.map(|(k, piece)| if k % 2 == 1 { camel(piece) } else { piece.to_owned() }).collect();
    pieces.join("`")
}
