//! Why a model could not be evaluated.

use thiserror::Error;
use vcgpdm_core::gp::NumericsError;
use vcgpdm_core::models::library::{CombinationError, PlanError};
use vcgpdm_core::models::variational::ObservationError;
use vcgpdm_core::models::{DatasetError, RolloutError, ScoreError};
use vcgpdm_core::motion::ClipError;
use vcgpdm_core::motion::pose::PoseError;

/// Why a model could not be evaluated.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum EvaluationError {
    /// The trial does not exist.
    #[error(
        "expected a trial from 1 to {count} to hold out, and at least 2 trials, found trial {} of {count}",
        .found.saturating_add(1)
    )]
    Trial {
        /// Number of trials.
        count: usize,
        /// The trial found, counted from 0.
        found: usize,
    },
    /// There are too few trials.
    #[error("expected {least} trials or more, found {found}")]
    FewTrials {
        /// The least number.
        least: usize,
        /// The number found.
        found: usize,
    },
    /// There are fewer trials to train on.
    #[error("expected from 1 to {most} trials to train on, found {found}")]
    TrainingTrials {
        /// Number of the trials that are not held out.
        most: usize,
        /// The number found.
        found: usize,
    },
    /// A coupled model has nothing to couple.
    #[error("expected two parts or more for a {model} model, found 1")]
    OnePart {
        /// The id of its kind.
        model: &'static str,
    },
    /// The model does not infer latents from observed columns.
    #[error("expected a vcgpdm or vgpdm model, found a {model} model")]
    NoFilter {
        /// The id of its kind.
        model: &'static str,
    },
    /// The trials cannot be used together.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// The trial held out cannot be resampled to the frame rate.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// The trial held out cannot be converted to columns.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// The trained model could not be fitted.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
    /// The model could not infer latents from the trial held out.
    #[error(transparent)]
    Observation(Box<ObservationError>),
    /// The model could not be rolled out.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
    /// Movements that cannot be planned as a library.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A movement of a library could not be made.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// A number of the outcome is not finite, though the predicted columns are.
    #[error("the prediction is not finite: {what} is {found}")]
    NotFinite {
        /// Which number of the outcome.
        what: &'static str,
        /// The number found.
        found: f64,
    },
    /// The time of a training is impossible.
    #[error("expected the seconds of the training, from 0, found {0}")]
    Seconds(f64),
    /// The prediction could not be scored.
    #[error("the prediction cannot be scored: {0}")]
    Score(#[from] ScoreError),
}

impl From<ObservationError> for EvaluationError {
    fn from(reason: ObservationError) -> Self {
        Self::Observation(Box::new(reason))
    }
}

vcgpdm_core::coded!(EvaluationError {
    Self::Dataset(reason) => reason.code(),
    Self::Clip(reason) => reason.code(),
    Self::Pose(reason) => reason.code(),
    Self::Rollout(reason) => reason.code(),
    Self::Numerics(_) | Self::NotFinite { .. } | Self::Score(_) => Numerics,
    _ => Comparison,
});
