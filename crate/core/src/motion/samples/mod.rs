//! Sample clips that the project makes itself: trials of walking by a procedural walker, built from published
//! gait curves and body proportions, and of a seated person who passes a bottle from hand to hand, with
//! natural variation. They are computed when asked for, and equal on every machine.

mod body;
mod bottle;
mod gait;
mod turns;
mod variation;
mod walker;

use crate::motion::clip::Clip;
use crate::motion::skeleton::Skeleton;
use crate::motion::stage_axes::UpAxis;
use nalgebra::DMatrix;
use serde::Serialize;
use walker::Arms;

/// A clip that this project makes itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct SampleInfo {
    /// The id by which [`clip`] finds it.
    pub id: &'static str,
    /// Its title for users.
    pub title: &'static str,
    /// The movement, "walk", "walk and wave", "stand and wave" or "pass a bottle".
    pub movement: &'static str,
}

/// A trial that this project makes.
struct Trial {
    info: SampleInfo,
    seed: u64,
    /// 0 for a movement whose length follows from the seed.
    seconds: f64,
}

const WALK: &str = "walk";
const WALK_AND_WAVE: &str = "walk and wave";
const STAND_AND_WAVE: &str = "stand and wave";
const PASS_A_BOTTLE: &str = "pass a bottle";

const fn walk(id: &'static str, title: &'static str, seed: u64, seconds: f64) -> Trial {
    Trial { info: SampleInfo { id, title, movement: WALK }, seed, seconds }
}

const fn wave(id: &'static str, title: &'static str, seed: u64, seconds: f64) -> Trial {
    Trial { info: SampleInfo { id, title, movement: WALK_AND_WAVE }, seed, seconds }
}

const fn stand(id: &'static str, title: &'static str, seed: u64, seconds: f64) -> Trial {
    Trial { info: SampleInfo { id, title, movement: STAND_AND_WAVE }, seed, seconds }
}

const fn bottle(id: &'static str, title: &'static str, seed: u64) -> Trial {
    Trial { info: SampleInfo { id, title, movement: PASS_A_BOTTLE }, seed, seconds: 0.0 }
}

const WALKS: [Trial; 10] = [
    walk("walk-1", "Walk, trial 1", 1, 4.2),
    walk("walk-2", "Walk, trial 2", 2, 3.9),
    walk("walk-3", "Walk, trial 3", 3, 4.4),
    walk("walk-4", "Walk, trial 4", 4, 4.0),
    walk("walk-5", "Walk, trial 5", 5, 3.7),
    walk("walk-6", "Walk, trial 6", 6, 4.3),
    wave("walk-wave-1", "Walk and wave, trial 1", 11, 4.1),
    wave("walk-wave-2", "Walk and wave, trial 2", 12, 4.3),
    wave("walk-wave-3", "Walk and wave, trial 3", 13, 3.8),
    wave("walk-wave-4", "Walk and wave, trial 4", 14, 4.0),
];

/// The clips in which no body walks.
const OTHERS: [Trial; 14] = [
    stand("stand-wave-1", "Stand and wave, trial 1", 41, 3.6),
    stand("stand-wave-2", "Stand and wave, trial 2", 42, 4.0),
    stand("stand-wave-3", "Stand and wave, trial 3", 43, 3.8),
    stand("stand-wave-4", "Stand and wave, trial 4", 44, 4.2),
    bottle("bottle-1", "Pass a bottle, trial 1", 21),
    bottle("bottle-2", "Pass a bottle, trial 2", 22),
    bottle("bottle-3", "Pass a bottle, trial 3", 23),
    bottle("bottle-4", "Pass a bottle, trial 4", 24),
    bottle("bottle-5", "Pass a bottle, trial 5", 25),
    bottle("bottle-6", "Pass a bottle, trial 6", 26),
    bottle("bottle-7", "Pass a bottle, trial 7", 27),
    bottle("bottle-8", "Pass a bottle, trial 8", 28),
    bottle("bottle-9", "Pass a bottle, trial 9", 29),
    bottle("bottle-10", "Pass a bottle, trial 10", 30),
];

/// All sample clips, in the order of the movements and trials.
pub fn list() -> Vec<SampleInfo> {
    WALKS.iter().chain(&OTHERS).map(|trial| trial.info).collect()
}

/// Makes the sample clip of that id (60 frames a second, centimetres, y up); `None` for an unknown id.
///
/// ```
/// use vcgpdm_core::motion::samples;
///
/// let walks: Vec<_> = samples::list().into_iter().filter(|info| info.movement == "walk").collect();
/// assert_eq!((walks.len(), walks[0].id), (6, "walk-1"));
/// assert!(samples::clip("walk-1").is_some_and(|clip| clip.frames() == 252));
/// assert!(samples::clip("run-1").is_none());
/// ```
pub fn clip(id: &str) -> Option<Clip> {
    walking_clip(id).or_else(|| {
        let Trial { info, seed, seconds } = OTHERS.iter().find(|trial| trial.info.id == id)?;
        Some(Clip { name: name(id), ..trial(info.movement, *seed, *seconds)? })
    })
}

/// Makes a new trial of a movement ([`SampleInfo::movement`]) from a seed. Passing a bottle has a length of its
/// own, whatever the seconds. `None` for an unknown movement.
pub fn trial(movement: &str, seed: u64, seconds: f64) -> Option<Clip> {
    let skeleton = body::skeleton();
    let values = match movement {
        WALK => walker::walk(&skeleton, Arms::Swing, seed, seconds),
        WALK_AND_WAVE => walker::walk(&skeleton, Arms::Wave, seed, seconds),
        STAND_AND_WAVE => walker::stand(&skeleton, seed, seconds),
        PASS_A_BOTTLE => bottle::pass(&skeleton, seed),
        _ => return None,
    };
    Some(made(&format!("{movement} {seed}.bvh"), skeleton, values))
}

/// The sample clips in which a body walks. A program that asks for no others has no code that makes them: the
/// page's first visit.
pub fn walking_list() -> Vec<SampleInfo> {
    WALKS.iter().map(|trial| trial.info).collect()
}

/// [`clip`] for the clips of [`walking_list`].
pub fn walking_clip(id: &str) -> Option<Clip> {
    let Trial { info, seed, seconds } = WALKS.iter().find(|trial| trial.info.id == id)?;
    let arms = if info.movement == WALK { Arms::Swing } else { Arms::Wave };
    let skeleton = body::skeleton();
    let values = walker::walk(&skeleton, arms, *seed, *seconds);
    Some(made(&name(id), skeleton, values))
}

fn name(id: &str) -> String {
    format!("{id} (made by this project).bvh")
}

fn made(name: &str, skeleton: Skeleton, values: DMatrix<f64>) -> Clip {
    Clip { found_up: Some(UpAxis::Y), ..Clip::new(name, skeleton, 1.0 / body::RATE, values) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{period, sha256};
    use nalgebra::Vector3;
    use std::collections::HashSet;

    fn clips() -> Vec<Clip> {
        list().iter().map(|info| clip(info.id).unwrap()).collect()
    }

    fn walks() -> Vec<Clip> {
        let walks = list().into_iter().filter(|info| info.movement.starts_with("walk"));
        walks.map(|info| clip(info.id).unwrap()).collect()
    }

    fn place(clip: &Clip, name: &str) -> usize {
        clip.skeleton.joints.iter().position(|joint| joint.name == name).unwrap()
    }

    /// Heel, ball and toe tip of the left and the right foot in every frame.
    fn soles(clip: &Clip) -> Vec<[Vector3<f64>; 6]> {
        let feet = ["Left", "Right"].map(|side| {
            let toes = place(clip, &format!("{side}ToeBase"));
            let node = clip.skeleton.figure().iter().position(|node| node.end_site && node.joint == toes);
            (place(clip, &format!("{side}Foot")), toes, node.unwrap())
        });
        let frames = (0..clip.frames()).map(|frame| {
            let pose = clip.world_pose(frame);
            let points = feet.map(|(foot, toes, tip)| {
                let heel = pose.positions[foot] + pose.rotations[foot] * body::HEEL;
                [heel, pose.positions[toes], pose.positions[tip]]
            });
            [points[0][0], points[0][1], points[0][2], points[1][0], points[1][1], points[1][2]]
        });
        frames.collect()
    }

    /// Mean speed over the ground, centimetres a second.
    fn speed(clip: &Clip) -> f64 {
        let (first, last) = (clip.values.row(0), clip.values.row(clip.frames() - 1));
        (last[0] - first[0]).hypot(last[2] - first[2]) / (clip.frame_time * (clip.frames() - 1) as f64)
    }

    #[test]
    fn each_movement_has_trials_with_their_own_ids() {
        let trials = |movement| list().iter().filter(|info| info.movement == movement).count();
        assert_eq!(["walk", "walk and wave", "stand and wave", "pass a bottle"].map(trials), [6, 4, 4, 10]);
        assert_eq!(list().iter().map(|info| info.id).collect::<HashSet<_>>().len(), list().len());
        assert_eq!(clip("walk-1").unwrap().name, "walk-1 (made by this project).bvh");
        assert!(clip("walk-0").is_none());
    }

    #[test]
    fn a_trial_of_a_samples_movement_and_seed_is_that_sample() {
        for Trial { info, seed, seconds } in WALKS.iter().chain(&OTHERS) {
            let made = trial(info.movement, *seed, *seconds).unwrap();
            assert_eq!(Clip { name: clip(info.id).unwrap().name, ..made }, clip(info.id).unwrap());
        }
        assert!(trial("run", 1, 4.0).is_none());
    }

    /// Models that were trained on them name their clips by these hashes.
    #[test]
    fn the_clips_are_those_of_earlier_versions() {
        let hashes: String = clips().into_iter().map(|clip| clip.sha256).collect();
        assert_eq!(sha256(hashes.as_bytes())[..16], *"2172f92f5db0442e");
    }

    #[test]
    fn a_clip_is_the_same_every_time_and_differs_from_all_others() {
        assert_eq!(clip("walk-2"), clip("walk-2"));
        let hashes: HashSet<String> = clips().into_iter().map(|clip| clip.sha256).collect();
        assert_eq!(hashes.len(), list().len());
        let lengths: HashSet<usize> = clips().iter().map(Clip::frames).collect();
        assert!(lengths.len() > 5);
    }

    #[test]
    fn a_sample_is_read_as_it_was_written() {
        let made = clip("walk-wave-1").unwrap();
        let read = crate::motion::bvh::read(&made.name, crate::motion::bvh::write(&made).as_bytes()).unwrap();
        assert_eq!((read.warnings.len(), &read.sha256), (0, &made.sha256));
        assert_eq!((&read.skeleton, &read.values), (&made.skeleton, &made.values));
    }

    #[test]
    fn the_standing_foot_does_not_slip() {
        for clip in walks() {
            let soles = soles(&clip);
            let slips = soles.windows(2).map(|pair| {
                let lowest = (0..6).min_by(|&a, &b| pair[0][a].y.total_cmp(&pair[0][b].y)).unwrap();
                let moved = pair[1][lowest] - pair[0][lowest];
                moved.x.hypot(moved.z) / clip.frame_time
            });
            let mut slips: Vec<f64> = slips.collect();
            slips.sort_by(f64::total_cmp);
            let (mean, speed) = (slips.iter().sum::<f64>() / slips.len() as f64, speed(&clip));
            assert!(mean < 0.03 * speed, "{}: the lowest point of the soles slips at {mean} cm/s", clip.name);
            let high = slips[slips.len() * 95 / 100];
            assert!(high < 0.1 * speed, "{}: in 5% of the frames it slips at {high} cm/s or more", clip.name);
        }
    }

    #[test]
    fn the_feet_stay_on_the_ground_and_take_turns() {
        for clip in walks() {
            let soles = soles(&clip);
            let lowest = |points: &[Vector3<f64>]| points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
            assert!(soles.iter().all(|points| (0.0..1.2).contains(&lowest(points))), "{}", clip.name);
            for foot in 0..2 {
                let down = |points: &[Vector3<f64>; 6]| lowest(&points[3 * foot..3 * foot + 3]) < 1.2;
                let share = soles.iter().filter(|points| down(points)).count() as f64 / soles.len() as f64;
                assert!(
                    (0.52..0.72).contains(&share),
                    "{}: a foot stands for {share} of the time",
                    clip.name
                );
                let highest = soles.iter().map(|p| lowest(&p[3 * foot..3 * foot + 3])).fold(0.0, f64::max);
                assert!(highest > 4.0, "{}: a foot is lifted by {highest} cm only", clip.name);
            }
        }
    }

    #[test]
    fn walking_speed_and_bounce_are_those_of_a_person() {
        for clip in walks() {
            let speed = speed(&clip);
            assert!((105.0..160.0).contains(&speed), "{}: {speed} cm/s", clip.name);
            let heights = clip.values.column(1);
            let bounce = heights.max() - heights.min();
            assert!((2.0..6.0).contains(&bounce), "{}: {bounce} cm up and down", clip.name);
            // Smooth: the velocity of the root changes by less than 15 cm/s from frame to frame.
            for frame in 2..clip.frames() {
                for column in 0..3 {
                    let value = |back: usize| clip.values[(frame - back, column)];
                    let change = (value(0) - 2.0 * value(1) + value(2)) / clip.frame_time;
                    assert!(change.abs() < 15.0, "{}: frame {frame}, column {column}: {change}", clip.name);
                }
            }
        }
    }

    #[test]
    fn waving_hands_are_above_the_head_and_swinging_hands_below_it() {
        for (info, clip) in list().iter().zip(clips()).filter(|(info, _)| info.movement != "pass a bottle") {
            let waves = info.movement.ends_with("wave");
            let (head, hips) = (place(&clip, "Head"), place(&clip, "Hips"));
            for side in ["Left", "Right"] {
                let hand = place(&clip, &format!("{side}Hand"));
                let mut across = Vec::new();
                for frame in 0..clip.frames() {
                    let at = clip.world_pose(frame).positions;
                    assert_eq!(at[hand].y > at[head].y, waves, "{} frame {frame}", clip.name);
                    across.push((at[hand].x - at[hips].x).abs());
                }
                let wide = across.iter().fold(0.0, |a: f64, b| a.max(*b))
                    - across.iter().fold(999.0, |a: f64, b| a.min(*b));
                assert_eq!(wide > 15.0, waves, "{}: {wide}", clip.name);
            }
        }
    }

    /// Frames of a cycle of some joints' angles.
    fn cycle(clip: &Clip, names: [&str; 2]) -> f64 {
        let columns: Vec<usize> =
            names.iter().flat_map(|name| (0..3).map(|k| 3 + 3 * place(clip, name) + k)).collect();
        period(&[clip.values.select_columns(&columns)]).unwrap().frames
    }

    #[test]
    fn hands_wave_at_a_rate_of_their_own_and_legs_walk_at_theirs() {
        let waving = list().into_iter().filter(|info| info.movement.ends_with("wave"));
        let clips: Vec<Clip> = waving.map(|info| clip(info.id).unwrap()).collect();
        let rates: Vec<f64> =
            clips.iter().map(|clip| 60.0 / cycle(clip, ["LeftForeArm", "RightForeArm"])).collect();
        assert!(rates.iter().all(|rate| (1.0..2.3).contains(rate)), "{rates:?} cycles a second");
        // Another rate in each trial, and none that is the rate of the steps in all of them.
        let steps = clips.iter().map(|clip| 120.0 / cycle(clip, ["LeftLeg", "RightLeg"]));
        let ratios: Vec<f64> = rates.iter().zip(steps).take(4).map(|(waves, steps)| waves / steps).collect();
        for values in [&rates[..4], &rates[4..], &ratios] {
            let sorted = {
                let mut sorted = values.to_vec();
                sorted.sort_by(f64::total_cmp);
                sorted
            };
            assert!(sorted[3] > 1.15 * sorted[0], "{sorted:?}");
        }
    }

    #[test]
    fn standing_feet_stay() {
        for info in list().into_iter().filter(|info| info.movement == "stand and wave") {
            let clip = clip(info.id).unwrap();
            let soles = soles(&clip);
            for points in &soles {
                for (point, first) in points.iter().zip(&soles[0]) {
                    assert!((point - first).norm() < 2.0, "{}: {}", clip.name, (point - first).norm());
                }
            }
        }
    }
}
