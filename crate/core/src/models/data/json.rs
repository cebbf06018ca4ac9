//! Phase maps and vectors in model documents.

use crate::json::checks::{bounded, count, positive_number};
use crate::json::{Field, FieldError, Value};
use crate::models::data::phase::PhaseMap;
use nalgebra::DVector;

/// Reads a vector of `length` numbers of moderate size.
pub fn vector(field: &Field, length: usize) -> Result<DVector<f64>, FieldError> {
    let numbers = field.numbers()?;
    count(field, numbers.len(), length..=length)?;
    bounded(field, &numbers)?;
    Ok(DVector::from_vec(numbers))
}

/// Writes a map from frames to phases.
pub fn phase_map_value(map: &PhaseMap) -> Value {
    Value::object([("start", Value::Number(map.start)), ("rate", Value::Number(map.rate))])
}

/// Reads a map from frames to phases.
pub fn phase_map(field: Field) -> Result<PhaseMap, FieldError> {
    let mut object = field.object()?;
    let start = object.get("start")?;
    bounded(&start, &[start.number()?])?;
    let map = PhaseMap { start: start.number()?, rate: positive_number(object.get("rate")?)? };
    object.end()?;
    Ok(map)
}
