//! The data of the bound.

use crate::gp::outputs::Outputs;
use crate::gp::stored_outputs::StoredOutputs;
use crate::models::data::sequences::Sequences;
use crate::models::variational::repertoire::Repertoire;
use nalgebra::DMatrix;

/// Stored inducing outputs of maps, for a bound in which they are fixed.
#[derive(Clone, Debug)]
pub struct StoredMaps {
    /// v of each part's pose map `[M]`.
    pub kinematics: Vec<StoredOutputs>,
    /// u into each part, the experts of the first primitives stacked in order `[M]`; those of the other
    /// primitives are not stored.
    pub dynamics: Vec<StoredOutputs>,
}

/// The data of the bound: centred observations, and their division into sequences and movements.
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
    /// to the diagonal of every inducing covariance. The matrices must have one row for each frame
    /// of the sequences.
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

    /// The bound under fixed `stored` inducing outputs: that of new movements of stored primitives, of which
    /// only latents and couplings are learned. Primitives that are not stored are learned too.
    pub fn under(self, stored: StoredMaps) -> Self {
        Self { stored: Some(stored), ..self }
    }

    /// Memory for the bound of one map with (points, columns) inducing outputs: stored or optimal ones.
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
