//! Reads values of JavaScript. Each value is checked before serde sees it, so that an error says in the words
//! of JavaScript what was expected, what was found and where.
//!
//! A visitor downloads this code, so generic functions are small.

use crate::values::error::{ErrorCode, VcgpdmError};
use crate::values::wording::{camel, camel_in_backticks, found_value, in_words, one_of, quoted, snake};
use js_sys::{Array, ArrayBuffer, Object, Reflect};
use serde::de::value::StringDeserializer;
use serde::de::{
    self, DeserializeSeed, Deserializer, Error, Expected, IntoDeserializer, Unexpected, Visitor,
};
use serde::forward_to_deserialize_any;
use std::fmt::{self, Display, Formatter};
use wasm_bindgen::prelude::*;

/// Why a value cannot be read.
#[derive(Debug)]
pub struct ReadError {
    /// The place in the value, such as "parts[0].joints"; empty for the value itself.
    place: String,
    reason: String,
    /// Whether the names in backticks are those of the library.
    names_of_library: bool,
    /// What a getter of the value threw.
    thrown: Option<JsValue>,
}

impl ReadError {
    fn new(reason: String) -> Self {
        Self { place: String::new(), reason, names_of_library: false, thrown: None }
    }

    fn of_field(reason: String) -> Self {
        Self { names_of_library: true, ..Self::new(reason) }
    }

    fn expected(expected: &str, found: &str) -> Self {
        Self::new(format!("expected {expected}, found {found}"))
    }

    fn thrown(value: JsValue) -> Self {
        Self { thrown: Some(value), ..Self::new(String::new()) }
    }

    /// The error of a value that is in this field or item of another value.
    fn within(mut self, step: &str) -> Self {
        let dot = if self.place.is_empty() || self.place.starts_with('[') { "" } else { "." };
        self.place = format!("{step}{dot}{}", self.place);
        self
    }

    /// The error to throw. Its message begins with `what`, the name of the value.
    pub fn named(mut self, code: ErrorCode, what: &str, names: Names) -> VcgpdmError {
        if let Some(value) = self.thrown {
            return VcgpdmError::Thrown(value);
        }
        if self.names_of_library && names == Names::JavaScript {
            self.reason = camel_in_backticks(&self.reason);
        }
        VcgpdmError::new(code, &format_args!("{what}: {self}"))
    }
}

impl Display for ReadError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if !self.place.is_empty() {
            write!(f, "`{}`: ", self.place)?;
        }
        f.write_str(&self.reason)
    }
}

impl std::error::Error for ReadError {}

/// The values that serde keeps before it reads them, as those of an enum with a tag, are refused by these
/// functions, in serde's words.
impl Error for ReadError {
    fn custom<T: Display>(reason: T) -> Self {
        Self::new(reason.to_string())
    }

    fn invalid_type(found: Unexpected, expected: &dyn Expected) -> Self {
        let found = match found {
            Unexpected::Bool(found) => found.to_string(),
            Unexpected::Unsigned(found) => found.to_string(),
            Unexpected::Signed(found) => found.to_string(),
            Unexpected::Float(found) => found.to_string(),
            Unexpected::Str(found) => quoted(found),
            Unexpected::Seq => "a list".to_owned(),
            Unexpected::Map => "an object".to_owned(),
            _ => "null".to_owned(),
        };
        Self::expected(&in_words(&expected.to_string()), &found)
    }

    fn invalid_value(found: Unexpected, expected: &dyn Expected) -> Self {
        Self::invalid_type(found, expected)
    }

    fn unknown_variant(found: &str, known: &'static [&'static str]) -> Self {
        Self::expected(&one_of(known), &quoted(found))
    }

    fn unknown_field(found: &str, known: &'static [&'static str]) -> Self {
        Self::of_field(format!("unknown field `{found}`, expected some of `{}`", known.join("`, `")))
    }

    fn missing_field(field: &'static str) -> Self {
        Self::of_field(format!("missing field `{field}`"))
    }
}

/// The names of the fields of a value.
pub fn fields_of(value: &JsValue) -> Vec<String> {
    if !value.is_object() {
        return Vec::new();
    }
    Object::keys(value.unchecked_ref::<Object>()).iter().filter_map(|field| field.as_string()).collect()
}

/// Refuses anything but an object with fields. An object of this package, such as a clip, has none.
pub fn check_object(value: &JsValue) -> Result<(), ReadError> {
    let is_list = Array::is_array(value) || ArrayBuffer::is_view(value);
    let is_ours = || Reflect::has(value, &"__wbg_ptr".into()).unwrap_or(true);
    if !value.is_object() || is_list || is_ours() {
        return Err(ReadError::expected("an object", &found_value(value)));
    }
    Ok(())
}

/// The names of fields: those of JavaScript, or those of the library in files.
#[derive(Clone, Copy, PartialEq)]
pub enum Names {
    /// In camelCase.
    JavaScript,
    /// In snake_case.
    #[cfg(feature = "training")]
    File,
}

/// A value of JavaScript for serde.
pub struct Value {
    value: JsValue,
    /// The names of its fields.
    pub names: Names,
    /// More fields that the object may have: those of another struct.
    others: &'static [&'static str],
}

impl Value {
    /// The value itself.
    pub fn new(value: &JsValue, names: Names, others: &'static [&'static str]) -> Self {
        Self { value: value.clone(), names, others }
    }

    fn refused<T>(&self, expected: &str) -> Result<T, ReadError> {
        Err(ReadError::expected(expected, &found_value(&self.value)))
    }

    /// A whole number from 0 to `most`.
    fn whole(&self, most: u32) -> Result<u32, ReadError> {
        let number = self.value.as_f64().filter(|number| (0.0..=f64::from(most)).contains(number));
        match number.filter(|number| number.fract() == 0.0) {
            Some(number) => Ok(number as u32),
            None => self.refused(&format!("a whole number from 0 to {most}")),
        }
    }

    fn number(&self) -> Result<f64, ReadError> {
        self.value.as_f64().map_or_else(|| self.refused("a number"), Ok)
    }

    fn text(&self) -> Result<String, ReadError> {
        self.value.as_string().map_or_else(|| self.refused("a text"), Ok)
    }

    /// The items of a list or of a typed array.
    fn items(&self, expected: &str) -> Result<Items, ReadError> {
        let items = if Array::is_array(&self.value) {
            self.value.clone().unchecked_into()
        } else if ArrayBuffer::is_view(&self.value) {
            Array::from(&self.value)
        } else {
            return self.refused(expected);
        };
        Ok(Items { items, next: 0, names: self.names })
    }

    /// The fields of an object; all if `known` is empty.
    fn fields(&self, known: &[&str]) -> Result<Fields, ReadError> {
        let value = &self.value;
        check_object(value)?;
        let mut fields = Vec::new();
        for field in fields_of(value) {
            let name = self.library_name(&field)?;
            let is_known = known.is_empty() || known.contains(&name.as_str());
            if !is_known && self.others.contains(&name.as_str()) {
                continue;
            }
            if !is_known {
                let all = [known, self.others].concat().join("`, `");
                return Err(ReadError::of_field(format!("unknown field `{name}`, expected some of `{all}`")));
            }
            let inner = Reflect::get(value, &field.as_str().into()).map_err(ReadError::thrown)?;
            // An undefined field counts as absent.
            if !inner.is_undefined() {
                fields.push((field, name, inner));
            }
        }
        // Serde takes them from the end.
        fields.reverse();
        Ok(Fields { fields, value: None, names: self.names })
    }

    /// The name of a field in the library.
    fn library_name(&self, field: &str) -> Result<String, ReadError> {
        if self.names != Names::JavaScript {
            return Ok(field.to_owned());
        }
        if field.contains('_') {
            let right = camel(field);
            return Err(ReadError::new(format!(
                "expected fields in camelCase, found `{field}`; write `{right}`"
            )));
        }
        Ok(snake(field))
    }
}

impl<'de> Deserializer<'de> for Value {
    type Error = ReadError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        let value = &self.value;
        if value.is_null() || value.is_undefined() {
            return visitor.visit_unit();
        }
        if let Some(truth) = value.as_bool() {
            return visitor.visit_bool(truth);
        }
        if let Some(text) = value.as_string() {
            return visitor.visit_string(text);
        }
        if let Ok(number) = self.whole(u32::MAX) {
            return visitor.visit_u64(u64::from(number));
        }
        if let Some(number) = value.as_f64() {
            return visitor.visit_f64(number);
        }
        if let Ok(items) = self.items("") {
            return visitor.visit_seq(items);
        }
        if value.is_function() {
            return self.refused("a value");
        }
        visitor.visit_map(self.fields(&[])?)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        match self.value.as_bool() {
            Some(truth) => visitor.visit_bool(truth),
            None => self.refused("true or false"),
        }
    }

    fn deserialize_u8<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_u64(u64::from(self.whole(u32::from(u8::MAX))?))
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_u64(u64::from(self.whole(u32::MAX)?))
    }

    /// Counts and indices too, which have 32 bits in wasm.
    fn deserialize_u64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        self.deserialize_u32(visitor)
    }

    fn deserialize_f32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_f64(self.number()?)
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_f64(self.number()?)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_string(self.text()?)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_string(self.text()?)
    }

    fn deserialize_identifier<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_string(self.text()?)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        if self.value.is_null() || self.value.is_undefined() {
            return visitor.visit_none();
        }
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_seq(self.items("a list")?)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, ReadError> {
        let expected = format!("a list of {length} items");
        let items = self.items(&expected)?;
        let found = items.items.length();
        if found as usize != length {
            return Err(ReadError::expected(&expected, &format!("a list of {found}")));
        }
        visitor.visit_seq(items)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        visitor.visit_map(self.fields(&[])?)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        visitor.visit_map(self.fields(fields)?)
    }

    /// An enum without contents, as a text.
    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        let Some(text) = self.value.as_string() else { return self.refused(&one_of(variants)) };
        let text: StringDeserializer<ReadError> = text.into_deserializer();
        visitor.visit_enum(text)
    }

    forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u16 u128 char bytes byte_buf unit unit_struct tuple_struct ignored_any
    }
}

/// The items of a list, one after the other.
struct Items {
    items: Array,
    next: u32,
    names: Names,
}

impl<'de> de::SeqAccess<'de> for Items {
    type Error = ReadError;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, ReadError> {
        let place = self.next;
        if place >= self.items.length() {
            return Ok(None);
        }
        self.next += 1;
        let item = Value { value: self.items.get(place), names: self.names, others: &[] };
        seed.deserialize(item).map(Some).map_err(|error| error.within(&format!("[{place}]")))
    }
}

/// The fields of an object, one after the other.
struct Fields {
    /// The fields to come, in reverse: the name in JavaScript, the name in the library, the value.
    fields: Vec<(String, String, JsValue)>,
    value: Option<(String, JsValue)>,
    names: Names,
}

impl<'de> de::MapAccess<'de> for Fields {
    type Error = ReadError;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, ReadError> {
        let Some((field, name, value)) = self.fields.pop() else { return Ok(None) };
        self.value = Some((field, value));
        let name: StringDeserializer<ReadError> = name.into_deserializer();
        seed.deserialize(name).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, ReadError> {
        let (field, value) = self.value.take().unwrap_or_default();
        let inner = Value { value, names: self.names, others: &[] };
        seed.deserialize(inner).map_err(|error| error.within(&field))
    }
}
