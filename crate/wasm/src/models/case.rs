//! A golden case, for measuring.

use crate::values::arguments::Text;
use crate::values::error::{ErrorCode, VcgpdmError};
use vcgpdm_core::models::variational::Workspace;
use vcgpdm_lab::golden::Case as GoldenCase;
use wasm_bindgen::prelude::*;

/// A problem and a point in its parameter space, for measuring one bound with its gradient.
#[wasm_bindgen]
pub struct Case {
    case: GoldenCase,
    workspace: Workspace,
}

#[wasm_bindgen]
impl Case {
    /// Reads a golden case.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &Text) -> Result<Case, VcgpdmError> {
        let text = text.get(ErrorCode::Settings, "the document")?;
        let case =
            GoldenCase::from_json(&text).map_err(|reason| VcgpdmError::new(ErrorCode::Settings, &reason))?;
        let workspace = case.objective.workspace(&case.params);
        Ok(Case { case, workspace })
    }

    /// The bound, in nats; its gradient is computed as well.
    #[wasm_bindgen(js_name = boundWithGradient)]
    pub fn bound_with_gradient(&mut self) -> Result<f64, VcgpdmError> {
        self.case.objective.compute_with_gradient(&self.case.params, &mut self.workspace)?;
        Ok(self.workspace.terms().total())
    }
}
