//! A cursor over a tree of values. It knows its path, so that an error about a wrong field names the path.

use crate::json::rows::matrix_from_rows;
use crate::json::value::Value;
use crate::json::write::digits;
use nalgebra::DMatrix;
use thiserror::Error;

/// More items than a list of a document has that is more than numbers: each takes memory for its path.
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

/// An object whose fields are taken one by one. [`Object::end`] refuses a field that was not taken: it is
/// unknown.
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

    /// A refusal of this field.
    pub fn error(&self, message: impl Into<String>) -> FieldError {
        FieldError { path: named(&self.path), message: message.into() }
    }

    /// A refusal of this field: what was expected, and what the document holds instead.
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

    /// Its fields, to be taken one by one.
    pub fn object(self) -> Result<Object<'a>, FieldError> {
        match self.value {
            Value::Object(fields) => {
                Ok(Object { fields: fields.iter().map(Some).collect(), path: self.path })
            }
            _ => Err(self.wrong("an object")),
        }
    }

    /// All its items; `read` turns each into a `T`.
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

    /// Its items.
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
            // Up to 2^53 an f64 is exact; a usize of the wasm ends before.
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
    /// The field of that name, `None` when there is none.
    pub fn optional(&mut self, name: &str) -> Option<Field<'a>> {
        let field = self.fields.iter_mut().find(|field| field.is_some_and(|(found, _)| found == name))?;
        field.take().map(|(_, value)| Field { value, path: self.path_of(name) })
    }

    /// The field of that name.
    pub fn get(&mut self, name: &str) -> Result<Field<'a>, FieldError> {
        self.optional(name).ok_or_else(|| FieldError {
            path: named(&self.path),
            message: format!("expected a field \"{name}\", found none"),
        })
    }

    /// Refuses the object where a field was not taken.
    pub fn end(self) -> Result<(), FieldError> {
        match self.fields.iter().flatten().next() {
            None => Ok(()),
            Some((name, _)) => {
                let name: String = name.chars().take(60).collect();
                let message = format!("expected no field \"{name}\", or only one");
                Err(FieldError { path: named(&self.path), message })
            }
        }
    }

    fn path_of(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) }
    }
}

/// Where serde found what is wrong, in an error's words.
pub fn place(path: &serde_path_to_error::Path) -> String {
    // Of the root it says a dot.
    if path.iter().next().is_none() { named("") } else { path.to_string() }
}

/// The path in an error's words.
fn named(path: &str) -> String {
    if path.is_empty() { "the top of the document".to_owned() } else { path.to_owned() }
}
