//! One model in one fold: trained on all trials but one, and tested on that one; and candidates from JavaScript.

use crate::data::clip::TrainingSet;
use crate::models::model::Model;
use crate::models::settings::{FRAMES_PER_SECOND, body_parts, with_parts};
use crate::values::arguments::Whole;
use crate::values::convert::{from_js, to_js, with_defaults};
use crate::values::error::{ErrorCode, VcgpdmError};
use js_sys::{Object, Reflect};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use vcgpdm_core::models::{DatasetError, FittedModel, Learner, ModelKind, Progress, Settings};
use vcgpdm_core::motion::parts::PartSpec;
use vcgpdm_lab::evaluation::{CandidateKind, Fold as HeldOut, Job, START_FRAMES};
use wasm_bindgen::prelude::*;

/// The settings that all folds of a comparison share. Each has a default.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct ComparisonSettings {
    /// The parts of the coupled models, as in `TrainingOptions`.
    #[cfg_attr(feature = "types", ts(type = "string | NamedPart[]", optional))]
    pub parts: Vec<PartSpec>,
    /// The clips are brought to about this rate; absent: 30.
    #[cfg_attr(feature = "types", ts(type = "number", optional))]
    pub frames_per_second: f64,
}

#[derive(Serialize)]
struct UsualRate {
    frames_per_second: f64,
}

impl ComparisonSettings {
    /// The settings from JavaScript, for the body of these clips.
    pub fn read(settings: &JsValue, clips: &TrainingSet) -> Result<Self, VcgpdmError> {
        let skeleton = &clips.clips.first().ok_or(DatasetError::Empty)?.skeleton;
        let usual = to_js(&UsualRate { frames_per_second: FRAMES_PER_SECOND })?;
        let settings = with_defaults(ErrorCode::Comparison, "settings", settings, usual)?;
        let settings = with_parts(settings, |parts| body_parts(parts, skeleton))?;
        from_js(ErrorCode::Comparison, "settings", &settings)
    }
}

/// A trial held out, and how many of the others are trained on.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct FoldOptions {
    /// Counted from 0; absent: the first.
    #[cfg_attr(feature = "types", ts(type = "number", optional))]
    held_out: usize,
    /// Trains on the first ones of the other trials; absent: on all.
    #[cfg_attr(feature = "types", ts(optional))]
    training_trials: Option<usize>,
}

/// Checks a trial of JavaScript, where trials are counted from 0. The library's errors count from 1.
pub fn check_held_out(held_out: usize, trials: usize) -> Result<(), VcgpdmError> {
    if held_out < trials {
        return Ok(());
    }
    let last = trials.saturating_sub(1);
    let words = format_args!("`heldOut`: expected a trial from 0 to {last}, found {held_out}");
    Err(VcgpdmError::new(ErrorCode::Comparison, &words))
}

/// The progress of an evaluation.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct EvaluationProgress {
    /// Share of the training done, 0 to 1. Time left is at most elapsed * (1 - fraction) / fraction.
    fraction: f64,
    /// Whether training has ended.
    done: bool,
}

/// One trial held out, the others trained on.
#[wasm_bindgen]
pub struct Fold {
    fold: Arc<HeldOut>,
    /// The kind of model that is trained if the caller names none.
    usual: ModelKind,
}

#[wasm_bindgen]
impl Fold {
    /// Holds one trial out, by default the first, and trains on the others.
    #[wasm_bindgen(constructor)]
    pub fn new(
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_optional_param_type = "ComparisonSettings")] settings: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "FoldOptions")] options: JsValue,
    ) -> Result<Fold, VcgpdmError> {
        let options = with_defaults(ErrorCode::Comparison, "fold", &options, Object::new().into())?;
        let FoldOptions { held_out, training_trials } = from_js(ErrorCode::Comparison, "fold", &options)?;
        let count = clips.clips.len();
        check_held_out(held_out, count)?;
        let training_trials = training_trials.unwrap_or(count - 1);
        let ComparisonSettings { parts, frames_per_second } = ComparisonSettings::read(&settings, clips)?;
        let fold =
            HeldOut::new(&clips.clips, held_out, training_trials, &parts, frames_per_second, START_FRAMES)?;
        let usual = if parts.len() > 1 { ModelKind::Vcgpdm } else { ModelKind::Vgpdm };
        Ok(Fold { fold: Arc::new(fold), usual })
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
    pub fn actual(&self) -> Result<Vec<f32>, VcgpdmError> {
        Ok(self.fold.body().positions(self.fold.actual())?)
    }
}

/// The training of one model in one fold, and its score.
#[wasm_bindgen]
pub struct Evaluation {
    fold: Arc<HeldOut>,
    candidate: Settings,
    seed: u32,
    learner: Box<dyn Learner>,
}

#[wasm_bindgen]
impl Evaluation {
    /// Prepares the training. Absent fields of the candidate are the defaults of its model, an absent model
    /// is a vCGPDM (a vGPDM if there is one part), and an absent seed is 0.
    #[wasm_bindgen(constructor)]
    pub fn new(
        fold: &Fold,
        #[wasm_bindgen(unchecked_optional_param_type = "CandidateOptions")] candidate: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] seed: Option<Whole>,
    ) -> Result<Evaluation, VcgpdmError> {
        let seed = seed.map_or(Ok(0), |seed| seed.get(ErrorCode::Comparison, "the seed"))?;
        let candidate = candidate_from_js(ErrorCode::Settings, "candidate", &candidate, fold.usual)?;
        let learner = fold.fold.learner(&candidate, seed)?;
        Ok(Evaluation { fold: Arc::clone(&fold.fold), candidate, seed, learner })
    }

    /// One iteration of the training.
    #[wasm_bindgen(unchecked_return_type = "EvaluationProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        let progress = self.learner.step();
        to_js(&EvaluationProgress { fraction: progress.fraction, done: progress.done })
    }

    /// The prediction of the best model so far.
    pub fn prediction(&self) -> Result<Prediction, VcgpdmError> {
        let model = self.learner.model()?;
        Ok(Prediction { fold: Arc::clone(&self.fold), training: self.learner.progress(), model })
    }

    /// The best model so far, as in a file: its last sequence is the beginning of the trial held out.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        let (fitted, training) = (self.learner.model()?, self.learner.progress());
        Ok(self.fold.model(fitted, &self.candidate, self.seed, &training)?.into())
    }
}

/// The prediction of a model for the trial held out.
#[wasm_bindgen]
pub struct Prediction {
    fold: Arc<HeldOut>,
    training: Progress,
    model: FittedModel,
}

#[wasm_bindgen]
impl Prediction {
    /// The scores of the prediction. `seconds`: the time of the training.
    #[wasm_bindgen(unchecked_return_type = "Outcome")]
    pub fn outcome(&self, seconds: f64) -> Result<JsValue, VcgpdmError> {
        to_js(&self.fold.outcome(&self.model, &self.training, seconds)?)
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Result<Vec<f32>, VcgpdmError> {
        let y = self.fold.predict(&self.model)?;
        Ok(self.fold.body().positions(&y)?)
    }
}

/// A candidate from JavaScript. Absent fields are the defaults of its model; an absent model is of the
/// `usual` kind.
pub fn candidate_from_js(
    code: ErrorCode,
    what: &str,
    value: &JsValue,
    usual: ModelKind,
) -> Result<Settings, VcgpdmError> {
    from_js(code, what, &whole_candidate(code, what, value, usual)?)
}

fn whole_candidate(
    code: ErrorCode,
    what: &str,
    value: &JsValue,
    usual: ModelKind,
) -> Result<JsValue, VcgpdmError> {
    let given = with_defaults(code, what, value, Object::new().into())?;
    let model = Reflect::get(&given, &"model".into()).unwrap_or_default();
    // The reader refuses an unknown kind, whatever the defaults are.
    let kind = from_js(code, what, &model).unwrap_or(usual.into());
    match kind {
        CandidateKind::Model(kind) => with_defaults(code, what, &given, to_js(&Settings::from(kind))?),
        // The rivals of a file state every setting.
        CandidateKind::ProMp | CandidateKind::Ar => Ok(given),
    }
}

#[derive(Serialize)]
struct Usual {
    held_out: usize,
    training_trials: usize,
    seed: u32,
}

/// A job from JavaScript in a comparison with this number of `trials`.
pub fn job_from_js(job: &JsValue, trials: usize) -> Result<Job, VcgpdmError> {
    const CODE: ErrorCode = ErrorCode::Comparison;
    let usual = to_js(&Usual { held_out: 0, training_trials: trials.saturating_sub(1), seed: 0 })?;
    let job = with_defaults(CODE, "job", job, usual)?;
    let candidate = Reflect::get(&job, &"candidate".into()).unwrap_or_default();
    let candidate = whole_candidate(CODE, "job: `candidate`", &candidate, ModelKind::Vcgpdm)?;
    // A plain object of ours accepts any field.
    let _ = Reflect::set(&job, &"candidate".into(), &candidate);
    from_js(CODE, "job", &job)
}
