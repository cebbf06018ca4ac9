//! Prepares a movement for a study: along z, with the feet on the ground, above the origin, at the frame rate
//! of the study.

use nalgebra::Vector3;
use thiserror::Error;
use vcgpdm_core::motion::Skeleton;
use vcgpdm_core::motion::landmarks::facing;

/// Speed in metres a second below which a body stands. A standing body is turned to its facing direction.
const STANDS: f64 = 0.2;
/// In one of this number of frames the lowest node may be below the ground, so that a bad frame does not lift
/// the figure.
const LOWEST: usize = 10;

/// Why a movement cannot be shown.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum StagingError {
    /// It is too short.
    #[error("expected a movement of at least {expected:.2} seconds, found {found:.2}")]
    Short {
        /// Seconds needed.
        expected: f64,
        /// Seconds of the movement.
        found: f64,
    },
    /// Its positions are not finite.
    #[error("expected finite positions, found others")]
    NotFinite,
}

/// A movement that is prepared for a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Staged {
    /// Positions [frames x nodes x 3], y up, in metres.
    pub positions: Vec<f32>,
    /// The speed before the movement was centred, in metres a second.
    pub speed: f64,
}

/// The `seconds` of a movement after its first `skipped` frames, or its last `seconds` if it is too short, at
/// `rate` frames a second and along z. The camera moves with the body at a constant speed: the body stays
/// above the origin and keeps its vertical movement.
///
/// `positions` [frames x nodes x 3] are metres on a stage with y up, `frame_time` seconds a frame.
///
/// # Errors
/// The movement is too short, or not finite.
pub fn staged(
    skeleton: &Skeleton,
    positions: &[f32],
    frame_time: f64,
    skipped: usize,
    seconds: f64,
    rate: usize,
) -> Result<Staged, StagingError> {
    if !positions.iter().all(|place| place.is_finite()) {
        return Err(StagingError::NotFinite);
    }
    let width = 3 * skeleton.node_count();
    let given = positions.len() / width.max(1);
    let frames = (seconds * rate as f64).round() as usize;
    let needed = frames.saturating_sub(1) as f64 / rate as f64;
    let held = given.saturating_sub(1) as f64 * frame_time;
    if held + 1e-9 < needed || frames == 0 {
        return Err(StagingError::Short { expected: seconds, found: held + frame_time });
    }
    let begin = (skipped as f64 * frame_time).min(held - needed).max(0.0);
    let mut places = Vec::with_capacity(frames * width);
    for frame in 0..frames {
        let at = ((begin + frame as f64 / rate as f64) / frame_time).clamp(0.0, (given - 1) as f64);
        // Rounding errors must not mix two frames.
        let at = if (at - at.round()).abs() < 1e-6 { at.round() } else { at };
        let (before, share) = (at.floor() as usize, at.fract());
        let after = (before + 1).min(given - 1);
        let mixed = |k: usize| {
            let (a, b) = (f64::from(positions[before * width + k]), f64::from(positions[after * width + k]));
            a + share * (b - a)
        };
        places.extend((0..width).map(mixed));
    }
    let (middle, velocity) = way(&places, width, rate);
    let speed = velocity.norm();
    let ahead = if speed < STANDS { facing(skeleton, positions) } else { None };
    let ahead = ahead.or_else(|| velocity.try_normalize(1e-6)).unwrap_or_else(Vector3::z);
    let ground = ground(&places, width);
    let (sine, cosine) = (ahead.x, ahead.z);
    let mut staged = Vec::with_capacity(places.len());
    for (frame, nodes) in places.chunks_exact(width).enumerate() {
        let time = (frame as f64 - 0.5 * (frames - 1) as f64) / rate as f64;
        for place in nodes.chunks_exact(3) {
            let (x, z) = (place[0] - middle.x - velocity.x * time, place[2] - middle.z - velocity.z * time);
            let turned = [cosine * x - sine * z, place[1] - ground, sine * x + cosine * z];
            staged.extend(turned.map(|place| place as f32));
        }
    }
    Ok(Staged { positions: staged, speed })
}

/// The mean position of the root, and its velocity: the slope of a straight line through its path by least
/// squares; both horizontal.
fn way(places: &[f64], width: usize, rate: usize) -> (Vector3<f64>, Vector3<f64>) {
    let roots: Vec<Vector3<f64>> =
        places.chunks_exact(width).map(|frame| Vector3::new(frame[0], 0.0, frame[2])).collect();
    let count = roots.len() as f64;
    let middle = roots.iter().sum::<Vector3<f64>>() / count;
    let time = |frame: usize| (frame as f64 - 0.5 * (count - 1.0)) / rate as f64;
    let (mut product, mut square) = (Vector3::zeros(), 0.0);
    for (frame, root) in roots.iter().enumerate() {
        product += time(frame) * (root - middle);
        square += time(frame) * time(frame);
    }
    (middle, if square > 0.0 { product / square } else { Vector3::zeros() })
}

/// The height of the ground: in nine of ten frames no node is lower.
fn ground(places: &[f64], width: usize) -> f64 {
    let lowest = |frame: &[f64]| frame.chunks_exact(3).map(|place| place[1]).fold(f64::INFINITY, f64::min);
    let mut lows: Vec<f64> = places.chunks_exact(width).map(lowest).collect();
    lows.sort_by(f64::total_cmp);
    lows.get(lows.len() / LOWEST).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm_core::motion::{Clip, samples};

    fn walk() -> Clip {
        samples::clip("walk-3").unwrap().resample(30.0).unwrap()
    }

    fn root(staged: &Staged, nodes: usize, frame: usize) -> Vector3<f64> {
        let at = 3 * nodes * frame;
        Vector3::from_fn(|axis, _| f64::from(staged.positions[at + axis]))
    }

    #[test]
    fn turns_a_walk_along_z_and_keeps_it_above_the_origin() {
        let clip = walk();
        let (places, nodes) = (clip.stage_positions(), clip.skeleton.node_count());
        let first = staged(&clip.skeleton, &places, clip.frame_time, 5, 3.5, 30).unwrap();
        assert_eq!(first.positions.len(), 105 * nodes * 3);
        assert!((1.0..1.6).contains(&first.speed), "{}", first.speed);
        for frame in 0..105 {
            let root = root(&first, nodes, frame);
            assert!(root.x.abs() < 0.1 && root.z.abs() < 0.1 && (0.7..1.1).contains(&root.y), "{root}");
        }
        // The body faces its direction of walking.
        assert!(facing(&clip.skeleton, &first.positions).unwrap().z > 0.98);
        let low = first.positions.chunks_exact(3).map(|place| place[1]).fold(f32::INFINITY, f32::min);
        assert!((-0.03..=0.0).contains(&low), "{low}");
        // The same walk at another position, in another direction.
        let (sine, cosine) = 2.0_f32.sin_cos();
        let turned: Vec<f32> = places
            .chunks_exact(3)
            .flat_map(|p| [3.0 + cosine * p[0] + sine * p[2], 0.4 + p[1], cosine * p[2] - sine * p[0]])
            .collect();
        let second = staged(&clip.skeleton, &turned, clip.frame_time, 5, 3.5, 30).unwrap();
        for (a, b) in first.positions.iter().zip(&second.positions) {
            assert!((a - b).abs() < 1e-4, "{a} {b}");
        }
    }

    #[test]
    fn keeps_the_speed_at_another_frame_rate() {
        let clip = walk();
        let fast = staged(&clip.skeleton, &clip.stage_positions(), clip.frame_time, 5, 3.5, 60).unwrap();
        let slow = staged(&clip.skeleton, &clip.stage_positions(), clip.frame_time, 5, 3.5, 30).unwrap();
        let width = 3 * clip.skeleton.node_count();
        assert_eq!(fast.positions.len(), 2 * slow.positions.len());
        assert!((fast.speed - slow.speed).abs() < 0.01);
        let turns = |staged: &Staged, step: usize| -> Vec<f32> {
            staged.positions.chunks_exact(width).step_by(step).map(|frame| frame[1]).collect()
        };
        for (a, b) in turns(&fast, 2).iter().zip(turns(&slow, 1)) {
            assert!((a - b).abs() < 0.002, "{a} {b}");
        }
    }

    #[test]
    fn takes_the_end_of_a_short_movement_or_refuses_it() {
        let clip = walk();
        let places = clip.stage_positions();
        let seconds = clip.frames() as f64 * clip.frame_time;
        let whole = staged(&clip.skeleton, &places, clip.frame_time, 5, seconds, 30).unwrap();
        assert_eq!(whole.positions.len(), places.len());
        let error = staged(&clip.skeleton, &places, clip.frame_time, 5, 4.5, 30).unwrap_err();
        assert_eq!(error.to_string(), "expected a movement of at least 4.50 seconds, found 4.40");
        let mut wild = places;
        wild[7] = f32::NAN;
        assert_eq!(staged(&clip.skeleton, &wild, clip.frame_time, 5, 1.0, 30), Err(StagingError::NotFinite));
    }

    #[test]
    fn turns_a_standing_body_to_face_z() {
        let clip = walk();
        let first: Vec<f32> = clip.stage_positions()[..3 * clip.skeleton.node_count()].repeat(60);
        let still = staged(&clip.skeleton, &first, clip.frame_time, 0, 1.5, 30).unwrap();
        assert!(still.speed < 1e-6);
        assert!(facing(&clip.skeleton, &still.positions).unwrap().z > 0.999);
    }
}
