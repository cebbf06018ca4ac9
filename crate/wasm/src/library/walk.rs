//! Motions without an end of primitives.

use crate::library::{Library, uses_of};
use crate::models::endless::Endless;
use crate::values::arguments::Whole;
use crate::values::convert::{from_js, matrix};
use crate::values::error::{ErrorCode, VcgpdmError};
use serde::Deserialize;
use std::sync::Arc;
use vcgpdm_core::models::library::TrainedLibrary;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Endless {
    /// Switches a part to another of its primitives. The part starts in the state that best fits the current
    /// motion of the other parts, which continue unchanged. With `alpha`, also sets the couplings. If the
    /// couplings are refused, the primitive does not change either.
    #[wasm_bindgen(js_name = use)]
    pub fn use_primitive(
        &mut self,
        part: &Whole,
        primitive: &Whole,
        #[wasm_bindgen(unchecked_optional_param_type = "number[][] | null")] alpha: JsValue,
    ) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        let primitive = primitive.count(ErrorCode::Rollout, "the primitive")?;
        let alpha: Option<Vec<Vec<f64>>> = from_js(ErrorCode::Rollout, "the couplings", &alpha)?;
        let library = self.library()?;
        let alpha = alpha.map(|alpha| matrix(&alpha));
        Ok(library.use_primitive(&mut self.endless, part, primitive, alpha)?)
    }

    /// Continues with a larger library. The larger library must contain all primitives of the earlier library.
    #[wasm_bindgen(js_name = setLibrary)]
    pub fn set_library(&mut self, library: &Library) -> Result<(), VcgpdmError> {
        self.library()?.check_growth(&library.trained)?;
        self.library = Some(Arc::clone(&library.trained));
        Ok(())
    }

    fn library(&self) -> Result<Arc<TrainedLibrary>, VcgpdmError> {
        let words = "expected a motion of primitives, found one of a model";
        self.library.clone().ok_or_else(|| VcgpdmError::new(ErrorCode::Rollout, &words))
    }
}

/// The start of a motion of primitives: a movement, one of its sequences, and a frame of the sequence. All are
/// counted from 0; the default sequence and frame are 0.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct WalkStart {
    movement: usize,
    #[serde(default)]
    #[cfg_attr(feature = "types", ts(type = "number", optional))]
    sequence: usize,
    #[serde(default)]
    #[cfg_attr(feature = "types", ts(type = "number", optional))]
    frame: usize,
}

#[wasm_bindgen]
impl Library {
    /// Starts a motion without an end of a combination, by default at the start of the combination, or at the
    /// frame of a movement that `start` gives.
    pub fn walk(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "WalkStart | null")] start: JsValue,
    ) -> Result<Endless, VcgpdmError> {
        let uses = uses_of(&uses)?;
        let start: Option<WalkStart> = from_js(ErrorCode::Rollout, "the start", &start)?;
        let endless = match start {
            Some(WalkStart { movement, sequence, frame }) => {
                self.trained.endless_from(&uses, (movement, sequence, frame))?
            }
            None => self.trained.endless(&uses)?,
        };
        Ok(Endless { endless, library: Some(Arc::clone(&self.trained)) })
    }
}
