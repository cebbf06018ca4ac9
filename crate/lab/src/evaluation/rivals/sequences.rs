//! The sequences of a training as trials, and how many first frames of each are given.

use nalgebra::DMatrix;
use vcgpdm_core::models::{MOST_FRAMES, Movements, RolloutError, TrainingError, Trial};

/// Training sequences with the columns of all parts side by side.
pub(super) struct Trials {
    pub trials: Vec<Trial>,
    /// The number of first frames from which a rollout starts: those of the shortest sequence that is no whole
    /// trial, so that trials trained on are predicted as the trial held out. Without such a sequence, all.
    given: Option<usize>,
}

impl Trials {
    /// # Errors
    /// No sequence is a whole trial, or a sequence has fewer than `least` frames.
    pub fn new(movements: &Movements, least: usize) -> Result<Self, TrainingError> {
        let y = movements.as_one_part().y.swap_remove(0);
        if y.ncols() == 0 {
            return Err(TrainingError::NoParts);
        }
        let mut at = 0;
        let mut trials = Vec::new();
        for (sequence, s) in movements.sequences.iter().enumerate() {
            if s.frames < least {
                return Err(TrainingError::Short { sequence, expected: least, found: s.frames });
            }
            trials.push(Trial { y: y.rows(at, s.frames).into_owned(), whole: s.whole });
            at += s.frames;
        }
        if trials.iter().all(|trial| !trial.whole) {
            return Err(TrainingError::NoWhole);
        }
        let given = trials.iter().filter(|trial| !trial.whole).map(|trial| trial.y.nrows()).min();
        Ok(Self { trials, given })
    }

    /// The first frames of each sequence from which a rollout starts [k x D].
    pub fn starts(&self) -> Vec<DMatrix<f64>> {
        let frames = |y: &DMatrix<f64>| self.given.unwrap_or(y.nrows()).min(y.nrows());
        self.trials.iter().map(|trial| trial.y.rows(0, frames(&trial.y)).into_owned()).collect()
    }
}

/// Checks the request of a rollout of a model of `count` sequences.
///
/// # Errors
/// There is no such sequence, or the number of frames is 0 or too large.
pub(super) fn check(count: usize, sequence: usize, frames: usize) -> Result<(), RolloutError> {
    if sequence >= count {
        return Err(RolloutError::Sequence { count, found: sequence });
    }
    if !(1..=MOST_FRAMES).contains(&frames) {
        return Err(RolloutError::Frames { most: MOST_FRAMES, found: frames });
    }
    Ok(())
}
