//! The summary of a rollout of a body: how it ends, the measures of its motion, and its predicted naturalness.

use crate::files;
use crate::progress::say;
use serde_json::{Value, json};
use std::error::Error;
use std::path::Path;
use vcgpdm::models::{Coupled, Ending, Health, Rollout, RolloutError, RolloutRequest};
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

/// What a viewer sees of a motion that does not move on: the end of a sentence.
fn warning(health: &Health, names: &[&str]) -> Option<String> {
    let since = format!("from {:.1} s on", health.from.unwrap_or(0.0));
    let name = health.part.and_then(|part| names.get(part)).unwrap_or(&"a part");
    match health.state {
        Ending::MovesOn | Ending::RestsAsRecorded => None,
        Ending::StandsStill => Some(format!("stands still {since}")),
        Ending::KeepsOnePose => Some(format!("keeps one pose {since}")),
        Ending::VisitsFewPoses => {
            let share = health.part.and_then(|part| health.parts[part].visited).unwrap_or(0.0);
            Some(format!("visits {:.0} % of its clips' poses in {name}", 100.0 * share))
        }
        Ending::LeavesTrainingRange => Some(format!("leaves the training range in {name} {since}")),
        Ending::NotFinite => Some("runs away: its numbers are too large".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm::models::PartPoses;

    #[test]
    fn warns_of_a_motion_that_does_not_move_on() {
        let health = |state, from, part| {
            let parts = vec![PartPoses { visited: Some(0.221), still_from: None }];
            warning(&Health { state, from, part, rank: 1, parts }, &["legs"])
        };
        assert_eq!(health(Ending::MovesOn, None, None), None);
        assert_eq!(health(Ending::RestsAsRecorded, Some(3.0), None), None);
        let words = |state| health(state, Some(0.71), Some(0)).unwrap();
        assert_eq!(words(Ending::KeepsOnePose), "keeps one pose from 0.7 s on");
        assert_eq!(words(Ending::VisitsFewPoses), "visits 22 % of its clips' poses in legs");
        assert_eq!(words(Ending::LeavesTrainingRange), "leaves the training range in legs from 0.7 s on");
    }
}
