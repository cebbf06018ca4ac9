//! What the bound is computed on.

use crate::gp::outputs::Outputs;
use crate::gp::stored_outputs::StoredOutputs;
use crate::models::data::sequences::Sequences;
use crate::models::variational::repertoire::Repertoire;
use nalgebra::DMatrix;

/// The inducing outputs of maps as they were learned before, for a bound in which they stay so.
#[derive(Clone, Debug)]
pub struct StoredMaps {
    /// v of each part's pose map `[M]`.
    pub kinematics: Vec<StoredOutputs>,
    /// u into each part, the experts of the first primitives stacked in order `[M]`; those of primitives
    /// after them are not stored.
    pub dynamics: Vec<StoredOutputs>,
}

/// What the bound is computed on: centred observations, and how they divide into sequences and movements.
#[derive(Clone, Debug)]
pub struct Objective {
    pub(super) y: Vec<DMatrix<f64>>,
    pub(super) second_moments: Vec<f64>,
    pub(super) repertoire: Repertoire,
    pub(super) jitter: f64,
    stored: Option<StoredMaps>,
}

impl Objective {
    /// `y[i]` are the centred observations of part i [N x D_i]; `jitter` times its signal variance is added
    /// to the diagonal of every inducing covariance. The matrices must have as many rows as the sequences
    /// have frames.
    pub fn new(y: Vec<DMatrix<f64>>, sequences: Sequences, jitter: f64) -> Self {
        let repertoire = Repertoire::plain(sequences, y.len());
        Self::of_movements(y, repertoire, jitter)
    }

    /// As [`new`](Self::new), for movements that may share primitives; their frames are stacked movement
    /// after movement.
    pub fn of_movements(y: Vec<DMatrix<f64>>, repertoire: Repertoire, jitter: f64) -> Self {
        let second_moments = y.iter().map(|y| y.norm_squared()).collect();
        Self { y, second_moments, repertoire, jitter, stored: None }
    }

    /// The same for maps whose inducing outputs are stored and stay as they are: the bound of new movements,
    /// of which only latents and couplings are to be learned, and new primitives where there are more than
    /// those that are stored.
    pub fn under(self, stored: StoredMaps) -> Self {
        Self { stored: Some(stored), ..self }
    }

    /// Room for the bound of one map with (points, columns) inducing outputs: the best ones, or those that
    /// are stored.
    pub(super) fn outputs<'a>(
        &'a self,
        which: impl Fn(&'a StoredMaps) -> &'a StoredOutputs,
        (points, columns): (usize, usize),
    ) -> Outputs {
        Outputs::new(self.stored.as_ref().map(which), points, columns)
    }

    /// The sequences of all movements.
    pub fn sequences(&self) -> &Sequences {
        self.repertoire.sequences()
    }

    /// The movements, and which primitives they use.
    pub fn repertoire(&self) -> &Repertoire {
        &self.repertoire
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
