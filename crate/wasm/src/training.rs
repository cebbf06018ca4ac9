//! Trainings: the clips, the settings, step by step.

use crate::models::dataset::{Dataset, Source};
use crate::models::motion_model::MotionModel;
use crate::models::variational::trainer::{
    Trainer as Training, TrainingProgress as Progress, TrainingSettings as Settings,
};
use crate::motion::clip::Clip as MotionClip;
use crate::wasm::clip::Clip;
use crate::wasm::model::Model;
use crate::wasm::{PartSpec, Terms, error, flat, parts, read, terms};
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

/// What training is asked to do.
#[derive(Clone, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct TrainingSettings {
    pub parts: Vec<PartSpec>,
    /// Latent dimensions Q of every part.
    pub latent: usize,
    /// Dynamics inducing points K of every expert.
    pub dynamics_ips: usize,
    /// Pose inducing points L of every part.
    pub pose_ips: usize,
    /// Order p of the dynamics.
    pub order: usize,
    /// The clips are brought to about this rate.
    pub frames_per_second: f64,
    /// The seed of everything random, a whole number from 0 to 4294967295.
    pub seed: u32,
    /// Most iterations of the optimiser.
    pub max_iterations: usize,
}

/// How far training is.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
#[serde(rename_all = "camelCase")]
pub struct TrainingProgress {
    pub iteration: usize,
    pub max_iterations: usize,
    pub evaluations: usize,
    /// The bound now, in nats.
    pub bound: f64,
    /// The best so far.
    pub best: f64,
    /// The terms of the best.
    pub terms: Terms,
    /// What is being optimised, in plain words.
    pub phase: String,
    pub done: bool,
    /// Why it ended, in plain words.
    pub reason: Option<String>,
    /// Share of the iterations used, 0 to 1. Time left is at most elapsed * (1 - fraction) / fraction.
    pub fraction: f64,
}

pub(super) fn progress(p: Progress) -> TrainingProgress {
    TrainingProgress {
        iteration: p.iteration,
        max_iterations: p.max_iterations,
        evaluations: p.evaluations,
        bound: p.bound,
        best: p.best,
        terms: terms(&p.terms),
        phase: p.phase,
        done: p.done,
        reason: p.reason,
        fraction: p.fraction,
    }
}

/// The clips that a model is trained on, one sequence each.
#[wasm_bindgen]
#[derive(Default)]
pub struct TrainingSet {
    pub(super) clips: Vec<MotionClip>,
}

#[wasm_bindgen]
impl TrainingSet {
    /// An empty set.
    #[wasm_bindgen(constructor)]
    pub fn new() -> TrainingSet {
        TrainingSet::default()
    }

    /// Adds a clip. Throws the reason when its body differs from the first clip's; the set stays as it was.
    pub fn add(&mut self, clip: &Clip) -> Result<(), JsError> {
        if let Some(first) = self.clips.first() {
            first.skeleton.same_body(&clip.clip.skeleton).map_err(|reason| {
                error(format!("{} cannot be trained together with {}: {reason}", clip.clip.name, first.name))
            })?;
        }
        self.clips.push(clip.clip.clone());
        Ok(())
    }

    /// How many clips there are.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> usize {
        self.clips.len()
    }
}

/// A training under way.
#[wasm_bindgen]
pub struct Trainer {
    dataset: Dataset,
    training: Training,
    frames_per_second: f64,
}

#[wasm_bindgen]
impl Trainer {
    /// Prepares the clips and finds the starting point.
    #[wasm_bindgen(constructor)]
    pub fn new(clips: &TrainingSet, settings: Ts<TrainingSettings>) -> Result<Trainer, JsError> {
        let settings = read("settings", &settings)?;
        let sources: Vec<Source> =
            clips.clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
        let parts = parts(&settings.parts);
        let frames_per_second = settings.frames_per_second;
        let dataset = Dataset::new(&sources, &parts, frames_per_second).map_err(error)?;
        let settings = Settings {
            latent: settings.latent,
            dynamics_ips: settings.dynamics_ips,
            pose_ips: settings.pose_ips,
            order: settings.order,
            seed: settings.seed,
            max_iterations: settings.max_iterations,
        };
        let training = Training::new(dataset.y.clone(), dataset.lengths(), settings)
            .map_err(|reason| error(dataset.refusal(reason)))?;
        Ok(Trainer { dataset, training, frames_per_second })
    }

    /// One iteration of the optimiser: a few milliseconds to some tens.
    pub fn step(&mut self) -> Result<Ts<TrainingProgress>, JsError> {
        progress(self.training.step()).into_ts().map_err(error)
    }

    /// The best model so far, at any time.
    pub fn model(&self) -> Result<Model, JsError> {
        let model =
            MotionModel::trained(&self.dataset, &self.training, self.frames_per_second).map_err(error)?;
        Ok(Model { model: Rc::new(model) })
    }

    /// Latent means of the training frames at the best so far [frames x Q] of one part, sequences one after the other.
    pub fn latents(&self, part: usize) -> Result<Vec<f64>, JsError> {
        let params = self.training.best();
        let part = params.parts.get(part).ok_or_else(|| error(format!("there is no part {part}")))?;
        Ok(flat(&part.latents.mean))
    }
}
