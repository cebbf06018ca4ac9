//! Prints, as Markdown, how much faster one training is in several threads:
//!
//! ```sh
//! cargo run --release --features threads --example threads -- [2]
//! ```
//!
//! The data are those of the example `scaling`, in two parts. Evaluations of the bound with its gradient and
//! whole iterations, in one thread and in so many as are asked for (absent: 2), in turn.
#![allow(missing_docs, clippy::disallowed_methods, clippy::unwrap_used)]

#[path = "shared/long_walks.rs"]
mod long_walks;

use long_walks::{split, walks};
use std::time::Instant;
use vcgpdm::models::VariationalSettings;
use vcgpdm::models::variational::Trainer;

/// Iterations of the first block and enough others for the optimiser to have filled its memory.
const BEFORE: usize = 50;
const ROUNDS: usize = 7;
/// Seconds that a measurement takes at least.
const LEAST: f64 = 0.3;
/// So few iterations in all that no training settles.
const MOST_STEPS: u32 = 30;

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
    let (one, many) = (one[one.len() / 2], many[many.len() / 2]);
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
        // The same training twice, which takes the same steps whatever the threads.
        let mut trainers = [1, threads].map(|threads| {
            let mut trainer = Trainer::new(split(&y, 2), lengths.clone(), &settings, 0).unwrap();
            trainer.use_threads(threads);
            while trainer.step().iteration < BEFORE {}
            trainer
        });
        let (objective, params) = (trainers[0].objective(), trainers[0].best());
        let (mut evaluations, mut iterations) = ([Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
        let mut steps = MOST_STEPS;
        for round in 0..2 * ROUNDS {
            let threads = if round % 2 == 0 { 1 } else { threads };
            let mut workspace = objective.workspace(&params);
            workspace.use_threads(threads);
            let mut evaluate = || objective.compute_with_gradient(&params, &mut workspace).unwrap();
            evaluate();
            evaluations[round % 2].push(ms(evaluate));
            let begin = Instant::now();
            (0..steps).for_each(|_| drop(trainers[round % 2].step()));
            let each = begin.elapsed().as_secs_f64() / f64::from(steps);
            // The first round says how many are enough.
            if round > 1 {
                iterations[round % 2].push(1e3 * each);
            } else if round == 1 {
                steps = ((LEAST / each).ceil() as u32).clamp(3, MOST_STEPS);
            }
        }
        let [of_one, of_many] = evaluations;
        let [one, many] = iterations;
        println!("| {frames} | {ips} + {ips} | {} | {} |", words(of_one, of_many), words(one, many));
    }
}
