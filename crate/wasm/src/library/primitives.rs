//! Moves primitives from one library to another.

use crate::library::{Library, uses_of};
use crate::values::convert::to_js;
use crate::values::error::VcgpdmError;
use std::rc::Rc;
use vcgpdm::models::library::TrainedLibrary;
use wasm_bindgen::prelude::*;

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
        Ok(Library { trained: Rc::new(self.trained.select(&chosen)?) })
    }

    /// A new library that also has the primitives and movements of another library. Primitives and movements
    /// that this library already has are not added again. Throws the reason if the primitives do not fit.
    pub fn add(&self, other: &Library) -> Result<Library, VcgpdmError> {
        let mut trained = TrainedLibrary::clone(&self.trained);
        trained.merge(&other.trained)?;
        Ok(Library { trained: Rc::new(trained) })
    }
}
