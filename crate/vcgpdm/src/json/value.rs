//! A tree of JSON values.

use nalgebra::DMatrix;

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
