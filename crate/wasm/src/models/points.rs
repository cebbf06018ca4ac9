//! Models with fewer inducing points, and poses of latents with their variance.

use crate::models::model::Model;
use crate::models::trained::coupled;
use crate::values::arguments::Whole;
#[cfg(feature = "training")]
use crate::values::convert::from_js;
use crate::values::error::{ErrorCode, VcgpdmError};
use nalgebra::DMatrix;
use vcgpdm_core::models::variational::InducingError;
#[cfg(feature = "training")]
use vcgpdm_core::models::{FittedModel, Model as TrainedModel, variational::KeptPoints};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Model {
    /// The model with these inducing points only, by index: those of the pose maps, `poses[part]`, and of the
    /// experts, `dynamics[source][target]`. Their outputs are inferred again from the data of the training;
    /// latents, kernels and couplings stay. `info().provenance.terms` has the terms of its bound.
    #[cfg(feature = "training")]
    #[wasm_bindgen(js_name = withPoints)]
    pub fn with_points(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[][]")] poses: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number[][][]")] dynamics: JsValue,
    ) -> Result<Model, VcgpdmError> {
        let poses = from_js(ErrorCode::Model, "poses", &poses)?;
        let dynamics = from_js(ErrorCode::Model, "dynamics", &dynamics)?;
        let full = self.model.body()?;
        let fewer = coupled(full)?.model.with_points(&KeptPoints { poses, dynamics })?;
        let mut provenance = full.provenance.clone();
        (provenance.objective, provenance.plain_bound) = (fewer.bound(), None);
        let fitted = FittedModel::Vcgpdm(Box::new(fewer));
        Ok(TrainedModel { fitted, body: full.body.clone(), provenance }.into())
    }

    /// The share of the prior variance of a part's pose map that is left at each latent point [points x Q],
    /// 0 to 1.
    #[wasm_bindgen(js_name = poseVariance)]
    pub fn pose_variance(&self, part: &Whole, latents: &[f64]) -> Result<Vec<f64>, VcgpdmError> {
        let part = part.count(ErrorCode::Model, "the part")?;
        let model = self.model.latent()?;
        let columns = model.pose_map(part)?.r().ncols();
        if !latents.len().is_multiple_of(columns) {
            return Err(InducingError::Latents { columns, found: latents.len() }.into());
        }
        Ok(model.pose_variance(part, &DMatrix::from_row_slice(latents.len() / columns, columns, latents))?)
    }

    /// World positions of the figure's nodes [nodes x 3] with every part at a latent point; the points of all
    /// parts one after the other.
    #[wasm_bindgen(js_name = bodyPose)]
    pub fn body_pose(&self, latents: &[f64]) -> Result<Vec<f32>, VcgpdmError> {
        Ok(coupled(self.model.body()?)?.body_pose(latents)?)
    }
}
