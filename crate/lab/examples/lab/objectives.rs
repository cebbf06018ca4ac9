//! Models trained with weighted pose terms or without couplings, compared with plain ones (docs/training.md).
//!
//! Each folder has the clips (.bvh) of one movement of one person. Each trial is held out in turn.

use crate::clips::{FolderTrainings, read_clips};
use crate::parallel::each_seed;
use crate::ratio::{ERRORS, ErrorOf, over_folders, over_trials};
use std::time::Instant;
use vcgpdm::models::{PoseWeight, Settings, VariationalSettings};
use vcgpdm::motion::Clip;
use vcgpdm::motion::parts::presets;
use vcgpdm_lab::evaluation::{Fold, Outcome, START_FRAMES};

const FRAMES_PER_SECOND: f64 = 30.0;
const DYNAMICS_IPS: usize = 12;
const POSE_IPS: [usize; 2] = [12, 30];
/// The first weight is the plain bound.
const WEIGHTS: [(&str, PoseWeight); 4] = [
    ("1", PoseWeight::Fixed(1.0)),
    ("0.3", PoseWeight::Fixed(0.3)),
    ("0.1", PoseWeight::Fixed(0.1)),
    ("balanced", PoseWeight::Balanced),
];
type ModelOf = fn(VariationalSettings) -> Settings;
const MODELS: [(&str, ModelOf); 2] = [("vCGPDM", Settings::Vcgpdm), ("vGPDM", Settings::Vgpdm)];

/// The outcomes of a candidate for each trial held out, from every seed.
type OfTrials = Vec<Vec<Outcome>>;

/// Two candidates, by their places in [`candidates`].
struct Pair {
    title: String,
    first: usize,
    second: usize,
}

/// For both models every weight with both sizes, and last the uncoupled vCGPDM.
fn candidates() -> Vec<Settings> {
    let settings = |pose_ips, pose_weight| VariationalSettings {
        dynamics_ips: DYNAMICS_IPS,
        pose_ips,
        pose_weight,
        ..VariationalSettings::default()
    };
    let mut all = Vec::new();
    for (_, model) in MODELS {
        for pose_ips in POSE_IPS {
            all.extend(WEIGHTS.map(|(_, weight)| model(settings(pose_ips, weight))));
        }
    }
    let plain = settings(POSE_IPS[0], PoseWeight::Fixed(1.0));
    all.push(Settings::Vcgpdm(VariationalSettings { uncoupled: true, ..plain }));
    all
}

/// Every weight against the plain bound, many pose points against few, and no couplings against couplings.
fn pairs() -> Vec<Pair> {
    let place =
        |model: usize, size: usize, weight: usize| (model * POSE_IPS.len() + size) * WEIGHTS.len() + weight;
    let mut pairs = Vec::new();
    for (model, (name, _)) in MODELS.iter().enumerate() {
        for (size, pose_ips) in POSE_IPS.iter().enumerate() {
            for (weight, (word, _)) in WEIGHTS.iter().enumerate().skip(1) {
                let title = format!("{name}, {DYNAMICS_IPS} + {pose_ips} points, {word} : 1");
                pairs.push(Pair { title, first: place(model, size, weight), second: place(model, size, 0) });
            }
        }
        for (weight, (word, _)) in WEIGHTS.iter().enumerate() {
            let title = format!("{name}, weight {word}, {} : {} pose points", POSE_IPS[1], POSE_IPS[0]);
            pairs.push(Pair { title, first: place(model, 1, weight), second: place(model, 0, weight) });
        }
    }
    let uncoupled = MODELS.len() * POSE_IPS.len() * WEIGHTS.len();
    pairs.push(Pair { title: "vCGPDM, uncoupled : coupled".to_owned(), first: uncoupled, second: 0 });
    pairs
}

/// The outcomes of every candidate.
fn outcomes(name: &str, trials: &[Clip], arguments: &FolderTrainings) -> Vec<OfTrials> {
    let preset = presets(&trials[0].skeleton).into_iter().find(|preset| preset.id == "lower-upper").unwrap();
    let clock = Instant::now();
    let candidates = candidates();
    let mut found = vec![OfTrials::new(); candidates.len()];
    for held_out in 0..trials.len() {
        let seconds = clock.elapsed().as_secs_f64();
        eprintln!("{name}: trial {} of {} held out, {seconds:.0} s", held_out + 1, trials.len());
        let training = trials.len() - 1;
        let fold =
            Fold::new(trials, held_out, training, &preset.parts, FRAMES_PER_SECOND, START_FRAMES).unwrap();
        for (candidate, found) in candidates.iter().zip(&mut found) {
            let seconds = || clock.elapsed().as_secs_f64();
            found.push(each_seed(0..arguments.seeds, arguments.threads, |seed| {
                fold.evaluate(&candidate.clone().into(), seed, &seconds, &mut |_| true).unwrap().unwrap()
            }));
        }
    }
    found
}

fn row(trials: &str, title: &str, cell: impl Fn(ErrorOf) -> String) {
    println!("| {trials} | {title} | {} |", ERRORS.map(|(_, error)| cell(error)).join(" | "));
}

pub fn run(arguments: &FolderTrainings) {
    println!("{} seeds.\n", arguments.seeds);
    println!("| trials | ratio of the errors | {} |", ERRORS.map(|(name, _)| name).join(" | "));
    println!("{}|", "|---".repeat(2 + ERRORS.len()));
    let mut all = Vec::new();
    for folder in &arguments.folders {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let trials: Vec<Clip> = read_clips(std::slice::from_ref(folder)).collect();
        let found = outcomes(&name, &trials, arguments);
        for Pair { title, first, second } in pairs() {
            row(&name, &title, |error| over_trials(&found[first], &found[second], error));
        }
        all.push(found);
    }
    if all.len() < 2 {
        return;
    }
    for Pair { title, first, second } in pairs() {
        let folders: Vec<_> = all.iter().map(|found| (&found[first][..], &found[second][..])).collect();
        row("all folders", &title, |error| over_folders(&folders, error));
    }
}
