//! Values of the library in JavaScript and back. Fields are snake_case in the library and in files, camelCase
//! in JavaScript; only this file converts them. Absent options are `null`.
//!
//! A visitor downloads this code, so generic functions are small.

use crate::arguments::found_value;
use crate::error::{ErrorCode, VcgpdmError};
use js_sys::{Array, ArrayBuffer, Object, Reflect};
use nalgebra::DMatrix;
use serde::Serialize;
use serde::de::{DeserializeOwned, Deserializer, Visitor};
use serde_wasm_bindgen::{Error, Serializer};
use wasm_bindgen::prelude::*;

const SERIALIZER: Serializer =
    Serializer::new().serialize_missing_as_null(true).serialize_maps_as_objects(true);

/// A value for JavaScript.
pub fn to_js<T: Serialize + ?Sized>(value: &T) -> Result<JsValue, VcgpdmError> {
    in_camel_case(value.serialize(&SERIALIZER))
}

/// A value from JavaScript. The error has this code; its message begins with `what`, the value's name.
pub fn from_js<T: DeserializeOwned>(code: ErrorCode, what: &str, value: &JsValue) -> Result<T, VcgpdmError> {
    read(code, what, checked(code, what, value, fields::<T>())?)
}

/// A copy of a value with the field names of the library. Unknown fields are an error.
fn checked(code: ErrorCode, what: &str, value: &JsValue, fields: &[&str]) -> Result<JsValue, VcgpdmError> {
    let value = renamed(value, &snake).map_err(|problem| match problem {
        Problem::Name(reason) => refused(code, what, &reason),
        Problem::Thrown(value) => VcgpdmError::Thrown(value),
    })?;
    check_fields(&value, fields).map_err(|reason| refused(code, what, &reason))?;
    Ok(value)
}

fn read<T: DeserializeOwned>(code: ErrorCode, what: &str, value: JsValue) -> Result<T, VcgpdmError> {
    let attempt = |value: JsValue| serde_wasm_bindgen::from_value::<T>(value);
    attempt(value.clone()).map_err(|reason| {
        let problem = |value: JsValue| attempt(value).err();
        refused(code, what, &reason_of(&value, &reason, &problem))
    })
}

/// Why a value cannot be read. Reading a list from null gives a message of JavaScript's own; without the
/// field, serde names it. `problem`: the error of another value.
fn reason_of(value: &JsValue, reason: &Error, problem: &dyn Fn(JsValue) -> Option<Error>) -> String {
    for field in fields_of(value) {
        let missing = format!("missing field `{field}`");
        let copy = without_null(value, &field);
        if copy
            .and_then(|copy| problem(copy.into()))
            .is_some_and(|problem| problem.to_string().contains(&missing))
        {
            return format!("`{}`: expected a value, found null", camel(&field, true));
        }
    }
    message(reason)
}

/// A copy of an object without this field; none where the field is not null.
fn without_null(value: &JsValue, field: &str) -> Option<Object> {
    if !Reflect::get(value, &field.into()).is_ok_and(|inner| inner.is_null()) {
        return None;
    }
    let copy = Object::assign(&Object::new(), value.unchecked_ref::<Object>());
    Reflect::delete_property(&copy, &field.into()).is_ok_and(|deleted| deleted).then_some(copy)
}

/// The names of the fields of a value.
fn fields_of(value: &JsValue) -> Vec<String> {
    if !value.is_object() {
        return Vec::new();
    }
    Object::keys(value.unchecked_ref::<Object>()).iter().filter_map(|field| field.as_string()).collect()
}

/// The names of the fields of a struct; none of anything else.
fn fields<T: DeserializeOwned>() -> &'static [&'static str] {
    let mut fields: &[&str] = &[];
    // Always fails: `FieldNames` has no value, it only collects names.
    let _ = T::deserialize(FieldNames(&mut fields));
    fields
}

/// Collects the field names of a struct. serde_wasm_bindgen reads only these fields and ignores others.
struct FieldNames<'a>(&'a mut &'static [&'static str]);

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

/// Refuses an object with an unknown field. An empty list of names allows any field.
fn check_fields(value: &JsValue, fields: &[&str]) -> Result<(), String> {
    if fields.is_empty() {
        return Ok(());
    }
    if !value.is_object() {
        return Err(format!("expected an object, found {}", found_value(value)));
    }
    for found in fields_of(value) {
        if !fields.contains(&found.as_str()) {
            let known = fields.join("`, `");
            return Err(camel(&format!("unknown field `{found}`, expected some of `{known}`"), false));
        }
    }
    Ok(())
}

/// One object with the fields of two values. (serde's `flatten` would take ten times as many bytes of wasm.)
pub fn to_js_joined<A: Serialize, B: Serialize>(first: &A, second: &B) -> Result<JsValue, VcgpdmError> {
    let (first, second) = (to_js(first)?, to_js(second)?);
    let (first, second): (&Object, &Object) = (first.unchecked_ref(), second.unchecked_ref());
    Ok(Object::assign(first, second).into())
}

/// Two structs from one object with the fields of both.
#[cfg(feature = "training")]
pub fn from_js_split<A: DeserializeOwned, B: DeserializeOwned>(
    code: ErrorCode,
    what: &str,
    value: &JsValue,
) -> Result<(A, B), VcgpdmError> {
    let (first, second) = (fields::<A>(), fields::<B>());
    let value = checked(code, what, value, &[first, second].concat())?;
    let (first, second) = divided(&value, first);
    Ok((read(code, what, first.into())?, read(code, what, second.into())?))
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
    let value = js_sys::JSON::parse(text).map_err(Error::from).and_then(serde_wasm_bindgen::from_value);
    value.map_err(|reason| refused(code, what, plain(&reason.to_string())))
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

fn in_camel_case(value: Result<JsValue, Error>) -> Result<JsValue, VcgpdmError> {
    let value = value.map_err(unconverted)?;
    renamed(&value, &|field| Ok(camel(field, true))).map_err(|problem| match problem {
        Problem::Name(reason) => VcgpdmError::new(ErrorCode::Numerics, &reason),
        Problem::Thrown(value) => VcgpdmError::Thrown(value),
    })
}

fn unconverted(reason: Error) -> VcgpdmError {
    VcgpdmError::new(ErrorCode::Numerics, &plain(&reason.to_string()))
}

fn refused(code: ErrorCode, what: &str, reason: &str) -> VcgpdmError {
    VcgpdmError::new(code, &format_args!("{what}: {reason}"))
}

/// The object's fields of these names, and the others.
#[cfg(feature = "training")]
fn divided(value: &JsValue, names: &[&str]) -> (Object, Object) {
    let (first, second) = (Object::new(), Object::new());
    for name in fields_of(value) {
        let object = if names.contains(&name.as_str()) { &first } else { &second };
        let field = name.into();
        // The value is a copy of ours: a plain object without getters.
        let _ = Reflect::set(object, &field, &Reflect::get(value, &field).unwrap_or_default());
    }
    (first, second)
}

/// Why a value cannot be copied.
enum Problem {
    /// The name of a field is wrong.
    Name(String),
    /// A getter of the value threw this.
    Thrown(JsValue),
}

/// A copy in which every field of every object has another name.
fn renamed(value: &JsValue, name: &dyn Fn(&str) -> Result<String, String>) -> Result<JsValue, Problem> {
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
    if !value.is_object() || ArrayBuffer::is_view(value) {
        return Ok(value.clone());
    }
    let copy = Object::new();
    for field in fields_of(value) {
        let new_name = name(&field).map_err(Problem::Name)?;
        let inner = Reflect::get(value, &field.into()).map_err(Problem::Thrown)?;
        // A new plain object accepts any field.
        let _ = Reflect::set(&copy, &new_name.into(), &renamed(&inner, name)?);
    }
    Ok(copy.into())
}

/// "dynamics_ips" as "dynamicsIps". In a sentence, only field names in backticks change.
fn camel(text: &str, mut is_field: bool) -> String {
    let mut words = Vec::new();
    let mut capital = false;
    for letter in text.bytes() {
        is_field ^= letter == b'`';
        if is_field && letter == b'_' {
            capital = true;
        } else {
            words.push(if capital { letter.to_ascii_uppercase() } else { letter });
            capital = false;
        }
    }
    string(words)
}

/// "dynamicsIps" as "dynamics_ips".
fn snake(field: &str) -> Result<String, String> {
    let mut name = Vec::new();
    for letter in field.bytes() {
        if letter == b'_' {
            let right = camel(field, true);
            return Err(format!("expected fields in camelCase, found `{field}`; write `{right}`"));
        }
        if letter.is_ascii_uppercase() {
            name.push(b'_');
        }
        name.push(letter.to_ascii_lowercase());
    }
    Ok(string(name))
}

/// The text of these bytes, of which only ASCII letters were changed.
fn string(letters: Vec<u8>) -> String {
    String::from_utf8(letters).unwrap_or_default()
}

/// An error of serde with the field names of JavaScript: serde puts field names in backticks.
fn message(reason: &Error) -> String {
    camel(&in_words(plain(&reason.to_string())), false)
}

/// The words of serde and of Rust for kinds of values, and those of JavaScript.
const WORDS: [(&str, &str); 12] = [
    ("usize", "a whole number"),
    ("u64", "a whole number"),
    ("u32", "a whole number"),
    ("f64", "a number"),
    ("a sequence", "a list"),
    ("sequence", "a list"),
    ("a map", "an object"),
    ("map", "an object"),
    ("unit value", "nothing"),
    ("Option value", "a value"),
    ("unit", "nothing"),
    ("variant identifier", "a text"),
];

/// "expected a whole number, found `1.5`" of "invalid type: floating point `1.5`, expected usize". Messages
/// of another form stay.
fn in_words(text: &str) -> String {
    let kinds = ["invalid type: ", "invalid value: "];
    let rest = kinds.iter().find_map(|kind| text.strip_prefix(kind));
    let Some((found, expected)) = rest.and_then(|rest| rest.split_once(", expected ")) else {
        return text.to_owned();
    };
    let word = |kind: &str| WORDS.iter().find(|(rust, _)| *rust == kind).map(|(_, word)| (*word).to_owned());
    let expected = match expected.strip_prefix("struct ") {
        Some(_) => "an object".to_owned(),
        None => word(expected).unwrap_or_else(|| expected.to_owned()),
    };
    let bare = ["floating point ", "integer ", "string ", "boolean "];
    let value = bare.iter().find_map(|kind| found.strip_prefix(kind)).map(str::to_owned);
    let found = value.or_else(|| word(found)).unwrap_or_else(|| found.to_owned());
    // Rust writes a whole number of JavaScript as `-1.0`.
    format!("expected {expected}, found {}", found.replace(".0`", "`"))
}

/// The message without the class name that JavaScript puts before it.
fn plain(text: &str) -> &str {
    text.strip_prefix("Error: ").unwrap_or(text)
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
        assert_eq!(refused, "it: `dynamicsIps`: expected a value, found null");
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
        assert_eq!(refusal(r#"{"dynamicsIps":[],"allScores":[{}]}"#), "it: missing field `dtwMse`");
        let unknown = refusal(r#"{"dynamicsIps":[],"allScores":[],"allScore":1}"#);
        assert_eq!(
            unknown,
            "it: unknown field `allScore`, expected some of `dynamicsIps`, `allScores`, `sha256`"
        );
        let kind = refusal(r#"{"dynamicsIps":[["a_b"]],"allScores":[]}"#);
        assert_eq!(kind, "it: expected a whole number, found \"a_b\"");
        let kind = refusal(r#"{"dynamicsIps":[[1.5]],"allScores":[]}"#);
        assert_eq!(kind, "it: expected a whole number, found `1.5`");
    }
}
