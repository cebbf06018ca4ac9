//! Several sequences in one matrix of frames. The history of a frame never contains frames of another sequence.
//! Each sequence has the facts about its clip.

use crate::gp::Gaussians;
use crate::models::errors::SequencesError;
use nalgebra::DMatrix;
use serde::Serialize;
use std::ops::Range;

/// The most frames of all sequences together. Sums of frames never overflow.
pub const MOST_FRAMES: usize = 1_000_000;

/// The lengths T_s of the sequences, stacked to N frames, and the order p of the dynamics.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sequences {
    lengths: Vec<usize>,
    order: usize,
    /// The frame of the stack with which the first sequence begins.
    first: usize,
}

impl Sequences {
    /// The sequences of these lengths, under dynamics of this `order`.
    ///
    /// # Errors
    ///
    /// When there is no sequence, the order is 0, a sequence has fewer than `order` frames, or no sequence
    /// has more. A sequence of exactly `order` frames has initial frames and no transition: it is the start
    /// of a movement to predict.
    pub fn new(lengths: Vec<usize>, order: usize) -> Result<Self, SequencesError> {
        if lengths.is_empty() {
            return Err(SequencesError::Empty);
        }
        if order == 0 {
            return Err(SequencesError::Order);
        }
        let all = lengths.iter().try_fold(0_usize, |sum, &frames| sum.checked_add(frames));
        if all.is_none_or(|all| all > MOST_FRAMES) {
            return Err(SequencesError::TooLong { most: MOST_FRAMES });
        }
        let longest = lengths.iter().max();
        let least = if longest.is_some_and(|&frames| frames > order) { order } else { order + 1 };
        match lengths.iter().position(|&frames| frames < least) {
            Some(index) => Err(SequencesError::TooShort { index, frames: lengths[index], order }),
            None => Ok(Self { lengths, order, first: 0 }),
        }
    }

    /// The sequences of one movement: a range of neighbouring sequences in the same stack of frames.
    ///
    /// # Errors
    ///
    /// When the range has no sequence or exceeds the number of sequences.
    pub fn subset(&self, which: Range<usize>) -> Result<Self, SequencesError> {
        let lengths = self.lengths.get(which.clone()).unwrap_or_default();
        if lengths.is_empty() {
            return Err(SequencesError::Empty);
        }
        let before: usize = self.lengths[..which.start].iter().sum();
        Ok(Self { lengths: lengths.to_vec(), order: self.order, first: self.first + before })
    }

    /// The numbers of frames T_s of the sequences.
    pub fn lengths(&self) -> &[usize] {
        &self.lengths
    }

    /// Order p of the dynamics.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Number of frames N of all sequences together.
    pub fn frames(&self) -> usize {
        self.lengths.iter().sum()
    }

    /// Number R of frames with a whole history: N - p times the number of sequences.
    pub fn transitions(&self) -> usize {
        self.frames() - self.order * self.lengths.len()
    }

    /// The frames of each sequence.
    pub fn ranges(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        self.lengths.iter().scan(self.first, |start, length| {
            let range = *start..*start + length;
            *start += length;
            Some(range)
        })
    }

    /// The first p frames of every sequence.
    pub fn initial_frames(&self) -> impl Iterator<Item = usize> + '_ {
        self.ranges().flat_map(|r| r.start..r.start + self.order)
    }

    /// The rows of `x` [N x Q] `lag` frames before each frame with a history [R x Q]; lag 0 gives these
    /// frames themselves.
    pub fn lagged(&self, x: &DMatrix<f64>, lag: usize) -> DMatrix<f64> {
        let mut out = DMatrix::zeros(self.transitions(), x.ncols());
        self.lagged_into(x, lag, &mut out);
        out
    }

    /// As [`lagged`](Self::lagged), into an existing matrix.
    pub fn lagged_into(&self, x: &DMatrix<f64>, lag: usize, out: &mut DMatrix<f64>) {
        for (rows, frames) in self.blocks(lag) {
            out.rows_mut(rows.start, rows.len()).copy_from(&x.rows(frames.start, frames.len()));
        }
    }

    /// The histories (x_{t-p}, ..., x_{t-1}), oldest first, of the latents `x` [N x Q]: [R x pQ].
    pub fn histories(&self, x: &Gaussians) -> Gaussians {
        let mut out = Gaussians::zeros(self.transitions(), self.order * x.mean.ncols());
        self.histories_into(x, &mut out);
        out
    }

    /// As [`histories`](Self::histories), into existing matrices.
    pub fn histories_into(&self, x: &Gaussians, out: &mut Gaussians) {
        self.windows_into(&x.mean, &mut out.mean);
        self.windows_into(&x.variance, &mut out.variance);
    }

    /// Adds the adjoint of [`histories`](Self::histories) to `into` [N x Q].
    pub fn add_histories_adjoint(&self, adjoint: &Gaussians, into: &mut Gaussians) {
        self.add_windows_adjoint(&adjoint.mean, &mut into.mean);
        self.add_windows_adjoint(&adjoint.variance, &mut into.variance);
    }

    /// The p rows of `x` [N x Q] before each frame that has a history, side by side, oldest first: [R x pQ].
    pub fn windows(&self, x: &DMatrix<f64>) -> DMatrix<f64> {
        let mut out = DMatrix::zeros(self.transitions(), self.order * x.ncols());
        self.windows_into(x, &mut out);
        out
    }

    fn windows_into(&self, x: &DMatrix<f64>, out: &mut DMatrix<f64>) {
        let dims = x.ncols();
        for k in 0..self.order {
            for (rows, frames) in self.blocks(self.order - k) {
                let shape = (rows.len(), dims);
                out.view_mut((rows.start, k * dims), shape).copy_from(&x.rows(frames.start, shape.0));
            }
        }
    }

    /// Adds the adjoint of [`windows`](Self::windows) to `into` [N x Q].
    pub fn add_windows_adjoint(&self, adjoint: &DMatrix<f64>, into: &mut DMatrix<f64>) {
        let dims = into.ncols();
        for k in 0..self.order {
            for (rows, frames) in self.blocks(self.order - k) {
                let shape = (rows.len(), dims);
                let mut out = into.rows_mut(frames.start, shape.0);
                out += adjoint.view((rows.start, k * dims), shape);
            }
        }
    }

    /// Adds the adjoint of [`lagged`](Self::lagged) with lag 0 to `into` [N x Q].
    pub fn add_targets_adjoint(&self, adjoint: &DMatrix<f64>, into: &mut DMatrix<f64>) {
        for (rows, frames) in self.blocks(0) {
            let mut out = into.rows_mut(frames.start, rows.len());
            out += adjoint.rows(rows.start, rows.len());
        }
    }

    /// For each sequence, its transition rows and the frames `lag` before them.
    fn blocks(&self, lag: usize) -> impl Iterator<Item = (Range<usize>, Range<usize>)> + '_ {
        self.ranges().enumerate().map(move |(s, r)| {
            let first_row = r.start - self.first - s * self.order;
            let count = r.len() - self.order;
            let first_frame = r.start + self.order - lag;
            (first_row..first_row + count, first_frame..first_frame + count)
        })
    }
}

/// A training sequence that a rollout can start from.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct SequenceInfo {
    /// The clip's name.
    pub name: String,
    /// The clip's content hash.
    pub sha256: String,
    /// Frames of the sequence.
    pub frames: usize,
    /// Seconds from its first frame to where its body comes to rest; `None`: it moves to its end, or is not
    /// known.
    pub rests_from: Option<f64>,
    /// The frames of the file that were used, the first and the one after the last; `None`: all, or not
    /// known.
    pub piece: Option<(usize, usize)>,
    /// The name of the clip whose bones it was given; `None`: it kept its own, or not known.
    pub bones_of: Option<String>,
    /// Whether all of the clip's frames are there; else only its first ones are.
    pub whole: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn histories_stay_inside_their_sequence() {
        let sequences = Sequences::new(vec![4, 3], 2).unwrap();
        let x = Gaussians {
            mean: DMatrix::from_fn(7, 1, |t, _| t as f64),
            variance: DMatrix::from_fn(7, 1, |t, _| 10.0 + t as f64),
        };
        let h = sequences.histories(&x);
        assert_eq!(h.mean, DMatrix::from_row_slice(3, 2, &[0.0, 1.0, 1.0, 2.0, 4.0, 5.0]));
        assert_eq!(h.variance.column(1).as_slice(), &[11.0, 12.0, 15.0]);
        assert_eq!(sequences.lagged(&x.mean, 0).as_slice(), &[2.0, 3.0, 6.0]);
        assert_eq!(sequences.initial_frames().collect::<Vec<_>>(), [0, 1, 4, 5]);
    }

    #[test]
    fn a_subset_keeps_its_place_in_the_stack() {
        let all = Sequences::new(vec![4, 3, 5], 2).unwrap();
        let some = all.subset(1..3).unwrap();
        assert_eq!((some.lengths(), some.frames(), some.transitions()), (&[3, 5][..], 8, 4));
        assert_eq!(some.ranges().collect::<Vec<_>>(), [4..7, 7..12]);
        let x = DMatrix::from_fn(12, 1, |t, _| t as f64);
        assert_eq!(some.lagged(&x, 0).as_slice(), &[6.0, 9.0, 10.0, 11.0]);
        assert_eq!(some.lagged(&x, 2).as_slice(), &[4.0, 7.0, 8.0, 9.0]);
        assert_eq!(all.subset(0..3).unwrap(), all);
        assert_eq!(all.subset(2..2).unwrap_err(), SequencesError::Empty);
        assert_eq!(all.subset(2..4).unwrap_err(), SequencesError::Empty);
    }

    #[test]
    fn adjoints_are_transposes() {
        let sequences = Sequences::new(vec![5, 4, 6], 2).unwrap();
        let x = Gaussians {
            mean: DMatrix::from_fn(15, 2, |t, q| ((t * 3 + q) as f64).sin()),
            variance: DMatrix::from_fn(15, 2, |t, q| ((t + 5 * q) as f64).cos()),
        };
        let h = sequences.histories(&x);
        let g = Gaussians {
            mean: h.mean.map_with_location(|t, q, _| (t as f64 - q as f64).sin()),
            variance: h.variance.map_with_location(|t, q, _| (t as f64 + q as f64).cos()),
        };
        let mut back = Gaussians::zeros(15, 2);
        sequences.add_histories_adjoint(&g, &mut back);
        let forth = h.mean.dot(&g.mean) + h.variance.dot(&g.variance);
        assert!((forth - x.mean.dot(&back.mean) - x.variance.dot(&back.variance)).abs() < 1e-12);
    }

    #[test]
    fn refuses_short_sequences() {
        let error = |lengths| Sequences::new(lengths, 2).unwrap_err().to_string();
        assert_eq!(error(vec![8, 1]), "sequence 1 has 1 frame; dynamics of order 2 need at least 3");
        assert_eq!(error(vec![2, 2]), "sequence 0 has 2 frames; dynamics of order 2 need at least 3");
        assert!(Sequences::new(vec![MOST_FRAMES], 2).is_ok());
        assert_eq!(
            Sequences::new(vec![MOST_FRAMES, 1], 2),
            Err(SequencesError::TooLong { most: MOST_FRAMES })
        );
    }

    #[test]
    fn a_sequence_of_one_history_has_no_transition() {
        let sequences = Sequences::new(vec![5, 2, 4], 2).unwrap();
        assert_eq!((sequences.frames(), sequences.transitions()), (11, 5));
        let x = DMatrix::from_fn(11, 1, |t, _| t as f64);
        assert_eq!(sequences.lagged(&x, 0).as_slice(), [2.0, 3.0, 4.0, 9.0, 10.0]);
        assert_eq!(sequences.initial_frames().collect::<Vec<_>>(), [0, 1, 5, 6, 7, 8]);
    }
}
