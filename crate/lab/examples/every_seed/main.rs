//! Trains from many seeds, by our start and schedule and by others, and prints what came of it as a Markdown
//! table:
//!
//! ```sh
//! cargo run --release --example every_seed -- [--clips FOLDER] [--parts whole,lower-upper] [--seeds 20] [--peer "python train.py"]
//! ```
//!
//! The protocol is that of Velychko et al. (2018, section 5.3): train on five trials and the first 5 frames
//! of a sixth, roll the model out from those for the length of the sixth trial and compare. Without a folder
//! the bundled walks are used.
#![allow(missing_docs, clippy::disallowed_methods, clippy::unwrap_used, clippy::panic)]

#[path = "../shared/clips.rs"]
mod clips;
#[path = "../shared/seeds.rs"]
mod seeds;
mod ways;

use clap::Parser;
use clips::read_clips;
use nalgebra::DMatrix;
use seeds::{each_seed, near, range};
use std::path::PathBuf;
use std::process::Command;
use std::time::Instant;
use vcgpdm::models::variational::{Objective, Params, SMALLEST_S, VariationalTrainer};
use vcgpdm::models::{Dataset, RolloutRequest, Source, VariationalSettings};
use vcgpdm::motion::parts::{PartSpec, PartsPreset};
use vcgpdm::motion::{Clip, Skeleton, parts, samples};
use vcgpdm_lab::evaluation::dtw_mse;
use vcgpdm_lab::evaluation::stats::rank_correlation;
use vcgpdm_lab::golden::Case;
use ways::{ITERATIONS, OTHERS, OURS, Way};

const START_FRAMES: usize = 5;
/// Evaluations after which a training may be judged.
const EARLY: [usize; 6] = [30, 40, 60, 80, 120, 160];
const FRAMES_PER_SECOND: f64 = 30.0;

#[derive(Parser)]
struct Arguments {
    /// A folder whose first six BVH files, by name, are trials of one body; absent: the bundled walks.
    #[arg(long)]
    clips: Option<PathBuf>,
    /// Splits of the body, by the ids of the presets, or `five`.
    #[arg(long, value_delimiter = ',', default_value = "whole,lower-upper")]
    parts: Vec<String>,
    /// Seeds of our own training, from 0.
    #[arg(long, default_value_t = 20)]
    seeds: u32,
    /// Seeds of each other way to train, from 0.
    #[arg(long, default_value_t = 8)]
    others: u32,
    /// Of the other ways only those that have these words in their schedule.
    #[arg(long, default_value = "")]
    schedule: String,
    /// A command that trains from a starting point in a file, named last, and prints a JSON object with
    /// "elbo", "evaluations" and, evaluation by evaluation, a "trace" of seconds and best bounds.
    #[arg(long)]
    peer: Option<String>,
    /// Seeds that the peer trains from, from 0.
    #[arg(long, default_value_t = 3)]
    peer_seeds: u32,
    /// Trainings at a time; absent: as many as there are cores.
    #[arg(long)]
    threads: Option<usize>,
}

/// The data of one split of the body.
struct Problem {
    title: String,
    dataset: Dataset,
    /// The bound as the trainer computes it, whatever the start.
    objective: Objective,
    /// The rows of the whole trial that is predicted.
    actual: DMatrix<f64>,
}

/// Evaluations, seconds and the best bound so far, iteration by iteration.
type Trace = Vec<(usize, f64, f64)>;

/// Evaluations and seconds until the bound `enough`.
fn until(trace: &Trace, enough: f64) -> Option<(usize, f64)> {
    trace.iter().find(|(.., best)| *best >= enough).map(|(evaluations, seconds, _)| (*evaluations, *seconds))
}

#[derive(Clone)]
struct Run {
    bound: f64,
    trace: Trace,
    mse: f64,
    still: bool,
    alpha: DMatrix<f64>,
    /// The share of the variances S that are as small as they can be.
    smallest: f64,
}

fn share_of_smallest(params: &Params) -> f64 {
    let all = || params.parts.iter().flat_map(|part| part.latents.variance.iter());
    all().filter(|s| **s < 1.01 * SMALLEST_S).count() as f64 / all().count() as f64
}

fn run(problem: &Problem, way: &Way, seed: u32) -> Run {
    let settings = VariationalSettings { max_iterations: 20 * ITERATIONS, ..VariationalSettings::default() };
    let begin = Instant::now();
    let mut trainer = trainer(problem, way, &settings, seed);
    let mut trace = Vec::new();
    let progress = loop {
        let progress = trainer.step();
        trace.push((progress.evaluations, begin.elapsed().as_secs_f64(), progress.best));
        let joint: usize = (way.phases)().iter().rev().skip(1).map(|phase| phase.iterations).sum();
        if progress.done || progress.iteration >= joint + ITERATIONS {
            break progress;
        }
    };
    let model = trainer.finish(&problem.dataset).unwrap();
    let model = model.coupled().unwrap();
    let request = |frames, sequence| {
        model.rollout(&RolloutRequest { frames, sequence, ..Default::default() }).unwrap().y
    };
    let last = problem.dataset.sequences.len() - 1;
    let mse = dtw_mse(&request(problem.actual.nrows(), last), &problem.actual).unwrap().dtw_mse;
    // No walk: what is left of the movement after ten seconds is a fifth of what the trial does, or the
    // prediction is hardly better than a motionless one.
    let end = request(300, 0).rows(240, 60).row_variance().sum().sqrt();
    let variance = problem.actual.row_variance().sum();
    let still = end < 0.2 * variance.sqrt() || mse > 0.5 * variance / problem.actual.ncols() as f64;
    let smallest = share_of_smallest(&trainer.best());
    Run { bound: progress.best, trace, mse, still, alpha: model.model.alpha.clone(), smallest }
}

impl Run {
    /// The best bound after at most so many evaluations.
    fn bound_after(&self, evaluations: usize) -> f64 {
        let early = self.trace.iter().take_while(|(so_far, ..)| *so_far <= evaluations);
        early.last().or(self.trace.first()).map_or(self.bound, |(.., best)| *best)
    }

    /// Evaluations and seconds of the whole training.
    fn whole(&self) -> (usize, f64) {
        self.trace.last().map_or((0, 0.0), |(evaluations, seconds, _)| (*evaluations, *seconds))
    }
}

fn trainer(problem: &Problem, way: &Way, settings: &VariationalSettings, seed: u32) -> VariationalTrainer {
    let objective = problem.objective.clone();
    let start = (way.begin)(objective.observations(), objective.sequences(), settings, seed);
    VariationalTrainer::from_start(objective, start, (way.phases)(), settings, seed).unwrap()
}

fn read_trials(folder: Option<&PathBuf>) -> Vec<Clip> {
    match folder {
        Some(folder) => read_clips(std::slice::from_ref(folder)).take(6).collect(),
        None => samples::list().iter().take(6).map(|sample| samples::clip(sample.id).unwrap()).collect(),
    }
}

/// A preset, or `five`: both legs, trunk with the root, both arms.
fn split(skeleton: &Skeleton, id: &str) -> PartsPreset {
    let preset = |id: &str| parts::presets(skeleton).into_iter().find(|p| p.id == id).unwrap();
    if id != "five" {
        return preset(id);
    }
    let mut four = preset("legs-trunk-arms").parts;
    let legs = four.remove(0).joints;
    // Each leg hangs on a child of the root.
    let branch = |mut joint: usize| {
        while let Some(parent) = skeleton.joints[joint].parent.filter(|parent| *parent > 0) {
            joint = parent;
        }
        joint
    };
    let mut of_legs: Vec<PartSpec> = Vec::new();
    for joint in legs {
        let name = skeleton.joints[branch(joint)].name.clone();
        if joint == 0 {
            four[0].joints.insert(0, 0);
        } else if let Some(leg) = of_legs.iter_mut().find(|leg| leg.name == name) {
            leg.joints.push(joint);
        } else {
            of_legs.push(PartSpec { name, joints: vec![joint] });
        }
    }
    of_legs.append(&mut four);
    PartsPreset { id: id.to_owned(), title: "Both legs, trunk, both arms".to_owned(), parts: of_legs }
}

fn problem(trials: &[Clip], preset: &str) -> Problem {
    let chosen = split(&trials[0].skeleton, preset);
    let sources: Vec<Source> = trials
        .iter()
        .enumerate()
        .map(|(k, clip)| Source { clip, first_frames: (k + 1 == trials.len()).then_some(START_FRAMES) })
        .collect();
    let dataset = Dataset::new(&sources, &chosen.parts, FRAMES_PER_SECOND).unwrap();
    let trial = trials[trials.len() - 1].resample(1.0 / dataset.frame_time).unwrap();
    let actual = dataset.mapping.encode(&trial).unwrap().y;
    let trainer =
        VariationalTrainer::new(dataset.y.clone(), dataset.lengths(), &VariationalSettings::default(), 0)
            .unwrap();
    Problem { title: chosen.title, objective: trainer.objective(), dataset, actual }
}

/// The runs of a way, seed by seed, several at a time.
fn runs(problem: &Problem, way: &Way, seeds: u32, threads: usize) -> Vec<Run> {
    each_seed(seeds, threads, |seed| {
        let run = run(problem, way, seed);
        eprintln!("{}, {}, seed {seed}: {:.0}", way.start, way.schedule, run.bound);
        run
    })
}

/// What another program makes of our starts: bounds, and how they were reached.
fn peer(problem: &Problem, command: &str, seeds: u32) -> Vec<(f64, Trace)> {
    let file = std::env::temp_dir().join(format!("every-seed-{}.json", std::process::id()));
    let found = (0..seeds).map(|seed| {
        let trainer = trainer(problem, &OURS, &VariationalSettings::default(), seed);
        std::fs::write(&file, Case::write(&trainer.best(), &trainer.objective()).unwrap()).unwrap();
        let mut words = command.split_whitespace();
        let output = Command::new(words.next().unwrap()).args(words).arg(&file).output().unwrap();
        let text = String::from_utf8_lossy(&output.stdout);
        let result: serde_json::Value = serde_json::from_str(&text)
            .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)));
        eprintln!("peer, seed {seed}: {}", result["elbo"]);
        let evaluations = result["evaluations"].as_f64().unwrap();
        let listed: Vec<[f64; 2]> = serde_json::from_value(result["trace"].clone()).unwrap();
        // It may list only some of them, evenly.
        let every = evaluations / listed.len() as f64;
        let at = |k: usize| ((k + 1) as f64 * every).round() as usize;
        let trace = listed.iter().enumerate().map(|(k, [seconds, best])| (at(k), *seconds, *best));
        (result["elbo"].as_f64().unwrap(), trace.collect())
    });
    let found = found.collect();
    let _ = std::fs::remove_file(&file);
    found
}

fn main() {
    let arguments = Arguments::parse();
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = arguments.threads.unwrap_or(cores);
    let trials = read_trials(arguments.clips.as_ref());
    for preset in &arguments.parts {
        let problem = problem(&trials, preset);
        let frames: usize = problem.dataset.lengths().iter().sum();
        let variance = problem.actual.row_variance().sum() / problem.actual.ncols() as f64;
        println!("## {}\n", problem.title);
        println!("{frames} frames; a motionless prediction scores about {variance:.5}.\n");
        let ours = runs(&problem, &OURS, arguments.seeds, threads);
        let mut all = vec![(OURS, ours.clone())];
        let others = OTHERS.into_iter().filter(|way| way.schedule.contains(&arguments.schedule));
        all.extend(others.map(|way| (way, runs(&problem, &way, arguments.others, threads))));
        let peers = arguments.peer.as_ref().map(|command| peer(&problem, command, arguments.peer_seeds));
        let bounds = all.iter().flat_map(|(_, runs)| runs.iter().map(|run| run.bound));
        let best = bounds.chain(peers.iter().flatten().map(|p| p.0)).fold(f64::NEG_INFINITY, f64::max);
        let enough = best - 1e-3 * best.abs();
        println!("Best bound of all: {best:.0}. Numbers with slashes are smallest / middle / largest.\n");
        println!(
            "| start | schedule | seeds | within 0.5 % | within 0.1 % | bound | DTW MSE | no walk | evaluations | to within 0.1 %: evaluations | seconds |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|---|");
        for (way, runs) in all.iter().filter(|(_, runs)| !runs.is_empty()) {
            let near = near(runs.iter().map(|run| run.bound), best);
            let until: Vec<(usize, f64)> = runs.iter().filter_map(|run| until(&run.trace, enough)).collect();
            println!(
                "| {} | {} | {} | {near} | {} | {} | {} | {} | {} | {} | {} |",
                way.start,
                way.schedule,
                runs.len(),
                until.len(),
                range(runs.iter().map(|run| run.bound), 0),
                range(runs.iter().map(|run| run.mse), 5),
                runs.iter().filter(|run| run.still).count(),
                range(runs.iter().map(|run| run.whole().0 as f64), 0),
                range(until.iter().map(|(evaluations, _)| *evaluations as f64), 0),
                range(until.iter().map(|(_, seconds)| *seconds), 1),
            );
        }
        if let Some(peers) = peers {
            let near = near(peers.iter().map(|p| p.0), best);
            let reached: Vec<(usize, f64)> =
                peers.iter().filter_map(|(_, trace)| until(trace, enough)).collect();
            let whole = |of: fn(&(usize, f64, f64)) -> f64| {
                range(peers.iter().filter_map(|(_, trace)| trace.last()).map(of), 0)
            };
            println!(
                "| ours | the peer's, from our starts ({} s in all) | {} | {near} | {} | {} | | | {} | {} | {} |",
                whole(|last| last.1),
                peers.len(),
                reached.len(),
                range(peers.iter().map(|p| p.0), 0),
                whole(|last| last.0 as f64),
                range(reached.iter().map(|(evaluations, _)| *evaluations as f64), 0),
                range(reached.iter().map(|(_, seconds)| *seconds), 1),
            );
        }
        println!();
        println!(
            "Seconds of a whole training of ours: {}.\n",
            range(ours.iter().map(|run| run.whole().1), 1)
        );
        println!(
            "Share of the variances S that are as small as they can be: {}.\n",
            range(ours.iter().map(|run| run.smallest), 2)
        );
        foretold(&all);
        who_drives_whom(&problem, &ours);
    }
}

/// Whether the bound early in a training tells where it ends: if it did, the best of several short ones could
/// be continued.
fn foretold(all: &[(Way, Vec<Run>)]) {
    println!("Rank correlation over the seeds of the bound after so many evaluations with the last one:\n");
    println!(
        "| start | schedule | {} |\n|---|---|{}",
        EARLY.map(|n| n.to_string()).join(" | "),
        "---|".repeat(EARLY.len())
    );
    for (way, runs) in all.iter().filter(|(_, runs)| runs.len() >= 8) {
        let correlation = |evaluations: usize| {
            let pairs: Vec<(f64, f64)> =
                runs.iter().map(|run| (run.bound_after(evaluations), run.bound)).collect();
            rank_correlation(&pairs).map_or(String::new(), |r| format!("{r:.2}"))
        };
        println!("| {} | {} | {} |", way.start, way.schedule, EARLY.map(correlation).join(" | "));
    }
    println!();
}

/// Coupling variances alpha over the seeds, and how often each says that a part drives another.
fn who_drives_whom(problem: &Problem, runs: &[Run]) {
    let names: Vec<&str> = problem.dataset.layout.parts().iter().map(|part| part.name.as_str()).collect();
    if names.len() < 2 {
        return;
    }
    println!("| coupling | alpha | weight w | seeds with w at least 0.1 |\n|---|---|---|---|");
    for (j, source) in names.iter().enumerate() {
        for (i, target) in names.iter().enumerate() {
            let weights: Vec<f64> = runs
                .iter()
                .map(|run| vcgpdm::models::coupling_weights(run.alpha.column(i).as_slice()).1[j])
                .collect();
            println!(
                "| {source} to {target} | {} | {} | {} of {} |",
                range(runs.iter().map(|run| run.alpha[(j, i)]), 3),
                range(weights.iter().copied(), 3),
                weights.iter().filter(|w| **w >= 0.1).count(),
                runs.len()
            );
        }
    }
    println!();
}
