//! What a training is asked to do.

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

/// The settings of the model, and what they are applied to.
#[derive(Serialize, Deserialize)]
pub struct TrainingSettings {
    /// How the body is split.
    pub parts: Vec<PartSpec>,
    /// The clips are brought to about this rate.
    pub frames_per_second: f64,
    /// The seed of everything random.
    pub seed: u32,
    /// The model's own.
    #[serde(flatten)]
    pub variational: VariationalSettings,
}
