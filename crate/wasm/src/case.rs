//! A golden case, for measuring.

use wasm_bindgen::prelude::*;

/// A problem and a point in its parameter space, for measuring one bound with its gradient.
#[wasm_bindgen]
pub struct Case {
    case: crate::golden::Case,
    workspace: crate::models::variational::elbo::Workspace,
}

#[wasm_bindgen]
impl Case {
    /// Reads a golden case.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &str) -> Result<Case, JsError> {
        let case = crate::golden::Case::from_json(text)?;
        let workspace = case.objective.workspace(&case.params);
        Ok(Case { case, workspace })
    }

    /// The bound, in nats; its gradient is computed as well.
    #[wasm_bindgen(js_name = boundWithGradient)]
    pub fn bound_with_gradient(&mut self) -> Result<f64, JsError> {
        self.case.objective.compute_with_gradient(&self.case.params, &mut self.workspace)?;
        Ok(self.workspace.terms().total())
    }
}
