//! Checks of ranges, shapes and signs. An error says what was expected and what was found.

use crate::json::field::{Field, FieldError};
use nalgebra::DMatrix;
use std::ops::RangeInclusive;

/// Largest size of a number; sums of products of larger numbers could overflow.
const LARGEST: f64 = 1e12;

/// Reads a number in a range; `expected` describes the range in an error.
pub fn within(field: Field, range: RangeInclusive<f64>, expected: &str) -> Result<f64, FieldError> {
    let number = field.number()?;
    if range.contains(&number) { Ok(number) } else { Err(field.wrong(expected)) }
}

/// Checks that `found`, which is the value or the length of a field, is in a range.
pub fn count(field: &Field, found: usize, range: RangeInclusive<usize>) -> Result<usize, FieldError> {
    if range.contains(&found) {
        return Ok(found);
    }
    let (lowest, highest) = range.into_inner();
    let expected = if lowest == highest { lowest.to_string() } else { format!("from {lowest} to {highest}") };
    Err(field.error(format!("expected {expected}, found {found}")))
}

/// Checks the shape of a matrix.
pub fn shape(field: &Field, matrix: &DMatrix<f64>, rows: usize, columns: usize) -> Result<(), FieldError> {
    let (r, c) = matrix.shape();
    if (r, c) == (rows, columns) {
        return Ok(());
    }
    Err(field.error(format!("expected {rows} x {columns} numbers, found {r} x {c}")))
}

/// Reads a positive number.
pub fn positive_number(field: Field) -> Result<f64, FieldError> {
    let number = field.number()?;
    positive(&field, &[number])?;
    Ok(number)
}

/// Checks that variances or squared lengthscales are positive and not too large.
pub fn positive(field: &Field, values: &[f64]) -> Result<(), FieldError> {
    match values.iter().find(|v| !(1e-12..=LARGEST).contains(*v)) {
        None => Ok(()),
        Some(v) => Err(field.error(format!("expected positive numbers up to 1e12, found {v}"))),
    }
}

/// Checks that numbers are at most 1e12 in size.
pub fn bounded(field: &Field, values: &[f64]) -> Result<(), FieldError> {
    match values.iter().find(|v| v.abs() > LARGEST) {
        None => Ok(()),
        Some(v) => Err(field.error(format!("expected numbers up to 1e12 in size, found {v}"))),
    }
}

/// Reads a matrix of numbers that are at most 1e12 in size.
pub fn bounded_matrix(field: &Field) -> Result<DMatrix<f64>, FieldError> {
    let matrix = field.matrix()?;
    bounded(field, matrix.as_slice())?;
    Ok(matrix)
}
