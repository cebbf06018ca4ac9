//! Primitives on their way from one library to another.

use crate::clip::TrainingSet;
use crate::convert::{from_js, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::library::{Library, uses_of};
use crate::progress::progress_to_js;
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use vcgpdm::models::library::{
    ImportFrames, ImportRequest, ImportTrainer as Import, Leader, PartMotion, TrainedLibrary,
};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Why primitives of another library do not fit, and whether `ImportTrainer` can learn them again. */
export interface Misfit {
    reason: string;
    canBeRelearned: boolean;
}

/** How much a part of a combination moves in the long run. */
export interface PartMotion {
    /** The variance of its latents as a share of that in the movements that its primitive learned from. */
    share: number;
    still: boolean;
    /**
     * The other part whose predictions about it weigh most, and whether its primitive learned together with
     * that of this part; null where there is no other.
     */
    leader: { part: number; weight: number; met: boolean } | null;
}

/** The options of an `ImportTrainer`. */
export interface ImportRequest {
    /**
     * The primitive of the library that stands in for each part, in movements to which the part brings none
     * of its own; null where none is needed. Those of `companions` when not given.
     */
    companions?: (number | null)[];
    maxIterations: number;
    seed: number;
}
"#;

#[derive(Serialize)]
struct Misfit {
    reason: String,
    can_be_relearned: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Asked {
    companions: Option<Vec<Option<usize>>>,
    max_iterations: usize,
    seed: u32,
}

#[derive(Serialize)]
struct Motion {
    share: f64,
    still: bool,
    leader: Option<LeaderOfPart>,
}

#[derive(Serialize)]
struct LeaderOfPart {
    part: usize,
    weight: f64,
    met: bool,
}

impl From<PartMotion> for Motion {
    fn from(PartMotion { share, still, leader }: PartMotion) -> Self {
        let leader = leader.map(|Leader { part, weight, met }| LeaderOfPart { part, weight, met });
        Self { share, still, leader }
    }
}

#[wasm_bindgen]
impl Library {
    /// The motion of each part of a combination in the long run: whether it stands still, and which parts
    /// drive it.
    /// Under `alpha`, or the couplings of `nearestCouplings` where none are given.
    #[wasm_bindgen(unchecked_return_type = "PartMotion[]")]
    pub fn motion(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number[][] | null")] alpha: JsValue,
    ) -> Result<JsValue, VcgpdmError> {
        let uses = uses_of(&uses)?;
        let alpha = self.couplings(&uses, &alpha)?;
        let motion = self.trained.library.motion(&uses, &alpha)?;
        to_js(&motion.into_iter().map(Motion::from).collect::<Vec<_>>())
    }

    /// These primitives as a library of their own, with the pose maps that their latents mean something
    /// under. Movements of which all primitives are among them come along.
    pub fn select(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] primitives: JsValue,
    ) -> Result<Library, VcgpdmError> {
        let chosen = uses_of(&primitives)?;
        Ok(Library { trained: Rc::new(self.trained.select(&chosen)?) })
    }

    /// Why primitives of another library cannot be added as they are; null: they can.
    #[wasm_bindgen(unchecked_return_type = "Misfit | null")]
    pub fn misfit(&self, other: &Library) -> Result<JsValue, VcgpdmError> {
        match self.trained.check_fit(&other.trained) {
            Ok(()) => Ok(JsValue::NULL),
            Err(misfit) => {
                to_js(&Misfit { reason: misfit.to_string(), can_be_relearned: misfit.can_be_relearned() })
            }
        }
    }

    /// A library with the primitives of another one, and its movements; those that are here already are not
    /// added twice. Throws the reason of `misfit`.
    pub fn add(&self, other: &Library) -> Result<Library, VcgpdmError> {
        let mut trained = TrainedLibrary::clone(&self.trained);
        trained.merge(&other.trained)?;
        Ok(Library { trained: Rc::new(trained) })
    }

    /// The primitives that stand in for parts to which another library brings none, when nobody says which:
    /// of each part one that is called as a movement or primitive there, else the first.
    #[wasm_bindgen(unchecked_return_type = "(number | null)[]")]
    pub fn companions(&self, other: &Library) -> Result<JsValue, VcgpdmError> {
        to_js(&self.trained.companions(&other.trained))
    }
}

fn request_of(library: &Library, other: &Library, request: &JsValue) -> Result<ImportRequest, VcgpdmError> {
    let Asked { companions, max_iterations, seed } = from_js(ErrorCode::Training, "the request", request)?;
    let companions = companions.unwrap_or_else(|| library.trained.companions(&other.trained));
    Ok(ImportRequest { companions, max_iterations, seed })
}

/// Primitives of another library, learned again under the pose maps of this one, step by step. All else in it
/// stays.
#[wasm_bindgen]
pub struct ImportTrainer {
    import: Import,
}

#[wasm_bindgen]
impl ImportTrainer {
    /// Prepares all primitives of `other`, without a clip: from the latents that it keeps of its movements;
    /// where it keeps only their first frames, from rollouts.
    #[wasm_bindgen(constructor)]
    pub fn new(
        library: &Library,
        other: &Library,
        #[wasm_bindgen(unchecked_param_type = "ImportRequest")] request: JsValue,
    ) -> Result<ImportTrainer, VcgpdmError> {
        let request = request_of(library, other, &request)?;
        let frames = other.trained.import_frames();
        Ok(ImportTrainer { import: Import::new(&library.trained, &other.trained, frames, &request)? })
    }

    /// Prepares all primitives of `other`, one of each part at most, from clips of their movement, which must
    /// have the library's body.
    #[wasm_bindgen(js_name = fromClips)]
    pub fn from_clips(
        library: &Library,
        other: &Library,
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_param_type = "ImportRequest")] request: JsValue,
    ) -> Result<ImportTrainer, VcgpdmError> {
        let request = request_of(library, other, &request)?;
        let clips = library.encode(clips)?;
        let frames = ImportFrames::Clips(&clips);
        Ok(ImportTrainer { import: Import::new(&library.trained, &other.trained, frames, &request)? })
    }

    /// One iteration of the optimiser. The bound is that of the frames under what stays.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        progress_to_js(&self.import.step())
    }

    /// How much of what the frames show of each part the pose maps of the library do not reproduce: 0
    /// nothing, 1 so much that its mean pose would do as well. No dynamics can bring it back.
    pub fn lost(&self) -> Vec<f64> {
        self.import.lost()
    }

    /// The library with the primitives as they are at the best bound so far.
    pub fn library(&self) -> Result<Library, VcgpdmError> {
        Ok(Library { trained: Rc::new(self.import.finish()?) })
    }
}
