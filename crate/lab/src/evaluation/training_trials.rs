//! The trials that a model learns from, how well its rollouts repeat them, and the model with the body of its fold.

use crate::evaluation::predictor::Predictor;
use crate::evaluation::stats::mean;
use nalgebra::DMatrix;
use vcgpdm_core::gp::NumericsError;
use vcgpdm_core::models::map::{MapModel, MapPoseMap};
use vcgpdm_core::models::variational::PoseMap;
use vcgpdm_core::models::{
    Body, ColumnMapping, Dataset, DatasetError, FittedModel, Model, ModelKind, Movements, Provenance,
    RolloutError, Sequence, dtw_mse,
};
use vcgpdm_core::motion::parts::{PartsLayout, presets};
use vcgpdm_core::motion::pose::PoseMapping;

/// The trials of one data set.
#[derive(Clone, Debug)]
pub struct TrainingTrials<S = PoseMapping> {
    body: Body<S>,
    movements: Movements,
}

impl<S: ColumnMapping> TrainingTrials<S> {
    /// The trials of a data set; sequences that are only the first frames of a trial are none.
    pub fn new(dataset: &Dataset<S>) -> Self {
        Self { body: Body::new(dataset), movements: Movements::new(dataset) }
    }

    /// Converts columns to poses.
    pub fn body(&self) -> &Body<S> {
        &self.body
    }

    /// What the model learns from.
    pub fn movements(&self) -> &Movements {
        &self.movements
    }

    /// All columns [frames x D] of a rollout from the beginning of a sequence.
    ///
    /// # Errors
    /// The model cannot be rolled out for this number of frames.
    pub fn rollout(
        &self,
        model: &dyn Predictor,
        sequence: usize,
        frames: usize,
    ) -> Result<DMatrix<f64>, RolloutError> {
        Ok(self.body.columns(&self.by_part(model.rollout(sequence, frames)?)))
    }

    /// Columns of each part. A model of the whole body has one part with the columns of all parts side by side.
    pub(super) fn by_part(&self, predicted: Vec<DMatrix<f64>>) -> Vec<DMatrix<f64>> {
        if predicted.len() == self.movements.y.len() {
            return predicted;
        }
        let mut at = 0;
        let part = |y: &DMatrix<f64>| {
            at += y.ncols();
            predicted[0].columns(at - y.ncols(), y.ncols()).into_owned()
        };
        self.movements.y.iter().map(part).collect()
    }

    /// The mean over the trials of the error of a rollout with the length of the trial (`dtw_mse`): the
    /// smallest one decides which size or seed is chosen. Absent if a trial cannot be scored.
    pub fn error(&self, model: &dyn Predictor) -> Option<f64> {
        let mut begin = 0;
        let mut errors = Vec::new();
        for (place, Sequence { frames, whole }) in self.movements.sequences.iter().enumerate() {
            if *whole {
                let rows = |y: &DMatrix<f64>| y.rows(begin, *frames).into_owned();
                let actual = self.body.columns(&self.movements.y.iter().map(rows).collect::<Vec<_>>());
                let made = self.rollout(model, place, *frames).ok()?;
                errors.push(dtw_mse(&made, &actual).ok()?.dtw_mse);
            }
            begin += frames;
        }
        Some(mean(&errors)).filter(|error| error.is_finite())
    }
}

/// The model with the body of its fold.
///
/// # Errors
/// The whole body is no part of it, or a covariance cannot be factorised.
pub fn fold_model(fitted: FittedModel, body: &Body, provenance: Provenance) -> Result<Model, DatasetError> {
    let parts = body.layout.parts().len();
    if parts == 1 || !matches!(fitted.kind(), ModelKind::Vgpdm | ModelKind::MapGpdm) {
        return Ok(Model { fitted, body: body.clone(), provenance });
    }
    let whole = &presets(body.mapping.skeleton())[0].parts;
    let layout = PartsLayout::new(whole, &body.mapping)?;
    let side_by_side: Vec<usize> = (0..parts).flat_map(|part| body.layout.columns(part).to_vec()).collect();
    let mut order: Vec<usize> = (0..side_by_side.len()).collect();
    order.sort_by_key(|place| side_by_side[*place]);
    let fitted = with_columns(fitted, &order).map_err(|reason| DatasetError::Training(reason.into()))?;
    Ok(Model { fitted, body: Body { layout, ..body.clone() }, provenance })
}

/// The model of one part whose columns are those at these places of the present ones.
fn with_columns(fitted: FittedModel, order: &[usize]) -> Result<FittedModel, NumericsError> {
    let ordered = |columns: &DMatrix<f64>| columns.select_columns(order);
    Ok(match fitted {
        FittedModel::Vcgpdm(mut model) => {
            for map in &mut model.parts {
                let (r, kernel, covariance) =
                    (map.r().clone(), map.kernel().clone(), map.covariance().clone());
                let noise =
                    order.iter().filter_map(|place| map.column_noise().get(*place).copied()).collect();
                *map = PoseMap::new(r, kernel, map.beta(), ordered(map.mean()), covariance, model.jitter)?
                    .with_column_noise(noise);
            }
            FittedModel::Vcgpdm(model)
        }
        FittedModel::Map(model) => {
            let parts = model.parts().iter().map(|map| MapPoseMap {
                latents: map.latents.clone(),
                kernel: map.kernel.clone(),
                coefficients: ordered(&map.coefficients),
            });
            FittedModel::Map(Box::new(MapModel::new(
                model.sequences().clone(),
                parts.collect(),
                model.dynamics().to_vec(),
                model.coefficients().to_vec(),
                model.linear().clone(),
                model.alpha().clone(),
            )))
        }
        other => other,
    })
}
