//! Reads and writes dynamic movement primitives as JSON.

use crate::json::checks::{bounded_matrix, count, positive, positive_number, shape};
use crate::json::{Field, FieldError, Value};
use crate::models::data::json::{phase_map, phase_map_value, vector};
use crate::models::dmp::discrete::{DiscreteStart, DmpDiscrete};
use crate::models::dmp::rhythmic::{DmpRhythmic, RhythmicStart};
use crate::models::dmp::spring::SpringStart;

const MOST_BASES: usize = 1000;

impl DmpDiscrete {
    /// The model as JSON.
    pub(crate) fn to_value(&self) -> Value {
        Value::object([
            ("goal", Value::numbers(self.goal.as_slice())),
            ("alpha_x", Value::Number(self.alpha_x)),
            ("centres", Value::numbers(&self.centres)),
            ("widths", Value::numbers(&self.widths)),
            ("weights", Value::matrix(&self.weights)),
            ("scaled", Value::list(&self.scaled, |scaled| Value::Bool(*scaled))),
            (
                "starts",
                Value::list(&self.starts, |start| {
                    Value::object([
                        ("phase", phase_map_value(&start.map)),
                        ("spring", spring_value(&start.spring)),
                    ])
                }),
            ),
        ])
    }

    /// Reads a model of parts with these numbers of `columns` and of `sequences` sequences.
    pub(crate) fn from_field(field: Field, columns: &[usize], sequences: usize) -> Result<Self, FieldError> {
        let mut object = field.object()?;
        let d = columns.iter().sum();
        let goal = vector(&object.get("goal")?, d)?;

        let alpha_x = positive_number(object.get("alpha_x")?)?;
        let field = object.get("centres")?;
        let bases = count(&field, field.numbers()?.len(), 1..=MOST_BASES)?;
        let centres = vector(&field, bases)?.as_slice().to_vec();
        let field = object.get("widths")?;
        let widths = field.numbers()?;
        count(&field, widths.len(), bases..=bases)?;
        positive(&field, &widths)?;
        let field = object.get("weights")?;
        let weights = bounded_matrix(&field)?;
        shape(&field, &weights, bases, d)?;
        let field = object.get("scaled")?;
        let scaled = field.list(|item| item.boolean())?;
        count(&field, scaled.len(), d..=d)?;
        let field = object.get("starts")?;
        let starts = field.list(|item| {
            let mut object = item.object()?;
            let map = phase_map(object.get("phase")?)?;
            let spring = spring(object.get("spring")?, d)?;
            object.end()?;
            Ok(DiscreteStart { map, spring })
        })?;
        count(&field, starts.len(), sequences..=sequences)?;
        object.end()?;
        let columns = columns.to_vec();
        Ok(Self { goal, alpha_x, centres, widths, weights, scaled, starts, columns })
    }
}

impl DmpRhythmic {
    /// The model as JSON.
    pub(crate) fn to_value(&self) -> Value {
        Value::object([
            ("centre", Value::numbers(self.centre.as_slice())),
            ("concentration", Value::Number(self.concentration)),
            ("weights", Value::matrix(&self.weights)),
            (
                "starts",
                Value::list(&self.starts, |start| {
                    Value::object([
                        ("phase", phase_map_value(&start.map)),
                        ("amplitude", Value::Number(start.amplitude)),
                        ("spring", spring_value(&start.spring)),
                    ])
                }),
            ),
        ])
    }

    /// Reads a model of parts with these numbers of `columns` and of `sequences` sequences.
    pub(crate) fn from_field(field: Field, columns: &[usize], sequences: usize) -> Result<Self, FieldError> {
        let mut object = field.object()?;
        let d = columns.iter().sum();
        let centre = vector(&object.get("centre")?, d)?;
        let concentration = positive_number(object.get("concentration")?)?;
        let field = object.get("weights")?;
        let weights = bounded_matrix(&field)?;
        let bases = count(&field, weights.nrows(), 1..=MOST_BASES)?;
        shape(&field, &weights, bases, d)?;
        let field = object.get("starts")?;
        let starts = field.list(|item| {
            let mut object = item.object()?;
            let map = phase_map(object.get("phase")?)?;
            let amplitude = positive_number(object.get("amplitude")?)?;
            let spring = spring(object.get("spring")?, d)?;
            object.end()?;
            Ok(RhythmicStart { map, amplitude, spring })
        })?;
        count(&field, starts.len(), sequences..=sequences)?;
        object.end()?;
        Ok(Self { centre, concentration, weights, starts, columns: columns.to_vec() })
    }
}

fn spring_value(spring: &SpringStart) -> Value {
    Value::object([
        ("position", Value::numbers(spring.position.as_slice())),
        ("velocity", Value::numbers(spring.velocity.as_slice())),
    ])
}

fn spring(field: Field, d: usize) -> Result<SpringStart, FieldError> {
    let mut object = field.object()?;
    let spring = SpringStart {
        position: vector(&object.get("position")?, d)?,
        velocity: vector(&object.get("velocity")?, d)?,
    };
    object.end()?;
    Ok(spring)
}
