//! Rolled-out motions.

use crate::convert::{flat, rows, to_js};
use crate::error::VcgpdmError;
use crate::predictions::Predictions;
use std::rc::Rc;
use vcgpdm::models::variational::InducingError;
use vcgpdm::models::variational::Vcgpdm;
use vcgpdm::models::{Rollout as MotionRollout, RolloutRequest, TrainedModel};
use vcgpdm::motion::bvh;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What changed couplings do to the experts: they stay as learned, or they are inferred again from the same data. */
export type Reading = "as learned" | "re-inferred";

/** What a rollout is asked for. */
export interface RolloutOptions {
    /** Frames in all, the start included. */
    frames: number;
    /** The training sequence whose start latents begin it, counted from 0. */
    sequence: number;
    /** Coupling variances `alpha[source][target]`; absent: as learned. */
    alpha?: number[][] | null;
    /** Absent: as learned. */
    reading?: Reading;
}
"#;

/// A rolled-out motion.
#[wasm_bindgen]
pub struct Rollout {
    pub(crate) rollout: MotionRollout,
    pub(crate) positions: Vec<f32>,
    pub(crate) model: Rc<TrainedModel<Vcgpdm>>,
    pub(crate) request: RolloutRequest,
}

impl Rollout {
    pub(crate) fn new(
        model: &Rc<TrainedModel<Vcgpdm>>,
        rollout: MotionRollout,
        request: &RolloutRequest,
    ) -> Result<Self, VcgpdmError> {
        let positions = model.positions(&rollout)?;
        Ok(Self { rollout, positions, model: Rc::clone(model), request: request.clone() })
    }
}

#[wasm_bindgen]
impl Rollout {
    /// Frames in all, the start included.
    #[wasm_bindgen(getter)]
    pub fn frames(&self) -> usize {
        self.rollout.y.nrows()
    }

    /// The latent path of a part [frames x Q].
    pub fn latents(&self, part: usize) -> Result<Vec<f64>, VcgpdmError> {
        let paths = &self.rollout.latents;
        Ok(flat(paths.get(part).ok_or(InducingError::Part { count: paths.len(), found: part })?))
    }

    /// The weights `w[source][target]` that its couplings give the experts; those into each part sum to 1.
    #[wasm_bindgen(unchecked_return_type = "number[][]")]
    pub fn weights(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&rows(&self.rollout.weights))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.positions.clone()
    }

    /// What every expert predicts, with its uncertainty, about each of its frames.
    pub fn predictions(&self) -> Result<Predictions, VcgpdmError> {
        Predictions::new(self)
    }

    /// The motion as the text of a BVH file.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(&self) -> Result<String, VcgpdmError> {
        Ok(bvh::write(&self.model.clip(&self.rollout, "rollout.bvh")?))
    }
}
