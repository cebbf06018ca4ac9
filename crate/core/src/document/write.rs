//! Writes models as documents.

use crate::document::error::{FORMAT, THIRD, VERSION};
use crate::document::settings::{write_settings, write_variational};
use crate::document::subject::Subject;
use crate::json::Value;
use crate::models::variational::{BoundTerms, ExternalEvidence, FittedExpert, PoseMap};
use crate::models::{Coupled, FittedModel, Model, Provenance, SequenceInfo};
use crate::motion::parts::PartSpec;

/// The document of a model of any kind.
pub(super) fn document<S: Subject>(trained: &Model<S>) -> Value {
    if let Some(coupled) = trained.coupled() {
        return variational(coupled);
    }
    let Model { fitted, body, provenance } = trained;
    let settings = write_settings(&provenance.settings, provenance.seed);
    let fields = match fitted {
        // `coupled` above is `Some` for this kind.
        FittedModel::Vcgpdm(_) => Value::Null,
        FittedModel::Map(model) => model.to_value(),
        FittedModel::Tmp(model) => model.to_value(),
        FittedModel::Dmp(model) => model.to_value(),
    };
    let parts = Value::list(body.layout.parts(), |spec| Value::object(part_fields::<S>(spec)));
    let sequences = Value::list(&body.sequences, |info| Value::Object(sequence_fields(info)));
    let provenance = Value::object([
        ("engine", Value::text(&provenance.engine)),
        ("settings", settings),
        ("frames_per_second", Value::Number(provenance.frames_per_second)),
        ("objective", Value::Number(provenance.objective)),
        ("iterations", Value::whole(provenance.iterations)),
        ("note", provenance.note.as_deref().map_or(Value::Null, Value::text)),
    ]);
    Value::object([
        ("format", Value::text(FORMAT)),
        ("version", Value::whole(S::VERSIONS[1])),
        ("kind", Value::text(fitted.kind().id())),
        (S::FIELD, Subject::to_value(&body.mapping)),
        ("frame_time", Value::Number(body.frame_time)),
        ("column_means", Value::numbers(&body.column_means)),
        ("parts", parts),
        ("sequences", sequences),
        ("model", fields),
        ("provenance", provenance),
    ])
}

/// The origin of a training sequence.
pub(super) fn sequence_fields(info: &SequenceInfo) -> Vec<(String, Value)> {
    let mut fields = vec![
        ("clip".to_owned(), Value::text(&info.name)),
        ("sha256".to_owned(), Value::text(&info.sha256)),
        ("frames".to_owned(), Value::whole(info.frames)),
    ];
    // The next fields are absent if they have no value, so that files written by earlier versions keep their
    // hash.
    if let Some(seconds) = info.rests_from {
        fields.push(("rests_from".to_owned(), Value::Number(seconds)));
    }
    if let Some((first, end)) = info.piece {
        fields.push(("piece".to_owned(), Value::list([first, end], Value::whole)));
    }
    if let Some(first) = &info.bones_of {
        fields.push(("bones_of".to_owned(), Value::text(first)));
    }
    if !info.whole {
        fields.push(("whole".to_owned(), Value::Bool(false)));
    }
    fields
}

/// The document of a variational model. A program that writes no other kind does not contain the code of the
/// others.
pub(super) fn variational<S: Subject>(coupled: Coupled<S>) -> Value {
    let Coupled { model, body, provenance } = coupled;
    let parts = model.parts.iter().zip(body.layout.parts());
    let parts = Value::list(parts, |(map, spec)| Value::of_fields(pose_map::<S>(map, spec)));
    // The dynamics into each part. Matrices over all sources stack their blocks in order.
    let dynamics = Value::list(0..model.part_count(), |i| {
        let own = [
            ("experts", Value::list(&model.experts, |row| expert(&row[i]))),
            ("u_covariance", Value::matrix(&model.dynamics_covariance[i])),
            ("sum_psi2", Value::matrix(&model.sums[i].psi2)),
            ("sum_psi1_mu", Value::matrix(&model.sums[i].psi1_mu)),
        ];
        with_external_evidence(own, model.external.get(i))
    });
    // Version 1 suffices for a model of a body without evidence from other data.
    let version = if model.external.is_empty() { S::VERSIONS[0] } else { THIRD };
    let sequences = Value::list(body.sequences.iter().zip(&model.starts), |(info, start)| {
        let mut fields = sequence_fields(info);
        // The latent means of the first frames, for each part.
        fields.push(("start".to_owned(), Value::list(start, Value::matrix)));
        Value::Object(fields)
    });
    let provenance = Value::Object(variational_provenance(provenance, Some(&model.terms)));
    Value::object([
        ("format", Value::text(FORMAT)),
        ("version", Value::whole(version_of(version, &model.parts))),
        (S::FIELD, Subject::to_value(&body.mapping)),
        ("frame_time", Value::Number(body.frame_time)),
        ("column_means", Value::numbers(&body.column_means)),
        ("order", Value::whole(model.order)),
        ("jitter", Value::Number(model.jitter)),
        ("parts", parts),
        ("dynamics", dynamics),
        // The row is the source, the column the target.
        ("alpha", Value::matrix(&model.alpha)),
        ("sequences", sequences),
        ("provenance", provenance),
    ])
}

/// The provenance of a variational model or a library, with the `terms` of its bound if they are kept.
pub(super) fn variational_provenance(
    provenance: &Provenance,
    terms: Option<&BoundTerms>,
) -> Vec<(String, Value)> {
    let fields = [
        ("engine", Some(Value::text(&provenance.engine))),
        ("settings", Some(write_variational(&provenance.settings, provenance.seed))),
        ("frames_per_second", Some(Value::Number(provenance.frames_per_second))),
        ("bound", Some(Value::Number(provenance.bound()))),
        ("objective", provenance.plain_bound.map(|_| Value::Number(provenance.objective))),
        ("terms", terms.map(terms_value)),
        ("iterations", Some(Value::whole(provenance.iterations))),
        ("evaluations", Some(Value::whole(provenance.evaluations))),
        ("rollout_rounds", rollout_rounds(provenance.rollout_rounds)),
        ("note", Some(provenance.note.as_deref().map_or(Value::Null, Value::text))),
    ];
    fields.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?))).collect()
}

/// Absent if 0, as in documents from before models learned from their rollouts.
pub(super) fn rollout_rounds(rounds: usize) -> Option<Value> {
    Some(rounds).filter(|rounds| *rounds > 0).map(Value::whole)
}

/// The version of a document with these pose maps for which `version` suffices otherwise.
pub(super) fn version_of(version: usize, maps: &[PoseMap]) -> usize {
    if maps.iter().any(|map| !map.column_noise().is_empty()) { VERSION } else { version }
}

/// The fields of a part with its pose map.
pub(super) fn pose_map<S: Subject>(map: &PoseMap, spec: &PartSpec) -> Vec<(&'static str, Value)> {
    let [name, places] = part_fields::<S>(spec);
    let mut fields = Vec::from([
        name,
        places,
        ("lambda", Value::numbers(map.kernel().lambda.as_slice())),
        ("variance", Value::Number(map.kernel().variance)),
        ("beta", Value::Number(map.beta())),
        ("r", Value::matrix(map.r())),
        ("v_mean", Value::matrix(map.mean())),
        ("v_covariance", Value::matrix(map.covariance())),
    ]);
    // Absent in files that an earlier version wrote, which keep their hash.
    if !map.column_noise().is_empty() {
        fields.push(("column_noise", Value::numbers(map.column_noise())));
    }
    fields
}

/// Adds the evidence from other data, if there is any.
pub(super) fn with_external_evidence<const N: usize>(
    own: [(&str, Value); N],
    external: Option<&ExternalEvidence>,
) -> Value {
    let mut fields = Vec::from(own);
    if let Some(external) = external {
        fields.push(("other_precision", Value::matrix(&external.precision)));
        fields.push(("other_b", Value::matrix(&external.b)));
    }
    Value::of_fields(fields)
}

fn part_fields<S: Subject>(spec: &PartSpec) -> [(&'static str, Value); 2] {
    [("name", Value::text(&spec.name)), (S::PLACES, Value::wholes(&spec.joints))]
}

fn expert(expert: &FittedExpert) -> Value {
    Value::object([
        ("lambda", Value::numbers(expert.kernel().lambda.as_slice())),
        ("z", Value::matrix(expert.z())),
        ("u_mean", Value::matrix(expert.mean())),
    ])
}

fn terms_value(terms: &BoundTerms) -> Value {
    let BoundTerms { kinematics, dynamics, initial, entropy } = terms;
    Value::object([
        ("kinematics", Value::numbers(kinematics)),
        ("dynamics", Value::numbers(dynamics)),
        ("initial", Value::Number(*initial)),
        ("entropy", Value::Number(*entropy)),
    ])
}
