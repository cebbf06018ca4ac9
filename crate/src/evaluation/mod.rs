//! Scores of a motion against another one.

mod dtw;

pub use dtw::{Score, ScoreError, dtw_mse};
