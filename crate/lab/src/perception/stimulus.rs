//! One movement that is shown, and what is known of it.

use crate::evaluation::Outcome;
use crate::perception::movement::FigureMovement;
use vcgpdm::models::Settings;
use vcgpdm::models::variational::BoundTerms;

/// A movement that is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Stimulus {
    /// Tells it from all others: letters, digits, dots and dashes, a letter first.
    pub id: String,
    /// The trial that was recorded, or that was held out and predicted.
    pub trial: String,
    /// Where it comes from.
    pub source: MovementSource,
    /// How fast the figure went through the world before it was centred, in metres a second.
    pub speed: f64,
    /// The places of the figure's nodes.
    pub movement: FigureMovement,
}

/// Where a movement comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum MovementSource {
    /// It was recorded.
    Natural {
        /// Whether it is one of those that are shown all along, on which models were trained; else it is kept
        /// for catch trials.
        seen: bool,
    },
    /// A model made it.
    Generated(Box<Generated>),
}

/// What is known of a generated movement.
#[derive(Clone, Debug, PartialEq)]
pub struct Generated {
    /// The model with its settings.
    pub candidate: Settings,
    /// The seed of its training.
    pub seed: u32,
    /// Whether somebody has marked it as an obvious failure: it checks attention and counts for nothing else.
    pub failed: bool,
    /// How good the model is.
    pub scores: Scores,
}

/// How good a model is at the trial held out, and what its bound says.
#[derive(Clone, Debug, PartialEq)]
pub struct Scores {
    /// Mean squared error on the trial held out, frame by frame.
    pub mse: f64,
    /// The same after dynamic time warping.
    pub dtw_mse: f64,
    /// The bound on the log evidence, in nats, where the model has one.
    pub bound: Option<f64>,
    /// Its terms, where it has such.
    pub terms: Option<BoundTerms>,
}

impl Scores {
    /// The scores of an outcome.
    pub fn new(outcome: &Outcome) -> Self {
        Self {
            mse: outcome.score.mse,
            dtw_mse: outcome.score.dtw_mse,
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
        self.terms.as_ref().map(|terms| terms.dynamics.iter().sum::<f64>() + terms.initial + terms.entropy)
    }
}

impl Stimulus {
    /// What is known of it, where a model made it.
    pub fn generated(&self) -> Option<&Generated> {
        match &self.source {
            MovementSource::Generated(generated) => Some(generated),
            MovementSource::Natural { .. } => None,
        }
    }

    /// Whether it is natural, and, if so, one of those that are shown all along.
    pub fn natural(&self) -> Option<bool> {
        match self.source {
            MovementSource::Natural { seen } => Some(seen),
            MovementSource::Generated(_) => None,
        }
    }

    /// Marks it as an obvious failure or not; a natural one is none.
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
