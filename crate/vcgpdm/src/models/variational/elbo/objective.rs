//! What the bound is computed on.

use crate::models::sequences::Sequences;
use nalgebra::DMatrix;

/// What the bound is computed on: centred observations and how they divide into sequences.
#[derive(Clone, Debug)]
pub struct Objective {
    pub(super) y: Vec<DMatrix<f64>>,
    pub(super) second_moments: Vec<f64>,
    pub(super) sequences: Sequences,
    pub(super) jitter: f64,
}

impl Objective {
    /// `y[i]` are the centred observations of part i [N x D_i]; `jitter` times its signal variance is added to the diagonal of
    /// every inducing covariance. The matrices must have as many rows as the sequences have frames.
    pub fn new(y: Vec<DMatrix<f64>>, sequences: Sequences, jitter: f64) -> Self {
        let second_moments = y.iter().map(|y| y.norm_squared()).collect();
        Self { y, second_moments, sequences, jitter }
    }

    /// The sequences.
    pub fn sequences(&self) -> &Sequences {
        &self.sequences
    }

    /// The centred observations of each part [N x D_i].
    pub fn observations(&self) -> &[DMatrix<f64>] {
        &self.y
    }

    /// The factor of the signal variance on the diagonal of every inducing covariance.
    pub fn jitter(&self) -> f64 {
        self.jitter
    }
}
