//! A tree of JSON values, and its text.

use nalgebra::DMatrix;
use thiserror::Error;

/// A JSON value.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// A number; always finite if it was read.
    Number(f64),
    /// A string.
    Text(String),
    /// An array.
    List(Vec<Value>),
    /// An object with its fields in the order of the text.
    Object(Vec<(String, Value)>),
}

impl Value {
    /// An object with these fields.
    pub fn object<const N: usize>(fields: [(&str, Value); N]) -> Value {
        Value::of_fields(Vec::from(fields))
    }

    /// An object with these fields; of any number, so that the code exists once.
    pub fn of_fields(fields: Vec<(&str, Value)>) -> Value {
        Value::Object(fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    }

    /// An array of the values that `value` makes of the items.
    pub fn list<T>(items: impl IntoIterator<Item = T>, value: impl Fn(T) -> Value) -> Value {
        Value::List(items.into_iter().map(value).collect())
    }

    /// An array of numbers.
    pub fn numbers(values: &[f64]) -> Value {
        Value::list(values, |v| Value::Number(*v))
    }

    /// An array of the rows of a matrix, each an array of numbers.
    pub fn matrix(matrix: &DMatrix<f64>) -> Value {
        Value::list(matrix.row_iter(), |row| Value::list(row.iter(), |v| Value::Number(*v)))
    }

    /// An array of whole numbers.
    pub fn wholes(values: &[usize]) -> Value {
        Value::list(values, |v| Value::whole(*v))
    }

    /// A whole number; exact up to 2^53.
    pub fn whole(value: usize) -> Value {
        Value::Number(value as f64)
    }

    /// A string.
    pub fn text(text: &str) -> Value {
        Value::Text(text.to_owned())
    }
}

/// A number that JSON cannot express: NaN or an infinity.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("expected finite numbers, found {0}")]
pub struct NotFinite(pub f64);

/// Writes a value. A number has the fewest digits that are read as the same bits.
pub fn write(value: &Value) -> Result<String, NotFinite> {
    let mut out = String::new();
    append(value, &mut out)?;
    Ok(out)
}

fn append(value: &Value, out: &mut String) -> Result<(), NotFinite> {
    match value {
        Value::Null => out.push_str("null"),
        Value::Bool(true) => out.push_str("true"),
        Value::Bool(false) => out.push_str("false"),
        Value::Number(number) if number.is_finite() => {
            out.push_str(&digits(*number));
        }
        Value::Number(number) => return Err(NotFinite(*number)),
        Value::Text(text) => quote(text, out),
        Value::List(items) => {
            out.push('[');
            for (k, item) in items.iter().enumerate() {
                if k > 0 {
                    out.push(',');
                }
                append(item, out)?;
            }
            out.push(']');
        }
        Value::Object(fields) => {
            out.push('{');
            for (k, (name, field)) in fields.iter().enumerate() {
                if k > 0 {
                    out.push(',');
                }
                quote(name, out);
                out.push(':');
                append(field, out)?;
            }
            out.push('}');
        }
    }
    Ok(())
}

/// The fewest digits that are read as the same finite number.
pub(super) fn digits(number: f64) -> String {
    // Rust's `{:?}` is valid JSON, with an exponent for numbers of many digits.
    let mut text = format!("{number:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
    text
}

fn quote(text: &str, out: &mut String) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if c < ' ' => out.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
}
