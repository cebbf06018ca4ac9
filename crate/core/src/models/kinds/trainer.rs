//! Trainings of any kind of model on a data set.

use crate::gp::NumericsError;
use crate::models::data::column_mapping::ColumnMapping;
use crate::models::data::dataset::{Dataset, DatasetError};
use crate::models::data::movements::Movements;
use crate::models::errors::TrainingError;
use crate::models::kinds::body::Body;
use crate::models::kinds::fitted_model::FittedModel;
use crate::models::kinds::learners::Learner;
use crate::models::kinds::model::Model;
use crate::models::kinds::own_rollouts::OwnRollouts;
use crate::models::training::progress::{Progress, TrainingPhase};
use crate::models::training::provenance::Provenance;
use crate::models::training::settings::{Settings, VariationalSettings};
use crate::models::variational::{VariationalTrainer, Vcgpdm};
use crate::motion::pose::PoseMapping;
use nalgebra::DMatrix;
use std::ops::ControlFlow;

/// The share of the time that is planned for the iterations; the rest is for learning from own rollouts.
const ITERATIONS_SHARE: f64 = 0.6;

/// A training of any kind of model. It can be stopped after any step; the best model so far is kept. A step is an
/// iteration of the optimiser. If the settings say so, a vCGPDM or vGPDM of a body then learns from its own
/// rollouts in further steps, as [`Model::learn_from_own_rollouts`] does.
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
    /// After the last iteration, if the model learns from its own rollouts.
    rollouts: Option<OwnRollouts>,
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
            rollouts: None,
        })
    }

    /// One step. After the end it does nothing.
    pub fn step(&mut self) -> Progress {
        let mut progress = self.learner.progress();
        if !progress.done {
            progress = self.learner.step();
        } else if let Some(rollouts) = &mut self.rollouts {
            rollouts.step();
        }
        if progress.done && self.rollouts.is_none() && self.learns_from_own_rollouts() {
            self.rollouts = self.own_rollouts(&progress);
        }
        with_rounds(progress, self.learns_from_own_rollouts(), self.rounds())
    }

    /// The share of the rounds of own rollouts that are done, and whether all are.
    fn rounds(&self) -> Option<(f64, bool)> {
        self.rollouts.as_ref().map(|rollouts| (rollouts.fraction(), rollouts.is_done()))
    }

    fn learns_from_own_rollouts(&self) -> bool {
        let asked = self.settings.variational().is_some_and(|settings| settings.own_rollouts);
        asked && self.body.mapping.poses().is_some()
    }

    /// The model of the last iteration before it learns from its own rollouts; `None` if it has none.
    fn own_rollouts(&self, progress: &Progress) -> Option<OwnRollouts> {
        let (fitted, body) = (self.learner.model().ok()?, self.body.with_poses()?);
        OwnRollouts::new(Model { fitted, body, provenance: self.provenance(progress) })
    }

    /// Trains to the end.
    pub fn run(&mut self) -> Progress {
        self.run_with(|_| ControlFlow::Continue(()))
    }

    /// Trains to the end, or until `watch`, which is called after every step, breaks.
    pub fn run_with(&mut self, watch: impl FnMut(&Progress) -> ControlFlow<()>) -> Progress {
        run_with(|| self.step(), watch)
    }

    /// The best model so far.
    ///
    /// # Errors
    ///
    /// When a covariance of the model cannot be factorised.
    pub fn finish(&self) -> Result<Model<S>, NumericsError> {
        let mut provenance = self.provenance(&self.learner.progress());
        let fitted = match self.rollouts.as_ref().and_then(OwnRollouts::best) {
            Some((rounds, model)) => {
                provenance.rollout_rounds = rounds;
                FittedModel::Vcgpdm(Box::new(model.clone()))
            }
            None => self.learner.model()?,
        };
        Ok(Model { fitted, body: self.body.clone(), provenance })
    }

    fn provenance(&self, progress: &Progress) -> Provenance {
        let mut settings = self.settings.clone();
        if let Settings::Vcgpdm(s) | Settings::Vgpdm(s) = &mut settings {
            // `extend` may have raised it.
            s.max_iterations = progress.max_iterations;
        }
        if let (Settings::Vcgpdm(s), 1) = (&settings, self.body.layout.parts().len()) {
            settings = Settings::Vgpdm(s.clone());
        }
        Provenance::of_training(settings, self.seed, self.frames_per_second, progress)
    }

    /// How far the training is.
    pub fn progress(&self) -> Progress {
        with_rounds(self.learner.progress(), self.learns_from_own_rollouts(), self.rounds())
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
        if !self.learner.progress().done {
            self.rollouts = None;
        }
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

impl VariationalTrainer {
    /// The trained model of the best bound so far, on the data set that this training began with.
    ///
    /// # Errors
    ///
    /// When a covariance of the model cannot be factorised.
    pub fn finish<S: ColumnMapping>(&self, dataset: &Dataset<S>) -> Result<Model<S>, NumericsError> {
        let provenance = match dataset.y.len() {
            1 => self.provenance(dataset.frames_per_second).of_one_part(),
            _ => self.provenance(dataset.frames_per_second),
        };
        let fitted = FittedModel::Vcgpdm(Box::new(self.model()?));
        Ok(Model { fitted, body: Body::new(dataset), provenance })
    }
}

/// The progress of a training whose iterations are this far, and which may learn from its own rollouts: `rounds` has
/// the share of the rounds that are done, and whether all are; `None` before the first.
pub(crate) fn with_rounds(progress: Progress, learns: bool, rounds: Option<(f64, bool)>) -> Progress {
    if !learns {
        return progress;
    }
    let (share, ended) = rounds.unwrap_or((0.0, true));
    let done = progress.done && ended;
    let iterations = if progress.done { 1.0 } else { progress.fraction };
    Progress {
        phase: if progress.done && !done { Some(TrainingPhase::OwnRollouts) } else { progress.phase },
        fraction: if done { 1.0 } else { ITERATIONS_SHARE * iterations + (1.0 - ITERATIONS_SHARE) * share },
        done,
        reason: progress.reason.filter(|_| done),
        ..progress
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
