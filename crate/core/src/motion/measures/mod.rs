//! Measures of a motion: how far hands and feet swing, whether they swing in step, how fast the body walks,
//! whether it stands still. All are computed from the positions of its nodes, so they apply to recorded clips
//! and rollouts alike.

mod limbs;
pub(crate) mod poses;
mod rhythm;
mod speed;

use crate::motion::Skeleton;
use crate::motion::anatomy::Anatomy;
use crate::motion::{RHYTHMIC, period};
use limbs::{ends, forward_places};
use nalgebra::DMatrix;
use serde::Serialize;
use speed::Track;

pub use limbs::Limb;
pub use speed::rests_from;

/// A smaller swing, in metres, is noise and has no phase.
const LEAST_SWING: f64 = 0.01;

/// A motion must contain a period this many times.
const LEAST_PERIODS: f64 = 3.0;

/// Measures of a whole body over some frames.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Measures {
    /// The hands and feet that the body has: left hand, right hand, left foot, right foot.
    pub limbs: Vec<LimbMeasures>,
    /// Mean speed of all nodes relative to the root, in metres a second.
    pub joint_speed: f64,
    /// Speed of the root over the ground, over whole seconds, in metres a second.
    pub walking_speed: f64,
    /// Horizontal speed of the lowest node of the legs divided by the walking speed; 0 for standing feet that
    /// do not slide. `None` if the body hardly walks or has no legs.
    pub foot_slide: Option<f64>,
}

/// Measures of one hand or foot.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct LimbMeasures {
    /// Which limb it is.
    #[cfg_attr(feature = "types", ts(inline))]
    pub limb: Limb,
    /// The index of the joint at the end of the limb.
    pub joint: usize,
    /// Standard deviation of the limb's end along the heading, relative to the root, in metres for a body 1.7
    /// m tall.
    pub swing: f64,
    /// Seconds from one swing to the next; `None` if it does not swing, or not the same way at least three
    /// times.
    pub period: Option<f64>,
    /// Phase relative to the foot or hand of the *other* side, in cycles from -0.5 to 0.5; 0 when both are in
    /// front at the same time, as in walking. `None` exactly if `locking` is.
    pub ahead: Option<f64>,
    /// Constancy of that phase difference, |mean of exp(i difference)|: 1 if both swing in step, near 0 if
    /// they swing at different rates. `None` if one of the two does not swing, or the foot is not periodic.
    pub locking: Option<f64>,
}

/// Measures of a part: the means over its hands and feet.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PartMeasures {
    /// Mean of [`LimbMeasures::swing`], in metres; `None` if the part has no hand or foot.
    pub swing: Option<f64>,
    /// Mean of the existing [`LimbMeasures::period`]s, in seconds.
    pub period: Option<f64>,
    /// Mean of the existing [`LimbMeasures::locking`]s.
    pub locking: Option<f64>,
}

impl Measures {
    /// The measures of the part of the body with these joints.
    pub fn part(&self, joints: &[usize]) -> PartMeasures {
        let limbs = || self.limbs.iter().filter(|limb| joints.contains(&limb.joint));
        PartMeasures {
            swing: mean(limbs().map(|limb| limb.swing)),
            period: mean(limbs().filter_map(|limb| limb.period)),
            locking: mean(limbs().filter_map(|limb| limb.locking)),
        }
    }
}

fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values.fold((0.0, 0), |(sum, count), value| (sum + value, count + 1));
    (count > 0).then(|| sum / f64::from(count))
}

/// Measures a motion from the `positions` [frames x nodes x 3] of the figure's nodes: y up, in metres for a
/// body 1.7 m tall, as [`Clip::stage_positions`](crate::motion::Clip::stage_positions) returns them;
/// `frame_time` in seconds.
///
/// The phases of a hand and a foot come from complex demodulation at the period of the foot, in windows of
/// one period.
///
/// ```
/// use vcgpdm_core::motion::measures::measures;
/// use vcgpdm_core::motion::samples;
///
/// let clip = samples::clip("walk-1").ok_or("no such sample")?;
/// let walk = measures(&clip.skeleton, &clip.stage_positions(), clip.frame_time);
/// let hand = &walk.limbs[0];
/// assert!(hand.swing > 0.05 && hand.locking.is_some_and(|locking| locking > 0.95));
/// # Ok::<(), &str>(())
/// ```
pub fn measures(skeleton: &Skeleton, positions: &[f32], frame_time: f64) -> Measures {
    let track = Track::new(skeleton, positions, frame_time);
    let walking_speed = speed::walking(&track);
    let mut measures = Measures {
        limbs: Vec::new(),
        joint_speed: speed::joint_speed(&track),
        walking_speed,
        foot_slide: None,
    };
    if let Some(anatomy) = Anatomy::find(skeleton) {
        measures.limbs = limb_measures(skeleton, &anatomy, &track);
        measures.foot_slide = speed::foot_slide(skeleton, &anatomy, &track, walking_speed);
    }
    measures
}

fn limb_measures(skeleton: &Skeleton, anatomy: &Anatomy, track: &Track) -> Vec<LimbMeasures> {
    let ends = ends(skeleton, anatomy);
    let places = forward_places(skeleton, anatomy, &ends, track);
    let mut limbs = Vec::new();
    let mut periods = Vec::new();
    for (end, places) in ends.iter().zip(&places) {
        let place = DMatrix::from_column_slice(places.len(), 1, places);
        let swing = place.variance().sqrt();
        let frames = places.len() as f64;
        let repeats = if swing < LEAST_SWING { None } else { period(&[place]) };
        let steady =
            repeats.filter(|found| found.correlation >= RHYTHMIC && LEAST_PERIODS * found.frames <= frames);
        let repeats = steady.map(|period| period.frames);
        let seconds = repeats.map(|frames| frames * track.frame_time);
        let (limb, joint) = (end.limb, end.joint);
        limbs.push(LimbMeasures { limb, joint, swing, period: seconds, ahead: None, locking: None });
        periods.push(repeats);
    }
    for k in 0..ends.len() {
        // In walking, a hand swings with the foot of the other side.
        let Some(other) = ends.iter().position(|end| end.limb == ends[k].limb.other()) else { continue };
        let foot = if ends[k].limb.is_hand() { other } else { k };
        let swinging = limbs[k].swing.min(limbs[other].swing) >= LEAST_SWING;
        let step = periods[foot].filter(|_| swinging);
        if let Some(step) = step.and_then(|period| rhythm::step(&places[k], &places[other], period)) {
            limbs[k].ahead = Some(step.ahead);
            limbs[k].locking = Some(step.locking);
        }
    }
    limbs
}

#[cfg(test)]
mod tests;
