//! Learning dynamic movement primitives: one regression.

use crate::gp::NumericsError;
use crate::models::dmp::Canonical;
use crate::models::dmp::discrete::DmpDiscrete;
use crate::models::dmp::rhythmic::DmpRhythmic;
use crate::models::dmp::spring::ALPHA_Z;
use crate::models::learner::{Learner, LearningProgress, MovementModel, Movements};
use crate::models::phase::Trial;
use crate::models::trials::trials_of;
use crate::models::variational::trainer::TrainingError;
use nalgebra::DMatrix;

const MOST_BASES: usize = 200;

/// What the learning of dynamic movement primitives is asked to do.
#[derive(Clone, Debug, PartialEq)]
pub struct DmpSettings {
    /// Towards a goal or around a centre.
    pub canonical: Canonical,
    /// B, basis functions of each column.
    pub bases: usize,
    /// How fast the discrete system's x fades, from 0.1 to 100; others are brought there.
    pub alpha_x: f64,
}

impl DmpSettings {
    /// 20 bases, and alpha_x = alpha_z / 3.
    pub fn new(canonical: Canonical) -> Self {
        Self { canonical, bases: 20, alpha_x: ALPHA_Z / 3.0 }
    }
}

enum Fitted {
    Discrete(DmpDiscrete),
    Rhythmic(DmpRhythmic),
}

impl Fitted {
    fn model(&self) -> &dyn MovementModel {
        match self {
            Fitted::Discrete(model) => model,
            Fitted::Rhythmic(model) => model,
        }
    }
}

/// A training of dynamic movement primitives: a single step does it all.
pub struct DmpLearner {
    trials: Vec<Trial>,
    columns: Vec<usize>,
    settings: DmpSettings,
    fitted: Option<Fitted>,
    error: f64,
    reason: Option<String>,
}

impl DmpLearner {
    /// Ready to learn.
    pub fn new(movements: &Movements, settings: DmpSettings) -> Result<Self, TrainingError> {
        let found = settings.bases;
        if !(1..=MOST_BASES).contains(&found) {
            return Err(TrainingError::Setting {
                name: "the number of bases",
                lowest: 1,
                highest: MOST_BASES,
                found,
            });
        }
        let (trials, columns) = trials_of(movements)?;
        Ok(Self { trials, columns, settings, fitted: None, error: f64::INFINITY, reason: None })
    }

    fn fit(&self) -> Result<Fitted, NumericsError> {
        let (trials, columns, bases) = (&self.trials, &self.columns, self.settings.bases);
        Ok(match self.settings.canonical {
            Canonical::Discrete => Fitted::Discrete(DmpDiscrete::fit(
                trials,
                columns,
                bases,
                self.settings.alpha_x.clamp(0.1, 100.0),
            )?),
            Canonical::Rhythmic => Fitted::Rhythmic(DmpRhythmic::fit(trials, columns, bases)?),
        })
    }

    /// Mean squared difference of the whole training trials from what the model makes of their starts.
    fn training_error(&self, model: &dyn MovementModel) -> f64 {
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
    fn step(&mut self) -> LearningProgress {
        if self.reason.is_none() {
            match self.fit() {
                Ok(fitted) => {
                    self.error = self.training_error(fitted.model());
                    self.reason = Some("the regression is done".into());
                    self.fitted = Some(fitted);
                }
                Err(error) => self.reason = Some(format!("stopped: {error}")),
            }
        }
        self.progress()
    }

    /// The objective is minus the mean squared error of the training trials.
    fn progress(&self) -> LearningProgress {
        let done = self.reason.is_some();
        LearningProgress {
            iteration: usize::from(done),
            max_iterations: 1,
            objective: -self.error,
            best: -self.error,
            done,
            reason: self.reason.clone(),
            fraction: if done { 1.0 } else { 0.0 },
        }
    }

    fn model(&self) -> Result<Box<dyn MovementModel>, NumericsError> {
        // Before the first step, or after one that failed: learned now, to say why it fails.
        let fresh;
        let fitted = match &self.fitted {
            Some(fitted) => fitted,
            None => {
                fresh = self.fit()?;
                &fresh
            }
        };
        Ok(match fitted {
            Fitted::Discrete(model) => Box::new(model.clone()),
            Fitted::Rhythmic(model) => Box::new(model.clone()),
        })
    }
}
