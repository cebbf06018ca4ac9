//! The graphics Turing test: studies, the trials of a participant, and new studies from a comparison.

use crate::data::clip::Clip;
use crate::lab::evaluation::candidate_from_js;
use crate::values::arguments::{Text, Whole};
use crate::values::convert::{from_js, to_js};
use crate::values::error::{ErrorCode, VcgpdmError};
use serde::{Deserialize, Serialize};
use std::cell::OnceCell;
use vcgpdm_core::models::{ModelKind, Settings};
use vcgpdm_lab::evaluation::{Outcome, START_FRAMES};
use vcgpdm_lab::perception::{
    Design, Look, Maker, Preset, Stimulus as MovementStimulus, Study as MovementStudy, StudyMovement, Texts,
};
use wasm_bindgen::prelude::*;

/// The skeleton of the moving figure.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "StudySkeleton"))]
struct Skeleton<'a> {
    /// The name of each node: first the joints, then the ends of the last bones.
    names: &'a [String],
    /// The parent of each node; -1 for the root.
    parents: Vec<i32>,
    /// The number of nodes that are joints.
    joints: usize,
    /// Height of the figure, in metres.
    height: f64,
    /// The node on top of the head; null if unknown.
    head: Option<usize>,
    /// The tips of the left and the right foot; null if unknown.
    feet: Option<[usize; 2]>,
    /// The nodes that are drawn for a point-light walker.
    dots: &'a [usize],
}

/// The errors of a model on the held-out trial, and its bound.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "StimulusScores"))]
struct Scores {
    /// Mean squared error on the held-out trial, frame by frame.
    mse: f64,
    /// Mean squared error after dynamic time warping.
    dtw_mse: f64,
    /// The error of rollouts on the trials trained on, after dynamic time warping; null if unknown.
    training_mse: Option<f64>,
    /// The bound on the log evidence, in nats; null for a model without a bound.
    bound: Option<f64>,
    /// The terms of the bound for the dynamics; null if unknown.
    dynamics: Option<f64>,
    /// The terms of the bound for the poses; null if unknown.
    pose: Option<f64>,
}

/// A movement of a study, recorded or generated.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "StudyStimulus"))]
struct Stimulus<'a> {
    /// The unique id by which answers refer to the movement.
    id: &'a str,
    #[cfg_attr(feature = "types", ts(type = "\"natural\" | \"generated\""))]
    kind: &'static str,
    /// The recorded trial, or the held-out trial that was predicted.
    trial: &'a str,
    /// For a natural movement: true if ordinary trials show it, false if only catch trials show it. Always
    /// false for a generated movement.
    seen: bool,
    /// Whether the movement is marked as an obvious failure. Such movements check the participants'
    /// attention.
    failed: bool,
    /// The speed of the figure before centring, in metres a second.
    speed: f64,
    /// The kind of model; null for a natural movement.
    model: Option<ModelKind>,
    /// The settings of the model; null for a natural movement.
    settings: Option<&'a Settings>,
    /// The scores of the model; null for a natural movement.
    scores: Option<Scores>,
}

/// The design, texts and stimuli of a study.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct StudyInfo<'a> {
    title: &'a str,
    look: Look,
    frames_per_second: usize,
    /// How many seconds of each movement are shown.
    seconds: f64,
    /// How many frames of each movement are shown.
    frames: usize,
    /// How many seconds the cross is shown before a movement.
    cross_seconds: f64,
    answer_during_movement: bool,
    pause_seconds: usize,
    texts: &'a Texts,
    skeleton: Skeleton<'a>,
    stimuli: Vec<Stimulus<'a>>,
    design: &'a Design,
    /// SHA-256 of the figure and the movements, hexadecimal. It does not depend on the design, the texts or
    /// the marks of failures. Answers refer to the study by this hash.
    hash: String,
}

/// A study: movements, their sources, and how they are shown.
#[wasm_bindgen]
pub struct Study {
    study: MovementStudy,
    /// The stimuli never change, so the changed copies of a study share them.
    hash: OnceCell<String>,
}

#[wasm_bindgen]
impl Study {
    /// Reads the document of a study. Throws the error with the path of the field.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Study, VcgpdmError> {
        Ok(Study::of(MovementStudy::from_json(&text.get(ErrorCode::Study, "the document")?)?))
    }

    /// The study as a JSON document.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        Ok(self.study.to_json()?)
    }

    /// The design, texts and stimuli of the study.
    #[wasm_bindgen(getter, unchecked_return_type = "StudyInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        let study = &self.study;
        let (texts, design, figure) = (&study.texts, &study.design, &study.figure);
        to_js(&StudyInfo {
            title: &study.title,
            look: study.look,
            frames_per_second: study.frames_per_second,
            seconds: study.seconds,
            frames: study.frames(),
            cross_seconds: study.cross_seconds,
            answer_during_movement: design.answer_during_movement,
            pause_seconds: design.pause_seconds,
            texts,
            skeleton: Skeleton {
                names: &figure.names,
                parents: figure.parents.iter().map(|parent| parent.map_or(-1, |k| k as i32)).collect(),
                joints: figure.joints,
                height: study.height,
                head: figure.landmarks.head,
                feet: figure.landmarks.feet,
                dots: &figure.landmarks.dots,
            },
            stimuli: self.stimuli(),
            design,
            hash: self.hash()?,
        })
    }

    /// The trials of a participant, in order. The seed, a whole number from 0 to 4294967295, determines them.
    #[wasm_bindgen(unchecked_return_type = "StudyTrial[]")]
    pub fn trials(&self, seed: &Whole) -> Result<JsValue, VcgpdmError> {
        let seed = seed.get(ErrorCode::Study, "the seed")?;
        to_js(&self.study.trials(seed))
    }

    /// The positions of a movement's nodes [frames x nodes x 3], in metres. The y axis points up, the ground
    /// is at y = 0, and the figure stays above the origin and faces along z.
    pub fn positions(&self, stimulus: &Whole) -> Result<Vec<f32>, VcgpdmError> {
        let stimulus = stimulus.count(ErrorCode::Study, "the movement")?;
        self.study.positions(stimulus).ok_or_else(|| {
            let most = self.study.stimuli.len().saturating_sub(1);
            let message = format_args!("expected a movement from 0 to {most}, found {stimulus}");
            VcgpdmError::new(ErrorCode::Study, &message)
        })
    }

    /// The same movements with the trials and times of a preset. Movements that are shorter than the preset's
    /// time are shown in full.
    #[wasm_bindgen(js_name = withDesign)]
    pub fn with_design(
        &self,
        #[wasm_bindgen(unchecked_param_type = "StudyPreset")] preset: &Text,
    ) -> Result<Study, VcgpdmError> {
        let preset = self::preset(preset)?;
        Ok(self.changed(self.study.clone().with_preset(preset)))
    }

    /// The same study with figures drawn in this way.
    #[wasm_bindgen(js_name = withLook)]
    pub fn with_look(
        &self,
        #[wasm_bindgen(unchecked_param_type = "StudyLook")] look: &Text,
    ) -> Result<Study, VcgpdmError> {
        let look = self::look(look)?;
        let mut study = self.study.clone();
        study.look = look;
        Ok(self.changed(study))
    }

    /// The same study with other texts to read.
    #[wasm_bindgen(js_name = withTexts)]
    pub fn with_texts(
        &self,
        #[wasm_bindgen(unchecked_param_type = "StudyTexts")] texts: JsValue,
    ) -> Result<Study, VcgpdmError> {
        let texts: Texts = from_js(ErrorCode::Study, "texts", &texts)?;
        let mut study = self.study.clone();
        study.texts = texts;
        Ok(self.changed(study))
    }

    /// The same study, with only the movements of these ids marked as obvious failures.
    #[wasm_bindgen(js_name = withFailed)]
    pub fn with_failed(
        &self,
        #[wasm_bindgen(unchecked_param_type = "string[]")] ids: JsValue,
    ) -> Result<Study, VcgpdmError> {
        let ids: Vec<String> = from_js(ErrorCode::Study, "the ids", &ids)?;
        Ok(self.changed(self.study.clone().with_failed(&ids)?))
    }
}

/// The preset of that name.
pub fn preset(name: &Text) -> Result<Preset, VcgpdmError> {
    let id = name.get(ErrorCode::Study, "the design")?;
    Preset::from_id(&id).ok_or_else(|| {
        let known = Preset::ALL.map(Preset::id).join(", ");
        VcgpdmError::new(ErrorCode::Study, &format_args!("expected one of {known}, found \"{id}\""))
    })
}

/// The look of that name.
pub fn look(name: &Text) -> Result<Look, VcgpdmError> {
    let id = name.get(ErrorCode::Study, "the look")?;
    Look::from_id(&id).ok_or_else(|| {
        VcgpdmError::new(ErrorCode::Study, &format_args!("expected figure or points, found \"{id}\""))
    })
}

impl Study {
    /// A study of the library.
    pub fn of(study: MovementStudy) -> Study {
        Study { study, hash: OnceCell::new() }
    }

    /// Another study of the same movements.
    fn changed(&self, study: MovementStudy) -> Study {
        Study { study, hash: self.hash.clone() }
    }

    fn hash(&self) -> Result<String, VcgpdmError> {
        if self.hash.get().is_none() {
            let _ = self.hash.set(self.study.hash()?);
        }
        Ok(self.hash.get().cloned().unwrap_or_default())
    }

    fn stimuli(&self) -> Vec<Stimulus<'_>> {
        fn known(stimulus: &MovementStimulus) -> Stimulus<'_> {
            let generated = stimulus.generated();
            Stimulus {
                id: &stimulus.id,
                kind: if generated.is_some() { "generated" } else { "natural" },
                trial: &stimulus.trial,
                seen: stimulus.natural() == Some(true),
                failed: stimulus.failed(),
                speed: stimulus.speed,
                model: generated.map(|generated| generated.candidate.kind()),
                settings: generated.map(|generated| &generated.candidate),
                scores: generated.map(|generated| Scores {
                    mse: generated.scores.mse,
                    dtw_mse: generated.scores.dtw_mse,
                    training_mse: generated.scores.training_mse,
                    bound: generated.scores.bound,
                    dynamics: generated.scores.dynamics(),
                    pose: generated.scores.pose(),
                }),
            }
        }
        self.study.stimuli.iter().map(known).collect()
    }
}

/// A movement for a new study.
#[derive(Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct MadeMovement {
    /// The trial, counted from 0. Its id in the study counts from 1.
    trial: usize,
    /// The name of the trial.
    name: String,
    /// Seconds from one frame to the next.
    frame_time: f64,
}

/// Collects movements for a new study: recorded movements and predictions of held-out trials.
#[wasm_bindgen]
pub struct StudyMaker {
    maker: Maker,
}

#[wasm_bindgen]
impl StudyMaker {
    /// A maker without movements, for the body of this clip. Each movement of the study lasts `seconds`, at
    /// most those of the preset; the comparison has `framesPerSecond` frames a second.
    #[wasm_bindgen(constructor)]
    pub fn new(
        body: &Clip,
        seconds: f64,
        #[wasm_bindgen(js_name = framesPerSecond)] frames_per_second: f64,
    ) -> StudyMaker {
        StudyMaker { maker: Maker::new(body.skeleton(), seconds, frames_per_second, START_FRAMES) }
    }

    /// Adds a recorded movement, as `Fold.actual` or `Clip.positions` give it [frames x nodes x 3]. If `seen`
    /// is false, only catch trials show the movement. Throws if the movement is shorter than the movements of
    /// the study.
    #[wasm_bindgen(js_name = addNatural)]
    pub fn add_natural(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "MadeMovement")] movement: JsValue,
        positions: &[f32],
        seen: bool,
    ) -> Result<(), VcgpdmError> {
        let MadeMovement { trial, name, frame_time } = from_js(ErrorCode::Study, "the movement", &movement)?;
        let shown = StudyMovement { trial, name: &name, positions, frame_time };
        Ok(self.maker.natural(&shown, seen)?)
    }

    /// Adds the prediction of a model for the held-out trial, as `Prediction.positions` gives it. If a
    /// candidate has several seeds, the study keeps the seed with the smallest
    /// `outcome.trainingMse`; where no seed has it, the highest `outcome.objective`.
    #[wasm_bindgen(js_name = addGenerated)]
    pub fn add_generated(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "MadeMovement")] movement: JsValue,
        positions: &[f32],
        #[wasm_bindgen(unchecked_param_type = "CandidateOptions")] candidate: JsValue,
        seed: &Whole,
        #[wasm_bindgen(unchecked_param_type = "Outcome")] outcome: JsValue,
    ) -> Result<(), VcgpdmError> {
        let MadeMovement { trial, name, frame_time } = from_js(ErrorCode::Study, "the movement", &movement)?;
        let candidate = candidate_from_js(ErrorCode::Study, "the candidate", &candidate, ModelKind::Vcgpdm)?;
        let outcome: Outcome = from_js(ErrorCode::Study, "the outcome", &outcome)?;
        let seed = seed.get(ErrorCode::Study, "the seed")?;
        let shown = StudyMovement { trial, name: &name, positions, frame_time };
        Ok(self.maker.generated(&shown, &candidate, seed, &outcome)?)
    }

    /// The study of all movements that were added so far.
    pub fn study(
        &self,
        title: &Text,
        #[wasm_bindgen(unchecked_param_type = "StudyPreset")] design: &Text,
        #[wasm_bindgen(unchecked_param_type = "StudyLook", js_name = drawn)] drawn: &Text,
        seed: &Whole,
    ) -> Result<Study, VcgpdmError> {
        let title = title.get(ErrorCode::Study, "the title")?;
        let seed = seed.get(ErrorCode::Study, "the seed")?;
        let study = self.maker.clone().study(&title, preset(design)?, look(drawn)?, seed)?;
        Ok(Study::of(study))
    }
}
