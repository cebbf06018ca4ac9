//! Results of a comparison: which jobs are asked for, which are finished, and what they say.

use crate::arguments::Text;
use crate::clip::TrainingSet;
use crate::convert::{from_js, from_json, to_js, to_js_joined, to_json};
use crate::error::{ErrorCode, VcgpdmError};
use crate::evaluation::ComparisonSettings;
use crate::settings::cost_to_js;
use js_sys::{Array, Reflect};
use serde::Serialize;
use vcgpdm_lab::evaluation::{Comparison, Finished, Job, Plan, Results as AllResults, START_FRAMES, Setting};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** One candidate in one fold with one seed. */
export interface Job {
    candidate: Candidate;
    /** The trial held out, counted from 1. */
    heldOut: number;
    /** How many of the other trials are trained on. */
    trainingTrials: number;
    seed: number;
}

/** A trial, by its content. */
export interface Trial {
    name: string;
    /** SHA-256 of the clip's file, hexadecimal. */
    sha256: string;
    /** The frames of the clip that were used, from the first up to but not including the end; null: all. */
    piece: [number, number] | null;
}

/** What all results of a comparison have in common. */
export interface Setting {
    trials: Trial[];
    parts: PartSpec[];
    framesPerSecond: number;
    /** Frames of the trial held out that a prediction starts from. */
    startFrames: number;
}

/** Which trainings a comparison asks for. */
export interface Plan {
    /** Coupled models are left out for a body in one part. */
    models: ModelKind[];
    latent: number;
    order: number;
    maxIterations: number;
    /**
     * Numbers of inducing points of the variational models: of every dynamics map, and of every pose map
     * where there are no `poseIps`.
     */
    ips: number[];
    /** Numbers of inducing points of every pose map, each with each of `ips`. */
    poseIps?: number[];
    /** Numbers of primitives of the TMP; null: chosen by the bound. */
    primitives: (number | null)[];
    /** Whether the TMP is that of the papers: over normalised time, with weights that all trials share. */
    normalisedTime?: boolean;
    /** Numbers of basis functions of the DMPs. */
    bases: number[];
    /** Whether the dynamics of the MAP models are balanced. */
    balanced: boolean;
    /** Whether their kernels have a linear term. */
    linear?: boolean;
    /** Trials held out, counted from 1; empty: each in turn. */
    heldOut: number[];
    /** Of the models that have random starts; the others get 0. */
    seeds: number[];
    /** How many of the other trials are trained on; empty: all. */
    trainingTrials: number[];
    /**
     * Whether also the coupled models, with the middle number of inducing points, are trained on 1, 2, ...
     * trials in the first fold with the first seed.
     */
    growth: boolean;
}

/** A job that a plan asks for. */
export interface PlannedJob {
    /** Tells the job from every other; readable. */
    id: string;
    job: Job;
    /** Whether the results hold an outcome of it. */
    done: boolean;
}

/** A finished job: with an outcome, or the reason why there is none. */
export interface FinishedJob {
    /** Tells the job from every other; readable. */
    id: string;
    job: Job;
    /** The program and its version that computed it. */
    engine: string;
    outcome: Outcome | null;
    failure: string | null;
}

/** A mean over folds; seeds of the same fold are averaged first. */
export interface Spread {
    mean: number;
    /** Null for a single fold. */
    standardError: number | null;
    /** Number of folds. */
    count: number;
}

/** One candidate: a row of figure 4 of Velychko et al. (2018). */
export interface ModelSummary {
    model: ModelKind;
    candidate: Candidate;
    /** The settings that set it apart, in a few words. */
    label: string;
    /** Mean squared error after dynamic time warping. */
    mse: Spread;
    /** The median error over the folds: a single rollout that goes astray does not move it. */
    mseMedian: number;
    /** The same error on the trials that were trained on; null where the results do not hold it. */
    trainingMse: Spread | null;
    /** The error of a prediction that does not move. */
    variance: number;
    /** The bound on the log evidence, in nats, where the model has one. */
    bound: Spread | null;
    /** Seconds of a training. */
    seconds: Spread;
    /** Numbers that must be kept to roll out. */
    storedNumbers: Spread;
    /** The share of trainings that ended because nothing changed any more; null where that is not known. */
    converged: number | null;
    /** Means of the terms of the bound, in nats; null where the results do not hold them. */
    terms: { pose: number; dynamics: number } | null;
    /** The mean error of each part; empty where the results do not hold it. */
    partErrors: number[];
    /** Number of trials held out. */
    folds: number;
    /** Number of trainings. */
    runs: number;
    /**
     * How many candidates it stands for: all that differ in size alone, where it is the one of them that
     * claims choose for most trials; else 0.
     */
    standsFor: number;
}

/** One candidate in figure 6B of Velychko et al. (2018). */
export interface BoundAndError {
    label: string;
    /** The mean bound, in nats. */
    bound: number;
    /** The mean error. */
    mse: number;
}

/** Bound and error of one kind of model over its sizes, all other settings being the same. */
export interface Correlation {
    model: ModelKind;
    /** What the candidates have in common, where the kind has several such groups; else empty. */
    label: string;
    /** Number of candidates. */
    settings: number;
    /** Number of trials held out that all of them have. */
    folds: number;
    /** Spearman's rank correlation. */
    rank: number;
    /** The share of all orders of the settings whose correlation is as low. */
    chance: number;
    points: BoundAndError[];
}

/** Mean number of frames trained on, and mean seconds of an iteration. */
export interface FramesAndTime {
    frames: number;
    seconds: number;
    /** Mean seconds of a whole training. */
    trainingSeconds: number;
}

/** Learning time of one candidate over the frames trained on. */
export interface Growth {
    model: ModelKind;
    label: string;
    /** From few to many frames. */
    points: FramesAndTime[];
    /** k where the time of an iteration grows as frames to the power k; null where it cannot be told. */
    exponent: number | null;
    /** Where it lies, 95 %; null where it cannot be told. */
    interval: Interval | null;
    /** The same power for a whole training; null where it cannot be told. */
    trainingExponent: number | null;
    /** Where that lies. */
    trainingInterval: Interval | null;
    /**
     * The share of these trainings that ended because nothing changed any more; null where that is not known.
     */
    converged: number | null;
}

/** Where a number lies, with the probability that such an interval covers it. */
export interface Interval {
    low: number;
    high: number;
    level: number;
}

/** What bounds and errors of one part and several say in one fold. */
export interface Evidence {
    /** The trial held out. */
    trial: string;
    /** The bound of the vCGPDM minus that of the vGPDM, in nats. */
    logBayesFactor: number;
    /** The error of the vCGPDM over that of the vGPDM. */
    errorRatio: number;
}

/** What the papers say, and what these results say about it. */
export interface Claim {
    /** The sentence of the paper, or our own question next to it. */
    claim: string;
    /** Its place in the papers: year and section. */
    place: string;
    /** Our criterion for it. */
    criterion: string;
    /** The effect that was found, with its interval. */
    found: string;
    /** Whether the numbers agree; only where the whole interval does. */
    answer: "yes" | "no" | "undecided";
}

/** What the results of a comparison say. */
export interface Comparison {
    /** Names of the parts whose errors the models have. */
    parts: string[];
    /** Every candidate that was trained on all other trials. */
    models: ModelSummary[];
    /** For every kind of model with a bound and at least three candidates that differ in size alone. */
    correlations: Correlation[];
    /** For every kind of model that was trained on at least three numbers of trials. */
    growth: Growth[];
    /** In every fold that both variational models have. */
    evidence: Evidence[];
    /** The claims about which there are results. */
    claims: Claim[];
}
"#;

/// What tells a job from every other.
#[derive(Serialize)]
struct Identity {
    id: String,
}

/// A value about a job, with the id of the job.
fn identified<T: Serialize>(job: &Job, value: &T) -> Result<JsValue, VcgpdmError> {
    to_js_joined(&Identity { id: job.to_string() }, value)
}

/// All results of a comparison so far.
#[wasm_bindgen]
pub struct Results {
    results: AllResults,
}

#[wasm_bindgen]
impl Results {
    /// No job finished yet; each clip of the set is a trial.
    pub fn empty(
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_param_type = "ComparisonSettings")] settings: JsValue,
    ) -> Result<Results, VcgpdmError> {
        let ComparisonSettings { parts, frames_per_second } =
            from_js(ErrorCode::Comparison, "settings", &settings)?;
        let setting = Setting::new(&clips.clips, &parts, frames_per_second, START_FRAMES)?;
        Ok(Results { results: AllResults::new(setting) })
    }

    /// Reads a file of results, from the page or from the terminal program.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Results, VcgpdmError> {
        let text = text.get(ErrorCode::Results, "the document")?;
        let results: AllResults =
            from_json(ErrorCode::Results, "expected the results of an evaluation", &text)?;
        results.check()?;
        Ok(Results { results })
    }

    /// The file: its fields have the names of the terminal program, in snake_case.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        to_json(&self.results)
    }

    /// What was compared on what.
    #[wasm_bindgen(unchecked_return_type = "Setting")]
    pub fn setting(&self) -> Result<JsValue, VcgpdmError> {
        let setting = to_js(self.results.setting())?;
        // A file leaves out the piece of a whole clip.
        let trials = Reflect::get(&setting, &"trials".into()).unwrap_or_default();
        for trial in Array::from(&trials).iter() {
            if !Reflect::has(&trial, &"piece".into()).unwrap_or(true) {
                let _ = Reflect::set(&trial, &"piece".into(), &JsValue::NULL);
            }
        }
        Ok(setting)
    }

    /// The jobs that are finished, in the order of tables: by model, then by size, then by seed.
    #[wasm_bindgen(unchecked_return_type = "FinishedJob[]")]
    pub fn finished(&self) -> Result<Array, VcgpdmError> {
        self.results.in_order().into_iter().map(|finished| identified(&finished.job, finished)).collect()
    }

    /// The jobs that the plan asks for, fold after fold, so that the first tables come early.
    #[wasm_bindgen(unchecked_return_type = "PlannedJob[]")]
    pub fn jobs(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Plan")] plan: JsValue,
    ) -> Result<Array, VcgpdmError> {
        let plan: Plan = from_js(ErrorCode::Comparison, "plan", &plan)?;
        let one_part = self.results.setting().parts.len() < 2;
        let jobs = self.results.jobs(&if one_part { plan.without_coupled() } else { plan })?;
        jobs.iter().map(|planned| identified(&planned.job, planned)).collect()
    }

    /// What the training of a job will cost here, on these trials; nothing for TMP and DMP: beside the others
    /// they cost little.
    #[wasm_bindgen(js_name = costOf, unchecked_return_type = "TrainingCost")]
    pub fn cost_of(
        &self,
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_param_type = "Job")] job: JsValue,
    ) -> Result<JsValue, VcgpdmError> {
        let job: Job = from_js(ErrorCode::Comparison, "job", &job)?;
        let Setting { parts, frames_per_second, .. } = self.results.setting();
        cost_to_js(job.candidate.kind(), job.cost(&clips.clips, parts, *frames_per_second))
    }

    /// Keeps the outcome of a job that this program trained. An outcome that is there already stays.
    pub fn add(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Job")] job: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Outcome")] outcome: JsValue,
    ) -> Result<(), VcgpdmError> {
        let job = from_js(ErrorCode::Comparison, "job", &job)?;
        let outcome = from_js(ErrorCode::Comparison, "outcome", &outcome)?;
        Ok(self.results.add(Finished::new(job, Ok(outcome)))?)
    }

    /// Takes over what the other results know and these do not. Throws when the other is of another setting.
    pub fn merge(&mut self, other: &Results) -> Result<(), VcgpdmError> {
        Ok(self.results.merge(other.results.clone())?)
    }

    /// What they say: tables, correlations, exponents, claims.
    #[wasm_bindgen(unchecked_return_type = "Comparison")]
    pub fn comparison(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&Comparison::new(&self.results))
    }
}
