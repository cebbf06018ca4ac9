//! Whether the motion of a trained model moves on, and what may help where it does not.

use vcgpdm_core::models::{Ending, Health, Model, RolloutRequest, VariationalSettings};

/// Seconds of the motion that a trained model is judged by, as on the page.
const SECONDS: f64 = 10.0;
/// The most frames of this motion: clips can have thousands of frames a second.
const MOST_FRAMES: f64 = 3000.0;

/// How the motion of a trained model ends; `None` for a kind without couplings, and for a motion that cannot
/// be made.
pub fn health_of(model: &Model) -> Option<Health> {
    let coupled = model.coupled()?;
    let frames = (SECONDS / model.body.frame_time).round().clamp(1.0, MOST_FRAMES) as usize;
    let request = RolloutRequest { frames, ..Default::default() };
    let rollout = coupled.rollout(&request).ok()?;
    let positions = coupled.positions(&rollout).ok()?;
    coupled.health(&rollout, &request, &positions).ok()
}

/// What may help where the motion of a model does not move on. `usual` are the settings for clips of this
/// length.
pub fn advice(settings: &VariationalSettings, usual: &VariationalSettings) -> String {
    let (dynamics, poses) = (usual.dynamics_ips, usual.pose_ips);
    if settings.dynamics_ips >= dynamics && settings.pose_ips >= poses {
        return "another --seed may help".to_owned();
    }
    format!("another --seed may help, or more inducing points (--dynamics-ips {dynamics} --pose-ips {poses})")
}

/// What a viewer sees of a motion that does not move on: the end of a sentence.
pub fn warning(health: &Health, names: &[&str]) -> Option<String> {
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
        Ending::Shakes => {
            let part = health.part.and_then(|part| health.parts.get(part).map(|part| part.pace));
            let pace = part.or(health.pace).unwrap_or_default();
            let times = pace
                .times
                .map_or(String::new(), |times| format!("{times:.1} times as fast as in its clips, and "));
            let place = part.map_or("the body", |_| name);
            Some(format!(
                "shakes: {place} moves {times}{:.0} % of its steps turn back",
                100.0 * pace.turns_back
            ))
        }
        Ending::NotFinite => Some("runs away: its numbers are too large".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm_core::models::{Pace, PartPoses};

    #[test]
    fn advises_more_points_where_there_are_fewer_than_usual() {
        let short = VariationalSettings::for_clips(2.0);
        let long = VariationalSettings::for_clips(20.0);
        assert_eq!(advice(&short, &short), "another --seed may help");
        assert_eq!(advice(&long, &short), "another --seed may help");
        assert!(advice(&short, &long).ends_with("points (--dynamics-ips 30 --pose-ips 30)"));
    }

    #[test]
    fn warns_of_a_motion_that_does_not_move_on() {
        let health = |state, from, part| {
            let pace = Pace {
                speed: 3.65,
                clip_speed: Some(0.5),
                times: Some(7.3),
                turns_back: 0.958,
                clip_turns_back: Some(0.0),
            };
            let parts = vec![PartPoses { visited: Some(0.221), still_from: None, pace }];
            warning(&Health { state, from, part, rank: 1, pace: Some(pace), parts }, &["legs"])
        };
        assert_eq!(health(Ending::MovesOn, None, None), None);
        assert_eq!(health(Ending::RestsAsRecorded, Some(3.0), None), None);
        let words = |state| health(state, Some(0.71), Some(0)).unwrap();
        assert_eq!(words(Ending::KeepsOnePose), "keeps one pose from 0.7 s on");
        let shakes = "shakes: legs moves 7.3 times as fast as in its clips, and 96 % of its steps turn back";
        assert_eq!(words(Ending::Shakes), shakes);
        assert_eq!(words(Ending::VisitsFewPoses), "visits 22 % of its clips' poses in legs");
        assert_eq!(words(Ending::LeavesTrainingRange), "leaves the training range in legs from 0.7 s on");
    }
}
