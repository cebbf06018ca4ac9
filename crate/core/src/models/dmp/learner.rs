//! Trainings of dynamic movement primitives: one regression.

use crate::gp::NumericsError;
use crate::models::data::movements::{Movements, split, split_trials};
use crate::models::data::phase::Trial;
use crate::models::dmp::model::Dmp;
use crate::models::errors::{TrainingError, in_range};
use crate::models::rollout::request::Handles;
use crate::models::search::Setbacks;
use crate::models::training::interface::Training;
use crate::models::training::progress::{EndReason, Progress};
use crate::models::training::settings::{DmpSettings, MOST_BASES};

/// The regression of one kind from trials, numbers of columns and the number of bases.
pub(super) type Fit = fn(&[Trial], &[usize], usize) -> Result<Dmp, NumericsError>;

/// A training of dynamic movement primitives in a single step.
pub struct DmpLearner {
    trials: Vec<Trial>,
    columns: Vec<usize>,
    fit: Fit,
    bases: usize,
    fitted: Option<Dmp>,
    error: f64,
    reason: Option<EndReason>,
}

impl DmpLearner {
    /// A training before its step. `fit` is [`Dmp::discrete`] or [`Dmp::rhythmic`].
    ///
    /// # Errors
    ///
    /// When the number of bases is out of its range, or the model cannot learn from the movements.
    pub fn new(movements: &Movements, fit: Fit, settings: &DmpSettings) -> Result<Self, TrainingError> {
        in_range("the number of bases", settings.bases, MOST_BASES)?;
        let (trials, columns) = split_trials(movements)?;
        let (bases, error) = (settings.bases, f64::INFINITY);
        Ok(Self { trials, columns, fit, bases, fitted: None, error, reason: None })
    }

    fn fit(&self) -> Result<Dmp, NumericsError> {
        (self.fit)(&self.trials, &self.columns, self.bases)
    }

    /// The model; before the step, or after a step that failed, it is fitted here to return the error.
    ///
    /// # Errors
    ///
    /// When a covariance of the regression cannot be factorised.
    pub fn fitted(&self) -> Result<Dmp, NumericsError> {
        self.fitted.clone().map_or_else(|| self.fit(), Ok)
    }

    /// Mean squared difference between the whole training trials and the model's rollouts of them.
    fn training_error(&self, model: &Dmp) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for (s, trial) in self.trials.iter().enumerate().filter(|(_, trial)| trial.whole) {
            let Ok(parts) = model.rollout(s, trial.y.nrows(), &Handles::default()) else {
                return f64::INFINITY;
            };
            for (part, actual) in parts.iter().zip(split(&trial.y, &self.columns)) {
                sum += (part - actual).norm_squared();
            }
            count += trial.y.len() as f64;
        }
        sum / count
    }
}

impl Training for DmpLearner {
    fn step(&mut self) -> Progress {
        if self.reason.is_none() {
            match self.fit() {
                Ok(fitted) => {
                    self.error = self.training_error(&fitted);
                    self.reason = Some(EndReason::Regression);
                    self.fitted = Some(fitted);
                }
                Err(error) => self.reason = Some(EndReason::Failed { primitives: None, error }),
            }
        }
        self.progress()
    }

    /// The objective is minus the mean squared error of the training trials.
    fn progress(&self) -> Progress {
        let done = self.reason.is_some();
        Progress {
            iteration: usize::from(done),
            max_iterations: 1,
            evaluations: 0,
            setbacks: Setbacks::default(),
            objective: -self.error,
            best: -self.error,
            terms: None,
            phase: None,
            done,
            reason: self.reason.clone(),
            fraction: if done { 1.0 } else { 0.0 },
        }
    }
}
