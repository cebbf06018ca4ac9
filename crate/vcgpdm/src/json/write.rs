//! Writes JSON on one line.

use crate::json::value::Value;
use thiserror::Error;

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
