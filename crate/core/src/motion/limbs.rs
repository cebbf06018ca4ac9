//! Limbs that come in mirrored pairs, and the direction in which they carry the body.

use crate::motion::skeleton::Skeleton;
use nalgebra::Vector3;

/// Two subtrees of one joint that mirror each other.
pub(crate) struct Pair {
    /// The first joints of both.
    pub(crate) members: [usize; 2],
    /// The number of joints above the common one.
    pub(crate) depth: usize,
    /// The length along the bones from the common joint to the farthest node.
    pub(crate) reach: f64,
    /// Their farthest nodes.
    pub(crate) tips: [usize; 2],
    /// The positions of their farthest nodes in the rest pose.
    pub(crate) ends: [Vector3<f64>; 2],
}

/// The pairs that are limbs: a pair of fingers or eyes is much shorter.
pub(crate) fn long_pairs(pairs: &[Pair]) -> Vec<&Pair> {
    let longest = pairs.iter().map(|pair| pair.reach).fold(0.0, f64::max);
    pairs.iter().filter(|pair| pair.reach > 0.4 * longest).collect()
}

/// Limbs agree when the sum of their vectors has this share of the length of all pairs.
const AGREES: f64 = 0.5;

/// All limbs of a body, each with its socket and its tip.
pub(crate) struct Limbs {
    limbs: Vec<LimbNodes>,
    /// The sum of the lengths of all limbs.
    length: f64,
}

struct LimbNodes {
    /// The number of its pair.
    pair: usize,
    socket: usize,
    tip: usize,
}

impl Limbs {
    /// The limbs of a body; `None` if nothing is mirrored.
    pub(crate) fn find(skeleton: &Skeleton) -> Option<Limbs> {
        let pairs = mirrored_pairs(skeleton);
        let mut found = Limbs { limbs: Vec::new(), length: 0.0 };
        for (number, pair) in long_pairs(&pairs).into_iter().enumerate() {
            for (socket, tip) in pair.members.into_iter().zip(pair.tips) {
                if found.limbs.iter().any(|limb| limb.socket == socket) {
                    continue;
                }
                found.limbs.push(LimbNodes { pair: number, socket, tip });
                found.length += pair.reach;
            }
        }
        (found.length > 0.0).then_some(found)
    }

    /// The sum of the vectors from the tips to the sockets, divided by the lengths of the limbs. Vectors to
    /// the left cancel those to the right, so what remains points up.
    pub(crate) fn upward(&self, places: &[Vector3<f64>]) -> Vector3<f64> {
        let vectors = self.limbs.iter().map(|limb| places[limb.socket] - places[limb.tip]);
        vectors.sum::<Vector3<f64>>() / self.length
    }

    /// Whether the pairs of limbs carry the body the same way. Arms that point up cancel legs that point down,
    /// and the direction of what remains is chance.
    pub(crate) fn agree(&self, places: &[Vector3<f64>]) -> bool {
        let mut pairs: Vec<Vector3<f64>> = Vec::new();
        for limb in &self.limbs {
            if pairs.len() <= limb.pair {
                pairs.resize(limb.pair + 1, Vector3::zeros());
            }
            pairs[limb.pair] += places[limb.socket] - places[limb.tip];
        }
        let lengths: f64 = pairs.iter().map(Vector3::norm).sum();
        pairs.iter().sum::<Vector3<f64>>().norm() >= AGREES * lengths
    }
}

/// Whether the vector clearly points along one axis.
pub(crate) fn is_clear(upward: &Vector3<f64>) -> bool {
    upward.norm() > 0.1 && upward.amax() > 0.8 * upward.norm()
}

/// The size of the box around some points.
pub(crate) fn extents(points: &[Vector3<f64>]) -> Vector3<f64> {
    let first = points.first().copied().unwrap_or_default();
    let low = points.iter().fold(first, |low, point| low.inf(point));
    let high = points.iter().fold(first, |high, point| high.sup(point));
    high - low
}

/// The length of the path along the bones from the root to each node of the figure, in file units.
pub(crate) fn path_lengths(skeleton: &Skeleton) -> Vec<f64> {
    let mut paths: Vec<f64> = Vec::new();
    for joint in &skeleton.joints {
        let bone = Vector3::from(joint.offset).norm();
        paths.push(joint.parent.map_or(0.0, |parent| paths[parent] + bone));
    }
    for (place, joint) in skeleton.joints.iter().enumerate() {
        for end in &joint.end_sites {
            paths.push(paths[place] + Vector3::from(*end).norm());
        }
    }
    paths
}

/// The length of the path along the bones between two nodes of the figure, whose paths from the root are
/// `paths`.
pub(crate) fn path_between(skeleton: &Skeleton, paths: &[f64], a: usize, b: usize) -> f64 {
    let nodes = skeleton.figure();
    let (above, below) = (nodes[a].joint, nodes[b].joint);
    let meets = |&joint: &usize| is_within(skeleton, above, joint);
    let common = std::iter::once(below).chain(ancestors(skeleton, below)).find(meets).unwrap_or(0);
    paths[a] + paths[b] - 2.0 * paths[common]
}

/// All pairs of subtrees that mirror each other in the rest pose.
pub(crate) fn mirrored_pairs(skeleton: &Skeleton) -> Vec<Pair> {
    let paths = path_lengths(skeleton);
    let rest = skeleton.rest_pose().positions;
    let joints = skeleton.joints.len();
    // For each joint: its depth, the number of joints below it, and the farthest node below it.
    let mut depths = vec![0; joints];
    let mut children = vec![Vec::new(); joints];
    for (place, joint) in skeleton.joints.iter().enumerate() {
        if let Some(parent) = joint.parent {
            depths[place] = depths[parent] + 1;
            children[parent].push(place);
        }
    }
    let mut farthest: Vec<usize> = (0..joints).collect();
    for (node, end) in skeleton.figure().iter().enumerate().skip(joints) {
        if paths[node] > paths[farthest[end.joint]] {
            farthest[end.joint] = node;
        }
    }
    let mut sizes = vec![1; joints];
    for place in (1..joints).rev() {
        if let Some(parent) = skeleton.joints[place].parent {
            sizes[parent] += sizes[place];
            if paths[farthest[place]] > paths[farthest[parent]] {
                farthest[parent] = farthest[place];
            }
        }
    }
    let mut pairs = Vec::new();
    for parent in 0..joints {
        let reach = |child: usize| paths[farthest[child]] - paths[parent];
        for (i, &a) in children[parent].iter().enumerate() {
            for &b in &children[parent][i + 1..] {
                let (longer, shorter) = (reach(a).max(reach(b)), reach(a).min(reach(b)));
                let tips = [farthest[a], farthest[b]];
                let ends = tips.map(|tip| rest[tip]);
                let alike = sizes[a] == sizes[b] && shorter > 0.9 * longer;
                if alike && (ends[0] - ends[1]).norm() > 0.02 * longer {
                    pairs.push(Pair { members: [a, b], depth: depths[parent], reach: longer, tips, ends });
                }
            }
        }
    }
    pairs
}

fn ancestors(skeleton: &Skeleton, joint: usize) -> impl Iterator<Item = usize> + '_ {
    std::iter::successors(skeleton.joints[joint].parent, |&joint| skeleton.joints[joint].parent)
}

/// Whether a joint is `top` or below it.
pub(crate) fn is_within(skeleton: &Skeleton, joint: usize, top: usize) -> bool {
    joint == top || ancestors(skeleton, joint).any(|ancestor| ancestor == top)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::bvh;

    #[test]
    fn legs_of_clearly_different_lengths_are_no_pair() {
        let body = |y: f64| {
            let joint = "\n{\nCHANNELS 1 Zrotation\nOFFSET 0 0 0\n";
            let leg = |x: i32, y: f64| format!("JOINT a{x}{joint}End Site\n{{\nOFFSET {x} {y} 0\n}}\n}}\n");
            let body = format!("HIERARCHY\nROOT a{joint}{}{}}}\n", leg(1, 9.0), leg(-1, y));
            let text = format!("{body}MOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0\n");
            bvh::read("a.bvh", text.as_bytes()).unwrap().into_clip().skeleton
        };
        assert_eq!([9.0, 8.5, 7.0].map(|y| mirrored_pairs(&body(y)).len()), [1, 1, 0]);
        // Without a pair there is no direction up, and no division by zero.
        assert_eq!([8.5, 7.0].map(|y| Limbs::find(&body(y)).is_some()), [true, false]);
    }
}
