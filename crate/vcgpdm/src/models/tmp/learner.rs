//! Trainings of temporal movement primitives, sweep by sweep, with a search for their number.

use crate::gp::NumericsError;
use crate::gp::linalg::counting_jittered;
use crate::models::data::movements::Movements;
use crate::models::data::movements::split_trials;
use crate::models::data::phase::{Alignment, PhaseMap, Trial};
use crate::models::fitted::fitted_model::FittedModel;
use crate::models::tmp::Tmp;
use crate::models::tmp::partial_trial::PartialTrial;
use crate::models::tmp::posterior::Posterior;
use crate::models::training::error::{TrainingError, in_range};
use crate::models::training::learner::Learner;
use crate::models::training::progress::{EndReason, Progress, Setbacks};
use crate::models::training::settings::{MOST_PRIMITIVES, TmpSettings};

/// Number of sweeps between two updates of lengthscale and phases.
const EVERY: usize = 5;
/// The sweeps of a number of primitives end when [`EVERY`] of them raise the bound by less than this share.
const SMALL_GAIN: f64 = 5e-6;
/// The same share, and the most sweeps, during the search for the number of primitives. Each number starts
/// from the result of the number before and so needs few sweeps.
const SEARCH_GAIN: f64 = 5e-5;
const SEARCH_SWEEPS: usize = 30;
/// More primitives are better only when they raise the bound by this many nats, a Bayes factor of 150.
/// Without this limit, an unused primitive could win, because the bound rises a little with every sweep.
const DECISIVE: f64 = 5.0;
/// From this number of primitives on, only every second number is tried: one more hardly changes the bound.
const MANY: usize = 10;
/// When this many numbers in a row are worse than the best, the search tries again from the best with more
/// freedom ([`Posterior::freed`]); then it ends.
const WORSE_IN_A_ROW: usize = 2;
/// The first step of the phases and the first factor of the lengthscale; both shrink.
const PHASE_STEP: f64 = 1.0 / 64.0;
const LENGTHSCALE_FACTOR: f64 = 1.4;

/// Limits of a training.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// The most primitives of the search.
    pub most_primitives: usize,
    /// The most sweeps for each number of primitives.
    pub max_sweeps: usize,
}

/// The limits of a training outside tests.
const LIMITS: Limits = Limits { most_primitives: 20, max_sweeps: 150 };

/// A training of temporal movement primitives.
pub struct TmpLearner {
    /// The whole trials, from which the model learns.
    trials: Vec<Trial>,
    /// The partial trials.
    partial: Vec<Trial>,
    /// The places in the training set of the whole trials, then of the partial ones.
    order: Vec<usize>,
    columns: Vec<usize>,
    /// Whether phases are learned; false: they are normalised time, and all trials have the same weights.
    learns_phases: bool,
    /// The requested number of primitives; `None`: the number with the highest bound.
    requested: Option<usize>,
    limits: Limits,
    /// The current number of primitives.
    count: usize,
    current: Posterior,
    bound: f64,
    sweeps: usize,
    /// The bound [`EVERY`] sweeps ago.
    before: f64,
    phase_step: f64,
    lengthscale_factor: f64,
    best: Option<(f64, Posterior)>,
    setbacks: Setbacks,
    bounds: Vec<(usize, f64)>,
    /// The numbers of primitives in a row that were worse than the best.
    worse_in_a_row: usize,
    /// Whether each new primitive has more freedom.
    freed: bool,
    iteration: usize,
    /// Why the search for the number ended, while the best number is trained to the end.
    end: Option<EndReason>,
    reason: Option<EndReason>,
}

impl TmpLearner {
    /// A training before its first sweep, with aligned trials and one primitive or the requested number.
    ///
    /// # Errors
    ///
    /// When the number of primitives is out of its range, or the model cannot learn from the movements.
    pub fn new(movements: &Movements, settings: &TmpSettings) -> Result<Self, TrainingError> {
        Self::within(movements, settings, LIMITS)
    }

    pub(super) fn within(
        movements: &Movements,
        settings: &TmpSettings,
        limits: Limits,
    ) -> Result<Self, TrainingError> {
        let requested = settings.primitives;
        in_range("the number of primitives", requested.unwrap_or(1), MOST_PRIMITIVES)?;
        let (all, columns) = split_trials(movements)?;
        let mut order: Vec<usize> = (0..all.len()).collect();
        order.sort_by_key(|&s| !all[s].whole);
        let (trials, partial): (Vec<Trial>, Vec<Trial>) = all.into_iter().partition(|trial| trial.whole);
        let learns_phases = !settings.normalised_time;
        let alignment =
            if learns_phases { Alignment::new(&trials, None) } else { Alignment::normalised_time(&trials) };
        let count = requested.unwrap_or(1);
        // A part has one noise variance, like beta of the vCGPDM. With a variance for each column, the bound
        // of a column that hardly moves would grow without limit, and the bounds could not be compared.
        let groups: Vec<usize> = columns.iter().copied().filter(|&width| width > 0).collect();
        let current = Posterior::start(&trials, &alignment, &groups, count, settings.normalised_time)?;
        let bound = current.bound(&trials)?;
        Ok(Self {
            trials,
            partial,
            order,
            columns,
            learns_phases,
            requested,
            limits,
            count,
            current,
            bound,
            sweeps: 0,
            before: bound,
            phase_step: PHASE_STEP,
            lengthscale_factor: LENGTHSCALE_FACTOR,
            best: None,
            bounds: Vec::new(),
            worse_in_a_row: 0,
            freed: false,
            iteration: 0,
            end: None,
            setbacks: Setbacks::default(),
            reason: None,
        })
    }

    /// Does all updates once and returns the bound.
    fn sweep(&mut self) -> Result<f64, NumericsError> {
        let (current, trials) = (&mut self.current, &self.trials);
        current.update_primitives()?;
        current.update_weights()?;
        current.update_hyperparameters(trials)?;
        if self.sweeps % EVERY == EVERY - 1 {
            if !current.update_lengthscale(trials, self.lengthscale_factor)? {
                self.lengthscale_factor = self.lengthscale_factor.sqrt();
            }
            if self.learns_phases {
                current.update_phases(trials, self.phase_step);
            }
            self.phase_step = (self.phase_step * 0.7).max(1e-4);
        }
        self.sweeps += 1;
        current.bound(trials)
    }

    /// One sweep; when the sweeps of a number of primitives end, the change to the next number.
    fn advance(&mut self) -> Result<(), NumericsError> {
        self.bound = self.sweep()?;
        let compare = self.sweeps.is_multiple_of(EVERY);
        let gain = if self.is_searching() { SEARCH_GAIN } else { SMALL_GAIN };
        let small = compare && self.bound - self.before < gain * self.bound.abs();
        if compare {
            self.before = self.bound;
        }
        let most = if self.is_searching() { SEARCH_SWEEPS } else { self.limits.max_sweeps };
        if self.sweeps < most && !small {
            return Ok(());
        }
        self.record_bound();
        let best = self.best.as_ref().map_or(self.count, |(_, p)| p.primitives());
        if self.requested.is_some() {
            self.reason = Some(if small { EndReason::BoundSettled } else { EndReason::Iterations });
        } else if let Some(end) = self.end.take() {
            self.reason = Some(end);
        } else if self.worse_in_a_row >= WORSE_IN_A_ROW {
            if self.freed {
                self.train_best(EndReason::MorePrimitivesAreWorse { best });
            } else {
                (self.freed, self.worse_in_a_row) = (true, 0);
                self.return_to_best();
                self.grow()?;
            }
        } else if self.count >= self.limits.most_primitives {
            self.train_best(EndReason::MostPrimitives { best });
        } else {
            self.grow()?;
        }
        Ok(())
    }

    /// Changes to the next number of primitives.
    fn grow(&mut self) -> Result<(), NumericsError> {
        if self.freed {
            self.current = self.current.freed(&self.trials)?;
        }
        let more = if self.count < MANY { 1 } else { 2.min(self.limits.most_primitives - self.count) };
        for _ in 0..more {
            self.count += 1;
            self.current = self.current.with_one_more(&self.trials)?;
        }
        self.bound = self.current.bound(&self.trials)?;
        self.restart_sweeps();
        Ok(())
    }

    /// The most numbers of primitives to try.
    fn numbers_to_try(&self) -> usize {
        let most = self.limits.most_primitives;
        most.min(MANY) + most.saturating_sub(MANY).div_ceil(2) + WORSE_IN_A_ROW
    }

    /// Whether the search for the number of primitives goes on. After it, the best number is trained to the
    /// end.
    fn is_searching(&self) -> bool {
        self.requested.is_none() && self.end.is_none()
    }

    /// Resets the sweeps, and the steps that shrink in them.
    fn restart_sweeps(&mut self) {
        (self.sweeps, self.before) = (0, self.bound);
        (self.phase_step, self.lengthscale_factor) = (PHASE_STEP, LENGTHSCALE_FACTOR);
    }

    /// Whether the current posterior is better than the best before.
    fn is_best(&self) -> bool {
        self.best.as_ref().is_none_or(|(bound, posterior)| {
            self.bound > bound + if posterior.primitives() < self.count { DECISIVE } else { 0.0 }
        })
    }

    /// Records the bound of the current number of primitives, and the posterior if it is the best.
    fn record_bound(&mut self) {
        match self.bounds.iter_mut().find(|(count, _)| *count == self.count) {
            Some((_, bound)) => *bound = self.bound.max(*bound),
            None => self.bounds.push((self.count, self.bound)),
        }
        self.worse_in_a_row += 1;
        if self.is_best() {
            self.best = Some((self.bound, self.current.clone()));
            self.worse_in_a_row = 0;
        }
    }

    /// Makes the best posterior the current one.
    fn return_to_best(&mut self) {
        if let Some((bound, posterior)) = &self.best {
            (self.count, self.bound, self.current) = (posterior.primitives(), *bound, posterior.clone());
        }
    }

    /// Continues with the best number of primitives; `end` is the reason at the end.
    fn train_best(&mut self, end: EndReason) {
        self.return_to_best();
        self.end = Some(end);
        self.restart_sweeps();
    }
}

impl Learner for TmpLearner {
    fn step(&mut self) -> Progress {
        if self.reason.is_none() {
            self.iteration += 1;
            let (advanced, jittered) = counting_jittered(|| self.advance());
            self.setbacks.jittered += jittered;
            if let Err(error) = advanced {
                self.reason = Some(EndReason::Failed { primitives: Some(self.count), error });
            }
        }
        self.progress()
    }

    fn progress(&self) -> Progress {
        let most = if self.requested.is_some() { 0 } else { self.numbers_to_try() * SEARCH_SWEEPS };
        let most = most + self.limits.max_sweeps;
        let best = match &self.best {
            Some((best, _)) if !self.is_best() => *best,
            _ => self.bound,
        };
        let share = self.iteration as f64 / most as f64;
        let done = self.reason.is_some();
        Progress {
            iteration: self.iteration,
            max_iterations: most,
            evaluations: 0,
            setbacks: self.setbacks,
            objective: self.bound,
            best,
            terms: None,
            phase: None,
            done,
            reason: self.reason.clone(),
            fraction: if done { 1.0 } else { share.min(0.99) },
        }
    }

    fn model(&self) -> Result<FittedModel, NumericsError> {
        Ok(FittedModel::Tmp(Box::new(self.fitted()?)))
    }
}

impl TmpLearner {
    /// The best model so far.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub fn fitted(&self) -> Result<Tmp, NumericsError> {
        let best = match &self.best {
            Some((_, posterior)) if !self.is_best() => posterior,
            _ => &self.current,
        };
        let mut posterior = best.clone();
        let mut trials = self.trials.clone();
        let mut log_determinant = 0.0;
        for trial in &self.partial {
            let trial = PartialTrial::new(best, &self.trials, trial)?;
            let map = if self.learns_phases {
                trial.best_map()?
            } else {
                PhaseMap { start: 0.0, rate: Alignment::mean_rate(&self.trials, &best.maps) }
            };
            posterior.include(trial.features(&map), map)?;
            trials.push(trial.whitened().clone());
            log_determinant += trial.log_determinant();
        }
        let mut model = Tmp::new(&posterior, &trials, &self.order, &self.columns, &self.bounds)?;
        model.bound -= log_determinant;
        Ok(model)
    }
}
