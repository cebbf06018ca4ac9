//! Which primitive each part uses in clips, moment by moment.

use crate::data::clip::TrainingSet;
use crate::library::Library;
use crate::values::arguments::Whole;
use crate::values::convert::{flat, to_js};
use crate::values::error::{ErrorCode, VcgpdmError};
use serde::Serialize;
use std::sync::Arc;
use vcgpdm_core::models::library::TrainedLibrary;
use wasm_bindgen::prelude::*;

/// A time in which one combination of primitives is the likeliest.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "RecognisedSegment"))]
pub(crate) struct Segment {
    /// The index of the movement that uses these primitives; null: parts use primitives of several movements.
    movement: Option<usize>,
    /// The index of the primitive of each part, as in `LibraryInfo.primitives`.
    uses: Vec<usize>,
    /// The first frame, and the one after the last.
    first: usize,
    end: usize,
    /// The mean of its probability.
    probability: f64,
}

/// A recognition under way.
#[wasm_bindgen]
pub struct Recogniser {
    under_way: Option<vcgpdm_core::models::library::Recogniser>,
    trained: Arc<TrainedLibrary>,
}

/// The primitives of a library in clips.
#[wasm_bindgen]
pub struct Recognition {
    found: vcgpdm_core::models::library::Recognition,
    trained: Arc<TrainedLibrary>,
}

#[wasm_bindgen]
impl Library {
    /// The primitive that each part uses in clips of the library's body. Several clips count as one recording: each
    /// begins where the one before ends, in the same direction. The library need not be trained on the clips.
    pub fn recognise(&self, clips: &TrainingSet) -> Result<Recognition, VcgpdmError> {
        let found = self.trained.recognise(&clips.clips.iter().collect::<Vec<_>>())?;
        Ok(Recognition { found, trained: Arc::clone(&self.trained) })
    }

    /// The same step by step.
    pub fn recogniser(&self, clips: &TrainingSet) -> Result<Recogniser, VcgpdmError> {
        let under_way = self.trained.recogniser(&clips.clips.iter().collect::<Vec<_>>())?;
        Ok(Recogniser { under_way: Some(under_way), trained: Arc::clone(&self.trained) })
    }
}

#[wasm_bindgen]
impl Recogniser {
    /// Takes one step, and returns the share that is done: 1 at the end.
    pub fn step(&mut self) -> f64 {
        self.under_way.as_mut().map_or(1.0, vcgpdm_core::models::library::Recogniser::step)
    }

    /// The primitives in the clips, once all steps are taken.
    pub fn finish(&mut self) -> Result<Recognition, VcgpdmError> {
        let expected = || VcgpdmError::new(ErrorCode::Clips, &"expected steps until 1, and finish once");
        let mut under_way = self.under_way.take().ok_or_else(expected)?;
        while under_way.step() < 1.0 {}
        Ok(Recognition { found: under_way.finish(), trained: Arc::clone(&self.trained) })
    }
}

#[wasm_bindgen]
impl Recognition {
    /// Frames of the recording at the frame rate of the library.
    #[wasm_bindgen(getter)]
    pub fn frames(&self) -> usize {
        self.found.y.nrows()
    }

    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub fn positions(&self) -> Result<Vec<f32>, VcgpdmError> {
        Ok(self.trained.body.positions(&self.found.y)?)
    }

    /// The probability of each primitive of a part in every frame given all frames [frames x primitives of the
    /// part], in the order of the library.
    pub fn probabilities(&self, part: &Whole) -> Result<Vec<f64>, VcgpdmError> {
        let (part, count) = (part.count(ErrorCode::Clips, "the part")?, self.found.primitives.len());
        if part >= count {
            let words = format_args!("expected a part from 0 to {}, found {part}", count - 1);
            return Err(VcgpdmError::new(ErrorCode::Clips, &words));
        }
        Ok(flat(&self.found.part_posterior(part)))
    }

    /// The recording in pieces of one combination of primitives each.
    #[wasm_bindgen(unchecked_return_type = "RecognisedSegment[]")]
    pub fn segments(&self) -> Result<JsValue, VcgpdmError> {
        let movements = &self.trained.library.movements;
        let segments = self.found.segments().into_iter();
        let segments =
            segments.map(|vcgpdm_core::models::library::Segment { uses, frames, probability }| Segment {
                movement: movements.iter().position(|movement| movement.uses == uses),
                uses,
                first: frames.start,
                end: frames.end,
                probability,
            });
        to_js(&segments.collect::<Vec<_>>())
    }
}
