//! Which movement of a library a clip shows, on clips that the library was not trained on
//! (docs/recognising.md).
//!
//! Each folder has the clips (.bvh) of one movement of one person. The library learns from every other trial
//! and recognises the rest; then the two halves change places.

use crate::clips;
use std::path::PathBuf;
use vcgpdm::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary};
use vcgpdm::models::{Dataset, PoseWeight, Source, VariationalSettings};
use vcgpdm::motion::parts::presets;
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

/// The errors of the boundaries, in seconds, of three clips that were joined; `None`: other pieces were found.
fn boundary_errors(library: &TrainedLibrary, clips: [&Clip; 3], expected: [usize; 3]) -> Option<[f64; 2]> {
    let segments = library.recognise(&clips).unwrap().segments();
    let found: Vec<usize> = segments.iter().map(|segment| segment.movement).collect();
    if found != expected {
        return None;
    }
    let step = clips[0].frame_time;
    let first = clips[0].frames() as f64 * step;
    let second = first + clips[1].frames() as f64 * step;
    let end = |piece: usize| segments[piece].frames.end as f64 * library.body.frame_time;
    Some([(end(0) - first).abs(), (end(1) - second).abs()])
}

pub fn run(folders: &[PathBuf]) {
    let movements = movements(folders);
    let count = movements.len();
    let mut shares = vec![vec![Vec::new(); count]; count];
    let (mut errors, mut joins) = (Vec::new(), 0);
    for half in 0..2 {
        eprintln!("half {} of 2", half + 1);
        let library = library(&movements, half);
        let held_out: Vec<Vec<&Clip>> = movements.iter().map(|trials| trials.half(1 - half)).collect();
        for (truth, clips) in held_out.iter().enumerate() {
            for clip in clips {
                let found = library.recognise(&[clip]).unwrap().shares();
                shares[truth].iter_mut().zip(found).for_each(|(all, share)| all.push(share));
            }
        }
        for outer in 0..count {
            for inner in (0..count).filter(|inner| *inner != outer) {
                let (a, b) = (&held_out[outer], &held_out[inner]);
                let clips = [a[0], b[0], a[a.len() - 1]];
                joins += 1;
                errors.extend(boundary_errors(&library, clips, [outer, inner, outer]).into_iter().flatten());
            }
        }
    }
    let names: Vec<&str> = movements.iter().map(|trials| trials.name.as_str()).collect();
    let heads: Vec<String> = names.iter().map(|name| format!("frames of {name}")).collect();
    println!("| movement | trials | {} |", heads.join(" | "));
    println!("{}|", "|---".repeat(2 + count));
    for (truth, name) in names.iter().enumerate() {
        let cells: Vec<String> = shares[truth]
            .iter()
            .map(|shares| format!("{:.0} %", 100.0 * shares.iter().sum::<f64>() / shares.len() as f64))
            .collect();
        println!("| {name} | {} | {} |", movements[truth].clips.len(), cells.join(" | "));
    }
    println!(
        "\n{} of {joins} clips joined from three pieces are cut into these three; their boundaries are off by {:.2} s (median; at most {:.2} s).",
        errors.len() / 2,
        median(&errors),
        errors.iter().copied().fold(0.0, f64::max)
    );
}
