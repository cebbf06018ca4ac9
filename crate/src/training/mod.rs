//! Training: where it starts, how it searches, and how it is watched, stopped and kept.

mod init;
mod optimizer;
mod trainer;
mod variational;

pub use trainer::{Trainer, TrainingError, TrainingProgress, TrainingSettings};
pub use variational::{VariationalLearner, VariationalModel};
