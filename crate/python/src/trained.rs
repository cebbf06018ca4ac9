//! A trained model of a body or of tables, as `model.rs` and `rollout.rs` use it.

use crate::arrays::matrix;
use crate::clip::Clip;
use crate::refused;
use nalgebra::DMatrix;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use vcgpdm_core::models::Rollout;
use vcgpdm_core::models::{ColumnMapping, Coupled, Model, RolloutRequest, SeriesModel};

/// A model of a body or of tables.
pub enum Trained {
    Body(Model),
    Series(SeriesModel),
}

/// Calls a model of a body or of tables with its couplings.
#[macro_export]
macro_rules! coupled {
    ($trained:expr, $model:ident => $call:expr) => {
        match $trained as &$crate::trained::Trained {
            $crate::trained::Trained::Body(trained) => match trained.coupled() {
                Some($model) => $call,
                None => Err($crate::trained::without_couplings(trained.kind().id())),
            },
            $crate::trained::Trained::Series(trained) => match trained.coupled() {
                Some($model) => $call,
                None => Err($crate::trained::without_couplings(trained.kind().id())),
            },
        }
    };
}

/// The refusal of a kind of model without couplings.
pub fn without_couplings(kind: &str) -> PyErr {
    refused(format!("expected a vcgpdm or vgpdm model, found a {kind} model"))
}

/// The names of the parts of a model.
pub fn part_names(trained: &Trained) -> PyResult<Vec<String>> {
    coupled!(trained, model => {
        Ok(model.body.layout.parts().iter().map(|part| part.name.clone()).collect())
    })
}

/// A dict of the names of the parts, with a value for each.
pub fn by_part<'py, T: IntoPyObject<'py>>(
    py: Python<'py>,
    trained: &Trained,
    values: impl Iterator<Item = T>,
) -> PyResult<Bound<'py, PyDict>> {
    let parts = PyDict::new(py);
    for (name, value) in part_names(trained)?.into_iter().zip(values) {
        parts.set_item(name, value)?;
    }
    Ok(parts)
}

impl Trained {
    /// The columns [frames x D] of a clip at the frame rate of the model, or of an array.
    pub fn rows(&self, given: &Bound<'_, PyAny>) -> PyResult<DMatrix<f64>> {
        match (self, given.cast::<Clip>()) {
            (Trained::Body(model), Ok(clip)) => model.body.encode(&clip.get().clip).map_err(refused),
            (Trained::Series(_), Ok(_)) => {
                Err(refused("expected an array for a model of arrays, found a clip"))
            }
            (_, Err(_)) => {
                let y = matrix(given, "the trial")?;
                let expected = coupled!(self, model => Ok(model.body.column_means.len()))?;
                if y.ncols() != expected {
                    let found = y.ncols();
                    return Err(refused(format!("expected an array of {expected} columns, found {found}")));
                }
                Ok(y)
            }
        }
    }
}

/// The rollout that goes on from observed columns [frames x D].
pub fn after_observed<S: ColumnMapping>(
    model: Coupled<S>,
    observed: &DMatrix<f64>,
    request: &RolloutRequest,
) -> PyResult<Rollout> {
    let filter = model.filter(request).map_err(refused)?;
    let latents = model.infer(&filter, &model.body.centred(observed)).map_err(refused)?;
    let request = RolloutRequest { start: Some(latents.means), ..request.clone() };
    model.rollout(&request).map_err(refused)
}
