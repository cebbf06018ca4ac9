//! Trainings of libraries: of primitives, and of couplings alone.

use crate::arguments::{Text, Whole};
use crate::clip::TrainingSet;
use crate::convert::{from_js, rows, to_js};
use crate::error::{ErrorCode, VcgpdmError};
use crate::library::{Library, uses_of};
use crate::model::Model;
use crate::progress::progress_to_js;
use crate::settings::{Task, settings_from_js};
use serde::Deserialize;
use std::rc::Rc;
use vcgpdm::models::library::{
    CouplingTrainer as Fit, LibraryPlan, LibraryTrainer as Training, PlannedMovement,
};
use vcgpdm::models::{Dataset, Source};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/**
 * What a library learns: movements with how many clips each has, in order, and of each part whether its
 * primitive is the same in all.
 */
export interface LibraryPlan {
    movements: { name: string; sequences: number }[];
    shared: boolean[];
}
"#;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Planned {
    movements: Vec<PlannedName>,
    shared: Vec<bool>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PlannedName {
    name: String,
    sequences: usize,
}

/// A training of a library under way, step by step.
#[wasm_bindgen]
pub struct LibraryTrainer {
    training: Training,
}

#[wasm_bindgen]
impl LibraryTrainer {
    /// Prepares the clips, which are those of the plan's movements one after the other, and finds the
    /// starting point.
    #[wasm_bindgen(constructor)]
    pub fn new(
        clips: &TrainingSet,
        #[wasm_bindgen(unchecked_param_type = "TrainingSettings")] settings: JsValue,
        #[wasm_bindgen(unchecked_param_type = "LibraryPlan")] plan: JsValue,
    ) -> Result<LibraryTrainer, VcgpdmError> {
        let (Task { parts, frames_per_second, seed }, settings) = settings_from_js(&settings)?;
        let Planned { movements, shared } = from_js(ErrorCode::Training, "the plan", &plan)?;
        let movements = movements
            .into_iter()
            .map(|movement| PlannedMovement { name: movement.name, sequences: movement.sequences });
        let plan = LibraryPlan::new(movements.collect(), shared)
            .map_err(|reason| VcgpdmError::new(ErrorCode::Training, &reason))?;
        let sources: Vec<Source> =
            clips.clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
        let dataset = Dataset::new(&sources, &parts, frames_per_second)?;
        Ok(LibraryTrainer { training: Training::new(&dataset, &plan, &settings, seed)? })
    }

    /// One iteration of the optimiser: a few milliseconds to some tens.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        progress_to_js(&self.training.step())
    }

    /// Allows this many more iterations. The training continues where it stopped.
    pub fn extend(&mut self, iterations: &Whole) -> Result<(), VcgpdmError> {
        self.training.extend(iterations.count(ErrorCode::Training, "the number of iterations")?);
        Ok(())
    }

    /// What the user should know, in sentences without a full stop: that a clip does not move or was given
    /// twice, that a part never changes, and which settings are more than the data allow and were reduced.
    pub fn notices(&self) -> Vec<String> {
        self.training.warnings()
    }

    /// The best library so far, at any time.
    pub fn library(&self) -> Result<Library, VcgpdmError> {
        Ok(Library { trained: Rc::new(self.training.finish()?) })
    }
}

/// A fit of couplings under way: of a combination, to clips, while its primitives stay.
#[wasm_bindgen]
pub struct CouplingTrainer {
    fit: Fit,
}

#[wasm_bindgen]
impl CouplingTrainer {
    /// Prepares the clips, which must have the library's body.
    #[wasm_bindgen(constructor)]
    pub fn new(
        library: &Library,
        #[wasm_bindgen(unchecked_param_type = "number[]")] uses: JsValue,
        clips: &TrainingSet,
        max_iterations: &Whole,
    ) -> Result<CouplingTrainer, VcgpdmError> {
        let iterations = max_iterations.count(ErrorCode::Training, "the number of iterations")?;
        let clips = library.encode(clips)?;
        Ok(CouplingTrainer { fit: Fit::new(&library.trained, &uses_of(&uses)?, &clips, iterations)? })
    }

    /// One iteration of the optimiser. The bound is that of the clips under the stored primitives.
    #[wasm_bindgen(unchecked_return_type = "TrainingProgress")]
    pub fn step(&mut self) -> Result<JsValue, VcgpdmError> {
        progress_to_js(&self.fit.step())
    }

    /// The best couplings so far, `alpha[source][target]`.
    #[wasm_bindgen(unchecked_return_type = "number[][]")]
    pub fn alpha(&self) -> Result<JsValue, VcgpdmError> {
        to_js(&rows(&self.fit.alpha()))
    }

    /// A library with the combination as a movement of that name, which starts where the clips do; a
    /// combination of the same name makes way, a learned movement does not.
    pub fn library(&self, name: &Text) -> Result<Library, VcgpdmError> {
        let name = name.get(ErrorCode::Model, "the name")?;
        Ok(Library { trained: Rc::new(self.fit.finish(&name)?) })
    }

    /// The combination with the best couplings so far.
    pub fn model(&self) -> Result<Model, VcgpdmError> {
        let trained = self.fit.finish("")?;
        Ok(Model::from(trained.movement(trained.library.movements.len() - 1)?))
    }
}
