//! Models that follow a recording: latents of observed columns, and rollouts that go on from them.

use crate::models::data::column_mapping::ColumnMapping;
use crate::models::fitted::coupled::Coupled;
use crate::models::rollout::couplings::coupling_weight_matrix;
use crate::models::rollout::request::{Rollout, RolloutError, RolloutRequest};
use crate::models::variational::{Filter, LatentMoments, ObservationError};
use crate::motion::pose::PoseError;
use nalgebra::DMatrix;

/// Where in the movement a recording starts follows from this time of it, in seconds.
const SEARCHED: f64 = 0.5;

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

    /// The mean rollout that begins with these latents [frames x Q_i] of each part, p frames or more, in place
    /// of a training sequence. The frames of the request include them.
    ///
    /// # Errors
    ///
    /// As [`Coupled::rollout`], and when the latents do not fit the model.
    #[doc(hidden)]
    pub fn rollout_after(
        &self,
        given: &[DMatrix<f64>],
        request: &RolloutRequest,
    ) -> Result<Rollout, RolloutError> {
        self.check_frames(request.frames)?;
        Ok(self.rollout_along(self.model.path_after(given, request)?, request))
    }
}
