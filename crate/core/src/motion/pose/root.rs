//! The root: from its position and orientation to rates that do not depend on its heading, and back.

use crate::elementary::Elementary;
use crate::motion::anatomy::{Anatomy, Region};
use crate::motion::clip::Clip;
use crate::motion::joint_names::Side;
use crate::motion::rotation;
use crate::motion::stage::UpAxis;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

/// Position and heading at the start of a motion, which its rows do not contain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RootStart {
    /// The root's position in frame 0, in the file's axes and units. The component along the up axis is not
    /// used where rows contain the height. Where they contain its changes, this component is the height above
    /// the root's first height in the first clip.
    pub position: [f64; 3],
    /// The heading in frame 0, radians about the up axis.
    pub yaw: f64,
}

/// The order of the root's angles: R_y(yaw) R_x(pitch) R_z(roll).
const YXZ: [usize; 3] = [1, 0, 2];

/// The root in a world with y up: its position in leg lengths, its angles in radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct RootPose {
    pub(super) place: Vector3<f64>,
    /// Yaw, pitch, roll.
    pub(super) angles: [f64; 3],
}

/// The root's pose behind the rows until now, for a motion whose rows come in pieces.
#[derive(Clone, Debug)]
pub struct RootTrack {
    begin: RootPose,
    before: Option<RootPose>,
    /// Whether rows contain changes of the height.
    climbs: bool,
}

impl RootTrack {
    pub(super) fn new(begin: RootPose, climbs: bool) -> Self {
        Self { begin, before: None, climbs }
    }

    /// A vector in a world with y up, turned so that z is the heading of the newest row.
    pub(crate) fn relative_to_heading(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        let [yaw, ..] = self.before.as_ref().unwrap_or(&self.begin).angles;
        rotation::about_axis(1, -yaw) * vector
    }

    /// Adds a row and returns its pose.
    pub(super) fn push(&mut self, row: &[f64; 6]) -> RootPose {
        let pose = integrate(row, self.before.as_ref(), &self.begin, self.climbs);
        self.before = Some(pose);
        pose
    }
}

impl RootPose {
    /// `R_y(yaw) R_x(pitch) R_z(roll)`.
    pub(super) fn orientation(&self) -> UnitQuaternion<f64> {
        let [yaw, pitch, roll] = self.angles;
        rotation::about_axis(1, yaw) * rotation::about_axis(0, pitch) * rotation::about_axis(2, roll)
    }
}

/// Angles of a sequence of orientations without jumps: each is the solution nearest to the previous angles.
/// The first is the solution with the smaller pitch and roll.
pub(super) fn continuous_angles(orientations: impl Iterator<Item = UnitQuaternion<f64>>) -> Vec<[f64; 3]> {
    let mut angles: Vec<[f64; 3]> = Vec::new();
    for orientation in orientations {
        let next = match angles.last() {
            Some(previous) => rotation::euler_near(&orientation, YXZ, *previous),
            None => {
                let first = rotation::euler_near(&orientation, YXZ, [0.0; 3]);
                // The other solution, with its pitch and roll near zero.
                let turned = [
                    first[0] + std::f64::consts::PI,
                    std::f64::consts::PI - first[1],
                    first[2] + std::f64::consts::PI,
                ];
                let other = [turned[0], rotation::wrapped(turned[1]), rotation::wrapped(turned[2])];
                let tilt = |angles: &[f64; 3]| angles[1].hypotenuse(angles[2]);
                if tilt(&other) < tilt(&first) { other } else { first }
            }
        };
        angles.push(next);
    }
    angles
}

/// Rows [frames x 6] of a sequence of root poses, in the order of [`super::mapping::ROOT_COLUMNS`].
///
/// `yaw rate_t = yaw_t - yaw_{t-1}` wrapped to +-pi; `(sideways, -, forward)_t = R_y(-yaw_{t-1}) (p_t -
/// p_{t-1})`. Where the body `climbs`, the height is a rate too: `y_t - y_{t-1}`. Row 0 has no previous frame
/// and repeats the rates of row 1.
pub(super) fn rows(poses: &[RootPose], climbs: bool) -> Vec<[f64; 6]> {
    let mut rows: Vec<[f64; 6]> = (poses.iter().enumerate())
        .map(|(t, now)| {
            let before = &poses[t.saturating_sub(1)];
            let step = rotation::about_axis(1, -before.angles[0]) * (now.place - before.place);
            let yaw_rate = rotation::wrapped(now.angles[0] - before.angles[0]);
            let height = if climbs { step.y } else { now.place.y };
            [yaw_rate, step.z, step.x, height, now.angles[1], now.angles[2]]
        })
        .collect();
    if let [first, second, ..] = rows.as_mut_slice() {
        let rates = if climbs { 4 } else { 3 };
        first[..rates].copy_from_slice(&second[..rates]);
    }
    rows
}

/// The inverse of [`rows`]: the pose that follows `before`. The rates of the first row are not used.
fn integrate(row: &[f64; 6], before: Option<&RootPose>, start: &RootPose, climbs: bool) -> RootPose {
    let [yaw_rate, forward, sideways, height, pitch, roll] = *row;
    let (yaw, mut place) = match before {
        None => (start.angles[0], start.place),
        Some(before) => {
            let step = rotation::about_axis(1, before.angles[0]) * Vector3::new(sideways, 0.0, forward);
            (before.angles[0] + yaw_rate, before.place + step)
        }
    };
    if !climbs {
        place.y = height;
    } else if before.is_some() {
        place.y += height;
    }
    RootPose { place, angles: [yaw, pitch, roll] }
}

/// R0 [w, x, y, z]: the one of the 24 axis-aligned rotations that turns the body of the clip upright, facing
/// z with its left along x.
pub(super) fn upright(clip: &Clip, up: UpAxis) -> [f64; 4] {
    let turn = up.to_y_up();
    let anatomy = Anatomy::find(&clip.skeleton);
    let (mut upward, mut leftward) = (Vector3::zeros(), Vector3::zeros());
    for frame in 0..clip.frames() {
        let pose = clip.world_pose(frame);
        let inverse = (turn * pose.rotations[0]).inverse();
        upward += inverse * Vector3::y();
        if let Some(anatomy) = &anatomy {
            let middle = |side| -> Vector3<f64> {
                let joints = anatomy.joints(Region::Leg(side));
                joints.iter().map(|&joint| pose.positions[joint]).sum::<Vector3<f64>>()
                    / joints.len().max(1) as f64
            };
            leftward += inverse * (turn * (middle(Side::Left) - middle(Side::Right)));
        }
    }
    let unit = |v: Vector3<f64>| v.try_normalize(1e-12).unwrap_or_else(Vector3::zeros);
    let (upward, leftward) = (unit(upward), unit(leftward));
    // First the up axis, then the left side; the trace prefers the root's own axes in a tie.
    let score = |m: &Matrix3<f64>| 10.0 * (m * upward).y + (m * leftward).x + 1e-3 * m.trace();
    let mut best = Matrix3::identity();
    for candidate in axis_rotations() {
        if score(&candidate) > score(&best) + 1e-12 {
            best = candidate;
        }
    }
    let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(best));
    [q.w, q.i, q.j, q.k]
}

/// The 24 axis-aligned rotations.
fn axis_rotations() -> Vec<Matrix3<f64>> {
    let mut rotations = Vec::with_capacity(24);
    for i in 0..3 {
        for j in (0..3).filter(|&j| j != i) {
            for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                let (x, y) = (Vector3::ith(i, a), Vector3::ith(j, b));
                rotations.push(Matrix3::from_columns(&[x, y, x.cross(&y)]));
            }
        }
    }
    rotations
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_24_axis_rotations() {
        let rotations = axis_rotations();
        assert_eq!(rotations.len(), 24);
        for (n, a) in rotations.iter().enumerate() {
            assert_eq!(a.determinant(), 1.0);
            assert!(rotations[..n].iter().all(|b| a != b));
        }
    }

    #[test]
    fn a_walk_round_a_circle_is_stationary() {
        let poses: Vec<RootPose> = (0..50)
            .map(|t| {
                let yaw = 0.2 * f64::from(t);
                let place = Vector3::new(-yaw.cos(), 0.5, yaw.sin()) * 2.0;
                RootPose { place, angles: [yaw, 0.1, 0.0] }
            })
            .collect();
        let rows = rows(&poses, false);
        for row in &rows {
            for (value, first) in row.iter().zip(&rows[0]) {
                assert!((value - first).abs() < 1e-12);
            }
        }
        assert!((rows[0][0] - 0.2).abs() < 1e-12);
        // Ahead along a chord of the circle.
        assert!((rows[0][1].hypot(rows[0][2]) - 4.0 * 0.1_f64.sin()).abs() < 1e-12 && rows[0][1] > 0.39);
    }

    #[test]
    fn the_angles_of_a_somersault_have_no_jumps() {
        let turning = (0..200).map(|t| {
            rotation::about_axis(1, 2.0)
                * rotation::about_axis(0, 0.05 * f64::from(t))
                * rotation::about_axis(2, 0.01)
        });
        let angles = continuous_angles(turning);
        for pair in angles.windows(2) {
            for n in 0..3 {
                assert!((pair[1][n] - pair[0][n]).abs() < 0.1, "{pair:?}");
            }
        }
        assert!((angles[199][1] - 0.05 * 199.0).abs() < 1e-9);
    }
}
