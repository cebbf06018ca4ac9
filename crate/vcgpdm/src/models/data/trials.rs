//! Sequences as trials with the columns of all parts side by side, and back.

use crate::models::data::movements::Movements;
use crate::models::data::phase::Trial;
use crate::models::training::error::TrainingError;
use nalgebra::DMatrix;

/// The fewest frames of a whole movement.
const LEAST_FRAMES: usize = 4;

/// The sequences with the columns of all parts side by side, and the number of columns D_i of each part.
///
/// # Errors
///
/// When there is no column, a part does not have one row for each frame, a sequence is too short, or no
/// sequence is a whole movement.
pub fn split_trials(movements: &Movements) -> Result<(Vec<Trial>, Vec<usize>), TrainingError> {
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
    let joined = movements.as_one_part().y.swap_remove(0);
    let mut trials = Vec::new();
    let mut at = 0;
    for (sequence, s) in movements.sequences.iter().enumerate() {
        let expected = if s.whole { LEAST_FRAMES } else { 1 };
        if s.frames < expected {
            return Err(TrainingError::Short { sequence, expected, found: s.frames });
        }
        trials.push(Trial { y: joined.rows(at, s.frames).into_owned(), whole: s.whole });
        at += s.frames;
    }
    if trials.iter().all(|trial| !trial.whole) {
        return Err(TrainingError::NoWhole);
    }
    Ok((trials, columns))
}

/// The columns `y` [T x D] of all parts, divided into those of each part [T x D_i]; `columns` are the numbers
/// D_i.
pub fn split(y: &DMatrix<f64>, columns: &[usize]) -> Vec<DMatrix<f64>> {
    let mut at = 0;
    let part = |&width: &usize| {
        at += width;
        y.columns(at - width, width).into_owned()
    };
    columns.iter().map(part).collect()
}
