//! Trainings of clips or tables, step by step.

use crate::arguments::Whole;
use crate::clip::TrainingSet;
use crate::convert::{flat, from_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::model::Model;
use crate::progress::progress_to_js;
use crate::settings::{Task, body_parts, settings_from_js};
use crate::tables::{TablePart, parts_of_columns};
use crate::trained::Trained;
use std::rc::Rc;
use vcgpdm::models::{Dataset, DatasetError, Source, VariationalSettings};
use vcgpdm::series::Columns;
use vcgpdm::{Model as BodyModel, Trainer as BodyTrainer};
use vcgpdm_lab::evaluation::TrainingTrials;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** The parameters that are optimised: first all but the latents, then everything. */
export type TrainingPhase = "couplings-kernels-inducing-points" | "everything";

/** Why training ended: the bound no longer rises, or all iterations are used. */
export type EndReason = "settled" | "iterations";

/** Numerical failures that a training survived. */
export interface Setbacks {
    /** Factorisations of a covariance that failed, and were tried again with jitter on its diagonal. */
    jittered: number;
    /** Evaluations that gave no finite number even so: the search turned back there. */
    turnedBack: number;
}

/** The progress of a training. */
export interface TrainingProgress {
    iteration: number;
    maxIterations: number;
    /** Evaluations of the bound with its gradient. */
    evaluations: number;
    /** Numerical failures so far that the training survived. */
    setbacks: Setbacks;
    /** The bound now, in nats; with `poseWeight` the objective, in which the pose terms have this weight. */
    bound: number;
    /** The best so far. */
    best: number;
    /** The terms of the bound at the best, without weights. */
    terms: BoundTerms;
    phase: TrainingPhase;
    done: boolean;
    /** Null before the end. */
    reason: EndReason | null;
    /** Share of the iterations used, 0 to 1. Time left is at most elapsed * (1 - fraction) / fraction. */
    fraction: number;
}
"#;

enum Training {
    Body(BodyTrainer, TrainingTrials),
    Tables(BodyTrainer<Columns>, TrainingTrials<Columns>),
}

/// Calls the training of a body or of tables.
macro_rules! either {
    ($training:expr, $trainer:ident => $call:expr) => {
        match $training {
            Training::Body($trainer, _) => $call,
            Training::Tables($trainer, _) => $call,
        }
    };
}

/// A training of a vCGPDM, or of a vGPDM where there is one part.
#[wasm_bindgen]
pub struct Trainer {
    training: Training,
    /// The body's model of [`finish`](Self::finish).
    finished: Option<Rc<BodyModel>>,
}

#[wasm_bindgen]
impl Trainer {
    /// Prepares the clips or tables and finds the starting point.
    #[wasm_bindgen(constructor)]
    pub fn new(
        set: &TrainingSet,
        #[wasm_bindgen(unchecked_optional_param_type = "TrainingOptions | TableTrainingOptions")]
        settings: JsValue,
    ) -> Result<Trainer, VcgpdmError> {
        if set.clips.is_empty() && set.tables.is_empty() {
            return Err(DatasetError::Empty.into());
        }
        let training = if set.tables.is_empty() {
            let skeleton = &set.clips[0].skeleton;
            let seconds = set.clips.iter().map(|clip| clip.frames() as f64 * clip.frame_time);
            let usual = VariationalSettings::for_clips(seconds.fold(0.0, f64::max));
            let (Task { parts, frames_per_second, seed }, settings) =
                settings_from_js(&settings, &usual, |parts| body_parts(parts, skeleton))?;
            let sources: Vec<Source> = set.clips.iter().map(Source::from).collect();
            let dataset = Dataset::new(&sources, &parts, frames_per_second)?;
            let trainer = BodyTrainer::new(&dataset, &settings.into(), seed)?;
            Training::Body(trainer, TrainingTrials::new(&dataset))
        } else {
            let (task, settings) = settings_from_js(&settings, &VariationalSettings::default(), |parts| {
                if parts.is_undefined() {
                    return Ok(vec![TablePart::all(&set.tables[0])]);
                }
                from_js(ErrorCode::Parts, "parts", parts)
            })?;
            let parts = parts_of_columns(&set.tables, &task.parts)?;
            let dataset = Dataset::of_tables(&set.tables, &parts, task.frames_per_second)?;
            let trainer = BodyTrainer::new(&dataset, &settings.into(), task.seed)?;
            Training::Tables(trainer, TrainingTrials::new(&dataset))
        };
        Ok(Trainer { training, finished: None })
    }

    /// One iteration of the optimiser: a few milliseconds to some tens.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        self.finished = None;
        progress_to_js(&either!(&mut self.training, trainer => trainer.step()))
    }

    /// Allows this many more iterations. The training continues where it stopped, as if they had been allowed
    /// from the beginning.
    pub fn extend(&mut self, iterations: &Whole) -> Result<(), VcgpdmError> {
        let iterations = iterations.count(ErrorCode::Training, "the number of iterations")?;
        self.finished = None;
        either!(&mut self.training, trainer => trainer.extend(iterations));
        Ok(())
    }

    /// What the user should know, in sentences without a full stop: that a clip does not move or was given
    /// twice, that a part never changes, and which settings are more than the data allow and were reduced.
    pub fn notices(&self) -> Vec<String> {
        either!(&self.training, trainer => trainer.warnings())
    }

    /// The model at the end: the best model, whose dynamics then learn from its own rollouts, if it is one of a
    /// body. This takes some tenths of a second.
    pub fn finish(&mut self) -> Result<Model, VcgpdmError> {
        let Training::Body(trainer, _) = &self.training else { return self.model() };
        let mut model = trainer.finish()?;
        model.learn_from_own_rollouts()?;
        let model = self.finished.insert(Rc::new(model));
        Ok(Model { model: Trained::Body(Rc::clone(model)) })
    }

    /// The best model so far, at any time.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        let model = match &self.training {
            Training::Body(trainer, _) => Trained::Body(Rc::new(trainer.finish()?)),
            Training::Tables(trainer, _) => Trained::Table(Rc::new(trainer.finish()?)),
        };
        Ok(Model { model })
    }

    /// How well rollouts of the best model so far, after [`finish`](Self::finish) those of its model, repeat
    /// the clips or tables: the mean over them of the squared error after time warping. Undefined if a rollout
    /// cannot be scored.
    #[wasm_bindgen(js_name = rolloutError)]
    pub fn rollout_error(&self) -> Result<Option<f64>, VcgpdmError> {
        Ok(match &self.training {
            Training::Body(trainer, trials) => match &self.finished {
                Some(model) => trials.error(&model.fitted),
                None => trials.error(&trainer.finish()?.fitted),
            },
            Training::Tables(trainer, trials) => trials.error(&trainer.finish()?.fitted),
        })
    }

    /// Latent means of the training frames of one part at the best bound so far [frames x Q], sequences one
    /// after the other.
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        either!(&self.training, trainer => {
            let parts = 0..trainer.part_count();
            let latents: Vec<_> = parts.filter_map(|part| trainer.latents(part)).collect();
            Ok(flat(part.part_of(ErrorCode::Training, &latents)?))
        })
    }
}
