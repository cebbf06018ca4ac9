//! Reads and writes MAP models as JSON.
//!
//! The predictions are sums over all training frames, so the document contains the latents of every frame:
//! the training movements can be computed from it.

use crate::gp::Kernel;
use crate::json::checks::{bounded_matrix, count, positive, positive_number, shape};
use crate::json::{Field, FieldError, Value};
use crate::models::data::sequences::Sequences;
use crate::models::map::model::{MapModel, MapPoseMap};
use nalgebra::{DMatrix, DVector};

const MOST_LATENT: usize = 100;
const MOST_ORDER: usize = 100;

impl MapModel {
    /// The model as JSON.
    pub(crate) fn to_value(&self) -> Value {
        let parts = Value::list(self.parts(), |part| {
            Value::object([
                ("lambda", Value::numbers(part.kernel.lambda.as_slice())),
                ("variance", Value::Number(part.kernel.variance)),
                ("latents", Value::matrix(&part.latents)),
                ("coefficients", Value::matrix(&part.coefficients)),
            ])
        });
        // The dynamics into each part.
        let dynamics = Value::list(self.coefficients().iter().enumerate(), |(i, coefficients)| {
            // The linear term of each source; absent without linear terms.
            let linear = self.linear().column_iter().nth(i);
            let linear = linear.map(|column| ("linear", Value::numbers(column.as_slice())));
            let mut fields = vec![
                ("lambda", Value::list(self.dynamics(), |row| Value::numbers(row[i].lambda.as_slice()))),
                ("coefficients", Value::matrix(coefficients)),
            ];
            fields.extend(linear);
            Value::of_fields(fields)
        });
        Value::object([
            ("order", Value::whole(self.sequences().order())),
            ("parts", parts),
            ("dynamics", dynamics),
            // Row the source, column the target.
            ("alpha", Value::matrix(self.alpha())),
        ])
    }

    /// Reads a model of parts with these numbers of `columns`, trained on sequences of these `lengths`.
    pub(crate) fn from_field(
        field: Field,
        columns: &[usize],
        lengths: Vec<usize>,
    ) -> Result<Self, FieldError> {
        let mut object = field.clone().object()?;
        let m = columns.len();
        let order = object.get("order")?;
        let order = count(&order, order.whole()?, 1..=MOST_ORDER)?;
        let frames = lengths.iter().try_fold(0usize, |sum, length| sum.checked_add(*length));
        let sequences = Sequences::new(lengths, order).map_err(|problem| field.error(problem.to_string()))?;
        let frames = frames.ok_or_else(|| field.error("expected sequences of fewer frames"))?;

        let list = object.get("parts")?;
        let items = list.items()?;
        count(&list, items.len(), m..=m)?;
        let mut parts = Vec::with_capacity(m);
        for (item, columns) in items.into_iter().zip(columns) {
            parts.push(part(item, frames, *columns)?);
        }
        let latent: Vec<usize> = parts.iter().map(|part| part.latents.ncols()).collect();

        let list = object.get("dynamics")?;
        let items = list.items()?;
        count(&list, items.len(), m..=m)?;
        let mut dynamics = vec![Vec::with_capacity(m); m];
        let mut coefficients = Vec::with_capacity(m);
        let mut linear: Vec<f64> = Vec::new();
        for (item, q) in items.into_iter().zip(&latent) {
            let mut target = item.object()?;
            let list = target.get("lambda")?;
            let sources = list.items()?;
            count(&list, sources.len(), m..=m)?;
            for ((source, row), q) in sources.iter().zip(&mut dynamics).zip(&latent) {
                row.push(Kernel { lambda: lambda(source, order * q)?, variance: 1.0 });
            }
            coefficients.push(matrix(&target.get("coefficients")?, sequences.transitions(), *q)?);
            if let Some(field) = target.optional("linear") {
                linear.extend(lambda(&field, m)?.iter());
            }
            target.end()?;
        }
        // All targets have linear terms, or no target has.
        let linear = match linear.len() {
            0 => DMatrix::zeros(0, 0),
            found if found == m * m => DMatrix::from_vec(m, m, linear),
            _ => {
                return Err(list.error("expected linear terms in the dynamics into every part, or into none"));
            }
        };
        let field = object.get("alpha")?;
        let alpha = matrix(&field, m, m)?;
        positive(&field, alpha.as_slice())?;
        object.end()?;
        Ok(MapModel::new(sequences, parts, dynamics, coefficients, linear, alpha))
    }
}

fn part(field: Field, frames: usize, columns: usize) -> Result<MapPoseMap, FieldError> {
    let mut part = field.object()?;
    let field = part.get("lambda")?;
    let q = count(&field, field.numbers()?.len(), 1..=MOST_LATENT)?;
    let kernel = Kernel { lambda: lambda(&field, q)?, variance: positive_number(part.get("variance")?)? };
    let latents = matrix(&part.get("latents")?, frames, q)?;
    let coefficients = matrix(&part.get("coefficients")?, frames, columns)?;
    part.end()?;
    Ok(MapPoseMap { latents, kernel, coefficients })
}

fn lambda(field: &Field, dims: usize) -> Result<DVector<f64>, FieldError> {
    let lambda = field.numbers()?;
    count(field, lambda.len(), dims..=dims)?;
    positive(field, &lambda)?;
    Ok(DVector::from_vec(lambda))
}

fn matrix(field: &Field, rows: usize, columns: usize) -> Result<DMatrix<f64>, FieldError> {
    let matrix = bounded_matrix(field)?;
    shape(field, &matrix, rows, columns)?;
    Ok(matrix)
}
