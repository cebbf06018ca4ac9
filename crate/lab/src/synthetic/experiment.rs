//! The experiment: the data, a training on them, and the findings of the training so far.

use crate::synthetic::alignment::{LatentAlignment, align};
use crate::synthetic::data::{Synthetic, SyntheticError};
use crate::synthetic::verdict::Verdict;
use nalgebra::DMatrix;
use serde::Serialize;
use vcgpdm::gp::NumericsError;
use vcgpdm::models::variational::{Params, VariationalTrainer};
use vcgpdm::models::{Progress, VariationalSettings, coupling_weight_matrix};

/// The fit of a model to the data.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Fit {
    /// The bound, in nats.
    pub bound: f64,
    /// The error of the mean rollout: [`Synthetic::mse`].
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
