//! From a model to the tree of its document.

use super::{FORMAT, VERSION, Value};
use crate::model::{BoundTerms, FittedExpert};
use crate::motion_model::{MotionModel, Provenance};
use crate::training::TrainingSettings;
use nalgebra::DMatrix;

pub(super) fn document(model: &MotionModel) -> Value {
    let fitted = &model.fitted;
    let parts = fitted.parts.iter().zip(model.layout.parts());
    let parts = Value::list(parts, |(map, spec)| {
        Value::object([
            ("name", Value::text(&spec.name)),
            ("joints", Value::wholes(&spec.joints)),
            ("lambda", Value::numbers(map.kernel.lambda.as_slice())),
            ("variance", Value::Number(map.kernel.variance)),
            ("beta", Value::Number(map.beta)),
            ("r", matrix(&map.r)),
            ("v_mean", matrix(&map.mean)),
            ("v_covariance", matrix(&map.covariance)),
        ])
    });
    // The dynamics into each part; matrices over its sources stack them in order.
    let dynamics = Value::list(0..fitted.part_count(), |i| {
        Value::object([
            ("experts", Value::list(&fitted.experts, |row| expert(&row[i]))),
            ("u_covariance", matrix(&fitted.dynamics_covariance[i])),
            ("sum_psi2", matrix(&fitted.sums[i].psi2)),
            ("sum_psi1_mu", matrix(&fitted.sums[i].psi1_mu)),
        ])
    });
    let sequences = Value::list(model.sequences.iter().zip(&fitted.starts), |(info, start)| {
        Value::object([
            ("clip", Value::text(&info.name)),
            ("sha256", Value::text(&info.sha256)),
            ("frames", Value::whole(info.frames)),
            // The latent means of the first frames of each part.
            ("start", Value::list(start, matrix)),
        ])
    });
    Value::object([
        ("format", Value::text(FORMAT)),
        ("version", Value::whole(VERSION)),
        ("pose", model.mapping.to_value()),
        ("frame_time", Value::Number(model.frame_time)),
        ("column_means", Value::numbers(&model.column_means)),
        ("order", Value::whole(fitted.order)),
        ("jitter", Value::Number(fitted.jitter)),
        ("parts", parts),
        ("dynamics", dynamics),
        // Row the source, column the target.
        ("alpha", matrix(&fitted.alpha)),
        ("sequences", sequences),
        ("provenance", provenance(&model.provenance)),
    ])
}

/// An array of rows.
fn matrix(matrix: &DMatrix<f64>) -> Value {
    Value::list(matrix.row_iter(), |row| Value::list(row.iter(), |v| Value::Number(*v)))
}

fn expert(expert: &FittedExpert) -> Value {
    Value::object([
        ("lambda", Value::numbers(expert.kernel.lambda.as_slice())),
        ("z", matrix(&expert.z)),
        ("u_mean", matrix(&expert.mean)),
    ])
}

fn provenance(provenance: &Provenance) -> Value {
    let Provenance { engine, settings, frames_per_second, bound, terms, iterations, evaluations, note } =
        provenance;
    let TrainingSettings { latent, dynamics_ips, pose_ips, order, seed, max_iterations } = settings;
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
