//! The graphics Turing test: studies, and what a participant is shown.

use crate::arguments::{Text, Whole};
use crate::convert::{from_js, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use serde::{Deserialize, Serialize};
use std::cell::OnceCell;
use vcgpdm::models::{ModelKind, Settings};
use vcgpdm_lab::perception::{
    Look, Preset, Stimulus as MovementStimulus, Study as MovementStudy, StudyTrial as Shown, Texts,
};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What a participant reads: plain text, with an empty line between paragraphs. */
export interface StudyTexts {
    consent: string;
    instructions: string;
    question: string;
    pause: string;
    end: string;
}

/** The figure that moves. */
export interface StudySkeleton {
    /** The name of each node; joints first, then the ends of the last bones. */
    names: string[];
    /** The parent of each node; -1 for the root. */
    parents: number[];
    /** How many of the nodes are joints. */
    joints: number;
    /** Height of the figure, in metres. */
    height: number;
    /** The node on top of the head; null where it is not known. */
    head: number | null;
    /** The tips of the left and the right foot; null where they are not known. */
    feet: [number, number] | null;
    /** The nodes that a point-light walker shows. */
    dots: number[];
}

/** How good a model is at the trial held out, and what its bound says. */
export interface StimulusScores {
    /** Mean squared error on the trial held out, frame by frame. */
    mse: number;
    /** The same after dynamic time warping. */
    dtwMse: number;
    /** The bound on the log evidence, in nats; null where the model has none. */
    bound: number | null;
    /** The part of the bound about dynamics; null where its terms are not known. */
    dynamics: number | null;
    /** The part of the bound about poses; null where its terms are not known. */
    pose: number | null;
}

/** A movement of a study. */
export interface StudyStimulus {
    /** Tells it from all others: what answers name it by. */
    id: string;
    kind: "natural" | "generated";
    /** The trial that was recorded, or held out and predicted. */
    trial: string;
    /**
     * Of a natural one: whether it is shown all along; else it is kept for catch trials. False for a
     * generated one.
     */
    seen: boolean;
    /** Whether it is marked as an obvious failure: it checks attention. */
    failed: boolean;
    /** How fast the figure went before it was centred, in metres a second. */
    speed: number;
    /** The kind of model; null for a natural one. */
    model: ModelKind | null;
    /** Its settings; null for a natural one. */
    settings: Candidate | null;
    /** How good it is; null for a natural one. */
    scores: StimulusScores | null;
}

/** How many trials of which kind a participant is shown. */
export interface StudyDesign {
    blocks: number;
    comparisons: number;
    /** None are shown where the study has no failed movement. */
    attentionChecks: number;
    /** None are shown where the study has no unseen natural movement. */
    catchTrials: number;
    /** The shortest pause between blocks. */
    pauseSeconds: number;
    /** Whether an answer is taken while the movements go on, which ends the trial. */
    answerDuringMovement: boolean;
    seed: number;
}

/** Designs with a name. */
export type StudyPreset = "class" | "p3-part-1" | "p3-part-2" | "p2";

/** How the figures of a study are drawn. */
export type StudyLook = "figure" | "points";

/** The design, texts and stimuli of a study. */
export interface StudyInfo {
    title: string;
    look: StudyLook;
    framesPerSecond: number;
    /** Seconds of each movement that are shown. */
    seconds: number;
    /** Frames of each movement that are shown. */
    frames: number;
    /** Seconds of the cross before it. */
    crossSeconds: number;
    answerDuringMovement: boolean;
    pauseSeconds: number;
    texts: StudyTexts;
    skeleton: StudySkeleton;
    stimuli: StudyStimulus[];
    design: StudyDesign;
    /**
     * SHA-256 of what is shown, hexadecimal: the same for every design, text and mark. Answers name the study
     * by it.
     */
    hash: string;
}

/** Two movements side by side. */
export interface StudyTrial {
    /** Counted from 0. */
    block: number;
    kind: "comparison" | "attention" | "catch";
    /** The place of the stimulus on the left. */
    left: number;
    /** The place of the stimulus on the right. */
    right: number;
    /** On which side the natural movement is; "none": on both. */
    naturalSide: "left" | "right" | "none";
    /** The way that both figures go: 0 is towards the observer, 90 to the observer's right. */
    headingDegrees: number;
}
"#;

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct StudyTexts {
    consent: String,
    instructions: String,
    question: String,
    pause: String,
    end: String,
}

#[derive(Serialize)]
struct Skeleton<'a> {
    names: &'a [String],
    parents: Vec<i32>,
    joints: usize,
    height: f64,
    head: Option<usize>,
    feet: Option<[usize; 2]>,
    dots: &'a [usize],
}

#[derive(Serialize)]
struct Scores {
    mse: f64,
    dtw_mse: f64,
    bound: Option<f64>,
    dynamics: Option<f64>,
    pose: Option<f64>,
}

#[derive(Serialize)]
struct Stimulus<'a> {
    id: &'a str,
    kind: &'static str,
    trial: &'a str,
    seen: bool,
    failed: bool,
    speed: f64,
    model: Option<ModelKind>,
    settings: Option<&'a Settings>,
    scores: Option<Scores>,
}

#[derive(Serialize)]
struct Design {
    blocks: usize,
    comparisons: usize,
    attention_checks: usize,
    catch_trials: usize,
    pause_seconds: usize,
    answer_during_movement: bool,
    seed: u32,
}

#[derive(Serialize)]
struct StudyInfo<'a> {
    title: &'a str,
    look: &'static str,
    frames_per_second: usize,
    seconds: f64,
    frames: usize,
    cross_seconds: f64,
    answer_during_movement: bool,
    pause_seconds: usize,
    texts: StudyTexts,
    skeleton: Skeleton<'a>,
    stimuli: Vec<Stimulus<'a>>,
    design: Design,
    hash: String,
}

#[derive(Serialize)]
struct StudyTrial {
    block: usize,
    kind: &'static str,
    left: usize,
    right: usize,
    natural_side: &'static str,
    heading_degrees: usize,
}

/// A study: movements, who made them, and how they are shown.
#[wasm_bindgen]
pub struct Study {
    study: MovementStudy,
    /// The stimuli never change, so a large study is read once.
    hash: OnceCell<String>,
}

#[wasm_bindgen]
impl Study {
    /// Reads a study's document. Throws what is wrong, with the path of the field.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Study, VcgpdmError> {
        Ok(Study::of(MovementStudy::from_json(&text.get(ErrorCode::Study, "the document")?)?))
    }

    /// The document.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        Ok(self.study.to_json()?)
    }

    /// Its design, texts and stimuli.
    #[wasm_bindgen(getter, unchecked_return_type = "StudyInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        let study = &self.study;
        let (texts, design, figure) = (&study.texts, &study.design, &study.figure);
        to_js(&StudyInfo {
            title: &study.title,
            look: study.look.id(),
            frames_per_second: study.frames_per_second,
            seconds: study.seconds,
            frames: study.frames(),
            cross_seconds: study.cross_seconds,
            answer_during_movement: design.answer_during_movement,
            pause_seconds: design.pause_seconds,
            texts: StudyTexts {
                consent: texts.consent.clone(),
                instructions: texts.instructions.clone(),
                question: texts.question.clone(),
                pause: texts.pause.clone(),
                end: texts.end.clone(),
            },
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
            design: Design {
                blocks: design.blocks,
                comparisons: design.comparisons,
                attention_checks: design.attention_checks,
                catch_trials: design.catch_trials,
                pause_seconds: design.pause_seconds,
                answer_during_movement: design.answer_during_movement,
                seed: design.seed,
            },
            hash: self.hash()?,
        })
    }

    /// What a participant is shown, in order: the same for the same seed, a whole number from 0 to
    /// 4294967295.
    #[wasm_bindgen(unchecked_return_type = "StudyTrial[]")]
    pub fn trials(&self, seed: &Whole) -> Result<JsValue, VcgpdmError> {
        let seed = seed.get(ErrorCode::Study, "the seed")?;
        let trial = |trial: Shown| StudyTrial {
            block: trial.block,
            kind: trial.kind.id(),
            left: trial.left,
            right: trial.right,
            natural_side: trial.natural_side.id(),
            heading_degrees: trial.heading_degrees,
        };
        to_js(&self.study.trials(seed).into_iter().map(trial).collect::<Vec<_>>())
    }

    /// The places of a movement's nodes [frames x nodes x 3]: y up, in metres, the ground at y = 0, the
    /// figure above the origin, on its way along z.
    pub fn positions(&self, stimulus: &Whole) -> Result<Vec<f32>, VcgpdmError> {
        let stimulus = stimulus.count(ErrorCode::Study, "the movement")?;
        self.study.positions(stimulus).ok_or_else(|| {
            let most = self.study.stimuli.len().saturating_sub(1);
            let message = format_args!("expected a movement from 0 to {most}, found {stimulus}");
            VcgpdmError::new(ErrorCode::Study, &message)
        })
    }

    /// The same movements with the trials and times of a preset; movements that are shorter than the preset's
    /// are shown whole.
    #[wasm_bindgen(js_name = withDesign)]
    pub fn with_design(
        &self,
        #[wasm_bindgen(unchecked_param_type = "StudyPreset")] preset: &Text,
    ) -> Result<Study, VcgpdmError> {
        let preset = self::preset(preset)?;
        Ok(self.changed(self.study.clone().with_preset(preset)))
    }

    /// The same study with figures that are drawn like this.
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
        let StudyTexts { consent, instructions, question, pause, end } =
            from_js(ErrorCode::Study, "texts", &texts)?;
        let mut study = self.study.clone();
        study.texts = Texts { consent, instructions, question, pause, end };
        Ok(self.changed(study))
    }

    /// The same study of which the movements of these ids, and no others, are marked as obvious failures.
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
                    bound: generated.scores.bound,
                    dynamics: generated.scores.dynamics(),
                    pose: generated.scores.pose(),
                }),
            }
        }
        self.study.stimuli.iter().map(known).collect()
    }
}
