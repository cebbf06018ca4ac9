//! Learning temporal movement primitives, sweep by sweep, and their number.

use crate::gp::NumericsError;
use crate::models::learner::Learner;
use crate::models::model::Model;
use crate::models::movements::Movements;
use crate::models::phase::{Alignment, Trial};
use crate::models::progress::{EndReason, LearningProgress};
use crate::models::settings::TmpSettings;
use crate::models::tmp::Tmp;
use crate::models::tmp::posterior::Posterior;
use crate::models::training_error::{TrainingError, in_range};
use crate::models::trials::split_trials;

/// More would only be slow.
const MOST_PRIMITIVES: usize = 40;
/// So many sweeps pass between two looks at lengthscale and phases.
const EVERY: usize = 5;
/// A number of primitives is done when [`EVERY`] sweeps have together gained less than this part of the bound.
const SMALL_GAIN: f64 = 2e-6;
/// The search for the number ends when so many in a row were worse than the best.
const WORSE_IN_A_ROW: usize = 2;
/// Places along the axis where a trial of which only the first frames are known is looked for.
const PLACES: usize = 32;
/// First step of the phases and factor of the lengthscale; both shrink.
const PHASE_STEP: f64 = 1.0 / 64.0;
const LENGTHSCALE_FACTOR: f64 = 1.4;

/// How far the learning goes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Where the search for the number of primitives ends at the latest.
    pub most_primitives: usize,
    /// Sweeps over all updates for each number of primitives, at most.
    pub max_sweeps: usize,
}

/// The limits of every training; tests have smaller ones.
const LIMITS: Limits = Limits { most_primitives: 12, max_sweeps: 150 };

/// A training of temporal movement primitives.
pub struct TmpLearner {
    trials: Vec<Trial>,
    columns: Vec<usize>,
    groups: Vec<usize>,
    alignment: Alignment,
    /// The number of primitives asked for; absent: chosen by the bound.
    asked: Option<usize>,
    limits: Limits,
    /// The number of primitives that is being tried.
    count: usize,
    current: Posterior,
    bound: f64,
    sweeps: usize,
    /// The bound [`EVERY`] sweeps ago.
    before: f64,
    relocated: bool,
    phase_step: f64,
    lengthscale_factor: f64,
    best: Option<(f64, Posterior)>,
    bounds: Vec<(usize, f64)>,
    iteration: usize,
    reason: Option<EndReason>,
}

impl TmpLearner {
    /// Aligns the trials and starts with the smallest number of primitives.
    ///
    /// # Errors
    ///
    /// When the number of primitives is out of its range, or the movements cannot be learned from.
    pub fn new(movements: &Movements, settings: &TmpSettings) -> Result<Self, TrainingError> {
        Self::within(movements, settings, LIMITS)
    }

    pub(super) fn within(
        movements: &Movements,
        settings: &TmpSettings,
        limits: Limits,
    ) -> Result<Self, TrainingError> {
        let asked = settings.primitives;
        in_range("the number of primitives", asked.unwrap_or(1), MOST_PRIMITIVES)?;
        let (trials, columns) = split_trials(movements)?;
        let alignment = Alignment::new(&trials, None);
        let count = asked.unwrap_or(1);
        // A part has one noise variance, like beta of the vCGPDM: only then are the bounds of both on the same footing, because
        // the bound of a column that hardly moves would otherwise grow without limit.
        let groups: Vec<usize> = columns.iter().copied().filter(|&width| width > 0).collect();
        let current = Posterior::start(&trials, &alignment, &groups, count)?;
        let bound = current.bound(&trials)?;
        Ok(Self {
            trials,
            columns,
            groups,
            alignment,
            asked,
            limits,
            count,
            current,
            bound,
            sweeps: 0,
            before: bound,
            relocated: false,
            phase_step: PHASE_STEP,
            lengthscale_factor: LENGTHSCALE_FACTOR,
            best: None,
            bounds: Vec::new(),
            iteration: 0,
            reason: None,
        })
    }

    /// All updates once; the bound after them.
    fn sweep(&mut self) -> Result<f64, NumericsError> {
        let (current, trials) = (&mut self.current, &self.trials);
        current.update_primitives()?;
        current.update_weights()?;
        current.update_hyperparameters(trials)?;
        if self.sweeps % EVERY == EVERY - 1 {
            if !current.update_lengthscale(trials, self.lengthscale_factor)? {
                self.lengthscale_factor = self.lengthscale_factor.sqrt();
            }
            current.update_phases(trials, self.phase_step);
            self.phase_step = (self.phase_step * 0.7).max(1e-4);
        }
        self.sweeps += 1;
        current.bound(trials)
    }

    /// One sweep, and what follows when this number of primitives is done.
    fn advance(&mut self) -> Result<(), NumericsError> {
        self.bound = self.sweep()?;
        let look = self.sweeps.is_multiple_of(EVERY);
        let small = look && self.bound - self.before < SMALL_GAIN * self.bound.abs();
        if look {
            self.before = self.bound;
        }
        // Late enough for the primitives to be about right, early enough for them to follow.
        let late = 2 * self.sweeps > self.limits.max_sweeps;
        if !self.relocated && (small || late) && self.sweeps < self.limits.max_sweeps {
            self.current.relocate(&self.trials, PLACES)?;
            self.bound = self.current.bound(&self.trials)?;
            (self.relocated, self.before) = (true, f64::NEG_INFINITY);
            return Ok(());
        }
        if self.sweeps < self.limits.max_sweeps && !small {
            return Ok(());
        }
        self.bounds.push((self.count, self.bound));
        if self.best.as_ref().is_none_or(|(best, _)| self.bound > *best) {
            self.best = Some((self.bound, self.current.clone()));
        }
        let best = self.best.as_ref().map_or(self.count, |(_, p)| p.primitives());
        if self.asked.is_some() {
            self.reason = Some(EndReason::BoundSettled);
        } else if self.count >= best + WORSE_IN_A_ROW {
            self.reason = Some(EndReason::MorePrimitivesAreWorse { best });
        } else if self.count >= self.limits.most_primitives {
            self.reason = Some(EndReason::MostPrimitives { best });
        } else {
            self.count += 1;
            self.current = Posterior::start(&self.trials, &self.alignment, &self.groups, self.count)?;
            self.bound = self.current.bound(&self.trials)?;
            (self.sweeps, self.before, self.relocated) = (0, self.bound, false);
            (self.phase_step, self.lengthscale_factor) = (PHASE_STEP, LENGTHSCALE_FACTOR);
        }
        Ok(())
    }
}

impl Learner for TmpLearner {
    fn step(&mut self) -> LearningProgress {
        if self.reason.is_none() {
            self.iteration += 1;
            if let Err(error) = self.advance() {
                self.reason = Some(EndReason::Failed { primitives: Some(self.count), error });
            }
        }
        self.progress()
    }

    fn progress(&self) -> LearningProgress {
        let counts = if self.asked.is_some() { 1 } else { self.limits.most_primitives };
        let best = self.best.as_ref().map_or(f64::NEG_INFINITY, |(best, _)| *best).max(self.bound);
        let within = self.sweeps as f64 / self.limits.max_sweeps as f64;
        let share = (self.bounds.len() as f64 + within.min(1.0)) / counts as f64;
        let done = self.reason.is_some();
        LearningProgress {
            iteration: self.iteration,
            max_iterations: counts * self.limits.max_sweeps,
            evaluations: 0,
            objective: self.bound,
            best,
            phase: None,
            done,
            reason: self.reason.clone(),
            fraction: if done { 1.0 } else { share.min(1.0) },
        }
    }

    fn model(&self) -> Result<Model, NumericsError> {
        Ok(Model::Tmp(Box::new(self.fitted()?)))
    }
}

impl TmpLearner {
    /// The best model so far, with all that is known of it.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn fitted(&self) -> Result<Tmp, NumericsError> {
        let best = match &self.best {
            Some((bound, posterior)) if *bound >= self.bound => posterior,
            _ => &self.current,
        };
        Tmp::new(best, &self.trials, &self.columns, &self.bounds)
    }
}
