//! Rollouts: motions, or columns of numbers.

#[cfg(feature = "training")]
use crate::data::clip::Clip;
use crate::data::clip::bvh_text;
use crate::models::predictions::Predictions;
#[cfg(feature = "training")]
use crate::models::trained::column_names;
use crate::models::trained::{Trained, coupled};
use crate::values::arguments::Whole;
use crate::values::convert::{flat, rows, to_js, to_js_joined};
use crate::values::error::{ErrorCode, VcgpdmError};
use serde::Serialize;
use std::sync::Arc;
#[cfg(feature = "training")]
use vcgpdm_core::models::SeriesModel;
use vcgpdm_core::models::{ColumnMapping, Model, Rollout as Columns, RolloutRequest};
use vcgpdm_core::motion::measures::{PartMeasures, measures};
use wasm_bindgen::prelude::*;

#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct Parts {
    /// Each part of the model, in its order.
    parts: Vec<PartMeasures>,
}

/// The model to show among several of the same data: of those with the highest rank (`Health.rank` of their
/// rollouts) the one with the smallest error (`Trainer.rolloutError`, infinite if unknown). A place in the
/// lists, which have the same length; -1 if they are empty.
#[wasm_bindgen(js_name = bestToShow)]
pub fn best_to_show(
    // As bytes, 256 would become 0.
    #[wasm_bindgen(unchecked_param_type = "Uint8Array")] ranks: &[f64],
    errors: &[f64],
) -> Result<i32, VcgpdmError> {
    let refused = |expected: &str, found: f64| {
        let words = format_args!("the ranks: expected {expected}, found {found}");
        Err(VcgpdmError::new(ErrorCode::Rollout, &words))
    };
    if ranks.len() != errors.len() {
        return refused("as many as there are errors", ranks.len() as f64);
    }
    if let Some(found) = ranks.iter().find(|rank| f64::from(**rank as u8) != **rank) {
        return refused("whole numbers from 0 to 255", *found);
    }
    let models = ranks.iter().map(|rank| *rank as u8).zip(errors.iter().copied());
    Ok(vcgpdm_core::models::best_to_show(models).map_or(-1, |place| place as i32))
}

/// A rollout of a model: a motion, or columns of numbers.
#[wasm_bindgen]
pub struct Rollout {
    /// Without latents and weights for a kind without couplings.
    pub(crate) rollout: Columns,
    /// Empty for a model of tables.
    positions: Vec<f32>,
    pub(crate) model: Trained,
    pub(crate) request: RolloutRequest,
}

impl Rollout {
    /// The mean rollout of a model of any kind.
    pub(crate) fn mean(model: &Trained, request: RolloutRequest) -> Result<Self, VcgpdmError> {
        match model {
            Trained::Body(body) => Self::new(body, columns(body, &request)?, &request),
            #[cfg(feature = "training")]
            Trained::Table(table) => {
                let rollout = columns(table, &request)?;
                Ok(Self::of_table(table, rollout, request))
            }
        }
    }

    /// A rollout of a model of tables.
    #[cfg(feature = "training")]
    pub(crate) fn of_table(model: &Arc<SeriesModel>, rollout: Columns, request: RolloutRequest) -> Self {
        Self { rollout, positions: Vec::new(), model: Trained::Table(Arc::clone(model)), request }
    }

    /// A rollout of a model of a body.
    pub(crate) fn new(
        model: &Arc<Model>,
        rollout: Columns,
        request: &RolloutRequest,
    ) -> Result<Self, VcgpdmError> {
        let positions = model.body.positions(&rollout.y)?;
        Ok(Self { rollout, positions, model: Trained::Body(Arc::clone(model)), request: request.clone() })
    }
}

/// A rollout as columns. Only a vCGPDM or vGPDM has latents and weights, and starts from any frame.
fn columns<S: ColumnMapping + Clone>(
    model: &Model<S>,
    request: &RolloutRequest,
) -> Result<Columns, VcgpdmError> {
    if let Some(coupled) = model.coupled() {
        return Ok(coupled.rollout(request)?);
    }
    // The player has no MAP CGPDM.
    #[cfg(feature = "training")]
    let changed = request.alpha.clone().and_then(|alpha| model.with_alpha(alpha)).transpose()?;
    #[cfg(not(feature = "training"))]
    let changed: Option<Model<S>> = None;
    if request.alpha.is_some() && changed.is_none() || request.frame > 0 || request.start.is_some() {
        let words = format_args!(
            "expected a vcgpdm or vgpdm model for other couplings, another frame or start latents, found a {} \
             model",
            model.kind().id()
        );
        return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
    }
    let model = changed.as_ref().unwrap_or(model);
    let y = model.rollout_with(request.sequence, request.frames, &request.handles)?;
    Ok(Columns::of_columns(y))
}

#[wasm_bindgen]
impl Rollout {
    /// Frames in all, the start included.
    #[wasm_bindgen(getter)]
    pub fn frames(&self) -> usize {
        self.rollout.y.nrows()
    }

    /// All columns [frames x columns], in their own units.
    #[cfg(feature = "training")]
    pub fn values(&self) -> Vec<f64> {
        flat(&self.rollout.y)
    }

    /// The latent path of a part [frames x Q], of a vCGPDM or vGPDM.
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        Ok(flat(part.part_of(ErrorCode::Rollout, &self.rollout.latents)?))
    }

    /// The weights `w[source][target]` that its couplings give the experts; those into each part sum to 1.
    /// Empty for a kind without couplings.
    #[wasm_bindgen(unchecked_return_type = "number[][]")]
    pub fn weights(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&rows(&self.rollout.weights))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    /// Throws for a model of tables.
    pub fn positions(&self) -> Result<Vec<f32>, VcgpdmError> {
        self.model.body()?;
        Ok(self.positions.clone())
    }

    /// The prediction of every expert for each frame, with its uncertainty.
    pub fn predictions(&self) -> Result<Predictions, VcgpdmError> {
        Predictions::new(coupled(self.model.body()?)?, &self.request, &self.rollout)
    }

    /// The displacement of all columns with which a node of the figure in a frame, counted from 0, is near a place,
    /// in metres from the root: the joints turn as little as possible, those that carry many others least. For the `handles` of a TMP or DMP.
    #[cfg(feature = "training")]
    pub fn dragged(
        &self,
        frame: &Whole,
        node: &Whole,
        x: f64,
        y: f64,
        z: f64,
    ) -> Result<Vec<f64>, VcgpdmError> {
        let frame = frame.count(ErrorCode::Rollout, "the frame")?;
        let node = node.count(ErrorCode::Rollout, "the node")?;
        Ok(self.model.body()?.body.dragged(&self.rollout.y, frame, node, [x, y, z])?)
    }

    /// The motion of the body from this frame on, counted from 0, to the end.
    #[wasm_bindgen(unchecked_return_type = "Measures")]
    pub fn measures(&self, first: &Whole) -> Result<JsValue, VcgpdmError> {
        let first = first.count(ErrorCode::Rollout, "the first frame")?;
        let (body, frames) = (&self.model.body()?.body, self.frames());
        if first >= frames {
            let words = format_args!("the first frame: expected one from 0 to {}, found {first}", frames - 1);
            return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
        }
        let values = self.positions.len() / frames * first;
        let measured = measures(body.mapping.skeleton(), &self.positions[values..], body.frame_time);
        let parts = body.layout.parts().iter().map(|part| measured.part(&part.joints)).collect();
        to_js_joined(&measured, &Parts { parts })
    }

    /// How it ends, and its poses compared with those of the clips.
    #[wasm_bindgen(unchecked_return_type = "Health")]
    pub fn health(&self) -> Result<JsValue, VcgpdmError> {
        let health = coupled(self.model.body()?)?.health(&self.rollout, &self.request, &self.positions)?;
        to_js(&health)
    }

    /// How likely the latents are: the mean log density of those of a frame under the dynamics as learned. Compare
    /// rollouts of one model only. Nobody has asked people about this number; that of Knopp et al. (2019) is
    /// `dynamicsElbo` of `Model.info`. A mean rollout has no noise, so its difference is usually above 0, even where
    /// the motion stands still: read `health` first. Throws for a kind without couplings and for a model of tables.
    #[cfg(feature = "training")]
    #[wasm_bindgen(js_name = latentLogDensity, unchecked_return_type = "LatentLogDensity")]
    pub fn latent_log_density(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&coupled(self.model.body()?)?.latent_log_density(&self.rollout)?)
    }

    /// The motion as the text of a BVH file.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "BvhOptions")] options: JsValue,
    ) -> Result<String, VcgpdmError> {
        bvh_text(self.model.body()?.body.clip(&self.rollout.y, "rollout.bvh")?, &options)
    }

    /// The motion as a clip.
    #[cfg(feature = "training")]
    #[wasm_bindgen(js_name = toClip)]
    pub fn to_clip(&self) -> Result<Clip, VcgpdmError> {
        Ok(Clip { clip: self.model.body()?.body.clip(&self.rollout.y, "motion.bvh")? })
    }

    /// The columns as CSV: frame, time in seconds, and a column for each.
    #[cfg(feature = "training")]
    #[wasm_bindgen(js_name = toCsv)]
    pub fn to_csv(&self) -> String {
        let (columns, frame_time) = match &self.model {
            Trained::Body(model) => (column_names(&model.body), model.body.frame_time),
            Trained::Table(model) => (column_names(&model.body), model.body.frame_time),
        };
        vcgpdm_core::series::write(&columns, &self.rollout.y, frame_time)
    }
}
