//! The sweeps from one start of a number of primitives.

use crate::gp::NumericsError;
use crate::models::data::phase::Trial;
use crate::models::tmp::posterior::Posterior;

/// Number of sweeps between two updates of lengthscale and phases.
const EVERY: usize = 5;
/// The first step of the phases and the first factor of the lengthscale; both shrink.
const PHASE_STEP: f64 = 1.0 / 64.0;
const LENGTHSCALE_FACTOR: f64 = 1.4;

/// A posterior and the state of its sweeps.
#[derive(Clone)]
pub(super) struct Run {
    pub posterior: Posterior,
    pub bound: f64,
    pub sweeps: usize,
    /// The bound [`EVERY`] sweeps ago.
    before: f64,
    phase_step: f64,
    lengthscale_factor: f64,
}

impl Run {
    /// A run before its first sweep.
    pub fn new(posterior: Posterior, trials: &[Trial]) -> Result<Self, NumericsError> {
        let bound = posterior.bound(trials)?;
        Ok(Self {
            posterior,
            bound,
            sweeps: 0,
            before: bound,
            phase_step: PHASE_STEP,
            lengthscale_factor: LENGTHSCALE_FACTOR,
        })
    }

    /// Does all updates once. Returns whether the last [`EVERY`] sweeps raised the bound by less than the share
    /// `gain`.
    pub fn sweep(&mut self, trials: &[Trial], learns_phases: bool, gain: f64) -> Result<bool, NumericsError> {
        let posterior = &mut self.posterior;
        posterior.update_primitives()?;
        posterior.update_weights()?;
        posterior.update_hyperparameters(trials)?;
        if self.sweeps % EVERY == EVERY - 1 {
            if !posterior.update_lengthscale(trials, self.lengthscale_factor)? {
                self.lengthscale_factor = self.lengthscale_factor.sqrt();
            }
            if learns_phases {
                posterior.update_phases(trials, self.phase_step);
            }
            self.phase_step = (self.phase_step * 0.7).max(1e-4);
        }
        self.sweeps += 1;
        self.bound = posterior.bound(trials)?;
        if !self.sweeps.is_multiple_of(EVERY) {
            return Ok(false);
        }
        let is_small = self.bound - self.before < gain * self.bound.abs();
        self.before = self.bound;
        Ok(is_small)
    }
}
