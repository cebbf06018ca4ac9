//! The settings of a training: in JavaScript one object with the settings of the model and of its data.

use crate::arguments::Whole;
#[cfg(feature = "training")]
use crate::convert::from_js_split;
use crate::convert::{from_js, to_js, to_js_joined};
use crate::error::{ErrorCode, VcgpdmError};
#[cfg(feature = "training")]
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use vcgpdm::models::{ModelKind, Settings, TrainingCost, VariationalSettings};
use vcgpdm::motion::parts::PartSpec;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The size of a variational model, and how long it is trained. */
export interface VariationalSettings {
    /** Latent dimensions Q of every part. */
    latent: number;
    /** Dynamics inducing points K of every expert. */
    dynamicsIps: number;
    /** Pose inducing points L of every part. */
    poseIps: number;
    /** Order p of the dynamics. */
    order: number;
    /** Most iterations of the optimiser. */
    maxIterations: number;
    /**
     * The factor of the pose terms in the objective: a number from 0.001 to 1000, or "balanced" for Q_i / D_i
     * (Urtasun, Fleet & Fua 2006). Absent: 1, and the objective is the bound on the log evidence.
     */
    poseWeight?: number | "balanced";
    /** Whether each part of a vCGPDM learns as if it were alone; absent: no. */
    uncoupled?: boolean;
}

/** The settings of a training. */
export interface TrainingSettings extends VariationalSettings {
    parts: PartSpec[];
    /** The clips are brought to about this rate. */
    framesPerSecond: number;
    /** The seed of everything random, a whole number from 0 to 4294967295. */
    seed: number;
}

/** The cost of a training here, on one core; right to a factor of about two. */
export interface TrainingCost {
    /** Until all iterations are used; a bound that settles ends the training sooner. */
    seconds: number;
    /** Memory. */
    bytes: number;
}
"#;

/// The time of the wasm over that of the native program: docs/training.md has both.
const SLOWER: f64 = 2.0;
/// The same for exact Gaussian processes: large matrix products have no wide vectors in wasm.
const SLOWER_EXACT: f64 = 2.5;

/// The cost of a training, before it begins.
#[derive(Serialize)]
struct Cost {
    seconds: f64,
    bytes: f64,
}

/// The cost of a training on `frames` frames of parts with `columns` columns each (a joint has three).
/// Right to a factor of about two.
#[wasm_bindgen(js_name = trainingCost, unchecked_return_type = "TrainingCost")]
pub fn training_cost(
    #[wasm_bindgen(unchecked_param_type = "VariationalSettings")] settings: JsValue,
    frames: &Whole,
    #[wasm_bindgen(unchecked_param_type = "number[]")] columns: JsValue,
) -> Result<JsValue, VcgpdmError> {
    let settings: VariationalSettings = from_js(ErrorCode::Settings, "settings", &settings)?;
    let columns: Vec<usize> = from_js(ErrorCode::Settings, "columns", &columns)?;
    let cost = settings.cost(frames.count(ErrorCode::Settings, "the number of frames")?, &columns);
    cost_to_js(ModelKind::Vcgpdm, cost)
}

/// The cost of a training here, from that in the native program.
pub fn cost_to_js(kind: ModelKind, cost: TrainingCost) -> Result<JsValue, VcgpdmError> {
    let slower = match kind {
        ModelKind::MapGpdm | ModelKind::MapCgpdm => SLOWER_EXACT,
        _ => SLOWER,
    };
    to_js(&Cost { seconds: slower * cost.seconds, bytes: cost.bytes })
}

/// The settings of the data.
#[derive(Serialize, Deserialize)]
pub struct Task<P = PartSpec> {
    /// The parts of the body, or of the columns of a table.
    pub parts: Vec<P>,
    /// The clips are brought to about this rate.
    pub frames_per_second: f64,
    /// The seed of everything random.
    pub seed: u32,
}

/// The settings of a training for JavaScript.
pub fn settings_to_js(task: &Task, settings: &Settings) -> Result<JsValue, VcgpdmError> {
    match settings.variational() {
        Some(settings) => to_js_joined(task, settings),
        None => to_js(task),
    }
}

/// The settings of a training from JavaScript.
#[cfg(feature = "training")]
pub fn settings_from_js<P: DeserializeOwned>(
    value: &JsValue,
) -> Result<(Task<P>, VariationalSettings), VcgpdmError> {
    from_js_split(ErrorCode::Settings, "settings", value)
}
