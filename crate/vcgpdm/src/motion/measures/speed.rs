//! How fast a body walks and its joints move, whether its feet slide, and when it comes to stand still.

use crate::elementary::Elementary;
use crate::motion::Skeleton;
use crate::motion::anatomy::{Anatomy, Region};
use crate::motion::measures::track::Track;
use nalgebra::Vector3;

/// A body none of whose joints is faster than this, relative to the root, stands still; in metres a second.
const STILL: f64 = 0.1;
/// A body stands still when it does so for at least this long, to the end; in seconds.
const STILL_FOR: f64 = 1.0;
/// Joints of a person who stands are slower than this, in metres a second.
const SWAY: f64 = 0.2;
/// A recording ends at rest when its body stands for at least this long, in seconds.
const REST_FOR: f64 = 0.25;
/// A body that gets on more slowly than this, in metres a second, does not walk.
const WALKING: f64 = 0.1;
/// Steps come and go within a second: the speed of walking is that over a whole one.
const WALKING_WINDOW: f64 = 1.0;

/// Mean speed of all nodes relative to the root, in metres a second.
pub(super) fn of_joints(track: &Track) -> f64 {
    let count = track.frames().saturating_sub(1) * track.nodes.saturating_sub(1);
    let speeds = (1..track.frames()).flat_map(|frame| joint_speeds(track, frame));
    speeds.sum::<f64>() / count.max(1) as f64
}

/// Seconds from the first frame to the one from which the body stands still to the end: no joint is faster
/// than 0.1 m/s relative to the root, for at least one second. A body that glides in one pose stands still.
/// `None`: it keeps moving.
///
/// `positions` [frames x nodes x 3] as for [`measures`](super::measures), `frame_time` in seconds.
pub fn still_from(skeleton: &Skeleton, positions: &[f32], frame_time: f64) -> Option<f64> {
    slow_from(skeleton, positions, frame_time, STILL, STILL_FOR)
}

/// Seconds from the first frame to the one from which a recorded body comes to rest; `None`: it moves to its
/// end. Who stands sways, and recordings are cut soon after: a joint may be twice as fast as where a rollout
/// [stands still](still_from), and a quarter of a second is enough.
///
/// `positions` [frames x nodes x 3] as for [`measures`](super::measures), `frame_time` in seconds.
pub fn rests_from(skeleton: &Skeleton, positions: &[f32], frame_time: f64) -> Option<f64> {
    slow_from(skeleton, positions, frame_time, SWAY, REST_FOR)
}

/// Seconds to the frame from which no joint is as fast as `speed`, in metres a second, for at least `least`
/// seconds, to the end.
fn slow_from(skeleton: &Skeleton, positions: &[f32], frame_time: f64, speed: f64, least: f64) -> Option<f64> {
    let track = Track::new(skeleton, positions, frame_time);
    let slow = |&frame: &usize| joint_speeds(&track, frame).all(|found| found < speed);
    let frames = (1..track.frames()).rev().take_while(slow).count();
    let seconds = frames as f64 * frame_time;
    (seconds >= least).then(|| (track.frames() - 1 - frames) as f64 * frame_time)
}

/// Speeds relative to the root of all nodes but the root, from the frame before to this one.
fn joint_speeds<'a>(track: &'a Track, frame: usize) -> impl Iterator<Item = f64> + 'a {
    let moved = move |node| track.beside_root(frame, node) - track.beside_root(frame - 1, node);
    (1..track.nodes).map(move |node| moved(node).norm() / track.frame_time)
}

/// Mean speed of the root over the ground, in metres a second.
pub(super) fn walking(track: &Track) -> f64 {
    let last = track.frames().saturating_sub(1);
    let window = ((WALKING_WINDOW / track.frame_time).round() as usize).clamp(1, last.max(1));
    let ways =
        (window..track.frames()).map(|frame| along_ground(track.at(frame, 0) - track.at(frame - window, 0)));
    let count = track.frames().saturating_sub(window).max(1) as f64;
    ways.sum::<f64>() / (count * window as f64 * track.frame_time)
}

/// Horizontal speed of the lowest node of the legs, as a share of the `walking` speed.
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

fn along_ground(way: Vector3<f64>) -> f64 {
    way.x.hypotenuse(way.z)
}
