//! The ends of hands and feet, and their places along the heading of the body.

use crate::motion::Skeleton;
use crate::motion::anatomy::{Anatomy, Region};
use crate::motion::joint_names::Side;
use crate::motion::measures::track::Track;
use nalgebra::{DMatrix, Vector3};
use serde::Serialize;

/// A hand or a foot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
pub enum Limb {
    /// The left hand.
    #[serde(rename = "left hand")]
    LeftHand,
    /// The right hand.
    #[serde(rename = "right hand")]
    RightHand,
    /// The left foot.
    #[serde(rename = "left foot")]
    LeftFoot,
    /// The right foot.
    #[serde(rename = "right foot")]
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
    /// The node of the figure: the tip of the fingers or toes, as far as the file knows them.
    node: usize,
    /// The joint that bears it.
    pub(super) joint: usize,
}

/// The ends of the limbs that the body has.
pub(super) fn ends(skeleton: &Skeleton) -> Vec<End> {
    let Some(anatomy) = Anatomy::of(skeleton) else { return Vec::new() };
    let nodes = skeleton.figure();
    let tips = [
        (Limb::LeftHand, Region::Arm(Side::Left)),
        (Limb::RightHand, Region::Arm(Side::Right)),
        (Limb::LeftFoot, Region::Leg(Side::Left)),
        (Limb::RightFoot, Region::Leg(Side::Right)),
    ];
    let tips = tips.map(|(limb, region)| (limb, anatomy.tip(skeleton, region)));
    let tips = tips.into_iter().filter_map(|(limb, tip)| tip.map(|node| (limb, node)));
    tips.map(|(limb, node)| End { limb, node, joint: nodes[node].joint }).collect()
}

/// The place of each end along the heading, relative to the root [frames x ends], in metres.
pub(super) fn forward_places(skeleton: &Skeleton, ends: &[End], track: &Track) -> DMatrix<f64> {
    let across = across(skeleton);
    let mut places = DMatrix::zeros(track.frames(), ends.len());
    let mut forward = Vector3::z();
    for frame in 0..track.frames() {
        let left: Vector3<f64> =
            across.iter().map(|&[left, right]| track.at(frame, left) - track.at(frame, right)).sum();
        // Front = left x up. A body that lies on its side keeps the heading that it had.
        let ahead = Vector3::new(-left.z, 0.0, left.x);
        forward = ahead.try_normalize(1e-6).unwrap_or(forward);
        for (place, end) in places.row_mut(frame).iter_mut().zip(ends) {
            *place = track.beside_root(frame, end.node).dot(&forward);
        }
    }
    places
}

/// Pairs of a left and a right joint that lie across the body whatever the limbs do: the hips and the shoulders. In walking these two
/// turn against each other, so that both together keep the heading.
fn across(skeleton: &Skeleton) -> Vec<[usize; 2]> {
    let Some(anatomy) = Anatomy::of(skeleton) else { return Vec::new() };
    let rest = skeleton.rest_pose().positions;
    let apart = 0.02 * skeleton.height();
    let pair = |region: fn(Side) -> Region| {
        let (left, right) = (anatomy.joints(region(Side::Left)), anatomy.joints(region(Side::Right)));
        // Some files begin both limbs at one point, in the middle of the body.
        let mut pairs = left.into_iter().zip(right).map(|(left, right)| [left, right]);
        pairs.find(|&[left, right]| (rest[left] - rest[right]).norm() > apart)
    };
    [pair(Region::Leg), pair(Region::Arm)].into_iter().flatten().collect()
}
