//! The results of the analysis of the answers to a study.

use crate::values::arguments::Text;
use crate::values::convert::{from_js, to_js, to_json, with_defaults};
use crate::values::error::{ErrorCode, VcgpdmError};
use serde::Deserialize;
use vcgpdm_lab::perception::{AnalysisOptions, AnswerFile, PerceptionResults, Study, read_answers};
use wasm_bindgen::prelude::*;

/// A file of answers: CSV or JSON, in the format of the page or of jsPsych.
#[derive(Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct AnswersFile {
    name: String,
    text: String,
}

fn results(study: &Text, answers: &JsValue, options: &JsValue) -> Result<PerceptionResults, VcgpdmError> {
    let study = Study::from_json(&study.get(ErrorCode::Study, "the study")?)?;
    let files: Vec<AnswersFile> = from_js(ErrorCode::Study, "the answers", answers)?;
    let options = if options.is_null() { &JsValue::UNDEFINED } else { options };
    let options =
        with_defaults(ErrorCode::Study, "the options", options, to_js(&AnalysisOptions::default())?)?;
    let options: AnalysisOptions = from_js(ErrorCode::Study, "the options", &options)?;
    let given = files.iter().map(|file| AnswerFile { name: &file.name, text: &file.text });
    let answers = read_answers(&study, &given.collect::<Vec<_>>())?;
    Ok(PerceptionResults::new(&study, &answers, options)?)
}

/// Analyses the answers to a study. The numbers are the same as those of `vcgpdm perception`.
#[wasm_bindgen(js_name = analysePerception, unchecked_return_type = "PerceptionResults")]
pub fn analyse_perception(
    study: &Text,
    #[wasm_bindgen(unchecked_param_type = "AnswersFile[]")] answers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PerceptionOptions")] options: JsValue,
) -> Result<JsValue, VcgpdmError> {
    to_js(&results(study, &answers, &options)?)
}

/// The analysis as the document that `vcgpdm perception --out` writes.
#[wasm_bindgen(js_name = perceptionJson)]
pub fn perception_json(
    study: &Text,
    #[wasm_bindgen(unchecked_param_type = "AnswersFile[]")] answers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PerceptionOptions")] options: JsValue,
) -> Result<String, VcgpdmError> {
    to_json(&results(study, &answers, &options)?)
}

/// The data for the papers' figures, in the format that `vcgpdm perception --figures` writes.
#[wasm_bindgen(js_name = perceptionFigures, unchecked_return_type = "FigureTable[]")]
pub fn perception_figures(
    study: &Text,
    #[wasm_bindgen(unchecked_param_type = "AnswersFile[]")] answers: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "PerceptionOptions")] options: JsValue,
) -> Result<JsValue, VcgpdmError> {
    to_js(&results(study, &answers, &options)?.figures())
}
