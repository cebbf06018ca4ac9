//! Predictions of the experts with their uncertainty, and Gaussian moments of a rollout's latents.

use crate::values::arguments::Whole;
#[cfg(feature = "training")]
use crate::values::convert::flat;
use crate::values::error::{ErrorCode, VcgpdmError};
#[cfg(feature = "training")]
use vcgpdm_core::models::variational::LatentMoments;
use vcgpdm_core::models::variational::{InducingError, PartPredictions, Prediction};
use vcgpdm_core::models::{Coupled, Rollout, RolloutRequest};
use wasm_bindgen::prelude::*;

/// The predictions for each frame of a rollout, from frame p (the order of the dynamics) on. Each prediction
/// is a Gaussian with the same variance in all latent dimensions.
#[wasm_bindgen]
pub struct Predictions {
    /// For each frame, the predictions for each part.
    frames: Vec<Vec<PartPredictions>>,
    order: usize,
}

impl Predictions {
    pub(crate) fn new(
        model: Coupled,
        request: &RolloutRequest,
        rollout: &Rollout,
    ) -> Result<Self, VcgpdmError> {
        let dynamics = model.predictive_dynamics(request)?;
        let (order, path) = (model.model.order, &rollout.latents);
        let frames = order..rollout.y.nrows();
        let frames = frames.map(|t| dynamics.predict(path, t)).collect::<Result<_, _>>()?;
        Ok(Self { frames, order })
    }

    fn each<'a>(&'a self, target: usize, source: Option<usize>) -> Result<Vec<&'a Prediction>, VcgpdmError> {
        let prediction = |parts: &'a Vec<PartPredictions>| -> Result<&'a Prediction, VcgpdmError> {
            let missing = |found| InducingError::Part { count: parts.len(), found };
            let part = parts.get(target).ok_or_else(|| missing(target))?;
            match source {
                None => Ok(&part.product),
                Some(source) => Ok(part.experts.get(source).ok_or_else(|| missing(source))?),
            }
        };
        self.frames.iter().map(prediction).collect()
    }
}

#[wasm_bindgen]
impl Predictions {
    /// The first predicted frame, which is the order p of the dynamics. Row 0 of each array belongs to this
    /// frame.
    #[wasm_bindgen(getter, js_name = firstFrame)]
    pub fn first_frame(&self) -> usize {
        self.order
    }

    /// Means of the product of all experts for a part [predicted frames x Q].
    pub fn means(&self, target: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let target = target.count(ErrorCode::Rollout, "the target")?;
        Ok(self.each(target, None)?.iter().flat_map(|prediction| prediction.mean.iter().copied()).collect())
    }

    /// Variances of the product of all experts for a part [predicted frames].
    pub fn variances(&self, target: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let target = target.count(ErrorCode::Rollout, "the target")?;
        Ok(self.each(target, None)?.iter().map(|prediction| prediction.variance).collect())
    }

    /// Means of the source's prediction of the target [predicted frames x Q of the target].
    #[wasm_bindgen(js_name = expertMeans)]
    pub fn expert_means(&self, source: &Whole, target: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let source = source.count(ErrorCode::Rollout, "the source")?;
        let target = target.count(ErrorCode::Rollout, "the target")?;
        Ok(self
            .each(target, Some(source))?
            .iter()
            .flat_map(|prediction| prediction.mean.iter().copied())
            .collect())
    }

    /// Variances of the source's prediction of the target [predicted frames]: alpha plus the variance of the
    /// expert.
    #[wasm_bindgen(js_name = expertVariances)]
    pub fn expert_variances(&self, source: &Whole, target: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let source = source.count(ErrorCode::Rollout, "the source")?;
        let target = target.count(ErrorCode::Rollout, "the target")?;
        Ok(self.each(target, Some(source))?.iter().map(|prediction| prediction.variance).collect())
    }
}

/// The latents in every frame of a rollout as Gaussians.
#[cfg(feature = "training")]
#[wasm_bindgen]
pub struct Moments(pub(crate) LatentMoments);

#[cfg(feature = "training")]
#[wasm_bindgen]
impl Moments {
    /// Means of a part's latents [frames x Q].
    pub fn means(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        Ok(flat(part.part_of(ErrorCode::Rollout, &self.0.means)?))
    }

    /// Covariances of a part's latents [frames x Q x Q].
    pub fn covariances(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let frames = part.part_of(ErrorCode::Rollout, &self.0.covariances)?;
        Ok(frames.iter().flat_map(|covariance| covariance.iter().copied()).collect())
    }
}
