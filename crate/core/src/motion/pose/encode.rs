//! From clips to rows of Y.

use crate::motion::clip::Clip;
use crate::motion::pose::mapping::{PoseError, PoseMapping, ROOT_COLUMNS, mean_positions};
use crate::motion::pose::root;
use crate::motion::pose::root::{RootPose, RootStart};
use crate::motion::rotation;
use crate::motion::skeleton::LocalPose;
use crate::motion::stage::UpAxis;
use crate::plural::listed;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

/// A clip as rows of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Encoded {
    /// Poses [frames x columns of the mapping].
    pub y: DMatrix<f64>,
    /// The start of the clip. Together with `y` it determines the whole motion.
    pub start: RootStart,
    /// Which parts of the clip the rows cannot hold, as sentences.
    pub warnings: Vec<String>,
}

/// Largest displacement or height in leg lengths: a larger one is a fault of the recording.
const FARTHEST: f64 = 1e5;

/// A body stands when the vector upwards of its root has this component along the up axis.
const STANDS: f64 = 0.7;

/// Positions that vary by a smaller fraction of the body's height count as constant.
const STILL: f64 = 1e-3;

impl PoseMapping {
    /// Turns a clip of the same body into rows of Y [frames x columns]. The clip may have other channels than
    /// the mapping's body, and its joints in another order. If the clip states the axis that points up ([`Clip::up`]), or the body clearly stands
    /// along another axis than in the mapping, this axis counts for its rows.
    ///
    /// # Errors
    ///
    /// [`PoseError::Body`] for a clip of another body, [`PoseError::Spike`] when its root is absurdly far
    /// away.
    pub fn encode(&self, clip: &Clip) -> Result<Encoded, PoseError> {
        let order = self.order_warning(clip);
        let clip = &*clip.in_order_of(&self.skeleton);
        let body = self.skeleton.same_body(&clip.skeleton);
        body.map_err(|reason| PoseError::Body { clip: clip.name.clone(), reason })?;
        let poses: Vec<LocalPose> = (0..clip.frames()).map(|frame| clip.local_pose(frame)).collect();
        let mut y = DMatrix::zeros(poses.len(), self.column_count());
        let up = self.up_of(clip);
        let (turn, upright) = (up.to_y_up(), self.upright().inverse());
        let angles = root::continuous_angles(poses.iter().map(|pose| turn * pose.rotations[0] * upright));
        let roots: Vec<RootPose> = (poses.iter().zip(&angles))
            .map(|(pose, &angles)| RootPose { place: turn * pose.positions[0] / self.leg(), angles })
            .collect();
        for (t, row) in root::rows(&roots, self.climbs_from.is_some()).iter().enumerate() {
            if let Some(&found) = row.iter().find(|value| value.abs() > FARTHEST) {
                return Err(PoseError::Spike { frame: t, most: FARTHEST, found: found.abs() });
            }
            for (column, &value) in row.iter().enumerate() {
                y[(t, column)] = value;
            }
        }
        for joint in 1..self.skeleton.joints.len() {
            let column = ROOT_COLUMNS.len() + 3 * (joint - 1);
            let mut previous = Vector3::from(self.first[joint]);
            for (t, pose) in poses.iter().enumerate() {
                previous = next_rotation(&pose.rotations[joint], &previous);
                y.fixed_view_mut::<1, 3>(t, column).copy_from(&previous.transpose());
            }
        }
        let start = match (poses.first(), angles.first()) {
            (Some(pose), Some(angles)) => {
                // A start is in the axes of the mapping.
                let place = if up == self.stage.up {
                    pose.positions[0]
                } else {
                    self.stage.up.to_y_up().inverse() * (turn * pose.positions[0])
                };
                let first = self.climbs_from.unwrap_or(0.0) * self.leg() * Vector3::y();
                let place = place - self.stage.up.to_y_up().inverse() * first;
                RootStart { position: place.into(), yaw: angles[0] }
            }
            _ => RootStart::default(),
        };
        let mut warnings = self.moving_joints(clip);
        warnings.extend(self.turn_warning(clip, up).into_iter().chain(order));
        Ok(Encoded { y, start, warnings })
    }

    /// The axis that points up in a clip: stated, or that of the mapping. If the body would lie on average,
    /// and stands along the axis found from the clip itself, then that axis.
    fn up_of(&self, clip: &Clip) -> UpAxis {
        let found = clip.up_axis();
        if clip.up.is_some() || found == self.stage.up {
            return found;
        }
        let upright = self.upright().inverse() * Vector3::y();
        let mean = (0..clip.frames()).map(|frame| clip.local_pose(frame).rotations[0] * upright);
        let mean = mean.sum::<Vector3<f64>>() / clip.frames().max(1) as f64;
        let stands = |up: UpAxis| up.height(&mean) > STANDS;
        if stands(found) && !stands(self.stage.up) { found } else { self.stage.up }
    }

    /// A sentence if another axis points up in the clip than in the body of this mapping.
    #[doc(hidden)]
    pub fn axis_warning(&self, clip: &Clip) -> Option<String> {
        self.turn_warning(clip, self.up_of(clip))
    }

    /// As [`axis_warning`](Self::axis_warning), for the axis that [`up_of`](Self::up_of) has found.
    fn turn_warning(&self, clip: &Clip, found: UpAxis) -> Option<String> {
        let (own, up) = (found.name(), self.stage.up.name());
        let turned =
            || format!("the up axis is {own} here and {up} in the body it is compared with: it was turned");
        (own != up && clip.up.is_none()).then(turned)
    }

    /// A sentence if the joints of the clip are in another order than in the body of this mapping.
    #[doc(hidden)]
    pub fn order_warning(&self, clip: &Clip) -> Option<String> {
        self.skeleton.places_in(&clip.skeleton).map(|_| {
            "the joints are in another order than in the body it is compared with: they were matched by their names"
                .to_owned()
        })
    }

    fn moving_joints(&self, clip: &Clip) -> Vec<String> {
        let spreads = mean_positions(clip).1;
        let moving: Vec<&str> = (clip.skeleton.joints.iter().zip(spreads).skip(1))
            .filter(|(_, spread)| *spread > STILL * self.stage.height)
            .map(|(joint, _)| joint.name.as_str())
            .collect();
        if moving.is_empty() {
            return Vec::new();
        }
        let names = listed(moving);
        vec![format!("joints that move in their parent's frame are kept at their mean position: {names}")]
    }
}

/// The rotation vector nearest to `previous`, or the shortest vector if even the nearest is far away:
/// otherwise a sensor that flips over would add a turn each time.
fn next_rotation(rotation: &UnitQuaternion<f64>, previous: &Vector3<f64>) -> Vector3<f64> {
    let near = rotation::log_near(rotation, previous);
    if (near - previous).norm() > FRAC_PI_2 { rotation::log(rotation) } else { near }
}
