//! The schedule of Velychko et al. (2018, sections 5 and 5.2) beside ours (docs/training.md): everything jointly,
//! then at most four rounds of three blocks. Each trial of a person is held out once. The objective is the bound.

use crate::parallel::each_seed;
use crate::ratios::{persons, ratio};
use clap::Args;
use std::path::PathBuf;
use vcgpdm::models::variational::VariationalTrainer;
use vcgpdm::models::{FittedModel, Group, Phase, VariationalSettings};
use vcgpdm::motion::{Clip, parts};
use vcgpdm_lab::evaluation::{Fold, START_FRAMES, dtw_mse, stats};

const ROUNDS: usize = 4;
/// Enough for as many evaluations as theirs.
const MOST_ITERATIONS: usize = 5000;
const BLOCKS: [&[Group]; 3] =
    [&[Group::Latents], &[Group::Kernels, Group::Couplings], &[Group::InducingInputs]];
const EVERYTHING: &[Group] = &[Group::Latents, Group::Couplings, Group::Kernels, Group::InducingInputs];
/// What is compared with what, by the places in the results of a training: ours, theirs, ours for longer.
const COMPARED: [(&str, usize, usize); 3] =
    [("theirs : ours", 1, 0), ("ours, longer : ours", 2, 0), ("theirs : ours, longer", 1, 2)];

#[derive(Args)]
pub struct Arguments {
    /// Folders with the trials (BVH) of one person each; absent: the sample walks.
    folders: Vec<PathBuf>,
    /// Seeds, from 0. A trial counts with the geometric mean of its errors.
    #[arg(long, default_value_t = 3)]
    seeds: u32,
    /// Iterations of ours, and of the joint part of theirs.
    #[arg(long, default_value_t = VariationalSettings::default().max_iterations)]
    iterations: usize,
    /// Iterations of each of their blocks; the papers name no number.
    #[arg(long, default_value_t = 50)]
    block: usize,
    /// Trainings at a time.
    #[arg(long, default_value_t = 1)]
    threads: usize,
}

/// A training: the logarithm of its error on the trial held out, its bound, and the evaluations.
#[derive(Clone, Copy)]
struct Trained {
    error: f64,
    bound: f64,
    evaluations: f64,
}

pub fn run(arguments: &Arguments) {
    println!("| trials | schedules | error on the trial held out | bounds differ by, nats | evaluations |");
    println!("{}|", "|---".repeat(5));
    let persons = persons(&arguments.folders).map(|(name, clips)| trials(&name, &clips, arguments));
    let persons: Vec<Vec<[Trained; 3]>> = persons.collect();
    let means: Vec<[Trained; 3]> = persons.iter().map(|trials| mean_of(trials)).collect();
    print(&format!("{} persons", means.len()), &means);
}

/// Holds out each trial in turn, and prints a row for each two schedules.
fn trials(name: &str, clips: &[Clip], arguments: &Arguments) -> Vec<[Trained; 3]> {
    let presets = parts::presets(&clips[0].skeleton);
    let parts = &presets.iter().find(|preset| preset.id == "lower-upper").unwrap().parts;
    let held_out = (0..clips.len()).map(|trial| {
        let fold = Fold::new(clips, trial, clips.len() - 1, parts, 30.0, START_FRAMES).unwrap();
        let seeds = each_seed(0..arguments.seeds, arguments.threads, |seed| train(&fold, arguments, seed));
        eprintln!("{name}, trial {}", trial + 1);
        mean_of(&seeds)
    });
    let trials: Vec<[Trained; 3]> = held_out.collect();
    print(name, &trials);
    trials
}

/// The trainings of one fold: ours, theirs, and ours with as many evaluations as theirs.
fn train(fold: &Fold, arguments: &Arguments, seed: u32) -> [Trained; 3] {
    let movements = fold.movements();
    let lengths = || movements.sequences.iter().map(|sequence| sequence.frames).collect();
    let Arguments { iterations, block, .. } = *arguments;
    let settings = |iterations| VariationalSettings::default().with_max_iterations(iterations);
    let (short, long) = (settings(iterations), settings(MOST_ITERATIONS));
    let blocked = settings(iterations + ROUNDS * BLOCKS.len() * block);
    let ours = |settings| VariationalTrainer::new(movements.y.clone(), lengths(), settings, seed).unwrap();
    let start = ours(&long);
    let blocks = BLOCKS.map(|groups| Phase { groups, iterations: block });
    let mut phases = vec![Phase { groups: EVERYTHING, iterations }];
    phases.extend(std::iter::repeat_n(blocks, ROUNDS).flatten());
    let theirs =
        VariationalTrainer::from_start(start.objective(), start.best(), phases, &blocked, seed).unwrap();
    let theirs = trained(fold, theirs, usize::MAX);
    [trained(fold, ours(&short), usize::MAX), theirs, trained(fold, start, theirs.evaluations as usize)]
}

/// The training until its end, or until this number of evaluations.
fn trained(fold: &Fold, mut trainer: VariationalTrainer, evaluations: usize) -> Trained {
    let mut progress = trainer.progress();
    while !progress.done && progress.evaluations < evaluations {
        progress = trainer.step();
    }
    let model = FittedModel::Vcgpdm(Box::new(trainer.model().unwrap()));
    let error = dtw_mse(&fold.predict(&model).unwrap(), fold.actual()).unwrap().dtw_mse;
    Trained { error: error.ln(), bound: progress.best, evaluations: progress.evaluations as f64 }
}

/// The means over seeds or trials.
fn mean_of(all: &[[Trained; 3]]) -> [Trained; 3] {
    std::array::from_fn(|schedule| {
        let mean = |number: fn(&Trained) -> f64| {
            stats::mean(&all.iter().map(|one| number(&one[schedule])).collect::<Vec<_>>())
        };
        Trained {
            error: mean(|one| one.error),
            bound: mean(|one| one.bound),
            evaluations: mean(|one| one.evaluations),
        }
    })
}

/// Prints a row for each two schedules; the units are trials, or persons.
fn print(name: &str, units: &[[Trained; 3]]) {
    for (schedules, a, b) in COMPARED {
        let errors = |which: usize| units.iter().map(|unit| unit[which].error.exp()).collect::<Vec<_>>();
        let [ours, other] = [b, a].map(|which| mean_of(units)[which]);
        println!(
            "| {name} | {schedules} | {} | {:+.0} | {:.0} : {:.0} |",
            ratio(&errors(a), &errors(b)),
            other.bound - ours.bound,
            other.evaluations,
            ours.evaluations,
        );
    }
}
