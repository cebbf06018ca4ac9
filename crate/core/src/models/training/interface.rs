//! What the trainings of all kinds of models have in common.

use crate::models::training::progress::Progress;
use nalgebra::DMatrix;

/// A training of one kind of model. The caller loops and may stop after any iteration; the best model so far
/// is kept.
pub trait Training {
    /// One iteration. After the end it does nothing.
    fn step(&mut self) -> Progress;

    /// Uses `threads` threads from now on, where the kind of model can. The result is the same to the last
    /// bit.
    #[cfg(feature = "threads")]
    fn use_threads(&mut self, _threads: usize) {}

    /// Settings that are more than the data allow and were reduced, as sentences without a full stop.
    fn notices(&self) -> &[String] {
        &[]
    }

    /// Allows `iterations` more, if the kind of model can.
    fn extend(&mut self, _iterations: usize) {}

    /// Latent means of a part at the best so far [N x Q_i]; `None` for a kind of model without latents.
    fn latents(&self, _part: usize) -> Option<DMatrix<f64>> {
        None
    }

    /// How far the training is.
    fn progress(&self) -> Progress;
}
