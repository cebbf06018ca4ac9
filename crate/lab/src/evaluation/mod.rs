//! Comparison of models by cross-validation.
//!
//! A [`Plan`] lists jobs, a [`Fold`] trains and scores a candidate, [`Results`] store the outcomes, and a
//! [`Comparison`] computes tables and the answers to the papers' claims.

mod candidate;
mod candidate_text;
mod claims;
mod comparison;
mod correlation;
mod cross_validation;
mod cycles;
mod details;
mod effect;
mod error;
mod fixed;
mod job;
mod labels;
mod modularity;
mod modularity_test;
mod outcome;
mod plan;
mod predictor;
mod primary;
mod results;
mod results_error;
mod rivals;
mod rows;
mod setting;
pub mod stats;
mod summary;
#[cfg(test)]
pub(crate) mod testing;
mod training_trials;

pub use candidate::{Candidate, CandidateKind};
pub use comparison::Comparison;
pub use cross_validation::{Fold, START_FRAMES};
pub use cycles::{CyclesError, whole_cycles};
pub use details::{Bands, Compared, Details};
pub use effect::Effect;
pub use error::EvaluationError;
pub use fixed::fixed;
pub use job::{Finished, Job, job_in_files};
pub use labels::Labels;
pub use modularity::{LibraryFold, LibraryOutcome, MovementTrials};
pub use modularity_test::{FoldTraining, ModularityTest, Trained};
pub use outcome::{Difference, Outcome};
pub use plan::{ComparisonPlanError, Plan};
pub use predictor::{Forecast, Predictor};
pub use results::{Disagreement, PlannedJob, Results};
pub use results_error::ResultsError;
pub use rivals::Rival;
pub use setting::{Setting, SettingError, TrialClip};
pub use summary::{
    BoundAndError, Claim, ClaimAnswer, Correlation, DetailMeans, Evidence, FramesAndTime, Growth,
    ModelSummary, Spread, TermMeans,
};
pub use training_trials::TrainingTrials;
pub use vcgpdm_core::models::{Score, ScoreError, dtw_mse};
