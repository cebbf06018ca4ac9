//! The summary of a rollout of a body: how it ends, the measures of its motion, and its predicted naturalness.

use crate::files;
use crate::health::warning;
use crate::progress::say;
use serde_json::{Value, json};
use std::error::Error;
use std::path::Path;
use vcgpdm::models::{Coupled, Rollout, RolloutError, RolloutRequest};
use vcgpdm::motion::measures::measures;

/// Prints the summary as JSON, and a warning if the motion does not move on.
pub fn print(
    model: Coupled,
    request: &RolloutRequest,
    rollout: &Rollout,
    out: Option<&Path>,
) -> Result<(), Box<dyn Error>> {
    let positions = model.positions(rollout)?;
    let health = model.health(rollout, request, &positions)?;
    let measures = measures(model.body.mapping.skeleton(), &positions, model.body.frame_time);
    let names: Vec<&str> = model.body.layout.parts().iter().map(|part| part.name.as_str()).collect();
    if let Some(words) = warning(&health, &names) {
        say(&format!("warning: the motion {words}"));
    }
    let value = json!({
        "parts": names,
        "health": health,
        "measures": measures,
        "predicted_naturalness": predicted_naturalness(model, rollout)?,
    });
    files::print_summary(&value, &out.into_iter().collect::<Vec<_>>())
}

/// The mean log density of the latents of a frame under the learned dynamics, in the rollout and in the
/// training. Files of earlier versions have no latents of the training.
fn predicted_naturalness(model: Coupled, rollout: &Rollout) -> Result<Value, RolloutError> {
    let learned = model.predictive_dynamics(&RolloutRequest::default())?;
    let of_rollout = learned.mean_log_density(std::slice::from_ref(&rollout.latents))?;
    let of_training = learned.mean_log_density(&model.model.starts)?;
    Ok(json!({
        "rollout": of_rollout,
        "training": of_training,
        "difference": of_rollout.zip(of_training).map(|(rollout, training)| rollout - training),
        "unit": "nats a frame",
    }))
}
