//! Trains models of clips from several seeds, with more or fewer inducing points and parts, and counts those
//! that keep moving:
//!
//! ```sh
//! cargo run --release --example keeps_moving -- CLIP.bvh ... [--seeds 10] [--points 12,20,30] [--parts whole,lower-upper]
//! ```
//!
//! Each clip is trained on alone. Without a clip the first bundled walk is used. A model keeps moving where
//! its rollout does, or rests as the recording does; how each seed ends is on stderr. Bounds are smallest /
//! middle / largest of the seeds.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

#[path = "shared/alone.rs"]
mod alone;
#[path = "shared/seeds.rs"]
mod seeds;

use alone::{Alone, alone};
use clap::Parser;
use seeds::{each_seed, near, range};
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm::Trainer;
use vcgpdm::models::{Dataset, Health, RolloutRequest, VariationalSettings, best_to_show};

/// So many seeds are trained from together where nobody asks for another number.
const GROUP: usize = 4;

#[derive(Parser)]
struct Arguments {
    /// BVH files, or folders of them; absent: a bundled walk.
    clips: Vec<PathBuf>,
    /// Seeds, from 0.
    #[arg(long, default_value_t = 10)]
    seeds: u32,
    /// Inducing points, of the dynamics as of the poses.
    #[arg(long, value_delimiter = ',', default_values_t = [12, 20, 30])]
    points: Vec<usize>,
    /// Presets of parts.
    #[arg(long, value_delimiter = ',', default_values_t = ["whole", "lower-upper", "legs-trunk-arms"].map(str::to_owned))]
    parts: Vec<String>,
    /// Orders of the dynamics.
    #[arg(long, value_delimiter = ',', default_values_t = [2])]
    orders: Vec<usize>,
    /// Iterations at most.
    #[arg(long, value_delimiter = ',', default_values_t = [600])]
    iterations: Vec<usize>,
    /// Frames of a rollout.
    #[arg(long, default_value_t = 300)]
    frames: usize,
    /// So many trainings at a time.
    #[arg(long, default_value_t = 1)]
    threads: usize,
}

impl Arguments {
    /// Inducing points, order and iterations of each column of seeds.
    fn settings(&self) -> Vec<(usize, usize, usize)> {
        let mut all = Vec::new();
        for &points in &self.points {
            for &order in &self.orders {
                all.extend(self.iterations.iter().map(|&iterations| (points, order, iterations)));
            }
        }
        all
    }
}

/// What one training ended in.
#[derive(Clone, Copy)]
struct Run {
    bound: f64,
    seconds: f64,
    health: Health,
}

fn run(dataset: &Dataset, settings: &VariationalSettings, seed: u32, frames: usize) -> Run {
    let begin = Instant::now();
    let mut trainer = Trainer::new(dataset, &settings.clone().into(), seed).unwrap();
    while !trainer.step().done {}
    let seconds = begin.elapsed().as_secs_f64();
    let model = trainer.finish().unwrap();
    let request = RolloutRequest { frames, ..Default::default() };
    let model = model.coupled().unwrap();
    let rollout = model.rollout(&request).unwrap();
    let positions = model.positions(&rollout).unwrap();
    let health = model.health(&rollout, &request, &positions).unwrap();
    Run { bound: trainer.progress().best, seconds, health }
}

fn word(health: &Health) -> String {
    match health {
        Health::MovesOn => "moves".to_owned(),
        Health::StandsStill { from } => format!("still {from:.1}"),
        Health::LeavesTraining { from, .. } => format!("leaves {from:.1}"),
        other => format!("{other:?}"),
    }
}

fn main() {
    let arguments = Arguments::parse();
    println!(
        "| clip | parts | points | p | iterations | seeds that keep moving | chosen of {GROUP} seeds | bound | within 0.5 % of the best | s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for Alone { clip, preset, dataset } in alone(&arguments.clips, &arguments.parts) {
        eprintln!("{clip} rests from {:?} s", dataset.sequences[0].rests_from);
        for (points, order, iterations) in arguments.settings() {
            let settings = VariationalSettings {
                latent: 3,
                order,
                dynamics_ips: points,
                pose_ips: points,
                max_iterations: iterations,
            };
            let train = |seed| run(&dataset, &settings, seed, arguments.frames);
            let runs = each_seed(arguments.seeds, arguments.threads, train);
            let moves = |run: &Run| run.health.rank() == Health::MovesOn.rank();
            let moving = runs.iter().filter(|run| moves(run)).count();
            let groups: Vec<&[Run]> = runs.chunks_exact(GROUP).collect();
            let chosen = groups.iter().filter(|group| {
                let best = best_to_show(group.iter().map(|run| (run.health.rank(), run.bound)));
                best.is_some_and(|place| moves(&group[place]))
            });
            let chosen = chosen.count();
            let each: Vec<String> =
                runs.iter().map(|run| format!("{} ({:.0})", word(&run.health), run.bound)).collect();
            let bounds = || runs.iter().map(|run| run.bound);
            let near = near(bounds(), bounds().fold(f64::NEG_INFINITY, f64::max));
            let bounds = range(bounds(), 0);
            let seconds = runs.iter().map(|run| run.seconds).sum::<f64>() / runs.len().max(1) as f64;
            eprintln!("{clip} {preset} {points}: {}", each.join(", "));
            println!(
                "| {clip} | {preset} | {points} | {order} | {iterations} | {moving} of {} | {chosen} of {} | {bounds} | {near} | {seconds:.1} |",
                runs.len(),
                groups.len()
            );
        }
    }
}
