//! A training under way, whatever the model.

use crate::gp::NumericsError;
use crate::json::Value;
use crate::models::kind::ModelKind;
use crate::models::rollout::RolloutError;
use nalgebra::DMatrix;

/// How far a training is.
#[derive(Clone, Debug, PartialEq)]
pub struct LearningProgress {
    /// Iterations so far.
    pub iteration: usize,
    /// Most iterations there can be.
    pub max_iterations: usize,
    /// What is maximised, now: the bound, a log density, or the negative of an error.
    pub objective: f64,
    /// The best so far.
    pub best: f64,
    /// Whether training has ended.
    pub done: bool,
    /// Why it ended, in plain words.
    pub reason: Option<String>,
    /// Share of the work done, 0 to 1. Time left is at most elapsed (1 - fraction) / fraction.
    pub fraction: f64,
}

/// A training under way. Whoever calls it loops, shows progress and may stop at any time: the best so far is kept.
pub trait Learner {
    /// One iteration. After the end it does nothing.
    fn step(&mut self) -> LearningProgress;

    /// How far training is.
    fn progress(&self) -> LearningProgress;

    /// The best model so far.
    fn model(&self) -> Result<Box<dyn MovementModel>, NumericsError>;
}

/// A fitted model of movement.
pub trait MovementModel {
    /// Which kind of model it is.
    fn kind(&self) -> ModelKind;

    /// Centred columns of each part [frames x D_i], starting as the training sequence `sequence` starts.
    fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError>;

    /// How many numbers must be kept to roll out from one sequence ("size" in figure 4 of Velychko et al. 2018); the column
    /// means and the body are the same for all models and do not count.
    fn stored_numbers(&self) -> usize;

    /// The bound on the log evidence, in nats, where the model has one.
    fn bound(&self) -> Option<f64>;

    /// What a document holds of it under "model"; `None` for the variational models, whose document is that of
    /// [`MotionModel`](crate::models::motion_model::MotionModel).
    fn to_value(&self) -> Option<Value> {
        None
    }
}
