//! A trained model of any kind, of a body or of tables.

use crate::values::error::{ErrorCode, VcgpdmError};
use std::sync::Arc;
#[cfg(feature = "training")]
use vcgpdm_core::models::SeriesModel;
use vcgpdm_core::models::variational::Vcgpdm;
use vcgpdm_core::models::{Body, ColumnMapping, Coupled, Model as TrainedModel};

/// The couplings and latents of a model, which vCGPDM and vGPDM alone have.
pub(crate) fn coupled<S: ColumnMapping>(model: &TrainedModel<S>) -> Result<Coupled<'_, S>, VcgpdmError> {
    model.coupled().ok_or_else(|| {
        let found = format_args!("expected a vcgpdm or vgpdm model, found a {} model", model.kind().id());
        VcgpdmError::new(ErrorCode::Model, &found)
    })
}

/// A model of a body or of tables.
#[derive(Clone)]
pub(crate) enum Trained {
    Body(Arc<TrainedModel>),
    #[cfg(feature = "training")]
    Table(Arc<SeriesModel>),
}

impl Trained {
    /// The model of a body; an error for a model of tables.
    pub fn body(&self) -> Result<&Arc<TrainedModel>, VcgpdmError> {
        match self {
            Trained::Body(model) => Ok(model),
            #[cfg(feature = "training")]
            Trained::Table(_) => {
                let words = "expected a model of a body, found a model of tables";
                Err(VcgpdmError::new(ErrorCode::Model, &words))
            }
        }
    }

    /// The latent model of a vCGPDM or vGPDM.
    pub fn latent(&self) -> Result<&Vcgpdm, VcgpdmError> {
        match self {
            Trained::Body(model) => Ok(coupled(model)?.model),
            #[cfg(feature = "training")]
            Trained::Table(model) => Ok(coupled(model)?.model),
        }
    }
}

/// The names of all columns.
pub(crate) fn column_names<S: ColumnMapping>(body: &Body<S>) -> Vec<String> {
    (0..body.column_means.len()).map(|column| body.mapping.column_name(column)).collect()
}
