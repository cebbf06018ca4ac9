//! The modularity test on the sample trials, one trial at a time.

use crate::convert::{from_js, to_js_joined};
use crate::error::{ErrorCode, VcgpdmError};
use crate::progress::progress_to_js;
use serde::{Deserialize, Serialize};
use vcgpdm_lab::evaluation::{FoldTraining, ModularityTest, Trained};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A fold of the test: one held-out trial. */
export interface ModularityFold {
    /** The id of the sample. */
    sample: string;
    /** Whether to train a model of this movement alone instead of a library. */
    alone: boolean;
    /** The maximum number of iterations for each seed; absent: the number that the test uses. */
    maxIterations?: number;
}

/** How well the held-out trial is predicted with the seed that has the highest bound. */
export interface ModularityOutcome {
    /** The name of the trial's movement. */
    movement: string;
    score: Score;
    /** The bound on the log evidence of all training movements, in nats. */
    bound: number;
    /** How many numbers the rollouts of all training movements need from the model. */
    storedNumbers: number;
    /** Number of training frames. */
    frames: number;
}
"#;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Asked {
    sample: String,
    alone: bool,
    max_iterations: Option<usize>,
}

#[derive(Serialize)]
struct Named<'a> {
    movement: &'a str,
}

/// The training of one fold of the modularity test. The test holds out one sample trial and predicts it in
/// one of two ways: with a library in which walking and walking with waving share the primitive of the lower
/// body, or with a model of this movement alone. docs/modularity.md describes the training and the score.
#[wasm_bindgen]
pub struct ModularityTraining {
    movement: String,
    training: FoldTraining,
}

#[wasm_bindgen]
impl ModularityTraining {
    /// Prepares the training of a fold.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "ModularityFold")] fold: JsValue,
    ) -> Result<ModularityTraining, VcgpdmError> {
        let Asked { sample, alone, max_iterations } = from_js(ErrorCode::Comparison, "the fold", &fold)?;
        let unknown = || format!("expected a sample of walking or of walking with waving, found {sample}");
        let place = ModularityTest::place_of(&sample)
            .ok_or_else(|| VcgpdmError::new(ErrorCode::Comparison, &unknown()))?;
        let mut test = ModularityTest::on_samples();
        if let Some(iterations) = max_iterations {
            test.settings.max_iterations = iterations;
        }
        let trained = if alone { Trained::Alone } else { Trained::Together };
        let training = test.training(place, trained)?;
        let movement = test.movements.swap_remove(place.0).name;
        Ok(ModularityTraining { movement, training })
    }

    /// One iteration of the optimiser.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        progress_to_js(&self.training.step()?)
    }

    /// The outcome of the best seed so far; null until the first seed has finished.
    #[wasm_bindgen(unchecked_return_type = "ModularityOutcome | null")]
    pub fn outcome(&self) -> Result<JsValue, VcgpdmError> {
        match self.training.best() {
            None => Ok(JsValue::NULL),
            Some((outcome, _)) => to_js_joined(&Named { movement: &self.movement }, outcome),
        }
    }
}
