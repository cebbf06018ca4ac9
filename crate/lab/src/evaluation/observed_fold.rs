//! Cross-validation in which a trained model observes the trial held out: no frame of the trial is trained
//! on.

use crate::evaluation::cross_validation::{trained, training_of, trials_of};
use crate::evaluation::error::EvaluationError;
use crate::evaluation::fold_model::fold_model;
use crate::evaluation::outcome::ObservedStart;
use crate::evaluation::training_trials::TrainingTrials;
use nalgebra::DMatrix;
use vcgpdm::internals::provenance;
use vcgpdm::models::{Body, Dataset, Model, Movements, Progress, RolloutRequest, Settings, Source, dtw_mse};
use vcgpdm::motion::Clip;
use vcgpdm::motion::parts::PartSpec;

/// One trial held out and observed.
#[derive(Clone, Debug)]
pub struct ObservedFold {
    training: TrainingTrials,
    frames_per_second: f64,
    /// All columns of the trial held out [T x D].
    actual: DMatrix<f64>,
}

impl ObservedFold {
    /// The trial `held_out`, counted from 0, against the first `training_trials` of the others.
    ///
    /// # Errors
    /// The trial does not exist, or the trials cannot be trained on together at this frame rate.
    pub fn new(
        trials: &[Clip],
        held_out: usize,
        training_trials: usize,
        parts: &[PartSpec],
        frames_per_second: f64,
    ) -> Result<Self, EvaluationError> {
        let (trial, others) = trials_of(trials, held_out, training_trials)?;
        let sources: Vec<Source> = others.into_iter().map(Source::from).collect();
        let dataset = Dataset::new(&sources, parts, frames_per_second)?;
        let training = TrainingTrials::new(&dataset);
        let actual = training.body().encode(trial)?;
        Ok(Self { training, frames_per_second, actual })
    }

    /// The training data, without any frame of the trial held out.
    pub fn movements(&self) -> &Movements {
        self.training.movements()
    }

    /// The body with the parts of the fold. A model of the whole body has one part.
    pub fn body(&self) -> &Body {
        self.training.body()
    }

    /// All columns of the trial held out [T x D].
    pub fn actual(&self) -> &DMatrix<f64> {
        &self.actual
    }

    /// Trains a candidate. `watch` is called after every step; if it returns false, there is no model.
    ///
    /// # Errors
    /// The candidate cannot be trained on these trials.
    pub fn train(
        &self,
        candidate: &Settings,
        seed: u32,
        watch: &mut dyn FnMut(&Progress) -> bool,
    ) -> Result<Option<Model>, EvaluationError> {
        let learner = training_of(&self.training, candidate, seed)?;
        let Some(learner) = trained(learner, watch) else { return Ok(None) };
        let provenance = provenance(candidate.clone(), seed, self.frames_per_second, &learner.progress());
        Ok(Some(fold_model(learner.model()?, self.body(), provenance)?))
    }

    /// The error of a rollout whose start latents the model infers from the first `start_frames` frames of
    /// the trial held out. `seconds` is a clock.
    ///
    /// # Errors
    /// The model is no vCGPDM or vGPDM, or the rollout cannot be made or scored.
    pub fn observed_start(
        &self,
        model: &Model,
        start_frames: usize,
        seconds: &dyn Fn() -> f64,
    ) -> Result<ObservedStart, EvaluationError> {
        let begin = seconds();
        let coupled = model.coupled().ok_or(EvaluationError::NoFilter { model: model.kind().id() })?;
        let frames = self.actual.nrows();
        let first = self.actual.rows(0, start_frames.min(frames)).into_owned();
        let start = Some(coupled.latents_of(&first)?);
        let rollout = coupled.rollout(&RolloutRequest { frames, start, ..RolloutRequest::default() })?;
        let seconds = seconds() - begin;
        Ok(ObservedStart { dtw_mse: dtw_mse(&rollout.y, &self.actual)?.dtw_mse, seconds })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::cross_validation::START_FRAMES;
    use vcgpdm::models::{DmpSettings, VariationalSettings};
    use vcgpdm::motion::{parts, samples};

    fn trials() -> Vec<Clip> {
        samples::list().iter().take(3).map(|s| samples::clip(s.id).unwrap()).collect()
    }

    fn lower_upper(trials: &[Clip]) -> Vec<PartSpec> {
        parts::presets(&trials[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts
    }

    fn settings() -> VariationalSettings {
        VariationalSettings {
            latent: 2,
            dynamics_ips: 6,
            pose_ips: 6,
            max_iterations: 40,
            ..VariationalSettings::default()
        }
    }

    /// The same seed gives the same error, for a model of parts and for one of the whole body.
    #[test]
    fn starts_from_observed_frames_and_repeats_to_the_last_bit() {
        let trials = trials();
        let fold = ObservedFold::new(&trials, 1, 2, &lower_upper(&trials), 20.0).unwrap();
        for candidate in [Settings::Vcgpdm(settings()), Settings::Vgpdm(settings())] {
            let error = || {
                let model = fold.train(&candidate, 3, &mut |_| true).unwrap().unwrap();
                fold.observed_start(&model, START_FRAMES, &|| 0.0).unwrap().dtw_mse
            };
            let first = error();
            assert!(first.is_finite() && first > 0.0, "{first}");
            assert_eq!(first.to_bits(), error().to_bits(), "{candidate:?}");
        }
    }

    /// Whatever the trial held out shows, the training data stay the same.
    #[test]
    fn does_not_train_on_any_frame_of_the_trial_held_out() {
        let mut trials = trials();
        let parts = lower_upper(&trials);
        let fps = 1.0 / trials[1].frame_time;
        let fold = |trials: &[Clip]| ObservedFold::new(trials, 1, 2, &parts, fps).unwrap();
        let before = fold(&trials);
        assert_eq!(before.movements().y[0].nrows(), trials[0].frames() + trials[2].frames());
        for frame in 0..trials[1].frames() {
            let still = trials[2].values.row(0).into_owned();
            trials[1].values.row_mut(frame).copy_from(&still);
        }
        let after = fold(&trials);
        assert_ne!(after.actual(), before.actual());
        assert_eq!(after.movements().y, before.movements().y);
        assert_eq!(after.body().column_means, before.body().column_means);
    }

    #[test]
    fn refuses_models_without_a_filter_and_trials_that_do_not_exist() {
        let trials = trials();
        let parts = lower_upper(&trials);
        let fold = ObservedFold::new(&trials, 1, 2, &parts, 20.0).unwrap();
        let dmp = Settings::DmpRhythmic(DmpSettings { bases: 5 });
        assert!(fold.train(&dmp, 0, &mut |_| false).unwrap().is_none());
        let model = fold.train(&dmp, 0, &mut |_| true).unwrap().unwrap();
        let error = fold.observed_start(&model, START_FRAMES, &|| 0.0).unwrap_err().to_string();
        assert_eq!(error, "expected a vcgpdm or vgpdm model, found a dmp-rhythmic model");
        let error = ObservedFold::new(&trials, 0, 3, &parts, 20.0).unwrap_err().to_string();
        assert_eq!(error, "expected from 1 to 2 trials to train on, found 3");
    }
}
