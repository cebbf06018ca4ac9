//! Results of a comparison: the planned jobs, the finished jobs, and tables of the results.

use crate::data::clip::TrainingSet;
use crate::lab::evaluation::job_from_js;
use crate::lab::evaluation::{ComparisonSettings, check_held_out};
use crate::models::settings::cost_to_js;
use crate::values::arguments::Text;
use crate::values::convert::{from_js, from_json, to_js, to_js_joined, to_json, with_defaults};
use crate::values::error::{ErrorCode, VcgpdmError};
use js_sys::{Array, Object, Reflect};
use serde::Serialize;
use vcgpdm_core::models::Settings;
use vcgpdm_lab::evaluation::{Comparison, Finished, Job, Plan, Results as AllResults, START_FRAMES, Setting};
use wasm_bindgen::prelude::*;

/// A job with its id.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct IdentifiedJob<'a> {
    /// A readable id that no other job has.
    id: String,
    /// In files of the terminal program, the candidate can also be a `Rival`.
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
