//! How far a training is, for JavaScript.

use crate::convert::to_js;
use crate::error::VcgpdmError;
use serde::Serialize;
use vcgpdm::models::variational::BoundTerms;
use vcgpdm::models::{EndReason, Progress, Setbacks, TrainingPhase};
use wasm_bindgen::prelude::*;

#[derive(Serialize)]
struct TrainingProgress<'a> {
    iteration: usize,
    max_iterations: usize,
    evaluations: usize,
    setbacks: Setbacks,
    bound: f64,
    best: f64,
    terms: Option<&'a BoundTerms>,
    phase: Option<TrainingPhase>,
    done: bool,
    reason: Option<&'static str>,
    fraction: f64,
}

/// The progress of the training of a vCGPDM, a vGPDM or a library.
pub fn progress_to_js(progress: &Progress) -> Result<JsValue, VcgpdmError> {
    to_js(&TrainingProgress {
        iteration: progress.iteration,
        max_iterations: progress.max_iterations,
        evaluations: progress.evaluations,
        setbacks: progress.setbacks,
        bound: progress.objective,
        best: progress.best,
        terms: progress.terms.as_ref(),
        phase: progress.phase,
        done: progress.done,
        reason: progress.reason.as_ref().map(|reason| match reason {
            EndReason::Iterations => "iterations",
            _ => "settled",
        }),
        fraction: progress.fraction,
    })
}
