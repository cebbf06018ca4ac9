//! The walker's body: 21 joints in proportions from a published table.
//!
//! Segment lengths are fractions of the body's height H, after Drillis and Contini (1966) as printed in
//! Winter, *Biomechanics and Motor Control of Human Movement* (4th ed. 2009, fig. 4.1): ankle 0.039 H above
//! the ground, shank 0.246 H, thigh 0.245 H, upper arm 0.186 H, forearm 0.146 H, hand 0.108 H, foot 0.152 H
//! long, shoulders at 0.818 H, chin at 0.870 H. The table has outer breadths; the joint centres
//! are closer together: hips 0.10 H apart, shoulders 0.22 H.

use crate::motion::rotation;
use crate::motion::skeleton::{Channel, Joint, Skeleton};
use nalgebra::{DMatrix, UnitQuaternion, Vector3};

/// Height of the body, centimetres.
pub(super) const HEIGHT: f64 = 172.0;
/// The heel in the frame of the ankle (toes forward along z), centimetres.
pub(super) const HEEL: Vector3<f64> = Vector3::new(0.0, -0.039 * HEIGHT, -0.035 * HEIGHT);
/// The ball of the foot, where the toes bend.
pub(super) const BALL: Vector3<f64> = Vector3::new(0.0, -0.039 * HEIGHT, 0.077 * HEIGHT);
/// From the ball to the tip of the toes.
pub(super) const TOE: Vector3<f64> = Vector3::new(0.0, 0.0, 0.040 * HEIGHT);

/// Indices of the joints in [`skeleton`].
pub(super) mod joint {
    pub const HIPS: usize = 0;
    pub const LEFT_UP_LEG: usize = 1;
    pub const RIGHT_UP_LEG: usize = 5;
    pub const SPINE: usize = 9;
    pub const SPINE1: usize = 10;
    pub const NECK: usize = 11;
    pub const HEAD: usize = 12;
    pub const LEFT_SHOULDER: usize = 13;
    pub const RIGHT_SHOULDER: usize = 17;
    pub const COUNT: usize = 21;
}

/// The body at rest: upright with the arms stretched out sideways, y up, facing z, the left side at positive
/// x; centimetres.
///
/// The root has position and rotation channels, every other joint the rotations z, y, x.
pub(super) fn skeleton() -> Skeleton {
    let mut joints = Vec::with_capacity(joint::COUNT);
    let mut add = |name: &str, parent: Option<usize>, offset: [f64; 3], end: Option<[f64; 3]>| {
        let scale = |v: [f64; 3]| v.map(|x| x * HEIGHT);
        let rotations = [Channel::Zrotation, Channel::Yrotation, Channel::Xrotation];
        let mut channels = Vec::new();
        if parent.is_none() {
            channels.extend([Channel::Xposition, Channel::Yposition, Channel::Zposition]);
        }
        channels.extend(rotations);
        joints.push(Joint {
            name: name.to_owned(),
            parent,
            offset: scale(offset),
            channels,
            end_sites: end.map(scale).into_iter().collect(),
        });
    };
    add("Hips", None, [0.0; 3], None);
    for (side, sign, first) in [("Left", 1.0, joint::LEFT_UP_LEG), ("Right", -1.0, joint::RIGHT_UP_LEG)] {
        add(&format!("{side}UpLeg"), Some(joint::HIPS), [sign * 0.050, -0.020, 0.0], None);
        add(&format!("{side}Leg"), Some(first), [0.0, -0.245, 0.0], None);
        add(&format!("{side}Foot"), Some(first + 1), [0.0, -0.246, 0.0], None);
        add(&format!("{side}ToeBase"), Some(first + 2), [0.0, -0.039, 0.077], Some([0.0, 0.0, 0.040]));
    }
    add("Spine", Some(joint::HIPS), [0.0, 0.060, -0.008], None);
    add("Spine1", Some(joint::SPINE), [0.0, 0.110, -0.006], None);
    add("Neck", Some(joint::SPINE1), [0.0, 0.120, 0.0], None);
    add("Head", Some(joint::NECK), [0.0, 0.060, 0.012], Some([0.0, 0.100, 0.010]));
    for (side, sign, first) in [("Left", 1.0, joint::LEFT_SHOULDER), ("Right", -1.0, joint::RIGHT_SHOULDER)] {
        add(&format!("{side}Shoulder"), Some(joint::SPINE1), [sign * 0.020, 0.090, 0.008], None);
        add(&format!("{side}Arm"), Some(first), [sign * 0.090, 0.008, -0.008], None);
        add(&format!("{side}ForeArm"), Some(first + 1), [sign * 0.186, 0.0, 0.0], None);
        let hand_end = Some([sign * 0.108, 0.0, 0.0]);
        add(&format!("{side}Hand"), Some(first + 2), [sign * 0.146, 0.0, 0.0], hand_end);
    }
    Skeleton { joints }
}

/// Frames a second.
pub(super) const RATE: f64 = 60.0;

/// The frames of a clip of [`skeleton`](super::body::skeleton).
pub(super) struct Frames {
    /// [frames x channels]: positions in centimetres, angles in degrees.
    pub values: DMatrix<f64>,
    /// The angles of the last frame, radians: the next ones are those nearest to them.
    angles: [[f64; 3]; joint::COUNT],
    added: usize,
}

impl Frames {
    /// `frames` frames, all zero.
    pub fn new(frames: usize) -> Frames {
        let values = DMatrix::zeros(frames, 3 + 3 * joint::COUNT);
        Frames { values, angles: [[0.0; 3]; joint::COUNT], added: 0 }
    }

    /// Writes the next frame: the place of the root and the local rotations of the joints.
    pub fn add(&mut self, place: &Vector3<f64>, q: &[UnitQuaternion<f64>; joint::COUNT]) {
        let mut row = self.values.row_mut(self.added);
        for (column, coordinate) in place.iter().enumerate() {
            row[column] = *coordinate;
        }
        for (k, rotation) in q.iter().enumerate() {
            self.angles[k] = rotation::euler_near(rotation, [2, 1, 0], self.angles[k]);
            for (column, angle) in self.angles[k].iter().enumerate() {
                row[3 + 3 * k + column] = angle.to_degrees();
            }
        }
        self.added += 1;
    }
}
