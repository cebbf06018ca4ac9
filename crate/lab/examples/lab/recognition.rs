//! Which movement of a library a clip shows, on clips that the library was not trained on
//! (docs/recognising.md).
//!
//! Each folder has the clips (.bvh) of one movement of one person. The library learns from every other trial
//! and recognises the rest; then the two halves change places. Clips of two movements are also joined, one after
//! the other, and mixed: the legs of one with the upper body of the other.

use crate::clips;
use std::path::PathBuf;
use vcgpdm::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary};
use vcgpdm::models::{Dataset, PoseWeight, Source, VariationalSettings};
use vcgpdm::motion::parts::presets;
use vcgpdm::motion::skeleton::Joint;
use vcgpdm::motion::{Clip, samples};
use vcgpdm_lab::evaluation::stats::median;

const FRAMES_PER_SECOND: f64 = 30.0;
const SEED: u32 = 0;

/// The trials of a movement.
struct Trials {
    name: String,
    clips: Vec<Clip>,
}

impl Trials {
    /// Every other trial, from the first or the second on.
    fn half(&self, first: usize) -> Vec<&Clip> {
        self.clips.iter().skip(first).step_by(2).collect()
    }
}

fn movements(folders: &[PathBuf]) -> Vec<Trials> {
    if folders.is_empty() {
        let trials = |name: &str| {
            let of_movement = samples::list().into_iter().filter(|sample| sample.movement == name);
            let clips = of_movement.map(|sample| samples::clip(sample.id).unwrap()).collect();
            Trials { name: name.to_owned(), clips }
        };
        return ["walk", "walk and wave"].map(trials).into();
    }
    let trials = |folder: &PathBuf| Trials {
        name: folder.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        clips: clips::read_clips(std::slice::from_ref(folder)).collect(),
    };
    folders.iter().map(trials).collect()
}

fn library(movements: &[Trials], half: usize) -> TrainedLibrary {
    let chosen: Vec<Vec<&Clip>> = movements.iter().map(|trials| trials.half(half)).collect();
    let sources: Vec<Source> = chosen.iter().flatten().map(|clip| Source::from(*clip)).collect();
    let skeleton = &movements[0].clips[0].skeleton;
    let parts = presets(skeleton).into_iter().find(|preset| preset.id == "lower-upper").unwrap().parts;
    let dataset = Dataset::new(&sources, &parts, FRAMES_PER_SECOND).unwrap();
    let planned = movements.iter().zip(&chosen);
    let planned = planned
        .map(|(trials, chosen)| PlannedMovement { name: trials.name.clone(), sequences: chosen.len() });
    let plan = LibraryPlan::new(planned.collect(), vec![false; parts.len()]).unwrap();
    let settings =
        VariationalSettings { pose_weight: PoseWeight::Balanced, ..VariationalSettings::default() };
    let mut trainer = LibraryTrainer::new(&dataset, &plan, &settings, SEED).unwrap();
    trainer.run();
    trainer.finish().unwrap()
}

/// The joints of the upper body.
fn upper_body(clip: &Clip) -> Vec<usize> {
    let preset = presets(&clip.skeleton).into_iter().find(|preset| preset.id == "lower-upper").unwrap();
    preset.parts.into_iter().find(|part| part.name.contains("upper")).unwrap().joints
}

/// The legs of one clip with the upper body of another clip of the same body and rate, as long as the shorter one.
fn mixed(legs: &Clip, arms: &Clip) -> Clip {
    let frames = legs.frames().min(arms.frames());
    let mut mixed = legs.cut(0, frames).unwrap();
    let upper = upper_body(legs);
    let mut first = 0;
    for (joint, Joint { channels, .. }) in legs.skeleton.joints.iter().enumerate() {
        if upper.contains(&joint) {
            let of_arms = arms.values.view((0, first), (frames, channels.len()));
            mixed.values.columns_mut(first, channels.len()).copy_from(&of_arms);
        }
        first += channels.len();
    }
    mixed
}

/// The share of the frames in which each part has the primitive that `is_right` accepts.
fn share_by_part(library: &TrainedLibrary, clip: &Clip, is_right: impl Fn(usize, usize) -> bool) -> Vec<f64> {
    let found = library.recognise(&[clip]).unwrap();
    let frames = found.posterior.nrows() as f64;
    let share = |part: usize| {
        let right = found.segments().into_iter().filter(|segment| is_right(part, segment.uses[part]));
        right.map(|segment| segment.frames.len()).sum::<usize>() as f64 / frames
    };
    (0..found.primitives.len()).map(share).collect()
}

/// The errors of the boundaries, in seconds, of three clips that were joined; `None`: other pieces were found.
fn boundary_errors(library: &TrainedLibrary, clips: [&Clip; 3], expected: [usize; 3]) -> Option<[f64; 2]> {
    let segments = library.recognise(&clips).unwrap().segments();
    let found: Vec<&[usize]> = segments.iter().map(|segment| &segment.uses[..]).collect();
    let expected = expected.map(|movement| &library.library.movements[movement].uses[..]);
    if found != expected {
        return None;
    }
    let step = clips[0].frame_time;
    let first = clips[0].frames() as f64 * step;
    let second = first + clips[1].frames() as f64 * step;
    let end = |piece: usize| segments[piece].frames.end as f64 * library.body.frame_time;
    Some([(end(0) - first).abs(), (end(1) - second).abs()])
}

/// The shares of the frames of a clip in which each movement is found, in all parts.
fn shares_of_movements(library: &TrainedLibrary, clip: &Clip) -> Vec<f64> {
    let found = library.recognise(&[clip]).unwrap();
    let frames = found.posterior.nrows() as f64;
    let share = |uses: &Vec<usize>| {
        let of_movement = found.segments().into_iter().filter(|segment| segment.uses == *uses);
        of_movement.map(|segment| segment.frames.len()).sum::<usize>() as f64 / frames
    };
    library.library.movements.iter().map(|movement| share(&movement.uses)).collect()
}

/// A row of the table: its head, the number of clips, and the means of the shares in per cent.
fn print_row(head: &str, shares: &[Vec<f64>]) {
    let mean = |shares: &Vec<f64>| shares.iter().sum::<f64>() / shares.len() as f64;
    let cells: Vec<String> = shares.iter().map(|shares| format!("{:.0} %", 100.0 * mean(shares))).collect();
    println!("| {head} | {} | {} |", shares[0].len(), cells.join(" | "));
}

pub fn run(folders: &[PathBuf]) {
    let movements = movements(folders);
    let count = movements.len();
    let mut shares = vec![vec![Vec::new(); count]; count];
    let mut of_mixed = vec![vec![vec![Vec::new(); 2]; count]; count];
    let (mut errors, mut joins) = (Vec::new(), 0);
    for half in 0..2 {
        eprintln!("half {} of 2", half + 1);
        let library = library(&movements, half);
        let held_out: Vec<Vec<&Clip>> = movements.iter().map(|trials| trials.half(1 - half)).collect();
        for (truth, clips) in held_out.iter().enumerate() {
            for clip in clips {
                let found = shares_of_movements(&library, clip);
                shares[truth].iter_mut().zip(found).for_each(|(all, share)| all.push(share));
            }
        }
        for first in 0..count {
            for second in (0..count).filter(|second| *second != first) {
                let (a, b) = (&held_out[first], &held_out[second]);
                let clips = [a[0], b[0], a[a.len() - 1]];
                joins += 1;
                errors.extend(boundary_errors(&library, clips, [first, second, first]).into_iter().flatten());
                for (legs, arms) in a.iter().zip(b) {
                    let of_part = [first, second];
                    let found = share_by_part(&library, &mixed(legs, arms), |part, used| {
                        library.library.movements[of_part[part]].uses[part] == used
                    });
                    of_mixed[first][second].iter_mut().zip(found).for_each(|(all, share)| all.push(share));
                }
            }
        }
    }
    let names: Vec<&str> = movements.iter().map(|trials| trials.name.as_str()).collect();
    let heads: Vec<String> = names.iter().map(|name| format!("frames of {name}")).collect();
    println!("| movement | trials | {} |", heads.join(" | "));
    println!("{}|", "|---".repeat(2 + count));
    for (name, shares) in names.iter().zip(&shares) {
        print_row(name, shares);
    }
    println!(
        "\n{} of {joins} clips joined from three pieces are cut into these three; their boundaries are off by {:.2} s (median; at most {:.2} s).\n",
        errors.len() / 2,
        median(&errors),
        errors.iter().copied().fold(0.0, f64::max)
    );
    println!("| legs of | upper body of | clips | legs recognised | upper body recognised |");
    println!("{}|", "|---".repeat(5));
    for first in 0..count {
        for second in (0..count).filter(|second| *second != first) {
            print_row(&format!("{} | {}", names[first], names[second]), &of_mixed[first][second]);
        }
    }
}
