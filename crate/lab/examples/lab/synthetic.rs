//! The synthetic experiment of Velychko et al. (2018, section 5.1) from many seeds, as Markdown tables. A
//! seed is that of the data and of the training.

use crate::parallel::each_seed;
use clap::Args;
use std::time::Instant;
use vcgpdm_core::models::VariationalSettings;
use vcgpdm_lab::evaluation::Effect;
use vcgpdm_lab::synthetic::{DRIVE, Experiment, Findings, Fit, Snapshot, Synthetic};

#[derive(Args)]
pub struct Arguments {
    #[arg(long, default_value_t = 10)]
    seeds: u32,
    /// The first seed.
    #[arg(long, default_value_t = 0)]
    first: u32,
    /// The share of the first part's dynamics in the second.
    #[arg(long, default_value_t = DRIVE)]
    drive: f64,
    /// Trainings at the same time; absent: one for each core.
    #[arg(long)]
    threads: Option<usize>,
    /// The order of the model's dynamics.
    #[arg(long)]
    order: Option<usize>,
    /// Inducing points of every function. Several numbers: the errors with the first beside those with each other one.
    #[arg(long, value_delimiter = ',')]
    ips: Vec<usize>,
    #[arg(long)]
    max_iterations: Option<usize>,
}

struct Run {
    seed: u32,
    start: Fit,
    found: Findings,
    /// Of the mean path at the start and at the end, for each part.
    late_spread: [Vec<f64>; 2],
    iterations: usize,
    seconds: f64,
}

fn experiment(seed: u32, drive: f64, settings: &VariationalSettings) -> Run {
    let data = Synthetic::draw(seed, drive).unwrap();
    let mut experiment = Experiment::new(data, settings, seed).unwrap();
    let begin = Instant::now();
    while !experiment.step().done {}
    let seconds = begin.elapsed().as_secs_f64();
    let found = experiment.findings().unwrap();
    Run {
        seed,
        start: experiment.start().fit,
        late_spread: [experiment.start(), &found.now].map(|model| model.late_spread(experiment.data())),
        found,
        iterations: experiment.progress().iteration,
        seconds,
    }
}

pub fn run(arguments: &Arguments) {
    let usual = [Synthetic::settings().dynamics_ips];
    let sizes = if arguments.ips.is_empty() { &usual } else { &arguments.ips[..] };
    let runs: Vec<Vec<Run>> = sizes.iter().map(|&points| table(arguments, points)).collect();
    let errors = |runs: &[Run]| runs.iter().map(|run| (run.seed as usize, run.found.now.fit.mse)).collect();
    for (points, other) in sizes.iter().zip(&runs).skip(1) {
        let Some(effect) = Effect::new(&errors(&runs[0]), &errors(other)) else { continue };
        let higher = |(a, b): &(&Run, &Run)| a.found.now.fit.bound > b.found.now.fit.bound;
        println!(
            "\nMSE with {} points divided by MSE with {points}, seed by seed: {}. The bound is higher in {}.",
            sizes[0],
            effect.text(),
            runs[0].iter().zip(other).filter(higher).count(),
        );
    }
}

/// Prints the table of one number of inducing points.
fn table(arguments: &Arguments, points: usize) -> Vec<Run> {
    let ours = Synthetic::settings();
    let settings = VariationalSettings {
        order: arguments.order.unwrap_or(ours.order),
        max_iterations: arguments.max_iterations.unwrap_or(ours.max_iterations),
        ..ours.with_points(points, points)
    };
    let threads = arguments.threads.unwrap_or(std::thread::available_parallelism().map_or(1, usize::from));
    let runs = each_seed(arguments.first..arguments.first + arguments.seeds, threads, |seed| {
        let run = experiment(seed, arguments.drive, &settings);
        eprintln!("seed {seed}: {:.0}", run.found.now.fit.bound);
        run
    });
    let VariationalSettings { order, dynamics_ips, pose_ips, max_iterations, .. } = settings;
    println!(
        "Share of part 1 in part 2: {}. Order {order}, {dynamics_ips} dynamics and {pose_ips} pose inducing points, at most {max_iterations} iterations.\n",
        arguments.drive
    );
    println!(
        "| seed | 1 to 1 | 2 to 1 | 1 to 2 | 2 to 2 | 2 to 1 : 1 to 1 | 1 to 2 : 2 to 2 | right | bound, start | end | MSE, start | end | latents explained | iterations | seconds |"
    );
    println!("{}|", "|---".repeat(15));
    for run in &runs {
        let Findings { alpha: a, verdict, now: Snapshot { learned, fit, .. }, .. } = &run.found;
        println!(
            "| {} | {:.4} | {:.4} | {:.4} | {:.4} | {:.1} | {:.2} | {} | {:.0} | {:.0} | {:.3} | {:.4} | {:.3}, {:.3} | {} | {:.1} |",
            run.seed,
            a[(0, 0)],
            a[(1, 0)],
            a[(0, 1)],
            a[(1, 1)],
            verdict.back,
            verdict.forth,
            if verdict.right(arguments.drive) { "yes" } else { "no" },
            run.start.bound,
            fit.bound,
            run.start.mse,
            fit.mse,
            learned[0].explained,
            learned[1].explained,
            run.iterations,
            run.seconds,
        );
    }
    let right = runs.iter().filter(|run| run.found.verdict.right(arguments.drive)).count();
    println!("\nRight: {right} of {}.\n", runs.len());
    let round = |when: usize| {
        let parts = runs.iter().flat_map(|run| &run.late_spread[when]);
        parts.filter(|share| (0.8..1.25).contains(*share)).count()
    };
    println!(
        "In the last 50 frames the mean path goes round as far as the true latents (0.8 to 1.25 times) in {} of {} parts \
         at the start, {} at the end.\n",
        round(0),
        2 * runs.len(),
        round(1)
    );
    runs
}
