//! Results of a comparison: the planned jobs, the finished jobs, and tables of the results.

use crate::arguments::Text;
use crate::clip::TrainingSet;
use crate::convert::{from_js, from_json, to_js, to_js_joined, to_json};
use crate::error::{ErrorCode, VcgpdmError};
use crate::evaluation::job_from_js;
use crate::evaluation::{ComparisonSettings, check_held_out};
use crate::settings::{cost_to_js, with_defaults};
use js_sys::{Array, Object, Reflect};
use serde::Serialize;
use vcgpdm::models::Settings;
use vcgpdm_lab::evaluation::{Comparison, Finished, Job, Plan, Results as AllResults, START_FRAMES, Setting};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** One candidate in one fold with one seed. */
export interface Job {
    candidate: Candidate;
    /** The held-out trial, counted from 0. */
    heldOut: number;
    /** The number of other trials in the training set. */
    trainingTrials: number;
    seed: number;
}

/** A trial, identified by the hash of its file. */
export interface Trial {
    name: string;
    /** SHA-256 of the clip's file, hexadecimal. */
    sha256: string;
    /** The used frames of the clip, from the first up to but not including the end; null: all frames. */
    piece: [number, number] | null;
}

/** The setting that all results of a comparison share. */
export interface Setting {
    trials: Trial[];
    parts: PartSpec[];
    framesPerSecond: number;
    /** Number of frames of the held-out trial that a prediction starts from. */
    startFrames: number;
}

/** The plan of a comparison: the trainings to run. */
export interface Plan {
    /** The models to train. A body with one part has no coupled models. */
    models: ModelKind[];
    latent: number;
    order: number;
    maxIterations: number;
    /**
     * Numbers of inducing points of each dynamics map of the variational models. Without `poseIps`, each pose
     * map has the same number.
     */
    ips: number[];
    /** Numbers of inducing points of each pose map. Each number is combined with each number in `ips`. */
    poseIps?: number[];
    /** Numbers of primitives of the TMP; null: the bound chooses the number. */
    primitives: (number | null)[];
    /**
     * Whether the TMP is the model of the papers: it uses normalised time, and all trials share its weights.
     */
    normalisedTime?: boolean;
    /** Numbers of basis functions of the DMPs. */
    bases: number[];
    /** Whether the dynamics of the MAP models are balanced. */
    balanced: boolean;
    /** The factor of the pose terms in the objective of the variational models; absent: 1. */
    poseWeight?: number | "balanced";
    /** Whether the couplings between the parts of the vCGPDM are off; absent: no. */
    uncoupled?: boolean;
    /** Whether the kernels of the MAP models have a linear term. */
    linear?: boolean;
    /** The held-out trials, counted from 0; empty: each trial in turn. */
    heldOut: number[];
    /** The seeds of the models with random starts. The other models get the seed 0. */
    seeds: number[];
    /** Numbers of other trials in the training set; empty: all other trials. */
    trainingTrials: number[];
    /**
     * Whether the plan also trains the coupled models on 1, 2, ... trials. These trainings use the first
     * fold, the first seed and the middle number of inducing points.
     */
    growth: boolean;
}

/** A job of a plan. */
export interface PlannedJob {
    /** A readable id that no other job has. */
    id: string;
    job: Job;
    /** Whether the results contain an outcome of the job. */
    done: boolean;
}

/** A finished job, with its outcome or the reason why it failed. */
export interface FinishedJob {
    /** A readable id that no other job has. */
    id: string;
    /** In files of the terminal program, the candidate can also be a `Rival`. */
    job: Job;
    /** The program that computed the outcome, and its version. */
    engine: string;
    outcome: Outcome | null;
    failure: string | null;
}

/** A mean over folds. The seeds of a fold are averaged first. */
export interface Spread {
    mean: number;
    /** Null for a single fold. */
    standardError: number | null;
    /** Number of folds. */
    count: number;
}

/** One candidate: a row of figure 4 of Velychko et al. (2018). */
export interface ModelSummary {
    model: ModelKind | "promp" | "ar";
    candidate: Candidate | Rival;
    /** The settings that differ from those of other candidates, as a short text. */
    label: string;
    /** Mean squared error after dynamic time warping. */
    mse: Spread;
    /** The median error over the folds. A single bad rollout hardly changes it. */
    mseMedian: number;
    /** The same error on the training trials; null if the results do not contain it. */
    trainingMse: Spread | null;
    /** The error of a constant prediction. */
    variance: number;
    /** The bound on the log evidence, in nats; null for a model without a bound. */
    bound: Spread | null;
    /** Seconds of a training. */
    seconds: Spread;
    /** How many numbers a rollout needs from the model. */
    storedNumbers: Spread;
    /** The share of trainings that ended because they converged; null if unknown. */
    converged: number | null;
    /** Means of the terms of the bound, in nats; null if the results do not contain them. */
    terms: { pose: number; dynamics: number } | null;
    /** The mean error of each part; empty if the results do not contain it. */
    partErrors: number[];
    /** More about the predictions; null if the results do not contain it, as those computed here. */
    details: PredictionDetails | null;
    /** Number of held-out trials. */
    folds: number;
    /** Number of trainings. */
    runs: number;
    /**
     * Candidates that differ only in size form a group. For each held-out trial, the claims choose one
     * candidate of the group. For the candidate that they choose most often, this is the number of candidates
     * in its group; for the others it is 0.
     */
    standsFor: number;
}

/** Means over folds: more about predictions than their error. */
export interface PredictionDetails {
    /** Mean squared error of each part over the first half second, frame by frame. */
    firstHalfSecond: number[];
    /** The error of each part after time warping along a path of its own. */
    ownPath: number[];
    /** Speed of the prediction divided by that of the trial. */
    speed: number;
    /** Horizontal speed of the standing foot, in walking speeds; null if the body hardly walks. */
    footSlide: { predicted: number; recorded: number } | null;
    /** The share of rollouts that stand still after 20 seconds. */
    stillAt20S: number;
    /** Shares of recorded numbers in the predicted bands, and their mean log density; null without variances. */
    bands: { within50: number; within95: number; logDensity: number } | null;
    folds: number;
}

/** One candidate in figure 1 of the supplement of Velychko et al. (2017). */
export interface BoundAndError {
    label: string;
    /** The mean bound, in nats. */
    bound: number;
    /** The mean error. */
    mse: number;
}

/** Bounds and errors of one kind of model in several sizes. All other settings are the same. */
export interface Correlation {
    model: ModelKind;
    /** The settings that the candidates share; empty if the kind of model has only one group. */
    label: string;
    /** Number of candidates. */
    settings: number;
    /** Number of held-out trials for which all candidates have results. */
    folds: number;
    /** Spearman's rank correlation within each trial; the mean over the trials. */
    rank: number;
    /** Its 95 % interval by a bootstrap over the trials; null for a single trial. */
    interval: Interval | null;
    points: BoundAndError[];
}

/** Mean number of training frames, and mean seconds of an iteration. */
export interface FramesAndTime {
    frames: number;
    seconds: number;
    /** Mean seconds of a whole training. */
    trainingSeconds: number;
}

/** Training time of one candidate against the number of training frames. */
export interface Growth {
    model: ModelKind;
    label: string;
    /** Sorted by the number of frames, the lowest first. */
    points: FramesAndTime[];
    /**
     * The exponent k if the time of an iteration grows as frames to the power k; null if it cannot be
     * estimated.
     */
    exponent: number | null;
    /** The 95 % interval of the exponent; null if it cannot be estimated. */
    interval: Interval | null;
    /** The same exponent for a whole training; null if it cannot be estimated. */
    trainingExponent: number | null;
    /** The 95 % interval of `trainingExponent`. */
    trainingInterval: Interval | null;
    /** The share of these trainings that ended because they converged; null if unknown. */
    converged: number | null;
}

/** An interval for a number, and the probability that such an interval covers the number. */
export interface Interval {
    low: number;
    high: number;
    level: number;
}

/** Compares the bounds and errors of the models with one part and with several parts in one fold. */
export interface Evidence {
    /** The held-out trial. */
    trial: string;
    /** The bound of the vCGPDM minus the bound of the vGPDM, in nats. */
    logBayesFactor: number;
    /** The error of the vCGPDM divided by the error of the vGPDM. */
    errorRatio: number;
}

/** A claim of the papers, and whether these results agree with it. */
export interface Claim {
    /** The sentence of the paper, or a related question of ours. */
    claim: string;
    /** Where the claim is in the papers: year and section. */
    place: string;
    /** Our criterion for the claim. */
    criterion: string;
    /** The measured effect, with its interval. */
    found: string;
    /**
     * Whether the results agree with the claim. It is "undecided" unless the whole interval is on one side.
     */
    answer: "yes" | "no" | "undecided";
    /** Whether it is one of the claims that were named beforehand. Their answers are corrected for their number. */
    primary: boolean;
}

/** Tables and claims computed from the results of a comparison. */
export interface Comparison {
    /** Names of the parts in `partErrors` of the models. */
    parts: string[];
    /** Every candidate that was trained on all other trials. */
    models: ModelSummary[];
    /**
     * One entry for each kind of model with a bound and at least three candidates that differ only in size.
     */
    correlations: Correlation[];
    /** One entry for each kind of model that was trained on at least three different numbers of trials. */
    growth: Growth[];
    /** One entry for each fold with results of both variational models. */
    evidence: Evidence[];
    /** The claims that these results can test. */
    claims: Claim[];
}
"#;

/// A job with its id.
#[derive(Serialize)]
struct IdentifiedJob<'a> {
    id: String,
    job: &'a Job,
}

/// A value that belongs to a job, with the job and its id. They replace the job of a file, whose trial is
/// counted from 1.
fn identified<T: Serialize>(job: &Job, value: &T) -> Result<JsValue, VcgpdmError> {
    to_js_joined(value, &IdentifiedJob { id: job.to_string(), job })
}

/// A job from JavaScript, with one of these trials held out.
fn checked_job(job: &JsValue, trials: usize) -> Result<Job, VcgpdmError> {
    let job = job_from_js(job, trials)?;
    check_held_out(job.held_out, trials)?;
    Ok(job)
}

/// All results of a comparison so far.
#[wasm_bindgen]
pub struct Results {
    results: AllResults,
}

#[wasm_bindgen]
impl Results {
    /// Results without a finished job. Each clip of the set is a trial.
    pub fn empty(
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_optional_param_type = "ComparisonSettings")] settings: JsValue,
    ) -> Result<Results, VcgpdmError> {
        let ComparisonSettings { parts, frames_per_second } = ComparisonSettings::read(&settings, clips)?;
        let setting = Setting::new(&clips.clips, &parts, frames_per_second, START_FRAMES)?;
        Ok(Results { results: AllResults::new(setting) })
    }

    /// Reads a file of results that the page or the terminal program wrote.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Results, VcgpdmError> {
        let text = text.get(ErrorCode::Results, "the document")?;
        let results: AllResults =
            from_json(ErrorCode::Results, "expected the results of an evaluation", &text)?;
        results.check()?;
        Ok(Results { results })
    }

    /// The results as a file. Its fields have the names of the terminal program, in snake_case.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        to_json(&self.results)
    }

    /// The trials, the parts and the rate of the comparison.
    #[wasm_bindgen(unchecked_return_type = "Setting")]
    pub fn setting(&self) -> Result<JsValue, VcgpdmError> {
        let setting = to_js(self.results.setting())?;
        // A file omits `piece` if the trial is a whole clip.
        let trials = Reflect::get(&setting, &"trials".into()).unwrap_or_default();
        for trial in Array::from(&trials).iter() {
            if !Reflect::has(&trial, &"piece".into()).unwrap_or(true) {
                let _ = Reflect::set(&trial, &"piece".into(), &JsValue::NULL);
            }
        }
        Ok(setting)
    }

    /// The finished jobs, in the order of the tables: by model, then by size, then by seed.
    #[wasm_bindgen(unchecked_return_type = "FinishedJob[]")]
    pub fn finished(&self) -> Result<Array, VcgpdmError> {
        self.results.in_order().into_iter().map(|finished| identified(&finished.job, finished)).collect()
    }

    /// The jobs of the plan, sorted by fold, so that the first tables appear early. By default the plan has
    /// each kind of model once, with the defaults of its settings, in each fold.
    #[wasm_bindgen(unchecked_return_type = "PlannedJob[]")]
    pub fn jobs(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "Partial<Plan>")] plan: JsValue,
    ) -> Result<Array, VcgpdmError> {
        let plan = with_defaults(ErrorCode::Comparison, "plan", &plan, Object::new().into())?;
        let plan: Plan = from_js(ErrorCode::Comparison, "plan", &plan)?;
        for held_out in &plan.held_out {
            check_held_out(*held_out, self.results.setting().trials.len())?;
        }
        let one_part = self.results.setting().parts.len() < 2;
        let jobs = self.results.jobs(&if one_part { plan.without_coupled() } else { plan })?;
        jobs.iter().map(|planned| identified(&planned.job, planned)).collect()
    }

    /// An estimate of the cost of a job with these trials in wasm. It is zero for TMP and DMP, which cost
    /// little compared with the other models.
    #[wasm_bindgen(js_name = costOf, unchecked_return_type = "TrainingCost")]
    pub fn cost_of(
        &self,
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_param_type = "JobOptions")] job: JsValue,
    ) -> Result<JsValue, VcgpdmError> {
        let job = checked_job(&job, clips.clips.len())?;
        let Setting { parts, frames_per_second, .. } = self.results.setting();
        cost_to_js(
            job.candidate.settings().map(Settings::kind),
            job.cost(&clips.clips, parts, *frames_per_second),
        )
    }

    /// Adds the outcome of a job that this program trained. An earlier outcome of the job is not replaced.
    pub fn add(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "JobOptions")] job: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Outcome")] outcome: JsValue,
    ) -> Result<(), VcgpdmError> {
        let job = checked_job(&job, self.results.setting().trials.len())?;
        let outcome = from_js(ErrorCode::Comparison, "outcome", &outcome)?;
        Ok(self.results.add(Finished::new(job, Ok(outcome)))?)
    }

    /// Adds the outcomes of other results that are missing here. Throws if the settings differ.
    pub fn merge(&mut self, other: &Results) -> Result<(), VcgpdmError> {
        Ok(self.results.merge(other.results.clone())?)
    }

    /// Tables, correlations, exponents and claims computed from the results.
    #[wasm_bindgen(unchecked_return_type = "Comparison")]
    pub fn comparison(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&Comparison::new(&self.results))
    }
}
