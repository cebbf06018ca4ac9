//! A motion transferred to a body with other bones.

use crate::motion::clip::Clip;
use crate::motion::same_body::BodyMismatch;
use nalgebra::Vector3;

impl Clip {
    /// The same motion of a body with the bones of `other`, whose joints must have the same names in the same
    /// tree.
    ///
    /// The joint angles do not change. The path of the root is scaled by the ratio of the mean heights of the
    /// root above the lowest point of the body: this accounts for other legs and other units. Standing feet
    /// therefore stay on the ground, except for small errors where thigh and shin have other proportions. A
    /// clip of the same body is returned unchanged; any other clip gets a warning that says what was done.
    ///
    /// # Errors
    ///
    /// A [`BodyMismatch`] that names the first joint that differs in its name or its place in the tree.
    pub fn with_bones_of(&self, other: &Clip) -> Result<Clip, BodyMismatch> {
        let own = &*self.in_order_of(&other.skeleton);
        other.skeleton.same_joints(&own.skeleton)?;
        if other.skeleton.same_body(&own.skeleton).is_ok() {
            return Ok(self.clone());
        }
        let mut clip = own.clone();
        for (joint, model) in clip.skeleton.joints.iter_mut().zip(&other.skeleton.joints) {
            joint.end_sites.clone_from(&model.end_sites);
            // The root's offset is a place in the world, not a bone.
            if joint.parent.is_some() {
                joint.offset = model.offset;
            }
        }
        let scale = clip.root_scale(own);
        let mut column = 0;
        for (joint, own) in clip.skeleton.joints.iter_mut().zip(&own.skeleton.joints) {
            if joint.parent.is_none() {
                joint.offset = own.offset.map(|place| scale * place);
            }
            for channel in &own.channels {
                if !channel.is_rotation() {
                    // A position replaces the offset; the difference between the two is a movement.
                    let (from, to) = (own.offset[channel.axis()], joint.offset[channel.axis()]);
                    clip.values.column_mut(column).apply(|value| *value = to + scale * (*value - from));
                }
                column += 1;
            }
        }
        clip.name_bones(other, scale);
        Ok(clip)
    }

    /// The ratio of the mean height of the root to that of `own`, the same motion of another body.
    pub(crate) fn root_scale(&self, own: &Clip) -> f64 {
        let (before, after) = (own.root_height(), self.root_height());
        if before > 0.0 && after > 0.0 { after / before } else { 1.0 }
    }

    /// Notes whose bones the clip has.
    pub(crate) fn name_bones(&mut self, other: &Clip, scale: f64) {
        // Formatting with a fixed number of digits would add code to the wasm that nothing else needs.
        let rounded = (1000.0 * scale).round() / 1000.0;
        let first = &other.name;
        self.bones_of = Some(first.clone());
        self.warnings
            .push(format!("The bones are those of {first}; the way of the root is scaled by {rounded}"));
    }

    /// Mean height of the root above the lowest point of the body whose bones have their offsets, in file
    /// units.
    fn root_height(&self) -> f64 {
        let up = self.up_axis().to_y_up();
        let bones = &self.skeleton;
        let offsets: Vec<Vector3<f64>> = bones.joints.iter().map(|joint| joint.offset.into()).collect();
        let mut sum = 0.0;
        for frame in 0..self.frames() {
            let rotations = self.local_pose(frame).rotations;
            let places = bones.forward_kinematics(&rotations, &offsets).positions;
            let height = |place: &Vector3<f64>| (up * place).y;
            sum += height(&places[0]) - places.iter().map(height).fold(f64::INFINITY, f64::min);
        }
        sum / self.frames().max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{samples, stage::STAGE_HEIGHT};

    /// The walk of another body in other units. The factors scale its thighs, shins and arms.
    fn other_body(walk: &Clip, thigh: f64, shin: f64, arm: f64, unit: f64) -> Clip {
        let mut other = walk.clone();
        for joint in &mut other.skeleton.joints {
            let name = joint.name.to_lowercase();
            let factor = if name.contains("foot") {
                shin
            } else if name.contains("leg") && !name.contains("up") {
                thigh
            } else if name.contains("arm") || name.contains("hand") {
                arm
            } else {
                1.0
            };
            joint.offset = joint.offset.map(|x| unit * factor * x);
            joint.end_sites.iter_mut().for_each(|end| *end = end.map(|x| unit * x));
        }
        other.name = "other.bvh".to_owned();
        other
    }

    /// The lowest point of the body in each frame, in metres above the ground of the whole clip.
    fn lowest(clip: &Clip) -> Vec<f64> {
        let stage = clip.stage();
        assert!((stage.metres_per_unit() * stage.height - STAGE_HEIGHT).abs() < 1e-9);
        let nodes = clip.skeleton.figure().len();
        let heights: Vec<f64> = clip.stage_positions().chunks(3).map(|place| f64::from(place[1])).collect();
        heights.chunks(nodes).map(|frame| frame.iter().copied().fold(f64::INFINITY, f64::min)).collect()
    }

    #[test]
    fn angles_stay_and_feet_stay_on_the_ground() {
        let walk = samples::clip("walk-1").unwrap();
        for (thigh, shin, arm, unit) in [(1.1, 1.06, 0.9, 1.0), (0.92, 0.95, 1.1, 2.54)] {
            let other = other_body(&walk, thigh, shin, arm, unit);
            let moved = walk.with_bones_of(&other).unwrap();
            assert_eq!(other.skeleton.same_body(&moved.skeleton), Ok(()));
            for frame in 0..walk.frames() {
                assert_eq!(moved.local_pose(frame).rotations, walk.local_pose(frame).rotations);
            }
            for (after, before) in lowest(&moved).iter().zip(lowest(&walk)) {
                assert!((after - before).abs() < 0.01, "{after} {before}");
            }
            // Longer legs take longer steps.
            let way = |clip: &Clip| {
                let root = |frame| clip.world_pose(frame).positions[0];
                (root(clip.frames() - 1) - root(0)).norm()
            };
            let longer = way(&moved) / way(&walk) / unit;
            assert!(longer > thigh.min(shin) - 0.03 && longer < thigh.max(shin) + 0.03, "{longer}");
            assert!(
                moved.warnings.iter().any(|warning| warning.contains("other.bvh")),
                "{:?}",
                moved.warnings
            );
        }
    }

    #[test]
    fn a_clip_of_the_same_body_is_unchanged_and_other_joints_are_refused() {
        let walk = samples::clip("walk-1").unwrap();
        assert_eq!(walk.with_bones_of(&samples::clip("walk-2").unwrap()).unwrap(), walk);
        let mut other = other_body(&walk, 1.1, 1.1, 1.0, 1.0);
        other.skeleton.joints[3].name = "tail".to_owned();
        let refused = walk.with_bones_of(&other).unwrap_err();
        assert!(matches!(refused, BodyMismatch::Name { joint: 3, .. }), "{refused}");
    }

    #[test]
    fn position_channels_move_with_the_new_offset() {
        let mut walk = samples::clip("walk-1").unwrap().cut(0, 20).unwrap();
        let last = walk.skeleton.joints.len() - 1;
        walk.skeleton.joints[last].channels.insert(0, crate::motion::skeleton::Channel::Xposition);
        let place = walk.skeleton.channel_starts()[last];
        let own = walk.skeleton.joints[last].offset[0];
        walk.values = walk.values.clone().insert_column(place, own);
        let other = other_body(&walk, 1.1, 1.1, 0.8, 1.0);
        let moved = walk.with_bones_of(&other).unwrap();
        let positions = moved.values.column(place);
        assert!(positions.iter().all(|value| (value - other.skeleton.joints[last].offset[0]).abs() < 1e-9));
    }
}
