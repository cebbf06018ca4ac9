//! Nodes that a picture of a figure needs: head, feet, and the dots of a point-light walker.

use crate::motion::Clip;
use crate::motion::anatomy::{Anatomy, Region};
use crate::motion::joint_names::Side;
use crate::motion::skeleton::Skeleton;
use nalgebra::Vector3;

/// Nodes of [`Skeleton::figure`], by their places in it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Landmarks {
    /// The top of the head; `None` if it was not found.
    pub head: Option<usize>,
    /// The tips of the left and the right foot; `None` if they were not found.
    pub feet: Option<[usize; 2]>,
    /// The nodes that a point-light walker (Johansson 1973) shows: head, shoulders, elbows, wrists, hips,
    /// knees and ankles as far as they were found. All nodes if no limbs were found.
    pub dots: Vec<usize>,
}

impl Landmarks {
    /// Finds the landmarks of a skeleton.
    pub fn new(skeleton: &Skeleton) -> Self {
        let nodes = skeleton.figure();
        let Some(anatomy) = Anatomy::find(skeleton) else {
            return Self { head: None, feet: None, dots: (0..nodes.len()).collect() };
        };
        if let Some(from_trunk) = anatomy.from_trunk.as_deref() {
            let found = Landmarks::new(&from_trunk.body);
            let own = |node: usize| from_trunk.nodes[node];
            let dots = found.dots.into_iter().map(own).collect();
            return Self { head: found.head.map(own), feet: found.feet.map(|feet| feet.map(own)), dots };
        }
        let sides = [Side::Left, Side::Right];
        let head = anatomy.head(skeleton);
        let feet = sides.map(|side| anatomy.foot(skeleton, side));
        let limbs = sides.map(Region::Arm).into_iter().chain(sides.map(Region::Leg));
        let mut dots: Vec<usize> = head.into_iter().collect();
        dots.extend(limbs.flat_map(|limb| hinges(skeleton, &anatomy, limb)));
        let feet = match feet {
            [Some(left), Some(right)] => Some([left, right]),
            _ => None,
        };
        Self { head, feet, dots }
    }
}

/// The three nodes along the two longest successive bones of a limb: hip, knee and ankle of a leg.
fn hinges(skeleton: &Skeleton, anatomy: &Anatomy, limb: Region) -> Vec<usize> {
    let nodes = skeleton.figure();
    let rest = skeleton.rest_pose().positions;
    let mut chain: Vec<usize> = Vec::new();
    let mut next = anatomy.tip(skeleton, limb);
    while let Some(node) = next.filter(|&node| anatomy.regions[nodes[node].joint] == limb) {
        chain.push(node);
        next = nodes[node].parent;
    }
    chain.reverse();
    let length = |bones: &[usize]| -> f64 {
        bones.windows(2).map(|bone| (rest[bone[1]] - rest[bone[0]]).norm()).sum()
    };
    let longest = chain.windows(3).max_by(|a, b| length(a).total_cmp(&length(b)));
    longest.map_or(chain.clone(), <[usize]>::to_vec)
}

/// The horizontal unit vector in which a body faces on the stage, averaged over its positions [frames x nodes
/// x 3]. `None` if left and right were not found, or the body turns too much for a mean.
pub fn facing(skeleton: &Skeleton, positions: &[f32]) -> Option<Vector3<f64>> {
    let anatomy = Anatomy::find(skeleton)?;
    let nodes = skeleton.node_count();
    let (left, right) = (anatomy.joints(Region::Leg(Side::Left)), anatomy.joints(Region::Leg(Side::Right)));
    let mut sum = Vector3::zeros();
    for frame in positions.chunks_exact(3 * nodes.max(1)) {
        let place = |joint: &usize| Vector3::from_fn(|axis, _| f64::from(frame[3 * joint + axis]));
        let middle =
            |joints: &[usize]| joints.iter().map(place).sum::<Vector3<f64>>() / joints.len().max(1) as f64;
        let leftward = middle(&left) - middle(&right);
        // With y up and left along x, the body faces z.
        let forward = leftward.cross(&Vector3::y());
        sum += Vector3::new(forward.x, 0.0, forward.z).try_normalize(1e-9).unwrap_or_default();
    }
    sum.try_normalize(1e-3 * positions.len() as f64 / nodes.max(1) as f64)
}

impl Clip {
    /// The nodes of the figure that a picture needs.
    pub fn landmarks(&self) -> Landmarks {
        Landmarks::new(&self.skeleton)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{rotation, samples};

    #[test]
    fn a_point_light_walker_has_thirteen_dots() {
        let clip = samples::clip("walk-1").unwrap();
        let Landmarks { head, feet, dots } = clip.landmarks();
        let name = |node: usize| {
            let node = clip.skeleton.figure()[node];
            clip.skeleton.joints[node.joint].name.clone()
        };
        let names: Vec<String> = dots.iter().map(|&dot| name(dot)).collect();
        let limbs = ["LeftArm", "LeftForeArm", "LeftHand", "RightArm", "RightForeArm", "RightHand"];
        let legs = ["LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot"];
        assert_eq!(names[1..], [limbs, legs].concat());
        assert_eq!(names[0], "Head");
        assert_eq!(head, Some(dots[0]));
        assert_eq!(feet.unwrap().map(name), ["LeftToeBase", "RightToeBase"]);
    }

    #[test]
    fn a_walker_faces_where_it_goes() {
        for id in ["walk-1", "walk-wave-2"] {
            let clip = samples::clip(id).unwrap();
            let places = clip.stage_positions();
            let nodes = clip.skeleton.node_count();
            let root = |frame: usize| {
                let at = 3 * nodes * frame;
                Vector3::new(f64::from(places[at]), 0.0, f64::from(places[at + 2]))
            };
            let way = (root(clip.frames() - 1) - root(0)).normalize();
            let facing = facing(&clip.skeleton, &places).unwrap();
            assert!(facing.dot(&way) > 0.98, "{id}: {facing} {way}");
        }
    }

    #[test]
    fn a_body_that_turns_all_the_way_round_faces_nowhere() {
        let walk = samples::clip("walk-1").unwrap();
        let turned = |frames: usize, angle: f64| -> Vec<f32> {
            let pose = &walk.stage_positions()[..3 * walk.skeleton.node_count()];
            let place = |k: usize, point: &[f32]| {
                let turn = rotation::about_axis(1, angle * k as f64 / (frames - 1) as f64);
                let place = turn * Vector3::from_fn(|axis, _| f64::from(point[axis]));
                [place.x as f32, place.y as f32, place.z as f32]
            };
            (0..frames).flat_map(|k| pose.chunks(3).flat_map(move |point| place(k, point))).collect()
        };
        assert_eq!(facing(&walk.skeleton, &turned(2001, std::f64::consts::TAU)), None);
        assert!(facing(&walk.skeleton, &turned(2001, std::f64::consts::PI)).is_some());
    }
}
