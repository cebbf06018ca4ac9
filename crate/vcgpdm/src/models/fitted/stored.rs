//! What the documents of movement primitives have in common.

use crate::json::checks::{count, positive_number, tame};
use crate::json::{Field, FieldError, Value};
use crate::models::data::phase::PhaseMap;
use nalgebra::DVector;

/// Number of columns D of all parts together.
pub fn whole_columns(columns: &[usize]) -> usize {
    columns.iter().sum()
}

/// Reads a vector of `length` numbers that can be computed with.
pub fn vector(field: &Field, length: usize) -> Result<DVector<f64>, FieldError> {
    let numbers = field.numbers()?;
    count(field, numbers.len(), length..=length)?;
    tame(field, &numbers)?;
    Ok(DVector::from_vec(numbers))
}

/// Where a trial lies on the axis of phase.
pub fn map_value(map: &PhaseMap) -> Value {
    Value::object([("start", Value::Number(map.start)), ("rate", Value::Number(map.rate))])
}

/// Reads where a trial lies on the axis of phase.
pub fn phase_map(field: Field) -> Result<PhaseMap, FieldError> {
    let mut object = field.object()?;
    let start = object.get("start")?;
    tame(&start, &[start.number()?])?;
    let map = PhaseMap { start: start.number()?, rate: positive_number(object.get("rate")?)? };
    object.end()?;
    Ok(map)
}
