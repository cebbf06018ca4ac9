//! A training under way, step by step.

use crate::clip::TrainingSet;
use crate::convert::flat;
use crate::error::{ErrorCode, VcgpdmError};
use crate::given::Whole;
use crate::model::Model;
use crate::progress::progress_to_js;
use crate::settings::{Task, settings_from_js};
use std::rc::Rc;
use vcgpdm::Trainer as Training;
use vcgpdm::models::{ColumnMapping, Dataset, Source};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The terms of the bound, in nats. */
export interface BoundTerms {
    /** The pose map of each part. */
    kinematics: number[];
    /** The dynamics into each part. */
    dynamics: number[];
    /** The prior of the first frames. */
    initial: number;
    entropy: number;
}

/** What is being optimised: first what the latents are explained with, then everything together. */
export type TrainingPhase = "couplings-kernels-inducing-points" | "everything";

/** Why training ended: the bound no longer rises, or all iterations are used. */
export type EndReason = "settled" | "iterations";

/** What went wrong in a training and was survived. */
export interface Setbacks {
    /** Factorisations of a covariance that failed, and were tried again with jitter on its diagonal. */
    jittered: number;
    /** Evaluations that gave no finite number even so: the search turned back there. */
    turnedBack: number;
}

/** How far training is. */
export interface TrainingProgress {
    iteration: number;
    maxIterations: number;
    /** Evaluations of the bound with its gradient. */
    evaluations: number;
    /** What went wrong so far and was survived. */
    setbacks: Setbacks;
    /** The bound now, in nats. */
    bound: number;
    /** The best so far. */
    best: number;
    /** The terms of the best. */
    terms: BoundTerms;
    phase: TrainingPhase;
    done: boolean;
    /** Null while it goes on. */
    reason: EndReason | null;
    /** Share of the iterations used, 0 to 1. Time left is at most elapsed * (1 - fraction) / fraction. */
    fraction: number;
}
"#;

/// A training under way.
#[wasm_bindgen]
pub struct Trainer {
    training: Training,
}

#[wasm_bindgen]
impl Trainer {
    /// Prepares the clips and finds the starting point.
    #[wasm_bindgen(constructor)]
    pub fn new(
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_param_type = "TrainingSettings")] settings: JsValue,
    ) -> Result<Trainer, VcgpdmError> {
        let (Task { parts, frames_per_second, seed }, settings) = settings_from_js(&settings)?;
        let sources: Vec<Source> = clips.clips.iter().map(Source::from).collect();
        let dataset = Dataset::new(&sources, &parts, frames_per_second)?;
        Ok(Trainer { training: Training::new(&dataset, &settings.into(), seed)? })
    }

    /// One iteration of the optimiser: a few milliseconds to some tens.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        progress_to_js(&self.training.step())
    }

    /// Allows so many more iterations: training goes on where it stopped, as if they had been allowed from
    /// the beginning.
    pub fn extend(&mut self, iterations: &Whole) -> Result<(), VcgpdmError> {
        let iterations = iterations.count(ErrorCode::Training, "the number of iterations")?;
        self.training.extend(iterations);
        Ok(())
    }

    /// What the user should know, in sentences without a full stop: that a clip does not move or was given
    /// twice, that a part never changes, and which settings are more than the data allow and were reduced.
    pub fn notices(&self) -> Vec<String> {
        self.training.warnings()
    }

    /// The best model so far, at any time.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        Ok(Model { model: Rc::new(self.training.finish()?) })
    }

    /// Latent means of the training frames at the best so far [frames x Q] of one part, sequences one after
    /// the other.
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        latents_of(&self.training, part)
    }
}

/// Latent means of a part of a training under way, row after row.
pub(crate) fn latents_of<S: ColumnMapping>(
    training: &Training<S>,
    part: &Whole,
) -> Result<Vec<f64>, VcgpdmError> {
    let latents: Vec<_> = (0..training.part_count()).filter_map(|part| training.latents(part)).collect();
    Ok(flat(part.part_of(ErrorCode::Training, &latents)?))
}
