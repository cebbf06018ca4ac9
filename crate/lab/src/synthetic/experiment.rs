//! The experiment: the data, a training on them, the findings of the training so far, and the verdict.

use crate::synthetic::alignment::{LatentAlignment, align};
use crate::synthetic::data::{FRAMES, Synthetic, SyntheticError, spread};
use nalgebra::DMatrix;
use serde::Serialize;
use vcgpdm_core::models::variational::{VariationalTrainer, Vcgpdm};
use vcgpdm_core::models::{Progress, Reading, SeriesModel, VariationalSettings, coupling_weight_matrix};

/// How well a model explains the data.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "SyntheticFit"))]
pub struct Fit {
    /// The bound, in nats.
    pub bound: f64,
    /// The mean squared error of a rollout of all frames, after dynamic time warping of each part.
    pub mse: f64,
}

/// The last frames of a mean path, which say where it goes in the long run.
const LATE: usize = 50;

/// A model at one moment of its training, as figure 3 (E to H) of the paper shows it: for each part, in the
/// coordinates of the true latents.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The learned latents.
    pub learned: Vec<LatentAlignment>,
    /// The pose inducing points [L x 2].
    pub pose_ips: Vec<DMatrix<f64>>,
    /// The dynamics inducing points of the part's prediction about itself [K x 2p], oldest state first.
    pub dynamics_ips: Vec<DMatrix<f64>>,
    /// The mean path from the learned first states [N x 2].
    pub path: Vec<DMatrix<f64>>,
    /// The observations on that path [N x 10].
    pub generated: Vec<DMatrix<f64>>,
    /// The fit to the data.
    pub fit: Fit,
}

impl Snapshot {
    fn new(data: &Synthetic, model: &Vcgpdm) -> Result<Self, SyntheticError> {
        let path = model.dynamics(&model.alpha, Reading::AsLearned)?.path(&model.start(0, 0)?, FRAMES)?;
        let generated = model.observations(&path);
        let latents = model.starts[0].iter().zip(&data.latents);
        let learned: Vec<_> = latents.map(|(x, actual)| align(x, actual)).collect::<Result<_, _>>()?;
        let states = |part: usize| {
            let z = model.experts[part][part].z();
            let width = z.ncols() / model.order;
            let state = |p: usize| learned[part].place(&z.columns(p * width, width).into_owned());
            let placed: Vec<_> = (0..model.order).map(state).collect();
            DMatrix::from_fn(z.nrows(), 2 * model.order, |k, c| placed[c / 2][(k, c % 2)])
        };
        let parts = 0..learned.len();
        Ok(Self {
            pose_ips: parts.clone().map(|i| learned[i].place(model.parts[i].r())).collect(),
            dynamics_ips: parts.clone().map(states).collect(),
            path: parts.map(|i| learned[i].place(&path[i])).collect(),
            fit: Fit { bound: model.bound(), mse: data.mse(&generated)? },
            learned,
            generated,
        })
    }

    /// How far the mean path of each part goes round in its last 50 frames: its standard deviation there,
    /// divided by that of the true latents.
    pub fn late_spread(&self, data: &Synthetic) -> Vec<f64> {
        let late = |x: &DMatrix<f64>| spread(&x.rows(x.nrows() - LATE, LATE).into_owned());
        self.path.iter().zip(&data.latents).map(|(path, actual)| late(path) / late(actual)).collect()
    }
}

/// The findings of a training at its best bound so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Findings {
    /// Coupling variances `alpha[source][target]` [2 x 2].
    pub alpha: DMatrix<f64>,
    /// Weights of these variances `[source][target]`; the weights into each part sum to 1.
    pub weights: DMatrix<f64>,
    /// The verdict of these variances about the couplings.
    pub verdict: Verdict,
    /// The model.
    pub now: Snapshot,
}

/// A training on synthetic data, one step at a time.
pub struct Experiment {
    data: Synthetic,
    trainer: VariationalTrainer,
    start: Snapshot,
}

impl Experiment {
    /// A training on the data before its first step.
    ///
    /// # Errors
    ///
    /// Training cannot start with these settings, or the starting point cannot be rolled out.
    pub fn new(data: Synthetic, settings: &VariationalSettings, seed: u32) -> Result<Self, SyntheticError> {
        let trainer = data.trainer(settings, seed)?;
        let start = Snapshot::new(&data, &trainer.model()?)?;
        Ok(Self { data, trainer, start })
    }

    /// The data with the true latents.
    pub fn data(&self) -> &Synthetic {
        &self.data
    }

    /// The starting point.
    pub fn start(&self) -> &Snapshot {
        &self.start
    }

    /// One iteration of the optimiser. After the end it does nothing.
    pub fn step(&mut self) -> Progress {
        self.trainer.step()
    }

    /// The progress of the training.
    pub fn progress(&self) -> Progress {
        self.trainer.progress()
    }

    /// The findings so far, at any time.
    ///
    /// # Errors
    ///
    /// The model cannot be fitted or rolled out.
    pub fn findings(&self) -> Result<Findings, SyntheticError> {
        let model = self.trainer.model()?;
        let now = Snapshot::new(&self.data, &model)?;
        let weights = coupling_weight_matrix(&model.alpha);
        Ok(Findings { verdict: Verdict::new(&model.alpha), alpha: model.alpha, weights, now })
    }

    /// The best model so far, as a model of tables.
    ///
    /// # Errors
    ///
    /// The model cannot be fitted.
    pub fn model(&self) -> Result<SeriesModel, SyntheticError> {
        Ok(self.trainer.finish(&self.data.dataset()?)?)
    }
}

/// alpha^{21} is "much larger" than alpha^{11} if it is at least this many times as large.
pub const MUCH: f64 = 10.0;
/// When the first part drives the second, alpha^{12} is within this factor of alpha^{22}, larger or smaller.
pub const ALIKE: f64 = 4.0;

/// The verdict of coupling variances `alpha[source][target]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// alpha^{21} / alpha^{11}: how many times weaker the second part drives the first than the first drives
    /// itself.
    pub back: f64,
    /// alpha^{12} / alpha^{22}: how many times weaker the first part drives the second than the second drives
    /// itself.
    pub forth: f64,
}

impl Verdict {
    /// The verdict of learned couplings [2 x 2].
    pub fn new(alpha: &DMatrix<f64>) -> Self {
        Self { back: alpha[(1, 0)] / alpha[(0, 0)], forth: alpha[(0, 1)] / alpha[(1, 1)] }
    }

    /// Whether the verdict is that the second part does not drive the first.
    pub fn back_is_right(&self) -> bool {
        self.back >= MUCH
    }

    /// Whether the verdict about the first part driving the second is true: it drives if its share `drive` is
    /// not 0.
    pub fn forth_is_right(&self, drive: f64) -> bool {
        if drive > 0.0 { (1.0 / ALIKE..=ALIKE).contains(&self.forth) } else { self.forth >= MUCH }
    }

    /// Whether both verdicts are true.
    pub fn right(&self, drive: f64) -> bool {
        self.back_is_right() && self.forth_is_right(drive)
    }
}
