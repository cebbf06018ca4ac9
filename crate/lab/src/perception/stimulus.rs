//! One movement of a study, and its source.

use crate::evaluation::Outcome;
use crate::perception::movement::FigureMovement;
use vcgpdm_core::models::Settings;
use vcgpdm_core::models::variational::BoundTerms;

/// A movement of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Stimulus {
    /// Its unique name: letters, digits, dots and dashes, a letter first.
    pub id: String,
    /// The trial that was recorded, or that was held out and predicted.
    pub trial: String,
    /// The source of the movement.
    pub source: MovementSource,
    /// The speed of the figure before it was centred, in metres a second.
    pub speed: f64,
    /// The positions of the figure's nodes.
    pub movement: FigureMovement,
}

/// The source of a movement.
#[derive(Clone, Debug, PartialEq)]
pub enum MovementSource {
    /// It was recorded.
    Natural {
        /// Whether it is in all trials, and models were trained on it; otherwise it is for catch trials only.
        seen: bool,
    },
    /// A model made it.
    Generated(Box<Generated>),
}

/// The model of a generated movement.
#[derive(Clone, Debug, PartialEq)]
pub struct Generated {
    /// The model with its settings.
    pub candidate: Settings,
    /// The seed of its training.
    pub seed: u32,
    /// Whether it is marked as an obvious failure, which only checks the attention.
    pub failed: bool,
    /// The scores of the model.
    pub scores: Scores,
}

/// Errors of a model on the trial held out, and its bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Scores {
    /// Mean squared error on the trial held out, frame by frame.
    pub mse: f64,
    /// The same after dynamic time warping.
    pub dtw_mse: f64,
    /// The mean error of rollouts over the trials trained on, after dynamic time warping; absent in studies of
    /// earlier versions.
    pub training_mse: Option<f64>,
    /// The bound on the log evidence, in nats, if the model has one.
    pub bound: Option<f64>,
    /// The terms of the bound, if the model has them.
    pub terms: Option<BoundTerms>,
}

impl Scores {
    /// The scores of an outcome.
    pub fn new(outcome: &Outcome) -> Self {
        Self {
            mse: outcome.score.mse,
            dtw_mse: outcome.score.dtw_mse,
            training_mse: outcome.training_mse,
            bound: outcome.bound,
            terms: outcome.terms.clone(),
        }
    }

    /// The part of the bound about poses: the kinematics terms of all parts.
    pub fn pose(&self) -> Option<f64> {
        self.terms.as_ref().map(|terms| terms.kinematics.iter().sum())
    }

    /// The part of the bound about dynamics: the dynamics terms of all parts, the first frames, and the
    /// entropy of the latents.
    pub fn dynamics(&self) -> Option<f64> {
        self.terms.as_ref().map(BoundTerms::dynamics_elbo)
    }
}

impl Stimulus {
    /// The model, if a model made the movement.
    pub fn generated(&self) -> Option<&Generated> {
        match &self.source {
            MovementSource::Generated(generated) => Some(generated),
            MovementSource::Natural { .. } => None,
        }
    }

    /// For a natural movement, whether it is in all trials; absent for a generated one.
    pub fn natural(&self) -> Option<bool> {
        match self.source {
            MovementSource::Natural { seen } => Some(seen),
            MovementSource::Generated(_) => None,
        }
    }

    /// Marks a generated movement as an obvious failure or not.
    pub(super) fn mark(&mut self, failed: bool) {
        if let MovementSource::Generated(generated) = &mut self.source {
            generated.failed = failed;
        }
    }

    /// Whether it is marked as an obvious failure.
    pub fn failed(&self) -> bool {
        self.generated().is_some_and(|generated| generated.failed)
    }
}
