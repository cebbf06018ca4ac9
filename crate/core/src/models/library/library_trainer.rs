//! Trainings of a library.

use crate::gp::NumericsError;
use crate::models::data::dataset::{Dataset, DatasetError};
use crate::models::errors::TrainingError;
use crate::models::kinds::body::Body;
use crate::models::kinds::trainer::{run_with, with_rounds};
use crate::models::library::own_rollouts::LibraryRollouts;
use crate::models::library::plan::LibraryPlan;
use crate::models::library::{Library, TrainedLibrary};
use crate::models::training::progress::Progress;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::VariationalTrainer;
use nalgebra::DMatrix;
use std::ops::ControlFlow;

/// A training of a library: all movements together, with the primitives that they share. If the settings say so,
/// each movement then learns from its own rollouts in further steps.
pub struct LibraryTrainer {
    trainer: VariationalTrainer,
    learns_from_own_rollouts: bool,
    rollouts: Option<LibraryRollouts>,
    plan: LibraryPlan,
    body: Body,
    frames_per_second: f64,
    warnings: Vec<String>,
}

impl LibraryTrainer {
    /// A training before its first iteration. The data set has the sequences of the plan's movements, one
    /// movement after the other. Everything random follows from the `seed`.
    ///
    /// # Errors
    ///
    /// When a setting is out of its range, the data set does not fit the plan, or the bound cannot be
    /// computed at the start; the error names the clip if the reason is in one clip.
    pub fn new(
        dataset: &Dataset,
        plan: &LibraryPlan,
        settings: &VariationalSettings,
        seed: u32,
    ) -> Result<Self, DatasetError> {
        let trainer = trainer_of(dataset.y.clone(), dataset.lengths(), plan, settings, seed);
        Ok(Self {
            trainer: trainer.map_err(|reason| dataset.training_error(reason))?,
            learns_from_own_rollouts: settings.own_rollouts,
            rollouts: None,
            plan: plan.clone(),
            body: Body::new(dataset),
            frames_per_second: dataset.frames_per_second,
            warnings: dataset.warnings.clone(),
        })
    }

    /// Uses `threads` threads from now on. The result is the same to the last bit.
    #[cfg(feature = "threads")]
    pub fn use_threads(&mut self, threads: usize) {
        self.trainer.use_threads(threads);
    }

    /// One step: an iteration of the optimiser, or a round of own rollouts of a movement. After the end it does
    /// nothing.
    pub fn step(&mut self) -> Progress {
        if !self.trainer.progress().done {
            self.trainer.step();
        } else if let Some(rollouts) = &mut self.rollouts {
            rollouts.step();
        }
        let ended = self.trainer.progress().done && self.learns_from_own_rollouts;
        if ended && self.rollouts.is_none() {
            self.rollouts = self.trained().ok().map(LibraryRollouts::new);
        }
        self.progress()
    }

    /// Trains to the end.
    pub fn run(&mut self) -> Progress {
        self.run_with(|_| ControlFlow::Continue(()))
    }

    /// Trains to the end, or until `watch`, which is called after every step, breaks.
    pub fn run_with(&mut self, watch: impl FnMut(&Progress) -> ControlFlow<()>) -> Progress {
        run_with(|| self.step(), watch)
    }

    /// How far the training is.
    pub fn progress(&self) -> Progress {
        let rounds = self.rollouts.as_ref().map(|rollouts| (rollouts.fraction(), rollouts.is_done()));
        with_rounds(self.trainer.progress(), self.learns_from_own_rollouts, rounds)
    }

    /// Allows `iterations` more, also after the end, where the training then continues.
    pub fn extend(&mut self, iterations: usize) {
        self.trainer.extend(iterations);
        if !self.trainer.progress().done {
            self.rollouts = None;
        }
    }

    /// What the user should know: the warnings of the data set, then settings that are more than the data
    /// allow and were reduced. Sentences without a full stop.
    pub fn warnings(&self) -> Vec<String> {
        [&self.warnings, self.trainer.notices()].concat()
    }

    /// The best library so far.
    ///
    /// # Errors
    ///
    /// When a covariance of the library cannot be factorised.
    pub fn finish(&self) -> Result<TrainedLibrary, NumericsError> {
        self.rollouts.as_ref().map_or_else(|| self.trained(), |rollouts| Ok(rollouts.best().clone()))
    }

    /// The library of the best bound so far.
    fn trained(&self) -> Result<TrainedLibrary, NumericsError> {
        Ok(TrainedLibrary {
            library: library_of(&self.trainer, &self.plan)?,
            body: self.body.clone(),
            provenance: self.trainer.provenance(self.frames_per_second),
        })
    }
}

/// A training on the centred observations `y` [N x D_i] of each part, stacked by the `lengths` of the
/// sequences.
pub(super) fn trainer_of(
    y: Vec<DMatrix<f64>>,
    lengths: Vec<usize>,
    plan: &LibraryPlan,
    settings: &VariationalSettings,
    seed: u32,
) -> Result<VariationalTrainer, TrainingError> {
    plan.check(y.len())?;
    let primitives = plan.primitives().into_iter().map(|primitive| primitive.part).collect();
    VariationalTrainer::of_movements(y, lengths, primitives, plan.uses(), settings, seed)
}

/// The library of the best bound of a training so far.
pub(super) fn library_of(trainer: &VariationalTrainer, plan: &LibraryPlan) -> Result<Library, NumericsError> {
    Library::fit(&trainer.objective(), &trainer.best(), trainer.best_terms(), plan)
}
