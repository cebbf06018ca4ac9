//! Reads and writes dynamic movement primitives as JSON.

use crate::json::checks::{bounded_matrix, count, positive, positive_number, shape};
use crate::json::{Field, FieldError, Value};
use crate::models::data::json::{phase_map, phase_map_value, vector};
use crate::models::dmp::model::{Canonical, Dmp, DmpStart};
use crate::models::dmp::spring::SpringStart;
use crate::models::training::kind::ModelKind;

const MOST_BASES: usize = 1000;

impl Dmp {
    /// The model as JSON.
    pub(crate) fn to_value(&self) -> Value {
        let goal = Value::numbers(self.goal.as_slice());
        let weights = Value::matrix(&self.weights);
        let starts = |has_amplitude: bool| {
            Value::list(&self.starts, |DmpStart { map, amplitude, spring }| {
                let (map, spring) = (phase_map_value(map), spring_value(spring));
                if has_amplitude {
                    return Value::object([
                        ("phase", map),
                        ("amplitude", Value::Number(*amplitude)),
                        ("spring", spring),
                    ]);
                }
                Value::object([("phase", map), ("spring", spring)])
            })
        };
        match &self.canonical {
            Canonical::Discrete { alpha_x, centres, widths, scaled } => Value::object([
                ("goal", goal),
                ("alpha_x", Value::Number(*alpha_x)),
                ("centres", Value::numbers(centres)),
                ("widths", Value::numbers(widths)),
                ("weights", weights),
                ("scaled", Value::list(scaled, |scaled| Value::Bool(*scaled))),
                ("starts", starts(false)),
            ]),
            Canonical::Rhythmic { concentration } => Value::object([
                ("centre", goal),
                ("concentration", Value::Number(*concentration)),
                ("weights", weights),
                ("starts", starts(true)),
            ]),
        }
    }

    /// Reads a model of this kind, of parts with these numbers of `columns` and of `sequences` sequences.
    pub(crate) fn from_field(
        field: Field,
        kind: ModelKind,
        columns: &[usize],
        sequences: usize,
    ) -> Result<Self, FieldError> {
        let mut object = field.object()?;
        let d = columns.iter().sum();
        let is_discrete = kind == ModelKind::DmpDiscrete;
        let goal = vector(&object.get(if is_discrete { "goal" } else { "centre" })?, d)?;
        let weights = object.get("weights")?;
        let (field, weights) = (weights.clone(), bounded_matrix(&weights)?);
        let bases = count(&field, weights.nrows(), 1..=MOST_BASES)?;
        shape(&field, &weights, bases, d)?;
        let canonical = if is_discrete {
            let alpha_x = positive_number(object.get("alpha_x")?)?;
            let centres = vector(&object.get("centres")?, bases)?.as_slice().to_vec();
            let field = object.get("widths")?;
            let widths = field.numbers()?;
            count(&field, widths.len(), bases..=bases)?;
            positive(&field, &widths)?;
            let field = object.get("scaled")?;
            let scaled = field.list(|item| item.boolean())?;
            count(&field, scaled.len(), d..=d)?;
            Canonical::Discrete { alpha_x, centres, widths, scaled }
        } else {
            Canonical::Rhythmic { concentration: positive_number(object.get("concentration")?)? }
        };
        let field = object.get("starts")?;
        let starts = field.list(|item| {
            let mut object = item.object()?;
            let map = phase_map(object.get("phase")?)?;
            let amplitude = if is_discrete { 1.0 } else { positive_number(object.get("amplitude")?)? };
            let spring = spring(object.get("spring")?, d)?;
            object.end()?;
            Ok(DmpStart { map, amplitude, spring })
        })?;
        count(&field, starts.len(), sequences..=sequences)?;
        object.end()?;
        Ok(Self { canonical, goal, weights, starts, columns: columns.to_vec() })
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
