//! Reads and writes temporal movement primitives as JSON.

use crate::json::checks::{bounded_matrix, count, positive, positive_number, shape};
use crate::json::{Field, FieldError, Value};
use crate::models::data::json::{phase_map, phase_map_value, vector};
use crate::models::data::phase::PhaseAxis;
use crate::models::tmp::{Tmp, TrialWeights};
use nalgebra::DMatrix;

const MOST_INDUCING: usize = 10_000;
const MOST_PRIMITIVES: usize = 1000;

impl Tmp {
    /// The model as JSON.
    pub(crate) fn to_value(&self) -> Value {
        let axis = match self.axis {
            PhaseAxis::Cycle => "cycle",
            PhaseAxis::Trial => "trial",
        };
        let trials = Value::list(&self.trials, |trial| {
            Value::object([
                ("phase", phase_map_value(&trial.map)),
                ("weights", Value::matrix(&trial.weights)),
            ])
        });
        // The bound of each number of primitives, in the order tried.
        let bounds = Value::list(&self.bounds, |(count, bound)| Value::numbers(&[*count as f64, *bound]));
        Value::object([
            ("axis", Value::text(axis)),
            ("lengthscale", Value::Number(self.lengthscale)),
            ("range", Value::numbers(&[self.range.0, self.range.1])),
            ("inducing", Value::numbers(&self.inducing)),
            ("coefficients", Value::matrix(&self.coefficients)),
            ("trials", trials),
            ("centre", Value::matrix(&self.centre)),
            ("scale", Value::numbers(self.scale.as_slice())),
            ("spread", Value::matrix(&self.spread)),
            ("noise", Value::numbers(self.noise.as_slice())),
            ("bound", Value::Number(self.bound)),
            ("bounds", bounds),
        ])
    }

    /// Reads a model of parts with these numbers of `columns` and of `sequences` sequences.
    pub(crate) fn from_field(field: Field, columns: &[usize], sequences: usize) -> Result<Self, FieldError> {
        let mut object = field.object()?;
        let d = columns.iter().sum();
        let field = object.get("axis")?;
        let axis = match field.text()? {
            "cycle" => PhaseAxis::Cycle,
            "trial" => PhaseAxis::Trial,
            _ => return Err(field.error("expected \"cycle\" or \"trial\"")),
        };
        let lengthscale = positive_number(object.get("lengthscale")?)?;
        let range = vector(&object.get("range")?, 2)?;
        let field = object.get("inducing")?;
        let r = count(&field, field.numbers()?.len(), 1..=MOST_INDUCING)?;
        let inducing = vector(&field, r)?.as_slice().to_vec();
        let field = object.get("coefficients")?;
        let coefficients = bounded_matrix(&field)?;
        let q = count(&field, coefficients.ncols(), 1..=MOST_PRIMITIVES)?;
        shape(&field, &coefficients, r, q)?;
        let matrix = |field: Field, rows: usize| -> Result<DMatrix<f64>, FieldError> {
            let matrix = bounded_matrix(&field)?;
            shape(&field, &matrix, rows, q)?;
            Ok(matrix)
        };
        let field = object.get("trials")?;
        let trials = field.list(|item| {
            let mut object = item.object()?;
            let map = phase_map(object.get("phase")?)?;
            let weights = matrix(object.get("weights")?, d)?;
            object.end()?;
            Ok(TrialWeights { map, weights })
        })?;
        count(&field, trials.len(), sequences..=sequences)?;
        let centre = matrix(object.get("centre")?, d)?;
        let field = object.get("scale")?;
        let scale = vector(&field, d)?;
        positive(&field, scale.as_slice())?;
        let spread = matrix(object.get("spread")?, q)?;
        let field = object.get("noise")?;
        let noise = vector(&field, d)?;
        positive(&field, noise.as_slice())?;
        let bound = object.get("bound")?.number()?;
        let bounds = object.get("bounds")?.list(|item| {
            let items = item.items()?;
            count(&item, items.len(), 2..=2)?;
            Ok((items[0].whole()?, items[1].number()?))
        })?;
        object.end()?;
        Ok(Self {
            axis,
            lengthscale,
            range: (range[0], range[1]),
            inducing,
            coefficients,
            trials,
            centre,
            scale,
            spread,
            noise,
            columns: columns.to_vec(),
            bound,
            bounds,
        })
    }
}
