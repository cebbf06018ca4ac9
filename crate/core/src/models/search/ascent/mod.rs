//! The search for the parameters of the largest objective: phase after phase with different free parameters,
//! one iteration of the optimiser at a time. The best point is stored.

use crate::gp::NumericsError;
use crate::gp::linalg::counting_jittered;
use crate::models::search::Setbacks;
use crate::models::search::optimizer::Optimizer;
use crate::models::search::parameters::{Group, Parameters};
use serde::Serialize;
use std::collections::VecDeque;

/// The last phase ends when this number of iterations has gained less than [`SMALL_GAIN`] of the objective.
const PATIENCE: usize = 40;
const SMALL_GAIN: f64 = 1e-6;

/// An objective to be maximised.
pub trait Target {
    /// The arguments of the objective.
    type Parameters: Parameters;
    /// The terms whose sum is the objective.
    type Terms: Clone;

    /// Computes the objective at `at`, its terms and its gradient.
    fn compute(&mut self, at: &Self::Parameters) -> Result<f64, NumericsError>;

    /// Copies the terms of the last [`compute`](Self::compute).
    fn copy_terms(&self, into: &mut Self::Terms);

    /// The gradient of the last [`compute`](Self::compute), with respect to the natural parameters.
    fn gradient(&self) -> &Self::Parameters;
}

/// A phase of the schedule: the free parameters, and the number of iterations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phase {
    /// The free parameters; all others are fixed.
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

/// The objective with the results of its evaluations.
pub struct Search<T: Target> {
    /// The objective.
    pub target: T,
    /// The best value so far.
    pub best: f64,
    /// The terms of the best value.
    pub best_terms: T::Terms,
    /// Number of evaluations so far.
    pub evaluations: usize,
    /// Failures in these evaluations.
    pub setbacks: Setbacks,
    parameters: T::Parameters,
    /// The flat vector, fixed entries included.
    flat: Vec<f64>,
    flat_gradient: Vec<f64>,
    best_flat: Vec<f64>,
    /// The free entries of the flat vector in the phase under way.
    free: Vec<usize>,
}

impl<T: Target> Search<T> {
    /// The negative objective with `x` in the free entries of the flat vector; writes its `gradient`.
    fn evaluate(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        self.evaluations += 1;
        for (k, value) in self.free.iter().zip(x) {
            self.flat[*k] = *value;
        }
        self.parameters.set_flat(&self.flat);
        let (computed, jittered) = counting_jittered(|| self.target.compute(&self.parameters));
        self.setbacks.jittered += jittered;
        if let Ok(value) = computed {
            self.target.gradient().flat_gradient_into(&self.parameters, &mut self.flat_gradient);
            if self.flat_gradient.iter().all(|g| g.is_finite()) {
                if value > self.best {
                    self.best = value;
                    self.best_flat.copy_from_slice(&self.flat);
                    self.target.copy_terms(&mut self.best_terms);
                }
                for (out, k) in gradient.iter_mut().zip(&self.free) {
                    *out = -self.flat_gradient[*k];
                }
                return -value;
            }
        }
        self.setbacks.turned_back += 1;
        // No jitter helped: a value worse than all others makes the line search turn back.
        gradient.fill(0.0);
        1e3 * (1.0 + self.best.abs())
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
    search: Search<T>,
    phases: Vec<Phase>,
    /// Whether an entry of the flat vector is fixed in every phase; empty: no entry is.
    fixed: Vec<bool>,
    phase: usize,
    phase_iterations: usize,
    iteration: usize,
    max_iterations: usize,
    optimizer: Option<Optimizer>,
    /// Best values of the last iterations of the last phase.
    trace: VecDeque<f64>,
    value: f64,
    reason: Option<SearchEnd>,
    /// Number of threads in which the optimiser computes its directions.
    threads: usize,
}

impl<T: Target> Ascent<T> {
    /// Starts at `parameters`, where the objective has this `value` and these terms. There must be a phase.
    /// Phases without iterations are left out, except the last.
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
            flat_gradient: Vec::with_capacity(flat.len()),
            flat,
            best_flat,
            free: Vec::new(),
        };
        Self {
            search,
            phases,
            fixed: Vec::new(),
            phase: 0,
            phase_iterations: 0,
            iteration: 0,
            max_iterations,
            optimizer: None,
            trace: VecDeque::with_capacity(PATIENCE + 1),
            value,
            reason: None,
            threads: 1,
        }
    }

    /// Computes the optimiser's directions in `threads` threads from now on. The result is the same to the
    /// last bit.
    #[cfg(feature = "threads")]
    pub fn use_threads(&mut self, threads: usize) {
        self.threads = threads;
        if let Some(optimizer) = &mut self.optimizer {
            optimizer.use_threads(threads);
        }
    }

    /// Before the first step: fixes these entries of the flat vector in every phase and group.
    pub fn fix(&mut self, fixed: Vec<bool>) {
        self.fixed = fixed;
    }

    /// The objective with the results of its evaluations.
    pub fn search(&self) -> &Search<T> {
        &self.search
    }

    /// The objective, to change how it is computed.
    #[cfg(feature = "threads")]
    pub fn target_mut(&mut self) -> &mut T {
        &mut self.search.target
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
        let moved = optimizer.step(&mut |x, gradient| self.search.evaluate(x, gradient));
        self.iteration += 1;
        self.phase_iterations += 1;
        if let Some(value) = optimizer.value() {
            self.value = -value;
        }
        let last = self.phase + 1 == self.phases.len();
        if last {
            let best = self.search.best;
            if self.trace.len() > PATIENCE {
                self.trace.pop_front();
            }
            self.trace.push_back(best);
            let earlier = self.trace.front().filter(|_| self.trace.len() > PATIENCE);
            let settled = earlier.is_some_and(|earlier| best - earlier < SMALL_GAIN * best.abs());
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
    fn begin_phase(&mut self) -> Optimizer {
        let search = &mut self.search;
        search.flat.copy_from_slice(&search.best_flat);
        let groups = self.phases[self.phase].groups;
        let kinds = search.parameters.flat_kinds();
        let fixed = |k: usize| self.fixed.get(k).copied().unwrap_or(false);
        search.free = (0..kinds.len()).filter(|k| groups.contains(&kinds[*k].group) && !fixed(*k)).collect();
        let start = search.free.iter().map(|k| search.flat[*k]).collect();
        let mut optimizer = Optimizer::new(start, search.free.iter().map(|k| kinds[*k].flat_box()));
        optimizer.use_threads(self.threads);
        optimizer
    }

    /// Allows `iterations` more iterations. A search that used all its iterations goes on with the pairs of
    /// its optimiser, as if all had been allowed from the start. A search that has settled stays settled.
    pub fn extend(&mut self, iterations: usize) {
        self.max_iterations = self.max_iterations.saturating_add(iterations);
        if self.reason == Some(SearchEnd::Iterations) {
            self.reason = None;
        }
    }

    /// Number of iterations so far.
    pub fn iteration(&self) -> usize {
        self.iteration
    }

    /// Largest number of iterations.
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

#[cfg(test)]
mod tests;
