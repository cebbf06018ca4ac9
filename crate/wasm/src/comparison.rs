//! Comparing models: a trial held out, an evaluation step by step, and what the results say.

use crate::evaluation::candidate::Candidate;
use crate::evaluation::comparison::Comparison;
use crate::evaluation::cross_validation::{Fold as HeldOut, Outcome};
use crate::evaluation::results::{Results, Setting};
use crate::models::learner::{Learner, LearningProgress, MovementModel};
use crate::wasm::training::TrainingSet;
use crate::wasm::{PartSpec, error, parts, read};
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// What all folds of a comparison have in common.
#[derive(Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct ComparisonSettings {
    /// How the coupled models split the body.
    pub parts: Vec<PartSpec>,
    /// The clips are brought to about this rate.
    pub frames_per_second: f64,
}

/// Results of which none is finished yet; each clip of the set is a trial.
#[wasm_bindgen(js_name = emptyResults)]
pub fn empty_results(clips: &TrainingSet, common: Ts<ComparisonSettings>) -> Result<Ts<Results>, JsError> {
    let common = read("settings", &common)?;
    let setting = Setting::new(&clips.clips, &parts(&common.parts), common.frames_per_second);
    setting.check().map_err(error)?;
    Results::new(setting).into_ts().map_err(error)
}

/// What results say: tables, correlations, exponents, claims. Throws the reason when they are no results of an evaluation.
#[wasm_bindgen]
pub fn compare(results: Ts<Results>) -> Result<Ts<Comparison>, JsError> {
    let results = read("expected the results of an evaluation", &results)?;
    results.check().map_err(error)?;
    Comparison::of(&results).into_ts().map_err(error)
}

/// One trial held out, the others trained on.
#[wasm_bindgen]
pub struct Fold {
    fold: Rc<HeldOut>,
}

#[wasm_bindgen]
impl Fold {
    /// Holds out the trial `heldOut`, counted from 1, and trains on the others, or on the first `trainingTrials` of them.
    #[wasm_bindgen(constructor)]
    pub fn new(
        clips: &TrainingSet,
        common: Ts<ComparisonSettings>,
        #[wasm_bindgen(js_name = heldOut)] held_out: usize,
        #[wasm_bindgen(js_name = trainingTrials)] training_trials: usize,
    ) -> Result<Fold, JsError> {
        let common = read("settings", &common)?;
        let place = held_out.checked_sub(1).ok_or_else(|| error("expected a trial from 1, found 0"))?;
        let rate = common.frames_per_second;
        let others = clips.clips.len().saturating_sub(1);
        if !(1..=others).contains(&training_trials) {
            let words = format!("expected from 1 to {others} trials to train on, found {training_trials}");
            return Err(error(words));
        }
        let fold =
            HeldOut::new(&clips.clips, place, training_trials, &parts(&common.parts), rate).map_err(error)?;
        Ok(Fold { fold: Rc::new(fold) })
    }

    /// Frames of the trial held out.
    #[wasm_bindgen(getter)]
    pub fn frames(&self) -> usize {
        self.fold.actual().nrows()
    }

    /// Seconds from one frame to the next.
    #[wasm_bindgen(getter, js_name = frameTime)]
    pub fn frame_time(&self) -> f64 {
        self.fold.body().frame_time
    }

    /// World positions of the trial held out [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn actual(&self) -> Result<Vec<f32>, JsError> {
        self.fold.body().positions(self.fold.actual()).map_err(error)
    }
}

/// How far an evaluation is.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct EvaluationProgress {
    /// Share of the training done, 0 to 1. Time left is at most elapsed * (1 - fraction) / fraction.
    pub fraction: f64,
    /// Whether training has ended.
    pub done: bool,
}

/// One model that is trained in one fold, to be scored when it is done.
#[wasm_bindgen]
pub struct Evaluation {
    fold: Rc<HeldOut>,
    learner: Box<dyn Learner>,
}

#[wasm_bindgen]
impl Evaluation {
    /// Prepares the training.
    #[wasm_bindgen(constructor)]
    pub fn new(fold: &Fold, candidate: Ts<Candidate>, seed: u32) -> Result<Evaluation, JsError> {
        let candidate = read("candidate", &candidate)?;
        let learner = fold.fold.learner(&candidate, seed).map_err(error)?;
        Ok(Evaluation { fold: fold.fold.clone(), learner })
    }

    /// One iteration of the training.
    pub fn step(&mut self) -> Result<Ts<EvaluationProgress>, JsError> {
        let progress = self.learner.step();
        EvaluationProgress { fraction: progress.fraction, done: progress.done }.into_ts().map_err(error)
    }

    /// The best model so far, put to the test.
    pub fn prediction(&self) -> Result<Prediction, JsError> {
        let model = self.learner.model().map_err(error)?;
        Ok(Prediction { fold: self.fold.clone(), training: self.learner.progress(), model })
    }
}

/// What a model predicts for the trial held out.
#[wasm_bindgen]
pub struct Prediction {
    fold: Rc<HeldOut>,
    training: LearningProgress,
    model: Box<dyn MovementModel>,
}

#[wasm_bindgen]
impl Prediction {
    /// How good it is. `seconds` is how long the training took.
    pub fn outcome(&self, seconds: f64) -> Result<Ts<Outcome>, JsError> {
        let outcome = self.fold.outcome(&*self.model, &self.training, seconds).map_err(error)?;
        outcome.into_ts().map_err(error)
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Result<Vec<f32>, JsError> {
        let y = self.fold.predict(&*self.model).map_err(error)?;
        self.fold.body().positions(&y).map_err(error)
    }
}
