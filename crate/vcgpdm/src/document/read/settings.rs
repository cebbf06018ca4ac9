//! What a training was asked for.

use crate::json::checks::count;
use crate::json::{Field, FieldError, Object};
use crate::models::{DmpSettings, MapSettings, ModelKind, Settings, TmpSettings, VariationalSettings};
use std::ops::RangeInclusive;

// Training refuses what is larger.
pub(super) const MOST_LATENT: usize = 100;
pub(super) const MOST_IPS: usize = 1000;
pub(super) const MOST_ORDER: usize = 100;

/// What training was asked for, and the seed.
pub(super) fn variational_settings(field: Field) -> Result<(VariationalSettings, u32), FieldError> {
    let mut object = field.object()?;
    let settings = VariationalSettings {
        latent: in_range(&object.get("latent")?, 1..=MOST_LATENT)?,
        dynamics_ips: in_range(&object.get("dynamics_ips")?, 1..=MOST_IPS)?,
        pose_ips: in_range(&object.get("pose_ips")?, 1..=MOST_IPS)?,
        order: in_range(&object.get("order")?, 1..=MOST_ORDER)?,
        max_iterations: object.get("max_iterations")?.whole()?,
    };
    let seed = seed(&mut object)?;
    object.end()?;
    Ok((settings, seed))
}

/// The same for a model that is not variational.
pub(super) fn baseline_settings(field: Field, kind: ModelKind) -> Result<(Settings, u32), FieldError> {
    let mut object = field.clone().object()?;
    let (settings, seed) = match kind {
        ModelKind::MapGpdm => (Settings::MapGpdm(map_settings(&mut object)?), seed(&mut object)?),
        ModelKind::MapCgpdm => (Settings::MapCgpdm(map_settings(&mut object)?), seed(&mut object)?),
        ModelKind::Tmp => {
            let primitives = object.optional("primitives").map(|field| in_range(&field, 1..=MOST_IPS));
            let time = object.optional("normalised_time").map(|field| in_range(&field, 0..=1)).transpose()?;
            let normalised_time = time == Some(1);
            let primitives = primitives.transpose()?;
            (Settings::Tmp(TmpSettings { primitives, normalised_time }), 0)
        }
        ModelKind::DmpDiscrete => (Settings::DmpDiscrete(dmp_settings(&mut object)?), 0),
        ModelKind::DmpRhythmic => (Settings::DmpRhythmic(dmp_settings(&mut object)?), 0),
        ModelKind::Vcgpdm | ModelKind::Vgpdm => return Err(field.error("expected settings of a baseline")),
    };
    object.end()?;
    Ok((settings, seed))
}

fn map_settings(object: &mut Object) -> Result<MapSettings, FieldError> {
    Ok(MapSettings {
        latent: in_range(&object.get("latent")?, 1..=MOST_LATENT)?,
        order: in_range(&object.get("order")?, 1..=MOST_ORDER)?,
        max_iterations: object.get("max_iterations")?.whole()?,
        // Yes is 1.
        balanced: in_range(&object.get("balanced")?, 0..=1)? == 1,
        linear: object.optional("linear").map(|field| in_range(&field, 0..=1)).transpose()? == Some(1),
    })
}

fn dmp_settings(object: &mut Object) -> Result<DmpSettings, FieldError> {
    Ok(DmpSettings { bases: in_range(&object.get("bases")?, 1..=MOST_IPS)? })
}

/// A setting, within what training could have been asked for.
fn in_range(field: &Field, range: RangeInclusive<usize>) -> Result<usize, FieldError> {
    count(field, field.whole()?, range)
}

fn seed(object: &mut Object) -> Result<u32, FieldError> {
    let field = object.get("seed")?;
    u32::try_from(field.whole()?).map_err(|_| field.wrong("a whole number from 0 to 4294967295"))
}
