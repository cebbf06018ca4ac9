//! Trainings of dynamic movement primitives: one regression.

use crate::gp::NumericsError;
use crate::models::data::movements::Movements;
use crate::models::data::movements::split_trials;
use crate::models::data::phase::Trial;
use crate::models::dmp::Canonical;
use crate::models::dmp::discrete::DmpDiscrete;
use crate::models::dmp::rhythmic::DmpRhythmic;
use crate::models::fitted::fitted_model::FittedModel;
use crate::models::training::error::{TrainingError, in_range};
use crate::models::training::learner::Learner;
use crate::models::training::progress::{EndReason, Progress, Setbacks};
use crate::models::training::settings::{DmpSettings, MOST_BASES};
use nalgebra::DMatrix;

/// A training of dynamic movement primitives in a single step.
pub struct DmpLearner {
    trials: Vec<Trial>,
    columns: Vec<usize>,
    canonical: Canonical,
    bases: usize,
    fitted: Option<FittedModel>,
    error: f64,
    reason: Option<EndReason>,
}

impl DmpLearner {
    /// A training before its step.
    ///
    /// # Errors
    ///
    /// When the number of bases is out of its range, or the model cannot learn from the movements.
    pub fn new(
        movements: &Movements,
        canonical: Canonical,
        settings: &DmpSettings,
    ) -> Result<Self, TrainingError> {
        in_range("the number of bases", settings.bases, MOST_BASES)?;
        let (trials, columns) = split_trials(movements)?;
        let (bases, error) = (settings.bases, f64::INFINITY);
        Ok(Self { trials, columns, canonical, bases, fitted: None, error, reason: None })
    }

    fn fit(&self) -> Result<FittedModel, NumericsError> {
        let (trials, columns, bases) = (&self.trials, &self.columns, self.bases);
        Ok(match self.canonical {
            Canonical::Discrete => {
                FittedModel::DmpDiscrete(Box::new(DmpDiscrete::fit(trials, columns, bases)?))
            }
            Canonical::Rhythmic => {
                FittedModel::DmpRhythmic(Box::new(DmpRhythmic::fit(trials, columns, bases)?))
            }
        })
    }

    /// Mean squared difference between the whole training trials and the model's rollouts of them.
    fn training_error(&self, model: &FittedModel) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for (s, trial) in self.trials.iter().enumerate().filter(|(_, trial)| trial.whole) {
            let Ok(parts) = model.rollout(s, trial.y.nrows()) else { return f64::INFINITY };
            let mut at = 0;
            for part in parts {
                let actual: DMatrix<f64> = trial.y.columns(at, part.ncols()).into_owned();
                at += part.ncols();
                sum += (part - actual).norm_squared();
            }
            count += trial.y.len() as f64;
        }
        sum / count
    }
}

impl Learner for DmpLearner {
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

    fn model(&self) -> Result<FittedModel, NumericsError> {
        // Before the step, or after a step that failed, fit here to return the error.
        self.fitted.clone().map_or_else(|| self.fit(), Ok)
    }
}
