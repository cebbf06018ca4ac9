//! The settings of a training as documents contain them: true is written as 1, and a setting that the
//! training chooses is absent.

use crate::json::checks::count;
use crate::json::{Field, FieldError, Object, Value};
use crate::models::{
    BALANCED, DmpSettings, MOST_DIMENSIONS, MOST_INDUCING, MapSettings, ModelKind, POSE_WEIGHTS, PoseWeight,
    Settings, TmpSettings, VariationalSettings,
};
use std::ops::RangeInclusive;

/// Writes settings and seed.
pub fn write_settings(settings: &Settings, seed: u32) -> Value {
    match settings {
        Settings::Vcgpdm(settings) | Settings::Vgpdm(settings) => variational_value(settings, seed),
        Settings::MapGpdm(settings) | Settings::MapCgpdm(settings) => {
            let MapSettings { latent, order, max_iterations, balanced, linear } = settings;
            let mut fields = vec![
                ("balanced", Value::whole(usize::from(*balanced))),
                ("latent", Value::whole(*latent)),
                ("max_iterations", Value::whole(*max_iterations)),
                ("order", Value::whole(*order)),
                ("seed", Value::Number(seed.into())),
            ];
            // Absent if false, as in documents from before this setting existed.
            fields.extend(linear.then(|| ("linear", Value::whole(1))));
            Value::of_fields(fields)
        }
        Settings::Tmp(TmpSettings { primitives, normalised_time }) => {
            let count = primitives.map(|count| ("primitives".to_owned(), Value::whole(count)));
            // Absent if false, as in documents from before this setting existed.
            let time = normalised_time.then(|| ("normalised_time".to_owned(), Value::whole(1)));
            Value::Object(time.into_iter().chain(count).collect())
        }
        Settings::DmpDiscrete(DmpSettings { bases }) | Settings::DmpRhythmic(DmpSettings { bases }) => {
            Value::object([("bases", Value::whole(*bases))])
        }
    }
}

/// Reads the settings of this kind of model, and the seed.
pub fn read_settings(field: Field, kind: ModelKind) -> Result<(Settings, u32), FieldError> {
    match kind {
        ModelKind::Vcgpdm => {
            read_variational(field).map(|(settings, seed)| (Settings::Vcgpdm(settings), seed))
        }
        ModelKind::Vgpdm => read_variational(field).map(|(settings, seed)| (Settings::Vgpdm(settings), seed)),
        _ => read_baseline(field, kind),
    }
}

/// Writes the settings of a variational model or library. A program that writes no other kind does not
/// contain the code of the others.
pub(super) fn write_variational(settings: &Settings, seed: u32) -> Value {
    settings.variational().map_or(Value::Null, |settings| variational_value(settings, seed))
}

fn variational_value(settings: &VariationalSettings, seed: u32) -> Value {
    let VariationalSettings {
        latent,
        dynamics_ips,
        pose_ips,
        order,
        max_iterations,
        pose_weight,
        uncoupled,
        own_rollouts,
    } = settings;
    let mut fields = vec![
        ("latent", Value::whole(*latent)),
        ("dynamics_ips", Value::whole(*dynamics_ips)),
        ("pose_ips", Value::whole(*pose_ips)),
        ("order", Value::whole(*order)),
        ("seed", Value::Number(seed.into())),
        ("max_iterations", Value::whole(*max_iterations)),
    ];
    // Absent if 1 or false, as in documents from before these settings existed.
    fields.extend((!pose_weight.is_plain()).then(|| match pose_weight {
        PoseWeight::Fixed(factor) => ("pose_weight", Value::Number(*factor)),
        PoseWeight::Balanced => ("pose_weight", Value::text(BALANCED)),
    }));
    fields.extend(uncoupled.then(|| ("uncoupled", Value::whole(1))));
    fields.extend(own_rollouts.then(|| ("own_rollouts", Value::whole(1))));
    Value::of_fields(fields)
}

/// Reads the settings of a variational model or library, and the seed.
pub(super) fn read_variational(field: Field) -> Result<(VariationalSettings, u32), FieldError> {
    let mut object = field.object()?;
    let settings = VariationalSettings {
        latent: in_range(&object.get("latent")?, 1..=MOST_DIMENSIONS)?,
        dynamics_ips: in_range(&object.get("dynamics_ips")?, 1..=MOST_INDUCING)?,
        pose_ips: in_range(&object.get("pose_ips")?, 1..=MOST_INDUCING)?,
        order: in_range(&object.get("order")?, 1..=MOST_DIMENSIONS)?,
        max_iterations: object.get("max_iterations")?.whole()?,
        pose_weight: object.optional("pose_weight").map_or(Ok(PoseWeight::default()), pose_weight)?,
        uncoupled: optional_flag(&mut object, "uncoupled")?,
        own_rollouts: optional_flag(&mut object, "own_rollouts")?,
    };
    let seed = seed(&mut object)?;
    object.end()?;
    Ok((settings, seed))
}

fn pose_weight(field: Field) -> Result<PoseWeight, FieldError> {
    match field.value() {
        Value::Text(text) if text == BALANCED => Ok(PoseWeight::Balanced),
        Value::Number(number) if POSE_WEIGHTS.contains(number) => Ok(PoseWeight::Fixed(*number)),
        _ => Err(field.wrong("balanced, or a number from 0.001 to 1000")),
    }
}

/// Reads the settings of a model that is not variational, and the seed, which is 0 for models without one.
pub(super) fn read_baseline(field: Field, kind: ModelKind) -> Result<(Settings, u32), FieldError> {
    let mut object = field.clone().object()?;
    let (settings, seed) = match kind {
        ModelKind::MapGpdm => (Settings::MapGpdm(map_settings(&mut object)?), seed(&mut object)?),
        ModelKind::MapCgpdm => (Settings::MapCgpdm(map_settings(&mut object)?), seed(&mut object)?),
        ModelKind::Tmp => {
            let primitives = object.optional("primitives").map(|field| in_range(&field, 1..=MOST_INDUCING));
            let settings = TmpSettings {
                primitives: primitives.transpose()?,
                normalised_time: optional_flag(&mut object, "normalised_time")?,
            };
            (Settings::Tmp(settings), 0)
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
        latent: in_range(&object.get("latent")?, 1..=MOST_DIMENSIONS)?,
        order: in_range(&object.get("order")?, 1..=MOST_DIMENSIONS)?,
        max_iterations: object.get("max_iterations")?.whole()?,
        balanced: in_range(&object.get("balanced")?, 0..=1)? == 1,
        linear: optional_flag(object, "linear")?,
    })
}

fn dmp_settings(object: &mut Object) -> Result<DmpSettings, FieldError> {
    Ok(DmpSettings { bases: in_range(&object.get("bases")?, 1..=MOST_INDUCING)? })
}

/// False if absent.
fn optional_flag(object: &mut Object, name: &str) -> Result<bool, FieldError> {
    let flag = object.optional(name).map(|field| in_range(&field, 0..=1)).transpose()?;
    Ok(flag == Some(1))
}

fn in_range(field: &Field, range: RangeInclusive<usize>) -> Result<usize, FieldError> {
    count(field, field.whole()?, range)
}

fn seed(object: &mut Object) -> Result<u32, FieldError> {
    let field = object.get("seed")?;
    u32::try_from(field.whole()?).map_err(|_| field.wrong("a whole number from 0 to 4294967295"))
}
