//! What a body does, measured: how far hands and feet swing, whether they swing in step, how fast the body
//! walks, whether it stands still. All from the places of its nodes over time, so that recorded clips and
//! rollouts are measured alike.

mod limbs;
mod rhythm;
mod speed;
mod track;

use crate::motion::Skeleton;
use crate::motion::anatomy::Anatomy;
use crate::motion::period;
use limbs::{ends, forward_places};
use nalgebra::DMatrix;
use serde::Serialize;
use track::Track;

pub use limbs::Limb;
pub use speed::{rests_from, still_from};

/// A limb that swings less than this, in metres, has no phase: what is left is noise.
const LEAST_SWING: f64 = 0.01;

/// What a body does in a stretch of frames.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measures {
    /// The hands and feet that the body has: left hand, right hand, left foot, right foot.
    pub limbs: Vec<LimbMeasures>,
    /// Mean speed of all nodes relative to the root, in metres a second.
    pub joint_speed: f64,
    /// Speed of the root over the ground, over whole seconds, in metres a second.
    pub walking_speed: f64,
    /// Horizontal speed of the lowest node of the legs, as a share of the walking speed. A foot that stands
    /// does not slide: 0. Absent where the body hardly walks or has no legs.
    pub foot_slide: Option<f64>,
}

/// What one hand or foot does.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LimbMeasures {
    /// Which limb it is.
    pub limb: Limb,
    /// The joint at the end of the limb, by its place in the skeleton.
    pub joint: usize,
    /// Standard deviation of the limb's end along the heading, relative to the root, in metres for a body 1.7
    /// m tall.
    pub swing: f64,
    /// Seconds from one swing to the next; absent where it does not swing, or does not repeat itself.
    pub period: Option<f64>,
    /// How far its swing is ahead of that of the foot or hand of the *other* side, in cycles from -0.5 to
    /// 0.5: 0 when both are in front at the same time, as in walking. Absent where `locking` is.
    pub ahead: Option<f64>,
    /// How constant that phase difference is, 0 to 1: |mean of exp(i difference)| over the stretch. 1: in
    /// step; near 0: each at its own pace. Absent where one of the two does not swing, or the foot does not
    /// repeat itself.
    pub locking: Option<f64>,
}

/// What a part of the body does: the mean over the hands and feet that belong to it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartMeasures {
    /// Mean of [`LimbMeasures::swing`], in metres; absent where no hand or foot belongs to the part.
    pub swing: Option<f64>,
    /// Mean of [`LimbMeasures::period`] where it is there, in seconds.
    pub period: Option<f64>,
    /// Mean of [`LimbMeasures::locking`] where it is there.
    pub locking: Option<f64>,
}

impl Measures {
    /// The measures of the part of the body with these joints.
    pub fn of_joints(&self, joints: &[usize]) -> PartMeasures {
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

/// Measures a stretch of frames: `positions` [frames x nodes x 3] of the figure's nodes, y up, in metres for
/// a body 1.7 m tall, as [`Clip::stage_positions`](crate::motion::Clip::stage_positions) gives them;
/// `frame_time` in seconds.
///
/// The phases of a hand and a foot are those of complex demodulations at the period of the foot, in windows
/// of one such period.
///
/// ```
/// use vcgpdm::motion::measures::measures;
/// use vcgpdm::motion::samples;
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
        joint_speed: speed::of_joints(&track),
        walking_speed,
        foot_slide: None,
    };
    if let Some(anatomy) = Anatomy::of(skeleton) {
        measures.limbs = of_limbs(skeleton, &anatomy, &track);
        measures.foot_slide = speed::foot_slide(skeleton, &anatomy, &track, walking_speed);
    }
    measures
}

fn of_limbs(skeleton: &Skeleton, anatomy: &Anatomy, track: &Track) -> Vec<LimbMeasures> {
    let ends = ends(skeleton, anatomy);
    let places = forward_places(skeleton, anatomy, &ends, track);
    let mut limbs = Vec::new();
    let mut periods = Vec::new();
    for (end, places) in ends.iter().zip(&places) {
        let place = DMatrix::from_column_slice(places.len(), 1, places);
        let swing = place.variance().sqrt();
        // In frames.
        let repeats = if swing < LEAST_SWING { None } else { period(&[place]) };
        let repeats = repeats.map(|period| period.frames);
        let seconds = repeats.map(|frames| frames * track.frame_time);
        let (limb, joint) = (end.limb, end.joint);
        limbs.push(LimbMeasures { limb, joint, swing, period: seconds, ahead: None, locking: None });
        periods.push(repeats);
    }
    for k in 0..ends.len() {
        // The foot or hand of the other side, with which it swings in walking.
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
