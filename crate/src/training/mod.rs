//! Training: where it starts, how it searches, and how it is watched, stopped and kept.

mod init;
mod optimizer;
mod trainer;

pub use init::starting_point;
pub use trainer::{Phase, Trainer, TrainingError, TrainingProgress, TrainingSettings, schedule};
