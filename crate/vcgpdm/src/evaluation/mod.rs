//! How well models predict: scores of a motion against another one, cross-validation over trials, and their statistics.

mod claims;
mod comparison;
mod cross_validation;
mod dtw;
mod labels;
mod results;
mod rows;
pub mod stats;

pub use claims::Claim;
pub use comparison::{BoundAndError, Comparison, Correlation, FramesAndTime, Growth, ModelSummary, Spread};
pub use cross_validation::{EvaluationError, Fold, Outcome, START_FRAMES};
pub use dtw::{Score, ScoreError, dtw_mse};
pub use labels::Labels;
pub use results::{Finished, Job, Results, ResultsError, ResultsPart, Setting, Trial};
