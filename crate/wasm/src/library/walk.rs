//! An endless rollout of a combination of primitives.

use crate::library::{Library, uses_of};
use crate::values::arguments::Whole;
use crate::values::convert::{flat, from_js, matrix};
use crate::values::error::{ErrorCode, VcgpdmError};
use serde::Deserialize;
use std::rc::Rc;
use vcgpdm::models::library::{LibraryWalk as Walk, TrainedLibrary, WalkFrames as Frames};
use wasm_bindgen::prelude::*;

/// The start of a walk: a movement, one of its sequences, and a frame of the sequence. All are counted from
/// 0; the default sequence and frame are 0.
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

/// An endless rollout of a combination. Its primitives, couplings and tempos can change while it runs.
#[wasm_bindgen]
pub struct LibraryWalk {
    trained: Rc<TrainedLibrary>,
    walk: Walk,
}

#[wasm_bindgen]
impl Library {
    /// Starts an endless rollout of a combination, by default at the start of the combination, or at the
    /// frame of a movement that `start` gives.
    pub fn walk(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "WalkStart | null")] start: JsValue,
    ) -> Result<LibraryWalk, VcgpdmError> {
        let uses = uses_of(&uses)?;
        let start: Option<WalkStart> = from_js(ErrorCode::Rollout, "the start", &start)?;
        let walk = match start {
            Some(WalkStart { movement, sequence, frame }) => {
                Walk::from_sequence(&self.trained, &uses, (movement, sequence, frame))?
            }
            None => Walk::new(&self.trained, &uses)?,
        };
        Ok(LibraryWalk { trained: Rc::clone(&self.trained), walk })
    }
}

#[wasm_bindgen]
impl LibraryWalk {
    /// Switches a part to another of its primitives. The part starts in the state that best fits the current
    /// motion of the other parts, which continue unchanged. With `alpha`, also sets the couplings.
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
        // If the couplings are refused, the primitive does not change either.
        let mut latents = self.walk.latents.clone();
        latents.use_primitive(&self.trained.library, part, primitive)?;
        if let Some(alpha) = alpha {
            latents.set_alpha(matrix(&alpha))?;
        }
        self.walk.latents = latents;
        Ok(())
    }

    /// Sets the couplings `alpha[source][target]` from the next frame on.
    #[wasm_bindgen(js_name = setAlpha)]
    pub fn set_alpha(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "number[][]")] alpha: JsValue,
    ) -> Result<(), VcgpdmError> {
        let alpha: Vec<Vec<f64>> = from_js(ErrorCode::Rollout, "the couplings", &alpha)?;
        Ok(self.walk.latents.set_alpha(matrix(&alpha))?)
    }

    /// Sets the tempo of a part, from 0.25 to 2; 1 is the learned tempo.
    #[wasm_bindgen(js_name = setTempo)]
    pub fn set_tempo(&mut self, part: &Whole, tempo: f64) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        Ok(self.walk.latents.set_tempo(part, tempo)?)
    }

    /// Continues the walk with a larger library. The larger library must contain all primitives of the
    /// earlier library.
    #[wasm_bindgen(js_name = setLibrary)]
    pub fn set_library(&mut self, library: &Library) -> Result<(), VcgpdmError> {
        self.trained.check_growth(&library.trained)?;
        self.trained = Rc::clone(&library.trained);
        Ok(())
    }

    /// Removes the last frames, at most 64. The walk returns to its state right after the frame before them.
    /// This also undoes all changes made since then, even with 0 frames.
    pub fn rewind(&mut self, frames: &Whole) -> Result<(), VcgpdmError> {
        Ok(self.walk.rewind(frames.count(ErrorCode::Rollout, "the number of frames")?)?)
    }

    /// Computes the next frames.
    pub fn advance(&mut self, frames: &Whole) -> Result<WalkFrames, VcgpdmError> {
        let frames = frames.count(ErrorCode::Rollout, "the number of frames")?;
        Ok(WalkFrames(self.walk.advance(&self.trained, frames)?))
    }
}

/// The next frames of a walk.
#[wasm_bindgen]
pub struct WalkFrames(Frames);

#[wasm_bindgen]
impl WalkFrames {
    /// The latent path of a part [frames x Q].
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        Ok(flat(part.part_of(ErrorCode::Rollout, &self.0.latents)?))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.0.positions.clone()
    }
}
