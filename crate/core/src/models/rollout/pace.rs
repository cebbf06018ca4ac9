//! The pace of a motion: how fast and how smoothly a body and its parts move, beside their clips.

use crate::motion::measures::poses::Poses;
use serde::Serialize;

/// A motion shakes when it is more than this many times as fast as its clips, ...
const FAST: f64 = 2.0;
/// ... or when the share of its steps that turn back is larger than that of its clips by more than this. A hand that
/// waves 4 times a second, at 30 frames a second, turns back in a quarter of its steps.
const TURNS: f64 = 0.3;
/// Models that move on are up to this many times as fast as their clips, ...
const USUAL_SPEED: f64 = 1.75;
/// ... and turn back in at most this much more of their steps.
const USUAL_TURNS: f64 = 0.1;
/// A viewer does not see slower shaking, in metres a second; clips count as at least this fast.
const SEEN_SPEED: f64 = 0.05;

/// How fast a body or a part moves, relative to the root and without its turns, and how smoothly: in that half of
/// the rollout in which it is faster.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Pace {
    /// Mean speed of its nodes (root mean square), in metres a second for a body 1.7 m tall.
    pub speed: f64,
    /// The speed in the clips as the pose maps make them. `None`: the model has not kept the latents of its clips'
    /// frames.
    pub clip_speed: Option<f64>,
    /// How many times as fast as the clips it is. Clips count as 0.05 m/s at least, which a viewer hardly sees.
    pub times: Option<f64>,
    /// The share of its steps from frame to frame that go back, opposite to the step before; 0 to 1.
    pub turns_back: f64,
    /// That share in the clips.
    pub clip_turns_back: Option<f64>,
}

impl Pace {
    /// Whether it is no faster and no less smooth than before, but for paces that are usual in models that move on:
    /// 1.75 times as fast as the clips, and 10 per cent more steps that turn back.
    pub(in crate::models) fn is_no_worse_than(&self, before: &Pace) -> bool {
        let times = self.times.unwrap_or(0.0) <= before.times.unwrap_or(0.0).max(USUAL_SPEED);
        let usual_turns = self.clip_turns_back.unwrap_or(0.0) + USUAL_TURNS;
        times && self.turns_back <= before.turns_back.max(usual_turns)
    }

    /// Whether this is shaking, by thresholds of this library: twice the speed of the clips, or 30 per cent more of
    /// the steps turn back, and a viewer sees it (0.05 m/s).
    pub fn shakes(&self) -> bool {
        let turns = self.turns_back - self.clip_turns_back.unwrap_or(0.0) > TURNS;
        self.times.is_some_and(|times| times > FAST) || (turns && self.speed > SEEN_SPEED)
    }

    /// The pace of these poses beside that of the clips, in whose frames `begins` a sequence begins.
    pub(in crate::models) fn of(poses: &Poses, clips: &Poses, begins: &[usize], frame_time: f64) -> Pace {
        let middle = poses.frames() / 2;
        let halves = [0..middle, middle..poses.frames()].map(|half| poses.steps(half, &[]));
        let [first, second] = halves;
        let faster = if first.mean > second.mean { first } else { second };
        let clip = (!begins.is_empty()).then(|| clips.steps(0..clips.frames(), begins));
        let speed = faster.mean / frame_time;
        let clip_speed = clip.map(|clip| clip.mean / frame_time);
        Pace {
            speed,
            clip_speed,
            times: clip_speed.map(|clip| speed / clip.max(SEEN_SPEED)),
            turns_back: faster.turned_back,
            clip_turns_back: clip.map(|clip| clip.turned_back),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_whose_clips_turn_back_nearly_as_often_does_not_shake() {
        let pace = Pace { speed: 1.0, turns_back: 0.6, clip_turns_back: Some(0.4), ..Pace::default() };
        assert!(!pace.shakes() && Pace { clip_turns_back: None, ..pace }.shakes());
        assert!(!Pace { speed: 0.04, clip_turns_back: None, ..pace }.shakes(), "a viewer does not see it");
    }

    #[test]
    fn a_fast_motion_is_no_worse_than_itself() {
        let fast = Pace { times: Some(3.0), turns_back: 0.5, ..Pace::default() };
        assert!(fast.is_no_worse_than(&fast));
        assert!(!Pace { times: Some(3.1), ..fast }.is_no_worse_than(&fast));
        assert!(!Pace { turns_back: 0.6, ..fast }.is_no_worse_than(&fast));
    }

    #[test]
    fn a_motion_at_the_limits_does_not_shake() {
        let pace = Pace { speed: 1.0, times: Some(FAST), turns_back: TURNS, ..Pace::default() };
        assert!(!pace.shakes());
        assert!(Pace { turns_back: 0.31, ..pace }.shakes() && Pace { times: Some(2.1), ..pace }.shakes());
    }
}
