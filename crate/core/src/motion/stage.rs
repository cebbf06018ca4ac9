//! The stage: the world in which bodies are shown, in metres, with y up, the ground at y = 0 and every body
//! 1.7 m tall.

use crate::motion::anatomy::{Anatomy, standing_at_rest};
use crate::motion::clip::Clip;
use crate::motion::limbs::extents;
use crate::motion::period::upper_end;
pub use crate::motion::stage_axes::UpAxis;
use nalgebra::Vector3;

/// The height of every body on the stage, in metres.
pub const STAGE_HEIGHT: f64 = 1.7;

/// The quantities that bring a clip to the stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// The axis that points up in the file.
    pub up: UpAxis,
    /// Height of the body in file units.
    pub height: f64,
    /// Height of the ground in file units: the lowest point of the body in the clip.
    pub ground: f64,
}

impl Stage {
    /// Metres on the stage for one file unit.
    pub fn metres_per_unit(&self) -> f64 {
        STAGE_HEIGHT / self.height
    }

    /// The stage coordinates [x, y, z] of a point with y up in file units.
    pub(crate) fn place(&self, y_up: &Vector3<f64>) -> [f32; 3] {
        let scale = self.metres_per_unit();
        [(y_up.x * scale) as f32, ((y_up.y - self.ground) * scale) as f32, (y_up.z * scale) as f32]
    }
}

impl Clip {
    /// The up axis, the height of the body and the ground.
    pub fn stage(&self) -> Stage {
        let up = self.up_axis();
        let ground = ground(self.places().iter().map(|place| up.height(place)));
        Stage { up, height: self.height_along(up), ground }
    }

    /// The places of all nodes in all frames, in file units.
    fn places(&self) -> Vec<Vector3<f64>> {
        (0..self.frames()).flat_map(|frame| self.world_pose(frame).positions).collect()
    }

    /// The body's height in file units: see [`Skeleton::height`](crate::motion::skeleton::Skeleton::height);
    /// for a skeleton whose rest pose does not stand, the 95th percentile of the height of the body without
    /// its arms over the frames.
    pub fn height(&self) -> f64 {
        self.height_along(self.up_axis())
    }

    /// Stage positions of the figure's nodes [frames x nodes x 3]: y up, metres, the body 1.7 m tall, its
    /// lowest point over the clip at y = 0.
    pub fn stage_positions(&self) -> Vec<f32> {
        self.positions_along(self.up_axis())
    }

    /// [`stage_positions`](Self::stage_positions) of a clip in which this axis points up. It contains no code that
    /// searches for the axis.
    pub fn positions_along(&self, up: UpAxis) -> Vec<f32> {
        let places = self.places();
        let ground = ground(places.iter().map(|place| up.height(place)));
        let (stage, turn) = (Stage { up, height: self.height_along(up), ground }, up.to_y_up());
        places.iter().flat_map(|place| stage.place(&(turn * place))).collect()
    }

    /// [`height`](Self::height) of a clip in which this axis points up.
    pub fn height_along(&self, up: UpAxis) -> f64 {
        let height = match Anatomy::find(&self.skeleton) {
            Some(anatomy) if self.frames() > 0 && standing_at_rest(&self.skeleton, &anatomy).is_none() => {
                let turn = up.to_y_up();
                let extent = |frame| {
                    let body = anatomy.without_arms(&self.skeleton, &self.world_pose(frame).positions);
                    extents(&body.iter().map(|place| turn * place).collect::<Vec<_>>()).y
                };
                upper_end((0..self.frames()).map(extent).collect()).0
            }
            _ => self.skeleton.height(),
        };
        // A single joint has no height; a positive number avoids a division by zero.
        if height > 1e-9 { height } else { 1.0 }
    }
}

/// The lowest of all heights.
fn ground(heights: impl Iterator<Item = f64>) -> f64 {
    let lowest = heights.fold(f64::INFINITY, f64::min);
    if lowest.is_finite() { lowest } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::skeleton::{Channel, Joint, Skeleton};
    use crate::motion::{rotation, samples};
    use nalgebra::{DMatrix, UnitQuaternion};
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn positions_along_the_axis_that_is_found_are_the_same() {
        for clip in clips() {
            assert_eq!(clip.up_axis(), UpAxis::Y);
            assert_eq!(clip.positions_along(UpAxis::Y), clip.stage_positions());
            let turned =
                in_other_world(&clip, UnitQuaternion::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2));
            assert_eq!(turned.positions_along(turned.up_axis()), turned.stage_positions());
        }
    }

    /// The sample clips, whose axis has to be found.
    fn clips() -> Vec<Clip> {
        let clip = |id| Clip { found_up: None, ..samples::clip(id).unwrap() };
        samples::list().iter().map(|info| clip(info.id)).collect()
    }

    /// A sample clip whose world is turned.
    fn in_other_world(clip: &Clip, turn: UnitQuaternion<f64>) -> Clip {
        let mut clip = clip.clone();
        let channels = clip.skeleton.joints[0].channels.clone();
        let axes: Vec<usize> = clip.skeleton.joints[0].rotation_axes().collect();
        for t in 0..clip.frames() {
            let pose = clip.local_pose(t);
            let place = turn * pose.positions[0];
            let angles = rotation::angles_near(&(turn * pose.rotations[0]), &axes, &[0.0; 3]);
            let mut angles = angles.into_iter();
            for (column, channel) in channels.iter().enumerate() {
                clip.values[(t, column)] = if channel.is_rotation() {
                    angles.next().unwrap().to_degrees()
                } else {
                    place[channel.axis()]
                };
            }
        }
        clip
    }

    #[test]
    fn every_up_axis_is_found_and_gives_the_same_positions() {
        let clip = &clips()[0];
        let upright = clip.stage_positions();
        assert_eq!(clip.up_axis(), UpAxis::Y);
        for up in [UpAxis::X, UpAxis::Y, UpAxis::Z, UpAxis::MinusX, UpAxis::MinusY, UpAxis::MinusZ] {
            let turned = in_other_world(clip, up.to_y_up().inverse());
            assert_eq!(turned.up_axis(), up);
            for (a, b) in turned.stage_positions().iter().zip(&upright) {
                assert!((a - b).abs() < 1e-5, "{up:?}");
            }
        }
    }

    #[test]
    fn the_body_stands_or_sits_on_the_ground_and_is_1_7_m_tall() {
        for clip in clips() {
            let nodes = clip.skeleton.figure().len();
            let places = clip.stage_positions();
            assert_eq!(places.len(), clip.frames() * nodes * 3);
            let heights: Vec<f32> = places.chunks_exact(3).map(|place| place[1]).collect();
            let low = heights.iter().copied().fold(f32::INFINITY, f32::min);
            assert!(low.abs() < 1e-6, "{low}");
            for frame in heights.chunks_exact(nodes) {
                let top = frame[..clip.skeleton.joints.len()].iter().copied().fold(0.0, f32::max);
                let expected = if clip.name.starts_with("bottle") { 1.0..1.3 } else { 1.3..1.9 };
                assert!(expected.contains(&top), "{}: {top}", clip.name);
            }
        }
    }

    #[test]
    fn a_body_lying_on_the_ground_does_not_turn_the_world() {
        let mut clip = in_other_world(&clips()[0], rotation::about_axis(0, FRAC_PI_2));
        // Somewhere on the ground of a world with y up, on its front, on the spot.
        for (column, channel) in clip.skeleton.joints[0].channels.iter().enumerate() {
            if !channel.is_rotation() {
                clip.values.column_mut(column).fill(0.0);
            }
        }
        let stage = clip.stage();
        let columns = clip.skeleton.joints[0]
            .channels
            .iter()
            .position(|channel| *channel == crate::motion::skeleton::Channel::Zposition);
        clip.values.column_mut(columns.unwrap()).add_scalar_mut(7.3 * stage.height);
        let low = (0..clip.frames())
            .flat_map(|t| clip.world_pose(t).positions)
            .map(|p| p.y)
            .fold(f64::INFINITY, f64::min);
        let y = clip.skeleton.joints[0]
            .channels
            .iter()
            .position(|channel| *channel == crate::motion::skeleton::Channel::Yposition);
        clip.values.column_mut(y.unwrap()).add_scalar_mut(-low);
        assert_eq!(clip.up_axis(), UpAxis::Y);
    }

    /// A body with six channels at the root and angles elsewhere, from (name, parent, offset), that moves its
    /// joints a little and travels by `step` a frame.
    fn animal(joints: &[(&str, Option<usize>, [f64; 3])], step: Vector3<f64>) -> Clip {
        let angles = [Channel::Zrotation, Channel::Xrotation, Channel::Yrotation];
        let joint = |&(name, parent, offset): &(&str, Option<usize>, [f64; 3])| Joint {
            name: name.to_owned(),
            parent,
            offset,
            channels: if parent.is_none() { Channel::ALL.to_vec() } else { angles.to_vec() },
            end_sites: if joints.iter().any(|other| other.1.is_some_and(|p| joints[p].0 == name)) {
                Vec::new()
            } else {
                vec![offset]
            },
        };
        let skeleton = Skeleton { joints: joints.iter().map(joint).collect() };
        let values = DMatrix::from_fn(40, skeleton.channel_count(), |t, column| match column {
            0..3 => joints[0].2[column] + t as f64 * step[column],
            3..6 => 0.0,
            _ => 4.0 * (0.3 * t as f64 + column as f64).sin(),
        });
        Clip::new("animal.bvh", skeleton, 1.0 / 30.0, values)
    }

    /// Four legs under a long back; from the hind feet to the head it is farther ahead than up.
    fn four_legs(step: Vector3<f64>) -> Clip {
        animal(
            &[
                ("Hips", None, [0.0, 1.0, 0.0]),
                ("LeftThigh", Some(0), [0.0, 0.0, -0.3]),
                ("LeftCalf", Some(1), [0.0, -0.5, 0.0]),
                ("RightThigh", Some(0), [0.0, 0.0, 0.3]),
                ("RightCalf", Some(3), [0.0, -0.5, 0.0]),
                ("Spine", Some(0), [1.2, 0.0, 0.0]),
                ("LeftUpperArm", Some(5), [0.0, 0.0, -0.3]),
                ("LeftForearm", Some(6), [0.0, -0.5, 0.0]),
                ("RightUpperArm", Some(5), [0.0, 0.0, 0.3]),
                ("RightForearm", Some(8), [0.0, -0.5, 0.0]),
                ("Head", Some(5), [0.5, 0.0, 0.0]),
                ("Tail", Some(0), [-0.4, 0.0, 0.0]),
            ],
            step,
        )
    }

    /// Three pairs of legs that spread to the sides of a flat shell, whose eyes point ahead.
    fn many_legs() -> Clip {
        let mut joints = vec![("Shell", None, [0.0, 0.3, 0.0]), ("Head", Some(0), [0.0, 0.0, 0.7])];
        for ahead in [-0.3, 0.0, 0.3] {
            for (name, side) in [("LegL", 1.0), ("LegR", -1.0)] {
                joints.push((name, Some(0), [0.2 * side, 0.0, ahead]));
                joints.push((name, Some(joints.len() - 1), [0.4 * side, -0.15, 0.3 * ahead]));
            }
        }
        animal(&joints, Vector3::zeros())
    }

    #[test]
    fn animals_stand_on_their_legs() {
        let clips = [four_legs(Vector3::zeros()), four_legs(Vector3::new(0.05, 0.0, 0.0)), many_legs()];
        for (place, clip) in clips.iter().enumerate() {
            for up in UpAxis::ALL {
                let turned = in_other_world(clip, up.to_y_up().inverse());
                assert_eq!(turned.up_axis(), up, "animal {place}");
            }
        }
        let height = clips[0].stage().height;
        assert!((0.9..1.3).contains(&height), "{height}");
    }

    /// In the rest pose of some rigs the arms point up; toes then decided that the body lies.
    #[test]
    fn a_rest_pose_with_raised_arms_stands() {
        let mut joints = vec![
            ("Hips", None, [0.0, 85.0, 0.0]),
            ("Spine", Some(0), [0.0, 30.0, 0.0]),
            ("Head", Some(1), [0.0, 20.0, 0.0]),
        ];
        for (leg, side) in [
            (["LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToe"], 1.0),
            (["RightUpLeg", "RightLeg", "RightFoot", "RightToe"], -1.0),
        ] {
            let first = joints.len();
            joints.push((leg[0], Some(0), [11.0 * side, 0.0, 0.0]));
            joints.push((leg[1], Some(first), [0.0, -38.0, 0.0]));
            joints.push((leg[2], Some(first + 1), [0.0, -40.0, 0.0]));
            joints.push((leg[3], Some(first + 2), [0.0, 0.0, 15.0]));
        }
        for (arm, side) in [(["LeftArm", "LeftForeArm"], 1.0), (["RightArm", "RightForeArm"], -1.0)] {
            joints.push((arm[0], Some(1), [5.0 * side, 25.0, 0.0]));
            joints.push((arm[1], Some(joints.len() - 1), [0.0, 35.0, 0.0]));
        }
        let clip = animal(&joints, Vector3::zeros());
        assert_eq!((clip.up_axis(), clip.skeleton.height().round()), (UpAxis::Y, 148.0));
    }

    #[test]
    fn the_stated_axis_counts() {
        let walk = &clips()[0];
        for up in UpAxis::ALL {
            let clip = Clip { up: Some(up), ..walk.clone() };
            assert_eq!((clip.up_axis(), clip.stage().up), (up, up));
            assert_eq!(clip.resample(30.0).unwrap().cut(0, 10).unwrap().up_axis(), up);
        }
    }

    /// A chain without limbs that crawls along its own length.
    #[test]
    fn a_body_without_limbs_does_not_travel_upwards() {
        let chain =
            [("a", None, [0.0, 0.1, 0.0]), ("b", Some(0), [0.0, 0.1, 1.0]), ("c", Some(1), [0.0, 0.1, 1.0])];
        assert_eq!(animal(&chain, Vector3::zeros()).up_axis(), UpAxis::Z);
        assert_eq!(animal(&chain, Vector3::new(0.0, 0.0, 0.1)).up_axis(), UpAxis::Y);
    }
}
