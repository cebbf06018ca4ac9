//! The data of the bound.

use crate::gp::outputs::Outputs;
use crate::gp::stored_outputs::StoredOutputs;
use crate::models::data::sequences::Sequences;
use crate::models::training::pose_weight::PoseWeight;
use crate::models::training::progress::BoundTerms;
use crate::models::variational::params::Params;
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

/// The data of the bound: centred observations, and their division into sequences and movements. With them
/// the weight of the pose terms, which changes [`value`](Self::value) and the gradient, but no term.
#[derive(Clone, Debug)]
pub struct Objective {
    pub(super) y: Vec<DMatrix<f64>>,
    pub(super) second_moments: Vec<f64>,
    pub(super) repertoire: Repertoire,
    pub(super) jitter: f64,
    stored: Option<StoredMaps>,
    pose_weight: PoseWeight,
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
        Self { y, second_moments, repertoire, jitter, stored: None, pose_weight: PoseWeight::default() }
    }

    /// The bound under fixed `stored` inducing outputs: that of new movements of stored primitives, of which
    /// only latents and couplings are learned. Primitives that are not stored are learned too.
    pub fn under(self, stored: StoredMaps) -> Self {
        Self { stored: Some(stored), ..self }
    }

    /// The objective with this weight of the pose terms.
    pub fn weighted(self, pose_weight: PoseWeight) -> Self {
        Self { pose_weight, ..self }
    }

    /// The weight of the pose terms.
    pub fn pose_weight(&self) -> PoseWeight {
        self.pose_weight
    }

    /// The factor gamma_i of the pose term of part i.
    pub(super) fn pose_factor(&self, params: &Params, i: usize) -> f64 {
        self.pose_weight.factor(params.parts[i].r.ncols(), self.y[i].ncols())
    }

    /// The objective F_gamma of these terms of the bound: see [`PoseWeight`]. The terms are of parameters
    /// with the shapes of `params`.
    pub fn value(&self, params: &Params, terms: &BoundTerms) -> f64 {
        let BoundTerms { kinematics, dynamics, initial, entropy } = terms;
        let poses = kinematics.iter().enumerate().map(|(i, term)| self.pose_factor(params, i) * term);
        poses.sum::<f64>() + dynamics.iter().sum::<f64>() + initial + entropy
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
