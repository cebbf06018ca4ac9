//! The search for the parameters of the largest objective: blocks of free parameters one after the other, one
//! iteration of the optimiser at a time, the best kept.

use crate::gp::NumericsError;
use crate::gp::linalg::counting_jittered;
use crate::models::search::optimizer::{Evaluate, Optimizer};
use crate::models::training::parameters::{Group, Parameters};
use crate::models::training::progress::Setbacks;
use serde::Serialize;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The last phase ends when so many iterations have together gained less than [`SMALL_GAIN`] of the
/// objective.
const PATIENCE: usize = 40;
const SMALL_GAIN: f64 = 1e-6;

/// What is maximised.
pub trait Target {
    /// What it is a function of.
    type Parameters: Parameters;
    /// What it is the sum of.
    type Terms: Clone;

    /// Computes the value at `at`, and with it terms and gradient.
    fn compute(&mut self, at: &Self::Parameters) -> Result<f64, NumericsError>;

    /// The terms of the value computed last.
    fn terms(&self) -> &Self::Terms;

    /// The gradient of the value computed last with respect to the natural parameters.
    fn gradient(&self) -> &Self::Parameters;
}

/// A block of the schedule: which parameters are free, for how long.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phase {
    /// What is free; the rest is held.
    pub groups: &'static [Group],
    /// Most iterations. The last phase of a schedule goes on until the objective no longer rises.
    pub iterations: usize,
}

/// Why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SearchEnd {
    /// The objective no longer rises.
    Settled,
    /// All iterations are used.
    Iterations,
}

/// What the optimiser's evaluations leave behind.
pub struct Search<T: Target> {
    /// What is maximised.
    pub target: T,
    /// The best value so far.
    pub best: f64,
    /// Its terms.
    pub best_terms: T::Terms,
    /// Evaluations so far.
    pub evaluations: usize,
    /// What went wrong in them.
    pub setbacks: Setbacks,
    parameters: T::Parameters,
    /// The flat vector, held entries included.
    flat: Vec<f64>,
    best_flat: Vec<f64>,
}

impl<T: Target> Search<T> {
    /// The negative value and its gradient with the entries `free` of the flat vector replaced by `x`.
    fn evaluate(&mut self, free: &[usize], x: &[f64]) -> (f64, Vec<f64>) {
        self.evaluations += 1;
        for (k, value) in free.iter().zip(x) {
            self.flat[*k] = *value;
        }
        self.parameters.set_flat(&self.flat);
        let (computed, jittered) = counting_jittered(|| self.target.compute(&self.parameters));
        self.setbacks.jittered += jittered;
        if let Ok(value) = computed {
            let gradient = self.target.gradient().to_flat_gradient(&self.parameters);
            if gradient.iter().all(|g| g.is_finite()) {
                if value > self.best {
                    self.best = value;
                    self.best_flat.copy_from_slice(&self.flat);
                    self.best_terms.clone_from(self.target.terms());
                }
                return (-value, free.iter().map(|k| -gradient[*k]).collect());
            }
        }
        self.setbacks.turned_back += 1;
        // A point that no jitter could save: worse than all that was seen, so that the line search turns
        // back.
        (1e3 * (1.0 + self.best.abs()), vec![0.0; free.len()])
    }

    /// The parameters of the best value so far; before the first step, the starting point.
    pub fn best_parameters(&self) -> T::Parameters {
        let mut parameters = self.parameters.clone();
        parameters.set_flat(&self.best_flat);
        parameters
    }
}

/// A search under way.
pub struct Ascent<T: Target> {
    search: Arc<Mutex<Search<T>>>,
    phases: Vec<Phase>,
    /// Entries of the flat vector that are free in no phase; empty: none are held.
    held: Vec<bool>,
    phase: usize,
    phase_iterations: usize,
    iteration: usize,
    max_iterations: usize,
    optimizer: Option<Optimizer>,
    /// Best values of the last phase, iteration by iteration.
    trace: Vec<f64>,
    value: f64,
    reason: Option<SearchEnd>,
    /// In which the optimiser computes its directions.
    threads: usize,
}

impl<T: Target + Send + 'static> Ascent<T>
where
    T::Parameters: Send,
    T::Terms: Send,
{
    /// Starts at `parameters`, where the target has the value `value` of these terms. There must be a phase;
    /// phases without iterations are left out, but for the last.
    pub fn new(
        target: T,
        parameters: T::Parameters,
        (value, best_terms): (f64, T::Terms),
        mut phases: Vec<Phase>,
        max_iterations: usize,
    ) -> Self {
        let last = phases.len().saturating_sub(1);
        let mut place = 0;
        phases.retain(|phase| {
            place += 1;
            phase.iterations > 0 || place > last
        });
        let flat = parameters.to_flat();
        let best_flat = flat.clone();
        let search = Search {
            target,
            best: value,
            best_terms,
            evaluations: 0,
            setbacks: Setbacks::default(),
            parameters,
            flat,
            best_flat,
        };
        Self {
            search: Arc::new(Mutex::new(search)),
            phases,
            held: Vec::new(),
            phase: 0,
            phase_iterations: 0,
            iteration: 0,
            max_iterations,
            optimizer: None,
            trace: Vec::new(),
            value,
            reason: None,
            threads: 1,
        }
    }

    /// Computes the optimiser's directions in so many threads from now on, and to the same bits.
    #[cfg(feature = "threads")]
    pub fn use_threads(&mut self, threads: usize) {
        self.threads = threads;
        if let Some(optimizer) = &mut self.optimizer {
            optimizer.use_threads(threads);
        }
    }

    /// Before the first step: holds these entries of the flat vector in every phase, whatever their group.
    pub fn hold(&mut self, held: Vec<bool>) {
        self.held = held;
    }

    /// What the evaluations left behind.
    pub fn search(&self) -> MutexGuard<'_, Search<T>> {
        lock(&self.search)
    }

    /// One iteration of the optimiser. After the end it does nothing.
    pub fn step(&mut self) {
        if self.reason.is_none() {
            if self.iteration >= self.max_iterations {
                self.reason = Some(SearchEnd::Iterations);
            } else {
                self.iterate();
            }
        }
    }

    fn iterate(&mut self) {
        let mut optimizer = match self.optimizer.take() {
            Some(optimizer) => optimizer,
            None => self.begin_phase(),
        };
        let moved = optimizer.step();
        self.iteration += 1;
        self.phase_iterations += 1;
        if let Some(value) = optimizer.value() {
            self.value = -value;
        }
        let last = self.phase + 1 == self.phases.len();
        if last {
            let best = self.search().best;
            self.trace.push(best);
            let settled = self.trace.len() > PATIENCE
                && best - self.trace[self.trace.len() - 1 - PATIENCE] < SMALL_GAIN * best.abs();
            if settled || !moved {
                self.reason = Some(SearchEnd::Settled);
            }
        }
        if last || (moved && self.phase_iterations < self.phases[self.phase].iterations) {
            self.optimizer = Some(optimizer);
        } else {
            self.phase += 1;
            self.phase_iterations = 0;
        }
    }

    /// Every phase starts from the best point so far.
    fn begin_phase(&self) -> Optimizer {
        let mut search = self.search();
        search.flat = search.best_flat.clone();
        let groups = self.phases[self.phase].groups;
        let kinds = search.parameters.flat_kinds();
        let held = |k: usize| self.held.get(k).copied().unwrap_or(false);
        let free: Vec<usize> =
            (0..kinds.len()).filter(|k| groups.contains(&kinds[*k].group) && !held(*k)).collect();
        let start = free.iter().map(|k| search.flat[*k]).collect();
        let boxes: Vec<(f64, f64)> = free.iter().map(|k| kinds[*k].flat_box()).collect();
        drop(search);
        let shared = Arc::clone(&self.search);
        let evaluate: Evaluate = Box::new(move |x| lock(&shared).evaluate(&free, x));
        let mut optimizer = Optimizer::new(start, boxes.into_iter(), evaluate);
        optimizer.use_threads(self.threads);
        optimizer
    }

    /// Allows so many more iterations. A search that ended because all were used goes on with the memory of
    /// its optimiser, as if they had been allowed from the beginning; one that has settled stays settled.
    pub fn extend(&mut self, iterations: usize) {
        self.max_iterations = self.max_iterations.saturating_add(iterations);
        if self.reason == Some(SearchEnd::Iterations) {
            self.reason = None;
        }
    }

    /// Iterations so far.
    pub fn iteration(&self) -> usize {
        self.iteration
    }

    /// Most iterations there can be.
    pub fn max_iterations(&self) -> usize {
        self.max_iterations
    }

    /// The value at the point reached.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// The phase under way, or the last one.
    pub fn phase(&self) -> &Phase {
        &self.phases[self.phase]
    }

    /// Why the search ended; `None` while it goes on.
    pub fn reason(&self) -> Option<SearchEnd> {
        self.reason
    }

    /// Share of the iterations used, 0 to 1.
    pub fn fraction(&self) -> f64 {
        if self.reason.is_some() { 1.0 } else { self.iteration as f64 / self.max_iterations.max(1) as f64 }
    }
}

fn lock<T>(shared: &Mutex<T>) -> MutexGuard<'_, T> {
    // Evaluations do not unwind; if one ever did, the best so far would still be whole.
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests;
