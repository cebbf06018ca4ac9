//! Rolled-out motions.

use crate::convert::{flat, rows, to_js, to_js_beside};
use crate::coupled::coupled;
use crate::error::{ErrorCode, VcgpdmError};
use crate::given::Whole;
use crate::predictions::Predictions;
use serde::Serialize;
use std::rc::Rc;
use vcgpdm::models::{Health, Model, Rollout as MotionRollout, RolloutRequest};
use vcgpdm::motion::bvh;
use vcgpdm::motion::measures::{PartMeasures, measures};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/**
 * What changed couplings do to the experts: they stay as learned, or they are inferred again from the same
 * data.
 */
export type Reading = "as learned" | "re-inferred";

/** What a rollout is asked for. */
export interface RolloutOptions {
    /** Frames in all, the start included. */
    frames: number;
    /** The training sequence whose start latents begin it, counted from 0. */
    sequence: number;
    /** The frame of it that begins the rollout, counted from 0; absent: its first. */
    frame?: number;
    /** Coupling variances `alpha[source][target]`; absent: as learned. */
    alpha?: number[][] | null;
    /** Absent: as learned. */
    reading?: Reading;
}

/** What one hand or foot does. */
export interface LimbMeasures {
    limb: "left hand" | "right hand" | "left foot" | "right foot";
    /** The joint at its end. */
    joint: number;
    /**
     * How far it swings: standard deviation along the heading, relative to the root, in metres for a body 1.7
     * m tall.
     */
    swing: number;
    /** Seconds from one swing to the next; null where it does not swing. */
    period: number | null;
    /**
     * How far its swing is ahead of that of the foot or hand of the other side, in cycles from -0.5 to 0.5.
     */
    ahead: number | null;
    /**
     * How constant that is: 1 in step, near 0 each at its own pace; null where one of the two does not swing.
     */
    locking: number | null;
}

/** Means over the hands and feet of a part; null where there is none. */
export interface PartMeasures {
    swing: number | null;
    period: number | null;
    locking: number | null;
}

/** What a body does in a stretch of frames. */
export interface Measures {
    limbs: LimbMeasures[];
    /** Each part of the model, in its order. */
    parts: PartMeasures[];
    /** Mean speed of all joints relative to the root, in metres a second. */
    jointSpeed: number;
    /** Speed of the root over the ground, in metres a second. */
    walkingSpeed: number;
    /**
     * Horizontal speed of the lowest point of the legs, as a share of the walking speed; null where the body
     * hardly walks.
     */
    footSlide: number | null;
}

/** How a rollout ends. */
export interface Health {
    /** It rests as recorded where the recording that it begins as comes to rest too, hardly later. */
    state: "moves on" | "rests as recorded" | "stands still" | "leaves the training range" | "not finite";
    /** Seconds from the first frame to where it stands still or leaves. */
    from: number | null;
    /** The part that leaves the training range. */
    part: number | null;
    /** How good to show: 2 where it moves on or rests as recorded, 0 where it is not finite. */
    rank: number;
}
"#;

#[derive(Serialize)]
struct Parts {
    parts: Vec<PartMeasures>,
}

#[derive(Serialize)]
struct End {
    state: &'static str,
    from: Option<f64>,
    part: Option<usize>,
    rank: u8,
}

/// Which of several models of the same data is to be shown: of those of the highest rank (`Health.rank` of
/// their rollouts) the one of the highest bound. A place in the lists, which are as long; -1 where they are
/// empty.
#[wasm_bindgen(js_name = bestToShow)]
pub fn best_to_show(
    // As bytes, a 256 would be a 0.
    #[wasm_bindgen(unchecked_param_type = "Uint8Array")] ranks: &[f64],
    bounds: &[f64],
) -> Result<i32, VcgpdmError> {
    let refused = |expected: &str, found: f64| {
        let words = format_args!("the ranks: expected {expected}, found {found}");
        Err(VcgpdmError::new(ErrorCode::Rollout, &words))
    };
    if ranks.len() != bounds.len() {
        return refused("as many as there are bounds", ranks.len() as f64);
    }
    if let Some(found) = ranks.iter().find(|rank| f64::from(**rank as u8) != **rank) {
        return refused("whole numbers from 0 to 255", *found);
    }
    let models = ranks.iter().map(|rank| *rank as u8).zip(bounds.iter().copied());
    Ok(vcgpdm::models::best_to_show(models).map_or(-1, |place| place as i32))
}

/// A rolled-out motion.
#[wasm_bindgen]
pub struct Rollout {
    pub(crate) rollout: MotionRollout,
    pub(crate) positions: Vec<f32>,
    pub(crate) model: Rc<Model>,
    pub(crate) request: RolloutRequest,
}

impl Rollout {
    pub(crate) fn new(
        model: &Rc<Model>,
        rollout: MotionRollout,
        request: &RolloutRequest,
    ) -> Result<Self, VcgpdmError> {
        let positions = coupled(model)?.positions(&rollout)?;
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
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        Ok(flat(part.part_of(ErrorCode::Rollout, &self.rollout.latents)?))
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
        Predictions::new(coupled(&self.model)?, &self.request, &self.rollout)
    }

    /// What the body does from this frame on, counted from 0, to the end.
    #[wasm_bindgen(unchecked_return_type = "Measures")]
    pub fn measures(&self, first: &Whole) -> Result<JsValue, VcgpdmError> {
        let first = first.count(ErrorCode::Rollout, "the first frame")?;
        let (body, frames) = (&self.model.body, self.frames());
        if first >= frames {
            let words = format_args!("the first frame: expected one from 0 to {}, found {first}", frames - 1);
            return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
        }
        let values = self.positions.len() / frames * first;
        let measured = measures(body.mapping.skeleton(), &self.positions[values..], body.frame_time);
        let parts = body.layout.parts().iter().map(|part| measured.part(&part.joints)).collect();
        to_js_beside(&measured, &Parts { parts })
    }

    /// How it ends: moving on, standing still, far from what the model was trained on.
    #[wasm_bindgen(unchecked_return_type = "Health")]
    pub fn health(&self) -> Result<JsValue, VcgpdmError> {
        let health = coupled(&self.model)?.health(&self.rollout, &self.request, &self.positions)?;
        let (state, from, part) = match health {
            Health::MovesOn => ("moves on", None, None),
            Health::StandsStill { from } => ("stands still", Some(from), None),
            Health::RestsAsRecorded { from } => ("rests as recorded", Some(from), None),
            Health::LeavesTraining { from, part } => ("leaves the training range", Some(from), Some(part)),
            Health::NotFinite => ("not finite", None, None),
        };
        to_js(&End { state, from, part, rank: health.rank() })
    }

    /// The motion as the text of a BVH file.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(&self) -> Result<String, VcgpdmError> {
        Ok(bvh::write(&coupled(&self.model)?.clip(&self.rollout, "rollout.bvh")?))
    }
}
