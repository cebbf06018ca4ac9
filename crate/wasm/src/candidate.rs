//! Candidates of a comparison, and their jobs, with defaults for what a caller leaves out.

use crate::convert::{from_js, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::settings::with_defaults;
use js_sys::{Object, Reflect};
use serde::Serialize;
use vcgpdm::models::{ModelKind, Settings};
use vcgpdm_lab::evaluation::{CandidateKind, Job};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A candidate that a caller gives: absent fields are the defaults of its model. */
export type CandidateOptions = Partial<Candidate>;

/** A job that a caller gives. Each field has a default. */
export interface JobOptions {
    /** Absent: a vCGPDM. */
    candidate?: CandidateOptions;
    /** The held-out trial, counted from 0; absent: the first. */
    heldOut?: number;
    /** The number of other trials in the training set; absent: all. */
    trainingTrials?: number;
    /** Absent: 0. */
    seed?: number;
}
"#;

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
