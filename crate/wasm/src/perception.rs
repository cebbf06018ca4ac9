//! What answers to a study say.

use crate::arguments::Text;
use crate::convert::{from_js, to_js, to_json};
use crate::error::{ErrorCode, VcgpdmError};
use serde::{Deserialize, Serialize};
use vcgpdm_lab::perception::{AnalysisOptions, AnswerFile, PerceptionResults, Study, read_answers};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A file of answers: CSV or JSON, as the page or jsPsych writes it. */
export interface AnswersFile {
    name: string;
    text: string;
}

/** How answers are analysed; what is absent is as the terminal program has it. */
export interface PerceptionOptions {
    /** The ceiling c of the logistic regression. */
    ceiling?: number;
    /** Blocks of the cross-validation. */
    folds?: number;
    /** Draws from the posteriors for the order of the models. */
    draws?: number;
    /** The seed of blocks and draws. */
    seed?: number;
    /** Participants below this share of attention checks are left out. */
    attention?: number;
}

/** How answers were analysed. */
export interface UsedOptions {
    ceiling: number;
    folds: number;
    draws: number;
    seed: number;
    attention: number;
}

/**
 * How often movements were taken for the natural one, and what that says: the posterior beta(1 + hits, 1 +
 * trials - hits).
 */
export interface Confusion {
    hits: number;
    trials: number;
    mean: number;
    deviation: number;
    /** 95 % of the posterior lie between these. */
    low: number;
    high: number;
    /** The posterior probability that the rate is above one half. */
    aboveHalf: number;
}

/** A participant. */
export interface Participant {
    name: string;
    /** Answered comparisons. */
    comparisons: number;
    unanswered: number;
    attentionChecks: number;
    /** How many of these were seen through. */
    attentionHits: number;
    /** Whether they are left out, for too few of these. */
    excluded: boolean;
    /** The share of answers "left". */
    left: number | null;
    /** In milliseconds. */
    medianRt: number | null;
    /** How long after each other movements started at the most, in milliseconds. */
    startedApartMs: number | null;
}

/** What predicts the rate. */
export type ScoreKind = "mse" | "dtw-mse" | "bound" | "dynamics" | "pose";

/** A model with all its settings. */
export interface SettingResult {
    model: ModelKind;
    candidate: Candidate;
    /** The settings that set it apart, in a few words. */
    label: string;
    size: { dynamicsIps: number | null; poseIps: number | null; primitives: number | null; bases: number | null };
    /** Movements that have not failed. */
    movements: number;
    /** Movements that failed: where all did, the setting is an attention check. */
    failed: number;
    /** Means over the movements that have not failed; null where all did. */
    scores: { mse: number; dtwMse: number; bound: number | null; dynamics: number | null; pose: number | null } | null;
    /** Null without an answer. */
    confusion: Confusion | null;
}

/** How a score predicts the rate: p = ceiling / (1 + exp(w0 + w1 (score - centre) / scale)). */
export interface Regression {
    /** Null: all together. */
    model: ModelKind | null;
    score: ScoreKind;
    settings: number;
    trials: number;
    centre: number;
    scale: number;
    ceiling: number;
    /** w0 and w1. */
    weights: number[];
    /** Their standard errors; null where the answers do not tell both. */
    errors: number[] | null;
    /**
     * ln K beside a constant, a block: the mean over the blocks left out; null with fewer answers than
     * blocks.
     */
    logBayesFactor: number | null;
    logBayesFactorError: number | null;
    folds: number;
    /** Scores and the rates that the curve predicts. */
    curve: number[][];
}

/** The setting of a kind of model with the highest rate. */
export interface BestSetting {
    model: ModelKind;
    /** Its place among the settings. */
    setting: number;
    label: string;
    confusion: Confusion;
}

/** What answers to a study say. */
export interface PerceptionResults {
    format: string;
    version: number;
    /** The program and its version. */
    engine: string;
    title: string;
    /** What was shown: the study's hash. */
    study: string;
    options: UsedOptions;
    participants: Participant[];
    /** Of all comparisons that count. */
    all: Confusion;
    settings: SettingResult[];
    regressions: Regression[];
    best: BestSetting[];
    /** Orders of the kinds, the highest rate first, the likeliest order first. */
    orders: { models: ModelKind[]; probability: number }[];
    /** `pairs[a][b]`: the probability that best setting a has a higher rate than best setting b. */
    pairs: number[][];
    /** Null without catch trials. */
    catch: { confusion: Confusion; isHalf: number } | null;
    /** Trials that a setting needs: to tell 0.6 from 0.5, and for 0.5 to lie in [0.45, 0.55]. */
    needed: { toTell: number | null; forPrecision: number | null };
}

/** The data of a figure of the papers. */
export interface FigureTable {
    /** A name for its file. */
    name: string;
    title: string;
    csv: string;
}
"#;

#[derive(Deserialize)]
struct AnswersFile {
    name: String,
    text: String,
}

#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct PerceptionOptions {
    ceiling: Option<f64>,
    folds: Option<usize>,
    draws: Option<usize>,
    seed: Option<u32>,
    attention: Option<f64>,
}

#[derive(Serialize)]
struct FigureTable {
    name: &'static str,
    title: &'static str,
    csv: String,
}

fn results(study: &Text, answers: &JsValue, options: &JsValue) -> Result<PerceptionResults, VcgpdmError> {
    let study = Study::from_json(&study.get(ErrorCode::Study, "the study")?)?;
    let files: Vec<AnswersFile> = from_js(ErrorCode::Study, "the answers", answers)?;
    let asked: PerceptionOptions = if options.is_undefined() || options.is_null() {
        PerceptionOptions::default()
    } else {
        from_js(ErrorCode::Study, "the options", options)?
    };
    let usual = AnalysisOptions::default();
    let options = AnalysisOptions {
        ceiling: asked.ceiling.unwrap_or(usual.ceiling),
        folds: asked.folds.unwrap_or(usual.folds),
        draws: asked.draws.unwrap_or(usual.draws),
        seed: asked.seed.unwrap_or(usual.seed),
        attention: asked.attention.unwrap_or(usual.attention),
    };
    let given = files.iter().map(|file| AnswerFile { name: &file.name, text: &file.text });
    let answers = read_answers(&study, &given.collect::<Vec<_>>())?;
    Ok(PerceptionResults::new(&study, &answers, options)?)
}

/// What answers to a study say: the same numbers as `vcgpdm perception`.
#[wasm_bindgen(js_name = analysePerception, unchecked_return_type = "PerceptionResults")]
pub fn analyse_perception(
    study: &Text,
    #[wasm_bindgen(unchecked_param_type = "AnswersFile[]")] answers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PerceptionOptions")] options: JsValue,
) -> Result<JsValue, VcgpdmError> {
    to_js(&results(study, &answers, &options)?)
}

/// The same as the document that `vcgpdm perception --out` writes.
#[wasm_bindgen(js_name = perceptionJson)]
pub fn perception_json(
    study: &Text,
    #[wasm_bindgen(unchecked_param_type = "AnswersFile[]")] answers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PerceptionOptions")] options: JsValue,
) -> Result<String, VcgpdmError> {
    to_json(&results(study, &answers, &options)?)
}

/// The data of the papers' figures, as `vcgpdm perception --figures` writes them.
#[wasm_bindgen(js_name = perceptionFigures, unchecked_return_type = "FigureTable[]")]
pub fn perception_figures(
    study: &Text,
    #[wasm_bindgen(unchecked_param_type = "AnswersFile[]")] answers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PerceptionOptions")] options: JsValue,
) -> Result<JsValue, VcgpdmError> {
    let figures = results(study, &answers, &options)?.figures().into_iter();
    let tables =
        figures.map(|figure| FigureTable { name: figure.name, title: figure.title, csv: figure.csv });
    to_js(&tables.collect::<Vec<_>>())
}
