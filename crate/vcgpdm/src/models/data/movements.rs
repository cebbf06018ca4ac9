//! Input of every learner: the columns of each part, one sequence after the other.

use crate::models::data::dataset::Dataset;
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
}
