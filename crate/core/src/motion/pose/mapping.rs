//! The mapping between poses of one body and rows of Y: its columns, and the facts of the body that it needs.

use crate::motion::clip::Clip;
use crate::motion::pose::root;
use crate::motion::rotation;
use crate::motion::same_body::BodyMismatch;
use crate::motion::skeleton::Skeleton;
use crate::motion::stage::Stage;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use thiserror::Error;

/// The quantity in a column of Y.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ColumnKind {
    /// Change of the root's heading since the previous frame, radians, positive to the left.
    YawRate,
    /// Displacement since the previous frame along the heading, in leg lengths.
    Forward,
    /// Displacement since the previous frame to the left of the heading, in leg lengths.
    Sideways,
    /// Height of the root, in leg lengths.
    Height,
    /// Change of the root's height since the previous frame, in leg lengths: of a body that climbs.
    HeightRate,
    /// Rotation of the root about its left axis, after the heading, radians, positive forward.
    Pitch,
    /// Rotation of the root about its front axis, after heading and pitch, radians.
    Roll,
    /// A component (0, 1, 2) of a joint's rotation vector in its parent's frame, radians.
    Rotation(usize),
}

impl ColumnKind {
    /// Whether it is the change of the root since the previous frame.
    pub(crate) fn is_rate(self) -> bool {
        use ColumnKind::{Forward, HeightRate, Sideways, YawRate};
        matches!(self, YawRate | Forward | Sideways | HeightRate)
    }

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            ColumnKind::YawRate => "yaw_rate",
            ColumnKind::Forward => "forward",
            ColumnKind::Sideways => "sideways",
            ColumnKind::Height => "height",
            ColumnKind::HeightRate => "height_rate",
            ColumnKind::Pitch => "pitch",
            ColumnKind::Roll => "roll",
            ColumnKind::Rotation(0) => "x",
            ColumnKind::Rotation(1) => "y",
            ColumnKind::Rotation(_) => "z",
        }
    }
}

/// One column of Y.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// The index of its joint.
    pub joint: usize,
    /// Its quantity.
    pub kind: ColumnKind,
}

/// The columns of the root, which are the first.
pub(crate) const ROOT_COLUMNS: [ColumnKind; 6] = [
    ColumnKind::YawRate,
    ColumnKind::Forward,
    ColumnKind::Sideways,
    ColumnKind::Height,
    ColumnKind::Pitch,
    ColumnKind::Roll,
];

/// Why poses could not be turned into numbers or back.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum PoseError {
    /// The clip shows another body.
    #[error("{clip}: not the same skeleton as the first clip: {reason}")]
    Body {
        /// The name of the clip.
        clip: String,
        /// The difference.
        reason: BodyMismatch,
    },
    /// Rows of a wrong width.
    #[error("expected {expected} columns, found {found}")]
    Columns {
        /// Columns of the mapping.
        expected: usize,
        /// Columns given.
        found: usize,
    },
    /// NaN, an infinity or a number of absurd size in a row.
    #[error("frame {frame}, column {column}: expected a number from -1e9 to 1e9, found {found}")]
    NotFinite {
        /// The frame, counted from 0.
        frame: usize,
        /// The column, counted from 0.
        column: usize,
        /// The number found.
        found: f64,
    },
    /// The root has moved too far for a file to store its position.
    #[error("frame {frame}: expected a place from -1e9 to 1e9 in the units of the file, found {found:e}")]
    Away {
        /// The frame, counted from 0.
        frame: usize,
        /// The number found.
        found: f64,
    },
    /// The root is so far away that the squares of its numbers would dominate all others.
    #[error(
        "frame {frame}: expected the root less than {most} leg lengths from the frame before and from the \
         ground, found {found:.0}; is \
         there a spike in the recording?"
    )]
    Spike {
        /// The frame, counted from 0.
        frame: usize,
        /// The limit, in leg lengths.
        most: f64,
        /// What was found, in leg lengths.
        found: f64,
    },
    /// The start of a motion holds numbers that cannot be used.
    #[error("{field}: expected {expected}")]
    Field {
        /// The field.
        field: &'static str,
        /// What was expected.
        expected: String,
    },
}

/// The mapping between poses of one body and rows of Y: all facts of the body that a rollout needs.
///
/// ```
/// use vcgpdm_core::motion::pose::{ColumnKind, PoseMapping};
/// use vcgpdm_core::motion::samples;
///
/// let clip = samples::clip("walk-1").ok_or("no such sample")?;
/// let mapping = PoseMapping::new(&clip);
/// assert_eq!(mapping.columns()[1].kind, ColumnKind::Forward);
///
/// let encoded = mapping.encode(&clip)?; // y [frames x columns], and where the walk starts
/// let step = encoded.y.column(1).mean(); // in leg lengths a frame
/// let leg = 0.5 * 1.7; // metres, of a body 1.7 m tall
/// assert!((1.0..1.6).contains(&(step * leg / clip.frame_time)), "a walk is 1 to 1.6 metres a second fast");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// The root's orientation is `R = C^-1 R_y(yaw) R_x(pitch) R_z(roll) R0`, with C the rotation that brings the
/// file's world to y up, and R0 the one of the 24 axis-aligned rotations that turns the body of the clip
/// upright, facing z. So yaw is the heading, and pitch and roll are near zero, whatever axes the root has.
/// Displacements and height are in leg lengths, half the body's height: a step is then about as large as the
/// angle that the leg sweeps.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseMapping {
    /// The body.
    pub(super) skeleton: Skeleton,
    /// Up axis, height and ground of the clip.
    pub(super) stage: Stage,
    /// R0 as a quaternion [w, x, y, z].
    pub(super) upright: [f64; 4],
    /// The position of each joint in its parent's frame, file units: its offset, or the mean of its position
    /// channels.
    pub(super) positions: Vec<[f64; 3]>,
    /// The rotation vector of each joint in the first frame. The first rotation vector of an encoded clip is
    /// the nearest to it.
    pub(super) first: Vec<[f64; 3]>,
    /// The height of the root in the first frame, in leg lengths, if rows contain changes of the height;
    /// `None`: they contain the height.
    pub(super) climbs_from: Option<f64>,
}

impl PoseMapping {
    /// The mapping for the body of a clip, with the clip's up axis, ground, mean joint positions and first
    /// pose.
    pub fn new(clip: &Clip) -> PoseMapping {
        let stage = clip.stage();
        PoseMapping {
            skeleton: clip.skeleton.clone(),
            stage,
            upright: root::upright(clip, stage.up),
            positions: mean_positions(clip).0,
            first: first_rotations(clip),
            climbs_from: None,
        }
    }

    /// The body whose poses are mapped.
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// Up axis, height and ground of the clip that the mapping was made from.
    pub fn stage(&self) -> &Stage {
        &self.stage
    }

    /// The columns of the root, which are the first.
    pub(crate) fn root_columns(&self) -> impl Iterator<Item = Column> {
        ROOT_COLUMNS.into_iter().map(|kind| match (kind, self.climbs_from) {
            (ColumnKind::Height, Some(_)) => Column { joint: 0, kind: ColumnKind::HeightRate },
            _ => Column { joint: 0, kind },
        })
    }

    /// The columns of Y: six of the root, then three of each other joint, in the order of the joints.
    pub fn columns(&self) -> Vec<Column> {
        let others = (1..self.skeleton.joints.len())
            .flat_map(|joint| (0..3).map(move |axis| Column { joint, kind: ColumnKind::Rotation(axis) }));
        self.root_columns().chain(others).collect()
    }

    /// The number of columns of Y.
    pub fn column_count(&self) -> usize {
        ROOT_COLUMNS.len() + 3 * (self.skeleton.joints.len() - 1)
    }

    /// The length of a leg in file units: the unit of displacements and height.
    pub(super) fn leg(&self) -> f64 {
        0.5 * self.stage.height
    }

    /// R0 as a rotation.
    pub(super) fn upright(&self) -> UnitQuaternion<f64> {
        let [w, x, y, z] = self.upright;
        UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))
    }

    /// The positions of the joints in their parents' frames.
    pub(super) fn local_positions(&self) -> Vec<Vector3<f64>> {
        self.positions.iter().map(|place| Vector3::from(*place)).collect()
    }
}

/// The mean position of each joint in its parent's frame, and the largest distance from it along any axis.
pub(super) fn mean_positions(clip: &Clip) -> (Vec<[f64; 3]>, Vec<f64>) {
    let mut means = Vec::new();
    let mut spreads = Vec::new();
    let mut column = 0;
    for joint in &clip.skeleton.joints {
        let (mut mean, mut spread) = (joint.offset, 0.0_f64);
        for channel in &joint.channels {
            if !channel.is_rotation() && clip.frames() > 0 {
                let values = clip.values.column(column);
                // Relative to the first value, so the mean of a constant channel is exact.
                let first = values[0];
                let average =
                    first + values.iter().map(|value| value - first).sum::<f64>() / values.len() as f64;
                mean[channel.axis()] = average;
                spread = values.iter().map(|value| (value - average).abs()).fold(spread, f64::max);
            }
            column += 1;
        }
        means.push(mean);
        spreads.push(spread);
    }
    (means, spreads)
}

/// The rotation vector of each joint in the first frame, |r| <= pi; the root's is not used.
fn first_rotations(clip: &Clip) -> Vec<[f64; 3]> {
    if clip.frames() == 0 {
        return vec![[0.0; 3]; clip.skeleton.joints.len()];
    }
    clip.local_pose(0).rotations.iter().map(|rotation| rotation::log(rotation).into()).collect()
}

crate::coded!(PoseError => Clip);
