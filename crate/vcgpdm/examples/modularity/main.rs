//! The modularity test of Velychko et al. (2018, section 5.5, figure 7) on the sample trials of walking and of walking with waving: a
//! library with one walking primitive of the lower body for both movements beside a model of each movement alone. Prints what
//! docs/modularity.md holds: `npm run modularity`.
//!
//! Q = 3, 25 pose inducing points a part, 16 dynamics inducing points an expert, leave one trial out; of two seeds that of the
//! highest bound, as somebody would choose who does not know the trial held out.
#![allow(clippy::unwrap_used)]

mod figure;

use std::path::PathBuf;
use std::time::Instant;
use vcgpdm::evaluation::stats::{mean, mean_interval, standard_error};
use vcgpdm::evaluation::{Fold, LibraryFold, MovementTrials, START_FRAMES};
use vcgpdm::models::library::TrainedLibrary;
use vcgpdm::models::{ModelSettings, VariationalSettings};
use vcgpdm::motion::parts::{PartSpec, presets};
use vcgpdm::motion::samples;

const FRAMES_PER_SECOND: f64 = 30.0;
const SEEDS: [u32; 2] = [1, 2];
/// The sample trials have very little noise, and need more iterations than recordings.
const ITERATIONS: usize = 600;

/// What came of one trial held out, with a model of its movement alone or with the library of both.
struct Came {
    error: f64,
    bound: f64,
    /// Of one training.
    seconds: f64,
    numbers: usize,
}

fn settings() -> VariationalSettings {
    VariationalSettings {
        latent: 3,
        dynamics_ips: 16,
        pose_ips: 25,
        max_iterations: ITERATIONS,
        ..Default::default()
    }
}

fn trials(name: &str, movement: &str) -> MovementTrials {
    let of = samples::list().into_iter().filter(|sample| sample.movement == movement);
    MovementTrials {
        name: name.to_owned(),
        trials: of.filter_map(|sample| samples::clip(sample.id)).collect(),
    }
}

fn alone(of: &MovementTrials, held_out: usize, parts: &[PartSpec], seed: u32) -> Came {
    let others = of.trials.len() - 1;
    let fold = Fold::new(&of.trials, held_out, others, parts, FRAMES_PER_SECOND, START_FRAMES).unwrap();
    let begin = Instant::now();
    let clock = || begin.elapsed().as_secs_f64();
    let outcome = fold.evaluate(&ModelSettings::Vcgpdm(settings()), seed, &clock, &mut |_| true);
    let outcome = outcome.unwrap().unwrap();
    let bound = outcome.objective;
    Came { error: outcome.score.dtw_mse, bound, seconds: outcome.seconds, numbers: outcome.stored_numbers }
}

fn together(
    movements: &[MovementTrials],
    place: (usize, usize),
    parts: &[PartSpec],
    seed: u32,
) -> (Came, TrainedLibrary) {
    let shared = ["lower".to_owned()];
    let fold = LibraryFold::new(movements, place, parts, &shared, FRAMES_PER_SECOND, START_FRAMES).unwrap();
    let begin = Instant::now();
    let mut trainer = fold.trainer(&settings(), seed).unwrap();
    while !trainer.step().done {}
    let library = fold.library(&trainer).unwrap();
    let seconds = begin.elapsed().as_secs_f64();
    let outcome = fold.outcome(&library).unwrap();
    let bound = outcome.bound;
    (Came { error: outcome.score.dtw_mse, bound, seconds, numbers: outcome.stored_numbers }, library)
}

/// Of two seeds the training of the highest bound: alone, and as a library.
fn held_out_trial(
    movements: &[MovementTrials],
    (m, held_out): (usize, usize),
    parts: &[PartSpec],
) -> (Came, Came, TrainedLibrary) {
    let own = SEEDS.map(|seed| alone(&movements[m], held_out, parts, seed));
    let own = own.into_iter().max_by(|a, b| a.bound.total_cmp(&b.bound)).unwrap();
    let shared = SEEDS.map(|seed| together(movements, (m, held_out), parts, seed));
    let (shared, library) = shared.into_iter().max_by(|a, b| a.0.bound.total_cmp(&b.0.bound)).unwrap();
    (own, shared, library)
}

/// A mean with its standard error, in thousandths.
fn thousandths(values: &[f64]) -> String {
    let error = standard_error(values).unwrap_or(f64::NAN);
    format!("{:.3} ± {:.3}", 1e3 * mean(values), 1e3 * error)
}

fn main() {
    let picture = std::env::args().skip(1).last().map(PathBuf::from);
    let movements = [trials("walk", "walk"), trials("wave", "walk and wave")];
    let skeleton = &movements[0].trials[0].skeleton;
    let parts = presets(skeleton).into_iter().find(|preset| preset.id == "lower-upper").unwrap().parts;
    println!(
        "| movement | trials | alone: DTW MSE x 1000 | library: DTW MSE x 1000 | library minus alone, paired, with 95 % interval | \
         library lower in | alone: seconds | library: seconds (both movements) | alone: numbers stored | library: numbers stored (both) |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    let mut drawn = None;
    for (m, of) in movements.iter().enumerate() {
        let (mut own, mut shared) = (Vec::new(), Vec::new());
        // Two trials at a time: each training has a core of its own, and its seconds are its own.
        let trials: Vec<usize> = (1..=of.trials.len()).collect();
        for pair in trials.chunks(2) {
            let came: Vec<_> = std::thread::scope(|scope| {
                let one = |held_out: usize| {
                    let (movements, parts) = (&movements, &parts);
                    scope.spawn(move || held_out_trial(movements, (m, held_out), parts))
                };
                let threads: Vec<_> = pair.iter().map(|held_out| one(*held_out)).collect();
                threads.into_iter().map(|thread| thread.join().unwrap()).collect()
            });
            for (alone, together, library) in came {
                eprintln!("{}: alone {:.5}, library {:.5}", of.name, alone.error, together.error);
                own.push(alone);
                shared.push(together);
                drawn.get_or_insert(library);
            }
        }
        let errors = |came: &[Came]| came.iter().map(|came| came.error).collect::<Vec<_>>();
        let (a, b) = (errors(&own), errors(&shared));
        let differences: Vec<f64> = a.iter().zip(&b).map(|(a, b)| b - a).collect();
        let interval = mean_interval(&differences).map_or(String::new(), |interval| {
            format!(" ({:+.3} to {:+.3})", 1e3 * interval.low, 1e3 * interval.high)
        });
        let seconds = |came: &[Came]| mean(&came.iter().map(|came| came.seconds).collect::<Vec<_>>());
        println!(
            "| {} | {} | {} | {} | {:+.3}{} | {} | {:.1} | {:.1} | {} | {} |",
            of.name,
            of.trials.len(),
            thousandths(&a),
            thousandths(&b),
            1e3 * mean(&differences),
            interval,
            differences.iter().filter(|d| **d < 0.0).count(),
            seconds(&own),
            seconds(&shared),
            own[0].numbers,
            shared[0].numbers,
        );
    }
    if let (Some(path), Some(library)) = (picture, drawn) {
        std::fs::write(&path, figure::svg(&library)).unwrap();
        eprintln!("wrote {}", path.display());
    }
}
