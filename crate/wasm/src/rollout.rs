//! Rolled-out motions.

use crate::models::motion_model::{MotionModel, Rollout as MotionRollout};
use crate::motion::bvh;
use crate::wasm::{error, flat};
use serde::Deserialize;
use std::rc::Rc;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// What a rollout is asked for.
#[derive(Deserialize, Tsify)]
pub struct RolloutOptions {
    /// Frames in all, the start included.
    pub frames: usize,
    /// The training sequence whose start latents begin it, counted from 0.
    pub sequence: usize,
    /// Coupling variances `alpha[source][target]`; absent: as learned.
    #[serde(default)]
    #[tsify(optional, type = "number[][] | null")]
    pub alpha: Option<Vec<Vec<f64>>>,
    /// What changed couplings do to the experts; absent: they stay as learned.
    #[serde(default)]
    #[tsify(optional, type = "\"as learned\" | \"re-inferred\"")]
    pub reading: Option<String>,
}

/// A rolled-out motion.
#[wasm_bindgen]
pub struct Rollout {
    pub(super) rollout: MotionRollout,
    pub(super) positions: Vec<f32>,
    pub(super) model: Rc<MotionModel>,
}

#[wasm_bindgen]
impl Rollout {
    /// Frames in all, the start included.
    #[wasm_bindgen(getter)]
    pub fn frames(&self) -> usize {
        self.rollout.y.nrows()
    }

    /// The latent path of a part [frames x Q].
    pub fn latents(&self, part: usize) -> Result<Vec<f64>, JsError> {
        let path = self.rollout.latents.get(part).ok_or_else(|| error(format!("there is no part {part}")))?;
        Ok(flat(path))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.positions.clone()
    }

    /// The motion as the text of a BVH file.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(&self) -> Result<String, JsError> {
        Ok(bvh::write(&self.model.clip(&self.rollout, "rollout.bvh").map_err(error)?))
    }
}
