//! Bones whose OFFSETs and position channels disagree: which of the two the file means.

use crate::motion::anatomy::{Anatomy, Region};
use crate::motion::clip::Clip;
use crate::motion::joint_names::Side;
use crate::plural::listed;
use nalgebra::Vector3;

/// Position channels that stay within this share of their OFFSET from 0 are displacements from the OFFSET.
const NEAR_ZERO: f64 = 0.05;
/// A bone of the frames differs from its OFFSET by more than this share of the longer of the two,
const OTHER_BONE: f64 = 0.3;
/// and by more than this share of the longest bone.
const CLEAR: f64 = 0.05;
/// A joint whose place varies by a larger share of its distance from its parent is no bone.
const STEADY: f64 = 0.3;
/// Bones whose lengths have a common ratio to their OFFSETs, up to this share, are in other units.
const SAME_RATIO: f64 = 0.05;

/// A joint below the root that has position channels.
struct Placed {
    joint: usize,
    /// The median of its place over the frames, in its parent's frame.
    place: Vector3<f64>,
    offset: Vector3<f64>,
    is_near_zero: bool,
}

impl Placed {
    fn longer(&self) -> f64 {
        self.place.norm().max(self.offset.norm())
    }
}

impl Clip {
    /// The clip with bones that its frames really have: an OFFSET that the position channels clearly replace
    /// becomes the median of these channels, and position channels at 0 get their OFFSET. Warnings name the
    /// joints. A file whose position channels repeat the OFFSETs stays as it is.
    pub(super) fn with_recorded_bones(mut self) -> Clip {
        let placed = self.placed_joints();
        let offsets = self.skeleton.joints.iter().skip(1).map(|joint| Vector3::from(joint.offset).norm());
        let longest = placed.iter().map(Placed::longer).chain(offsets).fold(0.0, f64::max);
        let differs = |bone: &&Placed| {
            let difference = (bone.place - bone.offset).norm();
            difference > CLEAR * longest && difference > OTHER_BONE * bone.longer()
        };
        let (at_zero, others): (Vec<&Placed>, Vec<&Placed>) =
            (placed.iter().filter(differs)).partition(|bone| bone.is_near_zero);
        // Where the OFFSETs mean nothing, a joint at 0 is at the place of its parent.
        let agreeing = placed.iter().filter(|bone| !differs(bone) && bone.longer() > 0.0).count();
        if !at_zero.is_empty() && others.len() <= agreeing {
            self.add_offsets(&at_zero);
        }
        if !others.is_empty() {
            self.replace_offsets(&others);
        }
        self
    }

    /// The joints that are bones and have position channels.
    fn placed_joints(&self) -> Vec<Placed> {
        let mut placed = Vec::new();
        let starts = self.skeleton.channel_starts();
        // A joint that carries legs and arms is the body's own root rather than a bone.
        let mut carries_all = vec![true; self.skeleton.joints.len()];
        if let Some(anatomy) = Anatomy::find(&self.skeleton) {
            for limb in [Side::Left, Side::Right].into_iter().flat_map(|s| [Region::Leg(s), Region::Arm(s)]) {
                let bearing = anatomy.bearing(&self.skeleton, limb);
                let exists = bearing.contains(&true);
                carries_all.iter_mut().zip(bearing).for_each(|(all, bears)| *all &= bears || !exists);
            }
        } else {
            let is_only = self.skeleton.children(0).nth(1).is_none();
            carries_all.iter_mut().enumerate().for_each(|(place, all)| *all = place == 1 && is_only);
        }
        for (place, joint) in self.skeleton.joints.iter().enumerate().skip(1) {
            if self.frames() == 0 || !joint.has_positions() || carries_all[place] {
                continue;
            }
            let offset = Vector3::from(joint.offset);
            let (mut median, mut largest, mut spread) = (offset, 0.0_f64, 0.0_f64);
            for (column, channel) in (starts[place]..).zip(&joint.channels) {
                if !channel.is_rotation() {
                    let mut values: Vec<f64> = self.values.column(column).iter().copied().collect();
                    values.sort_unstable_by(f64::total_cmp);
                    let (low, high) = (values[0], values[values.len() - 1]);
                    median[channel.axis()] = values[values.len() / 2];
                    largest = largest.max(-low).max(high);
                    spread = spread.max(high - low);
                }
            }
            let is_near_zero = joint.is_placed() && largest <= NEAR_ZERO * offset.norm();
            if is_near_zero || spread <= STEADY * median.norm() {
                placed.push(Placed { joint: place, place: median, offset, is_near_zero });
            }
        }
        placed
    }

    fn add_offsets(&mut self, bones: &[&Placed]) {
        let starts = self.skeleton.channel_starts();
        for bone in bones {
            let joint = &self.skeleton.joints[bone.joint];
            for (column, channel) in (starts[bone.joint]..).zip(&joint.channels) {
                if !channel.is_rotation() {
                    self.values.column_mut(column).add_scalar_mut(joint.offset[channel.axis()]);
                }
            }
        }
        let names = self.names_of(bones);
        self.warnings.push(format!(
            "the position channels of {names} stay near 0, which would put these joints into their parents: \
             their OFFSETs are used"
        ));
    }

    fn replace_offsets(&mut self, bones: &[&Placed]) {
        for bone in bones {
            self.skeleton.joints[bone.joint].offset = bone.place.into();
        }
        let mut ratios: Vec<f64> = (bones.iter())
            .filter(|bone| bone.offset.norm() > 0.0)
            .map(|bone| bone.place.norm() / bone.offset.norm())
            .collect();
        ratios.sort_unstable_by(f64::total_cmp);
        let ratio = ratios.get(ratios.len() / 2).copied().unwrap_or(1.0);
        let is_common = |other: &f64| (other / ratio - 1.0).abs() < SAME_RATIO;
        let other_units = 2 * ratios.iter().filter(|other| is_common(other)).count() > bones.len();
        if other_units {
            for bone in bones {
                let ends = &mut self.skeleton.joints[bone.joint].end_sites;
                ends.iter_mut().for_each(|end| *end = end.map(|x| ratio * x));
            }
        }
        let names = self.names_of(bones);
        let units = if other_units {
            format!("; the bones are {} times as long as the OFFSETs", (100.0 * ratio).round() / 100.0)
        } else {
            String::new()
        };
        self.warnings.push(format!(
            "the OFFSETs of {names} are not the bones of the frames: the position channels count{units}"
        ));
    }

    fn names_of(&self, bones: &[&Placed]) -> String {
        listed(bones.iter().map(|bone| self.skeleton.joints[bone.joint].name.as_str()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::skeleton::{Channel, Joint};
    use crate::motion::{Recording, samples};

    /// A walk whose joints have position channels that repeat their OFFSETs.
    fn walk() -> Clip {
        let walk = samples::clip("walk-1").unwrap().cut(0, 60).unwrap();
        let mut placed = walk.clone();
        let mut column = walk.skeleton.joints[0].channels.len();
        for (joint, own) in placed.skeleton.joints.iter_mut().zip(&walk.skeleton.joints).skip(1) {
            for axis in 0..3 {
                joint.channels.insert(axis, Channel::ALL[axis]);
                placed.values = placed.values.insert_column(column + axis, own.offset[axis]);
            }
            column += joint.channels.len();
        }
        placed
    }

    fn read(clip: Clip) -> Clip {
        Recording::new("walk.bvh", clip.skeleton, clip.frame_time, clip.values).into_clip()
    }

    /// Changes the OFFSET and the position channels of some joints by factors.
    fn scaled(mut clip: Clip, offset: f64, channels: f64, wanted: impl Fn(&str) -> bool) -> Clip {
        let starts = clip.skeleton.channel_starts();
        for (place, joint) in clip.skeleton.joints.iter_mut().enumerate().skip(1) {
            if wanted(&joint.name) {
                joint.offset = joint.offset.map(|x| offset * x);
                joint.end_sites.iter_mut().for_each(|end| *end = end.map(|x| offset.max(0.01) * x));
                for axis in 0..3 {
                    clip.values.column_mut(starts[place] + axis).apply(|x| *x *= channels);
                }
            }
        }
        clip
    }

    #[test]
    fn position_channels_that_repeat_the_offsets_change_nothing() {
        let clip = walk();
        let again = read(clip.clone());
        assert_eq!((again.skeleton, again.values, again.warnings), (clip.skeleton, clip.values, Vec::new()));
    }

    #[test]
    fn the_frames_decide_how_tall_the_body_is() {
        let height = walk().height();
        for (offset, legs_only) in [(0.0, false), (0.0, true), (0.01, false), (0.01, true), (2.54, false)] {
            let wanted = |name: &str| !legs_only || name.contains("Leg") || name.contains("Foot");
            let clip = read(scaled(walk(), offset, 1.0, wanted));
            let ratio = clip.height() / height;
            assert!((0.85..1.02).contains(&ratio), "{offset} {legs_only}: {ratio}");
            let [warning] = &clip.warnings[..] else { panic!("{:?}", clip.warnings) };
            assert!(warning.contains("OFFSETs of \"Left"), "{warning}");
            assert_eq!(warning.contains("times as long"), offset > 0.0, "{warning}");
        }
    }

    #[test]
    fn joints_at_zero_get_their_offsets() {
        let clip = walk();
        for (factor, hands_only) in [(0.0, false), (0.0, true), (1e-3, false)] {
            let wanted = |name: &str| !hands_only || name.contains("Hand");
            let read = read(scaled(clip.clone(), 1.0, factor, wanted));
            let apart = |t: usize| {
                let pairs = clip.world_pose(t).positions.into_iter().zip(read.world_pose(t).positions);
                pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
            };
            assert!(apart(30) < 0.01 * clip.height(), "{}", apart(30));
            assert!(read.warnings[0].contains("stay near 0"), "{:?}", read.warnings);
        }
    }

    #[test]
    fn bones_that_are_a_quarter_shorter_are_left_as_they_are() {
        let clip = scaled(walk(), 1.0, 0.74, |_| true);
        let again = read(clip.clone());
        assert_eq!((again.skeleton, again.values, again.warnings), (clip.skeleton, clip.values, Vec::new()));
    }

    #[test]
    fn hips_below_a_root_that_stays_are_no_bone() {
        let stand = samples::clip("stand-wave-1").unwrap();
        let mut clip = stand.clone();
        (0..3).for_each(|axis| clip.values.column_mut(axis).fill(stand.values[(0, axis)]));
        for joint in &mut clip.skeleton.joints {
            joint.parent = joint.parent.map(|parent| parent + 1);
        }
        clip.skeleton.joints[0].parent = Some(0);
        let root =
            Joint { name: "Reference".to_owned(), channels: Vec::new(), ..stand.skeleton.joints[0].clone() };
        clip.skeleton.joints.insert(0, root);
        assert_eq!(read(clip).warnings, [""; 0]);
    }
}
