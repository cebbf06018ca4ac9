//! One half of the body inferred from the other, and rollouts from frames of trials that were not trained on
//! (docs/completing.md). Each folder has the clips (.bvh) of one person; each trial is held out in turn.

mod rivals;

use crate::clips;
use nalgebra::DMatrix;
use rivals::{Answer, HISTORY, Pairs, answer};
use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm::models::variational::{Filter, LatentMoments};
use vcgpdm::models::{
    Body, Coupled, Dataset, Model, PoseWeight, RolloutRequest, Settings, Source, Trainer, VariationalSettings,
};
use vcgpdm::motion::Clip;
use vcgpdm::motion::parts::{PartSpec, presets};
use vcgpdm::motion::pose::ColumnKind;
use vcgpdm_lab::evaluation::stats::median;
use vcgpdm_lab::evaluation::{Fold, START_FRAMES, dtw_mse};

const FRAMES_PER_SECOND: f64 = 30.0;
/// Frames in which the filter searches its place: half a second.
const SEARCHED: usize = 15;
/// Frames from one gap to the next, and missing frames in each.
const GAPS: (usize, usize) = (20, 8);
/// Frames after the sense is cut.
const AFTER_CUT: [Range<usize>; 3] = [0..8, 0..15, 15..30];

fn settings() -> VariationalSettings {
    VariationalSettings {
        dynamics_ips: 20,
        pose_ips: 30,
        pose_weight: PoseWeight::Balanced,
        ..VariationalSettings::default()
    }
}

fn train(trials: &[&Clip], parts: &[PartSpec], settings: &Settings) -> Model {
    let sources: Vec<Source> = trials.iter().map(|clip| Source::from(*clip)).collect();
    let mut trainer =
        Trainer::new(&Dataset::new(&sources, parts, FRAMES_PER_SECOND).unwrap(), settings, 0).unwrap();
    trainer.run();
    trainer.finish().unwrap()
}

/// One direction in one fold: the columns of the given and of the other part.
struct Task {
    given: DMatrix<f64>,
    other: DMatrix<f64>,
    /// Columns of the other part that changed in training.
    changing: Vec<usize>,
}

/// Which rows of the given part are observed.
enum Sense {
    All,
    Gaps,
    CutAt(usize),
}

impl Sense {
    fn observed(&self, given: &DMatrix<f64>) -> DMatrix<f64> {
        let mut given = given.clone();
        for t in HISTORY..given.nrows() {
            let missing = match self {
                Sense::All => false,
                Sense::Gaps => t % GAPS.0 >= GAPS.0 - GAPS.1,
                Sense::CutAt(frame) => t >= *frame,
            };
            if missing {
                given.row_mut(t).fill(f64::NAN);
            }
        }
        given
    }
}

/// Means, variances and densities of these columns of a part under latents.
fn of_latents(
    filter: &Filter,
    part: usize,
    columns: &[usize],
    latents: &LatentMoments,
    task: &Task,
) -> Answer {
    let shape = task.other.shape();
    let (mut mean, mut variance) = (DMatrix::zeros(shape.0, shape.1), DMatrix::zeros(shape.0, shape.1));
    let mut log_densities = Vec::new();
    let changing: Vec<usize> = task.changing.iter().map(|&c| columns[c]).collect();
    for (t, moments) in filter.frames(part, latents).enumerate() {
        let moments = moments.unwrap();
        let mut row = vec![0.0; moments.mean.len()];
        for (c, &column) in columns.iter().enumerate() {
            mean[(t, c)] = moments.mean[column];
            variance[(t, c)] = moments.covariance[(column, column)];
            row[column] = task.other[(t, c)];
        }
        log_densities.push(moments.log_density(&row, &changing).unwrap());
    }
    Answer { mean, variance, log_densities }
}

/// One number of each column of the table.
#[derive(Clone, Default)]
struct Row {
    numbers: Vec<f64>,
}

/// All methods of the table.
const METHODS: [&str; 6] = [
    "vCGPDM, filter",
    "vCGPDM, smoother",
    "vGPDM, filter",
    "ridge regression",
    "Gaussian process regression",
    "nearest neighbour",
];

/// A fold with its models.
struct Trial<'a> {
    coupled: Coupled<'a>,
    whole: Coupled<'a>,
    body: &'a Body,
    /// Centred columns of each part, of the training trials and of the one held out.
    training: Vec<Vec<DMatrix<f64>>>,
    held_out: Vec<DMatrix<f64>>,
}

impl Trial<'_> {
    fn answers(&self, given: usize, sense: &Sense) -> (Task, Vec<Answer>) {
        let other = 1 - given;
        let changes = |&c: &usize| self.training.iter().any(|y| y[other].column(c).amax() > 1e-9);
        let changing = (0..self.held_out[other].ncols()).filter(changes).collect();
        let task =
            Task { given: self.held_out[given].clone(), other: self.held_out[other].clone(), changing };
        let observed = sense.observed(&task.given);
        let mut answers = Vec::new();

        let mut y = self.held_out.clone();
        y[given].copy_from(&observed);
        y[other].fill(f64::NAN);
        let filter = self.coupled.filter(&RolloutRequest::default()).unwrap();
        let run = filter.run_from_best(&y, SEARCHED).unwrap();
        let columns: Vec<usize> = (0..task.other.ncols()).collect();
        for latents in [filter.filtered(&run), filter.smoothed(&run).unwrap()] {
            answers.push(of_latents(&filter, other, &columns, &latents, &task));
        }

        let filter = self.whole.filter(&RolloutRequest::default()).unwrap();
        let mut y = DMatrix::from_element(observed.nrows(), self.body.column_means.len(), f64::NAN);
        for (c, &column) in self.body.layout.columns(given).iter().enumerate() {
            y.set_column(column, &observed.column(c));
        }
        let run = filter.run_from_best(&[y], SEARCHED).unwrap();
        let columns = self.body.layout.columns(other);
        answers.push(of_latents(&filter, 0, columns, &filter.filtered(&run), &task));

        let trials = self.training.iter().map(|y| (y[given].clone(), y[other].clone()));
        let pairs = Pairs::new(&trials.collect::<Vec<_>>());
        for prediction in
            [pairs.ridge(&observed), pairs.gaussian_process(&observed), pairs.nearest(&observed)]
        {
            answers.push(answer(prediction, &task.other, &task.changing));
        }
        (task, answers)
    }

    /// The rows of all methods.
    fn rows(&self, given: usize) -> Vec<Row> {
        let mut rows = vec![Row::default(); METHODS.len()];
        let (task, answers) = self.answers(given, &Sense::All);
        let frames = HISTORY - 1..task.other.nrows();
        for (row, answer) in rows.iter_mut().zip(&answers) {
            row.numbers.push(share(&answer.mean, &task.other, frames.clone()));
            row.numbers.push(self.joints(1 - given, &answer.mean, frames.clone()));
            let (mut inside, mut count) = (0.0, 0.0);
            for (t, &c) in frames.clone().flat_map(|t| task.changing.iter().map(move |c| (t, c))) {
                let error = (answer.mean[(t, c)] - task.other[(t, c)]).abs();
                inside += f64::from(u8::from(error < 1.96 * answer.variance[(t, c)].sqrt()));
                count += 1.0;
            }
            row.numbers.push(100.0 * inside / count);
            let densities = &answer.log_densities[frames.clone()];
            row.numbers.push(densities.iter().sum::<f64>() / densities.len() as f64);
        }
        let (task, answers) = self.answers(given, &Sense::Gaps);
        for (row, answer) in rows.iter_mut().zip(&answers) {
            row.numbers.push(share(&answer.mean, &task.other, frames.clone()));
        }
        let cut = task.other.nrows() / 2;
        let (task, answers) = self.answers(given, &Sense::CutAt(cut));
        for (row, answer) in rows.iter_mut().zip(&answers) {
            for after in AFTER_CUT {
                let frames = cut + after.start..(cut + after.end).min(task.other.nrows());
                row.numbers.push(share(&answer.mean, &task.other, frames));
            }
        }
        rows
    }

    /// The error of joint positions relative to the hips, as a share of that of the mean pose. Root and given
    /// part are as recorded.
    fn joints(&self, part: usize, mean: &DMatrix<f64>, frames: Range<usize>) -> f64 {
        let positions = |y: DMatrix<f64>| {
            let mut parts = self.held_out.clone();
            parts[part] = y;
            let mut all = self.body.columns(&parts);
            let recorded = self.body.columns(&self.held_out);
            for (c, column) in self.body.mapping.columns().iter().enumerate() {
                match column.kind {
                    ColumnKind::YawRate | ColumnKind::Forward | ColumnKind::Sideways => {
                        all.column_mut(c).fill(0.0)
                    }
                    ColumnKind::Height | ColumnKind::Pitch | ColumnKind::Roll => {
                        all.set_column(c, &recorded.column(c));
                    }
                    ColumnKind::Rotation(_) => {}
                }
            }
            self.body.positions(&all).unwrap()
        };
        let recorded = positions(self.held_out[part].clone());
        let width = recorded.len() / mean.nrows();
        let error = |found: &[f32]| -> f64 {
            let frames = frames.start * width..frames.end * width;
            found[frames.clone()].iter().zip(&recorded[frames]).map(|(a, b)| f64::from(a - b).powi(2)).sum()
        };
        error(&positions(mean.clone())) / error(&positions(mean * 0.0))
    }
}

/// The squared error in these frames, as a share of that of the mean pose.
fn share(mean: &DMatrix<f64>, recorded: &DMatrix<f64>, frames: Range<usize>) -> f64 {
    let rows = |y: &DMatrix<f64>| y.rows(frames.start, frames.len()).into_owned();
    (rows(mean) - rows(recorded)).norm_squared() / rows(recorded).norm_squared()
}

/// Errors of a rollout of a trial held out that starts from its first frames: trained on as a sequence, and
/// observed; and the seconds of both.
fn conditioned(trials: &[Clip], held_out: usize, parts: &[PartSpec], coupled: Coupled) -> [f64; 4] {
    let fold = Fold::new(trials, held_out, trials.len() - 1, parts, FRAMES_PER_SECOND, START_FRAMES).unwrap();
    let begin = Instant::now();
    let mut learner = fold.learner(&Settings::Vcgpdm(settings()), 0).unwrap();
    while !learner.step().done {}
    let trained = fold.predict(&learner.model().unwrap()).unwrap();
    let training = begin.elapsed().as_secs_f64();

    let actual = fold.actual();
    let begin = Instant::now();
    let start = coupled.latents_of(&actual.rows(0, START_FRAMES).into_owned()).unwrap();
    let frames = actual.nrows();
    let request = RolloutRequest { frames, start: Some(start), ..RolloutRequest::default() };
    let observed = coupled.rollout(&request).unwrap().y;
    let seconds = begin.elapsed().as_secs_f64();
    let error = |y: &DMatrix<f64>| dtw_mse(y, actual).unwrap().dtw_mse;
    [error(&trained), error(&observed), training, seconds]
}

/// The errors of a training clip completed from each half, as multiples of the model's own reconstruction.
fn completed(trial: &Trial, clip: &DMatrix<f64>, sequence: usize) -> [f64; 2] {
    let recorded = trial.body.centred(clip);
    let filter = trial.coupled.filter(&RolloutRequest::default()).unwrap();
    let own = trial.coupled.model.observations(&trial.coupled.model.starts[sequence]);
    [0, 1].map(|given| {
        let other = 1 - given;
        let mut y = recorded.clone();
        y[other].fill(f64::NAN);
        let latents = trial.coupled.infer(&filter, &y).unwrap();
        let error = |y: &DMatrix<f64>| (y - &recorded[other]).norm_squared();
        error(&filter.mean_columns(other, &latents).unwrap()) / error(&own[other])
    })
}

pub fn run(folders: &[PathBuf]) {
    let settings = settings();
    println!("{} + {} inducing points, balanced, seed 0.\n", settings.dynamics_ips, settings.pose_ips);
    let mut conditioning = Vec::new();
    println!(
        "| trials | inferred | by | error | joints | coverage, % | log density | gaps | 0 to 0.25 s | 0 to 0.5 s | 0.5 to 1 s after the cut |"
    );
    println!("{}|", "|---".repeat(11));
    for folder in folders {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let trials: Vec<Clip> = clips::read_clips(std::slice::from_ref(folder)).collect();
        let all = presets(&trials[0].skeleton);
        let parts = |id: &str| all.iter().find(|preset| preset.id == id).unwrap().parts.clone();
        let halves = parts("lower-upper");
        let mut tables = [Vec::new(), Vec::new()];
        let (mut starts, mut ratios) = (Vec::new(), [Vec::new(), Vec::new()]);
        for held_out in 0..trials.len() {
            eprintln!("{name}: trial {} of {} held out", held_out + 1, trials.len());
            let training: Vec<&Clip> =
                trials.iter().enumerate().filter(|(k, _)| *k != held_out).map(|(_, clip)| clip).collect();
            let model = train(&training, &halves, &Settings::Vcgpdm(settings.clone()));
            let whole = train(&training, &parts("whole"), &Settings::Vgpdm(settings.clone()));
            let body = &model.body;
            let columns =
                |clip: &Clip| body.mapping.encode(&clip.resample(1.0 / body.frame_time).unwrap()).unwrap().y;
            let trial = Trial {
                coupled: model.coupled().unwrap(),
                whole: whole.coupled().unwrap(),
                body,
                training: training.iter().map(|clip| body.centred(&columns(clip))).collect(),
                held_out: body.centred(&columns(&trials[held_out])),
            };
            for (given, table) in tables.iter_mut().enumerate() {
                table.push(trial.rows(given));
            }
            starts.push(conditioned(&trials, held_out, &halves, trial.coupled));
            for (ratios, ratio) in ratios.iter_mut().zip(completed(&trial, &columns(training[0]), 0)) {
                ratios.push(ratio);
            }
        }
        for (given, table) in tables.iter().enumerate() {
            for (method, label) in METHODS.iter().enumerate() {
                let numbers = (0..table[0][method].numbers.len()).map(|k| {
                    let middle =
                        median(&table.iter().map(|rows| rows[method].numbers[k]).collect::<Vec<_>>());
                    if matches!(k, 2 | 3) { format!("{middle:.0}") } else { format!("{middle:.2}") }
                });
                let cells = numbers.collect::<Vec<_>>().join(" | ");
                println!("| {name} | {} | {label} | {cells} |", halves[1 - given].name);
            }
        }
        let of = |k: usize| median(&starts.iter().map(|numbers| numbers[k]).collect::<Vec<_>>());
        let ratio = median(&starts.iter().map(|numbers| numbers[1] / numbers[0]).collect::<Vec<_>>());
        conditioning.push(format!(
            "| {name} | {:.5} | {:.5} | {ratio:.2} | {:.1} | {:.3} | {:.2} | {:.2} |",
            of(0),
            of(1),
            of(2),
            of(3),
            median(&ratios[0]),
            median(&ratios[1]),
        ));
    }
    println!(
        "\n| trials | {START_FRAMES} frames trained on | observed | observed : trained on | training, s | observing, s | training clip, upper from lower | lower from upper |"
    );
    println!("{}|", "|---".repeat(8));
    conditioning.iter().for_each(|row| println!("{row}"));
}
