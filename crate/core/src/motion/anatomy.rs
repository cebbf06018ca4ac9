//! Which joints are legs, arms and trunk: from the joints' names, or else from the shape of the tree.

use crate::motion::joint_names::{Limb, Side, is_sided, limb_of, looks_like_head};
use crate::motion::limbs::{
    Limbs, Pair, extents, is_clear, is_within, long_pairs, mirrored_pairs, path_between, path_lengths,
};
use crate::motion::skeleton::{Joint, Skeleton};
use nalgebra::Vector3;

/// A region of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Region {
    /// Hips, spine, neck and head.
    Trunk,
    /// From the collar bone or shoulder to the fingers.
    Arm(Side),
    /// From the hip to the toes.
    Leg(Side),
}

/// Where the limbs are.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Anatomy {
    /// The region of each joint.
    pub(crate) regions: Vec<Region>,
    /// The same body from its trunk on, if the tree begins within a limb.
    pub(crate) from_trunk: Option<Box<FromTrunk>>,
}

/// The rest pose of a body as a tree that begins at the trunk.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FromTrunk {
    pub(crate) body: Skeleton,
    anatomy: Anatomy,
    /// For each node of its figure the node of the original figure; the joints come first.
    pub(crate) nodes: Vec<usize>,
}

impl FromTrunk {
    /// `None` if neither names nor shape show legs in this tree.
    fn new(skeleton: &Skeleton, trunk: usize) -> Option<FromTrunk> {
        let (body, nodes) = rooted_at(skeleton, trunk);
        Some(FromTrunk { anatomy: Anatomy::in_tree(&body)?, body, nodes })
    }

    /// The values of the joints, in the order of the original joints.
    fn by_joint<T: Copy>(&self, values: &[T]) -> Vec<T> {
        let mut sorted = values.to_vec();
        values.iter().zip(&self.nodes).for_each(|(value, &joint)| sorted[joint] = *value);
        sorted
    }
}

impl Anatomy {
    /// Finds two legs, and arms if there are any; `None` where neither names nor shape show them.
    pub(crate) fn find(skeleton: &Skeleton) -> Option<Anatomy> {
        let in_tree = Anatomy::in_tree(skeleton);
        let from = |trunk| FromTrunk::new(skeleton, trunk);
        let from_trunk = if let Some(trunk) = trunk_beyond_limb(skeleton) {
            from(trunk)
        } else if in_tree.as_ref().is_some_and(Anatomy::has_both_arms) {
            None
        } else {
            // The tree may begin within a limb whose joints have no names.
            let forks = (0..skeleton.joints.len()).filter(|&joint| skeleton.children(joint).nth(1).is_some());
            forks.filter_map(from).find(|from_trunk| {
                let FromTrunk { body, anatomy, .. } = from_trunk;
                let regions = from_trunk.by_joint(&anatomy.regions);
                anatomy.has_both_arms() && anatomy.hips(body) == 0 && regions[0] != Region::Trunk
            })
        };
        let Some(from_trunk) = from_trunk else { return in_tree };
        let regions = from_trunk.by_joint(&from_trunk.anatomy.regions);
        Some(Anatomy { regions, from_trunk: Some(Box::new(from_trunk)) })
    }

    /// As [`find`](Self::find), for a tree that begins at the trunk.
    fn in_tree(skeleton: &Skeleton) -> Option<Anatomy> {
        let shaped = || by_shape(skeleton).map(|regions| Anatomy { regions, from_trunk: None });
        Anatomy::named(skeleton).or_else(|| shaped().filter(Anatomy::has_both_legs))
    }

    /// As [`find`](Self::find), by the names alone.
    pub(crate) fn named(skeleton: &Skeleton) -> Option<Anatomy> {
        let named = [false, true].into_iter().map(|legs_below_head| by_names(skeleton, legs_below_head));
        named.map(|regions| Anatomy { regions, from_trunk: None }).find(Anatomy::has_both_legs)
    }

    fn has(&self, region: Region) -> bool {
        self.regions.contains(&region)
    }

    fn has_both_legs(&self) -> bool {
        self.has(Region::Leg(Side::Left)) && self.has(Region::Leg(Side::Right))
    }

    /// Whether both arms were found.
    pub(crate) fn has_both_arms(&self) -> bool {
        self.has(Region::Arm(Side::Left)) && self.has(Region::Arm(Side::Right))
    }

    /// The joints of a region.
    pub(crate) fn joints(&self, region: Region) -> Vec<usize> {
        (0..self.regions.len()).filter(|&joint| self.regions[joint] == region).collect()
    }

    /// The positions of all nodes except those of the arms, which may be raised above the head.
    pub(crate) fn without_arms(&self, skeleton: &Skeleton, places: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let nodes = skeleton.figure();
        let others =
            nodes.iter().zip(places).filter(|(node, _)| !matches!(self.regions[node.joint], Region::Arm(_)));
        others.map(|(_, place)| *place).collect()
    }

    /// The farthest node of a limb, measured along the bones: the tip of the toes or fingers.
    pub(crate) fn tip(&self, skeleton: &Skeleton, limb: Region) -> Option<usize> {
        if let Some(FromTrunk { body, anatomy, nodes }) = self.from_trunk.as_deref() {
            return anatomy.tip(body, limb).map(|node| nodes[node]);
        }
        let nodes = skeleton.figure();
        farthest(&path_lengths(skeleton), |node| self.regions[nodes[node].joint] == limb)
    }

    /// The tip of a leg.
    pub(crate) fn foot(&self, skeleton: &Skeleton, side: Side) -> Option<usize> {
        self.tip(skeleton, Region::Leg(side))
    }

    /// The joint where the legs meet: the last one with both legs below it.
    pub(crate) fn hips(&self, skeleton: &Skeleton) -> usize {
        if let Some(FromTrunk { body, anatomy, nodes }) = self.from_trunk.as_deref() {
            return nodes[anatomy.hips(body)];
        }
        let [left, right] = [Side::Left, Side::Right].map(|side| self.bearing(skeleton, Region::Leg(side)));
        (0..self.regions.len()).rev().find(|&joint| left[joint] && right[joint]).unwrap_or(0)
    }

    /// For each joint whether it belongs to the trunk and a joint of the limb hangs below it.
    pub(crate) fn bearing(&self, skeleton: &Skeleton, limb: Region) -> Vec<bool> {
        if let Some(from_trunk) = self.from_trunk.as_deref() {
            return from_trunk.by_joint(&from_trunk.anatomy.bearing(&from_trunk.body, limb));
        }
        let mut bearing = vec![false; self.regions.len()];
        for (place, joint) in skeleton.joints.iter().enumerate().rev() {
            if let Some(parent) = joint.parent.filter(|&parent| self.regions[parent] == Region::Trunk)
                && (bearing[place] || self.regions[place] == limb)
            {
                bearing[parent] = true;
            }
        }
        bearing
    }

    /// The top of the head: the node farthest from the hips at or below a trunk joint whose name contains
    /// "head", or above it where the tree begins at the head; else the farthest node of the trunk.
    pub(crate) fn head(&self, skeleton: &Skeleton) -> Option<usize> {
        if let Some(FromTrunk { body, anatomy, nodes }) = self.from_trunk.as_deref() {
            return anatomy.head(body).map(|node| nodes[node]);
        }
        let hips = self.hips(skeleton);
        let is_above_hips: Vec<bool> =
            (0..self.regions.len()).map(|joint| is_within(skeleton, hips, joint)).collect();
        let mut within_head = vec![false; skeleton.joints.len()];
        for (place, joint) in skeleton.joints.iter().enumerate() {
            let below_head = joint.parent.is_some_and(|parent| within_head[parent]);
            within_head[place] = self.regions[place] == Region::Trunk
                && (looks_like_head(&joint.name) || below_head && !is_above_hips[place]);
            if within_head[place] && is_above_hips[place] {
                within_head[..place].fill(true);
            }
        }
        let paths = path_lengths(skeleton);
        let nodes = skeleton.figure();
        let lengths: Vec<f64> =
            (0..nodes.len()).map(|node| path_between(skeleton, &paths, hips, node)).collect();
        let is_trunk = |node: usize| self.regions[nodes[node].joint] == Region::Trunk;
        // A joint between the root and the hips is no head, unless the trunk has nothing else.
        let is_beyond_hips = |node: usize| nodes[node].end_site || !is_above_hips[nodes[node].joint];
        let head = |node: usize| is_trunk(node) && within_head[nodes[node].joint];
        farthest(&lengths, head)
            .or_else(|| farthest(&lengths, |node| is_trunk(node) && is_beyond_hips(node)))
            .or_else(|| farthest(&lengths, is_trunk))
    }
}

/// The rest pose as a tree from another root, and for each node of its figure the node of the original figure.
fn rooted_at(skeleton: &Skeleton, root: usize) -> (Skeleton, Vec<usize>) {
    let rest = skeleton.rest_pose().positions;
    let mut order: Vec<(usize, Option<usize>)> = vec![(root, None)];
    for at in 0..skeleton.joints.len() {
        let (place, from) = order[at];
        let came = from.map(|from| order[from].0);
        let next = skeleton.joints[place].parent.into_iter().chain(skeleton.children(place));
        order.extend(next.filter(|next| Some(*next) != came).map(|next| (next, Some(at))));
    }
    let joint = |&(place, parent): &(usize, Option<usize>)| {
        let above = parent.map_or_else(Vector3::zeros, |parent| rest[order[parent].0]);
        Joint { parent, offset: (rest[place] - above).into(), ..skeleton.joints[place].clone() }
    };
    let body = Skeleton { joints: order.iter().map(joint).collect() };
    let figure = &skeleton.figure();
    let joints = order.len();
    let ends = |place: usize| (joints..figure.len()).filter(move |&end| figure[end].joint == place);
    let places = order.iter().map(|(place, _)| *place);
    let nodes = places.clone().chain(places.flat_map(ends)).collect();
    (body, nodes)
}

/// Where a tree that begins within a limb reaches the trunk, by the names: of the joints without a side the one with
/// the most joints below it.
fn trunk_beyond_limb(skeleton: &Skeleton) -> Option<usize> {
    let joints = &skeleton.joints;
    joints.first().and_then(|root| limb_of(&root.name))?;
    let size =
        |top: &usize| joints.iter().enumerate().filter(|(at, _)| is_within(skeleton, *at, *top)).count();
    (0..joints.len()).rev().filter(|&joint| !is_sided(&joints[joint].name)).max_by_key(size)
}

/// Of the wanted nodes the one with the longest path.
fn farthest(paths: &[f64], wanted: impl Fn(usize) -> bool) -> Option<usize> {
    (0..paths.len()).filter(|&node| wanted(node)).max_by(|&a, &b| paths[a].total_cmp(&paths[b]))
}

/// The regions by the names of the joints. In a tree that begins at the head, legs are below a head.
fn by_names(skeleton: &Skeleton, legs_below_head: bool) -> Vec<Region> {
    let is_limb = |joint: usize, limb| limb_of(&skeleton.joints[joint].name).is_some_and(|(l, _)| l == limb);
    let mut bears_leg = vec![false; skeleton.joints.len()];
    for (place, joint) in skeleton.joints.iter().enumerate().rev() {
        if let Some(parent) = joint.parent {
            bears_leg[parent] |= legs_below_head && (bears_leg[place] || is_limb(place, Limb::Leg));
        }
    }
    let mut regions: Vec<Region> = Vec::new();
    // A joint below a limb belongs to the limb, a joint below the head to the trunk, whatever their names.
    let mut within_head = vec![false; skeleton.joints.len()];
    for (place, joint) in skeleton.joints.iter().enumerate() {
        let Some(parent) = joint.parent else {
            regions.push(Region::Trunk);
            continue;
        };
        within_head[place] = within_head[parent] || looks_like_head(&joint.name) && !bears_leg[place];
        let region = match regions[parent] {
            Region::Trunk if within_head[place] => Region::Trunk,
            Region::Trunk => match limb_of(&joint.name) {
                Some((Limb::Arm, side)) => Region::Arm(side),
                Some((Limb::Leg, side)) => Region::Leg(side),
                None => Region::Trunk,
            },
            limb => limb,
        };
        regions.push(region);
    }
    regions
}

/// A pair farther from the root than another is the legs if it ends lower and this many times as far from the
/// height of the root: then the tree begins at the chest or the head.
const FARTHER: f64 = 1.3;

/// Legs are the pair of long mirrored chains nearest to the root (of several, the one that ends lowest), but
/// for trees that begin at the chest or the head; arms are the longest such pair elsewhere.
fn by_shape(skeleton: &Skeleton) -> Option<Vec<Region>> {
    let pairs = mirrored_pairs(skeleton);
    let limbs = long_pairs(&pairs);
    let shallowest = limbs.iter().map(|pair| pair.depth).min()?;
    let up = up_of_rest(skeleton);
    let height = |pair: &Pair| pair.ends[0][up] + pair.ends[1][up];
    let legs = (limbs.iter().filter(|pair| pair.depth == shallowest))
        .min_by(|a, b| height(a).total_cmp(&height(b)))?;
    let root = 2.0 * skeleton.rest_pose().positions[0][up];
    let below_root = |pair: &Pair| root - height(pair);
    let lowest = limbs.iter().max_by(|a, b| below_root(a).total_cmp(&below_root(b)))?;
    let legs = if below_root(lowest) > FARTHER * below_root(legs).abs() { lowest } else { legs };
    let arms = (limbs.iter())
        .filter(|pair| !pair.members.iter().any(|&m| legs.members.iter().any(|&l| is_within(skeleton, m, l))))
        .filter(|pair| height(pair) > height(legs))
        .max_by(|a, b| a.reach.total_cmp(&b.reach));
    let mut regions = vec![Region::Trunk; skeleton.joints.len()];
    // The toes point to the front, and left = up x front. Without toes, left is the side of larger x.
    let rest = skeleton.rest_pose().positions;
    let mut front = 0.5 * (legs.ends[0] + legs.ends[1] - rest[legs.members[0]] - rest[legs.members[1]]);
    front[up] = 0.0;
    let left = Vector3::ith(up, 1.0).cross(&front);
    let left = if front.norm() > 0.02 * legs.reach { left } else { Vector3::x() };
    let mut paint = |pair: &Pair, region: fn(Side) -> Region| {
        let first_is_left = (pair.ends[0] - pair.ends[1]).dot(&left) > 0.0;
        for (member, left) in pair.members.into_iter().zip([first_is_left, !first_is_left]) {
            let side = if left { Side::Left } else { Side::Right };
            for (joint, painted) in regions.iter_mut().enumerate() {
                if is_within(skeleton, joint, member) {
                    *painted = region(side);
                }
            }
        }
    };
    paint(legs, Region::Leg);
    if let Some(arms) = arms {
        paint(arms, Region::Arm);
    }
    Some(regions)
}

/// The probable up axis of a rest pose without names: y, unless the body is clearly longer along z. The arms
/// usually lie along x.
fn up_of_rest(skeleton: &Skeleton) -> usize {
    let extent = extents(&skeleton.rest_pose().positions);
    match (extent[2] > 1.5 * extent[1], extent[1] > 1e-9 * extent.max()) {
        (true, _) => 2,
        (false, true) => 1,
        (false, false) => 0,
    }
}

/// The upward vector of an upright rest pose: from the feet to the head, or from the tips of the limbs to their
/// sockets where all limbs reach the ground. `None` if the rest pose is not upright, as in files whose offsets
/// all point along the bones' own axes.
pub(crate) fn standing_at_rest(skeleton: &Skeleton, anatomy: &Anatomy) -> Option<Vector3<f64>> {
    let rest = skeleton.rest_pose().positions;
    let paths = path_lengths(skeleton);
    let (to_head, length) = feet_to_head(skeleton, anatomy, &rest, &paths)?;
    if to_head.amax() <= 0.7 * length {
        return None;
    }
    let by_limbs = Limbs::find(skeleton)
        .filter(|limbs| limbs.agree(&rest))
        .map(|limbs| limbs.upward(&rest))
        .filter(|upward| is_clear(upward) && upward.iamax() != to_head.iamax());
    Some(by_limbs.unwrap_or(to_head))
}

/// The vector from the middle of the feet to the top of the head, and the length of that path along the
/// bones.
fn feet_to_head(
    skeleton: &Skeleton,
    anatomy: &Anatomy,
    places: &[Vector3<f64>],
    paths: &[f64],
) -> Option<(Vector3<f64>, f64)> {
    let head = anatomy.head(skeleton)?;
    let (left, right) = (anatomy.foot(skeleton, Side::Left)?, anatomy.foot(skeleton, Side::Right)?);
    let upward = places[head] - 0.5 * (places[left] + places[right]);
    let length = |foot| path_between(skeleton, paths, head, foot);
    Some((upward, 0.5 * (length(left) + length(right))))
}

/// Height of a standing body divided by the length along its bones from the toes to the top of the head. The
/// bones of feet and hips are horizontal, so the ratio is below 1.
const STANDING: f64 = 0.87;

impl Skeleton {
    /// The body's height in file units, from the rest pose: from the lowest to the highest point of legs and
    /// trunk. Where the rest pose does not stand, from the lengths of the bones; for a body without legs, the
    /// longest side of its box.
    pub fn height(&self) -> f64 {
        let rest = self.rest_pose().positions;
        let height = Anatomy::find(self).and_then(|anatomy| match standing_at_rest(self, &anatomy) {
            Some(upward) => Some(extents(&anatomy.without_arms(self, &rest))[upward.iamax()]),
            None => {
                feet_to_head(self, &anatomy, &rest, &path_lengths(self)).map(|(_, length)| STANDING * length)
            }
        });
        height.unwrap_or_else(|| extents(&rest)[up_of_rest(self)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::skeleton::Joint;
    use crate::motion::{landmarks::Landmarks, parts, samples};

    #[test]
    fn a_tree_may_begin_within_a_limb() {
        let body = samples::clip("walk-1").unwrap().skeleton;
        for named in [true, false] {
            for root in ["LeftToeBase", "RightLeg", "LeftUpLeg", "RightHand", "LeftForeArm"] {
                let place = body.joints.iter().position(|joint| joint.name == root).unwrap();
                let (mut other, nodes) = rooted_at(&body, place);
                if !named {
                    other.joints.iter_mut().for_each(|joint| joint.name = "joint".to_owned());
                }
                for (own, others) in parts::presets(&body).iter().zip(parts::presets(&other)).skip(1) {
                    for (own, others) in own.parts.iter().zip(&others.parts) {
                        let mut joints: Vec<usize> =
                            others.joints.iter().map(|&joint| nodes[joint]).collect();
                        joints.sort_unstable();
                        assert_eq!(joints, own.joints, "{root} {named} {}", own.name);
                    }
                }
                assert!((other.height() / body.height() - 1.0).abs() < 1e-9, "{root} {named}");
                let (own, others) = (Landmarks::new(&body), Landmarks::new(&other));
                assert_eq!(others.head.map(|head| nodes[head]), own.head, "{root} {named}");
                assert_eq!(others.feet.map(|feet| feet.map(|foot| nodes[foot])), own.feet, "{root} {named}");
                assert_eq!(others.dots.len(), own.dots.len(), "{root} {named}");
            }
        }
    }

    #[test]
    fn names_of_one_leg_alone_are_no_anatomy() {
        let mut body = samples::clip("walk-1").unwrap().skeleton;
        assert!(Anatomy::named(&body).is_some());
        for joint in body.joints.iter_mut().filter(|joint| joint.name.starts_with("Right")) {
            joint.name = "joint".to_owned();
        }
        assert!(Anatomy::named(&body).is_none());
    }

    #[test]
    fn a_joint_below_the_head_belongs_to_the_trunk_whatever_its_name() {
        let mut body = samples::clip("walk-1").unwrap().skeleton;
        let head = body.joints.iter().position(|joint| joint.name == "Head").unwrap();
        let hat = Joint { name: "LeftHand".to_owned(), parent: Some(head), ..body.joints[head].clone() };
        body.joints.push(hat);
        assert_eq!(Anatomy::named(&body).unwrap().regions.last(), Some(&Region::Trunk));
    }
}
