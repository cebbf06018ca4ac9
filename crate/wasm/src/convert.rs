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
    let value = serialized(value)?;
    renamed(&value, &|field| Ok(camel(field))).map_err(|reason| VcgpdmError::new(ErrorCode::Numerics, reason))
}

fn serialized<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, VcgpdmError> {
    let serializer = Serializer::new().serialize_missing_as_null(true).serialize_maps_as_objects(true);
    value.serialize(&serializer).map_err(|reason| VcgpdmError::new(ErrorCode::Numerics, words(&reason)))
}

/// A value from JavaScript. The error has this code; its words begin with `what` the value is.
pub fn from_js<T: DeserializeOwned>(code: ErrorCode, what: &str, value: &JsValue) -> Result<T, VcgpdmError> {
    let failed = |reason| VcgpdmError::new(code, format!("{what}: {reason}"));
    let value = renamed(value, &snake).map_err(failed)?;
    serde_wasm_bindgen::from_value(value).map_err(|reason| failed(words(&reason)))
}

/// A value as JSON, for a file: with the fields of the library. JavaScript writes it, as a library for it would weigh more.
#[cfg(feature = "comparison")]
pub fn to_json<T: Serialize>(value: &T) -> Result<String, VcgpdmError> {
    let text = js_sys::JSON::stringify(&serialized(value)?);
    text.map(String::from).map_err(|reason| VcgpdmError::new(ErrorCode::Numerics, thrown(&reason)))
}

/// A value from the JSON of a file: with the fields of the library.
#[cfg(feature = "comparison")]
pub fn from_json<T: DeserializeOwned>(code: ErrorCode, what: &str, text: &str) -> Result<T, VcgpdmError> {
    let failed = |reason| VcgpdmError::new(code, format!("{what}: {reason}"));
    let value = js_sys::JSON::parse(text).map_err(|reason| failed(thrown(&reason)))?;
    serde_wasm_bindgen::from_value(value).map_err(|reason| failed(thrown(&reason.into())))
}

/// What JavaScript says that it threw.
#[cfg(feature = "comparison")]
fn thrown(reason: &JsValue) -> String {
    reason.dyn_ref::<js_sys::Error>().map_or_else(String::new, |error| error.message().into())
}

/// Two values with their fields side by side in one object. (serde's `flatten` would weigh twenty times as much.)
pub fn to_js_beside<A: Serialize, B: Serialize>(first: &A, second: &B) -> Result<JsValue, VcgpdmError> {
    let (first, second) = (to_js(first)?, to_js(second)?);
    let (first, second): (&Object, &Object) = (first.unchecked_ref(), second.unchecked_ref());
    Ok(Object::assign(first, second).into())
}

/// Two values with their fields side by side in one object: the fields of these names, in snake_case, are the first's.
pub fn from_js_beside<A: DeserializeOwned, B: DeserializeOwned>(
    code: ErrorCode,
    what: &str,
    value: &JsValue,
    names: &[&str],
) -> Result<(A, B), VcgpdmError> {
    let (first, second) = (Object::new(), Object::new());
    if value.is_object() {
        for entry in Object::entries(value.unchecked_ref()).iter() {
            let entry: Array = entry.unchecked_into();
            let (name, value) = (entry.get(0), entry.get(1));
            let of_first = name.as_string().and_then(|name| snake(&name).ok());
            let of_first = of_first.is_some_and(|name| names.contains(&name.as_str()));
            // A new plain object refuses no field.
            let _ = Reflect::set(if of_first { &first } else { &second }, &name, &value);
        }
    }
    Ok((from_js(code, what, &first)?, from_js(code, what, &second)?))
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
    let mut words = String::new();
    for (k, piece) in text.trim_start_matches("Error: ").split('`').enumerate() {
        if k > 0 {
            words.push('`');
        }
        if k % 2 == 1 {
            words.push_str(&camel(piece));
        } else {
            words.push_str(piece);
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::ErrorCode;
    use js_sys::JSON;
    use serde::Deserialize;
    use wasm_bindgen_test::wasm_bindgen_test;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Inner {
        dtw_mse: f64,
    }

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Outer {
        dynamics_ips: Vec<Vec<usize>>,
        all_scores: Vec<Inner>,
        sha256: Option<String>,
    }

    fn outer() -> Outer {
        Outer {
            dynamics_ips: vec![vec![1, 2], vec![]],
            all_scores: vec![Inner { dtw_mse: 0.5 }],
            sha256: None,
        }
    }

    fn text(value: &JsValue) -> String {
        JSON::stringify(value).unwrap().into()
    }

    fn refusal(text: &str) -> String {
        let value = JSON::parse(text).unwrap();
        let refused = from_js::<Outer>(ErrorCode::Settings, "it", &value);
        let error: js_sys::Error = JsValue::from(refused.err().unwrap()).unchecked_into();
        error.message().into()
    }

    #[wasm_bindgen_test]
    fn fields_are_camel_case_in_javascript_at_every_depth() {
        let value = to_js(&outer()).ok().unwrap();
        let expected = r#"{"dynamicsIps":[[1,2],[]],"allScores":[{"dtwMse":0.5}],"sha256":null}"#;
        assert_eq!(text(&value), expected);
        assert_eq!(from_js::<Outer>(ErrorCode::Settings, "it", &value).ok().unwrap(), outer());
        assert_eq!(text(&value), expected, "what JavaScript gave is left as it was");
    }

    #[wasm_bindgen_test]
    fn rows_may_be_typed_arrays() {
        let row = js_sys::Float64Array::new_with_length(2);
        let value = from_js::<Vec<Vec<f64>>>(ErrorCode::Rollout, "it", &Array::of1(&row)).ok().unwrap();
        assert_eq!(value, [[0.0, 0.0]]);
    }

    #[wasm_bindgen_test]
    fn errors_name_fields_as_javascript_knows_them() {
        let snake = refusal(r#"{"dynamics_ips":[],"allScores":[]}"#);
        assert_eq!(snake, "it: expected fields in camelCase, found `dynamics_ips`; write `dynamicsIps`");
        assert_eq!(refusal(r#"{"allScores":[]}"#), "it: missing field `dynamicsIps`");
        assert_eq!(refusal(r#"{"dynamicsIps":[],"allScores":[{}]}"#), "it: missing field `dtwMse`");
        let unknown = refusal(r#"{"dynamicsIps":[],"allScores":[],"poseIps":1}"#);
        assert_eq!(
            unknown,
            "it: unknown field `poseIps`, expected one of `dynamicsIps`, `allScores`, `sha256`"
        );
        let kind = refusal(r#"{"dynamicsIps":"a_b","allScores":[]}"#);
        assert_eq!(kind, "it: invalid type: string \"a_b\", expected a sequence");
    }
}
