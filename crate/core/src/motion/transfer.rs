//! A motion transferred to a body with other joints or another rest pose.

use crate::elementary::Elementary;
use crate::motion::anatomy::{Anatomy, standing_at_rest};
use crate::motion::clip::Clip;
use crate::motion::counterparts::counterparts;
use crate::motion::landmarks::facing;
use crate::motion::rotation;
use crate::motion::same_body::BodyMismatch;
use crate::motion::skeleton::{LocalPose, Skeleton};
use crate::motion::stage_axes::UpAxis;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};

impl Clip {
    /// The same motion on the body of another clip, whose joints may have other names and another rest pose.
    ///
    /// Joints correspond by their names. Where both trees have the same shape, joints whose names have no
    /// partner correspond by limb and side, and then by their places. Bones of corresponding joints point in the same direction of the world: both rest poses are first made to stand
    /// and to face the same way, and each joint of the body then gets the rotation of its counterpart. A joint
    /// without a counterpart keeps its angle to its parent. The path of the root is scaled as in [`Clip::with_bones_of`].
    ///
    /// # Errors
    ///
    /// A [`BodyMismatch`]: the first difference of the trees if no more than half of the body's joints have a
    /// counterpart, or a rest pose that does not stand.
    pub fn onto(&self, body: &Clip) -> Result<Clip, BodyMismatch> {
        let sources = counterparts(&body.skeleton, &self.skeleton);
        if 2 * sources.iter().flatten().count() <= body.skeleton.joints.len() {
            body.skeleton.same_joints(&self.skeleton)?;
        }
        let (own_rest, rest) = (upright_rest(self)?, upright_rest(body)?);
        let turned: Vec<UnitQuaternion<f64>> = (0..sources.len())
            .map(|joint| {
                let bone = bone_of(&body.skeleton, &sources, joint);
                let turn = bone.and_then(|end| {
                    let own = direction(&self.skeleton, sources[joint]?, sources[end]?);
                    UnitQuaternion::rotation_between(
                        &(rest * direction(&body.skeleton, joint, end)),
                        &(own_rest * own),
                    )
                });
                turn.unwrap_or_default() * rest
            })
            .collect();

        let (from, to) = (self.up_axis().to_y_up(), body.up_axis().to_y_up().inverse());
        let mut clip = self.clone();
        clip.skeleton.clone_from(&body.skeleton);
        (clip.up, clip.found_up) = (body.up, Some(body.up_axis()));
        let poses: Vec<LocalPose> = (0..self.frames())
            .map(|frame| {
                let own = self.world_pose(frame);
                let mut world: Vec<UnitQuaternion<f64>> = Vec::with_capacity(sources.len());
                let mut pose = LocalPose::default();
                for (joint, body) in body.skeleton.joints.iter().enumerate() {
                    let parent = body.parent.map_or_else(UnitQuaternion::identity, |parent| world[parent]);
                    let turn = sources[joint].map_or(parent, |source| {
                        to * from * own.rotations[source] * own_rest.inverse() * turned[joint]
                    });
                    world.push(turn);
                    pose.rotations.push(parent.inverse() * turn);
                    pose.positions.push(body.offset.into());
                }
                pose.positions[0] = to * from * own.positions[0];
                pose
            })
            .collect();
        clip.values = values_of(&clip.skeleton, &poses);
        let scale = clip.root_scale(self);
        for (column, channel) in clip.skeleton.joints[0].channels.iter().enumerate() {
            if !channel.is_rotation() {
                clip.values.column_mut(column).apply(|value| *value *= scale);
            }
        }
        clip.name_bones(body, scale);
        Ok(clip)
    }
}

/// The joint at the end of the bone that leaves a joint: the next joint with a counterpart and another place.
/// `None` where several bones leave the joint.
fn bone_of(skeleton: &Skeleton, sources: &[Option<usize>], joint: usize) -> Option<usize> {
    let mut ends = Vec::new();
    let mut next: Vec<usize> = skeleton.children(joint).collect();
    while let Some(child) = next.pop() {
        if sources[child].is_some() && direction(skeleton, joint, child).norm() > 1e-6 * skeleton.height() {
            ends.push(child);
        } else {
            next.extend(skeleton.children(child));
        }
    }
    if let [end] = ends[..] { Some(end) } else { None }
}

/// The vector from one joint to another in the rest pose.
fn direction(skeleton: &Skeleton, from: usize, to: usize) -> Vector3<f64> {
    let rest = skeleton.rest_pose().positions;
    rest[to] - rest[from]
}

/// The rotation that makes the rest pose stand with y up and face z.
fn upright_rest(clip: &Clip) -> Result<UnitQuaternion<f64>, BodyMismatch> {
    let skeleton = &clip.skeleton;
    let standing = Anatomy::find(skeleton).and_then(|anatomy| standing_at_rest(skeleton, &anatomy));
    let turned = standing.and_then(|upward| {
        let upright = UpAxis::along(&upward).to_y_up();
        let places: Vec<f32> = (skeleton.rest_pose().positions.iter())
            .flat_map(|place| <[f64; 3]>::from(upright * place).map(|x| x as f32))
            .collect();
        let forward = facing(skeleton, &places)?;
        Some(rotation::about_axis(1, -forward.x.arctangent(forward.z)) * upright)
    });
    turned.ok_or_else(|| BodyMismatch::Rest { name: clip.name.clone() })
}

/// The channel values [frames x channels] of poses; angles are continuous in time.
fn values_of(skeleton: &Skeleton, poses: &[LocalPose]) -> DMatrix<f64> {
    let axes: Vec<Vec<usize>> = skeleton.joints.iter().map(|joint| joint.rotation_axes().collect()).collect();
    let mut previous = vec![[0.0; 3]; skeleton.joints.len()];
    let mut values = DMatrix::zeros(poses.len(), skeleton.channel_count());
    for (frame, pose) in poses.iter().enumerate() {
        let mut column = 0;
        for (place, joint) in skeleton.joints.iter().enumerate() {
            previous[place] = rotation::angles_near(&pose.rotations[place], &axes[place], &previous[place]);
            let mut angles = previous[place].into_iter();
            for channel in &joint.channels {
                values[(frame, column)] = if channel.is_rotation() {
                    angles.next().unwrap_or(0.0).to_degrees()
                } else {
                    pose.positions[place][channel.axis()]
                };
                column += 1;
            }
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::samples;

    /// The largest distance in metres between the joints of two clips of bodies with equally many joints.
    fn apart(a: &Clip, b: &Clip) -> f64 {
        let joints = a.skeleton.joints.len();
        let places = |clip: &Clip| -> Vec<f32> {
            let width = 3 * clip.skeleton.node_count();
            clip.stage_positions().chunks(width).flat_map(|frame| frame[..3 * joints].to_vec()).collect()
        };
        let pairs = places(a).into_iter().zip(places(b));
        pairs.map(|(x, y)| f64::from((x - y).abs())).fold(0.0, f64::max)
    }

    fn turn_offsets(clip: &mut Clip, turn: UnitQuaternion<f64>, wanted: impl Fn(&str) -> bool) {
        for joint in &mut clip.skeleton.joints {
            if wanted(&joint.name) {
                joint.offset = (turn * Vector3::from(joint.offset)).into();
                joint.end_sites.iter_mut().for_each(|end| *end = (turn * Vector3::from(*end)).into());
            }
        }
    }

    #[test]
    fn bones_point_the_same_way_from_another_rest_pose_with_other_names() {
        let walk = samples::clip("walk-1").unwrap().cut(0, 60).unwrap();
        let mut body = walk.clone();
        // Arms that hang at rest instead of pointing to the side, and the other way round.
        let quarter = rotation::about_axis(2, -std::f64::consts::FRAC_PI_2);
        turn_offsets(&mut body, quarter, |name| name == "LeftForeArm" || name == "LeftHand");
        turn_offsets(&mut body, quarter.inverse(), |name| name == "RightForeArm" || name == "RightHand");
        for joint in &mut body.skeleton.joints {
            joint.name = joint.name.replace("ForeArm", "Elbow");
        }
        assert!(apart(&walk, &Clip { values: walk.values.clone(), ..body.clone() }) > 0.2);
        let moved = walk.onto(&body).unwrap();
        assert_eq!(moved.skeleton, body.skeleton);
        assert!(apart(&walk, &moved) < 1e-3, "{}", apart(&walk, &moved));
        assert!(moved.warnings.iter().any(|warning| warning.contains(&body.name)));
    }

    #[test]
    fn another_axis_points_up_and_a_joint_without_a_counterpart_stays() {
        let mut walk = samples::clip("walk-1").unwrap().cut(0, 60).unwrap();
        walk.found_up = Some(UpAxis::Y);
        let mut body = walk.clone();
        turn_offsets(&mut body, rotation::about_axis(0, std::f64::consts::FRAC_PI_2), |_| true);
        body.found_up = Some(UpAxis::Z);
        let moved = walk.onto(&body).unwrap();
        assert_eq!(moved.up_axis(), UpAxis::Z);
        assert!(apart(&walk, &moved) < 1e-3, "{}", apart(&walk, &moved));

        // A tail, so that the joints correspond by their names.
        let mut tail = body.skeleton.joints[0].clone();
        (tail.name, tail.parent, tail.offset) = ("Tail".to_owned(), Some(0), [0.0, 3.0, 0.0]);
        tail.channels.retain(|channel| channel.is_rotation());
        body.skeleton.joints.push(tail);
        body.values = body.values.clone().insert_columns(walk.skeleton.channel_count(), 3, 0.0);
        let moved = walk.onto(&body).unwrap();
        assert!(apart(&walk, &moved) < 1e-3, "{}", apart(&walk, &moved));
        let tail = body.skeleton.joints.len() - 1;
        assert!(rotation::log(&moved.local_pose(30).rotations[tail]).norm() < 1e-6);
    }

    #[test]
    fn a_body_without_counterparts_or_without_a_standing_rest_pose_is_refused() {
        let walk = samples::clip("walk-1").unwrap().cut(0, 10).unwrap();
        let mut strange = walk.clone();
        for (place, joint) in strange.skeleton.joints.iter_mut().enumerate().skip(1) {
            joint.name = format!("bone {place}");
        }
        strange.skeleton.joints.pop();
        assert!(matches!(walk.onto(&strange), Err(BodyMismatch::JointCount { .. })));
        let mut folded = walk.clone();
        for joint in folded.skeleton.joints.iter_mut().skip(1) {
            joint.offset = [Vector3::from(joint.offset).norm(), 0.0, 0.0];
        }
        let refused = walk.onto(&folded).unwrap_err();
        assert!(refused.to_string().contains("expected a rest pose that stands"), "{refused}");
    }

    #[test]
    fn a_bone_ends_at_the_next_joint_with_a_counterpart() {
        let walk = samples::clip("walk-1").unwrap().skeleton;
        let place = |name: &str| walk.joints.iter().position(|joint| joint.name == name).unwrap();
        let [thigh, shin, foot] = ["LeftUpLeg", "LeftLeg", "LeftFoot"].map(place);
        let mut sources: Vec<Option<usize>> = (0..walk.joints.len()).map(Some).collect();
        assert_eq!(bone_of(&walk, &sources, thigh), Some(shin));
        sources[shin] = None;
        assert_eq!(bone_of(&walk, &sources, thigh), Some(foot));
    }
}
