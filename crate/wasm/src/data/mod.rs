//! Clips, tables and documents.

pub mod body;
pub mod clip;
#[cfg(feature = "training")]
pub mod tables;

use crate::values::arguments::Text;
use crate::values::convert::to_js;
use crate::values::error::{ErrorCode, VcgpdmError};
use wasm_bindgen::prelude::*;

/// The kind of a JSON document, whatever the order of its fields; fast for large documents.
#[wasm_bindgen(js_name = documentKind, unchecked_return_type = "DocumentKind")]
pub fn document_kind(text: &Text) -> Result<JsValue, VcgpdmError> {
    let text = text.get(ErrorCode::Model, "the document")?;
    to_js(&vcgpdm_lab::DocumentKind::from_json(&text))
}
