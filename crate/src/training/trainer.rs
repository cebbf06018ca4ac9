//! Training one step at a time, with progress, so that it can be shown, and stopped at any time with the best kept.

use super::init::starting_point;
use super::optimizer::{Evaluate, Optimizer};
use crate::linalg::NumericsError;
use crate::model::{BoundTerms, FittedModel, Group, Objective, Params, Sequences, SequencesError, Workspace};
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use thiserror::Error;

/// Added to the diagonal of every inducing covariance, times its signal variance.
const JITTER: f64 = 1e-6;
/// Iterations before everything is optimised together, at most.
const BLOCK_ITERATIONS: usize = 50;
/// The joint search ends when so many iterations have together gained less than [`SMALL_GAIN`] of the bound.
const PATIENCE: usize = 40;
const SMALL_GAIN: f64 = 1e-6;
/// More would not fit a browser's memory, or anybody's patience.
const LARGEST: usize = 1000;

/// What training is asked to do.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TrainingSettings {
    /// Latent dimensions Q of every part.
    pub latent: usize,
    /// Dynamics inducing points K of every expert.
    pub dynamics_ips: usize,
    /// Pose inducing points L of every part.
    pub pose_ips: usize,
    /// Order p of the dynamics.
    pub order: usize,
    /// The seed of everything random.
    pub seed: u32,
    /// Most iterations of the optimiser, all blocks together.
    pub max_iterations: usize,
}

impl Default for TrainingSettings {
    fn default() -> Self {
        Self { latent: 3, dynamics_ips: 12, pose_ips: 12, order: 2, seed: 0, max_iterations: 800 }
    }
}

/// Why training could not start.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TrainingError {
    /// A setting is out of its range.
    #[error("{name} must be from {lowest} to {highest}, found {found}")]
    Setting {
        /// What the setting is called.
        name: &'static str,
        /// Smallest value.
        lowest: usize,
        /// Largest value.
        highest: usize,
        /// The value asked for.
        found: usize,
    },
    /// There is nothing to do.
    #[error("expected at least one phase in the schedule, found none")]
    NoPhases,
    /// There is no part.
    #[error("expected at least one part, found none")]
    NoParts,
    /// Observations and sequences do not fit each other.
    #[error("part {part} has {found} frames of observations, but the sequences have {expected}")]
    Frames {
        /// Counted from 0.
        part: usize,
        /// Frames of the sequences.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// The sequences cannot be trained on.
    #[error(transparent)]
    Sequences(#[from] SequencesError),
    /// The bound cannot be computed at the starting point.
    #[error("training could not start: {0}")]
    Numerics(#[from] NumericsError),
}

/// How far training is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct TrainingProgress {
    /// Optimiser iterations so far.
    pub iteration: usize,
    /// Most iterations there can be.
    pub max_iterations: usize,
    /// Evaluations of the bound with its gradient so far.
    pub evaluations: usize,
    /// The bound at the point reached, in nats.
    pub bound: f64,
    /// The best bound so far.
    pub best: f64,
    /// The terms of the best bound.
    pub terms: BoundTerms,
    /// What is being optimised, in plain words.
    pub phase: String,
    /// Whether training has ended.
    pub done: bool,
    /// Why it ended, in plain words.
    pub reason: Option<String>,
    /// Share of the iterations used, 0 to 1. Time left is at most elapsed (1 - fraction) / fraction.
    pub fraction: f64,
}

/// A block of the schedule: which parameters are free, for how long.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phase {
    /// What is optimised, in plain words.
    pub name: &'static str,
    /// What is free; the rest is held.
    pub groups: &'static [Group],
    /// Most iterations. The last phase of a schedule goes on until the bound no longer rises.
    pub iterations: usize,
}

/// What the optimiser's evaluations leave behind.
struct Search {
    objective: Objective,
    workspace: Workspace,
    params: Params,
    /// The flat vector, held entries included.
    flat: Vec<f64>,
    best: f64,
    best_flat: Vec<f64>,
    best_terms: BoundTerms,
    evaluations: usize,
}

impl Search {
    /// The negative bound and its gradient with the entries `free` of the flat vector replaced by `x`.
    fn evaluate(&mut self, free: &[usize], x: &[f64]) -> (f64, Vec<f64>) {
        self.evaluations += 1;
        for (k, value) in free.iter().zip(x) {
            self.flat[*k] = *value;
        }
        self.params.set_flat(&self.flat);
        if self.objective.compute_with_gradient(&self.params, &mut self.workspace).is_ok() {
            let bound = self.workspace.terms().total();
            let gradient = self.workspace.gradient().to_flat_gradient(&self.params);
            if gradient.iter().all(|g| g.is_finite()) {
                if bound > self.best {
                    self.best = bound;
                    self.best_flat.copy_from_slice(&self.flat);
                    self.best_terms.clone_from(self.workspace.terms());
                }
                return (-bound, free.iter().map(|k| -gradient[*k]).collect());
            }
        }
        // A point that no jitter could save: worse than all that was seen, so that the line search turns back.
        (1e3 * (1.0 + self.best.abs()), vec![0.0; free.len()])
    }
}

/// A training under way.
pub struct Trainer {
    search: Arc<Mutex<Search>>,
    settings: TrainingSettings,
    phases: Vec<Phase>,
    phase: usize,
    phase_iterations: usize,
    iteration: usize,
    optimizer: Option<Optimizer>,
    /// Best bounds of the joint search, iteration by iteration.
    trace: Vec<f64>,
    bound: f64,
    reason: Option<&'static str>,
}

impl Trainer {
    /// Ready to train on the centred observations `y` [N x D_i] of each part, stacked as the `lengths` of the sequences say.
    pub fn new(
        y: Vec<DMatrix<f64>>,
        lengths: Vec<usize>,
        settings: TrainingSettings,
    ) -> Result<Self, TrainingError> {
        for (name, found) in [
            ("the latent dimension", settings.latent),
            ("the number of dynamics inducing points", settings.dynamics_ips),
            ("the number of pose inducing points", settings.pose_ips),
            ("the order of the dynamics", settings.order),
        ] {
            let highest = if name.contains("points") { LARGEST } else { 100 };
            if !(1..=highest).contains(&found) {
                return Err(TrainingError::Setting { name, lowest: 1, highest, found });
            }
        }
        if y.is_empty() {
            return Err(TrainingError::NoParts);
        }
        let sequences = Sequences::new(lengths, settings.order)?;
        let expected = sequences.frames();
        if let Some(part) = y.iter().position(|y| y.nrows() != expected) {
            return Err(TrainingError::Frames { part, expected, found: y[part].nrows() });
        }
        let params = starting_point(&y, &sequences, &settings);
        let phases = schedule(settings.max_iterations);
        Self::from_start(Objective::new(y, sequences, JITTER), params, phases, settings)
    }

    /// Ready to train from the parameters `start` by the given phases, of which there must be one. The settings count for the
    /// number of iterations and for the model's provenance.
    pub fn from_start(
        objective: Objective,
        params: Params,
        phases: Vec<Phase>,
        settings: TrainingSettings,
    ) -> Result<Self, TrainingError> {
        if phases.is_empty() {
            return Err(TrainingError::NoPhases);
        }
        let flat = params.to_flat();
        let mut workspace = objective.workspace(&params);
        objective.compute(&params, &mut workspace)?;
        let best_terms = workspace.terms().clone();
        let best = best_terms.total();
        let best_flat = flat.clone();
        let search =
            Search { objective, workspace, params, flat, best, best_flat, best_terms, evaluations: 0 };
        Ok(Self {
            search: Arc::new(Mutex::new(search)),
            settings,
            phases,
            phase: 0,
            phase_iterations: 0,
            iteration: 0,
            optimizer: None,
            trace: Vec::new(),
            bound: best,
            reason: None,
        })
    }

    fn search(&self) -> MutexGuard<'_, Search> {
        // Evaluations do not unwind; if one ever did, the best so far would still be whole.
        self.search.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// One iteration of the optimiser. After the end it does nothing.
    pub fn step(&mut self) -> TrainingProgress {
        if self.reason.is_none() {
            if self.iteration >= self.settings.max_iterations {
                self.reason = Some("all iterations used");
            } else {
                self.iterate();
            }
        }
        self.progress()
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
            self.bound = -value;
        }
        let last = self.phase + 1 == self.phases.len();
        if last {
            let best = self.search().best;
            self.trace.push(best);
            let settled = self.trace.len() > PATIENCE
                && best - self.trace[self.trace.len() - 1 - PATIENCE] < SMALL_GAIN * best.abs();
            if !moved || settled {
                self.reason = Some("the bound no longer rises");
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
        let kinds = search.params.flat_kinds();
        let free: Vec<usize> = (0..kinds.len()).filter(|k| groups.contains(&kinds[*k].group)).collect();
        let start = free.iter().map(|k| search.flat[*k]).collect();
        let boxes: Vec<(f64, f64)> = free.iter().map(|k| kinds[*k].flat_box()).collect();
        drop(search);
        let shared = Arc::clone(&self.search);
        let evaluate: Evaluate =
            Box::new(move |x| shared.lock().unwrap_or_else(PoisonError::into_inner).evaluate(&free, x));
        Optimizer::new(start, boxes.into_iter(), evaluate)
    }

    /// How far training is.
    pub fn progress(&self) -> TrainingProgress {
        let search = self.search();
        let max_iterations = self.settings.max_iterations;
        TrainingProgress {
            iteration: self.iteration,
            max_iterations,
            evaluations: search.evaluations,
            bound: self.bound,
            best: search.best,
            terms: search.best_terms.clone(),
            phase: self.phases[self.phase].name.to_owned(),
            done: self.reason.is_some(),
            reason: self.reason.map(str::to_owned),
            fraction: if self.reason.is_some() {
                1.0
            } else {
                self.iteration as f64 / max_iterations.max(1) as f64
            },
        }
    }

    /// What training was asked to do.
    pub fn settings(&self) -> &TrainingSettings {
        &self.settings
    }

    /// The parameters of the best bound so far; before the first step, the starting point.
    pub fn best(&self) -> Params {
        let search = self.search();
        let mut params = search.params.clone();
        params.set_flat(&search.best_flat);
        params
    }

    /// What the bound is computed on.
    pub fn objective(&self) -> Objective {
        self.search().objective.clone()
    }

    /// The model of the best bound so far.
    pub fn model(&self) -> Result<FittedModel, NumericsError> {
        let params = self.best();
        FittedModel::fit(&self.search().objective, &params)
    }
}

/// First what the latents are explained with, while they stay at their principal components; then everything together.
///
/// Without the first block some seeds end in a model that stands still; with the authors' further blocks (latents alone, kernels
/// alone, inducing points alone) more of them end in a worse bound.
pub fn schedule(max_iterations: usize) -> Vec<Phase> {
    use Group::{InducingInputs, Kernels, Latents};
    let first = Phase {
        name: "couplings, kernels and inducing points",
        groups: &[Kernels, InducingInputs],
        iterations: BLOCK_ITERATIONS.min(max_iterations / 8),
    };
    let all = &[Latents, Kernels, InducingInputs];
    let mut phases =
        vec![first, Phase { name: "everything together", groups: all, iterations: max_iterations }];
    // The last stays, even without iterations: there is always a phase to tell.
    if phases[0].iterations == 0 {
        phases.remove(0);
    }
    phases
}

#[cfg(test)]
mod tests;
