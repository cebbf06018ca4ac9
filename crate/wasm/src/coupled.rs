//! Models with couplings.

use crate::error::{ErrorCode, VcgpdmError};
use vcgpdm::models::{Coupled, Model};

/// The couplings and latents of a model, which only vCGPDM and vGPDM have.
pub(crate) fn coupled(model: &Model) -> Result<Coupled<'_>, VcgpdmError> {
    model.coupled().ok_or_else(|| {
        let found = format_args!("expected a vcgpdm or vgpdm model, found a {} model", model.kind().id());
        VcgpdmError::new(ErrorCode::Model, &found)
    })
}
