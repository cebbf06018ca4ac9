//! The summary of a rollout of a body: how it ends, the measures of its motion, and how likely its latents are.

use crate::files;
use crate::health::warning;
use crate::task::say;
use serde_json::json;
use std::error::Error;
use std::path::Path;
use vcgpdm_core::models::{Coupled, LatentLogDensity, Rollout, RolloutRequest};
use vcgpdm_core::motion::measures::measures;

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
    let LatentLogDensity { rollout, training, difference } = model.latent_log_density(rollout)?;
    let value = json!({
        "parts": names,
        "health": health,
        "measures": measures,
        "dynamics_elbo": model.model.terms.dynamics_elbo(),
        "latent_log_density": {
            "rollout": rollout,
            "training": training,
            "difference": difference,
            "unit": "nats a frame",
        },
    });
    files::print_summary(&value, &out.into_iter().collect::<Vec<_>>())
}
