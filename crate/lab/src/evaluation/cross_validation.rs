//! Leave-one-trial-out cross-validation (Velychko et al. 2018, section 5.3): train on all trials but one, and
//! on the first frames of the trial held out as one more sequence; roll out from these frames for the length
//! of the trial; score.

use crate::evaluation::candidate::Candidate;
use crate::evaluation::details::Predicted;
use crate::evaluation::error::EvaluationError;
use crate::evaluation::outcome::Outcome;
use crate::evaluation::predictor::Predictor;
use crate::evaluation::training_trials::{TrainingTrials, fold_model};
use nalgebra::DMatrix;
use serde::de::IgnoredAny;
use std::borrow::Cow;
use vcgpdm_core::models::{
    Body, Dataset, DatasetError, EndReason, FittedModel, Learner, Model, Movements, Progress, Provenance,
    RolloutError, Setbacks, Settings, Source, score_and_columns,
};
use vcgpdm_core::motion::Clip;
use vcgpdm_core::motion::parts::PartSpec;

/// Default number of first frames from which a trial is predicted. Velychko et al. (2018) have 2.
pub const START_FRAMES: usize = 5;

/// One trial held out: the training data, and the trial to predict.
#[derive(Clone, Debug)]
pub struct Fold {
    /// The trials trained on, and the first frames of the trial held out as the last sequence.
    training: TrainingTrials,
    /// The frame rate asked for.
    frames_per_second: f64,
    /// All columns of the trial held out [T x D].
    actual: DMatrix<f64>,
}

impl Fold {
    /// The trial `held_out`, counted from 0, predicted from its first `start_frames`, against the first
    /// `training_trials` of the others.
    ///
    /// # Errors
    /// The trial does not exist, or the trials cannot be trained on together at this frame rate.
    pub fn new<'a>(
        trials: &'a [Clip],
        held_out: usize,
        training_trials: usize,
        parts: &[PartSpec],
        frames_per_second: f64,
        start_frames: usize,
    ) -> Result<Self, EvaluationError> {
        let (trial, others) = trials_of(trials, held_out, training_trials)?;
        // The parts name joints by their places in the first trial.
        let in_order = |clip: &'a Clip| clip.in_order_of(&trials[0].skeleton);
        let (trial, others): (_, Vec<Cow<Clip>>) =
            (in_order(trial), others.into_iter().map(in_order).collect());
        let mut sources: Vec<Source> = others.iter().map(|clip| Source::from(&**clip)).collect();
        sources.push(Source { clip: &trial, first_frames: Some(start_frames) });
        let dataset = Dataset::new(&sources, parts, frames_per_second)?;
        let actual = dataset.mapping.encode(&trial.resample(1.0 / dataset.frame_time)?)?.y;
        Ok(Self { training: TrainingTrials::new(&dataset), frames_per_second, actual })
    }

    /// The training data; the last sequence has the first frames of the trial held out.
    pub fn movements(&self) -> &Movements {
        self.training.movements()
    }

    /// Converts columns to poses.
    pub fn body(&self) -> &Body {
        self.training.body()
    }

    /// All columns of the trial held out [T x D].
    pub fn actual(&self) -> &DMatrix<f64> {
        &self.actual
    }

    /// All columns that the model predicts for the trial held out [T x D].
    ///
    /// # Errors
    /// The model cannot be rolled out for the length of the trial.
    pub fn predict(&self, model: &dyn Predictor) -> Result<DMatrix<f64>, RolloutError> {
        self.training.rollout(model, self.movements().sequences.len() - 1, self.actual.nrows())
    }

    /// The training of a candidate in this fold, before its first step.
    ///
    /// # Errors
    /// The candidate cannot be trained on these trials; the error names the clip if one of them is the
    /// reason.
    pub fn learner(&self, candidate: &Settings, seed: u32) -> Result<Box<dyn Learner>, EvaluationError> {
        training_of(&self.training, candidate, seed)
    }

    /// The model of a candidate whose training is this far, for a file.
    ///
    /// # Errors
    /// A covariance of the model cannot be factorised.
    pub fn model(
        &self,
        fitted: FittedModel,
        candidate: &Settings,
        seed: u32,
        training: &Progress,
    ) -> Result<Model, EvaluationError> {
        let provenance = Provenance::of_training(candidate.clone(), seed, self.frames_per_second, training);
        Ok(fold_model(fitted, self.body(), provenance)?)
    }

    /// Trains a candidate and scores its prediction. `watch` is called after every step; if it returns false,
    /// the training ends without an outcome. `seconds` is a clock.
    ///
    /// # Errors
    /// The candidate cannot be trained, or its prediction cannot be scored.
    pub fn evaluate(
        &self,
        candidate: &Candidate,
        seed: u32,
        seconds: &dyn Fn() -> f64,
        watch: &mut dyn FnMut(&Progress) -> bool,
    ) -> Result<Option<Outcome>, EvaluationError> {
        let begin = seconds();
        let settings = match candidate {
            Candidate::Model(settings) => settings,
            Candidate::Rival(rival) => {
                let fitted = rival.fit(self.movements());
                let model =
                    fitted.map_err(|reason| DatasetError::from_training(reason, &self.body().sequences))?;
                let trained = seconds() - begin;
                let error = self.training.error(&*model);
                let outcome = self.scored(&*model, &regression(error), trained, error)?;
                return Ok(Some(self.with_details(outcome, &*model)));
            }
        };
        let Some(learner) = trained(self.learner(settings, seed)?, watch) else { return Ok(None) };
        let model = learner.model()?;
        let trained = seconds() - begin;
        let outcome = self.outcome(&model, &learner.progress(), trained)?;
        Ok(Some(self.with_details(outcome, &model)))
    }

    fn with_details(&self, outcome: Outcome, model: &dyn Predictor) -> Outcome {
        let predicted = Predicted { training: &self.training, actual: &self.actual };
        Outcome { details: predicted.details(model), ..outcome }
    }

    /// The outcome of a model whose training ended with this progress after `seconds` seconds.
    ///
    /// # Errors
    /// The prediction cannot be made or scored, or a number of the outcome is not finite.
    pub fn outcome(
        &self,
        model: &dyn Predictor,
        training: &Progress,
        seconds: f64,
    ) -> Result<Outcome, EvaluationError> {
        self.scored(model, training, seconds, self.training.error(model))
    }

    /// The same, when the error on the training trials is known.
    fn scored(
        &self,
        model: &dyn Predictor,
        training: &Progress,
        seconds: f64,
        training_mse: Option<f64>,
    ) -> Result<Outcome, EvaluationError> {
        if !(seconds.is_finite() && seconds >= 0.0) {
            return Err(EvaluationError::Seconds(seconds));
        }
        let (score, columns) = score_and_columns(&self.predict(model)?, &self.actual)?;
        let layout = &self.body().layout;
        let part = |part: usize| {
            let columns = layout.columns(part).iter().map(|column| columns[*column]);
            columns.sum::<f64>() / layout.columns(part).len().max(1) as f64
        };
        let outcome = Outcome {
            score,
            terms: model.terms().cloned(),
            part_errors: (0..self.movements().y.len()).map(part).collect(),
            bound: model.bound(),
            objective: training.best,
            iterations: training.iteration,
            seconds,
            frames: self.movements().sequences.iter().map(|s| s.frames).sum(),
            stored_numbers: model.stored_numbers(),
            reason: training.reason.as_ref().map(ToString::to_string),
            training_mse,
            details: None,
            ignored: IgnoredAny,
        };
        // JSON cannot store such numbers. Squares can overflow though the predicted columns are finite.
        for (what, found) in [
            ("its mean squared error after time warping", Some(outcome.score.dtw_mse)),
            ("its mean squared error", Some(outcome.score.mse)),
            ("the trial's variance", Some(outcome.score.variance)),
            ("the model's bound", outcome.bound),
            ("what the training maximised", Some(outcome.objective)),
        ] {
            if let Some(found) = found.filter(|found| !found.is_finite()) {
                return Err(EvaluationError::NotFinite { what, found });
            }
        }
        Ok(outcome)
    }
}

/// The progress of a rival, which learns in one step. Its objective is minus the error of its rollouts on the
/// training trials.
fn regression(training_mse: Option<f64>) -> Progress {
    let objective = -training_mse.unwrap_or(f64::INFINITY);
    Progress {
        iteration: 1,
        max_iterations: 1,
        evaluations: 0,
        objective,
        best: objective,
        terms: None,
        phase: None,
        done: true,
        reason: Some(EndReason::Regression),
        setbacks: Setbacks::default(),
        fraction: 1.0,
    }
}

/// The trial `held_out`, counted from 0, and the first `training_trials` of the others.
fn trials_of(
    trials: &[Clip],
    held_out: usize,
    training_trials: usize,
) -> Result<(&Clip, Vec<&Clip>), EvaluationError> {
    if held_out >= trials.len() || trials.len() < 2 {
        return Err(EvaluationError::Trial { count: trials.len(), found: held_out });
    }
    let most = trials.len() - 1;
    if !(1..=most).contains(&training_trials) {
        return Err(EvaluationError::TrainingTrials { most, found: training_trials });
    }
    let others = trials.iter().enumerate().filter(|(k, _)| *k != held_out).map(|(_, clip)| clip);
    Ok((&trials[held_out], others.take(training_trials).collect()))
}

/// The training of a candidate on these trials, before its first step.
fn training_of(
    training: &TrainingTrials,
    candidate: &Settings,
    seed: u32,
) -> Result<Box<dyn Learner>, EvaluationError> {
    let (kind, movements) = (candidate.kind(), training.movements());
    if kind.is_coupled() && movements.y.len() == 1 {
        return Err(EvaluationError::OnePart { model: kind.id() });
    }
    let learner = candidate.learner(movements, seed);
    Ok(learner.map_err(|reason| DatasetError::from_training(reason, &training.body().sequences))?)
}

/// The learner after its last step. `watch` is called after every step; if it returns false, there is none.
fn trained(
    mut learner: Box<dyn Learner>,
    watch: &mut dyn FnMut(&Progress) -> bool,
) -> Option<Box<dyn Learner>> {
    loop {
        let progress = learner.step();
        if !watch(&progress) {
            return None;
        }
        if progress.done {
            return Some(learner);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm_core::models::{
        DmpSettings, MapSettings, ModelKind, Sequence, TmpSettings, VariationalSettings,
    };
    use vcgpdm_core::motion::{parts, samples};

    fn trials() -> Vec<Clip> {
        samples::list().iter().take(3).map(|s| samples::clip(s.id).unwrap()).collect()
    }

    /// A candidate of each kind of model.
    fn of_each_kind(gpdm: VariationalSettings, point: MapSettings) -> [Settings; 7] {
        [
            Settings::Vcgpdm(gpdm.clone()),
            Settings::Vgpdm(gpdm),
            Settings::MapGpdm(point.clone()),
            Settings::MapCgpdm(point),
            Settings::Tmp(TmpSettings { primitives: Some(4), ..TmpSettings::default() }),
            Settings::DmpDiscrete(DmpSettings { bases: 20 }),
            Settings::DmpRhythmic(DmpSettings { bases: 20 }),
        ]
    }

    #[test]
    fn predicts_a_walk_with_every_model() {
        predict_from(START_FRAMES);
    }

    /// As in Velychko et al. (2018): two frames are a history without a transition.
    #[test]
    fn predicts_a_walk_from_two_frames_with_every_model() {
        predict_from(2);
    }

    fn predict_from(start_frames: usize) {
        let trials = trials();
        let parts =
            &parts::presets(&trials[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
        let fold = Fold::new(&trials, 1, 2, parts, 20.0, start_frames).unwrap();
        assert_eq!(fold.movements().sequences.last(), Some(&Sequence { frames: start_frames, whole: false }));
        let gpdm = VariationalSettings {
            latent: 2,
            order: 2,
            dynamics_ips: 6,
            pose_ips: 6,
            max_iterations: 40,
            ..Default::default()
        };
        let point = MapSettings { latent: 2, order: 2, max_iterations: 3, balanced: false, linear: true };
        for candidate in of_each_kind(gpdm, point) {
            let mut steps = 0;
            let mut watch = |progress: &Progress| {
                steps += 1;
                progress.best.is_finite() || steps < 3
            };
            let outcome = fold.evaluate(&candidate.clone().into(), 1, &|| 0.0, &mut watch).unwrap().unwrap();
            let score = outcome.score;
            assert!(score.dtw_mse.is_finite() && score.variance > 0.0, "{candidate:?}: {score:?}");
            assert!(outcome.stored_numbers > 0 && outcome.frames > 40);
            assert_eq!(
                outcome.terms.as_ref().map(|terms| terms.total()),
                outcome.bound.filter(|_| candidate.is_random())
            );
            // The errors on training trials are smaller.
            assert!(outcome.training_mse.unwrap() < score.variance, "{candidate:?}: {outcome:?}");
            // Together the parts have all columns.
            let widths = fold.movements().y.iter().map(|y| y.ncols() as f64);
            let sum: f64 = outcome.part_errors.iter().zip(widths).map(|(error, width)| error * width).sum();
            let mean = sum / fold.actual().ncols() as f64;
            assert!((mean / score.dtw_mse - 1.0).abs() < 1e-9, "{:?} {}", outcome.part_errors, score.dtw_mse);
            match candidate.kind() {
                ModelKind::Tmp => assert!(outcome.converged().is_some()),
                ModelKind::DmpDiscrete | ModelKind::DmpRhythmic => assert_eq!(outcome.converged(), None),
                _ => assert_eq!(outcome.converged(), Some(false), "{:?}", outcome.reason),
            }
            let text = serde_json::to_string(&candidate).unwrap();
            assert_eq!(serde_json::from_str::<Settings>(&text).unwrap(), candidate);
        }
    }

    /// What a fold predicts is what its model makes after its file was saved and opened, to the last bit.
    #[test]
    fn saves_the_model_of_a_fold() {
        let trials = trials();
        let presets = parts::presets(&trials[0].skeleton);
        // The arms come after the legs, but not in the order of the body's columns.
        let parts = &presets.iter().find(|p| p.id == "legs-trunk-arms").unwrap().parts;
        let fold = Fold::new(&trials, 1, 2, parts, 15.0, START_FRAMES).unwrap();
        let gpdm = VariationalSettings {
            latent: 2,
            dynamics_ips: 5,
            pose_ips: 5,
            max_iterations: 8,
            ..Default::default()
        };
        let point = MapSettings { latent: 2, max_iterations: 2, ..MapSettings::default() };
        for candidate in of_each_kind(gpdm, point) {
            let mut learner = fold.learner(&candidate, 3).unwrap();
            while !learner.step().done {}
            let fitted = learner.model().unwrap();
            let predicted = fold.predict(&fitted).unwrap();
            let model = fold.model(fitted, &candidate, 3, &learner.progress()).unwrap();
            let opened = Model::from_json(&model.to_json().unwrap()).unwrap();
            assert_eq!(opened.provenance.settings, candidate);
            assert_eq!(opened.provenance.objective, learner.progress().best);
            let (last, frames) = (opened.body.sequences.len() - 1, fold.actual().nrows());
            assert_eq!(opened.body.sequences[last].frames, START_FRAMES);
            assert_eq!(opened.rollout(last, frames).unwrap(), predicted, "{candidate:?}");
        }
    }

    /// If the frames to be predicted change, the training data stay the same.
    #[test]
    fn does_not_train_on_the_trial_held_out() {
        let mut trials = trials();
        let parts = &parts::presets(&trials[0].skeleton)[0].parts;
        let fps = 1.0 / trials[1].frame_time;
        let fold = |trials: &[Clip]| Fold::new(trials, 1, 2, parts, fps, START_FRAMES).unwrap();
        let before = fold(&trials);
        let frames = trials[1].frames();
        let others = trials[0].frames() + trials[2].frames();
        assert_eq!(before.movements().y[0].nrows(), others + START_FRAMES);
        for frame in START_FRAMES..frames {
            let still = trials[1].values.row(0).into_owned();
            trials[1].values.row_mut(frame).copy_from(&still);
        }
        let after = fold(&trials);
        assert_ne!(after.actual(), before.actual());
        assert_eq!(after.movements().y, before.movements().y);
    }

    #[test]
    fn has_no_outcome_after_a_stopped_training() {
        let trials = trials();
        let parts = &parts::presets(&trials[0].skeleton)[0].parts;
        let fold = Fold::new(&trials, 0, 1, parts, 20.0, START_FRAMES).unwrap();
        let candidate = Settings::DmpRhythmic(DmpSettings { bases: 5 }).into();
        assert_eq!(fold.evaluate(&candidate, 0, &|| 0.0, &mut |_| false).unwrap(), None);
    }

    #[test]
    fn refuses_a_coupled_model_of_one_part() {
        let trials = trials();
        let parts = &parts::presets(&trials[0].skeleton)[0].parts;
        let fold = Fold::new(&trials, 0, 1, parts, 20.0, START_FRAMES).unwrap();
        let candidate = Settings::Vcgpdm(VariationalSettings::default()).into();
        let error = fold.evaluate(&candidate, 0, &|| 0.0, &mut |_| true).unwrap_err().to_string();
        assert_eq!(error, "expected two parts or more for a vcgpdm model, found 1");
    }

    #[test]
    fn refuses_trials_that_do_not_exist() {
        let trials = trials();
        let parts = &parts::presets(&trials[0].skeleton)[0].parts;
        let error = Fold::new(&trials, 3, 2, parts, 20.0, START_FRAMES).unwrap_err().to_string();
        assert_eq!(
            error,
            "expected a trial from 1 to 3 to hold out, and at least 2 trials, found trial 4 of 3"
        );
        assert!(Fold::new(&trials[..1], 0, 1, parts, 20.0, START_FRAMES).is_err());
        let error = Fold::new(&trials, 0, 3, parts, 20.0, START_FRAMES).unwrap_err().to_string();
        assert_eq!(error, "expected from 1 to 2 trials to train on, found 3");
    }

    /// A model that predicts `value` in all columns.
    fn constant_model(fold: &Fold, value: f64) -> FittedModel {
        let settings = Settings::DmpRhythmic(DmpSettings { bases: 5 });
        let mut learned = fold.learner(&settings, 0).unwrap().model().unwrap();
        let FittedModel::Dmp(model) = &mut learned else { panic!("no DMP") };
        model.weights.fill(0.0);
        model.goal.fill(value);
        for start in &mut model.starts {
            start.spring.position.fill(value);
            start.spring.velocity.fill(0.0);
        }
        learned
    }

    #[test]
    fn refuses_outcomes_with_numbers_that_are_not_finite() {
        let trials = trials();
        let parts = &parts::presets(&trials[0].skeleton)[0].parts;
        let fold = Fold::new(&trials, 0, 1, parts, 20.0, START_FRAMES).unwrap();
        let outcome = |to: f64, best: f64, seconds: f64| {
            let training = Progress {
                iteration: 1,
                max_iterations: 1,
                evaluations: 0,
                objective: best,
                best,
                terms: None,
                phase: None,
                done: true,
                reason: None,
                setbacks: Setbacks::default(),
                fraction: 1.0,
            };
            fold.outcome(&constant_model(&fold, to), &training, seconds).map_err(|error| error.to_string())
        };
        assert!(outcome(1.0, 0.0, 1.0).is_ok());
        let far = outcome(1e200, 0.0, 1.0).unwrap_err();
        assert_eq!(far, "the prediction is not finite: its mean squared error after time warping is inf");
        assert!(outcome(f64::NAN, 0.0, 1.0).unwrap_err().contains("expected finite numbers, found NaN"));
        let unbegun = outcome(1.0, f64::NEG_INFINITY, 1.0).unwrap_err();
        assert_eq!(unbegun, "the prediction is not finite: what the training maximised is -inf");
        for seconds in [-1.0, f64::NAN] {
            let error = outcome(1.0, 0.0, seconds).unwrap_err();
            assert_eq!(error, format!("expected the seconds of the training, from 0, found {seconds}"));
        }
    }
}
