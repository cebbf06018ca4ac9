//! Trainings of any kind of model on a data set.

use crate::gp::NumericsError;
use crate::models::data::column_mapping::ColumnMapping;
use crate::models::data::dataset::{Dataset, DatasetError};
use crate::models::data::movements::Movements;
use crate::models::fitted::body::Body;
use crate::models::fitted::model::Model;
use crate::models::fitted::provenance::Provenance;
use crate::models::training::error::TrainingError;
use crate::models::training::learner::Learner;
use crate::models::training::progress::Progress;
use crate::models::training::settings::{Settings, VariationalSettings};
use crate::models::variational::Vcgpdm;
use crate::motion::pose::PoseMapping;
use nalgebra::DMatrix;
use std::ops::ControlFlow;

/// A training of any kind of model. It can be stopped after any iteration; the best model so far is kept.
///
/// ```
/// use std::ops::ControlFlow;
/// use vcgpdm::{Dataset, Settings, Trainer, part_presets, sample_clip};
///
/// let clip = sample_clip("walk-1").ok_or("no such sample")?;
/// let whole = &part_presets(&clip.skeleton)[0].parts;
/// let dataset = Dataset::new(&[(&clip).into()], whole, 30.0)?;
/// let mut trainer = Trainer::new(&dataset, &Settings::Vgpdm(Default::default()), 0)?;
/// trainer.run_with(|progress| match progress.iteration {
///     0..20 => ControlFlow::Continue(()),
///     _ => ControlFlow::Break(()),
/// });
/// let model = trainer.finish()?;
/// assert_eq!(model.rollout(0, 100)?.nrows(), 100);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Trainer<S = PoseMapping> {
    learner: Box<dyn Learner>,
    body: Body<S>,
    settings: Settings,
    seed: u32,
    frames_per_second: f64,
    warnings: Vec<String>,
}

impl<S: ColumnMapping> Trainer<S> {
    /// A training before its first iteration. Everything random follows from the `seed`.
    ///
    /// # Errors
    ///
    /// When a setting is out of its range, or the model cannot learn from the data set; the error names the
    /// clip if the reason is in one clip.
    pub fn new(dataset: &Dataset<S>, settings: &Settings, seed: u32) -> Result<Self, DatasetError> {
        let parts = dataset.layout.parts().len();
        if parts > 1 && matches!(settings, Settings::Vgpdm(_) | Settings::MapGpdm(_)) {
            return Err(DatasetError::Training(TrainingError::Parts { expected: 1, found: parts }));
        }
        let learner = settings.learner(&Movements::new(dataset), seed);
        Ok(Self {
            learner: learner.map_err(|reason| dataset.training_error(reason))?,
            body: Body::new(dataset),
            settings: settings.clone(),
            seed,
            frames_per_second: dataset.frames_per_second,
            warnings: dataset.warnings.clone(),
        })
    }

    /// One iteration. After the end it does nothing.
    pub fn step(&mut self) -> Progress {
        self.learner.step()
    }

    /// Trains to the end.
    pub fn run(&mut self) -> Progress {
        self.run_with(|_| ControlFlow::Continue(()))
    }

    /// Trains to the end, or until `watch`, which is called after every iteration, breaks.
    pub fn run_with(&mut self, watch: impl FnMut(&Progress) -> ControlFlow<()>) -> Progress {
        run_with(|| self.learner.step(), watch)
    }

    /// The best model so far.
    ///
    /// # Errors
    ///
    /// When a covariance of the model cannot be factorised.
    pub fn finish(&self) -> Result<Model<S>, NumericsError> {
        let progress = self.learner.progress();
        let mut settings = self.settings.clone();
        if let Settings::Vcgpdm(s) | Settings::Vgpdm(s) = &mut settings {
            // `extend` may have raised it.
            s.max_iterations = progress.max_iterations;
        }
        if let (Settings::Vcgpdm(s), 1) = (&settings, self.body.layout.parts().len()) {
            settings = Settings::Vgpdm(s.clone());
        }
        let provenance = Provenance::of_training(settings, self.seed, self.frames_per_second, &progress);
        Ok(Model { fitted: self.learner.model()?, body: self.body.clone(), provenance })
    }

    /// How far the training is.
    pub fn progress(&self) -> Progress {
        self.learner.progress()
    }

    /// What the user should know: the warnings of the data set, then settings that are more than the data
    /// allow and were reduced. Sentences without a full stop.
    pub fn warnings(&self) -> Vec<String> {
        [&self.warnings, self.learner.notices()].concat()
    }

    /// Allows `iterations` more, also after the end, where the training then continues. Only the training of
    /// a vCGPDM or vGPDM can be extended; for other kinds this does nothing.
    pub fn extend(&mut self, iterations: usize) {
        self.learner.extend(iterations);
    }

    /// The number of parts M.
    pub fn part_count(&self) -> usize {
        self.body.layout.parts().len()
    }

    /// Latent means of a part in all training frames at the best so far [N x Q_i], sequences one after the
    /// other; `None` where there is no such part, or the kind of model has no latents.
    pub fn latents(&self, part: usize) -> Option<DMatrix<f64>> {
        self.learner.latents(part)
    }

    /// Uses `threads` threads from now on, if the kind of model can. The result is the same to the last
    /// bit.
    #[cfg(feature = "threads")]
    pub fn use_threads(&mut self, threads: usize) {
        self.learner.use_threads(threads);
    }
}

impl Vcgpdm {
    /// Trains a vCGPDM to the end; a vGPDM where the data set has one part. [`Trainer`] does the same step by
    /// step, and trains the other kinds of models.
    ///
    /// ```
    /// use vcgpdm::{Dataset, Vcgpdm, VariationalSettings, part_presets, sample_clip};
    ///
    /// let clip = sample_clip("walk-1").ok_or("no such sample")?;
    /// let dataset = Dataset::new(&[(&clip).into()], &part_presets(&clip.skeleton)[1].parts, 30.0)?;
    /// let settings = VariationalSettings { max_iterations: 10, ..Default::default() };
    /// let model = Vcgpdm::fit(&dataset, &settings, 0)?;
    /// assert_eq!(model.rollout(0, 100)?.nrows(), 100);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`Trainer::new`] and [`Trainer::finish`].
    pub fn fit<S: ColumnMapping>(
        dataset: &Dataset<S>,
        settings: &VariationalSettings,
        seed: u32,
    ) -> Result<Model<S>, DatasetError> {
        let mut trainer = Trainer::new(dataset, &settings.clone().into(), seed)?;
        trainer.run();
        trainer.finish().map_err(|reason| DatasetError::Training(reason.into()))
    }
}

/// Takes steps to the end, or until `watch` breaks.
pub(crate) fn run_with(
    mut step: impl FnMut() -> Progress,
    mut watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Progress {
    loop {
        let progress = step();
        if watch(&progress).is_break() || progress.done {
            return progress;
        }
    }
}
