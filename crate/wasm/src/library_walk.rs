//! An endless rollout of a combination of primitives.

use crate::arguments::Whole;
use crate::convert::{flat, from_js, matrix};
use crate::error::{ErrorCode, VcgpdmError};
use crate::library::{Library, uses_of};
use serde::Deserialize;
use std::rc::Rc;
use vcgpdm::models::library::{LibraryWalk as Walk, TrainedLibrary, WalkFrames as Frames};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/**
 * Where a walk begins: a movement, one of its sequences and a frame of that, counted from 0; the first of
 * both where they are not given.
 */
export interface WalkStart {
    movement: number;
    sequence?: number;
    frame?: number;
}
"#;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WalkStart {
    movement: usize,
    #[serde(default)]
    sequence: usize,
    #[serde(default)]
    frame: usize,
}

/// A figure that goes on without an end, while primitives are exchanged and mixed, couplings and tempos
/// changed.
#[wasm_bindgen]
pub struct LibraryWalk {
    trained: Rc<TrainedLibrary>,
    walk: Walk,
}

#[wasm_bindgen]
impl Library {
    /// A figure that goes on without an end, of a combination; from a frame of a sequence of a movement,
    /// where that is given.
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
    /// Gives a part another of its primitives, at the state that is nearest to what the other parts do; these
    /// go on as they are. With `alpha`, under these couplings.
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
        // Both or nothing.
        let mut latents = self.walk.latents.clone();
        latents.use_primitive(&self.trained.library, part, primitive)?;
        if let Some(alpha) = alpha {
            latents.set_alpha(matrix(&alpha))?;
        }
        self.walk.latents = latents;
        Ok(())
    }

    /// Mixes the predictions of a part's primitive with those of another one of the part: a share of it from
    /// 0 to 1. It gets there evenly, at the pace of a whole exchange in `frames`; at once without.
    pub fn mix(
        &mut self,
        part: &Whole,
        other: &Whole,
        share: f64,
        frames: Option<Whole>,
    ) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        let other = other.count(ErrorCode::Rollout, "the primitive")?;
        let frames = frames
            .map_or(Ok(0), |frames| frames.count(ErrorCode::Rollout, "the frames of a whole exchange"))?;
        Ok(self.walk.latents.mix(&self.trained.library, part, other, share, frames)?)
    }

    /// Other couplings, `alpha[source][target]`, from the next frame on.
    #[wasm_bindgen(js_name = setAlpha)]
    pub fn set_alpha(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "number[][]")] alpha: JsValue,
    ) -> Result<(), VcgpdmError> {
        let alpha: Vec<Vec<f64>> = from_js(ErrorCode::Rollout, "the couplings", &alpha)?;
        Ok(self.walk.latents.set_alpha(matrix(&alpha))?)
    }

    /// Lets a part go through its own time at another tempo, 0.25 to 2; 1 is as learned.
    #[wasm_bindgen(js_name = setTempo)]
    pub fn set_tempo(&mut self, part: &Whole, tempo: f64) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        Ok(self.walk.latents.set_tempo(part, tempo)?)
    }

    /// Goes on in a library that has grown out of the one before: with all its primitives, and more to use.
    #[wasm_bindgen(js_name = setLibrary)]
    pub fn set_library(&mut self, library: &Library) -> Result<(), VcgpdmError> {
        self.trained.check_growth(&library.trained)?;
        self.trained = Rc::clone(&library.trained);
        Ok(())
    }

    /// Takes the last frames back, 64 at most: the walk is what it was when the frame before them had been
    /// made. What was changed since is taken back as well, also with 0 frames.
    pub fn rewind(&mut self, frames: &Whole) -> Result<(), VcgpdmError> {
        Ok(self.walk.rewind(frames.count(ErrorCode::Rollout, "the number of frames")?)?)
    }

    /// The next frames.
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
