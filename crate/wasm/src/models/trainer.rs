//! Trainings of clips or tables, step by step, and their progress.

use crate::data::clip::TrainingSet;
use crate::data::tables::{TablePart, parts_of_columns};
use crate::models::model::Model;
use crate::models::settings::{Task, body_parts, settings_from_js};
use crate::models::trained::Trained;
use crate::values::arguments::Whole;
use crate::values::convert::{flat, from_js, to_js};
use crate::values::error::{ErrorCode, VcgpdmError};
use std::sync::Arc;
use vcgpdm_core::models::Trainer as BodyTrainer;
use vcgpdm_core::models::{Dataset, DatasetError, Source, VariationalSettings};
use vcgpdm_core::series::Columns;
use vcgpdm_lab::evaluation::TrainingTrials;
use wasm_bindgen::prelude::*;

enum Training {
    Body(BodyTrainer, TrainingTrials),
    Tables(BodyTrainer<Columns>, TrainingTrials<Columns>),
}

/// Calls the training of a body or of tables.
macro_rules! either {
    ($training:expr, $trainer:ident => $call:expr) => {
        match $training {
            Training::Body($trainer, _) => $call,
            Training::Tables($trainer, _) => $call,
        }
    };
}

/// A training of a vCGPDM, or of a vGPDM where there is one part.
#[wasm_bindgen]
pub struct Trainer {
    training: Training,
}

#[wasm_bindgen]
impl Trainer {
    /// Prepares the clips or tables and finds the starting point.
    #[wasm_bindgen(constructor)]
    pub fn new(
        set: &TrainingSet,
        #[wasm_bindgen(unchecked_optional_param_type = "TrainingOptions | TableTrainingOptions")]
        settings: JsValue,
    ) -> Result<Trainer, VcgpdmError> {
        if set.clips.is_empty() && set.tables.is_empty() {
            return Err(DatasetError::Empty.into());
        }
        let training = if set.tables.is_empty() {
            let skeleton = &set.clips[0].skeleton;
            let sources: Vec<Source> = set.clips.iter().map(Source::from).collect();
            let read = |usual: &VariationalSettings| {
                settings_from_js(&settings, usual, |parts| body_parts(parts, skeleton))
            };
            // The data set depends on some of the options, and the defaults of the others on the data set.
            let (Task { parts, frames_per_second, seed }, _) = read(&VariationalSettings::default())?;
            let dataset = Dataset::new(&sources, &parts, frames_per_second)?;
            let (_, settings) = read(&VariationalSettings::for_dataset(&dataset))?;
            let trainer = BodyTrainer::new(&dataset, &settings.into(), seed)?;
            Training::Body(trainer, TrainingTrials::new(&dataset))
        } else {
            let (task, settings) = settings_from_js(&settings, &VariationalSettings::default(), |parts| {
                if parts.is_undefined() {
                    return Ok(vec![TablePart::all(&set.tables[0])]);
                }
                from_js(ErrorCode::Parts, "parts", parts)
            })?;
            let parts = parts_of_columns(&set.tables, &task.parts)?;
            let dataset = Dataset::of_tables(&set.tables, &parts, task.frames_per_second)?;
            let trainer = BodyTrainer::new(&dataset, &settings.into(), task.seed)?;
            Training::Tables(trainer, TrainingTrials::new(&dataset))
        };
        Ok(Trainer { training })
    }

    /// One step: an iteration of the optimiser, a few milliseconds to some tens, or a round of own rollouts.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        to_js(&either!(&mut self.training, trainer => trainer.step()))
    }

    /// Allows this many more iterations. The training continues where it stopped, as if they had been allowed
    /// from the beginning.
    pub fn extend(&mut self, iterations: &Whole) -> Result<(), VcgpdmError> {
        let iterations = iterations.count(ErrorCode::Training, "the number of iterations")?;
        either!(&mut self.training, trainer => trainer.extend(iterations));
        Ok(())
    }

    /// What the user should know, in sentences without a full stop: that a clip does not move or was given
    /// twice, that a part never changes, and which settings are more than the data allow and were reduced.
    pub fn notices(&self) -> Vec<String> {
        either!(&self.training, trainer => trainer.warnings())
    }

    /// The best model so far, at any time.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        let model = match &self.training {
            Training::Body(trainer, _) => Trained::Body(Arc::new(trainer.finish()?)),
            Training::Tables(trainer, _) => Trained::Table(Arc::new(trainer.finish()?)),
        };
        Ok(Model { model })
    }

    /// How well rollouts of the best model so far repeat the clips or tables: the mean over them of the squared
    /// error after time warping. Undefined if a rollout cannot be scored.
    #[wasm_bindgen(js_name = rolloutError)]
    pub fn rollout_error(&self) -> Result<Option<f64>, VcgpdmError> {
        Ok(match &self.training {
            Training::Body(trainer, trials) => trials.error(&trainer.finish()?.fitted),
            Training::Tables(trainer, trials) => trials.error(&trainer.finish()?.fitted),
        })
    }

    /// Latent means of the training frames of one part at the best bound so far [frames x Q], sequences one
    /// after the other.
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        either!(&self.training, trainer => {
            let parts = 0..trainer.part_count();
            let latents: Vec<_> = parts.filter_map(|part| trainer.latents(part)).collect();
            Ok(flat(part.part_of(ErrorCode::Training, &latents)?))
        })
    }
}
