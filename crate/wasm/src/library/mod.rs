//! Libraries of primitives: their contents, and combinations of primitives.

pub mod recognition;
pub mod trainers;
pub mod walk;

use crate::data::body::BodyInfo;
use crate::data::clip::TrainingSet;
use crate::models::model::{Model, ModelProvenance, PartInfo, part_infos};
use crate::values::arguments::{Text, Whole};
use crate::values::convert::{from_js, matrix, rows, to_js, to_js_joined};
use crate::values::error::{ErrorCode, VcgpdmError};
use nalgebra::DMatrix;
use serde::Serialize;
use std::sync::Arc;
use vcgpdm_core::models::SequenceInfo;
use vcgpdm_core::models::library::{
    CouplingsFrom, EncodedClip, LearnedMovement, Origin, Primitive, Relearned, TrainedLibrary,
};
use wasm_bindgen::prelude::*;

/// A primitive: the dynamics of one part.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
struct PrimitiveInfo<'a> {
    name: &'a str,
    /// The index of the part of the primitive.
    part: usize,
    origin: PrimitiveOrigin,
}

/// A movement of a library.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
struct MovementInfo<'a> {
    name: &'a str,
    /// The primitive of each part.
    uses: &'a [usize],
    /// Coupling variances, `alpha[source][target]`.
    alpha: Vec<Vec<f64>>,
    /// Whether the primitives were trained on the movement.
    learned: bool,
    couplings: &'a CouplingsFrom,
    sequences: &'a [SequenceInfo],
}

/// The parts, primitives and movements of a library.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub(crate) struct LibraryInfo<'a> {
    parts: Vec<PartInfo<'a>>,
    primitives: Vec<PrimitiveInfo<'a>>,
    movements: Vec<MovementInfo<'a>>,
    /// Order p of the dynamics.
    order: usize,
    /// Seconds from one frame to the next.
    frame_time: f64,
    #[cfg_attr(feature = "types", ts(type = "Provenance"))]
    provenance: ModelProvenance<'a>,
}

/// Indices of primitives of a library.
pub(crate) fn uses_of(uses: &JsValue) -> Result<Vec<usize>, VcgpdmError> {
    from_js(ErrorCode::Model, "the primitives", uses)
}

/// A library of primitives.
#[wasm_bindgen]
pub struct Library {
    pub(crate) trained: Arc<TrainedLibrary>,
}

#[wasm_bindgen]
impl Library {
    /// Reads the document of a library. If the text is not a valid library, throws the reason and the path of
    /// the field.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Library, VcgpdmError> {
        let text = text.get(ErrorCode::Model, "the document")?;
        Ok(Library { trained: Arc::new(TrainedLibrary::from_json(&text)?) })
    }

    /// The library as a JSON document.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> Result<String, VcgpdmError> {
        Ok(self.trained.to_json()?)
    }

    /// The parts, primitives and movements of the library.
    #[wasm_bindgen(unchecked_return_type = "LibraryInfo")]
    pub fn info(&self) -> Result<JsValue, VcgpdmError> {
        let TrainedLibrary { library, body, provenance } = &*self.trained;
        let mut rest = &body.sequences[..];
        let movement = |movement: &LearnedMovement| {
            let (own, others) = rest.split_at(movement.starts.len().min(rest.len()));
            rest = others;
            (own, movement.clone())
        };
        let movements: Vec<_> = library.movements.iter().map(movement).collect();
        let info = LibraryInfo {
            parts: part_infos(body.layout.parts(), &library.parts),
            primitives: library
                .primitives
                .iter()
                .enumerate()
                .map(|(a, Primitive { name, part, .. })| PrimitiveInfo {
                    name,
                    part: *part,
                    origin: self.trained.origin(a).into(),
                })
                .collect(),
            movements: movements
                .iter()
                .map(|(sequences, movement)| MovementInfo {
                    name: &movement.name,
                    uses: &movement.uses,
                    alpha: rows(&movement.alpha),
                    learned: movement.sums.is_some(),
                    couplings: &movement.couplings,
                    sequences,
                })
                .collect(),
            order: library.order,
            frame_time: body.frame_time,
            provenance: ModelProvenance::new(provenance, body.layout.parts(), Some(&library.terms))?,
        };
        to_js_joined(&info, &BodyInfo::new(body.mapping.skeleton()))
    }

    /// The learned model of a movement.
    pub fn movement(&self, index: &Whole) -> Result<Model, VcgpdmError> {
        let index = index.count(ErrorCode::Model, "the movement")?;
        Ok(Model::from(self.trained.movement(index)?))
    }

    /// The model of a combination, which has one primitive for each part. The couplings are `alpha`, by
    /// default those of `nearestCouplings`.
    pub fn combination(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number[][] | null")] alpha: JsValue,
    ) -> Result<Model, VcgpdmError> {
        let uses = uses_of(&uses)?;
        let alpha = self.couplings(&uses, &alpha)?;
        Ok(Model::from(self.trained.combination(&uses, &alpha)?))
    }

    /// Couplings `alpha[source][target]` for a combination without fitted couplings, each from a trained
    /// movement that uses the primitives of both parts. Among several such movements, the one most like the
    /// combination is taken. Primitives that never met get the largest variance, 10.
    #[wasm_bindgen(js_name = nearestCouplings, unchecked_return_type = "number[][]")]
    pub fn nearest_couplings(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
    ) -> Result<JsValue, VcgpdmError> {
        let uses = uses_of(&uses)?;
        self.trained.library.check_uses(&uses)?;
        to_js(&rows(&self.trained.library.nearest_couplings(&uses)))
    }

    /// A library with the combination and its couplings added as a movement of that name. It replaces a
    /// combination of the same name, but not a learned movement. `couplings` states the origin of the
    /// couplings, such as a fit. Without `couplings`, the origin is the nearest movement or the user.
    #[wasm_bindgen(js_name = withCombination)]
    pub fn with_combination(
        &self,
        name: &Text,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number[][]")] alpha: JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "CouplingsFrom | null")] couplings: JsValue,
    ) -> Result<Library, VcgpdmError> {
        let name = name.get(ErrorCode::Model, "the name")?;
        let uses = uses_of(&uses)?;
        let alpha: Vec<Vec<f64>> = from_js(ErrorCode::Model, "the couplings", &alpha)?;
        let from: Option<CouplingsFrom> =
            from_js(ErrorCode::Model, "where the couplings come from", &couplings)?;
        let mut trained = TrainedLibrary::clone(&self.trained);
        trained.add_combination(&name, &uses, &matrix(&alpha), from)?;
        Ok(Library { trained: Arc::new(trained) })
    }
}

impl Library {
    /// The clips as centred columns of the library's parts. The clips must have the body of the library.
    pub(crate) fn encode(&self, clips: &TrainingSet) -> Result<Vec<EncodedClip>, VcgpdmError> {
        Ok(clips.clips.iter().map(|clip| self.trained.encode(clip)).collect::<Result<_, _>>()?)
    }

    /// The given couplings, or by default the nearest couplings.
    pub(crate) fn couplings(&self, uses: &[usize], alpha: &JsValue) -> Result<DMatrix<f64>, VcgpdmError> {
        let given: Option<Vec<Vec<f64>>> = from_js(ErrorCode::Model, "the couplings", alpha)?;
        self.trained.library.check_uses(uses)?;
        Ok(given.map_or_else(|| self.trained.library.nearest_couplings(uses), |alpha| matrix(&alpha)))
    }
}

/// The training that learned a primitive. For a primitive that was learned again, this is the later training.
#[derive(Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PrimitiveOrigin {
    engine: String,
    seed: u32,
    /// The bound that the training reached, in nats.
    bound: f64,
    iterations: usize,
    note: Option<String>,
    /// The clips of the training.
    clips: Vec<SequenceInfo>,
    /// The primitive of another library from which this primitive was learned again. Null if this library
    /// learned the primitive from clips.
    relearned: Option<Relearned>,
}

impl From<Origin> for PrimitiveOrigin {
    fn from(Origin { training, clips, relearned }: Origin) -> Self {
        Self {
            seed: training.seed,
            bound: training.bound(),
            engine: training.engine,
            iterations: training.iterations,
            note: training.note,
            clips,
            relearned,
        }
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
        to_js(&motion)
    }

    /// A new library with only these primitives and the pose maps of their parts. It also contains each
    /// movement whose primitives are all among them.
    pub fn select(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number[]")] primitives: JsValue,
    ) -> Result<Library, VcgpdmError> {
        let chosen = uses_of(&primitives)?;
        Ok(Library { trained: Arc::new(self.trained.select(&chosen)?) })
    }

    /// A new library that also has the primitives and movements of another library. Primitives and movements
    /// that this library already has are not added again. Throws the reason if the primitives do not fit.
    pub fn add(&self, other: &Library) -> Result<Library, VcgpdmError> {
        let mut trained = TrainedLibrary::clone(&self.trained);
        trained.merge(&other.trained)?;
        Ok(Library { trained: Arc::new(trained) })
    }
}
