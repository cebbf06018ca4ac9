//! Models trained with balanced pose terms or without couplings, compared with plain ones (docs/training.md).
//!
//! Each folder has the clips (.bvh) of one person. Each trial is held out in turn.

use crate::clips;
use crate::ratio::ratio;
use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm::models::{PoseWeight, Settings, VariationalSettings};
use vcgpdm::motion::Clip;
use vcgpdm::motion::parts::presets;
use vcgpdm_lab::evaluation::{Fold, Outcome, START_FRAMES};

const FRAMES_PER_SECOND: f64 = 30.0;
const SEEDS: Range<u32> = 0..3;
const DYNAMICS_IPS: usize = 10;
const POSE_IPS: usize = 30;

/// Two candidates, by their places in [`candidates`].
const PAIRS: [(&str, usize, usize); 3] = [
    ("vCGPDM, balanced : plain", 1, 0),
    ("vGPDM, balanced : plain", 3, 2),
    ("vCGPDM, uncoupled : coupled", 4, 0),
];

fn candidates() -> [Settings; 5] {
    let plain = VariationalSettings {
        dynamics_ips: DYNAMICS_IPS,
        pose_ips: POSE_IPS,
        ..VariationalSettings::default()
    };
    let balanced = VariationalSettings { pose_weight: PoseWeight::Balanced, ..plain.clone() };
    let uncoupled = VariationalSettings { uncoupled: true, ..plain.clone() };
    [
        Settings::Vcgpdm(plain.clone()),
        Settings::Vcgpdm(balanced.clone()),
        Settings::Vgpdm(plain),
        Settings::Vgpdm(balanced),
        Settings::Vcgpdm(uncoupled),
    ]
}

/// The outcomes of every candidate for each trial held out, from every seed.
fn outcomes(name: &str, trials: &[Clip]) -> Vec<[Vec<Outcome>; 5]> {
    let preset = presets(&trials[0].skeleton).into_iter().find(|preset| preset.id == "lower-upper").unwrap();
    let clock = Instant::now();
    let fold = |held_out| {
        eprintln!("{name}: trial {} of {} held out", held_out + 1, trials.len());
        let training = trials.len() - 1;
        let fold =
            Fold::new(trials, held_out, training, &preset.parts, FRAMES_PER_SECOND, START_FRAMES).unwrap();
        candidates().map(|candidate| {
            let seconds = || clock.elapsed().as_secs_f64();
            SEEDS
                .map(|seed| fold.evaluate(&candidate, seed, &seconds, &mut |_| true).unwrap().unwrap())
                .collect()
        })
    };
    (0..trials.len()).map(fold).collect()
}

pub fn run(folders: &[PathBuf]) {
    println!("{DYNAMICS_IPS} + {POSE_IPS} inducing points, {} seeds.\n", SEEDS.len());
    println!(
        "| trials | ratio of the errors | held out | lower body | upper body | on the training trials |"
    );
    println!("{}|", "|---".repeat(6));
    for folder in folders {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let trials: Vec<Clip> = clips::read_clips(std::slice::from_ref(folder)).collect();
        let found = outcomes(&name, &trials);
        for (title, first, second) in PAIRS {
            let each = |place: usize| found.iter().map(|fold| &fold[place]).collect::<Vec<_>>();
            let (first, second) = (each(first), each(second));
            println!(
                "| {name} | {title} | {} | {} | {} | {} |",
                ratio(&first, &second, |o| o.score.dtw_mse),
                ratio(&first, &second, |o| o.part_errors[0]),
                ratio(&first, &second, |o| o.part_errors[1]),
                ratio(&first, &second, |o| o.training_mse.unwrap_or(f64::NAN)),
            );
        }
    }
}
