//! Latent paths of a rollout so far, in the layout that the dynamics read.

use crate::models::rollout::request::{Push, RolloutError, TEMPOS};
use nalgebra::DMatrix;
use std::borrow::Cow;
use std::ops::Range;

/// The latent paths of all parts so far. There are always at least p frames: the start of the rollout.
///
/// A part at tempo s moves s times as fast. Its history is read at whole frames of its own time, with
/// straight lines between frames, and each frame makes the share s of the predicted step:
///
/// x^i <- x^i + s_i ( sum_j w_{ji} f^{ji}(history of j) - x^i ).
///
/// At tempo 1 these are the dynamics as learned. The papers have no tempo.
#[derive(Clone, Debug)]
pub(crate) struct LatentPaths {
    order: usize,
    latent: Vec<usize>,
    /// The paths [frames x Q_i], one frame after the other, so that a history is a slice.
    paths: Vec<Vec<f64>>,
    /// Frames of each part's own time in a frame.
    tempos: Vec<f64>,
}

impl LatentPaths {
    /// Paths that begin with the `start` [frames x Q_i] of each part, `order` p frames or more, of `latent`
    /// dimensions Q_i.
    pub(crate) fn new(start: &[DMatrix<f64>], order: usize, latent: &[usize]) -> Result<Self, RolloutError> {
        let rows = start.first().map_or(0, DMatrix::nrows).max(order);
        for (part, &columns) in latent.iter().enumerate() {
            let (found_rows, found_columns) = start.get(part).map_or((0, 0), |s| s.shape());
            if (found_rows, found_columns) != (rows, columns) {
                return Err(RolloutError::Start { part, rows, columns, found_rows, found_columns });
            }
        }
        let rows = |start: &DMatrix<f64>| start.transpose().as_slice().to_vec();
        let paths = start.iter().take(latent.len()).map(rows).collect();
        Ok(Self { order, latent: latent.to_vec(), paths, tempos: vec![1.0; latent.len()] })
    }

    /// The order p: frames of a history.
    pub(crate) fn order(&self) -> usize {
        self.order
    }

    /// Latent dimensions Q of each part.
    pub(crate) fn latent(&self) -> &[usize] {
        &self.latent
    }

    /// The number of frames so far.
    pub(crate) fn frames(&self) -> usize {
        match (self.paths.first(), self.latent.first()) {
            (Some(path), Some(&q)) if q > 0 => path.len() / q,
            _ => 0,
        }
    }

    /// Sets the tempo of a part, one of [`TEMPOS`].
    pub(crate) fn set_tempo(&mut self, part: usize, tempo: f64) {
        self.tempos[part] = tempo;
    }

    /// The tempo of a part.
    pub(crate) fn tempo(&self, part: usize) -> f64 {
        self.tempos[part]
    }

    /// Lets a part continue from a state [p x Q].
    pub(crate) fn set_history(&mut self, part: usize, state: &DMatrix<f64>) {
        let (q, frames) = (self.latent[part], self.frames());
        let last = frames.saturating_sub(state.nrows());
        for frame in 0..frames {
            let row = state.row(frame.saturating_sub(last));
            self.paths[part][frame * q..][..q].iter_mut().zip(row.iter()).for_each(|(x, to)| *x = *to);
        }
    }

    /// The last p frames of a part in its own time, oldest first [p Q_i].
    pub(crate) fn history(&self, part: usize) -> Cow<'_, [f64]> {
        self.history_until(part, self.frames())
    }

    /// The last p of the first `end` frames of a part in its own time, oldest first [p Q_i].
    pub(crate) fn history_until(&self, part: usize, end: usize) -> Cow<'_, [f64]> {
        let (q, tempo, path) = (self.latent[part], self.tempos[part], &self.paths[part]);
        if tempo == 1.0 {
            return Cow::Borrowed(&path[(end - self.order) * q..end * q]);
        }
        let frame = |back: usize| &path[(end - 1 - back.min(end - 1)) * q..][..q];
        let state = |k: usize| {
            let back = k as f64 / tempo;
            let (later, earlier) = (frame(back as usize), frame(back as usize + 1));
            later.iter().zip(earlier).map(move |(a, b)| a + back.fract() * (b - a))
        };
        (0..self.order).rev().flat_map(state).collect()
    }

    /// Appends a frame: the latents `[Q_i]` that are predicted for each part.
    pub(crate) fn append(&mut self, next: &[Vec<f64>]) {
        for ((path, next), tempo) in self.paths.iter_mut().zip(next).zip(&self.tempos) {
            let newest = path.len() - next.len();
            path.extend_from_slice(next);
            if *tempo != 1.0 {
                for k in newest..newest + next.len() {
                    path[k + next.len()] = path[k] + tempo * (path[k + next.len()] - path[k]);
                }
            }
        }
    }

    /// Appends the frames of longer paths of these parts that are missing here.
    pub(crate) fn follow(&mut self, others: &LatentPaths) {
        for (path, other) in self.paths.iter_mut().zip(&others.paths) {
            path.extend_from_slice(&other[path.len()..]);
        }
    }

    /// Pushes a part: the frames of its history move together. The push must fit the part.
    pub(crate) fn push(&mut self, push: &Push) {
        let (path, q) = (&mut self.paths[push.part], self.latent[push.part]);
        let newest = path.len() - q;
        let step =
            |k: usize| path[newest + k] - newest.checked_sub(q).map_or(path[k], |before| path[before + k]);
        let displacement = |k: usize| push.by.get(k).unwrap_or(&0.0) + push.ahead * step(k);
        let by: Vec<f64> = (0..q).map(displacement).collect();
        let history = ((self.order - 1) as f64 / self.tempos[push.part]).ceil() as usize + 1;
        for frame in path[(newest + q).saturating_sub(history.max(self.order) * q)..].chunks_exact_mut(q) {
            frame.iter_mut().zip(&by).for_each(|(x, by)| *x += by);
        }
    }

    /// The newest latents `[Q_i]` of a part.
    pub(crate) fn newest(&self, part: usize) -> &[f64] {
        let path = &self.paths[part];
        &path[path.len() - self.latent[part]..]
    }

    /// Replaces the newest latents of a part.
    pub(crate) fn set_newest(&mut self, part: usize, latents: &[f64]) {
        let (path, q) = (&mut self.paths[part], self.latent[part]);
        let newest = path.len() - q;
        path[newest..].copy_from_slice(latents);
    }

    /// Drops all but the last frames that a prediction, a push or a drive needs at any tempo.
    pub(crate) fn forget(&mut self) {
        let most = (self.order as f64 / TEMPOS.start()) as usize + 1;
        for (path, q) in self.paths.iter_mut().zip(&self.latent) {
            path.drain(..path.len().saturating_sub(most * q));
        }
    }

    /// The paths of all parts in these frames [frames x Q_i].
    pub(crate) fn matrices(&self, frames: Range<usize>) -> Vec<DMatrix<f64>> {
        let paths = self.paths.iter().zip(&self.latent);
        let part = |(path, &q): (&Vec<f64>, &usize)| {
            DMatrix::from_row_slice(frames.len(), q, &path[frames.start * q..frames.end * q])
        };
        paths.map(part).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paths() -> LatentPaths {
        let start =
            [DMatrix::from_row_slice(2, 1, &[1.0, 2.0]), DMatrix::from_row_slice(2, 2, &[1., 2., 3., 4.])];
        let mut paths = LatentPaths::new(&start, 2, &[1, 2]).unwrap();
        paths.append(&[vec![3.0], vec![5.0, 6.0]]);
        paths
    }

    #[test]
    fn histories_are_the_last_frames_oldest_first() {
        let mut paths = paths();
        assert_eq!((paths.frames(), &paths.history(0)[..]), (3, &[2.0, 3.0][..]));
        assert_eq!(paths.history(1)[..], [3., 4., 5., 6.]);
        assert_eq!(paths.matrices(1..3)[1], DMatrix::from_row_slice(2, 2, &[3., 4., 5., 6.]));
        (0..12).for_each(|k| paths.append(&[vec![k as f64], vec![0.0; 2]]));
        paths.forget();
        assert_eq!((paths.frames(), &paths.history(0)[..]), (9, &[10.0, 11.0][..]));
    }

    #[test]
    fn a_pushed_part_keeps_its_speed_and_the_others_their_place() {
        let mut paths = paths();
        paths.push(&Push { part: 1, by: vec![0.5, -1.0], ..Push::default() });
        assert_eq!(paths.history(1)[..], [3.5, 3.0, 5.5, 5.0]);
        assert_eq!(paths.history(0)[..], [2.0, 3.0]);
        // Earlier frames do not change.
        assert_eq!(paths.matrices(0..1)[1], DMatrix::from_row_slice(1, 2, &[1.0, 2.0]));
        // A slow part reads frames that lie further back.
        (0..6).for_each(|k| paths.append(&[vec![f64::from(k)], vec![0.0; 2]]));
        paths.set_tempo(0, 0.25);
        paths.push(&Push { part: 0, by: vec![0.5], ..Push::default() });
        assert_eq!(paths.history(0)[..], [1.5, 5.5]);
    }

    #[test]
    fn a_push_ahead_moves_by_steps_of_the_part() {
        let mut paths = paths();
        paths.push(&Push { part: 0, ahead: 1.5, ..Push::default() });
        assert_eq!(paths.history(0)[..], [3.5, 4.5]);
    }

    #[test]
    fn refuses_a_start_of_another_shape() {
        let error = LatentPaths::new(&[DMatrix::zeros(1, 1)], 2, &[1]).unwrap_err().to_string();
        assert_eq!(error, "the start latents of part 0 must be 2 x 1 numbers, found 1 x 1");
    }
}
