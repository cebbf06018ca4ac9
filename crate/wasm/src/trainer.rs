//! A training under way, step by step.

use crate::clip::TrainingSet;
use crate::convert::{flat, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::given::Whole;
use crate::model::Model;
use crate::settings::{Task, settings_from_js};
use std::rc::Rc;
use vcgpdm::models::variational::{Trainer as Training, Vcgpdm};
use vcgpdm::models::{Dataset, Source, TrainedModel};
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
    dataset: Dataset,
    training: Training,
    frames_per_second: f64,
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
        let sources: Vec<Source> =
            clips.clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
        let dataset = Dataset::new(&sources, &parts, frames_per_second)?;
        let training = Training::new(dataset.y.clone(), dataset.lengths(), &settings, seed)
            .map_err(|reason| dataset.refusal(reason))?;
        Ok(Trainer { dataset, training, frames_per_second })
    }

    /// One iteration of the optimiser: a few milliseconds to some tens.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        to_js(&self.training.step())
    }

    /// Allows so many more iterations: training goes on where it stopped, as if they had been allowed from
    /// the beginning.
    pub fn extend(&mut self, iterations: &Whole) -> Result<(), VcgpdmError> {
        let iterations = iterations.count(ErrorCode::Training, "the number of iterations")?;
        self.training.extend(iterations);
        Ok(())
    }

    /// What was asked for and is more than the data allow, in sentences without a full stop: it was reduced.
    pub fn notices(&self) -> Vec<String> {
        self.training.notices().to_vec()
    }

    /// The best model so far, at any time.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        let model = TrainedModel::<Vcgpdm>::trained(&self.dataset, &self.training, self.frames_per_second)?;
        Ok(Model { model: Rc::new(model) })
    }

    /// Latent means of the training frames at the best so far [frames x Q] of one part, sequences one after
    /// the other.
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        Ok(flat(&part.part_of(ErrorCode::Training, &self.training.best().parts)?.latents.mean))
    }
}
