//! Moves primitives from one library to another.

use crate::clip::TrainingSet;
use crate::convert::{from_js, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::library::{Library, uses_of};
use crate::progress::progress_to_js;
use crate::settings::with_defaults;
use js_sys::Object;
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use vcgpdm::models::VariationalSettings;
use vcgpdm::models::library::{
    ImportFrames, ImportRequest, ImportTrainer as Import, Leader, PartMotion, TrainedLibrary,
};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/**
 * The reason why primitives of another library do not fit, and whether `ImportTrainer` can learn them again.
 */
export interface Misfit {
    reason: string;
    canBeRelearned: boolean;
}

/** The long-run motion of one part of a combination. */
export interface PartMotion {
    /**
     * The variance of the part's latents, divided by their variance in the training movements of its
     * primitive.
     */
    share: number;
    still: boolean;
    /**
     * The other part whose predictions of this part have the largest weight; null if there is only one part.
     * `met`: whether the primitives of the two parts learned from the same movement.
     */
    leader: { part: number; weight: number; met: boolean } | null;
}

/** The options of an `ImportTrainer`. Each has a default. */
export interface ImportRequest {
    /**
     * For each part, the primitive of this library to use in movements without an imported primitive of the
     * part; null if the part needs none. The default is the result of `companions`.
     */
    companions?: (number | null)[];
    /** Most iterations of the optimiser; absent: 250. */
    maxIterations?: number;
    /** Absent: 0. */
    seed?: number;
}
"#;

#[derive(Serialize)]
struct Misfit {
    reason: String,
    can_be_relearned: bool,
}

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Asked {
    companions: Option<Vec<Option<usize>>>,
    max_iterations: usize,
    seed: u32,
}

impl Default for Asked {
    fn default() -> Self {
        Self { companions: None, max_iterations: VariationalSettings::default().max_iterations, seed: 0 }
    }
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
    /// The long-run motion of each part of a combination: whether the part stands still, and which other part
    /// drives it. The couplings are `alpha`, by default those of `nearestCouplings`.
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

    /// A new library with only these primitives and the pose maps of their parts. It also contains each
    /// movement whose primitives are all among them.
    pub fn select(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] primitives: JsValue,
    ) -> Result<Library, VcgpdmError> {
        let chosen = uses_of(&primitives)?;
        Ok(Library { trained: Rc::new(self.trained.select(&chosen)?) })
    }

    /// The reason why the primitives of another library cannot be added unchanged; null if they can.
    #[wasm_bindgen(unchecked_return_type = "Misfit | null")]
    pub fn misfit(&self, other: &Library) -> Result<JsValue, VcgpdmError> {
        match self.trained.check_fit(&other.trained) {
            Ok(()) => Ok(JsValue::NULL),
            Err(misfit) => {
                to_js(&Misfit { reason: misfit.to_string(), can_be_relearned: misfit.can_be_relearned() })
            }
        }
    }

    /// A new library that also has the primitives and movements of another library. Primitives and movements
    /// that this library already has are not added again. Throws the reason of `misfit`.
    pub fn add(&self, other: &Library) -> Result<Library, VcgpdmError> {
        let mut trained = TrainedLibrary::clone(&self.trained);
        trained.merge(&other.trained)?;
        Ok(Library { trained: Rc::new(trained) })
    }

    /// The default primitives for parts of which the other library has no primitive. For each such part, this
    /// is a primitive with the name of a movement or primitive of the other library, or else the first
    /// primitive of the part.
    #[wasm_bindgen(unchecked_return_type = "(number | null)[]")]
    pub fn companions(&self, other: &Library) -> Result<JsValue, VcgpdmError> {
        to_js(&self.trained.companions(&other.trained))
    }
}

fn request_of(library: &Library, other: &Library, request: &JsValue) -> Result<ImportRequest, VcgpdmError> {
    let request = with_defaults(ErrorCode::Training, "the request", request, Object::new().into())?;
    let Asked { companions, max_iterations, seed } = from_js(ErrorCode::Training, "the request", &request)?;
    let companions = companions.unwrap_or_else(|| library.trained.companions(&other.trained));
    Ok(ImportRequest { companions, max_iterations, seed })
}

/// Learns primitives of another library again under the pose maps of this library, step by step. Everything
/// else in this library stays unchanged.
#[wasm_bindgen]
pub struct ImportTrainer {
    import: Import,
}

#[wasm_bindgen]
impl ImportTrainer {
    /// Prepares all primitives of `other` without clips. The frames come from the latents that `other` stores
    /// for its movements, or from rollouts if it stores only their first frames.
    #[wasm_bindgen(constructor)]
    pub fn new(
        library: &Library,
        other: &Library,
        #[wasm_bindgen(unchecked_optional_param_type = "ImportRequest")] request: JsValue,
    ) -> Result<ImportTrainer, VcgpdmError> {
        let request = request_of(library, other, &request)?;
        let frames = other.trained.import_frames();
        Ok(ImportTrainer { import: Import::new(&library.trained, &other.trained, frames, &request)? })
    }

    /// Prepares all primitives of `other`, at most one of each part, from clips of their movement. The clips
    /// must have the body of the library.
    #[wasm_bindgen(js_name = fromClips)]
    pub fn from_clips(
        library: &Library,
        other: &Library,
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_optional_param_type = "ImportRequest")] request: JsValue,
    ) -> Result<ImportTrainer, VcgpdmError> {
        let request = request_of(library, other, &request)?;
        let clips = library.encode(clips)?;
        let frames = ImportFrames::Clips(&clips);
        Ok(ImportTrainer { import: Import::new(&library.trained, &other.trained, frames, &request)? })
    }

    /// One iteration of the optimiser. The reported bound is the bound of the frames. Everything else in the
    /// library is fixed.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        progress_to_js(&self.import.step())
    }

    /// For each part, how much of the motion in the frames the pose maps of the library cannot reproduce. At
    /// 0 they reproduce everything; at 1 they are no better than the mean pose. Better dynamics cannot reduce
    /// this error.
    pub fn lost(&self) -> Vec<f64> {
        self.import.lost()
    }

    /// The library with the new primitives at the best bound so far.
    pub fn library(&self) -> Result<Library, VcgpdmError> {
        Ok(Library { trained: Rc::new(self.import.finish()?) })
    }
}
