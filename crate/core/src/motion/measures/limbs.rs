//! The tips of hands and feet, and their positions along the heading of the body.

use crate::elementary::Elementary;
use crate::motion::Skeleton;
use crate::motion::anatomy::{Anatomy, Region};
use crate::motion::joint_names::Side;
use crate::motion::measures::speed::Track;
use nalgebra::Vector3;
use serde::Serialize;

/// A hand or a foot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Limb {
    /// The left hand.
    #[serde(rename = "left-hand")]
    LeftHand,
    /// The right hand.
    #[serde(rename = "right-hand")]
    RightHand,
    /// The left foot.
    #[serde(rename = "left-foot")]
    LeftFoot,
    /// The right foot.
    #[serde(rename = "right-foot")]
    RightFoot,
}

impl Limb {
    /// The limb with which it swings in walking: a hand with the foot of the other side.
    pub fn other(self) -> Limb {
        match self {
            Limb::LeftHand => Limb::RightFoot,
            Limb::RightHand => Limb::LeftFoot,
            Limb::LeftFoot => Limb::RightHand,
            Limb::RightFoot => Limb::LeftHand,
        }
    }

    /// Whether it is a hand.
    pub fn is_hand(self) -> bool {
        matches!(self, Limb::LeftHand | Limb::RightHand)
    }
}

/// The end of a limb.
pub(super) struct End {
    pub(super) limb: Limb,
    /// The node of the figure: the tip of the fingers or toes.
    node: usize,
    /// The joint of that node.
    pub(super) joint: usize,
}

/// The ends of the limbs that the body has.
pub(super) fn ends(skeleton: &Skeleton, anatomy: &Anatomy) -> Vec<End> {
    let nodes = skeleton.figure();
    let mut ends = Vec::new();
    for (limb, region) in [
        (Limb::LeftHand, Region::Arm(Side::Left)),
        (Limb::RightHand, Region::Arm(Side::Right)),
        (Limb::LeftFoot, Region::Leg(Side::Left)),
        (Limb::RightFoot, Region::Leg(Side::Right)),
    ] {
        if let Some(node) = anatomy.tip(skeleton, region) {
            ends.push(End { limb, node, joint: nodes[node].joint });
        }
    }
    ends
}

/// The position of each end along the heading, relative to the root, in metres [ends x frames].
pub(super) fn forward_places(
    skeleton: &Skeleton,
    anatomy: &Anatomy,
    ends: &[End],
    track: &Track,
) -> Vec<Vec<f64>> {
    let across = across(skeleton, anatomy);
    let mut places = vec![Vec::new(); ends.len()];
    let mut forward = Vector3::z();
    for frame in 0..track.frames() {
        let mut left = Vector3::zeros();
        for &[on_left, on_right] in &across {
            left += track.at(frame, on_left) - track.at(frame, on_right);
        }
        // Front = left x up. A body that lies on its side keeps its last heading.
        let length = left.x.hypotenuse(left.z);
        if length > 1e-6 {
            forward = Vector3::new(-left.z / length, 0.0, left.x / length);
        }
        for (places, end) in places.iter_mut().zip(ends) {
            places.push(track.root_to(frame, end.node).dot(&forward));
        }
    }
    places
}

/// The left and right hip and the left and right shoulder. In walking hips and shoulders turn against each
/// other, so their sum keeps the heading.
fn across(skeleton: &Skeleton, anatomy: &Anatomy) -> Vec<[usize; 2]> {
    let rest = skeleton.rest_pose().positions;
    let apart = 0.02 * skeleton.height();
    let mut across = Vec::new();
    for region in [Region::Leg as fn(Side) -> Region, Region::Arm] {
        let (left, right) = (anatomy.joints(region(Side::Left)), anatomy.joints(region(Side::Right)));
        for (left, right) in left.into_iter().zip(right) {
            // Some files begin both limbs at one point, in the middle of the body.
            if (rest[left] - rest[right]).norm() > apart {
                across.push([left, right]);
                break;
            }
        }
    }
    across
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::samples;

    #[test]
    fn the_heading_comes_from_joints_that_are_apart() {
        let mut skeleton = samples::clip("walk-1").unwrap().skeleton;
        let place = |name: &str| skeleton.joints.iter().position(|joint| joint.name == name).unwrap();
        let [left, right, knee, other_knee] = ["LeftUpLeg", "RightUpLeg", "LeftLeg", "RightLeg"].map(place);
        let anatomy = Anatomy::find(&skeleton).unwrap();
        assert_eq!(across(&skeleton, &anatomy)[0], [left, right]);
        for (joint, side) in [(left, 1.0), (right, -1.0)] {
            let hip = skeleton.joints[joint].offset[0] - side * 0.5;
            skeleton.joints[joint].offset[0] -= hip;
            skeleton.joints[joint + 1].offset[0] += hip;
        }
        assert_eq!(across(&skeleton, &anatomy)[0], [knee, other_knee]);
    }
}
