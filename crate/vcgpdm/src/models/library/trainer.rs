//! Training of a library, one step at a time.

use crate::gp::NumericsError;
use crate::models::fitted::provenance::Provenance;
use crate::models::library::Library;
use crate::models::library::plan::LibraryPlan;
use crate::models::training::error::TrainingError;
use crate::models::training::progress::Progress;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::VariationalTrainer;
use nalgebra::DMatrix;

/// A training of a library under way: all movements together, with the primitives that they share.
pub struct LibraryTrainer {
    trainer: VariationalTrainer,
    plan: LibraryPlan,
}

impl LibraryTrainer {
    /// Ready to train on the centred observations `y` [N x D_i] of each part, stacked as the `lengths` of the
    /// sequences say; they are those of the plan's movements, one movement after the other. The `seed` is
    /// that of everything random.
    ///
    /// # Errors
    ///
    /// When a setting is out of its range, the observations do not fit the sequences or the plan, or the
    /// bound cannot be computed at the start.
    pub fn new(
        y: Vec<DMatrix<f64>>,
        lengths: Vec<usize>,
        plan: LibraryPlan,
        settings: &VariationalSettings,
        seed: u32,
    ) -> Result<Self, TrainingError> {
        plan.check(y.len())?;
        let primitives = plan.primitives().into_iter().map(|primitive| primitive.part).collect();
        let trainer = VariationalTrainer::of_movements(y, lengths, primitives, plan.uses(), settings, seed)?;
        Ok(Self { trainer, plan })
    }

    /// As [`Trainer::use_threads`].
    #[cfg(feature = "threads")]
    pub fn use_threads(&mut self, threads: usize) {
        self.trainer.use_threads(threads);
    }

    /// One iteration of the optimiser. After the end it does nothing.
    pub fn step(&mut self) -> Progress {
        self.trainer.step()
    }

    /// How far training is.
    pub fn progress(&self) -> Progress {
        self.trainer.progress()
    }

    /// Allows so many more iterations; see [`Trainer::extend`].
    pub fn extend(&mut self, iterations: usize) {
        self.trainer.extend(iterations);
    }

    /// What training was asked to do.
    pub fn settings(&self) -> &VariationalSettings {
        self.trainer.settings()
    }

    /// As [`Trainer::notices`].
    pub fn notices(&self) -> &[String] {
        self.trainer.notices()
    }

    /// The seed of everything random.
    pub fn seed(&self) -> u32 {
        self.trainer.seed()
    }

    /// How the best library so far was made; `frames_per_second` is the rate that the data set was asked for.
    pub fn provenance(&self, frames_per_second: f64) -> Provenance {
        self.trainer.provenance(frames_per_second)
    }

    /// The movements, and which parts share a primitive.
    pub fn plan(&self) -> &LibraryPlan {
        &self.plan
    }

    /// The library of the best bound so far.
    ///
    /// # Errors
    ///
    /// When a covariance of it cannot be factorised.
    pub fn library(&self) -> Result<Library, NumericsError> {
        let terms = self.trainer.best_terms();
        Library::fit(&self.trainer.objective(), &self.trainer.best(), terms, &self.plan)
    }
}
