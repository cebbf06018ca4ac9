//! The modularity test of Velychko et al. (2018, section 5.5, figure 7) on the sample trials of walking and
//! of walking with waving: a library with one walking primitive of the lower body for both movements,
//! compared with a model of each movement alone. The tables are in docs/modularity.md.

mod combination;
mod figure;
mod imports;

use std::path::Path;
use std::time::Instant;
use vcgpdm::models::library::TrainedLibrary;
use vcgpdm_lab::evaluation::stats::{mean, mean_interval, standard_error};
use vcgpdm_lab::evaluation::{ModularityTest, Trained};

/// The result for one trial held out, of a model of its movement alone or of the library of both.
struct Outcome {
    error: f64,
    /// Of one training.
    seconds: f64,
    numbers: usize,
}

fn outcome(test: &ModularityTest, place: (usize, usize), trained: Trained) -> (Outcome, TrainedLibrary) {
    let begin = Instant::now();
    let mut training = test.training(place, trained).unwrap();
    while !training.step().unwrap().done {}
    let seconds = begin.elapsed().as_secs_f64() / training.seeds() as f64;
    let (outcome, library) = training.best().unwrap().clone();
    (Outcome { error: outcome.score.dtw_mse, seconds, numbers: outcome.stored_numbers }, library)
}

/// A model of the movement alone, and a library.
fn held_out_trial(test: &ModularityTest, place: (usize, usize)) -> (Outcome, Outcome, TrainedLibrary) {
    let (own, _) = outcome(test, place, Trained::Alone);
    let (shared, library) = outcome(test, place, Trained::Together);
    (own, shared, library)
}

/// A mean with its standard error, in thousandths.
fn thousandths(values: &[f64]) -> String {
    let error = standard_error(values).unwrap_or(f64::NAN);
    format!("{:.3} ± {:.3}", 1e3 * mean(values), 1e3 * error)
}

/// A table of measurements.
struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn markdown(&self) -> String {
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let rule = format!("|{}\n", "---|".repeat(self.head.len()));
        let rows: String = self.rows.iter().map(|row| line(row)).collect();
        line(&self.head) + &rule + &rows
    }
}

/// The library compared with a model of each movement alone, and the library of the first trial.
fn modular(test: &ModularityTest) -> (Table, TrainedLibrary) {
    let head = [
        "movement",
        "trials",
        "alone: DTW MSE x 1000",
        "library: DTW MSE x 1000",
        "library minus alone, paired, with 95 % interval",
        "library lower in",
        "alone: seconds",
        "library: seconds (both movements)",
        "alone: numbers stored",
        "library: numbers stored (both)",
    ];
    let mut table = Table { head: head.map(str::to_owned).to_vec(), rows: Vec::new() };
    let mut drawn = None;
    for (m, movement) in test.movements.iter().enumerate() {
        let (mut own, mut shared) = (Vec::new(), Vec::new());
        // Two trials at a time: each training has a core of its own, and its seconds are its own.
        let trials: Vec<usize> = (0..movement.trials.len()).collect();
        for pair in trials.chunks(2) {
            let outcomes: Vec<_> = std::thread::scope(|scope| {
                let spawn = |held_out: usize| scope.spawn(move || held_out_trial(test, (m, held_out)));
                let threads: Vec<_> = pair.iter().map(|held_out| spawn(*held_out)).collect();
                threads.into_iter().map(|thread| thread.join().unwrap()).collect()
            });
            for (alone, together, library) in outcomes {
                eprintln!("{}: alone {:.5}, library {:.5}", movement.name, alone.error, together.error);
                own.push(alone);
                shared.push(together);
                drawn.get_or_insert(library);
            }
        }
        let errors = |outcomes: &[Outcome]| outcomes.iter().map(|outcome| outcome.error).collect::<Vec<_>>();
        let (a, b) = (errors(&own), errors(&shared));
        let differences: Vec<f64> = a.iter().zip(&b).map(|(a, b)| b - a).collect();
        let interval = mean_interval(&differences).map_or(String::new(), |interval| {
            format!(" ({:+.3} to {:+.3})", 1e3 * interval.low, 1e3 * interval.high)
        });
        let seconds =
            |outcomes: &[Outcome]| mean(&outcomes.iter().map(|outcome| outcome.seconds).collect::<Vec<_>>());
        table.rows.push(vec![
            movement.name.clone(),
            movement.trials.len().to_string(),
            thousandths(&a),
            thousandths(&b),
            format!("{:+.3}{interval}", 1e3 * mean(&differences)),
            differences.iter().filter(|d| **d < 0.0).count().to_string(),
            format!("{:.1}", seconds(&own)),
            format!("{:.1}", seconds(&shared)),
            own[0].numbers.to_string(),
            shared[0].numbers.to_string(),
        ]);
    }
    (table, drawn.unwrap())
}

pub fn run_imports() {
    print!("{}", imports::table(&ModularityTest::on_samples()).markdown());
}

pub fn run_combination() {
    print!("{}", combination::table().markdown());
}

pub fn run(picture: Option<&Path>) {
    let (table, library) = modular(&ModularityTest::on_samples());
    print!("{}", table.markdown());
    if let Some(path) = picture {
        std::fs::write(path, figure::svg(&library)).unwrap();
        eprintln!("wrote {}", path.display());
    }
}
