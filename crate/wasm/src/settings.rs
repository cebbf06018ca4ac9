//! What a training is asked to do: in JavaScript one object with the model's own settings and what they are
//! applied to.

#[cfg(feature = "training")]
use crate::convert::from_js_beside;
use crate::convert::{from_js, to_js, to_js_beside};
use crate::error::{ErrorCode, VcgpdmError};
use crate::given::Whole;
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
}

/** What training is asked to do. */
export interface TrainingSettings extends VariationalSettings {
    parts: PartSpec[];
    /** The clips are brought to about this rate. */
    framesPerSecond: number;
    /** The seed of everything random, a whole number from 0 to 4294967295. */
    seed: number;
}

/** What a training will cost here, on one core: good to a factor of two or so. */
export interface TrainingCost {
    /** Until all iterations are used; a bound that settles ends the training sooner. */
    seconds: number;
    /** Memory. */
    bytes: number;
}
"#;

/// How many times as long as the native program this one takes: docs/training.md has both.
const SLOWER: f64 = 2.0;
/// The same for models that are exact Gaussian processes: large products of matrices have no wide vectors
/// here.
const SLOWER_EXACT: f64 = 2.5;

/// What a training will cost, before it begins.
#[derive(Serialize)]
struct Cost {
    seconds: f64,
    bytes: f64,
}

/// What a training on so many frames will cost here, of parts with so many columns each (a joint has three).
/// An estimate, good to a factor of two or so.
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

/// What costs the native program so much, as it is here.
pub fn cost_to_js(kind: ModelKind, cost: TrainingCost) -> Result<JsValue, VcgpdmError> {
    let slower = match kind {
        ModelKind::MapGpdm | ModelKind::MapCgpdm => SLOWER_EXACT,
        _ => SLOWER,
    };
    to_js(&Cost { seconds: slower * cost.seconds, bytes: cost.bytes })
}

/// What a model's settings are applied to.
#[derive(Serialize, Deserialize)]
pub struct Task<P = PartSpec> {
    /// How the body, or the columns of a table, are split.
    pub parts: Vec<P>,
    /// The clips are brought to about this rate.
    pub frames_per_second: f64,
    /// The seed of everything random.
    pub seed: u32,
}

/// The settings of a training for JavaScript.
pub fn settings_to_js(task: &Task, settings: &Settings) -> Result<JsValue, VcgpdmError> {
    match settings.variational() {
        Some(settings) => to_js_beside(task, settings),
        None => to_js(task),
    }
}

/// The settings of a training from JavaScript.
#[cfg(feature = "training")]
pub fn settings_from_js<P: DeserializeOwned>(
    value: &JsValue,
) -> Result<(Task<P>, VariationalSettings), VcgpdmError> {
    from_js_beside(ErrorCode::Settings, "settings", value)
}
