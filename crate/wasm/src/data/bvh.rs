//! Motions as the text of a BVH file.

use crate::values::convert::{from_js, with_defaults};
use crate::values::error::{ErrorCode, VcgpdmError};
use js_sys::Object;
use serde::Deserialize;
use vcgpdm::motion::{Clip, bvh};
use wasm_bindgen::prelude::*;

/// How the text of a BVH file is written.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct BvhOptions {
    /// Whether joints get names that every program reads: `mixamorig:Hips` becomes `Hips`. three.js does not
    /// move joints whose names have a colon. Absent: the names stay.
    #[cfg_attr(feature = "types", ts(type = "boolean", optional))]
    plain_names: bool,
}

/// The text of a BVH file.
pub fn bvh_text(clip: Clip, options: &JsValue) -> Result<String, VcgpdmError> {
    let options = with_defaults(ErrorCode::Clip, "toBvh", options, Object::new().into())?;
    let BvhOptions { plain_names } = from_js(ErrorCode::Clip, "toBvh", &options)?;
    Ok(bvh::write(&if plain_names { clip.with_plain_names() } else { clip }))
}
