//! A combination that was never recorded: legs from walking and arms from waving while standing, with
//! couplings fitted to the first seconds of a recording of both.
//!
//! All models predict the same last seconds of the recording from the frame where the seen seconds end.

use crate::modularity::Table;
use nalgebra::DMatrix;
use vcgpdm::models::library::{
    CouplingTrainer, LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary,
};
use vcgpdm::models::{Dataset, PoseWeight, Reading, Source, VariationalSettings};
use vcgpdm::motion::parts::{PartSpec, presets};
use vcgpdm::motion::{Clip, samples};
use vcgpdm::{Model, Settings, Trainer};
use vcgpdm_lab::evaluation::dtw_mse;
use vcgpdm_lab::evaluation::stats::{Interval, mean, mean_interval};

const FRAMES_PER_SECOND: f64 = 30.0;
/// Sets of made trials: two movements, and a recording of both together.
const SETS: u64 = 8;
/// Trials of each movement of a set, and their seconds.
const TRIALS: u64 = 3;
const TRIAL_SECONDS: f64 = 3.5;
/// Seconds of the recording that are seen. The errors are those of all its frames after the last of these.
const SEEN: [f64; 3] = [0.5, 1.0, 2.0];
const RECORDING_SECONDS: f64 = 5.0;
/// Iterations of the fit of the couplings, the default of the program and the page.
const ITERATIONS: usize = 100;
/// The models, each of which predicts the recording of a set.
const WAYS: [&str; 6] = [
    "combination, couplings fitted to the seconds",
    "combination, couplings taken over from both movements",
    "combination of parts without coupling",
    "vGPDM of the seconds alone",
    "vGPDM of the seconds alone, as large as both parts",
    "vGPDM of both movements and the seconds",
];

/// The made trials of a set.
struct Set {
    movements: [Vec<Clip>; 2],
    recording: Clip,
}

impl Set {
    fn new(number: u64) -> Self {
        let trial = |movement: &str, seed: u64, seconds: f64| {
            samples::trial(movement, 1000 * (number + 1) + seed, seconds).unwrap()
        };
        let trials = |movement: &str, first: u64| {
            (first..first + TRIALS).map(|seed| trial(movement, seed, TRIAL_SECONDS)).collect()
        };
        let recording = trial("walk and wave", 200, RECORDING_SECONDS).resample(FRAMES_PER_SECOND).unwrap();
        Self { movements: [trials("walk", 0), trials("stand and wave", 100)], recording }
    }

    /// The errors of all ways for each of [`SEEN`].
    fn errors(&self) -> Vec<[f64; SEEN.len()]> {
        let parts = presets(&self.recording.skeleton);
        let parts = |id: &str| parts.iter().find(|preset| preset.id == id).unwrap().parts.clone();
        let (two, whole) = (parts("lower-upper"), parts("whole"));
        let [coupled, apart] = [false, true].map(|uncoupled| self.library(&two, uncoupled));
        // As many latent dimensions and inducing points as both parts together.
        let large = settings().with_latent(6).with_points(24, 24);
        let mut errors = vec![[0.0; SEEN.len()]; WAYS.len()];
        for (place, seconds) in SEEN.into_iter().enumerate() {
            let seen = self.recording.cut(0, (seconds * FRAMES_PER_SECOND) as usize).unwrap();
            let all: Vec<&Clip> = self.movements.iter().flatten().chain([&seen]).collect();
            let own = [fitted(&coupled, &seen, Alpha::Fitted), fitted(&coupled, &seen, Alpha::Learned)];
            let models = own.into_iter().chain([
                fitted(&apart, &seen, Alpha::Learned),
                vgpdm(&[&seen], &whole, settings()),
                vgpdm(&[&seen], &whole, large.clone()),
                vgpdm(&all, &whole, settings()),
            ]);
            for (way, model) in models.enumerate() {
                errors[way][place] = self.error(&model);
            }
        }
        errors
    }

    /// A library of both movements, which share no primitive.
    fn library(&self, parts: &[PartSpec], uncoupled: bool) -> TrainedLibrary {
        let dataset = dataset(&self.movements.iter().flatten().collect::<Vec<_>>(), parts);
        let planned = ["walk", "wave"]
            .map(|name| PlannedMovement { name: name.to_owned(), sequences: TRIALS as usize });
        let plan = LibraryPlan::new(planned.into(), vec![false; parts.len()]).unwrap();
        let mut trainer =
            LibraryTrainer::new(&dataset, &plan, &settings().with_uncoupled(uncoupled), 1).unwrap();
        trainer.run();
        trainer.finish().unwrap()
    }

    /// The error of a model whose last sequence is the seen part of the recording: that of the frames that no
    /// model saw, in per cent of their variance.
    fn error(&self, model: &Model) -> f64 {
        let coupled = model.coupled().unwrap();
        let sequence = coupled.model.starts.len() - 1;
        let last = coupled.model.start_frames(sequence) - 1;
        let first = (SEEN[SEEN.len() - 1] * FRAMES_PER_SECOND) as usize;
        let actual = model.body.encode(&self.recording).unwrap();
        let dynamics = coupled.model.dynamics(&coupled.model.alpha, Reading::AsLearned).unwrap();
        let path =
            dynamics.path(&coupled.model.start(sequence, last).unwrap(), actual.nrows() - last).unwrap();
        let predicted = model.body.columns(&coupled.model.observations(&path));
        let rest = |y: &DMatrix<f64>, from: usize| y.rows(from, y.nrows() - from).into_owned();
        let score = dtw_mse(&rest(&predicted, first - last), &rest(&actual, first)).unwrap();
        100.0 * score.dtw_mse / score.variance
    }
}

fn settings() -> VariationalSettings {
    VariationalSettings { pose_weight: PoseWeight::Balanced, ..VariationalSettings::default() }
        .with_max_iterations(400)
}

fn dataset(clips: &[&Clip], parts: &[PartSpec]) -> Dataset {
    let sources: Vec<Source> = clips.iter().map(|clip| Source::from(*clip)).collect();
    Dataset::new(&sources, parts, FRAMES_PER_SECOND).unwrap()
}

/// The couplings of a combination.
#[derive(PartialEq)]
enum Alpha {
    /// Fitted to the seen frames.
    Fitted,
    /// As the movements learned them.
    Learned,
}

/// Walking legs with waving arms that start with the seen frames.
fn fitted(library: &TrainedLibrary, seen: &Clip, alpha: Alpha) -> Model {
    let uses = library.read_uses("lower=walk,upper=wave").unwrap();
    let clip = library.encode(seen).unwrap();
    let mut trainer = CouplingTrainer::new(library, &uses, &[clip], ITERATIONS).unwrap();
    trainer.run();
    let mut found = trainer.finish("both").unwrap();
    let last = found.library.movements.len() - 1;
    if alpha == Alpha::Learned {
        found.library.movements[last].alpha = library.library.nearest_couplings(&uses);
    }
    found.movement(last).unwrap()
}

fn vgpdm(clips: &[&Clip], whole: &[PartSpec], settings: VariationalSettings) -> Model {
    let mut trainer = Trainer::new(&dataset(clips, whole), &Settings::Vgpdm(settings), 1).unwrap();
    trainer.run();
    trainer.finish().unwrap()
}

/// The ratio of the errors of a way and of the first way, its interval over the sets, and in how many sets it is
/// below 1.
fn ratio(own: &[f64], first: &[f64]) -> String {
    let logarithms: Vec<f64> = own.iter().zip(first).map(|(a, b)| (a / b).ln()).collect();
    let interval =
        mean_interval(&logarithms).map_or(String::new(), |i: Interval| format!(" ({})", i.map(f64::exp)));
    let lower = logarithms.iter().filter(|ratio| **ratio < 0.0).count();
    format!("{:.2}{interval}, {lower} of {}", mean(&logarithms).exp(), own.len())
}

/// The errors of all ways.
pub fn table() -> Table {
    let sets: Vec<Vec<[f64; SEEN.len()]>> = (0..SETS)
        .map(|number| {
            let errors = Set::new(number).errors();
            eprintln!("combination, set {}: {errors:.1?}", number + 1);
            errors
        })
        .collect();
    let of = |way: usize, place: usize| sets.iter().map(|errors| errors[way][place]).collect::<Vec<_>>();
    let row = |(way, name): (usize, &&str)| {
        let cells = (0..SEEN.len()).flat_map(|place| {
            let (own, first) = (of(way, place), of(0, place));
            let middle = mean(&own.iter().map(|error| error.ln()).collect::<Vec<_>>()).exp();
            let compared = if way == 0 { String::new() } else { ratio(&own, &first) };
            [format!("{middle:.0} %"), compared]
        });
        std::iter::once((*name).to_owned()).chain(cells).collect()
    };
    let heads = SEEN.iter().flat_map(|seconds| {
        [format!("{seconds} s seen: DTW MSE in % of the variance"), "divided by the first row".to_owned()]
    });
    Table {
        head: std::iter::once("model".to_owned()).chain(heads).collect(),
        rows: WAYS.iter().enumerate().map(row).collect(),
    }
}
