//! The trials that a model learns from, and how well its rollouts repeat them.

use crate::evaluation::predictor::Predictor;
use crate::evaluation::stats::mean;
use nalgebra::DMatrix;
use vcgpdm::models::{Body, ColumnMapping, Dataset, Movements, RolloutError, Sequence, dtw_mse};
use vcgpdm::motion::pose::PoseMapping;

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
