//! Training: where it starts, how it searches, and how it is watched, stopped and kept.

mod ascent;
mod init;
mod optimizer;
mod trainer;
mod variational;

pub(crate) use ascent::{Ascent, Phase, Target};
pub(crate) use init::starting_point;
pub(crate) use trainer::check_training;
pub use trainer::{Trainer, TrainingError, TrainingProgress, TrainingSettings};
pub use variational::{VariationalLearner, VariationalModel};
