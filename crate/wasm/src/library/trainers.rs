//! Trainings of libraries: one trains primitives and couplings, one fits only couplings.

use crate::data::clip::TrainingSet;
use crate::library::{Library, uses_of};
use crate::models::model::Model;
use crate::models::settings::{Task, body_parts, settings_from_js};
use crate::values::arguments::{Text, Whole};
use crate::values::convert::{from_js, rows, to_js};
use crate::values::error::{ErrorCode, VcgpdmError};
use crate::values::wording::quoted;
use serde::de::Visitor;
use serde::{Deserialize, Deserializer};
use std::fmt::{self, Formatter};
use std::sync::Arc;
use vcgpdm_core::models::library::{
    CouplingTrainer as Fit, LibraryPlan, LibraryTrainer as Training, PlannedMovement,
};
use vcgpdm_core::models::{Dataset, DatasetError, Source, VariationalSettings};
use vcgpdm_core::motion::parts::PartSpec;
use wasm_bindgen::prelude::*;

/// The plan of a library's training: the movements in order, the number of clips of each movement (absent:
/// 1), and the parts whose primitive all movements share: by name, or for each part whether it is shared.
/// Absent: no part is shared.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "LibraryPlan"))]
pub(crate) struct Planned {
    #[cfg_attr(feature = "types", ts(inline))]
    movements: Vec<PlannedName>,
    #[cfg_attr(feature = "types", ts(type = "string[] | boolean[]", optional))]
    shared: Option<Vec<Shared>>,
}

/// A part by its name, or whether the part at this place is shared.
enum Shared {
    Name(String),
    Place(bool),
}

impl<'de> Deserialize<'de> for Shared {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SharedVisitor)
    }
}

struct SharedVisitor;

impl Visitor<'_> for SharedVisitor {
    type Value = Shared;

    fn expecting(&self, formatter: &mut Formatter) -> fmt::Result {
        formatter.write_str("the name of a part, or true or false")
    }

    fn visit_bool<E>(self, shared: bool) -> Result<Shared, E> {
        Ok(Shared::Place(shared))
    }

    fn visit_str<E>(self, name: &str) -> Result<Shared, E> {
        Ok(Shared::Name(name.to_owned()))
    }
}

/// For each part, whether all movements share its primitive.
fn shared_parts(given: Vec<Shared>, parts: &[PartSpec]) -> Result<Vec<bool>, VcgpdmError> {
    let is_name = |one: &Shared| matches!(one, Shared::Name(_));
    if given.is_empty() || given.iter().any(is_name) {
        let mut shared = vec![false; parts.len()];
        for one in given {
            let Shared::Name(name) = one else {
                return Err(refused_part("the names of parts, or true or false for each", "both"));
            };
            let place = parts.iter().position(|part| part.name == name);
            let place = place.ok_or_else(|| {
                let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
                refused_part(&format!("some of the parts {}", names.join(", ")), &quoted(&name))
            })?;
            shared[place] = true;
        }
        return Ok(shared);
    }
    Ok(given.iter().map(|one| matches!(one, Shared::Place(true))).collect())
}

fn refused_part(expected: &str, found: &str) -> VcgpdmError {
    let words = format_args!("the plan: `shared`: expected {expected}, found {found}");
    VcgpdmError::new(ErrorCode::Training, &words)
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
struct PlannedName {
    name: String,
    #[cfg_attr(feature = "types", ts(optional))]
    sequences: Option<usize>,
}

/// Trains a library step by step.
#[wasm_bindgen]
pub struct LibraryTrainer {
    training: Training,
}

#[wasm_bindgen]
impl LibraryTrainer {
    /// Prepares the clips and finds the starting point. The clips are in the order of the plan's movements.
    #[wasm_bindgen(constructor)]
    pub fn new(
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_param_type = "TrainingOptions")] settings: JsValue,
        #[wasm_bindgen(unchecked_param_type = "LibraryPlan")] plan: JsValue,
    ) -> Result<LibraryTrainer, VcgpdmError> {
        let skeleton = &clips.clips.first().ok_or(DatasetError::Empty)?.skeleton;
        let (Task { parts, frames_per_second, seed }, settings) =
            settings_from_js(&settings, &VariationalSettings::for_library(), |parts| {
                body_parts(parts, skeleton)
            })?;
        let Planned { movements, shared } = from_js(ErrorCode::Training, "the plan", &plan)?;
        let movements = movements.into_iter().map(|PlannedName { name, sequences }| PlannedMovement {
            name,
            sequences: sequences.unwrap_or(1),
        });
        let shared = shared_parts(shared.unwrap_or_default(), &parts)?;
        let plan = LibraryPlan::new(movements.collect(), shared)
            .map_err(|reason| VcgpdmError::new(ErrorCode::Training, &reason))?;
        let sources: Vec<Source> =
            clips.clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
        let dataset = Dataset::new(&sources, &parts, frames_per_second)?;
        Ok(LibraryTrainer { training: Training::new(&dataset, &plan, &settings, seed)? })
    }

    /// One step: an iteration of the optimiser, a few milliseconds to some tens, or a round of own rollouts of a
    /// movement.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        to_js(&self.training.step())
    }

    /// Allows this many more iterations. The training continues where it stopped.
    pub fn extend(&mut self, iterations: &Whole) -> Result<(), VcgpdmError> {
        self.training.extend(iterations.count(ErrorCode::Training, "the number of iterations")?);
        Ok(())
    }

    /// Notices for the user, as sentences without a full stop: a clip does not move or was given twice, a
    /// part never changes, or a setting exceeded the limit of the data and was reduced.
    pub fn notices(&self) -> Vec<String> {
        self.training.warnings()
    }

    /// The best library so far. It can be read at any time.
    pub fn library(&self) -> Result<Library, VcgpdmError> {
        Ok(Library { trained: Arc::new(self.training.finish()?) })
    }
}

/// Fits the couplings of a combination to clips, step by step. The primitives stay unchanged.
#[wasm_bindgen]
pub struct CouplingTrainer {
    fit: Fit,
}

#[wasm_bindgen]
impl CouplingTrainer {
    /// Prepares the clips. They must have the body of the library. `max_iterations` is by default 250.
    #[wasm_bindgen(constructor)]
    pub fn new(
        library: &Library,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        clips: &TrainingSet,
        max_iterations: Option<Whole>,
    ) -> Result<CouplingTrainer, VcgpdmError> {
        let usual = VariationalSettings::default().max_iterations;
        let iterations = max_iterations.map_or(Ok(usual), |iterations| {
            iterations.count(ErrorCode::Training, "the number of iterations")
        })?;
        let clips = library.encode(clips)?;
        Ok(CouplingTrainer { fit: Fit::new(&library.trained, &uses_of(&uses)?, &clips, iterations)? })
    }

    /// One iteration of the optimiser. The reported bound is the bound of the clips under the stored
    /// primitives.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        to_js(&self.fit.step())
    }

    /// The best couplings so far, `alpha[source][target]`.
    #[wasm_bindgen(unchecked_return_type = "number[][]")]
    pub fn alpha(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&rows(&self.fit.alpha()))
    }

    /// A library with the combination added as a movement of that name. The movement starts as the clips do.
    /// It replaces a combination of the same name, but not a learned movement.
    pub fn library(&self, name: &Text) -> Result<Library, VcgpdmError> {
        let name = name.get(ErrorCode::Model, "the name")?;
        Ok(Library { trained: Arc::new(self.fit.finish(&name)?) })
    }

    /// The model of the combination with the best couplings so far.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        let trained = self.fit.finish("")?;
        Ok(Model::from(trained.movement(trained.library.movements.len() - 1)?))
    }
}
