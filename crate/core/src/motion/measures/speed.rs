//! Speed of a body and its joints, sliding of its feet, the time at which it comes to rest, and tracks of joints.

use crate::elementary::Elementary;
use crate::motion::Skeleton;
use crate::motion::anatomy::{Anatomy, Region};
use nalgebra::Vector3;

/// The joints of a standing person are slower than this, in metres a second.
const SWAY: f64 = 0.2;
/// Shortest time of standing at the end of a recording, in seconds.
const REST_FOR: f64 = 0.25;
/// A slower body, in metres a second, does not walk.
const WALKING: f64 = 0.1;
/// The walking speed is measured over this time, in seconds, which contains whole steps.
const WALKING_WINDOW: f64 = 1.0;

/// Mean speed of all nodes relative to the root, in metres a second.
pub(super) fn joint_speed(track: &Track) -> f64 {
    let count = track.frames().saturating_sub(1) * track.nodes.saturating_sub(1);
    let speeds = (1..track.frames()).flat_map(|frame| joint_speeds(track, frame));
    speeds.sum::<f64>() / count.max(1) as f64
}

/// Seconds until a recorded body comes to rest; `None` if it moves to the end. A standing person sways, and
/// recordings end soon after the movement: so joints may move at 0.2 m/s relative to the root, and a quarter
/// of a second is enough.
///
/// `positions` [frames x nodes x 3] as for [`measures`](super::measures), `frame_time` in seconds.
pub fn rests_from(skeleton: &Skeleton, positions: &[f32], frame_time: f64) -> Option<f64> {
    let track = Track::new(skeleton, positions, frame_time);
    let slow = |&frame: &usize| joint_speeds(&track, frame).all(|speed| speed < SWAY);
    let frames = (1..track.frames()).rev().take_while(slow).count();
    (frames as f64 * frame_time >= REST_FOR).then(|| (track.frames() - 1 - frames) as f64 * frame_time)
}

/// Speeds relative to the root of all other nodes, from the previous frame to this one.
fn joint_speeds<'a>(track: &'a Track, frame: usize) -> impl Iterator<Item = f64> + 'a {
    let moved = move |node| track.root_to(frame, node) - track.root_to(frame - 1, node);
    (1..track.nodes).map(move |node| moved(node).norm() / track.frame_time)
}

/// Mean speed of the root over the ground, in metres a second.
pub(super) fn walking(track: &Track) -> f64 {
    let last = track.frames().saturating_sub(1);
    let window = ((WALKING_WINDOW / track.frame_time).round() as usize).clamp(1, last.max(1));
    let steps =
        (window..track.frames()).map(|frame| along_ground(track.at(frame, 0) - track.at(frame - window, 0)));
    let count = track.frames().saturating_sub(window).max(1) as f64;
    steps.sum::<f64>() / (count * window as f64 * track.frame_time)
}

/// Horizontal speed of the lowest node of the legs divided by the `walking` speed.
pub(super) fn foot_slide(skeleton: &Skeleton, anatomy: &Anatomy, track: &Track, walking: f64) -> Option<f64> {
    let mut legs = Vec::new();
    for (node, figure) in skeleton.figure().iter().enumerate() {
        if matches!(anatomy.regions[figure.joint], Region::Leg(_)) {
            legs.push(node);
        }
    }
    let mut slid = 0.0;
    for frame in 1..track.frames() {
        let (mut lowest, mut lowest_height) = (0, f64::INFINITY);
        for &node in &legs {
            let height = track.at(frame, node).y;
            if height < lowest_height {
                (lowest, lowest_height) = (node, height);
            }
        }
        slid += along_ground(track.at(frame, lowest) - track.at(frame - 1, lowest));
    }
    let seconds = track.frames().saturating_sub(1).max(1) as f64 * track.frame_time;
    (walking >= WALKING).then(|| slid / seconds / walking)
}

fn along_ground(step: Vector3<f64>) -> f64 {
    step.x.hypotenuse(step.z)
}

/// Positions of nodes [frames x nodes x 3], y up, in metres.
pub(super) struct Track<'a> {
    positions: &'a [f32],
    pub(super) nodes: usize,
    /// Seconds from one frame to the next.
    pub(super) frame_time: f64,
}

impl<'a> Track<'a> {
    pub(super) fn new(skeleton: &Skeleton, positions: &'a [f32], frame_time: f64) -> Self {
        Self { positions, nodes: skeleton.figure().len(), frame_time }
    }

    pub(super) fn frames(&self) -> usize {
        self.positions.len() / (3 * self.nodes)
    }

    pub(super) fn at(&self, frame: usize, node: usize) -> Vector3<f64> {
        let first = 3 * (frame * self.nodes + node);
        Vector3::from_fn(|axis, _| f64::from(self.positions[first + axis]))
    }

    /// The vector from the root to the node.
    pub(super) fn root_to(&self, frame: usize, node: usize) -> Vector3<f64> {
        self.at(frame, node) - self.at(frame, 0)
    }
}
