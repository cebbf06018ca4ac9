//! How likely the latents of a rollout are under the dynamics as learned.

use crate::models::data::column_mapping::ColumnMapping;
use crate::models::kinds::coupled::Coupled;
use crate::models::rollout::request::{Rollout, RolloutError, RolloutRequest};
use serde::Serialize;

/// How likely latents are under the dynamics as learned: the mean log density of those of a frame, in nats a frame.
///
/// A number of this project. The predictor of Knopp et al. (2019) is [`BoundTerms::dynamics_elbo`] of the trained
/// model.
///
/// [`BoundTerms::dynamics_elbo`]: crate::models::variational::BoundTerms::dynamics_elbo
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct LatentLogDensity {
    /// Of the frames of the rollout; `None` where there is none after its start.
    pub rollout: Option<f64>,
    /// Of the frames of the training; `None` for a file of an earlier version, which has not kept them.
    pub training: Option<f64>,
    /// That of the rollout minus that of the training.
    pub difference: Option<f64>,
}

impl<S: ColumnMapping> Coupled<'_, S> {
    /// How likely the latents of a rollout of this model are under the dynamics as learned, whatever its
    /// couplings were, and how likely those of the training are.
    ///
    /// # Errors
    ///
    /// When the rollout is of another model, or a covariance cannot be factorised.
    #[doc(hidden)]
    pub fn latent_log_density(&self, rollout: &Rollout) -> Result<LatentLogDensity, RolloutError> {
        let learned = self.predictive_dynamics(&RolloutRequest::default())?;
        let of_rollout = learned.mean_log_density(std::slice::from_ref(&rollout.latents))?;
        let training = learned.mean_log_density(&self.model.starts)?;
        let difference = of_rollout.zip(training).map(|(rollout, training)| rollout - training);
        Ok(LatentLogDensity { rollout: of_rollout, training, difference })
    }
}
