//! Makes a study from the movements of a comparison.

use crate::data::clip::Clip;
use crate::lab::evaluation::candidate_from_js;
use crate::lab::study::{Study, look, preset};
use crate::values::arguments::{Text, Whole};
use crate::values::convert::from_js;
use crate::values::error::{ErrorCode, VcgpdmError};
use serde::Deserialize;
use vcgpdm::models::ModelKind;
use vcgpdm_lab::evaluation::{Outcome, START_FRAMES};
use vcgpdm_lab::perception::{Maker, StudyMovement};
use wasm_bindgen::prelude::*;

/// A movement for a new study.
#[derive(Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct MadeMovement {
    /// The trial, counted from 0. Its id in the study counts from 1.
    trial: usize,
    /// The name of the trial.
    name: String,
    /// Seconds from one frame to the next.
    frame_time: f64,
}

/// Collects movements for a new study: recorded movements and predictions of held-out trials.
#[wasm_bindgen]
pub struct StudyMaker {
    maker: Maker,
}

#[wasm_bindgen]
impl StudyMaker {
    /// A maker without movements, for the body of this clip. Each movement of the study lasts `seconds`, and
    /// the comparison has `framesPerSecond` frames a second.
    #[wasm_bindgen(constructor)]
    pub fn new(
        body: &Clip,
        seconds: f64,
        #[wasm_bindgen(js_name = framesPerSecond)] frames_per_second: f64,
    ) -> StudyMaker {
        StudyMaker { maker: Maker::new(body.skeleton(), seconds, frames_per_second, START_FRAMES) }
    }

    /// Adds a recorded movement, as `Fold.actual` or `Clip.positions` give it [frames x nodes x 3]. If `seen`
    /// is false, only catch trials show the movement. Throws if the movement is shorter than the movements of
    /// the study.
    #[wasm_bindgen(js_name = addNatural)]
    pub fn add_natural(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "MadeMovement")] movement: JsValue,
        positions: &[f32],
        seen: bool,
    ) -> Result<(), VcgpdmError> {
        let MadeMovement { trial, name, frame_time } = from_js(ErrorCode::Study, "the movement", &movement)?;
        let shown = StudyMovement { trial, name: &name, positions, frame_time };
        Ok(self.maker.natural(&shown, seen)?)
    }

    /// Adds the prediction of a model for the held-out trial, as `Prediction.positions` gives it. If a
    /// candidate has several seeds, the study keeps the seed with the highest `outcome.objective`.
    #[wasm_bindgen(js_name = addGenerated)]
    pub fn add_generated(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "MadeMovement")] movement: JsValue,
        positions: &[f32],
        #[wasm_bindgen(unchecked_param_type = "CandidateOptions")] candidate: JsValue,
        seed: &Whole,
        #[wasm_bindgen(unchecked_param_type = "Outcome")] outcome: JsValue,
    ) -> Result<(), VcgpdmError> {
        let MadeMovement { trial, name, frame_time } = from_js(ErrorCode::Study, "the movement", &movement)?;
        let candidate = candidate_from_js(ErrorCode::Study, "the candidate", &candidate, ModelKind::Vcgpdm)?;
        let outcome: Outcome = from_js(ErrorCode::Study, "the outcome", &outcome)?;
        let seed = seed.get(ErrorCode::Study, "the seed")?;
        let shown = StudyMovement { trial, name: &name, positions, frame_time };
        Ok(self.maker.generated(&shown, &candidate, seed, &outcome)?)
    }

    /// The study of all movements that were added so far.
    pub fn study(
        &self,
        title: &Text,
        #[wasm_bindgen(unchecked_param_type = "StudyPreset")] design: &Text,
        #[wasm_bindgen(unchecked_param_type = "StudyLook", js_name = drawn)] drawn: &Text,
        seed: &Whole,
    ) -> Result<Study, VcgpdmError> {
        let title = title.get(ErrorCode::Study, "the title")?;
        let seed = seed.get(ErrorCode::Study, "the seed")?;
        let study = self.maker.clone().study(&title, preset(design)?, look(drawn)?, seed)?;
        Ok(Study::of(study))
    }
}
