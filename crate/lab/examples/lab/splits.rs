//! When two parts predict better than one: the same walks with another timing of the upper body
//! (docs/comparison/splits.md).
//!
//! Each folder has the clips (.bvh) of one person; the sample walks follow. In every trial the upper body
//! comes from a later time of the trial than the lower body, or moves at another pace, equally in all trials
//! or differently in each. All trials have the same length, so that only the relative timing differs.

use crate::clips;
use crate::ratio::{ERRORS, over_trials};
use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm::models::{Settings, VariationalSettings};
use vcgpdm::motion::parts::{PartSpec, presets};
use vcgpdm::motion::{Clip, samples};
use vcgpdm_lab::evaluation::{Candidate, Fold, Outcome, START_FRAMES};

const FRAMES_PER_SECOND: f64 = 30.0;
const SEEDS: Range<u32> = 0..3;
/// The longest delay: about a cycle of a walk.
const CYCLE: f64 = 1.0;
/// Largest relative change of the pace of the upper body.
const PACE: f64 = 0.15;

/// Timing of the upper body: at time t it has its pose of time `delay` + `pace` t, in seconds.
#[derive(Clone, Copy)]
struct Time {
    delay: f64,
    pace: f64,
}

/// A name, and the timing of the upper body in trial k of n.
type Variant = (&'static str, fn(usize, usize) -> Time);

const VARIANTS: [Variant; 4] = [
    ("as walked", |_, _| Time { delay: 0.0, pace: 1.0 }),
    ("half a second later, in every trial", |_, _| Time { delay: 0.5 * CYCLE, pace: 1.0 }),
    ("later by a different time in each trial, 0 to 1 s", |k, n| Time {
        delay: CYCLE * share(k, n),
        pace: 1.0,
    }),
    ("at another pace in each trial, 0.85 to 1.15 times", |k, n| Time {
        delay: 0.0,
        pace: 1.0 + PACE * (2.0 * share(k, n) - 1.0),
    }),
];

/// Values from 0 to 1 in equal steps; trials that follow each other have distant values.
fn share(k: usize, n: usize) -> f64 {
    let order: Vec<usize> = (0..n).step_by(2).chain((1..n).step_by(2)).collect();
    order[k] as f64 / (n - 1) as f64
}

/// The trial with its own timing of the upper body, cut to a length that every timing allows.
fn timed(trial: &Clip, upper: &PartSpec, time: Time) -> Clip {
    let kept =
        ((trial.frames() as f64 * trial.frame_time - CYCLE) / (1.0 + PACE) / trial.frame_time) as usize;
    let mut clip = trial.cut(0, kept).unwrap();
    let mut channel = 0;
    for (joint, of_joint) in trial.skeleton.joints.iter().enumerate() {
        let places = channel..channel + of_joint.channels.len();
        channel = places.end;
        if upper.joints.contains(&joint) {
            for t in 0..kept {
                let from = time.delay / trial.frame_time + time.pace * t as f64;
                for place in places.clone() {
                    clip.values[(t, place)] = trial.values[(from.round() as usize, place)];
                }
            }
        }
    }
    clip
}

/// The outcomes of both models for each trial held out, from every seed: [parts, whole].
fn outcomes(trials: &[Clip], parts: &[PartSpec]) -> Vec<[Vec<Outcome>; 2]> {
    let settings = VariationalSettings::default();
    let candidates = [Settings::Vcgpdm(settings.clone()), Settings::Vgpdm(settings)].map(Candidate::from);
    let clock = Instant::now();
    let fold = |held_out| {
        let fold =
            Fold::new(trials, held_out, trials.len() - 1, parts, FRAMES_PER_SECOND, START_FRAMES).unwrap();
        candidates.each_ref().map(|candidate| {
            let seconds = || clock.elapsed().as_secs_f64();
            SEEDS
                .map(|seed| fold.evaluate(candidate, seed, &seconds, &mut |_| true).unwrap().unwrap())
                .collect()
        })
    };
    (0..trials.len()).map(fold).collect()
}

fn print(name: &str, trials: &[Clip]) {
    let preset = presets(&trials[0].skeleton).into_iter().find(|preset| preset.id == "lower-upper").unwrap();
    for (title, time) in VARIANTS {
        eprintln!("{name}: {title}");
        let timed: Vec<Clip> = trials
            .iter()
            .enumerate()
            .map(|(k, trial)| timed(trial, &preset.parts[1], time(k, trials.len())))
            .collect();
        let (parts, whole): (Vec<_>, Vec<_>) =
            outcomes(&timed, &preset.parts).into_iter().map(<(_, _)>::from).unzip();
        let cells = ERRORS.map(|(_, error)| over_trials(&parts, &whole, error));
        println!("| {name} | {title} | {} |", cells.join(" | "));
    }
}

pub fn run(folders: &[PathBuf]) {
    println!(
        "| trials | the upper body | error, parts : whole | lower body | upper body | on the training trials |"
    );
    println!("{}|", "|---".repeat(6));
    for folder in folders {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        print(&name, &clips::read_clips(std::slice::from_ref(folder)).collect::<Vec<_>>());
    }
    let walks = samples::list().into_iter().filter(|sample| sample.movement == "walk");
    print("walk-made", &walks.map(|sample| samples::clip(sample.id).unwrap()).collect::<Vec<_>>());
}
