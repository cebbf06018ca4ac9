//! Values of the library in JavaScript and back. Fields are snake_case in the library and in files, camelCase
//! in JavaScript; only this file and `read.rs` convert them. Absent options are `null`.
//!
//! A visitor downloads this code, so generic functions are small.

use crate::values::error::{ErrorCode, VcgpdmError};
use crate::values::read::{Names, Value, check_object, fields_of};
use crate::values::wording::camel;
use js_sys::{Array, ArrayBuffer, Object, Reflect};
use nalgebra::DMatrix;
use serde::Serialize;
use serde::de::DeserializeOwned;
#[cfg(feature = "training")]
use serde::de::{Deserializer, Visitor};
use serde_wasm_bindgen::{Error, Serializer};
use wasm_bindgen::prelude::*;

const SERIALIZER: Serializer =
    Serializer::new().serialize_missing_as_null(true).serialize_maps_as_objects(true);

/// A value for JavaScript.
pub fn to_js<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, VcgpdmError> {
    Ok(renamed(&value.serialize(&SERIALIZER).map_err(unconverted)?))
}

/// A value from JavaScript. The error has this code; its message begins with `what`, the value's name.
pub fn from_js<T: DeserializeOwned>(code: ErrorCode, what: &str, value: &JsValue) -> Result<T, VcgpdmError> {
    read(code, what, Value::new(value, Names::JavaScript, &[]))
}

fn read<T: DeserializeOwned>(code: ErrorCode, what: &str, value: Value) -> Result<T, VcgpdmError> {
    let names = value.names;
    T::deserialize(value).map_err(|reason| reason.named(code, what, names))
}

/// The names of the fields of a struct; none of anything else.
#[cfg(feature = "training")]
fn fields<T: DeserializeOwned>() -> &'static [&'static str] {
    let mut fields: &[&str] = &[];
    // Always fails: `FieldNames` has no value, it only collects names.
    let _ = T::deserialize(FieldNames(&mut fields));
    fields
}

/// Collects the field names of a struct.
#[cfg(feature = "training")]
struct FieldNames<'a>(&'a mut &'static [&'static str]);

#[cfg(feature = "training")]
impl<'de> Deserializer<'de> for FieldNames<'_> {
    type Error = serde::de::value::Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Self::Error> {
        Err(serde::de::Error::custom("no value"))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Self::Error> {
        *self.0 = fields;
        self.deserialize_any(visitor)
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct newtype_struct seq
        tuple tuple_struct map enum identifier ignored_any
    }
}

/// One object with the fields of two values. (serde's `flatten` would take ten times as many bytes of wasm.)
pub fn to_js_joined<A: Serialize, B: Serialize>(first: &A, second: &B) -> Result<JsValue, VcgpdmError> {
    let (first, second) = (to_js(first)?, to_js(second)?);
    let (first, second): (&Object, &Object) = (first.unchecked_ref(), second.unchecked_ref());
    Ok(Object::assign(first, second).into())
}

/// A copy of the caller's options in which absent fields are those of `defaults`. Absent options are the
/// defaults. An error names the options by `what`.
pub fn with_defaults(
    code: ErrorCode,
    what: &str,
    options: &JsValue,
    defaults: JsValue,
) -> Result<JsValue, VcgpdmError> {
    if options.is_undefined() {
        return Ok(defaults);
    }
    check_object(options).map_err(|reason| reason.named(code, what, Names::JavaScript))?;
    for name in Object::keys(options.unchecked_ref::<Object>()).iter() {
        let value = Reflect::get(options, &name).map_err(VcgpdmError::Thrown)?;
        if !value.is_undefined() {
            // A new plain object accepts any field.
            let _ = Reflect::set(&defaults, &name, &value);
        }
    }
    Ok(defaults)
}

/// Two structs from one object with the fields of both.
#[cfg(feature = "training")]
pub fn from_js_split<A: DeserializeOwned, B: DeserializeOwned>(
    code: ErrorCode,
    what: &str,
    value: &JsValue,
) -> Result<(A, B), VcgpdmError> {
    let (first, second) = (fields::<A>(), fields::<B>());
    let first_struct = read(code, what, Value::new(value, Names::JavaScript, second))?;
    Ok((first_struct, read(code, what, Value::new(value, Names::JavaScript, first))?))
}

/// A value as JSON for a file, with the fields of the library. JavaScript's own writer saves bytes of wasm.
#[cfg(feature = "training")]
pub fn to_json<T: Serialize>(value: &T) -> Result<String, VcgpdmError> {
    let value = value.serialize(&SERIALIZER).map_err(unconverted)?;
    js_sys::JSON::stringify(&value).map(String::from).map_err(|reason| unconverted(reason.into()))
}

/// A value from the JSON of a file, with the fields of the library.
#[cfg(feature = "training")]
pub fn from_json<T: DeserializeOwned>(code: ErrorCode, what: &str, text: &str) -> Result<T, VcgpdmError> {
    let value = js_sys::JSON::parse(text).map_err(|thrown| {
        // Always an error of the class SyntaxError.
        let reason: js_sys::Error = thrown.unchecked_into();
        VcgpdmError::new(code, &format_args!("{what}: {}", String::from(reason.message())))
    })?;
    read(code, what, Value::new(&value, Names::File, &[]))
}

/// A matrix from its rows.
#[cfg(feature = "training")]
pub fn matrix(alpha: &[Vec<f64>]) -> DMatrix<f64> {
    // A missing entry becomes NaN, which the library refuses.
    let at = |j: usize, i: usize| alpha.get(j).and_then(|row: &Vec<f64>| row.get(i)).copied();
    let columns = alpha.iter().map(Vec::len).max().unwrap_or(0);
    DMatrix::from_fn(alpha.len(), columns, |j, i| at(j, i).unwrap_or(f64::NAN))
}

/// The numbers of a matrix, row after row.
pub fn flat(matrix: &DMatrix<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

/// The rows of a matrix.
pub fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

fn unconverted(reason: Error) -> VcgpdmError {
    let text = reason.to_string();
    // JavaScript puts the name of the class before the message.
    VcgpdmError::new(ErrorCode::Numerics, &text.strip_prefix("Error: ").unwrap_or(&text))
}

/// A copy in which every field of every object has its name in JavaScript.
fn renamed(value: &JsValue) -> JsValue {
    if Array::is_array(value) {
        let items: &Array = value.unchecked_ref();
        // Numbers have no fields, and there may be many.
        if items.get(0).as_f64().is_some() {
            return value.clone();
        }
        return items.iter().map(|item| renamed(&item)).collect::<Array>().into();
    }
    if !value.is_object() || ArrayBuffer::is_view(value) {
        return value.clone();
    }
    let copy = Object::new();
    for field in fields_of(value) {
        // Both are plain objects of ours: no getter throws, and any field is accepted.
        let inner = Reflect::get(value, &field.as_str().into()).unwrap_or_default();
        let _ = Reflect::set(&copy, &camel(&field).into(), &renamed(&inner));
    }
    copy.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::values::error::ErrorCode;
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
        assert_eq!(text(&value), expected, "the argument is not changed");
    }

    #[wasm_bindgen_test]
    fn two_structs_share_one_object() {
        let both = |text: &str| {
            let value = JSON::parse(text).unwrap();
            from_js_split::<Inner, Outer>(ErrorCode::Settings, "it", &value)
        };
        let (first, second) =
            both(r#"{"dynamicsIps":[[1,2],[]],"dtwMse":0.5,"allScores":[{"dtwMse":0.5}]}"#).ok().unwrap();
        assert_eq!((first, second), (Inner { dtw_mse: 0.5 }, outer()));
        let error: js_sys::Error = JsValue::from(both(r#"{"bogus":3}"#).err().unwrap()).unchecked_into();
        let expected =
            "it: unknown field `bogus`, expected some of `dtwMse`, `dynamicsIps`, `allScores`, `sha256`";
        assert_eq!(String::from(error.message()), expected);
    }

    #[wasm_bindgen_test]
    fn a_null_field_is_named() {
        let refused = refusal(r#"{"dynamicsIps":null,"allScores":[],"sha256":null}"#);
        assert_eq!(refused, "it: `dynamicsIps`: expected a list, found null");
    }

    #[wasm_bindgen_test]
    fn the_error_of_a_getter_is_passed_on() {
        let options = js_sys::eval(r#"({ get dynamicsIps() { throw new RangeError("mine"); } })"#).unwrap();
        let thrown = JsValue::from(from_js::<Outer>(ErrorCode::Settings, "it", &options).err().unwrap());
        let error: js_sys::Error = thrown.unchecked_into();
        assert_eq!(
            (String::from(error.name()), String::from(error.message())),
            ("RangeError".into(), "mine".into())
        );
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
        let inner = refusal(r#"{"dynamicsIps":[],"allScores":[{}]}"#);
        assert_eq!(inner, "it: `allScores[0]`: missing field `dtwMse`");
        let unknown = refusal(r#"{"dynamicsIps":[],"allScores":[],"allScore":1}"#);
        assert_eq!(
            unknown,
            "it: unknown field `allScore`, expected some of `dynamicsIps`, `allScores`, `sha256`"
        );
        let kinds = [
            (
                r#"[["a_b"]]"#,
                "`dynamicsIps[0][0]`: expected a whole number from 0 to 4294967295, found \"a_b\"",
            ),
            ("[[1, 1.5]]", "`dynamicsIps[0][1]`: expected a whole number from 0 to 4294967295, found 1.5"),
            ("[[], true]", "`dynamicsIps[1]`: expected a list, found true"),
            (r#"{"a_b":1}"#, "`dynamicsIps`: expected a list, found an object"),
        ];
        for (found, words) in kinds {
            let text = format!(r#"{{"dynamicsIps":{found},"allScores":[]}}"#);
            assert_eq!(refusal(&text), format!("it: {words}"));
        }
    }
}
