//! The sequences of a training set as trials with the columns of all parts side by side, and back.

use crate::models::movements::Movements;
use crate::models::phase::Trial;
use crate::models::training_error::TrainingError;
use nalgebra::DMatrix;

/// Fewer frames are no whole movement.
const LEAST_FRAMES: usize = 4;

/// The sequences with the columns of all parts side by side, and the number of columns D_i of each part.
pub fn trials_of(movements: &Movements) -> Result<(Vec<Trial>, Vec<usize>), TrainingError> {
    let columns: Vec<usize> = movements.y.iter().map(|y| y.ncols()).collect();
    if columns.iter().sum::<usize>() == 0 {
        return Err(TrainingError::NoParts);
    }
    let expected: usize = movements.sequences.iter().map(|s| s.frames).sum();
    for (part, y) in movements.y.iter().enumerate() {
        if y.nrows() != expected {
            return Err(TrainingError::Frames { part, expected, found: y.nrows() });
        }
    }
    let all = movements.as_one_part().y.swap_remove(0);
    let mut trials = Vec::new();
    let mut at = 0;
    for (sequence, s) in movements.sequences.iter().enumerate() {
        let expected = if s.whole { LEAST_FRAMES } else { 1 };
        if s.frames < expected {
            return Err(TrainingError::Short { sequence, expected, found: s.frames });
        }
        trials.push(Trial { y: all.rows(at, s.frames).into_owned(), whole: s.whole });
        at += s.frames;
    }
    if trials.iter().all(|trial| !trial.whole) {
        return Err(TrainingError::NoWhole);
    }
    Ok((trials, columns))
}

/// The columns of each part.
pub fn split(y: &DMatrix<f64>, columns: &[usize]) -> Vec<DMatrix<f64>> {
    let mut at = 0;
    let part = |&width: &usize| {
        at += width;
        y.columns(at - width, width).into_owned()
    };
    columns.iter().map(part).collect()
}
