//! What a training is asked to do: in JavaScript one object with the model's own settings and what they are applied to.

#[cfg(feature = "training")]
use crate::convert::from_js_beside;
use crate::convert::to_js_beside;
#[cfg(feature = "training")]
use crate::error::ErrorCode;
use crate::error::VcgpdmError;
use serde::{Deserialize, Serialize};
use vcgpdm::models::VariationalSettings;
use vcgpdm::motion::parts::PartSpec;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What training is asked to do. */
export interface TrainingSettings {
    parts: PartSpec[];
    /** Latent dimensions Q of every part. */
    latent: number;
    /** Dynamics inducing points K of every expert. */
    dynamicsIps: number;
    /** Pose inducing points L of every part. */
    poseIps: number;
    /** Order p of the dynamics. */
    order: number;
    /** The clips are brought to about this rate. */
    framesPerSecond: number;
    /** The seed of everything random, a whole number from 0 to 4294967295. */
    seed: number;
    /** Most iterations of the optimiser. */
    maxIterations: number;
}
"#;

/// What a model's settings are applied to.
#[derive(Serialize, Deserialize)]
pub struct Task {
    /// How the body is split.
    pub parts: Vec<PartSpec>,
    /// The clips are brought to about this rate.
    pub frames_per_second: f64,
    /// The seed of everything random.
    pub seed: u32,
}

/// The settings of a training for JavaScript.
pub fn settings_to_js(task: &Task, settings: &VariationalSettings) -> Result<JsValue, VcgpdmError> {
    to_js_beside(task, settings)
}

/// The settings of a training from JavaScript.
#[cfg(feature = "training")]
pub fn settings_from_js(value: &JsValue) -> Result<(Task, VariationalSettings), VcgpdmError> {
    from_js_beside(ErrorCode::Settings, "settings", value, &["parts", "framesPerSecond", "seed"])
}
