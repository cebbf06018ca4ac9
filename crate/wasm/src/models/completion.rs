//! Recordings of which a model observes some parts and infers the others.

use crate::data::clip::Clip;
use crate::data::clip::bvh_text;
use crate::models::model::Model;
use crate::models::rollout::Rollout;
use crate::models::trained::{Trained, coupled};
use crate::values::arguments::Whole;
use crate::values::convert::{flat, from_js, matrix, rows, to_js};
use crate::values::error::{ErrorCode, VcgpdmError};
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use vcgpdm_core::models::variational::ObservationError;
use vcgpdm_core::models::{
    ColumnMapping, Model as TrainedModel, PartCompletion, Reading, Rollout as Rolled, RolloutRequest,
};
use wasm_bindgen::prelude::*;

/// What is observed of a recording.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "CompleteOptions"))]
pub(crate) struct Options {
    /// The names of the observed parts.
    given: Vec<String>,
    /// They are observed until this time, in seconds; absent: to the end.
    #[cfg_attr(feature = "types", ts(optional))]
    until: Option<f64>,
    /// Coupling variances `alpha[source][target]`; absent: as learned.
    #[cfg_attr(feature = "types", ts(optional = nullable))]
    alpha: Option<Vec<Vec<f64>>>,
    /// Absent: as learned.
    #[serde(default)]
    #[cfg_attr(feature = "types", ts(as = "Option<_>", optional))]
    reading: Reading,
}

/// The errors of a part that was not given, while the others are observed.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "PartCompletion"))]
pub(crate) struct PartScores<'a> {
    part: &'a str,
    #[serde(flatten)]
    scores: PartCompletion,
}

/// A completed recording.
#[wasm_bindgen]
pub struct Completion {
    found: vcgpdm_core::models::Completion,
    recorded: DMatrix<f64>,
    model: Arc<TrainedModel>,
}

#[wasm_bindgen]
impl Model {
    /// Observes some parts of a recording and infers the others, through the couplings. The clip need not be
    /// one that the model was trained on, but must be of the same body.
    pub fn complete(
        &self,
        clip: &Clip,
        #[wasm_bindgen(unchecked_param_type = "CompleteOptions")] options: JsValue,
    ) -> Result<Completion, VcgpdmError> {
        let model = self.model.body()?;
        let view = coupled(model)?;
        let options: Options = from_js(ErrorCode::Rollout, "complete", &options)?;
        let parts = model.body.layout.parts();
        let number = |name: &String| {
            parts.iter().position(|part| part.name == *name).ok_or_else(|| {
                let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
                let words = format_args!("given: expected parts of {}, found {name}", names.join(", "));
                VcgpdmError::new(ErrorCode::Rollout, &words)
            })
        };
        let given = options.given.iter().map(number).collect::<Result<Vec<usize>, _>>()?;
        let recorded = model.body.encode(&clip.clip)?;
        let frame_time = model.body.frame_time;
        let cut = options.until.map(|until| (until / frame_time).round() as usize);
        let alpha = options.alpha.as_deref().map(matrix);
        let request = RolloutRequest { alpha, reading: options.reading, ..RolloutRequest::default() };
        let found = view.complete(&request, &recorded, &given, cut).map_err(|reason| {
            let (ObservationError::Cut { least, end, .. }, Some(until)) = (&reason, options.until) else {
                return VcgpdmError::from(reason);
            };
            let seconds = |frame: usize| frame as f64 * frame_time;
            let (first, last) = (seconds(*least), seconds(end.saturating_sub(1)));
            let words = format_args!(
                "complete: `until`: expected from {first:.2} to {last:.2} seconds, found {until}"
            );
            VcgpdmError::new(ErrorCode::Rollout, &words)
        })?;
        Ok(Completion { found, recorded, model: Arc::clone(model) })
    }

    /// Infers the latents in the first frames of a clip, `[part][frame][dimension]`: the `start` of rollouts that
    /// go on from these frames. The frames count at the frame rate of the model. The clip need not be one that
    /// the model was trained on, but must be of the same body.
    #[wasm_bindgen(unchecked_return_type = "number[][][]")]
    pub fn infer(&self, clip: &Clip, frames: &Whole) -> Result<JsValue, VcgpdmError> {
        let frames = frames.count(ErrorCode::Rollout, "the number of frames")?;
        let latents = coupled(self.model.body()?)?.latents_of_clip(&clip.clip, frames)?;
        to_js(&latents.iter().map(rows).collect::<Vec<_>>())
    }
}

/// The motion in which the numbers of `observed` [frames x columns] are given, and the missing ones, which are
/// NaN, inferred.
fn filled<S: ColumnMapping>(
    model: &TrainedModel<S>,
    observed: &[f64],
    request: &RolloutRequest,
) -> Result<Rolled, VcgpdmError> {
    let (expected, found) = (request.frames.saturating_mul(model.body.column_means.len()), observed.len());
    if found != expected {
        let words = format_args!("expected {expected} numbers, one for each frame and column, found {found}");
        return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
    }
    let columns = DMatrix::from_row_slice(request.frames, model.body.column_means.len(), observed);
    Ok(coupled(model)?.fill(request, &columns)?)
}

#[wasm_bindgen]
impl Model {
    /// Fills in the missing numbers of columns, NaN in `observed` [frames x columns], through the couplings: the
    /// other numbers stay. The start of the options is not used.
    pub fn fill(
        &self,
        observed: &[f64],
        #[wasm_bindgen(unchecked_param_type = "RolloutOptions")] options: JsValue,
    ) -> Result<Rollout, VcgpdmError> {
        let request: RolloutRequest = from_js(ErrorCode::Rollout, "fill", &options)?;
        match &self.model {
            Trained::Body(body) => Rollout::new(body, filled(body, observed, &request)?, &request),
            Trained::Table(table) => {
                Ok(Rollout::of_table(table, filled(table, observed, &request)?, request))
            }
        }
    }
}

#[wasm_bindgen]
impl Completion {
    /// Frames of the recording at the frame rate of the model.
    #[wasm_bindgen(getter)]
    pub fn frames(&self) -> usize {
        self.recorded.nrows()
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall: the
    /// given parts as recorded until they are no longer observed, all others as inferred.
    pub fn positions(&self) -> Result<Vec<f32>, VcgpdmError> {
        Ok(self.model.body.positions(&self.found.y)?)
    }

    /// The same of the recording.
    pub fn recorded(&self) -> Result<Vec<f32>, VcgpdmError> {
        Ok(self.model.body.positions(&self.recorded)?)
    }

    /// The mean latents of a part [frames x Q], given all that is observed.
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        Ok(flat(part.part_of(ErrorCode::Rollout, &self.found.latents.means)?))
    }

    /// The errors of the parts that were not given.
    #[wasm_bindgen(unchecked_return_type = "PartCompletion[]")]
    pub fn scores(&self) -> Result<JsValue, VcgpdmError> {
        let parts = self.model.body.layout.parts();
        let named =
            |&(part, scores): &(usize, PartCompletion)| PartScores { part: &parts[part].name, scores };
        to_js(&self.found.parts.iter().map(named).collect::<Vec<_>>())
    }

    /// The completed motion as the text of a BVH file.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(
        &self,
        #[wasm_bindgen(unchecked_optional_param_type = "BvhOptions")] options: JsValue,
    ) -> Result<String, VcgpdmError> {
        bvh_text(self.model.body.clip(&self.found.y, "completed.bvh")?, &options)
    }
}
