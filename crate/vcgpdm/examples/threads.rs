//! Prints, as Markdown, how much faster one training is in several threads:
//!
//! ```sh
//! cargo run --release --features threads --example threads -- [2]
//! ```
//!
//! The data are those of the example `scaling`, in two parts. Evaluations of the bound with its gradient and whole iterations, of which
//! the optimiser's own work is one thread's, in one thread and in so many as are asked for (absent: 2), in turn.
#![allow(missing_docs, clippy::disallowed_methods, clippy::unwrap_used)]

#[path = "shared/long_walks.rs"]
mod long_walks;

use long_walks::{split, walks};
use std::time::Instant;
use vcgpdm::models::VariationalSettings;
use vcgpdm::models::variational::Trainer;

/// Iterations enough for the optimiser to have filled its memory.
const BEFORE: usize = 45;
const ROUNDS: usize = 7;
/// Seconds that a measurement takes at least.
const LEAST: f64 = 0.3;

/// Milliseconds of one of the things that are done again and again.
fn ms(mut what: impl FnMut()) -> f64 {
    let begin = Instant::now();
    let mut count = 0;
    while count < 3 || begin.elapsed().as_secs_f64() < LEAST {
        what();
        count += 1;
    }
    1e3 * begin.elapsed().as_secs_f64() / f64::from(count)
}

/// The middle of several measurements, with the one thread's beside it and the ratio.
fn words(mut one: Vec<f64>, mut many: Vec<f64>) -> String {
    for times in [&mut one, &mut many] {
        times.sort_by(f64::total_cmp);
    }
    let (one, many) = (one[ROUNDS / 2], many[ROUNDS / 2]);
    format!("{one:.2} | {many:.2} | {:.2}", one / many)
}

fn main() {
    let threads: usize = std::env::args().nth(1).map_or(2, |word| word.parse().unwrap());
    println!(
        "| frames | inducing points | an evaluation, ms: 1 thread | {threads} threads | times faster | an iteration, ms: 1 thread | {threads} threads | times faster |"
    );
    println!("{}|", "|---".repeat(8));
    for (frames, ips) in [(500, 12), (2000, 12), (16_000, 12), (16_000, 20), (16_000, 30)] {
        let (y, lengths) = walks(frames);
        let settings = VariationalSettings {
            dynamics_ips: ips,
            pose_ips: ips,
            max_iterations: 100_000,
            ..VariationalSettings::default()
        };
        let mut trainer = Trainer::new(split(&y, 2), lengths, &settings, 0).unwrap();
        while trainer.step().iteration < BEFORE {}
        let (objective, params) = (trainer.objective(), trainer.best());
        let (mut evaluations, mut iterations) = ([Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
        for round in 0..2 * ROUNDS {
            let threads = if round % 2 == 0 { 1 } else { threads };
            let mut workspace = objective.workspace(&params);
            workspace.use_threads(threads);
            let mut evaluate = || objective.compute_with_gradient(&params, &mut workspace).unwrap();
            evaluate();
            evaluations[round % 2].push(ms(evaluate));
            trainer.use_threads(threads);
            trainer.step();
            iterations[round % 2].push(ms(|| {
                trainer.step();
            }));
        }
        let [of_one, of_many] = evaluations;
        let [one, many] = iterations;
        println!("| {frames} | {ips} + {ips} | {} | {} |", words(of_one, of_many), words(one, many));
    }
}
