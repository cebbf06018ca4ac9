//! The experiment: the data, a training on them, the findings of the training so far, and the verdict.

use crate::synthetic::alignment::{LatentAlignment, align};
use crate::synthetic::data::{Synthetic, SyntheticError};
use nalgebra::DMatrix;
use serde::Serialize;
use vcgpdm::gp::NumericsError;
use vcgpdm::models::variational::{Params, VariationalTrainer};
use vcgpdm::models::{Progress, VariationalSettings, coupling_weight_matrix};

/// How well a model explains the data.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "SyntheticFit"))]
pub struct Fit {
    /// The bound, in nats.
    pub bound: f64,
    /// The mean squared error of a rollout of all frames, after dynamic time warping of each part.
    pub mse: f64,
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
    /// The learned latents of each part in the coordinates of the true ones.
    pub learned: Vec<LatentAlignment>,
    /// The fit of the model to the data.
    pub fit: Fit,
}

/// A training on synthetic data, one step at a time.
pub struct Experiment {
    data: Synthetic,
    trainer: VariationalTrainer,
    start: Fit,
}

impl Experiment {
    /// A training on the data before its first step.
    ///
    /// # Errors
    ///
    /// Training cannot start with these settings, or the starting point cannot be rolled out.
    pub fn new(data: Synthetic, settings: &VariationalSettings, seed: u32) -> Result<Self, SyntheticError> {
        let trainer = data.trainer(settings, seed)?;
        let model = trainer.model()?;
        let start = Fit { bound: model.bound(), mse: data.mse(&model)? };
        Ok(Self { data, trainer, start })
    }

    /// The data with the true latents.
    pub fn data(&self) -> &Synthetic {
        &self.data
    }

    /// The fit of the starting point to the data.
    pub fn start(&self) -> Fit {
        self.start
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
        let fit = Fit { bound: model.bound(), mse: self.data.mse(&model)? };
        let weights = coupling_weight_matrix(&model.alpha);
        let learned = self.learned(&self.trainer.best())?;
        Ok(Findings { verdict: Verdict::new(&model.alpha), alpha: model.alpha, weights, learned, fit })
    }

    fn learned(&self, params: &Params) -> Result<Vec<LatentAlignment>, NumericsError> {
        let parts = params.parts.iter().zip(&self.data.latents);
        parts.map(|(part, actual)| align(&part.latents.mean, actual)).collect()
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
