//! Trainings of temporal movement primitives, sweep by sweep, with a search for their number.

use crate::gp::NumericsError;
use crate::gp::linalg::counting_jittered;
use crate::models::data::movements::Movements;
use crate::models::data::movements::split_trials;
use crate::models::data::phase::{Alignment, PhaseMap, Trial};
use crate::models::errors::{TrainingError, in_range};
use crate::models::search::Setbacks;
use crate::models::tmp::Tmp;
use crate::models::tmp::partial_trial::PartialTrial;
use crate::models::tmp::posterior::Posterior;
use crate::models::tmp::run::Run;
use crate::models::training::interface::Training;
use crate::models::training::progress::{EndReason, Progress};
use crate::models::training::settings::{MOST_PRIMITIVES, TmpSettings};

/// The sweeps of a number of primitives end when [`EVERY`] of them raise the bound by less than this share.
const SMALL_GAIN: f64 = 5e-6;
/// The same share, and the most sweeps, during the search for the number of primitives.
const SEARCH_GAIN: f64 = 5e-5;
const SEARCH_SWEEPS: usize = 30;
/// More primitives are better only when they raise the bound by this many nats, a Bayes factor of 150.
/// Without this limit, an unused primitive could win, because the bound rises a little with every sweep.
const DECISIVE: f64 = 5.0;
/// From this number of primitives on, only every second number is tried: one more hardly changes the bound.
const MANY: usize = 10;
/// The search ends when this many numbers in a row are worse than the best.
const WORSE_IN_A_ROW: usize = 2;
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
    alignment: Alignment,
    /// The numbers of neighbouring columns that share their noise.
    groups: Vec<usize>,
    /// The requested number of primitives; `None`: the number with the highest bound.
    requested: Option<usize>,
    limits: Limits,
    current: Run,
    best: Option<Run>,
    setbacks: Setbacks,
    bounds: Vec<(usize, f64)>,
    /// The numbers of primitives in a row that were worse than the best.
    worse_in_a_row: usize,
    /// Whether a start of the current number was the best so far.
    is_number_best: bool,
    /// The run from the number before, while the current number has its second start.
    grown: Option<Run>,
    /// The second start of the best number. It is trained to the end too, so that the best bound is at least that
    /// of a training with this number alone.
    second: Option<Run>,
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
        let current = Run::new(current, &trials)?;
        Ok(Self {
            trials,
            partial,
            order,
            columns,
            learns_phases,
            alignment,
            groups,
            requested,
            limits,
            current,
            best: None,
            bounds: Vec::new(),
            worse_in_a_row: 0,
            is_number_best: false,
            grown: None,
            second: None,
            iteration: 0,
            end: None,
            setbacks: Setbacks::default(),
            reason: None,
        })
    }

    /// One sweep; when the sweeps of a run end, the change to the next run.
    fn advance(&mut self) -> Result<(), NumericsError> {
        let is_searching = self.is_searching();
        let gain = if is_searching { SEARCH_GAIN } else { SMALL_GAIN };
        let small = self.current.sweep(&self.trials, self.learns_phases, gain)?;
        let most = if is_searching { SEARCH_SWEEPS } else { self.limits.max_sweeps };
        if self.current.sweeps < most && !small {
            return Ok(());
        }
        self.record_bound();
        if self.requested.is_some() {
            self.reason = Some(if small { EndReason::BoundSettled } else { EndReason::Iterations });
        } else if self.end.is_some() {
            match self.second.take() {
                Some(second) => self.current = second,
                None => self.reason = self.end.take(),
            }
        } else if self.grown.is_none() && self.count() > 1 {
            self.start_again()?;
        } else {
            self.end_number()?;
        }
        Ok(())
    }

    /// The current number of primitives.
    fn count(&self) -> usize {
        self.current.posterior.primitives()
    }

    /// Starts the current number of primitives again, from principal components. From the number before, a new
    /// primitive can stay at 0 where the lengthscale has become long; from components, more primitives may share
    /// what fewer explained.
    fn start_again(&mut self) -> Result<(), NumericsError> {
        let (count, shared_weights) = (self.count(), !self.learns_phases);
        let fresh = Posterior::start(&self.trials, &self.alignment, &self.groups, count, shared_weights)?;
        self.grown = Some(std::mem::replace(&mut self.current, Run::new(fresh, &self.trials)?));
        Ok(())
    }

    /// Goes on with the next number of primitives, or trains the best number to the end.
    fn end_number(&mut self) -> Result<(), NumericsError> {
        self.worse_in_a_row += 1;
        if self.is_number_best {
            (self.worse_in_a_row, self.is_number_best) = (0, false);
            self.second = Some(self.current.clone());
        }
        if let Some(grown) = self.grown.take_if(|grown| grown.bound > self.current.bound) {
            self.current = grown;
        }
        self.grown = None;
        let best = self.best.as_ref().map_or(self.count(), |run| run.posterior.primitives());
        let end = if self.worse_in_a_row >= WORSE_IN_A_ROW {
            EndReason::MorePrimitivesAreWorse { best }
        } else if self.count() >= self.limits.most_primitives {
            EndReason::MostPrimitives { best }
        } else {
            return self.grow();
        };
        // From the best, the steps are large again.
        if let Some(best) = self.best.clone() {
            self.current = Run::new(best.posterior, &self.trials)?;
        }
        self.end = Some(end);
        Ok(())
    }

    /// Changes to the next number of primitives.
    fn grow(&mut self) -> Result<(), NumericsError> {
        let count = self.count();
        let more = if count < MANY { 1 } else { 2.min(self.limits.most_primitives - count) };
        let mut posterior = self.current.posterior.clone();
        for _ in 0..more {
            posterior = posterior.with_one_more(&self.trials)?;
        }
        self.current = Run::new(posterior, &self.trials)?;
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

    /// Whether the current posterior is better than the best before.
    fn is_best(&self) -> bool {
        self.best.as_ref().is_none_or(|best| {
            let more = best.posterior.primitives() < self.count();
            self.current.bound > best.bound + if more { DECISIVE } else { 0.0 }
        })
    }

    /// Records the bound of the current number of primitives, and the run if it is the best.
    fn record_bound(&mut self) {
        let (count, found) = (self.count(), self.current.bound);
        match self.bounds.iter_mut().find(|(other, _)| *other == count) {
            Some((_, bound)) => *bound = found.max(*bound),
            None => self.bounds.push((count, found)),
        }
        if self.is_best() {
            self.best = Some(self.current.clone());
            self.is_number_best = true;
        }
    }
}

impl Training for TmpLearner {
    fn step(&mut self) -> Progress {
        if self.reason.is_none() {
            self.iteration += 1;
            let (advanced, jittered) = counting_jittered(|| self.advance());
            self.setbacks.jittered += jittered;
            if let Err(error) = advanced {
                self.reason = Some(EndReason::Failed { primitives: Some(self.count()), error });
            }
        }
        self.progress()
    }

    fn progress(&self) -> Progress {
        let most = if self.requested.is_some() { 0 } else { 2 * self.numbers_to_try() * SEARCH_SWEEPS };
        let ends = if self.requested.is_some() { 1 } else { 2 };
        let most = most + ends * self.limits.max_sweeps;
        let best = match &self.best {
            Some(best) if !self.is_best() => best.bound,
            _ => self.current.bound,
        };
        let share = self.iteration as f64 / most as f64;
        let done = self.reason.is_some();
        Progress {
            iteration: self.iteration,
            max_iterations: most,
            evaluations: 0,
            setbacks: self.setbacks,
            objective: self.current.bound,
            best,
            terms: None,
            phase: None,
            done,
            reason: self.reason.clone(),
            fraction: if done { 1.0 } else { share.min(0.99) },
        }
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
            Some(best) if !self.is_best() => &best.posterior,
            _ => &self.current.posterior,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::data::movements::Sequence;
    use nalgebra::DMatrix;

    #[test]
    fn from_ten_primitives_on_every_second_number_is_tried() {
        let y = DMatrix::from_fn(30, 20, |t, k| (0.4 * ((k + 1) * t) as f64).sin());
        let movements = Movements { y: vec![y], sequences: vec![Sequence { frames: 30, whole: true }] };
        let grown = |count: usize, most_primitives: usize| {
            let settings = TmpSettings { primitives: Some(count), ..TmpSettings::default() };
            let limits = Limits { most_primitives, ..LIMITS };
            let mut learner = TmpLearner::within(&movements, &settings, limits).unwrap();
            learner.grow().unwrap();
            learner.count()
        };
        assert_eq!([grown(9, 20), grown(10, 20), grown(12, 20), grown(12, 13)], [10, 12, 14, 13]);
    }

    /// The most sweeps of a training: each number twice, then the best and its second start to the end.
    #[test]
    fn progress_names_the_most_sweeps() {
        let y = DMatrix::from_fn(30, 2, |t, k| (0.4 * ((k + 1) * t) as f64).sin());
        let movements = Movements { y: vec![y], sequences: vec![Sequence { frames: 30, whole: true }] };
        let most = [None, Some(2)].map(|primitives| {
            let settings = TmpSettings { primitives, ..TmpSettings::default() };
            TmpLearner::new(&movements, &settings).unwrap().progress().max_iterations
        });
        assert_eq!(most, [2 * (10 + 5 + 2) * 30 + 2 * 150, 150]);
    }

    #[test]
    fn the_search_ends_at_the_most_primitives() {
        let y = DMatrix::from_fn(30, 4, |t, k| (0.4 * ((k + 1) * t) as f64).sin());
        let movements = Movements { y: vec![y], sequences: vec![Sequence { frames: 30, whole: true }] };
        let limits = Limits { most_primitives: 2, max_sweeps: 10 };
        let mut learner = TmpLearner::within(&movements, &TmpSettings::default(), limits).unwrap();
        let first = learner.step();
        assert!((first.fraction * first.max_iterations as f64 - 1.0).abs() < 1e-9, "{}", first.fraction);
        while !learner.step().done {
            // A second start of one primitive would be the first one again.
            assert!(learner.count() > 1 || learner.grown.is_none());
        }
        assert_eq!(learner.progress().reason, Some(EndReason::MostPrimitives { best: 2 }));
        assert!(learner.fitted().unwrap().bounds.iter().all(|(count, _)| *count <= 2));
    }
}
