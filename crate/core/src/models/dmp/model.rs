//! Fitted dynamic movement primitives of either kind.

use crate::elementary::Elementary;
use crate::models::data::movements::split;
use crate::models::data::phase::{PhaseMap, Trial};
use crate::models::dmp::spring::{Curve, SpringStart, integrate};
use crate::models::rollout::request::{Handles, RolloutError, check_frames};
use crate::models::training::kind::ModelKind;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The canonical system for time, with its bases.
#[derive(Clone, Debug, PartialEq)]
pub enum Canonical {
    /// Towards a goal.
    Discrete {
        /// Decay rate of x: x = exp(-alpha_x t / tau), where t / tau is the phase of the trial.
        alpha_x: f64,
        /// Centres of the bases, in x `[B]`.
        centres: Vec<f64>,
        /// psi_b(x) = exp(-widths_b (x - centres_b)^2) `[B]`.
        widths: Vec<f64>,
        /// Whether the column's force is scaled by g - y(0) `[D]`.
        scaled: Vec<bool>,
    },
    /// Around a centre.
    Rhythmic {
        /// psi_b(phi) = exp(concentration (cos(phi - 2 pi b / B) - 1)).
        concentration: f64,
    },
}

impl Canonical {
    /// What is multiplied by the weights of `bases` bases at a phase `[B]`: x psi_b(x) / sum psi at t / tau, or psi_b /
    /// sum psi at a phase in cycles.
    pub fn features(&self, phase: f64, bases: usize) -> DVector<f64> {
        match self {
            Canonical::Discrete { alpha_x, centres, widths, .. } => {
                let x = (-alpha_x * phase).exponential();
                let exponents = DVector::from_fn(bases, |b, _| -widths[b] * (x - centres[b]).powi(2));
                // The largest exponent is subtracted first, so that the ratio is finite far from all centres.
                let largest = exponents.max();
                let psi = exponents.map(|e| (e - largest).exponential());
                let sum = psi.sum();
                psi * (x / sum)
            }
            Canonical::Rhythmic { concentration } => {
                let angle = |b: usize| TAU * (phase - b as f64 / bases as f64);
                let psi =
                    DVector::from_fn(bases, |b, _| (concentration * (angle(b).cosine() - 1.0)).exponential());
                let sum = psi.sum();
                psi / sum
            }
        }
    }

    /// Whether no force is known at a phase: after the end of all trials the spring alone goes to the goal.
    pub fn has_ended(&self, phase: f64) -> bool {
        matches!(self, Canonical::Discrete { .. }) && phase > 1.0
    }
}

/// Start of a sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct DmpStart {
    /// t / tau of the first frame, or its phase in cycles, and the change from frame to frame.
    pub map: PhaseMap,
    /// Amplitude r of a movement around a centre; 1 in the training trials, and for a movement towards a goal.
    pub amplitude: f64,
    /// The springs at the first frame.
    pub spring: SpringStart,
}

impl DmpStart {
    /// The start of a trial with its place in the alignment.
    pub(super) fn new((trial, map): (&Trial, &PhaseMap)) -> Self {
        Self { map: *map, amplitude: 1.0, spring: SpringStart::at_first_frame(&trial.y) }
    }
}

/// Fitted dynamic movement primitives.
#[derive(Clone, Debug, PartialEq)]
pub struct Dmp {
    /// The canonical system.
    pub canonical: Canonical,
    /// g `[D]`: the goal, which is the mean of the last frames of the whole trials, or the centre, the mean of the
    /// cycle.
    pub goal: DVector<f64>,
    /// Weights w of the basis functions [B x D].
    pub weights: DMatrix<f64>,
    /// The start of each training sequence.
    pub starts: Vec<DmpStart>,
    /// Numbers of columns D_i of the parts, in order.
    pub columns: Vec<usize>,
}

impl Dmp {
    /// The kind of model.
    pub fn kind(&self) -> ModelKind {
        match self.canonical {
            Canonical::Discrete { .. } => ModelKind::DmpDiscrete,
            Canonical::Rhythmic { .. } => ModelKind::DmpRhythmic,
        }
    }

    /// The bases at a phase, to be multiplied by the weights `[B]`.
    pub(super) fn features(&self, phase: f64) -> DVector<f64> {
        self.canonical.features(phase, self.weights.nrows())
    }

    /// The bases at the times of a curve whose trial has this place in the alignment [times x B].
    pub(super) fn features_along(&self, curve: &Curve, map: &PhaseMap) -> DMatrix<f64> {
        let phases = curve.times().into_iter().map(|t| map.start + map.rate * t);
        let rows: Vec<_> = phases.map(|phase| self.features(phase).transpose()).collect();
        DMatrix::from_rows(&rows)
    }

    /// The movement from the start of a training sequence, under `handles` of centred columns in the order of the
    /// parts: all columns, centred [frames x D]. Its speed is the mean speed of the training trials; a movement
    /// towards a goal stays there after the end of the trials.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is out of its range.
    pub fn path(
        &self,
        sequence: usize,
        frames: usize,
        handles: &Handles,
    ) -> Result<DMatrix<f64>, RolloutError> {
        check_frames(frames)?;
        let count = self.starts.len();
        let start = self.starts.get(sequence).ok_or(RolloutError::Sequence { count, found: sequence })?;
        let goal = &handles.moved(&self.goal);
        let rate = start.map.rate * handles.tempo;
        let spring = &start.spring;
        let (tau, scale) = match &self.canonical {
            Canonical::Discrete { scaled, .. } => {
                // y(0), from which the way is measured; the integration pushes it, too.
                let way = goal - &spring.position - handles.push_at(0).unwrap_or(DVector::zeros(goal.len()));
                (1.0 / rate, DVector::from_fn(goal.len(), |k, _| if scaled[k] { way[k] } else { 1.0 }))
            }
            Canonical::Rhythmic { .. } => {
                (1.0 / (TAU * rate), DVector::from_element(goal.len(), start.amplitude))
            }
        };
        let velocity = &spring.velocity * handles.tempo;
        Ok(integrate(&spring.position, &velocity, goal, tau, frames, handles, |t, out| {
            let phase = start.map.start + rate * t;
            if self.canonical.has_ended(phase) {
                return out.fill(0.0);
            }
            out.copy_from(&self.weights.tr_mul(&self.features(phase)));
            out.component_mul_assign(&scale);
        }))
    }

    /// As [`path`](Self::path): the columns of each part [frames x D_i].
    ///
    /// # Errors
    ///
    /// As [`path`](Self::path).
    pub fn rollout(
        &self,
        sequence: usize,
        frames: usize,
        handles: &Handles,
    ) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        Ok(split(&self.path(sequence, frames, handles)?, &self.columns))
    }

    /// The number of stored numbers from which one sequence can be rolled out: weights, g, y(0), y'(0), start and
    /// rate of one sequence; which columns are scaled and alpha_x, or amplitude and concentration.
    pub fn stored_numbers(&self) -> usize {
        let (of_each_column, others) = match self.canonical {
            Canonical::Discrete { .. } => (4, 3),
            Canonical::Rhythmic { .. } => (3, 4),
        };
        self.weights.len() + of_each_column * self.goal.len() + others
    }
}
