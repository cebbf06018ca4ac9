//! The summary of a rollout of a body: how it ends, and the measures of its motion.

use crate::files;
use crate::progress::say;
use serde_json::json;
use std::error::Error;
use std::path::Path;
use vcgpdm::models::{Coupled, Ending, Health, Rollout, RolloutRequest};
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
    let value = json!({ "parts": names, "health": health, "measures": measures });
    files::print_summary(&value, &out.into_iter().collect::<Vec<_>>())
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
