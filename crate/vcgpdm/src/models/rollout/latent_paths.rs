//! Latent paths of a rollout so far, in the layout that the dynamics read.

use crate::models::rollout::request::{Push, RolloutError};
use nalgebra::DMatrix;
use std::ops::Range;

/// The latent paths of all parts so far. There are always at least p frames: the start of the rollout.
#[derive(Clone, Debug)]
pub(crate) struct LatentPaths {
    order: usize,
    latent: Vec<usize>,
    /// The paths [frames x Q_i], one frame after the other, so that a history is a slice.
    paths: Vec<Vec<f64>>,
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
        Ok(Self { order, latent: latent.to_vec(), paths })
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

    /// The last p frames of a part, oldest first [p Q_i].
    pub(crate) fn history(&self, part: usize) -> &[f64] {
        self.history_until(part, self.frames())
    }

    /// The last p of the first `end` frames of a part, oldest first [p Q_i].
    pub(crate) fn history_until(&self, part: usize, end: usize) -> &[f64] {
        let q = self.latent[part];
        &self.paths[part][(end - self.order) * q..end * q]
    }

    /// Appends a frame: the latents `[Q_i]` of each part.
    pub(crate) fn append(&mut self, next: &[Vec<f64>]) {
        for (path, next) in self.paths.iter_mut().zip(next) {
            path.extend_from_slice(next);
        }
    }

    /// Appends the frames of longer paths of these parts that are missing here.
    pub(crate) fn follow(&mut self, others: &LatentPaths) {
        for (path, other) in self.paths.iter_mut().zip(&others.paths) {
            path.extend_from_slice(&other[path.len()..]);
        }
    }

    /// Pushes a part: its last p frames move together. The push must fit the part.
    pub(crate) fn push(&mut self, push: &Push) {
        let (path, q) = (&mut self.paths[push.part], self.latent[push.part]);
        let newest = path.len() - q;
        let step =
            |k: usize| path[newest + k] - newest.checked_sub(q).map_or(path[k], |before| path[before + k]);
        let displacement = |k: usize| push.by.get(k).unwrap_or(&0.0) + push.ahead * step(k);
        let by: Vec<f64> = (0..q).map(displacement).collect();
        for frame in path[newest + q - self.order * q..].chunks_exact_mut(q) {
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

    /// Drops the newest frame.
    pub(crate) fn drop_newest(&mut self) {
        for (path, q) in self.paths.iter_mut().zip(&self.latent) {
            path.truncate(path.len() - q);
        }
    }

    /// Drops all but the last frames that a prediction, a push or a drive needs.
    pub(crate) fn forget(&mut self) {
        for (path, q) in self.paths.iter_mut().zip(&self.latent) {
            path.drain(..path.len().saturating_sub(self.order.max(2) * q));
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
        assert_eq!(
            (paths.frames(), paths.history(0), paths.history(1)),
            (3, &[2.0, 3.0][..], &[3., 4., 5., 6.][..])
        );
        assert_eq!(paths.matrices(1..3)[1], DMatrix::from_row_slice(2, 2, &[3., 4., 5., 6.]));
        paths.forget();
        assert_eq!((paths.frames(), paths.history(0)), (2, &[2.0, 3.0][..]));
    }

    #[test]
    fn a_pushed_part_keeps_its_speed_and_the_others_their_place() {
        let mut paths = paths();
        paths.push(&Push { part: 1, by: vec![0.5, -1.0], ..Push::default() });
        assert_eq!(paths.history(1), &[3.5, 3.0, 5.5, 5.0]);
        assert_eq!(paths.history(0), &[2.0, 3.0]);
        // Earlier frames do not change.
        assert_eq!(paths.matrices(0..1)[1], DMatrix::from_row_slice(1, 2, &[1.0, 2.0]));
    }

    #[test]
    fn a_push_ahead_moves_by_steps_of_the_part() {
        let mut paths = paths();
        paths.push(&Push { part: 0, ahead: 1.5, ..Push::default() });
        assert_eq!(paths.history(0), &[3.5, 4.5]);
    }

    #[test]
    fn refuses_a_start_of_another_shape() {
        let error = LatentPaths::new(&[DMatrix::zeros(1, 1)], 2, &[1]).unwrap_err().to_string();
        assert_eq!(error, "the start latents of part 0 must be 2 x 1 numbers, found 1 x 1");
    }
}
