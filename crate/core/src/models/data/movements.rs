//! Input of every learner: the columns of each part, one sequence after the other; and the same as trials with the
//! columns of all parts side by side.

use crate::models::data::dataset::Dataset;
use crate::models::data::phase::Trial;
use crate::models::errors::TrainingError;
use nalgebra::DMatrix;

/// The movements that a model learns from.
///
/// A comparison trains on all trials but one, and on the first frames of the held-out trial as a sequence of
/// its own. Then it rolls out from that sequence for the length of the trial.
#[derive(Clone, Debug, PartialEq)]
pub struct Movements {
    /// Centred columns of each part [N x D_i], stacked sequence after sequence.
    pub y: Vec<DMatrix<f64>>,
    /// The sequences; their frames sum to N.
    pub sequences: Vec<Sequence>,
}

/// One sequence of the stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequence {
    /// Number of frames T_s.
    pub frames: usize,
    /// Whether it is a whole trial; false: the first frames of a trial that will be predicted.
    pub whole: bool,
}

impl Movements {
    /// The movements of a data set.
    pub fn new<S>(dataset: &Dataset<S>) -> Movements {
        let sequences = dataset.sequences.iter();
        let sequences = sequences.map(|info| Sequence { frames: info.frames, whole: info.whole }).collect();
        Movements { y: dataset.y.clone(), sequences }
    }

    /// The numbers of frames T_s of the sequences.
    pub fn lengths(&self) -> Vec<usize> {
        self.sequences.iter().map(|s| s.frames).collect()
    }

    /// The same movements with the columns of all parts side by side, as one part.
    pub fn as_one_part(&self) -> Movements {
        let (rows, columns) =
            (self.y.first().map_or(0, |y| y.nrows()), self.y.iter().map(|y| y.ncols()).sum());
        let mut joined = DMatrix::zeros(rows, columns);
        let mut at = 0;
        for y in &self.y {
            joined.columns_mut(at, y.ncols()).copy_from(y);
            at += y.ncols();
        }
        Movements { y: vec![joined], sequences: self.sequences.clone() }
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_part_has_all_columns_in_order() {
        let y = vec![DMatrix::from_element(3, 2, 1.0), DMatrix::from_element(3, 1, 2.0)];
        let joined = Movements { y, sequences: vec![Sequence { frames: 3, whole: true }] }.as_one_part();
        assert_eq!(joined.y, [DMatrix::from_row_slice(3, 3, &[1., 1., 2., 1., 1., 2., 1., 1., 2.])]);
        assert_eq!(joined.lengths(), [3]);
    }

    #[test]
    fn a_whole_movement_has_at_least_four_frames() {
        let frames = |whole: usize, first: usize| {
            let sequences =
                vec![Sequence { frames: whole, whole: true }, Sequence { frames: first, whole: false }];
            split_trials(&Movements { y: vec![DMatrix::zeros(whole + first, 1)], sequences })
                .map(|(trials, _)| trials.len())
        };
        assert_eq!(frames(4, 1), Ok(2));
        assert_eq!(frames(3, 1), Err(TrainingError::Short { sequence: 0, expected: 4, found: 3 }));
        assert_eq!(frames(4, 0), Err(TrainingError::Short { sequence: 1, expected: 1, found: 0 }));
    }
}
