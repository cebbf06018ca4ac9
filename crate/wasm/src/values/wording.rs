//! The words of errors: names of fields as JavaScript knows them, and values as a reader knows them.

use js_sys::{Array, JSON, Reflect};
use wasm_bindgen::prelude::*;

/// The longest text that an error repeats, in letters.
const LONGEST_TEXT: usize = 40;

/// The most letters of a number in a message.
#[cfg(feature = "training")]
const MOST_DIGITS: usize = 24;

/// What serde expects, in the words of JavaScript.
pub fn in_words(expected: &str) -> String {
    let word = match expected {
        "usize" | "u64" | "u32" | "u8" => "a whole number from 0 to 4294967295",
        "f64" | "f32" => "a number",
        "a boolean" => "true or false",
        "a string" => "a text",
        "a sequence" => "a list",
        other if other.contains("struct ") || other.contains("enum ") || other == "a map" => "an object",
        other => other,
    };
    word.to_owned()
}

/// The texts that an enum knows. Those with blanks are names in old files.
pub fn one_of(known: &[&str]) -> String {
    let names: Vec<String> =
        known.iter().filter(|name| !name.contains(' ')).map(|name| quoted(name)).collect();
    match names.as_slice() {
        [first, second] => format!("{first} or {second}"),
        _ => format!("one of {}", names.join(", ")),
    }
}

/// A text in quotes, shortened.
pub fn quoted(text: &str) -> String {
    let mut short: String = text.chars().take(LONGEST_TEXT).collect();
    if short.len() < text.len() {
        short.push('…');
    }
    JSON::stringify(&short.into()).map_or_else(|_| "a text".to_owned(), String::from)
}

/// A value for an error message.
pub fn found_value(found: &JsValue) -> String {
    if let Some(number) = found.as_f64() {
        return number.to_string();
    }
    if let Some(text) = found.as_string() {
        return quoted(&text);
    }
    if let Some(truth) = found.as_bool() {
        return truth.to_string();
    }
    if Array::is_array(found) {
        return "a list".to_owned();
    }
    if !found.is_object() {
        // Null, undefined, a function, a symbol or a bigint.
        return if found.is_null() {
            "null".to_owned()
        } else {
            found.js_typeof().as_string().unwrap_or_default()
        };
    }
    let class = Reflect::get(found, &"constructor".into()).ok();
    let name = class.and_then(|class| Reflect::get(&class, &"name".into()).ok()?.as_string());
    match name.as_deref() {
        None | Some("" | "Object") => "an object".to_owned(),
        Some(name) => format!("an instance of {name}"),
    }
}

/// A message in which a number of hundreds of digits has an exponent.
#[cfg(feature = "training")]
pub fn with_short_numbers(message: &str) -> String {
    let in_number = |letter: char| letter.is_ascii_digit() || matches!(letter, '.' | '-');
    let mut short = String::new();
    let mut rest = message;
    while !rest.is_empty() {
        let (text, after) = rest.split_at(rest.find(in_number).unwrap_or(rest.len()));
        let (number, after) = after.split_at(after.find(|letter| !in_number(letter)).unwrap_or(after.len()));
        short.push_str(text);
        match number.parse::<f64>() {
            Ok(value) if number.len() > MOST_DIGITS => short.push_str(&format!("{value:e}")),
            _ => short.push_str(number),
        }
        rest = after;
    }
    short
}

/// "dynamics_ips" as "dynamicsIps".
pub fn camel(name: &str) -> String {
    in_camel_case(name, true)
}

/// A sentence in which the names in backticks are those of JavaScript.
pub fn camel_in_backticks(sentence: &str) -> String {
    in_camel_case(sentence, false)
}

fn in_camel_case(text: &str, mut is_name: bool) -> String {
    let mut words = Vec::new();
    let mut capital = false;
    for letter in text.bytes() {
        is_name ^= letter == b'`';
        if is_name && letter == b'_' {
            capital = true;
        } else {
            words.push(if capital { letter.to_ascii_uppercase() } else { letter });
            capital = false;
        }
    }
    string(words)
}

/// "dynamicsIps" as "dynamics_ips".
pub fn snake(name: &str) -> String {
    let mut words = Vec::new();
    for letter in name.bytes() {
        if letter.is_ascii_uppercase() {
            words.push(b'_');
        }
        words.push(letter.to_ascii_lowercase());
    }
    string(words)
}

/// The text of these bytes, of which only ASCII letters were changed.
fn string(letters: Vec<u8>) -> String {
    String::from_utf8(letters).unwrap_or_default()
}
