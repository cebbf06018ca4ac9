//! The results of the analysis of the answers to a study.

use crate::arguments::Text;
use crate::convert::{from_js, to_js, to_json};
use crate::error::{ErrorCode, VcgpdmError};
use serde::{Deserialize, Serialize};
use vcgpdm_lab::perception::{AnalysisOptions, AnswerFile, PerceptionResults, Study, read_answers};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A file of answers: CSV or JSON, in the format of the page or of jsPsych. */
export interface AnswersFile {
    name: string;
    text: string;
}

/** The options of the analysis. An absent option has the default value of the terminal program. */
export interface PerceptionOptions {
    /** The ceiling c of the logistic regression. */
    ceiling?: number;
    /** The number of blocks of the cross-validation. */
    folds?: number;
    /** The number of draws from the posteriors that estimate the order of the models. */
    draws?: number;
    /** The seed that determines blocks and draws. */
    seed?: number;
    /** Participants who pass less than this share of their attention checks are excluded. */
    attention?: number;
}

/** The options that the analysis used. */
export interface UsedOptions {
    ceiling: number;
    folds: number;
    draws: number;
    seed: number;
    attention: number;
}

/**
 * How often participants took a movement for the natural one, and the posterior of this rate: beta(1 + hits,
 * 1 + trials - hits).
 */
export interface Confusion {
    hits: number;
    trials: number;
    mean: number;
    deviation: number;
    /** The bounds of the 95 % interval of the posterior. */
    low: number;
    high: number;
    /** The posterior probability that the rate is above one half. */
    aboveHalf: number;
}

/** A participant. */
export interface Participant {
    name: string;
    /** The number of answered comparisons. */
    comparisons: number;
    unanswered: number;
    attentionChecks: number;
    /** The number of attention checks that the participant passed. */
    attentionHits: number;
    /** Whether the participant is excluded for passing too few attention checks. */
    excluded: boolean;
    /** The share of answers "left". */
    left: number | null;
    /** The median response time, in milliseconds. */
    medianRt: number | null;
    /** The longest time between the starts of the two movements of a trial, in milliseconds. */
    startedApartMs: number | null;
}

/** The score that predicts the rate. */
export type ScoreKind = "mse" | "dtw-mse" | "bound" | "dynamics" | "pose";

/** A model with all its settings. */
export interface SettingResult {
    model: ModelKind;
    candidate: Candidate;
    /** The settings that differ from those of other candidates, as a short text. */
    label: string;
    size: { dynamicsIps: number | null; poseIps: number | null; primitives: number | null; bases: number | null };
    /** The number of movements that are not marked as failures. */
    movements: number;
    /** The number of movements that are marked as failures. If all are, the setting is an attention check. */
    failed: number;
    /** Means over the movements that are not marked as failures; null if all are. */
    scores: { mse: number; dtwMse: number; bound: number | null; dynamics: number | null; pose: number | null } | null;
    /** Null if there is no answer. */
    confusion: Confusion | null;
}

/** How a score predicts the rate: p = ceiling / (1 + exp(w0 + w1 (score - centre) / scale)). */
export interface Regression {
    /** Null for all kinds of models together. */
    model: ModelKind | null;
    score: ScoreKind;
    settings: number;
    trials: number;
    centre: number;
    scale: number;
    ceiling: number;
    /** w0 and w1. */
    weights: number[];
    /** The standard errors of the weights; null if the answers do not determine both weights. */
    errors: number[] | null;
    /**
     * The log Bayes factor per block, compared with a constant rate: the mean over the blocks that were left
     * out of the fit. Null if there are fewer answers than blocks.
     */
    logBayesFactor: number | null;
    logBayesFactorError: number | null;
    folds: number;
    /** Points of the curve: a score and the predicted rate. */
    curve: number[][];
}

/** For one kind of model, the setting with the highest rate. */
export interface BestSetting {
    model: ModelKind;
    /** The index of the setting in `settings`. */
    setting: number;
    label: string;
    confusion: Confusion;
}

/** The results of the analysis of the answers to a study. */
export interface PerceptionResults {
    format: string;
    version: number;
    /** The program that made the analysis, and its version. */
    engine: string;
    title: string;
    /** The hash of the study. */
    study: string;
    options: UsedOptions;
    participants: Participant[];
    /** The rate over all comparisons that count. */
    all: Confusion;
    settings: SettingResult[];
    regressions: Regression[];
    best: BestSetting[];
    /** Orders of the kinds of models, by falling rate. The most probable order comes first. */
    orders: { models: ModelKind[]; probability: number }[];
    /** `pairs[a][b]`: the probability that best setting a has a higher rate than best setting b. */
    pairs: number[][];
    /** Null if there are no catch trials. */
    catch: { confusion: Confusion; isHalf: number } | null;
    /**
     * How many trials a setting needs to distinguish 0.6 from 0.5, and to estimate 0.5 within [0.45, 0.55].
     */
    needed: { toTell: number | null; forPrecision: number | null };
}

/** The data for a figure like one of the papers. */
export interface FigureTable {
    /** A name for the file of the figure. */
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

/// Analyses the answers to a study. The numbers are the same as those of `vcgpdm perception`.
#[wasm_bindgen(js_name = analysePerception, unchecked_return_type = "PerceptionResults")]
pub fn analyse_perception(
    study: &Text,
    #[wasm_bindgen(unchecked_param_type = "AnswersFile[]")] answers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PerceptionOptions")] options: JsValue,
) -> Result<JsValue, VcgpdmError> {
    to_js(&results(study, &answers, &options)?)
}

/// The analysis as the document that `vcgpdm perception --out` writes.
#[wasm_bindgen(js_name = perceptionJson)]
pub fn perception_json(
    study: &Text,
    #[wasm_bindgen(unchecked_param_type = "AnswersFile[]")] answers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PerceptionOptions")] options: JsValue,
) -> Result<String, VcgpdmError> {
    to_json(&results(study, &answers, &options)?)
}

/// The data for the papers' figures, in the format that `vcgpdm perception --figures` writes.
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
