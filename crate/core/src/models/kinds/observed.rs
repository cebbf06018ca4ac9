//! Models that follow a recording: latents of observed columns and clips.

use crate::models::data::column_mapping::ColumnMapping;
use crate::models::data::dataset::DatasetError;
use crate::models::kinds::coupled::Coupled;
use crate::models::rollout::couplings::coupling_weight_matrix;
use crate::models::rollout::request::{Rollout, RolloutError, RolloutRequest};
use crate::models::variational::{Filter, LatentMoments, ObservationError};
use crate::motion::Clip;
use crate::motion::pose::PoseError;
use crate::plural::counted;
use nalgebra::DMatrix;
use thiserror::Error;

/// Where in the movement a recording starts follows from this time of it, in seconds.
const SEARCHED: f64 = 0.5;

/// Why the latents of a clip's first frames cannot be inferred.
#[doc(hidden)]
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ObservedClipError {
    /// The clip has another body, or cannot be brought to the frame rate of the model.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// The clip has too few frames.
    #[error(
        "{clip}: expected {expected} frames or more to start from, found {} at the frame rate of the model",
        counted(*found, "frame")
    )]
    Short {
        /// The clip's name.
        clip: String,
        /// Frames asked for.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// The frames cannot be filtered.
    #[error("{clip}: {reason}")]
    Observation {
        /// The clip's name.
        clip: String,
        /// The reason.
        reason: Box<ObservationError>,
    },
}

impl<S: ColumnMapping> Coupled<'_, S> {
    /// The model as a filter of observed columns, under the couplings of a request.
    ///
    /// # Errors
    ///
    /// When the couplings do not fit the model, or a covariance cannot be factorised.
    #[doc(hidden)]
    pub fn filter(&self, request: &RolloutRequest) -> Result<Filter, RolloutError> {
        let weight = self.provenance.settings.variational().map(|settings| settings.pose_weight);
        let alpha = request.alpha_or(&self.model.alpha);
        self.model.filter(alpha, request.reading, weight.unwrap_or_default())
    }

    /// The latents of all frames given all observed columns, [frames x D_i] of each part: centred, with NaN for
    /// a missing number.
    ///
    /// # Errors
    ///
    /// When the columns do not fit the model, there are fewer than p frames, a number is infinite, or a
    /// covariance cannot be factorised.
    #[doc(hidden)]
    pub fn infer(
        &self,
        filter: &Filter,
        observed: &[DMatrix<f64>],
    ) -> Result<LatentMoments, ObservationError> {
        let searched = (SEARCHED / self.body.frame_time).round() as usize;
        Ok(filter.smoothed(&filter.run_from_best(observed, searched)?)?)
    }

    /// The motion in which columns [frames x D] are as they are given, and their missing numbers, which are NaN,
    /// are inferred under the couplings of a request.
    ///
    /// # Errors
    ///
    /// When the rows have another number of columns, and as [`Coupled::filter`] and [`Coupled::infer`].
    #[doc(hidden)]
    pub fn fill(
        &self,
        request: &RolloutRequest,
        columns: &DMatrix<f64>,
    ) -> Result<Rollout, ObservationError> {
        self.check_frames(columns.nrows())?;
        let (expected, found) = (self.body.column_means.len(), columns.ncols());
        if found != expected {
            return Err(RolloutError::from(PoseError::Columns { expected, found }).into());
        }
        let filter = self.filter(request)?;
        let latents = self.infer(&filter, &self.body.centred(columns))?;
        let parts = (0..latents.means.len()).map(|part| filter.mean_columns(part, &latents));
        let means = self.body.columns(&parts.collect::<Result<Vec<_>, _>>()?);
        let y = columns.zip_map(&means, |given, mean| if given.is_nan() { mean } else { given });
        let weights = coupling_weight_matrix(request.alpha_or(&self.model.alpha));
        Ok(Rollout { latents: latents.means, y, weights })
    }

    /// The latents [frames x Q_i] of each part in observed columns [frames x D], p frames or more, under the
    /// learned couplings: the start latents of a rollout that goes on from them.
    ///
    /// # Errors
    ///
    /// As [`infer`](Self::infer).
    #[doc(hidden)]
    pub fn latents_of(&self, columns: &DMatrix<f64>) -> Result<Vec<DMatrix<f64>>, ObservationError> {
        let filter = self.filter(&RolloutRequest::default())?;
        Ok(self.infer(&filter, &self.body.centred(columns))?.means)
    }
}

impl Coupled<'_> {
    /// The latents [frames x Q_i] of each part in the first `frames` frames of a clip, at the frame rate of the
    /// model, as in [`latents_of`](Self::latents_of). The clip need not be a training clip.
    ///
    /// # Errors
    ///
    /// When the clip has another body or too few frames, or as in [`infer`](Self::infer).
    #[doc(hidden)]
    pub fn latents_of_clip(
        &self,
        clip: &Clip,
        frames: usize,
    ) -> Result<Vec<DMatrix<f64>>, ObservedClipError> {
        let columns = self.body.encode(clip)?;
        let (name, found) = (&clip.name, columns.nrows());
        if found < frames {
            return Err(ObservedClipError::Short { clip: name.clone(), expected: frames, found });
        }
        let latents = self.latents_of(&columns.rows(0, frames).into_owned());
        latents
            .map_err(|reason| ObservedClipError::Observation { clip: name.clone(), reason: Box::new(reason) })
    }
}

crate::coded!(ObservedClipError {
    Self::Dataset(reason) => reason.code(),
    Self::Observation { reason, .. } => reason.code(),
    _ => Clip,
});
