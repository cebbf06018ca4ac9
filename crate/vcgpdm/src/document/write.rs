//! From a model to the tree of its document.

use crate::document::{FORMAT, VERSION, Value};
use crate::models::variational::{BoundTerms, FittedExpert};
use crate::models::{BaselineModel, MotionModel, Provenance, VariationalSettings};

pub(super) fn variational(model: &MotionModel) -> Value {
    let fitted = &model.fitted;
    let parts = fitted.parts.iter().zip(model.body.layout.parts());
    let parts = Value::list(parts, |(map, spec)| {
        Value::object([
            ("name", Value::text(&spec.name)),
            ("joints", Value::wholes(&spec.joints)),
            ("lambda", Value::numbers(map.kernel.lambda.as_slice())),
            ("variance", Value::Number(map.kernel.variance)),
            ("beta", Value::Number(map.beta)),
            ("r", Value::matrix(&map.r)),
            ("v_mean", Value::matrix(&map.mean)),
            ("v_covariance", Value::matrix(&map.covariance)),
        ])
    });
    // The dynamics into each part; matrices over its sources stack them in order.
    let dynamics = Value::list(0..fitted.part_count(), |i| {
        Value::object([
            ("experts", Value::list(&fitted.experts, |row| expert(&row[i]))),
            ("u_covariance", Value::matrix(&fitted.dynamics_covariance[i])),
            ("sum_psi2", Value::matrix(&fitted.sums[i].psi2)),
            ("sum_psi1_mu", Value::matrix(&fitted.sums[i].psi1_mu)),
        ])
    });
    let sequences = Value::list(model.body.sequences.iter().zip(&fitted.starts), |(info, start)| {
        Value::object([
            ("clip", Value::text(&info.name)),
            ("sha256", Value::text(&info.sha256)),
            ("frames", Value::whole(info.frames)),
            // The latent means of the first frames of each part.
            ("start", Value::list(start, Value::matrix)),
        ])
    });
    Value::object([
        ("format", Value::text(FORMAT)),
        // The first version still says all there is to say.
        ("version", Value::whole(1)),
        ("pose", model.body.mapping.to_value()),
        ("frame_time", Value::Number(model.body.frame_time)),
        ("column_means", Value::numbers(&model.body.column_means)),
        ("order", Value::whole(fitted.order)),
        ("jitter", Value::Number(fitted.jitter)),
        ("parts", parts),
        ("dynamics", dynamics),
        // Row the source, column the target.
        ("alpha", Value::matrix(&fitted.alpha)),
        ("sequences", sequences),
        ("provenance", provenance(&model.provenance)),
    ])
}

/// A document of a model that only rolls out; `None` for a kind that has a document of its own.
pub(super) fn baseline(baseline: &BaselineModel) -> Option<Value> {
    let BaselineModel { body, model, record } = baseline;
    let fields = model.to_value()?;
    let parts = Value::list(body.layout.parts(), |spec| {
        Value::object([("name", Value::text(&spec.name)), ("joints", Value::wholes(&spec.joints))])
    });
    let sequences = Value::list(&body.sequences, |info| {
        Value::object([
            ("clip", Value::text(&info.name)),
            ("sha256", Value::text(&info.sha256)),
            ("frames", Value::whole(info.frames)),
        ])
    });
    let settings = record.settings.iter().map(|(name, value)| (name.clone(), Value::Number(*value)));
    let provenance = Value::object([
        ("engine", Value::text(&record.engine)),
        ("settings", Value::Object(settings.collect())),
        ("frames_per_second", Value::Number(record.frames_per_second)),
        ("objective", Value::Number(record.objective)),
        ("iterations", Value::whole(record.iterations)),
        ("note", record.note.as_deref().map_or(Value::Null, Value::text)),
    ]);
    Some(Value::object([
        ("format", Value::text(FORMAT)),
        ("version", Value::whole(VERSION)),
        ("kind", Value::text(model.kind().id())),
        ("pose", body.mapping.to_value()),
        ("frame_time", Value::Number(body.frame_time)),
        ("column_means", Value::numbers(&body.column_means)),
        ("parts", parts),
        ("sequences", sequences),
        ("model", fields),
        ("provenance", provenance),
    ]))
}

fn expert(expert: &FittedExpert) -> Value {
    Value::object([
        ("lambda", Value::numbers(expert.kernel.lambda.as_slice())),
        ("z", Value::matrix(&expert.z)),
        ("u_mean", Value::matrix(&expert.mean)),
    ])
}

fn provenance(provenance: &Provenance) -> Value {
    let Provenance { engine, settings, seed, frames_per_second, bound, terms, iterations, evaluations, note } =
        provenance;
    let VariationalSettings { latent, dynamics_ips, pose_ips, order, max_iterations } = settings;
    let settings = Value::object([
        ("latent", Value::whole(*latent)),
        ("dynamics_ips", Value::whole(*dynamics_ips)),
        ("pose_ips", Value::whole(*pose_ips)),
        ("order", Value::whole(*order)),
        ("seed", Value::Number((*seed).into())),
        ("max_iterations", Value::whole(*max_iterations)),
    ]);
    let BoundTerms { kinematics, dynamics, initial, entropy } = terms;
    let terms = Value::object([
        ("kinematics", Value::numbers(kinematics)),
        ("dynamics", Value::numbers(dynamics)),
        ("initial", Value::Number(*initial)),
        ("entropy", Value::Number(*entropy)),
    ]);
    Value::object([
        ("engine", Value::text(engine)),
        ("settings", settings),
        ("frames_per_second", Value::Number(*frames_per_second)),
        ("bound", Value::Number(*bound)),
        ("terms", terms),
        ("iterations", Value::whole(*iterations)),
        ("evaluations", Value::whole(*evaluations)),
        ("note", note.as_deref().map_or(Value::Null, Value::text)),
    ])
}
