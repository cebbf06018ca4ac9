//! A live rollout, which never ends.

use crate::models::rollout::Rollout;
use crate::models::trained::coupled;
use crate::values::arguments::Whole;
use crate::values::convert::flat;
use crate::values::error::{ErrorCode, VcgpdmError};
use nalgebra::DMatrix;
use std::rc::Rc;
use vcgpdm::models::variational::CyclePlace;
use vcgpdm::models::{LatentDynamics, LiveFrames as MotionFrames, Model, Push, Reading};
use wasm_bindgen::prelude::*;

/// A live rollout. It computes a few frames at a time; between them, couplings can change and parts can be
/// pushed.
#[wasm_bindgen]
pub struct LiveRollout {
    live: vcgpdm::models::LiveRollout,
    alpha: DMatrix<f64>,
    reading: Reading,
    cuts: Vec<(usize, usize)>,
    dynamics: LatentDynamics,
    model: Rc<Model>,
}

#[wasm_bindgen]
impl LiveRollout {
    /// Starts a live rollout after a frame of a rollout, under the same couplings.
    #[wasm_bindgen(constructor)]
    pub fn new(rollout: &Rollout, frame: &Whole) -> Result<LiveRollout, VcgpdmError> {
        let frame = frame.count(ErrorCode::Rollout, "the frame")?;
        let (model, request) = (Rc::clone(rollout.model.body()?), &rollout.request);
        let view = coupled(&model)?;
        let live = vcgpdm::models::LiveRollout::after(view, &rollout.rollout, frame, request.sequence)?;
        let (alpha, reading) = (request.alpha_or(&view.model.alpha).clone(), request.reading);
        let dynamics = view.model.dynamics_without(&[], &alpha, reading)?;
        Ok(LiveRollout { live, alpha, reading, cuts: Vec::new(), dynamics, model })
    }

    /// Sets the couplings from the next frame on: the variances [parts x parts], whose row is the source, and
    /// whether the experts are inferred again under them. If the couplings are invalid, nothing changes.
    #[wasm_bindgen(js_name = setCouplings)]
    pub fn set_couplings(&mut self, alpha: &[f64], re_inferred: bool) -> Result<(), VcgpdmError> {
        let (parts, found) = (coupled(&self.model)?.model.part_count(), alpha.len());
        if found != parts * parts {
            let words = format_args!(
                "expected coupling variances for {parts} x {parts} parts, found {found} numbers"
            );
            return Err(VcgpdmError::new(ErrorCode::Rollout, &words));
        }
        let alpha = DMatrix::from_row_slice(parts, parts, alpha);
        let reading = if re_inferred { Reading::ReInferred } else { Reading::AsLearned };
        self.dynamics = coupled(&self.model)?.model.dynamics_without(&self.cuts, &alpha, reading)?;
        (self.alpha, self.reading) = (alpha, reading);
        Ok(())
    }

    /// Cuts a coupling from the next frame on, or restores it. The last coupling into a part cannot be cut.
    pub fn cut(&mut self, source: &Whole, target: &Whole, cut: bool) -> Result<(), VcgpdmError> {
        let source = source.count(ErrorCode::Rollout, "the source")?;
        let target = target.count(ErrorCode::Rollout, "the target")?;
        let mut cuts = self.cuts.clone();
        cuts.retain(|other| *other != (source, target));
        if cut {
            cuts.push((source, target));
        }
        self.dynamics = coupled(&self.model)?.model.dynamics_without(&cuts, &self.alpha, self.reading)?;
        self.cuts = cuts;
        Ok(())
    }

    /// Computes the next frames.
    pub fn advance(&mut self, frames: &Whole) -> Result<LiveFrames, VcgpdmError> {
        let frames = frames.count(ErrorCode::Rollout, "the number of frames")?;
        Ok(LiveFrames(self.live.advance(coupled(&self.model)?, &self.dynamics, frames)?))
    }

    /// Takes the newest frame back, so that the next frame replaces it: other changes can come before it. Throws
    /// where no frame was computed since the last one was taken back.
    #[wasm_bindgen(js_name = takeBack)]
    pub fn take_back(&mut self) -> Result<(), VcgpdmError> {
        if self.live.take_back() {
            return Ok(());
        }
        let words = "expected a frame that was computed since the last one was taken back, found none";
        Err(VcgpdmError::new(ErrorCode::Rollout, &words))
    }

    /// Pushes a part by `by` in the latent space [Q], before the next frame.
    pub fn push(&mut self, part: &Whole, by: Vec<f64>) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        Ok(self.live.push(&Push { part, by, ..Push::default() })?)
    }

    /// Drives a part round its learned cycle, by `turns` within the next frames that are asked for; with 0 it
    /// stands still. It is driven until it is released.
    pub fn drive(&mut self, part: &Whole, turns: f64) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        Ok(self.live.drive(part, turns)?)
    }

    /// Lets a recording move a part, again and again until it is released: `latents` are those of the part in
    /// all frames of the recording [frames x Q], as in a `Completion`. The recording begins where it is most
    /// like the part now.
    pub fn record(&mut self, part: &Whole, latents: &[f64]) -> Result<(), VcgpdmError> {
        let part = part.count(ErrorCode::Rollout, "the part")?;
        let width = coupled(&self.model)?.model.latent_dimensions().get(part).copied().unwrap_or(1);
        // Numbers that do not fill a frame make a matrix that fits no part.
        let columns = if latents.len().is_multiple_of(width) { width } else { latents.len() };
        let latents = DMatrix::from_row_slice(latents.len() / columns.max(1), columns, latents);
        Ok(self.live.record(part, latents)?)
    }

    /// Lets the part of a node of the figure follow a place until it is released: the node comes as near to it
    /// as poses like those of the training allow. The place is relative to the figure's root, in metres.
    pub fn reach(&mut self, node: &Whole, x: f64, y: f64, z: f64) -> Result<(), VcgpdmError> {
        let node = node.count(ErrorCode::Rollout, "the node")?;
        Ok(self.live.reach(coupled(&self.model)?, node, [x, y, z])?)
    }

    /// Lets a part go on by itself that was driven, recorded or followed a place.
    pub fn release(&mut self, part: &Whole) -> Result<(), VcgpdmError> {
        self.live.release(part.count(ErrorCode::Rollout, "the part")?);
        Ok(())
    }

    /// Pushes the part of a node of the figure so that the node moves by about x, y and z metres.
    pub fn pull(&mut self, node: &Whole, x: f64, y: f64, z: f64) -> Result<(), VcgpdmError> {
        let node = node.count(ErrorCode::Rollout, "the node")?;
        let push = self.live.pull(coupled(&self.model)?, node, [x, y, z])?;
        Ok(self.live.push(&push)?)
    }
}

/// The next frames of a live rollout.
#[wasm_bindgen]
pub struct LiveFrames(MotionFrames);

#[wasm_bindgen]
impl LiveFrames {
    /// The latent path of a part [frames x Q].
    pub fn latents(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        Ok(flat(part.part_of(ErrorCode::Rollout, &self.0.latents)?))
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Vec<f32> {
        self.0.positions.clone()
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
