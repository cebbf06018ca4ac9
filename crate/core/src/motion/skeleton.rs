//! The joint tree of a body: names, parents, offsets and channels.

use crate::motion::rotation;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};
use serde::Serialize;
use thiserror::Error;

/// Largest number of joints of a body, and of its end sites.
pub const MAX_JOINTS: usize = 2_000;

/// Largest number of positions (frames x nodes) of one clip, which limits memory and time in a browser. A
/// body of 40 nodes can move for 17 minutes at 120 frames a second.
pub const MAX_POSITIONS: usize = 5_000_000;

/// Largest size of a number in a file; sums and products of such numbers are finite.
pub(crate) const LARGEST_NUMBER: f64 = 1e9;

/// One degree of freedom of a joint, as BVH files name it. Rotations are in degrees, positions in file units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Channel {
    /// Translation along x.
    Xposition,
    /// Translation along y.
    Yposition,
    /// Translation along z.
    Zposition,
    /// Rotation about x.
    Xrotation,
    /// Rotation about y.
    Yrotation,
    /// Rotation about z.
    Zrotation,
}

impl Channel {
    /// All six channels: positions, then rotations.
    pub const ALL: [Channel; 6] = [
        Channel::Xposition,
        Channel::Yposition,
        Channel::Zposition,
        Channel::Xrotation,
        Channel::Yrotation,
        Channel::Zrotation,
    ];

    /// Its name in a BVH file.
    pub fn name(self) -> &'static str {
        match self {
            Channel::Xposition => "Xposition",
            Channel::Yposition => "Yposition",
            Channel::Zposition => "Zposition",
            Channel::Xrotation => "Xrotation",
            Channel::Yrotation => "Yrotation",
            Channel::Zrotation => "Zrotation",
        }
    }

    /// The channel of that name in upper, lower or mixed case.
    pub fn from_name(name: &str) -> Option<Channel> {
        Channel::ALL.into_iter().find(|channel| channel.name().eq_ignore_ascii_case(name))
    }

    /// The axis it moves along or turns about: 0, 1, 2 for x, y, z.
    pub fn axis(self) -> usize {
        match self {
            Channel::Xposition | Channel::Xrotation => 0,
            Channel::Yposition | Channel::Yrotation => 1,
            Channel::Zposition | Channel::Zrotation => 2,
        }
    }

    /// Whether it is an angle in degrees rather than a position.
    pub fn is_rotation(self) -> bool {
        matches!(self, Channel::Xrotation | Channel::Yrotation | Channel::Zrotation)
    }
}

/// One joint. Its index in the skeleton identifies a joint, because names may repeat.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The name as written in the file.
    pub name: String,
    /// The index of the parent, which is smaller than the joint's own; `None` for the root.
    pub parent: Option<usize>,
    /// The joint's position in its parent's frame, in file units.
    pub offset: [f64; 3],
    /// The channels in the order in which a row of the file holds them.
    pub channels: Vec<Channel>,
    /// The ends of the bones that leave this joint and reach no other joint, in file units.
    pub end_sites: Vec<[f64; 3]>,
}

impl Joint {
    /// The axes of its rotation channels, in their order: `R = R_first R_second R_third`.
    pub fn rotation_axes(&self) -> impl Iterator<Item = usize> + '_ {
        self.channels.iter().filter(|channel| channel.is_rotation()).map(|channel| channel.axis())
    }

    /// Whether it has a position channel.
    pub(crate) fn has_positions(&self) -> bool {
        self.channels.iter().any(|channel| !channel.is_rotation())
    }

    /// Whether it has a position channel for every axis.
    pub fn is_placed(&self) -> bool {
        self.channels.iter().filter(|channel| !channel.is_rotation()).count() == 3
    }
}

/// A joint tree with one root at index 0 and parents before children.
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton {
    /// The joints, in the order of the file.
    pub joints: Vec<Joint>,
}

/// A joint or an end site. A bone runs from each node to its parent node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct FigureNode {
    /// The joint, or, for an end site, the joint whose bone ends here.
    pub joint: usize,
    /// The parent node; `None` for the root.
    pub parent: Option<usize>,
    /// Whether it is an end site.
    pub end_site: bool,
}

/// Why a joint tree is invalid.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SkeletonError {
    /// There is no joint at all.
    #[error("expected at least one joint, found none")]
    Empty,
    /// More than `MAX_JOINTS` joints or end sites.
    #[error("expected at most {MAX_JOINTS} joints, found {0}")]
    TooLarge(usize),
    /// Joint 0 has a parent, another joint has none, or a parent comes after its child.
    #[error(
        "joint {joint} ({name:?}): expected {}, found {}",
        if *.joint == 0 { "no parent, as it is the root".to_owned() } else { format!("a parent from 0 to {}", joint - 1) },
        .parent.map_or("none".to_owned(), |p| format!("parent {p}"))
    )]
    Parent {
        /// The place of the joint.
        joint: usize,
        /// The name of the joint.
        name: String,
        /// The parent it names.
        parent: Option<usize>,
    },
    /// An offset that is not a finite number of sensible size.
    #[error("joint {joint} ({name:?}): expected a finite offset, found one that is not")]
    Offset {
        /// The place of the joint.
        joint: usize,
        /// The name of the joint.
        name: String,
    },
    /// One channel twice.
    #[error("joint {joint} ({name:?}): expected each channel once, found {channel} twice")]
    RepeatedChannel {
        /// The place of the joint.
        joint: usize,
        /// The name of the joint.
        name: String,
        /// The channel.
        channel: &'static str,
    },
}

impl Skeleton {
    /// The number of channels of all joints together: the length of one row of the file.
    pub fn channel_count(&self) -> usize {
        self.joints.iter().map(|joint| joint.channels.len()).sum()
    }

    /// The number of nodes of [`Skeleton::figure`]: joints and end sites.
    pub fn node_count(&self) -> usize {
        self.joints.iter().map(|joint| 1 + joint.end_sites.len()).sum()
    }

    /// Largest number of frames of a clip of this body: `MAX_POSITIONS` divided by the number of nodes.
    pub fn max_frames(&self) -> usize {
        MAX_POSITIONS / self.node_count().max(1)
    }

    /// The column of each joint's first channel.
    pub fn channel_starts(&self) -> Vec<usize> {
        let mut next = 0;
        self.joints
            .iter()
            .map(|joint| {
                let start = next;
                next += joint.channels.len();
                start
            })
            .collect()
    }

    /// The indices of a joint's children.
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        self.joints.iter().enumerate().filter(move |(_, j)| j.parent == Some(joint)).map(|(i, _)| i)
    }

    /// Checks the conditions of all other methods: one root at index 0, parents before children, finite
    /// offsets and each channel at most once in a joint. A skeleton from
    /// [`bvh::read`](crate::motion::bvh::read) is always valid.
    ///
    /// # Errors
    ///
    /// A [`SkeletonError`] about the first joint that is wrong.
    pub fn validate(&self) -> Result<(), SkeletonError> {
        if self.joints.is_empty() {
            return Err(SkeletonError::Empty);
        }
        let ends: usize = self.joints.iter().map(|joint| joint.end_sites.len()).sum();
        if self.joints.len() > MAX_JOINTS || ends > MAX_JOINTS {
            return Err(SkeletonError::TooLarge(self.joints.len().max(ends)));
        }
        for (place, joint) in self.joints.iter().enumerate() {
            let name = || joint.name.clone();
            let sound = joint.parent.map_or(place == 0, |parent| parent < place);
            if !sound {
                return Err(SkeletonError::Parent { joint: place, name: name(), parent: joint.parent });
            }
            let offsets = joint.end_sites.iter().chain([&joint.offset]).flatten();
            if !offsets.into_iter().all(|x| x.abs() < 1e12) {
                return Err(SkeletonError::Offset { joint: place, name: name() });
            }
            for (i, channel) in joint.channels.iter().enumerate() {
                if joint.channels[..i].contains(channel) {
                    return Err(SkeletonError::RepeatedChannel {
                        joint: place,
                        name: name(),
                        channel: channel.name(),
                    });
                }
            }
        }
        Ok(())
    }

    /// The nodes to draw: node `i` is joint `i`; the end sites follow, in the order of their joints.
    pub fn figure(&self) -> Vec<FigureNode> {
        let joints = self.joints.iter().enumerate();
        let nodes = joints.clone().map(|(joint, j)| FigureNode { joint, parent: j.parent, end_site: false });
        let ends = joints.flat_map(|(joint, j)| {
            j.end_sites.iter().map(move |_| FigureNode { joint, parent: Some(joint), end_site: true })
        });
        nodes.chain(ends).collect()
    }

    /// The local rotations and positions in one row of channel values [frames x channels]: `R = R_first
    /// R_second R_third` in the order of the joint's channels. A position channel replaces the joint's
    /// offset, axis by axis.
    pub(crate) fn local_pose(&self, values: &DMatrix<f64>, frame: usize) -> LocalPose {
        let mut pose = LocalPose::default();
        let mut column = 0;
        for joint in &self.joints {
            let mut rotation = UnitQuaternion::identity();
            let mut position = Vector3::from(joint.offset);
            for channel in &joint.channels {
                let value = values[(frame, column)];
                column += 1;
                if channel.is_rotation() {
                    rotation *= rotation::about_axis(channel.axis(), value.to_radians());
                } else {
                    position[channel.axis()] = value;
                }
            }
            pose.rotations.push(rotation);
            pose.positions.push(position);
        }
        pose
    }

    /// World positions of all nodes of [`Skeleton::figure`] and world rotations of all joints.
    ///
    /// `p_j = p_parent + R_parent t_j`, `R_j = R_parent Q_j`, with the local rotations `Q_j` and local
    /// positions `t_j` [one for each joint]; those of the root are its orientation and position in the world.
    pub fn forward_kinematics(
        &self,
        rotations: &[UnitQuaternion<f64>],
        positions: &[Vector3<f64>],
    ) -> WorldPose {
        let mut pose = WorldPose { positions: Vec::new(), rotations: Vec::with_capacity(self.joints.len()) };
        self.forward_kinematics_into(rotations, positions, &mut pose);
        pose
    }

    /// [`Skeleton::forward_kinematics`] into an existing pose, whose memory is reused.
    pub fn forward_kinematics_into(
        &self,
        rotations: &[UnitQuaternion<f64>],
        positions: &[Vector3<f64>],
        pose: &mut WorldPose,
    ) {
        pose.positions.clear();
        pose.rotations.clear();
        for ((joint, &rotation), &position) in self.joints.iter().zip(rotations).zip(positions) {
            let (place, turned) = match joint.parent {
                None => (position, rotation),
                Some(parent) => (
                    pose.positions[parent] + pose.rotations[parent] * position,
                    pose.rotations[parent] * rotation,
                ),
            };
            pose.positions.push(place);
            pose.rotations.push(turned);
        }
        for (place, joint) in self.joints.iter().enumerate() {
            for end in &joint.end_sites {
                let end = pose.positions[place] + pose.rotations[place] * Vector3::from(*end);
                pose.positions.push(end);
            }
        }
    }

    /// The pose in which no joint is turned, the root at its offset.
    pub fn rest_pose(&self) -> WorldPose {
        let rotations = vec![UnitQuaternion::identity(); self.joints.len()];
        let positions: Vec<_> = self.joints.iter().map(|joint| Vector3::from(joint.offset)).collect();
        self.forward_kinematics(&rotations, &positions)
    }
}

/// The pose of one frame, joint by joint.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LocalPose {
    /// The rotation of each joint in its parent's frame; the root's is in the world.
    pub rotations: Vec<UnitQuaternion<f64>>,
    /// The position of each joint in its parent's frame, in file units; the root's is in the world.
    pub positions: Vec<Vector3<f64>>,
}

/// One pose in the world.
#[derive(Clone, Debug, Default)]
pub struct WorldPose {
    /// World position of each node of [`Skeleton::figure`], in file units.
    pub positions: Vec<Vector3<f64>>,
    /// World rotation of each joint.
    pub rotations: Vec<UnitQuaternion<f64>>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tree_with_too_many_joints_or_ends_or_with_one_bad_offset_is_refused() {
        let joint = |parent| Joint {
            name: "a".to_owned(),
            parent,
            offset: [0.0; 3],
            channels: Vec::new(),
            end_sites: Vec::new(),
        };
        let with_ends =
            |ends: usize| Skeleton { joints: vec![Joint { end_sites: vec![[0.0; 3]; ends], ..joint(None) }] };
        assert_eq!(with_ends(2000).validate(), Ok(()));
        assert_eq!(with_ends(2001).validate(), Err(SkeletonError::TooLarge(2001)));
        let joints = (0..2001_usize).map(|place| joint(place.checked_sub(1))).collect();
        assert_eq!(Skeleton { joints }.validate(), Err(SkeletonError::TooLarge(2001)));
        for axis in 0..3 {
            let mut body = with_ends(1);
            body.joints[0].end_sites[0][axis] = f64::NAN;
            assert!(matches!(body.validate(), Err(SkeletonError::Offset { joint: 0, .. })), "{axis}");
        }
    }
}
