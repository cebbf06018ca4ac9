//! The model of a fold, as a model that can be saved and opened.
//!
//! A model of the whole body learns in a fold from the columns of all parts side by side. In a file, its only
//! part has the columns in the order of the body.

use nalgebra::DMatrix;
use vcgpdm::gp::NumericsError;
use vcgpdm::models::map::{MapModel, MapPoseMap};
use vcgpdm::models::variational::PoseMap;
use vcgpdm::models::{Body, DatasetError, FittedModel, Model, ModelKind, Provenance};
use vcgpdm::motion::parts::{PartsLayout, presets};

/// The model with the body of its fold.
///
/// # Errors
/// The whole body is no part of it, or a covariance cannot be factorised.
pub fn fold_model(fitted: FittedModel, body: &Body, provenance: Provenance) -> Result<Model, DatasetError> {
    let parts = body.layout.parts().len();
    if parts == 1 || !matches!(fitted.kind(), ModelKind::Vgpdm | ModelKind::MapGpdm) {
        return Ok(Model { fitted, body: body.clone(), provenance });
    }
    let whole = &presets(body.mapping.skeleton())[0].parts;
    let layout = PartsLayout::new(whole, &body.mapping)?;
    let side_by_side: Vec<usize> = (0..parts).flat_map(|part| body.layout.columns(part).to_vec()).collect();
    let mut order: Vec<usize> = (0..side_by_side.len()).collect();
    order.sort_by_key(|place| side_by_side[*place]);
    let fitted = with_columns(fitted, &order).map_err(|reason| DatasetError::Training(reason.into()))?;
    Ok(Model { fitted, body: Body { layout, ..body.clone() }, provenance })
}

/// The model of one part whose columns are those at these places of the present ones.
fn with_columns(fitted: FittedModel, order: &[usize]) -> Result<FittedModel, NumericsError> {
    let ordered = |columns: &DMatrix<f64>| columns.select_columns(order);
    Ok(match fitted {
        FittedModel::Vcgpdm(mut model) => {
            for map in &mut model.parts {
                let (r, kernel, covariance) =
                    (map.r().clone(), map.kernel().clone(), map.covariance().clone());
                let noise =
                    order.iter().filter_map(|place| map.column_noise().get(*place).copied()).collect();
                *map = PoseMap::new(r, kernel, map.beta(), ordered(map.mean()), covariance, model.jitter)?
                    .with_column_noise(noise);
            }
            FittedModel::Vcgpdm(model)
        }
        FittedModel::Map(model) => {
            let parts = model.parts().iter().map(|map| MapPoseMap {
                latents: map.latents.clone(),
                kernel: map.kernel.clone(),
                coefficients: ordered(&map.coefficients),
            });
            FittedModel::Map(Box::new(MapModel::new(
                model.sequences().clone(),
                parts.collect(),
                model.dynamics().to_vec(),
                model.coefficients().to_vec(),
                model.linear().clone(),
                model.alpha().clone(),
            )))
        }
        other => other,
    })
}
