//! The first half second of a prediction (docs/comparison.md): where the vCGPDM starts, beside the autoregression.
//! Each trial of a person is held out once.

use crate::parallel::each_seed;
use crate::ratios::{persons, ratio};
use clap::Args;
use nalgebra::DMatrix;
use std::path::PathBuf;
use vcgpdm::models::variational::Vcgpdm;
use vcgpdm::models::{FittedModel, Reading, RolloutError, Settings, VariationalSettings};
use vcgpdm::motion::{Clip, parts};
use vcgpdm_lab::evaluation::{Fold, Forecast, Predictor, Rival, START_FRAMES, dtw_mse, stats};

const RATE: f64 = 30.0;
/// Frames of the first half second.
const SOON: usize = 15;
/// Frames in which a correction decays to 1 / e.
const FADE: f64 = 6.0;
const RIVAL: Rival = Rival::Ar { components: 20, order: 3 };
/// What is compared with what: places in the errors of a trial.
const COMPARED: [(&str, usize, usize); 5] = [
    ("last given frames : first frames", 1, 0),
    ("last frames, corrected : first frames", 2, 0),
    ("first frames : autoregression", 0, 3),
    ("last given frames : autoregression", 1, 3),
    ("last frames, corrected : autoregression", 2, 3),
];

#[derive(Args)]
pub struct Arguments {
    /// Folders with the trials (BVH) of one person each; absent: the sample walks.
    folders: Vec<PathBuf>,
    /// Most iterations of the vCGPDM.
    #[arg(long, default_value_t = 3000)]
    iterations: usize,
    /// Trainings at a time.
    #[arg(long, default_value_t = 1)]
    threads: usize,
}

/// The logarithms of two errors, of the first half second and after time warping, of each prediction.
type Errors = [[f64; 2]; 4];

pub fn run(arguments: &Arguments) {
    println!(
        "| trials | prediction from | error of the first half second | DTW MSE |\n{}|",
        "|---".repeat(4)
    );
    let mut all: Vec<Errors> = Vec::new();
    for (name, clips) in persons(&arguments.folders) {
        let trials = each_seed(0..clips.len() as u32, arguments.threads, |trial| {
            errors(&clips, trial as usize, arguments.iterations)
        });
        print(&name, &trials);
        let mean = |which: usize, error: usize| {
            stats::mean(&trials.iter().map(|trial| trial[which][error]).collect::<Vec<_>>())
        };
        all.push(std::array::from_fn(|which| [mean(which, 0), mean(which, 1)]));
    }
    print(&format!("{} persons", all.len()), &all);
}

fn print(name: &str, units: &[Errors]) {
    for (compared, a, b) in COMPARED {
        let cell = |error: usize| {
            let of = |which: usize| units.iter().map(|unit| unit[which][error].exp()).collect::<Vec<_>>();
            ratio(&of(a), &of(b))
        };
        println!("| {name} | {compared} | {} | {} |", cell(0), cell(1));
    }
}

fn errors(clips: &[Clip], trial: usize, iterations: usize) -> Errors {
    let presets = parts::presets(&clips[0].skeleton);
    let parts = &presets.iter().find(|preset| preset.id == "lower-upper").unwrap().parts;
    let fold = Fold::new(clips, trial, clips.len() - 1, parts, RATE, START_FRAMES).unwrap();
    let settings = VariationalSettings::default().with_points(10, 10).with_max_iterations(iterations);
    let mut learner = fold.learner(&Settings::Vcgpdm(settings), 0).unwrap();
    while !learner.step().done {}
    let fitted = learner.model().unwrap();
    let FittedModel::Vcgpdm(model) = &fitted else { unreachable!() };
    let from_last = |fade| FromLast { model, fold: &fold, fade };
    let rival = RIVAL.fit(fold.movements()).unwrap();
    let all: [&dyn Predictor; 4] = [&fitted, &from_last(None), &from_last(Some(FADE)), &*rival];
    all.map(|model| {
        let (made, actual) = (fold.predict(model).unwrap(), fold.actual());
        let soon = SOON.min(actual.nrows() - START_FRAMES);
        let apart = made.rows(START_FRAMES, soon) - actual.rows(START_FRAMES, soon);
        [(apart.norm_squared() / apart.len() as f64).ln(), dtw_mse(&made, actual).unwrap().dtw_mse.ln()]
    })
}

/// A rollout that starts from the latents of the last given frames.
struct FromLast<'a> {
    model: &'a Vcgpdm,
    fold: &'a Fold,
    /// What the pose of the last given frame misses is added to the next ones, and decays in so many frames.
    fade: Option<f64>,
}

impl Predictor for FromLast<'_> {
    fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        let first = START_FRAMES - self.model.order;
        let dynamics = self.model.dynamics(&self.model.alpha, Reading::AsLearned)?;
        let path = dynamics.path(&self.model.start(sequence, first)?, frames.saturating_sub(first))?;
        let before =
            (0..first).map(|frame| self.model.start(sequence, frame)).collect::<Result<Vec<_>, _>>()?;
        let latents = path.iter().enumerate().map(|(part, path)| {
            let given = before.iter().map(|start| start[part].row(0));
            DMatrix::from_rows(&given.chain(path.row_iter()).map(|row| row.into_owned()).collect::<Vec<_>>())
        });
        let mut y = self.model.observations(&latents.collect::<Vec<_>>());
        let Some(fade) = self.fade else { return Ok(y) };
        for (y, recorded) in y.iter_mut().zip(&self.fold.movements().y) {
            let missed = recorded.row(recorded.nrows() - 1) - y.row(START_FRAMES - 1);
            for (frame, mut row) in y.row_iter_mut().enumerate().skip(START_FRAMES) {
                row += &missed * (-((frame + 1 - START_FRAMES) as f64) / fade).exp();
            }
        }
        Ok(y)
    }

    fn forecast(&self, _: usize, _: usize) -> Result<Option<Forecast>, RolloutError> {
        Ok(None)
    }

    fn stored_numbers(&self) -> usize {
        self.model.stored_numbers()
    }
}
