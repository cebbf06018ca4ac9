//! A root that only carries the body: such a root stands still or keeps to the ground, and its child, the
//! hips, moves.
//!
//! Only the root's path enters the model as a path over the ground; every other joint keeps its mean
//! position. So the hips must be the root.

use crate::motion::anatomy::Anatomy;
use crate::motion::clip::Clip;
use crate::motion::rotation;
use crate::motion::skeleton::{Channel, Joint, LocalPose, Skeleton};
use crate::plural::counted;
use nalgebra::{DMatrix, UnitQuaternion};

/// A root stands still when it moves by less than this share of the body's height, and turns by less than
/// this angle (radians).
const STILL: f64 = 1e-3;
/// The only child of a still root is the body's own root when it moves by more than this share of the height:
/// files round positions to about this share. Below a root that moves, bones that stretch move as much, and
/// the limit is `STILL`.
const MOVES: f64 = 1e-5;
/// Where a still root has more children, one of them is the body's own root when it moves by this share of the
/// height. A bone of the body itself never does.
const TRAVELS: f64 = 0.5;

impl Clip {
    /// The clip without a root, or a chain of them, that only carries a child that moves: the child becomes the
    /// root. The world positions of the joints that remain do not change. A warning names the joints.
    pub(super) fn without_carrying_roots(self) -> Clip {
        self.with_carried_root().unwrap_or(self)
    }

    fn with_carried_root(&self) -> Option<Clip> {
        self.with_first_body().or_else(|| self.with_moving_child())
    }

    /// The first of several bodies below one root.
    fn with_first_body(&self) -> Option<Clip> {
        let (root, bodies) = bodies(&self.skeleton)?;
        let mut clip = self.below(bodies[0]);
        let name = |joint: usize| self.skeleton.joints[joint].name.as_str();
        let size = |joint: usize| counted(below(&self.skeleton, joint).len(), "joint");
        clip.bodies = bodies.iter().map(|&body| name(body).to_owned()).collect();
        let others = bodies[1..].iter().map(|&body| format!("{:?} ({})", name(body), size(body)));
        clip.warnings.push(format!(
            "the root {:?} carries {} bodies: {:?} ({}) is read, without {}. To read another, name its root: --root in the \
             terminal, root in Python, Clip.readBody in the npm package",
            name(root),
            bodies.len(),
            name(bodies[0]),
            size(bodies[0]),
            others.collect::<Vec<_>>().join(", ")
        ));
        Some(clip)
    }

    /// The joint and all joints below it, at the same places in the world.
    pub(super) fn below(&self, joint: usize) -> Clip {
        let poses: Vec<LocalPose> = (0..self.frames()).map(|frame| self.local_pose(frame)).collect();
        let (skeleton, values) = self.rooted_at(&below(&self.skeleton, joint), &poses);
        Clip { skeleton, ..self.with_values(values, self.frame_time) }
    }

    fn with_moving_child(&self) -> Option<Clip> {
        let skeleton = &self.skeleton;
        let first_child = carried(skeleton, 0)?;
        if !skeleton.joints[first_child.joint].has_positions() {
            return None;
        }
        let poses: Vec<LocalPose> = (0..self.frames()).map(|frame| self.local_pose(frame)).collect();
        let first = poses.first()?;
        let height = skeleton.height().max(f64::MIN_POSITIVE);
        let farthest = |joint: usize| {
            let moved = poses.iter().map(|pose| (pose.positions[joint] - first.positions[joint]).norm());
            moved.fold(0.0, f64::max) / height
        };
        let turned = |joint: usize| {
            let angle =
                |pose: &LocalPose| rotation::angle_between(&pose.rotations[joint], &first.rotations[joint]);
            poses.iter().map(angle).fold(0.0, f64::max)
        };
        let mut left_out: Vec<&str> = Vec::new();
        let (mut root, mut only) = (0, true);
        let mut next = Some(first_child);
        while let Some(Carried { joint, kept, others }) = next {
            let is_still = farthest(root) <= STILL && turned(root) <= STILL;
            only &= others.is_empty();
            left_out.extend(others.iter().map(|&other| skeleton.joints[other].name.as_str()));
            let enough = match (is_still, only) {
                (true, true) => MOVES,
                (true, false) => TRAVELS,
                (false, true) => STILL,
                (false, false) => return None,
            };
            if farthest(joint) > enough {
                let (skeleton, values) = self.rooted_at(&kept, &poses);
                let mut clip = Clip { skeleton, ..self.with_values(values, self.frame_time) };
                let [root, joint] = [0, joint].map(|joint| self.skeleton.joints[joint].name.as_str());
                clip.warnings.push(warning(root, joint, &left_out));
                return Some(clip);
            }
            if !is_still {
                return None;
            }
            root = joint;
            next = carried(skeleton, joint).filter(|next| skeleton.joints[next.joint].has_positions());
        }
        None
    }

    /// The joints in `kept`, of which the first becomes the root.
    fn rooted_at(&self, kept: &[usize], poses: &[LocalPose]) -> (Skeleton, DMatrix<f64>) {
        let starts = self.skeleton.channel_starts();
        let (old_root, child) = (&self.skeleton.joints[0], &self.skeleton.joints[kept[0]]);
        let channels = root_channels(old_root, child);
        let axes: Vec<usize> =
            channels.iter().filter(|channel| channel.is_rotation()).map(|channel| channel.axis()).collect();
        let mut joints = Vec::with_capacity(kept.len());
        for &place in kept {
            let joint = &self.skeleton.joints[place];
            // Of the kept joints only the first has its parent elsewhere.
            let parent = joint.parent.and_then(|parent| kept.iter().position(|&other| other == parent));
            joints.push(Joint { parent, ..joint.clone() });
        }
        joints[0].channels.clone_from(&channels);
        // A place in the world, which the position channels replace.
        joints[0].offset = [0.0; 3];
        let inner: Vec<usize> = (kept.iter().skip(1))
            .flat_map(|&joint| (starts[joint]..).take(self.skeleton.joints[joint].channels.len()))
            .collect();
        let mut values = DMatrix::zeros(self.frames(), channels.len() + inner.len());
        // From the nearest to the old root.
        let parents = |&joint: &usize| self.skeleton.joints[joint].parent;
        let ancestors: Vec<usize> = std::iter::successors(child.parent, parents).collect();
        // Angles stay as the file has them where no joint above is turned.
        let is_unturned = |pose: &LocalPose| {
            ancestors.iter().all(|&joint| pose.rotations[joint] == UnitQuaternion::identity())
        };
        let keeps_angles = channels == child.channels && poses.iter().all(is_unturned);
        let mut previous = [0.0; 3];
        for (t, pose) in poses.iter().enumerate() {
            let (mut place, mut turned) = (pose.positions[kept[0]], pose.rotations[kept[0]]);
            for &above in &ancestors {
                place = pose.positions[above] + pose.rotations[above] * place;
                turned = pose.rotations[above] * turned;
            }
            previous = rotation::angles_near(&turned, &axes, &previous);
            let mut angles = previous.into_iter();
            for (column, channel) in channels.iter().enumerate() {
                values[(t, column)] = match (channel.is_rotation(), keeps_angles) {
                    (false, _) => place[channel.axis()],
                    (true, true) => self.values[(t, starts[kept[0]] + column)],
                    (true, false) => angles.next().unwrap_or(0.0).to_degrees(),
                };
            }
            for (column, &old) in inner.iter().enumerate() {
                values[(t, channels.len() + column)] = self.values[(t, old)];
            }
        }
        (Skeleton { joints }, values)
    }
}

/// The joint and all joints below it, in their order.
fn below(skeleton: &Skeleton, top: usize) -> Vec<usize> {
    let mut within = vec![false; skeleton.joints.len()];
    for (place, joint) in skeleton.joints.iter().enumerate() {
        within[place] = place == top || joint.parent.is_some_and(|parent| within[parent]);
    }
    (0..within.len()).filter(|&place| within[place]).collect()
}

/// The joint that carries several bodies, each with legs and arms, and the roots of these bodies.
fn bodies(skeleton: &Skeleton) -> Option<(usize, Vec<usize>)> {
    let mut carrier = 0;
    while let [only] = skeleton.children(carrier).collect::<Vec<_>>()[..] {
        carrier = only;
    }
    // A body may have a still root of its own.
    let own_root = |child: usize| {
        let only = |&joint: &usize| match skeleton.children(joint).collect::<Vec<_>>()[..] {
            [only] => Some(only),
            _ => None,
        };
        let mut chain = std::iter::successors(Some(child), only);
        chain.find(|&joint| skeleton.joints[joint].has_positions()).unwrap_or(child)
    };
    let anatomy = |child: usize| {
        let kept = below(skeleton, child);
        let parent = |joint: usize| {
            skeleton.joints[joint].parent.and_then(|parent| kept.iter().position(|&other| other == parent))
        };
        let joint = |&place: &usize| Joint { parent: parent(place), ..skeleton.joints[place].clone() };
        let body = Skeleton { joints: kept.iter().map(joint).collect() };
        // Without a path of its own, only names show a body: the fingers of a hand come in pairs too.
        if skeleton.joints[child].has_positions() { Anatomy::find(&body) } else { Anatomy::named(&body) }
    };
    let roots = skeleton.children(carrier).map(own_root);
    let found: Vec<(usize, Anatomy)> = roots.filter_map(|child| Some((child, anatomy(child)?))).collect();
    // The chest of a body alone has two limbs, and its hips have the other two.
    let whole = found.iter().filter(|(_, anatomy)| anatomy.has_both_arms());
    let bodies: Vec<usize> = whole.map(|(child, _)| *child).collect();
    (bodies.len() > 1).then_some((carrier, bodies))
}

/// The child that carries the body.
struct Carried {
    joint: usize,
    /// The child and all joints below it.
    kept: Vec<usize>,
    /// Its siblings.
    others: Vec<usize>,
}

/// The child of a joint that has the most joints below it, if these are at least half of the joints below
/// `parent`.
fn carried(skeleton: &Skeleton, parent: usize) -> Option<Carried> {
    // For each joint below `parent`, the child of `parent` above it.
    let mut tops: Vec<Option<usize>> = vec![None; skeleton.joints.len()];
    let mut sizes = vec![0; skeleton.joints.len()];
    for (place, joint) in skeleton.joints.iter().enumerate() {
        tops[place] = if joint.parent == Some(parent) {
            Some(place)
        } else {
            joint.parent.and_then(|above| tops[above])
        };
        if let Some(top) = tops[place] {
            sizes[top] += 1;
        }
    }
    let joint = skeleton.children(parent).max_by_key(|&child| sizes[child])?;
    let kept = (0..tops.len()).filter(|&place| tops[place] == Some(joint)).collect();
    let others = skeleton.children(parent).filter(|&other| other != joint).collect();
    (2 * sizes[joint] >= sizes.iter().sum()).then_some(Carried { joint, kept, others })
}

/// The channels of the new root: all six, its own in their order where it has them all.
fn root_channels(old_root: &Joint, child: &Joint) -> Vec<Channel> {
    if child.channels.len() == Channel::ALL.len() {
        return child.channels.clone();
    }
    let rotations = |joint: &Joint| -> Vec<Channel> {
        joint.channels.iter().copied().filter(|channel| channel.is_rotation()).collect()
    };
    let usual = vec![Channel::Zrotation, Channel::Xrotation, Channel::Yrotation];
    let angles = [rotations(child), rotations(old_root), usual].into_iter().find(|angles| angles.len() == 3);
    let positions = Channel::ALL.into_iter().filter(|channel| !channel.is_rotation());
    positions.chain(angles.unwrap_or_default()).collect()
}

fn warning(root: &str, child: &str, others: &[&str]) -> String {
    let text = format!("the root {root:?} only carries {child:?}, which moves: {child:?} is the root now");
    let left_out = match others {
        [] => String::new(),
        [other] => format!(", and {other:?} was left out"),
        [other, ..] => format!(", and {other:?} and {} more were left out", others.len() - 1),
    };
    text + &left_out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::testing::any_clip;
    use crate::motion::{Recording, samples};
    use proptest::prelude::*;

    fn joint(name: &str, parent: Option<usize>, offset: [f64; 3], channels: &[Channel]) -> Joint {
        Joint { name: name.to_owned(), parent, offset, channels: channels.to_vec(), end_sites: Vec::new() }
    }

    /// The clip with a root above its own root that has `channels`, whose values are `pose`; helper bones
    /// `others` hang on the new root.
    fn carried_by(clip: &Clip, channels: &[Channel], pose: &[f64], others: &[&str]) -> Recording {
        let mut joints = vec![joint("Reference", None, [1.0, 2.0, 3.0], channels)];
        for own in &clip.skeleton.joints {
            joints.push(Joint { parent: Some(own.parent.map_or(0, |parent| parent + 1)), ..own.clone() });
        }
        for name in others {
            joints.push(joint(name, Some(0), [5.0, 0.0, 0.0], &[]));
        }
        let columns = channels.len();
        let values = DMatrix::from_fn(clip.frames(), columns + clip.values.ncols(), |t, column| {
            if column < columns { pose[column] } else { clip.values[(t, column - columns)] }
        });
        Recording::new("carried.bvh", Skeleton { joints }, clip.frame_time, values)
    }

    #[test]
    fn a_new_root_has_three_positions_and_the_first_order_of_three_angles() {
        use Channel::{Xposition, Xrotation, Yposition, Yrotation, Zposition, Zrotation};
        let turned = [Yrotation, Xrotation, Zrotation, Yposition];
        let cases: [(&[Channel], &[Channel], [Channel; 3]); 3] = [
            (&turned, &[Zrotation], [Yrotation, Xrotation, Zrotation]),
            (&[Zrotation, Yrotation, Xrotation], &turned, [Yrotation, Xrotation, Zrotation]),
            (&[Yposition], &[Zrotation], [Zrotation, Xrotation, Yrotation]),
        ];
        for (old, own, angles) in cases {
            let [old, own] = [old, own].map(|channels| joint("a", None, [0.0; 3], channels));
            let found = root_channels(&old, &own);
            assert_eq!(found[..3], [Xposition, Yposition, Zposition]);
            assert_eq!(found[3..], angles);
        }
    }

    #[test]
    fn a_still_root_is_folded_into_its_moving_child_to_the_last_digit() {
        let walk = samples::clip("walk-1").unwrap();
        let folded = carried_by(&walk, &Channel::ALL, &[0.0; 6], &[]).into_clip();
        assert_eq!(folded.values, walk.values);
        assert_eq!(folded.skeleton, walk.skeleton);
        let hips = &walk.skeleton.joints[0].name;
        assert_eq!(
            folded.warnings,
            [format!("the root \"Reference\" only carries {hips:?}, which moves: {hips:?} is the root now")]
        );
    }

    #[test]
    fn two_still_roots_are_folded() {
        let walk = samples::clip("walk-1").unwrap();
        let inner = carried_by(&walk, &Channel::ALL, &[7.0, 0.0, 1.0, 0.0, 90.0, 0.0], &[]);
        let inner = Clip::new("inner.bvh", inner.skeleton, inner.frame_time, inner.values);
        let outer = carried_by(&inner, &[], &[], &[]);
        let folded = outer.clone().into_clip();
        assert_eq!(folded.skeleton.joints.len(), walk.skeleton.joints.len());
        let before = outer.skeleton.local_pose(&outer.values, 30);
        let before = outer.skeleton.forward_kinematics(&before.rotations, &before.positions).positions;
        for (old, new) in before[2..].iter().zip(&folded.world_pose(30).positions) {
            assert!((old - new).norm() < 1e-9, "{old} {new}");
        }
    }

    #[test]
    fn helper_bones_beside_hips_that_travel_are_left_out() {
        let walk = samples::clip("walk-1").unwrap();
        let mut carried = carried_by(&walk, &Channel::ALL, &[0.0; 6], &["ik_foot_root", "ik_hand_root"]);
        // A still root may tremble.
        carried.values[(5, 0)] = 1e-4;
        let folded = carried.into_clip();
        assert_eq!(folded.skeleton.joints.len(), walk.skeleton.joints.len());
        assert!(folded.warnings[0].ends_with("\"ik_foot_root\" and 1 more were left out"));
        // On the spot it is not clear which child is the body.
        let mut still = walk.clone();
        for (column, channel) in walk.skeleton.joints[0].channels.iter().enumerate() {
            if !channel.is_rotation() {
                still.values.column_mut(column).fill(1.0);
            }
        }
        let kept = carried_by(&still, &[], &[], &["ik_foot_root"]).into_clip();
        assert_eq!((kept.skeleton.joints.len(), kept.warnings.len()), (walk.skeleton.joints.len() + 2, 0));
    }

    /// The first body of the clip under one root, as often as `names` says.
    fn together(walk: &Clip, names: &[&str]) -> Recording {
        let mut all = carried_by(walk, &[], &[], &[]);
        let single = all.skeleton.joints.split_off(1);
        all.skeleton.joints[0].offset = [0.0; 3];
        let values = all.values.clone();
        all.values = DMatrix::zeros(walk.frames(), 0);
        for (number, prefix) in names.iter().enumerate() {
            let first = all.skeleton.joints.len() - 1;
            all.skeleton.joints.extend(single.iter().map(|own| Joint {
                name: format!("{prefix}{}", own.name),
                parent: own.parent.map(|parent| if parent == 0 { 0 } else { parent + first }),
                ..own.clone()
            }));
            let column = all.values.ncols();
            all.values = all.values.insert_columns(column, values.ncols(), 0.0);
            all.values.columns_mut(column, values.ncols()).copy_from(&values);
            all.values.column_mut(column).add_scalar_mut(100.0 * number as f64);
        }
        all
    }

    #[test]
    fn of_several_bodies_the_first_is_read_and_another_can_be_chosen() {
        let walk = samples::clip("walk-1").unwrap().cut(0, 20).unwrap();
        for names in [&["A:", "B:"][..], &["A:", "B:", "C:"]] {
            let all = together(&walk, names);
            let first = all.clone().into_clip();
            assert!(first.values == walk.values && first.skeleton.joints.len() == 21);
            assert_eq!(first.skeleton.joints[0].name, "A:Hips");
            let [warning] = &first.warnings[..] else { panic!("{:?}", first.warnings) };
            assert!(warning.contains(&format!("carries {} bodies: \"A:Hips\" (21 joints)", names.len())));
            assert!(
                first.bodies.iter().eq(&names.iter().map(|name| format!("{name}Hips")).collect::<Vec<_>>())
            );
            assert!(warning.contains("\"B:Hips\" (21 joints)"), "{warning}");
            let second = all.clone().of_root(Some("B:Hips")).unwrap().into_clip();
            assert_eq!(second.skeleton.joints[0].name, "B:Hips");
            assert!((second.values[(5, 0)] - walk.values[(5, 0)] - 100.0).abs() < 1e-9);
            assert!(second.warnings.is_empty());
            // Each body may have a still root of its own, or no path.
            let mut nested = all.clone();
            let hips = nested.skeleton.joints.iter().position(|joint| joint.name == "B:Hips").unwrap();
            nested.skeleton.joints.iter_mut().skip(hips + 1).for_each(|joint| {
                joint.parent = joint.parent.map(|parent| if parent >= hips { parent + 1 } else { parent });
            });
            nested.skeleton.joints[hips].parent = Some(hips);
            nested.skeleton.joints.insert(hips, joint("B:Reference", Some(0), [0.0; 3], &[]));
            assert_eq!(nested.into_clip().bodies, first.bodies);
            let mut still = all.clone();
            for hips in still.skeleton.joints.iter_mut().filter(|joint| joint.name.ends_with("Hips")) {
                hips.channels.clear();
            }
            still.values = DMatrix::zeros(walk.frames(), still.skeleton.channel_count());
            assert_eq!(still.into_clip().bodies, first.bodies);
            let unknown = all.of_root(Some("D:Hips")).unwrap_err().to_string();
            assert!(unknown.contains("expected the name of a joint, found \"D:Hips\""), "{unknown}");
        }
    }

    /// Some clips of a set have the way in the root, others in the hips: all become the same body.
    #[test]
    fn a_root_that_moves_is_folded_too_if_its_only_child_moves() {
        let walk = samples::clip("walk-1").unwrap();
        for (others, joints) in [(&[][..], 21), (&["ik_foot_root"][..], 23)] {
            let mut recording = carried_by(&walk, &Channel::ALL, &[0.0; 6], others);
            for t in 0..walk.frames() {
                recording.values[(t, 0)] = t as f64;
            }
            let clip = recording.clone().into_clip();
            assert_eq!(clip.skeleton.joints.len(), joints);
            let place = clip.world_pose(50).positions[usize::from(joints > 21)];
            assert!((place.x - walk.world_pose(50).positions[0].x - 50.0).abs() < 1e-9);
        }
        // A child that keeps its place is a bone.
        let mut recording = carried_by(&walk, &Channel::ALL, &[0.0; 6], &[]);
        for t in 0..walk.frames() {
            recording.values[(t, 0)] = t as f64;
            for column in 6..9 {
                recording.values[(t, column)] = 1.0;
            }
        }
        assert_eq!(recording.clone().into_clip().skeleton, recording.skeleton);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Any root pose, any channels of root and child.
        #[test]
        fn folding_changes_no_position_in_the_world(
            clip in any_clip(),
            root in proptest::sample::subsequence(Channel::ALL.to_vec(), 0..=6).prop_shuffle(),
            pose in proptest::array::uniform6(-170.0..170.0_f64),
        ) {
            prop_assume!(clip.frames() > 1);
            let carried = carried_by(&clip, &root, &pose, &[]);
            let before = Clip::new("before", carried.skeleton.clone(), carried.frame_time, carried.values.clone());
            let after = before.clone().without_carrying_roots();
            prop_assert_eq!(after.skeleton.joints.len(), clip.skeleton.joints.len());
            for t in 0..clip.frames() {
                let (before, after) = (before.world_pose(t), after.world_pose(t));
                let joints = clip.skeleton.joints.len();
                let ends = before.positions[joints + 1..].iter();
                let all = before.positions[1..=joints].iter().chain(ends);
                for (old, new) in all.zip(&after.positions) {
                    prop_assert!((old - new).norm() < 1e-9, "{} {}", old, new);
                }
                for (old, new) in before.rotations[1..].iter().zip(&after.rotations) {
                    prop_assert!(old.angle_to(new) < 1e-6);
                }
            }
        }
    }
}
