//! A cursor over a tree of values. It stores its path, so that errors name the wrong field.

use crate::json::rows::matrix_from_rows;
use crate::json::value::Value;
use crate::json::value::digits;
use nalgebra::DMatrix;
use thiserror::Error;

/// Largest number of items of a list other than of numbers: each item takes memory for its path.
const MOST_ITEMS: usize = 100_000;

/// A field is missing, unknown, of the wrong type or out of its range.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("at {path}: {message}")]
pub struct FieldError {
    /// The field's path, such as `parts[0].r[1][0]`.
    pub path: String,
    /// What was expected and found.
    pub message: String,
}

/// One value of a tree, with its path.
#[derive(Clone, Debug)]
pub struct Field<'a> {
    value: &'a Value,
    path: String,
}

/// An object whose fields are taken one by one. [`Object::end`] refuses fields that were not taken, because
/// they are unknown.
#[derive(Debug)]
pub struct Object<'a> {
    fields: Vec<Option<&'a (String, Value)>>,
    path: String,
}

impl<'a> Field<'a> {
    /// The whole document.
    pub fn root(value: &'a Value) -> Self {
        Field { value, path: String::new() }
    }

    /// The value.
    pub fn value(&self) -> &'a Value {
        self.value
    }

    /// An error at this field.
    pub fn error(&self, message: impl Into<String>) -> FieldError {
        FieldError { path: displayed(&self.path), message: message.into() }
    }

    /// An error at this field, with what was expected and what was found.
    pub fn wrong(&self, expected: &str) -> FieldError {
        let found = match self.value {
            Value::Null => "null".to_owned(),
            Value::Bool(value) => value.to_string(),
            Value::Number(number) => digits(*number),
            Value::Text(_) => "a text".to_owned(),
            Value::List(items) => format!("a list of {}", items.len()),
            Value::Object(_) => "an object".to_owned(),
        };
        self.error(format!("expected {expected}, found {found}"))
    }

    /// The field as an object.
    pub fn object(self) -> Result<Object<'a>, FieldError> {
        match self.value {
            Value::Object(fields) => {
                Ok(Object { fields: fields.iter().map(Some).collect(), path: self.path })
            }
            _ => Err(self.wrong("an object")),
        }
    }

    /// The items of a list, each read by `read`.
    pub fn list<T>(
        &self,
        mut read: impl FnMut(Field<'a>) -> Result<T, FieldError>,
    ) -> Result<Vec<T>, FieldError> {
        let Value::List(items) = self.value else {
            return Err(self.wrong("a list"));
        };
        if items.len() > MOST_ITEMS {
            return Err(self.wrong(&format!("a list of at most {MOST_ITEMS}")));
        }
        items.iter().enumerate().map(|(k, item)| read(self.item(k, item))).collect()
    }

    fn item(&self, k: usize, value: &'a Value) -> Field<'a> {
        Field { value, path: format!("{}[{k}]", self.path) }
    }

    /// The items of a list.
    pub fn items(&self) -> Result<Vec<Field<'a>>, FieldError> {
        self.list(Ok)
    }

    /// A number, always finite.
    pub fn number(&self) -> Result<f64, FieldError> {
        match self.value {
            Value::Number(number) => Ok(*number),
            _ => Err(self.wrong("a number")),
        }
    }

    /// A whole number that is not negative.
    pub fn whole(&self) -> Result<usize, FieldError> {
        match self.value {
            // An f64 is exact up to 2^53; a usize of wasm has 32 bits.
            Value::Number(number) if number.fract() == 0.0 && (0.0..9007199254740992.0).contains(number) => {
                usize::try_from(*number as u64).map_err(|_| self.wrong("a smaller number"))
            }
            _ => Err(self.wrong("a whole number")),
        }
    }

    /// True or false.
    pub fn boolean(&self) -> Result<bool, FieldError> {
        match self.value {
            Value::Bool(value) => Ok(*value),
            _ => Err(self.wrong("true or false")),
        }
    }

    /// A string.
    pub fn text(&self) -> Result<&'a str, FieldError> {
        match self.value {
            Value::Text(text) => Ok(text),
            _ => Err(self.wrong("a text")),
        }
    }

    /// A list of finite numbers.
    pub fn numbers(&self) -> Result<Vec<f64>, FieldError> {
        let Value::List(items) = self.value else {
            return Err(self.wrong("a list of numbers"));
        };
        let number = |(k, item): (usize, &'a Value)| match item {
            Value::Number(number) => Ok(*number),
            _ => Err(self.item(k, item).wrong("a number")),
        };
        items.iter().enumerate().map(number).collect()
    }

    /// A list of N numbers.
    pub fn array<const N: usize>(&self) -> Result<[f64; N], FieldError> {
        let numbers = self.numbers()?;
        <[f64; N]>::try_from(numbers).map_err(|_| self.wrong(&format!("a list of {N} numbers")))
    }

    /// A list of rows of equal width.
    pub fn matrix(&self) -> Result<DMatrix<f64>, FieldError> {
        let rows = self.list(|row| row.numbers())?;
        matrix_from_rows(&rows).map_err(|message| self.error(message))
    }
}

impl<'a> Object<'a> {
    /// Whether there is a field of that name.
    pub fn has(&self, name: &str) -> bool {
        self.fields.iter().flatten().any(|(found, _)| found == name)
    }

    /// The field of that name, or `None`.
    pub fn optional(&mut self, name: &str) -> Option<Field<'a>> {
        let field = self.fields.iter_mut().find(|field| field.is_some_and(|(found, _)| found == name))?;
        field.take().map(|(_, value)| Field { value, path: self.path_of(name) })
    }

    /// The field of that name.
    pub fn get(&mut self, name: &str) -> Result<Field<'a>, FieldError> {
        self.optional(name).ok_or_else(|| FieldError {
            path: displayed(&self.path),
            message: format!("expected a field \"{name}\", found none"),
        })
    }

    /// An error if a field was not taken.
    pub fn end(self) -> Result<(), FieldError> {
        match self.fields.iter().flatten().next() {
            None => Ok(()),
            Some((name, _)) => {
                let name: String = name.chars().take(60).collect();
                let message = format!("expected no field \"{name}\", or only one");
                Err(FieldError { path: displayed(&self.path), message })
            }
        }
    }

    fn path_of(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) }
    }
}

/// The path of a serde error for a message.
pub fn place(path: &serde_path_to_error::Path) -> String {
    // serde writes the root as a dot.
    if path.iter().next().is_none() { displayed("") } else { path.to_string() }
}

/// The path for a message.
fn displayed(path: &str) -> String {
    if path.is_empty() { "the top of the document".to_owned() } else { path.to_owned() }
}
