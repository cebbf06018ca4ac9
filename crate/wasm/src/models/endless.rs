//! A motion without an end.

use crate::models::rollout::Rollout;
use crate::models::trained::coupled;
use crate::values::arguments::Whole;
use crate::values::convert::flat;
use crate::values::error::{ErrorCode, VcgpdmError};
use nalgebra::DMatrix;
use std::sync::Arc;
#[cfg(feature = "training")]
use vcgpdm_core::models::library::TrainedLibrary;
use vcgpdm_core::models::variational::CyclePlace;
use vcgpdm_core::models::{Push, Reading};
use wasm_bindgen::prelude::*;

/// A motion without an end, of a model or of a combination of primitives. It computes a few frames at a time;
/// between them, couplings, tempos and primitives can change, and parts can be pushed or moved.
#[wasm_bindgen]
pub struct Endless {
    pub(crate) endless: vcgpdm_core::models::Endless,
    /// That of a motion of primitives.
    #[cfg(feature = "training")]
    pub(crate) library: Option<Arc<TrainedLibrary>>,
}

#[wasm_bindgen]
impl Endless {
    /// Continues a rollout of a model after a frame, under the same couplings.
    #[wasm_bindgen(constructor)]
    pub fn new(rollout: &Rollout, frame: &Whole) -> Result<Endless, VcgpdmError> {
        let frame = frame.count(ErrorCode::Rollout, "the frame")?;
        let (model, request) = (rollout.model.body()?, &rollout.request);
        let learned = &coupled(model)?.model.alpha;
        let mut endless = vcgpdm_core::models::Endless::after(
            Arc::clone(model),
            &rollout.rollout,
            frame,
            request.sequence,
        )?;
        endless.set_couplings(request.alpha_or(learned).clone(), request.reading)?;
        Ok(Endless {
            endless,
            #[cfg(feature = "training")]
            library: None,
        })
    }

    /// Sets the couplings from the next frame on: the variances [parts x parts], whose row is the source, and
    /// whether the experts are inferred again under them. If the couplings are invalid, nothing changes.
    #[wasm_bindgen(js_name = setCouplings)]
    pub fn set_couplings(&mut self, alpha: &[f64], re_inferred: bool) -> Result<(), VcgpdmError> {
        let (parts, found) = (self.endless.alpha().nrows(), alpha.len());
        if found != parts * parts {
            let words = format_args!(
                "expected coupling variances for {parts} x {parts} parts, found {found} numbers"
            );
            return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
        }
        let alpha = DMatrix::from_row_slice(parts, parts, alpha);
        let reading = if re_inferred { Reading::ReInferred } else { Reading::AsLearned };
        Ok(self.endless.set_couplings(alpha, reading)?)
    }

    /// Cuts a coupling from the next frame on, or restores it. The last coupling into a part cannot be cut.
    pub fn cut(&mut self, source: &Whole, target: &Whole, cut: bool) -> Result<(), VcgpdmError> {
        let source = source.count(ErrorCode::Rollout, "the source")?;
        let target = target.count(ErrorCode::Rollout, "the target")?;
        Ok(self.endless.cut(source, target, cut)?)
    }

    /// Sets the tempo of a part, from 0.25 to 2; 1 is the learned tempo.
    #[wasm_bindgen(js_name = setTempo)]
    pub fn set_tempo(&mut self, part: &Whole, tempo: f64) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        Ok(self.endless.set_tempo(part, tempo)?)
    }

    /// Computes the next frames.
    pub fn advance(&mut self, frames: &Whole) -> Result<EndlessFrames, VcgpdmError> {
        let frames = frames.count(ErrorCode::Rollout, "the number of frames")?;
        Ok(EndlessFrames(self.endless.advance(frames)?))
    }

    /// Takes the last frames back, at most 64. The motion returns to its state right after the frame before
    /// them. This also undoes all changes made since then, even with 0 frames.
    pub fn rewind(&mut self, frames: &Whole) -> Result<(), VcgpdmError> {
        Ok(self.endless.rewind(frames.count(ErrorCode::Rollout, "the number of frames")?)?)
    }

    /// Pushes a part by `by` in the latent space [Q], before the next frame.
    pub fn push(&mut self, part: &Whole, by: Vec<f64>) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        Ok(self.endless.push(&Push { part, by, ..Push::default() })?)
    }

    /// Drives a part round its learned cycle, by `turns` within the next frames that are asked for; with 0 it
    /// stands still. It is driven until it is released.
    pub fn drive(&mut self, part: &Whole, turns: f64) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        Ok(self.endless.drive(part, turns)?)
    }

    /// Lets a recording move a part, again and again until it is released: `latents` are those of the part in
    /// all frames of the recording [frames x Q], as in a `Completion`. The recording begins where it is most
    /// like the part now.
    pub fn record(&mut self, part: &Whole, latents: &[f64]) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        let width = self.endless.latent_dimensions().get(part).copied().unwrap_or(1);
        // Numbers that do not fill a frame make a matrix that fits no part.
        let columns = if latents.len().is_multiple_of(width) { width } else { latents.len() };
        let latents = DMatrix::from_row_slice(latents.len() / columns.max(1), columns, latents);
        Ok(self.endless.record(part, latents)?)
    }

    /// Lets the part of a node of the figure follow a place until it is released: the node comes as near to it
    /// as poses like those of the training allow. The place is relative to the figure's root, in metres.
    pub fn reach(&mut self, node: &Whole, x: f64, y: f64, z: f64) -> Result<(), VcgpdmError> {
        let node = node.count(ErrorCode::Rollout, "the node")?;
        Ok(self.endless.reach(node, [x, y, z])?)
    }

    /// Lets a part go on by itself that was driven, recorded or followed a place.
    pub fn release(&mut self, part: &Whole) -> Result<(), VcgpdmError> {
        self.endless.release(part.count(ErrorCode::Rollout, "the part")?);
        Ok(())
    }

    /// Pushes the part of a node of the figure so that the node moves by about x, y and z metres.
    pub fn pull(&mut self, node: &Whole, x: f64, y: f64, z: f64) -> Result<(), VcgpdmError> {
        let node = node.count(ErrorCode::Rollout, "the node")?;
        let push = self.endless.pull(node, [x, y, z])?;
        Ok(self.endless.push(&push)?)
    }
}

/// The next frames of a motion without an end.
#[wasm_bindgen]
pub struct EndlessFrames(vcgpdm_core::models::EndlessFrames);

#[wasm_bindgen]
impl EndlessFrames {
    /// The latent path of a part [frames x Q].
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        Ok(flat(part.part_of(ErrorCode::Rollout, &self.0.latents)?))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.0.positions.clone()
    }

    /// All columns [frames x columns], in their own units: the motion itself, which `Model.fill` turns into a file.
    pub fn values(&self) -> Vec<f64> {
        flat(&self.0.y)
    }

    /// The phase of each part on the learned cycle, in turns from 0 to 1 [frames x parts]. Parts in step have
    /// the same phase. Empty if the learned rollout is not periodic.
    pub fn phases(&self) -> Vec<f64> {
        self.0.places.iter().map(|place: &CyclePlace| place.phase).collect()
    }

    /// The frame of the recording that moves each part [frames x parts], -1 without a recording.
    pub fn recorded(&self) -> Vec<i32> {
        let number = |frame: &Option<usize>| frame.and_then(|frame| i32::try_from(frame).ok()).unwrap_or(-1);
        self.0.recorded.iter().map(number).collect()
    }

    /// The distance of each part from its learned cycle, in radii of the cycle [frames x parts]. Empty if
    /// `phases` is empty.
    pub fn distances(&self) -> Vec<f64> {
        self.0.places.iter().map(|place: &CyclePlace| place.distance).collect()
    }
}
