//! The settings of a training: in JavaScript one object with the settings of the model and of its data.

use crate::values::arguments::Whole;
#[cfg(feature = "training")]
use crate::values::convert::from_js_split;
use crate::values::convert::{from_js, to_js, to_js_joined, with_defaults};
use crate::values::error::{ErrorCode, VcgpdmError};
#[cfg(feature = "training")]
use crate::values::wording::{found_value, quoted};
#[cfg(feature = "training")]
use js_sys::{Array, Object, Reflect};
#[cfg(feature = "training")]
use serde::de::{DeserializeOwned, Deserializer, Error, Visitor};
use serde::{Deserialize, Serialize};
#[cfg(feature = "training")]
use std::fmt;
use vcgpdm_core::models::{ModelKind, Settings, TrainingCost, VariationalSettings};
use vcgpdm_core::motion::parts::PartSpec;
#[cfg(feature = "training")]
use vcgpdm_core::motion::parts::{GivenJoint, GivenPart};
#[cfg(feature = "training")]
use vcgpdm_core::motion::{Skeleton, parts};
use wasm_bindgen::prelude::*;

/// The time of the wasm over that of the native program: docs/training.md has both.
const SLOWER: f64 = 2.0;
/// The same for exact Gaussian processes: large matrix products have no wide vectors in wasm.
const SLOWER_EXACT: f64 = 2.5;

/// The rate of the data if the caller gives none.
#[cfg(feature = "training")]
pub const FRAMES_PER_SECOND: f64 = 30.0;

/// The settings of a training of clips of which the longest has this many seconds, where nobody asks for others. A
/// `Trainer` and `train` use them.
#[wasm_bindgen(js_name = usualSettings, unchecked_return_type = "VariationalSettings")]
pub fn usual_settings(longest: f64) -> Result<JsValue, VcgpdmError> {
    to_js(&VariationalSettings::for_clips(longest))
}

/// The cost of a training on `frames` frames of parts with `columns` columns each (a joint has three).
/// Right to a factor of about two. Absent settings are those of `TrainingOptions`.
#[wasm_bindgen(js_name = trainingCost, unchecked_return_type = "TrainingCost")]
pub fn training_cost(
    #[wasm_bindgen(unchecked_param_type = "Partial<VariationalSettings>")] settings: JsValue,
    frames: &Whole,
    #[wasm_bindgen(unchecked_param_type = "number[]")] columns: JsValue,
) -> Result<JsValue, VcgpdmError> {
    let usual = to_js(&VariationalSettings::default())?;
    let settings = with_defaults(ErrorCode::Settings, "settings", &settings, usual)?;
    let settings: VariationalSettings = from_js(ErrorCode::Settings, "settings", &settings)?;
    let columns: Vec<usize> = from_js(ErrorCode::Settings, "columns", &columns)?;
    let cost = settings.cost(frames.count(ErrorCode::Settings, "the number of frames")?, &columns);
    cost_to_js(Some(ModelKind::Vcgpdm), cost)
}

/// The cost of a training here, from that in the native program. A rival has no kind of model.
pub fn cost_to_js(kind: Option<ModelKind>, mut cost: TrainingCost) -> Result<JsValue, VcgpdmError> {
    cost.seconds *= match kind {
        Some(ModelKind::MapGpdm | ModelKind::MapCgpdm) => SLOWER_EXACT,
        _ => SLOWER,
    };
    to_js(&cost)
}

/// The complete settings of a training.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[cfg_attr(feature = "types", ts(rename_all = "camelCase", rename = "TrainingSettings"))]
#[cfg_attr(feature = "types", ts(concrete(P = PartSpec)))]
pub struct Task<P = PartSpec> {
    /// The parts of the body, or of the columns of a table.
    #[cfg_attr(feature = "types", ts(type = "PartSpec[]"))]
    pub parts: Vec<P>,
    /// The clips are brought to about this rate.
    pub frames_per_second: f64,
    /// The seed of everything random, a whole number from 0 to 4294967295.
    pub seed: u32,
}

/// The settings of a training for JavaScript.
pub fn settings_to_js(task: &Task, settings: &Settings) -> Result<JsValue, VcgpdmError> {
    match settings.variational() {
        Some(settings) => to_js_joined(task, settings),
        None => to_js(task),
    }
}

/// The options with their field `parts` replaced by the parts that it means.
#[cfg(feature = "training")]
pub fn with_parts<P: Serialize>(
    options: JsValue,
    parts: impl FnOnce(&JsValue) -> Result<Vec<P>, VcgpdmError>,
) -> Result<JsValue, VcgpdmError> {
    // The options are a plain object of ours: no getter throws, and any field is accepted.
    let parts = parts(&Reflect::get(&options, &"parts".into()).unwrap_or_default())?;
    let _ = Reflect::set(&options, &"parts".into(), &to_js(&parts)?);
    Ok(options)
}

/// The settings of the data without their parts.
#[cfg(feature = "training")]
#[derive(Serialize)]
struct Rate {
    frames_per_second: f64,
    seed: u32,
}

/// The settings of a training from JavaScript. Fields that are absent are as in `usual`, the parts those of
/// `parts`.
#[cfg(feature = "training")]
pub fn settings_from_js<P: DeserializeOwned + Serialize>(
    value: &JsValue,
    usual: &VariationalSettings,
    parts: impl FnOnce(&JsValue) -> Result<Vec<P>, VcgpdmError>,
) -> Result<(Task<P>, VariationalSettings), VcgpdmError> {
    let rate = Rate { frames_per_second: FRAMES_PER_SECOND, seed: 0 };
    let usual = to_js_joined(&rate, usual)?;
    let complete = with_defaults(ErrorCode::Settings, "settings", value, usual)?;
    let complete = with_parts(complete, parts)?;
    let option = JsValue::from("asInPapers");
    let given = Reflect::get(&complete, &option).unwrap_or_default();
    let as_in_papers: Option<bool> = from_js(ErrorCode::Settings, "settings.asInPapers", &given)?;
    let _ = Reflect::delete_property(complete.unchecked_ref::<Object>(), &option);
    let (task, settings) =
        from_js_split::<_, VariationalSettings>(ErrorCode::Settings, "settings", &complete)?;
    Ok((task, if as_in_papers == Some(true) { settings.as_in_papers() } else { settings }))
}

/// The parts of a body from JavaScript: a preset by its id or by the names of its parts, or a list with joints
/// by name or index. Absent: lower and upper body, or else the whole body.
#[cfg(feature = "training")]
pub fn body_parts(value: &JsValue, skeleton: &Skeleton) -> Result<Vec<PartSpec>, VcgpdmError> {
    if value.is_undefined() {
        let usual = ["lower-upper", "whole"].iter().find_map(|id| parts::preset_parts(id, skeleton));
        return Ok(usual.unwrap_or_default());
    }
    let refused = |found: &str| {
        let splits = parts::preset_names(skeleton);
        let expected = format_args!("a list of parts or a split of this body ({splits})");
        VcgpdmError::new(ErrorCode::Parts, &format_args!("parts: expected {expected}, found {found}"))
    };
    if let Some(text) = value.as_string() {
        return parts::preset_parts(&text, skeleton).ok_or_else(|| refused(&quoted(&text)));
    }
    if !Array::is_array(value) {
        return Err(refused(&found_value(value)));
    }
    let given: Vec<Part> = from_js(ErrorCode::Parts, "parts", value)?;
    let part =
        |Part { name, joints }| GivenPart { name, joints: joints.into_iter().map(|joint| joint.0).collect() };
    Ok(parts::from_given(given.into_iter().map(part).collect(), skeleton)?)
}

/// A part by the names or indices of its joints.
#[cfg(feature = "training")]
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "NamedPart"))]
pub(crate) struct Part {
    name: String,
    #[cfg_attr(feature = "types", ts(type = "(string | number)[]"))]
    joints: Vec<NameOrIndex>,
}

#[cfg(feature = "training")]
struct NameOrIndex(GivenJoint);

#[cfg(feature = "training")]
impl<'de> Deserialize<'de> for NameOrIndex {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NameOrIndexVisitor)
    }
}

#[cfg(feature = "training")]
struct NameOrIndexVisitor;

#[cfg(feature = "training")]
impl Visitor<'_> for NameOrIndexVisitor {
    type Value = NameOrIndex;

    fn expecting(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str("the name of a joint or a number")
    }

    fn visit_str<E>(self, name: &str) -> Result<NameOrIndex, E> {
        Ok(NameOrIndex(GivenJoint::Name(name.to_owned())))
    }

    fn visit_f64<E>(self, number: f64) -> Result<NameOrIndex, E> {
        let is_index = number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&number);
        let index = is_index.then_some(number as usize);
        Ok(NameOrIndex(GivenJoint::Other { index, shown: number.to_string() }))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<NameOrIndex, E> {
        self.visit_f64(number as f64)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<NameOrIndex, E> {
        self.visit_f64(number as f64)
    }
}
