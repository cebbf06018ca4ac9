//! Temporal movement primitives (Clever et al. 2016; Endres et al. 2013), by variational Bayes.
//!
//! A movement is a weighted sum of a few functions of time, the primitives, which all columns share. Column k
//! of trial s at frame t is
//!
//! y_sk(t) = sum_q w_skq m_q(p_s(t)) + noise of variance sigma_k^2 (one for all columns of a part),
//!
//! - p_s(t) = start_s + rate_s t is the phase ([`PhaseAxis`]): of one cycle for a movement that repeats
//!   itself, of the whole movement for one that does not. Recorded walks start anywhere in the gait cycle and
//!   have their own speed; if only their lengths were normalised, steps of the left and the right leg would
//!   be averaged. Start and rate begin with an alignment to the mean of all trials
//!   ([`crate::models::Alignment`]), and then the bound is maximised over them too. The frames are modelled
//!   at their own phases, so that the bound is on log p of the same numbers as for the other models.
//! - m_q ~ GP(0, squared exponential of variance 1) over phase; one lengthscale for all; regular inducing
//!   phases, 0.7 lengthscales apart. The bound includes the variance between them.
//! - The primitives are shared, the weights belong to the trial: w_sk ~ N(mu_k, c_k V), mu_k ~ N(0, c_k
//!   diag(a)). c_k is the scale of the column, a_q the relevance of primitive q, and V [Q x Q] the covariance
//!   of the weights of a trial around the mean movement, one for all columns and trials.
//! - The model learns nothing from a partial trial, of which only the first frames are known: c, V and the
//!   noise come from whole trials. (Otherwise V grows along a combination of weights that only those frames
//!   need; the combination then has no cost, and predictions explode.) The rate of a partial trial is the
//!   mean of the whole trials, and its start maximises the posterior, with the weights integrated out. The
//!   posterior of its weights is the prediction; it is near mu_k where those frames have no information.
//!
//! With [`crate::models::TmpSettings::normalised_time`] the model is nearer to that of Clever et al. (2016): functions
//! of normalised time, and weights of the columns that all trials share, w_sk = w_k. Learned phases, cycles
//! and weights of each trial are extensions of this project.
//!
//! q = q(m) q(mu, w): Gaussians, the first over all primitives together, the second joint over mu_k and all
//! w_sk of a column. Both updates, and those of sigma, c, V and a, are maxima of the bound in closed form;
//! lengthscale, starts and rates change only where that raises the bound. So the bound never falls. The
//! number of primitives is the one with the highest bound.

mod json;
mod kernel;
mod learner;
mod partial_trial;
mod posterior;
mod run;
#[cfg(test)]
mod tests;
mod trial_features;
mod weights;

pub use learner::TmpLearner;

use crate::gp::NumericsError;
use crate::models::data::movements::split;
use crate::models::data::phase::{PhaseAxis, PhaseMap, Trial};
use crate::models::rollout::request::{Handles, RolloutError, check_frames};
use kernel::covariance;
use nalgebra::{DMatrix, DVector};
use posterior::Posterior;

/// Phases and weights of a training sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct TrialWeights {
    /// Map from its frames to phases.
    pub map: PhaseMap,
    /// `E[w_sk]` [D x Q].
    pub weights: DMatrix<f64>,
}

/// Fitted temporal movement primitives.
#[derive(Clone, Debug, PartialEq)]
pub struct Tmp {
    /// Meaning of the phase.
    pub axis: PhaseAxis,
    /// Lengthscale of the primitives, in units of phase.
    pub lengthscale: f64,
    /// The lowest and highest phase of the whole trials: 0 and 1 on a cycle.
    pub range: (f64, f64),
    /// Inducing phases z `[R]`.
    pub inducing: Vec<f64>,
    /// K_zz^-1 E[m(z)] [R x Q]: primitive q at phase p is sum_r k(p, z_r) coefficients_rq.
    pub coefficients: DMatrix<f64>,
    /// Phases and weights of each training sequence.
    pub trials: Vec<TrialWeights>,
    /// `E[mu_k]` [D x Q]: the mean movement.
    pub centre: DMatrix<f64>,
    /// c_k `[D]`.
    pub scale: DVector<f64>,
    /// V [Q x Q].
    pub spread: DMatrix<f64>,
    /// sigma_k^2 `[D]`.
    pub noise: DVector<f64>,
    /// D_i of each part, in order.
    pub columns: Vec<usize>,
    /// The bound on log p of all training frames, in nats.
    pub bound: f64,
    /// Each number of primitives with its bound, in the order tried.
    pub bounds: Vec<(usize, f64)>,
}

impl Tmp {
    /// `order` are the places in the training set of the posterior's trials.
    fn new(
        posterior: &Posterior,
        trials: &[Trial],
        order: &[usize],
        columns: &[usize],
        bounds: &[(usize, f64)],
    ) -> Result<Self, NumericsError> {
        let (d, q) = (posterior.weights.len(), posterior.primitives());
        let mut places: Vec<usize> = (0..order.len()).collect();
        places.sort_by_key(|&s| order[s]);
        Ok(Self {
            axis: posterior.kernel.axis,
            lengthscale: posterior.kernel.lengthscale,
            range: posterior.range(trials),
            inducing: posterior.kernel.inducing.clone(),
            coefficients: posterior.kernel.coefficients(&posterior.v),
            trials: (places.into_iter())
                .map(|s| TrialWeights { map: posterior.maps[s], weights: posterior.mean_weights(s) })
                .collect(),
            centre: DMatrix::from_fn(d, q, |k, q| posterior.weights[k].centre[q]),
            scale: posterior.scale.clone(),
            spread: posterior.spread.clone(),
            noise: posterior.noise.clone(),
            columns: columns.to_vec(),
            bound: posterior.bound(trials)?,
            bounds: bounds.to_vec(),
        })
    }

    /// The primitives at `phases` `[T]`: [T x Q].
    pub fn primitives(&self, phases: &[f64]) -> DMatrix<f64> {
        let cross = DMatrix::from_fn(phases.len(), self.inducing.len(), |t, r| {
            covariance(self.axis, self.lengthscale, phases[t] - self.inducing[r])
        });
        cross * &self.coefficients
    }

    /// Centred columns of each part [frames x D_i], starting as the training sequence `sequence` starts, under
    /// `handles` of centred columns in the order of the parts.
    ///
    /// The rate is that of the sequence. A movement that is not a cycle ends at the last phase of the
    /// training trials: with more frames, it is slower. A TMP has no goal, and a push is over in the next frame.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or the number of frames is 0 or too large.
    pub fn rollout(
        &self,
        sequence: usize,
        frames: usize,
        handles: &Handles,
    ) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        check_frames(frames)?;
        if handles.goal.is_some() {
            return Err(RolloutError::NoGoal);
        }
        let trial = self
            .trials
            .get(sequence)
            .ok_or(RolloutError::Sequence { count: self.trials.len(), found: sequence })?;
        let mut map = trial.map;
        if self.axis == PhaseAxis::Trial && map.at(frames - 1) > self.range.1 {
            map.rate = (self.range.1 - map.start).max(0.0) / (frames - 1) as f64;
        }
        map.rate *= handles.tempo;
        // A faster movement that is not a cycle stays at its end.
        let ends = self.axis == PhaseAxis::Trial && handles.tempo > 1.0;
        let last = if ends { self.range.1 } else { f64::INFINITY };
        let phases: Vec<f64> = (0..frames).map(|t| map.at(t).min(last)).collect();
        let mut y = self.primitives(&phases) * trial.weights.transpose();
        for (frame, mut row) in y.row_iter_mut().enumerate() {
            if let Some(by) = handles.push_at(frame) {
                row += by.transpose();
            }
        }
        Ok(split(&y, &self.columns))
    }

    /// The number of stored numbers from which one sequence can be rolled out: primitives at the inducing
    /// phases, the weights of one trial, its start and rate, lengthscale and range.
    pub fn stored_numbers(&self) -> usize {
        let weights = self.centre.len();
        self.coefficients.len() + weights + 2 + 1 + if self.axis == PhaseAxis::Trial { 2 } else { 0 }
    }
}
