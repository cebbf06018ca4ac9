//! The loss when primitives of one training are learned again under the pose maps of another.
//!
//! A library of walking is the donor, one of walking with waving the host; neither was trained on the clips
//! of the other. One walk is held out. It is predicted from its first frames by the donor, by the host with
//! the donor's primitives learned again, and by a library that was trained on both.

use crate::modularity::{Table, thousandths};
use nalgebra::DMatrix;
use vcgpdm::models::library::{
    ImportFrames, ImportRequest, ImportTrainer, LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary,
};
use vcgpdm::models::{Dataset, Source};
use vcgpdm::motion::Clip;
use vcgpdm_lab::evaluation::stats::{mean, mean_interval};
use vcgpdm_lab::evaluation::{ModularityTest, START_FRAMES, Trained, dtw_mse};

/// Iterations of an import, the default of the program and the page.
const ITERATIONS: usize = 200;

/// The errors of a prediction of the trial held out.
struct Prediction {
    /// The errors of all columns, and of those of the lower body.
    errors: [f64; 2],
    /// The share of the frames that the host's pose maps do not reproduce, for each part.
    lost: Option<Vec<f64>>,
}

const WAYS: [&str; 6] = [
    "donor, as trained",
    "both trained together",
    "whole movement, again from clips",
    "whole movement, again from what it remembers",
    "whole movement, again from what it generates",
    "legs alone, again from clips, with the host's arms",
];

/// A library of one movement alone, of the seed with the highest bound.
fn library(test: &ModularityTest, movement: usize) -> TrainedLibrary {
    let (movement, rate) = (&test.movements[movement], test.frames_per_second);
    let sources: Vec<Source> =
        movement.trials.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let dataset = Dataset::new(&sources, &test.parts, rate).unwrap();
    let planned = PlannedMovement { name: movement.name.clone(), sequences: movement.trials.len() };
    let plan = LibraryPlan::new(vec![planned], vec![false; test.parts.len()]).unwrap();
    let libraries = test.seeds.iter().map(|seed| {
        let mut trainer = LibraryTrainer::new(&dataset, &plan, &test.settings, *seed).unwrap();
        while !trainer.step().done {}
        trainer.finish().unwrap()
    });
    libraries.max_by(|a, b| a.provenance.objective.total_cmp(&b.provenance.objective)).unwrap()
}

/// A library with one trial held out, of the seed with the highest bound.
fn fold(test: &ModularityTest, place: (usize, usize), trained: Trained) -> TrainedLibrary {
    let mut training = test.training(place, trained).unwrap();
    while !training.step().unwrap().done {}
    training.best().unwrap().1.clone()
}

/// The errors of a rollout from the last sequence of a movement, compared with the whole clip: of all
/// columns, and of those of the lower body.
fn errors(library: &TrainedLibrary, movement: usize, actual: &Clip) -> [f64; 2] {
    let actual = library.encode(actual).unwrap();
    let actual = library.body.columns(&actual.y);
    let model = library.library.movement(movement).unwrap();
    let predicted = library.body.columns(&model.rollout(model.starts.len() - 1, actual.nrows()).unwrap());
    let legs = library.body.layout.columns(0);
    let error = |a: &DMatrix<f64>, b: &DMatrix<f64>| dtw_mse(a, b).unwrap().dtw_mse;
    [error(&predicted, &actual), error(&predicted.select_columns(legs), &actual.select_columns(legs))]
}

fn imported(
    host: &TrainedLibrary,
    donor: &TrainedLibrary,
    frames: ImportFrames,
    actual: &Clip,
) -> Prediction {
    let request = ImportRequest { companions: host.companions(donor), max_iterations: ITERATIONS, seed: 1 };
    let mut trainer = ImportTrainer::new(host, donor, frames, &request).unwrap();
    while !trainer.step().done {}
    let library = trainer.finish().unwrap();
    let errors = errors(&library, library.library.movements.len() - 1, actual);
    Prediction { errors, lost: Some(trainer.lost()) }
}

/// All ways for one trial held out.
fn held_out_trial(test: &ModularityTest, host: &TrainedLibrary, held_out: usize) -> Vec<Prediction> {
    let trials = &test.movements[0].trials;
    let actual = &trials[held_out];
    let donor = fold(test, (0, held_out), Trained::Alone);
    let both = fold(test, (0, held_out), Trained::Together);
    let rate = 1.0 / host.body.frame_time;
    let start = actual.resample(rate).unwrap().cut(0, START_FRAMES).unwrap();
    let others = trials.iter().enumerate().filter(|(k, _)| *k != held_out);
    let clips: Vec<_> =
        others.map(|(_, clip)| clip).chain([&start]).map(|clip| host.encode(clip).unwrap()).collect();
    let legs = donor.select(&[0]).unwrap();
    vec![
        Prediction { errors: errors(&donor, 0, actual), lost: None },
        Prediction { errors: errors(&both, 0, actual), lost: None },
        imported(host, &donor, ImportFrames::Clips(&clips), actual),
        imported(host, &donor, ImportFrames::Remembered, actual),
        imported(host, &donor, ImportFrames::Generated, actual),
        imported(host, &legs, ImportFrames::Clips(&clips), actual),
    ]
}

/// The table of all ways of import. The movements share no primitive.
pub fn table(test: &ModularityTest) -> Table {
    let test = &ModularityTest { shared: Vec::new(), ..test.clone() };
    let host = library(test, 1);
    let mut predictions: Vec<Vec<Prediction>> = WAYS.iter().map(|_| Vec::new()).collect();
    let trials: Vec<usize> = (0..test.movements[0].trials.len()).collect();
    for pair in trials.chunks(2) {
        let found: Vec<_> = std::thread::scope(|scope| {
            let host = &host;
            let spawn = |held_out: usize| scope.spawn(move || held_out_trial(test, host, held_out));
            let threads: Vec<_> = pair.iter().map(|held_out| spawn(*held_out)).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).collect()
        });
        for ways in found {
            let words: Vec<String> =
                ways.iter().map(|way| format!("{:.5} {:.5}", way.errors[0], way.errors[1])).collect();
            eprintln!("imports: {}", words.join(" "));
            for (into, way) in predictions.iter_mut().zip(ways) {
                into.push(way);
            }
        }
    }
    let rows = WAYS.iter().zip(&predictions).map(|(way, found)| {
        let mut cells = vec![(*way).to_owned()];
        for which in 0..2 {
            let errors = |all: &[Prediction]| {
                all.iter().map(|prediction| prediction.errors[which]).collect::<Vec<_>>()
            };
            let (own, found) = (errors(&predictions[0]), errors(found));
            let differences: Vec<f64> = own.iter().zip(&found).map(|(a, b)| b - a).collect();
            let interval = mean_interval(&differences).filter(|_| *way != WAYS[0]);
            cells.push(thousandths(&found));
            cells.push(interval.map_or(String::new(), |interval| {
                let (low, high) = (1e3 * interval.low, 1e3 * interval.high);
                format!("{:+.3} ({low:+.3} to {high:+.3})", 1e3 * mean(&differences))
            }));
        }
        let lost = |part: usize| {
            let lost: Vec<f64> =
                found.iter().filter_map(|prediction| Some(prediction.lost.as_ref()?[part])).collect();
            if lost.is_empty() { String::new() } else { format!("{:.1} %", 100.0 * mean(&lost)) }
        };
        cells.push([lost(0), lost(1)].join(if found[0].lost.is_some() { ", " } else { "" }));
        cells
    });
    let head = [
        "walks predicted by",
        "DTW MSE x 1000",
        "minus the donor, paired, with 95 % interval",
        "of the lower body alone",
        "minus the donor",
        "not shown by the host's pose maps: lower, upper",
    ];
    Table { head: head.map(str::to_owned).to_vec(), rows: rows.collect() }
}
