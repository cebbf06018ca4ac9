//! How well models predict: scores of a motion against another one, cross-validation over trials, and their statistics.

mod candidate;
mod cross_validation;
mod dtw;
pub mod stats;

pub use candidate::{Candidate, GpdmSettings, PointSettings};
pub use cross_validation::{EvaluationError, Fold, Outcome, START_FRAMES};
pub use dtw::{Score, ScoreError, dtw_mse};
