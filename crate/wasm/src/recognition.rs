//! Which movement of a library clips show, moment by moment.

use crate::clip::TrainingSet;
use crate::convert::{flat, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::library::Library;
use serde::Serialize;
use std::rc::Rc;
use vcgpdm::models::library::TrainedLibrary;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A time in which one movement of the library is the likeliest. */
export interface RecognisedSegment {
    /** The index of the movement. */
    movement: number;
    /** The first frame, and the one after the last. */
    first: number;
    end: number;
    /** The mean of its probability. */
    probability: number;
}
"#;

#[derive(Serialize)]
struct Segment {
    movement: usize,
    first: usize,
    end: usize,
    probability: f64,
}

/// A recognition under way.
#[wasm_bindgen]
pub struct Recogniser {
    under_way: Option<vcgpdm::models::library::Recogniser>,
    trained: Rc<TrainedLibrary>,
}

/// The movements of a library in clips.
#[wasm_bindgen]
pub struct Recognition {
    found: vcgpdm::models::library::Recognition,
    trained: Rc<TrainedLibrary>,
}

#[wasm_bindgen]
impl Library {
    /// The movements of this library in clips of its body. Several clips count as one recording: each begins
    /// where the one before ends, in the same direction. The library need not be trained on the clips.
    pub fn recognise(&self, clips: &TrainingSet) -> Result<Recognition, VcgpdmError> {
        let found = self.trained.recognise(&clips.clips.iter().collect::<Vec<_>>())?;
        Ok(Recognition { found, trained: Rc::clone(&self.trained) })
    }

    /// The same step by step.
    pub fn recogniser(&self, clips: &TrainingSet) -> Result<Recogniser, VcgpdmError> {
        let under_way = self.trained.recogniser(&clips.clips.iter().collect::<Vec<_>>())?;
        Ok(Recogniser { under_way: Some(under_way), trained: Rc::clone(&self.trained) })
    }
}

#[wasm_bindgen]
impl Recogniser {
    /// Takes one step, and returns the share that is done: 1 at the end.
    pub fn step(&mut self) -> f64 {
        self.under_way.as_mut().map_or(1.0, vcgpdm::models::library::Recogniser::step)
    }

    /// The movements of the clips, once all steps are taken.
    pub fn finish(&mut self) -> Result<Recognition, VcgpdmError> {
        let expected = || VcgpdmError::new(ErrorCode::Clips, &"expected steps until 1, and finish once");
        let mut under_way = self.under_way.take().ok_or_else(expected)?;
        while under_way.step() < 1.0 {}
        Ok(Recognition { found: under_way.finish(), trained: Rc::clone(&self.trained) })
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

    /// The probability of every movement in every frame given all frames [frames x movements].
    pub fn probabilities(&self) -> Vec<f64> {
        flat(&self.found.posterior)
    }

    /// The recording in pieces of one movement each.
    #[wasm_bindgen(unchecked_return_type = "RecognisedSegment[]")]
    pub fn segments(&self) -> Result<JsValue, VcgpdmError> {
        let segments = self.found.segments().into_iter();
        let segments = segments.map(|vcgpdm::models::library::Segment { movement, frames, probability }| {
            Segment { movement, first: frames.start, end: frames.end, probability }
        });
        to_js(&segments.collect::<Vec<_>>())
    }
}
