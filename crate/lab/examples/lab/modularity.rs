//! The modularity test of Velychko et al. (2018, section 5.5, figure 7) on the sample trials of walking and
//! of walking with waving: a library with one walking primitive of the lower body for both movements,
//! compared with a model of each movement alone. The tables are in docs/modularity.md.

use std::fmt::Write;
use std::path::Path;
use std::time::Instant;
use vcgpdm_core::models::Reading;
use vcgpdm_core::models::library::TrainedLibrary;
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

pub fn run(picture: Option<&Path>) {
    let (table, library) = modular(&ModularityTest::on_samples());
    print!("{}", table.markdown());
    if let Some(path) = picture {
        std::fs::write(path, svg(&library)).unwrap();
        eprintln!("wrote {}", path.display());
    }
}

const WIDTH: f64 = 420.0;
const MARGIN: f64 = 34.0;
/// Readable on white and on black. Training paths are dashed, generated ones solid.
const COLOURS: [&str; 2] = ["#c2543d", "#3b76b0"];

/// The movement of a path, whether it is a training path, and its points.
type LatentPath = (usize, bool, Vec<(f64, f64)>);

/// Figure 7 of Velychko et al. (2018): the latent paths of each part, generated solid and training dashed, both
/// movements in one latent space.
fn svg(trained: &TrainedLibrary) -> String {
    let library = &trained.library;
    let parts = trained.body.layout.parts();
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        WIDTH * parts.len() as f64,
        WIDTH + 24.0
    );
    for (part, spec) in parts.iter().enumerate() {
        let mut paths: Vec<LatentPath> = Vec::new();
        for (m, movement) in library.movements.iter().enumerate() {
            let model = library.movement(m).unwrap();
            let dynamics = model.dynamics(&model.alpha, Reading::AsLearned).unwrap();
            let frames = movement.starts[0][part].nrows();
            let generated = dynamics.path(&model.start(0, 0).unwrap(), frames).unwrap();
            let points = |x: &nalgebra::DMatrix<f64>| x.row_iter().map(|row| (row[0], row[1])).collect();
            paths.push((m, true, points(&movement.starts[0][part])));
            paths.push((m, false, points(&generated[part])));
        }
        let largest = paths
            .iter()
            .flat_map(|(_, _, points)| points)
            .fold(0.0_f64, |largest, (x, y)| largest.max(x.abs()).max(y.abs()));
        let scale = (WIDTH / 2.0 - MARGIN) / largest.max(1e-9);
        let (left, middle) = (WIDTH * part as f64, WIDTH / 2.0);
        for (m, training, points) in paths {
            let place =
                |(x, y): (f64, f64)| format!("{:.1},{:.1}", left + middle + scale * x, middle - scale * y);
            let points: Vec<String> = points.into_iter().map(place).collect();
            let dash = if training { " stroke-dasharray=\"4 4\" stroke-opacity=\"0.7\"" } else { "" };
            let _ = writeln!(
                out,
                "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{dash} points=\"{}\"/>",
                COLOURS[m % 2],
                points.join(" ")
            );
        }
        let _ = writeln!(
            out,
            "<text x=\"{}\" y=\"20\" text-anchor=\"middle\">{} body, latents 1 and 2</text>",
            left + middle,
            spec.name
        );
    }
    for (m, movement) in library.movements.iter().enumerate() {
        let x = 24.0 + 200.0 * m as f64;
        let _ = writeln!(
            out,
            "<text x=\"{x}\" y=\"{}\" fill=\"{}\">{} (dashed: training)</text>",
            WIDTH + 10.0,
            COLOURS[m % 2],
            movement.name
        );
    }
    out.push_str("</svg>\n");
    out
}
