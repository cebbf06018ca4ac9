//! JSON, small: a tree of values, read and written so that every number comes back to the bit, and a cursor over the tree
//! that knows the path of the field it stands on. Many times smaller in the wasm than a general library's code.

pub mod checks;
mod field;
mod parse;
pub(crate) mod rows;
mod write;

use nalgebra::DMatrix;

pub use field::{Field, FieldError, Object};
pub use parse::{JsonError, parse};
pub use write::{NotFinite, write};

/// Any JSON.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// A number; finite when it was read.
    Number(f64),
    /// A string.
    Text(String),
    /// An array.
    List(Vec<Value>),
    /// An object, its fields in the order of the text.
    Object(Vec<(String, Value)>),
}

impl Value {
    /// An object of named fields.
    pub fn object<const N: usize>(fields: [(&str, Value); N]) -> Value {
        Value::Object(fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    }

    /// An array of what `value` makes of each item.
    pub fn list<T>(items: impl IntoIterator<Item = T>, value: impl Fn(T) -> Value) -> Value {
        Value::List(items.into_iter().map(value).collect())
    }

    /// An array of numbers.
    pub fn numbers(values: &[f64]) -> Value {
        Value::list(values, |v| Value::Number(*v))
    }

    /// An array of rows.
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

#[cfg(test)]
mod tests;
