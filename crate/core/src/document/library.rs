//! Writes libraries of primitives as documents.

use crate::document::error::{FORMAT, LIBRARY, THIRD};
use crate::document::write::{
    pose_map, rollout_rounds, sequence_fields, variational_provenance, version_of, with_external_evidence,
};
use crate::json::Value;
use crate::models::SequenceInfo;
use crate::models::library::{
    CouplingsFrom, Excerpt, LearnedMovement, LibraryExpert, Origin, Primitive, TrainedLibrary,
};
use crate::motion::pose::PoseMapping;

/// The document of a library. Indices say which part a primitive belongs to and which primitives a movement
/// uses.
pub(super) fn document(trained: &TrainedLibrary) -> Value {
    let TrainedLibrary { library, body, provenance } = trained;
    let parts = library.parts.iter().zip(&library.pose_sums).zip(body.layout.parts());
    let parts = Value::list(parts, |((map, psi2), spec)| {
        let mut fields = pose_map::<PoseMapping>(map, spec);
        fields.push(("sum_psi2", Value::matrix(psi2)));
        Value::of_fields(fields)
    });
    let primitives = Value::list(&library.primitives, |primitive| {
        let fields = Vec::from([
            ("name", Value::text(&primitive.name)),
            ("part", Value::whole(primitive.part)),
            ("experts", Value::list(&primitive.experts, expert)),
        ]);
        with_origin(fields, primitive)
    });
    let mut sequences = body.sequences.iter();
    let movements = library.movements.iter().map(|learned| {
        let own: Vec<&SequenceInfo> = sequences.by_ref().take(learned.starts.len()).collect();
        movement(learned, &own)
    });
    let movements = Value::List(movements.collect());
    Value::object([
        ("format", Value::text(FORMAT)),
        ("version", Value::whole(version_of(THIRD, &library.parts))),
        ("kind", Value::text(LIBRARY)),
        ("pose", body.mapping.to_value()),
        ("frame_time", Value::Number(body.frame_time)),
        ("column_means", Value::numbers(&body.column_means)),
        ("order", Value::whole(library.order)),
        ("jitter", Value::Number(library.jitter)),
        ("parts", parts),
        ("primitives", primitives),
        ("movements", movements),
        ("provenance", Value::Object(variational_provenance(provenance, Some(&library.terms)))),
    ])
}

/// Adds origin and excerpts of a primitive; each is absent if the primitive has none.
fn with_origin(mut fields: Vec<(&'static str, Value)>, primitive: &Primitive) -> Value {
    if let Some(recorded) = &primitive.origin {
        fields.push(("origin", origin(recorded)));
    }
    if !primitive.excerpts.is_empty() {
        fields.push(("excerpts", Value::list(&primitive.excerpts, excerpt)));
    }
    Value::of_fields(fields)
}

fn origin(origin: &Origin) -> Value {
    let Origin { training, relearned, .. } = origin;
    let clips = |clips: &[SequenceInfo]| Value::list(clips, |info| Value::Object(sequence_fields(info)));
    let relearned = relearned.as_ref().map_or(Value::Null, |relearned| {
        Value::object([
            ("primitive", Value::text(&relearned.primitive)),
            ("frames", Value::text(relearned.frames.id())),
            ("clips", clips(&relearned.clips)),
        ])
    });
    let mut fields = variational_provenance(training, None);
    fields.extend([("clips".to_owned(), clips(&origin.clips)), ("relearned".to_owned(), relearned)]);
    Value::Object(fields)
}

fn excerpt(excerpt: &Excerpt) -> Value {
    Value::object([
        ("movement", Value::text(&excerpt.movement)),
        ("alpha", Value::numbers(&excerpt.alpha)),
        ("starts", Value::list(&excerpt.starts, |start| Value::list(start, Value::matrix))),
    ])
}

fn expert(expert: &LibraryExpert) -> Value {
    let own = [
        ("lambda", Value::numbers(expert.fitted.kernel().lambda.as_slice())),
        ("z", Value::matrix(expert.fitted.z())),
        ("u_mean", Value::matrix(expert.fitted.mean())),
        ("u_covariance", Value::matrix(&expert.covariance)),
    ];
    with_external_evidence(own, expert.external.as_ref())
}

fn movement(movement: &LearnedMovement, sequences: &[&SequenceInfo]) -> Value {
    let sequences = Value::list(sequences.iter().zip(&movement.starts), |(info, start)| {
        let mut fields = sequence_fields(info);
        fields.push(("start".to_owned(), Value::list(start, Value::matrix)));
        Value::Object(fields)
    });
    // Null if the movement was not learned from rows.
    let sums = movement.sums.as_ref().map_or(Value::Null, |sums| {
        Value::list(sums, |sums| {
            Value::object([
                ("sum_psi2", Value::matrix(&sums.psi2)),
                ("sum_psi1_mu", Value::matrix(&sums.psi1_mu)),
            ])
        })
    });
    let couplings = match &movement.couplings {
        CouplingsFrom::Training => Value::object([("from", Value::text("training"))]),
        CouplingsFrom::Clips { bound, iterations } => Value::object([
            ("from", Value::text("clips")),
            ("bound", Value::Number(*bound)),
            ("iterations", Value::whole(*iterations)),
        ]),
        CouplingsFrom::Movement { movement: name } => {
            Value::object([("from", Value::text("movement")), ("movement", Value::text(name))])
        }
        CouplingsFrom::Hand => Value::object([("from", Value::text("hand"))]),
        CouplingsFrom::Nothing => Value::object([("from", Value::text("nothing"))]),
    };
    let mut fields = Vec::from([
        ("name", Value::text(&movement.name)),
        ("uses", Value::wholes(&movement.uses)),
        // The row is the source, the column the target.
        ("alpha", Value::matrix(&movement.alpha)),
        ("sums", sums),
        ("sequences", sequences),
        ("couplings", couplings),
    ]);
    fields.extend(rollout_rounds(movement.rollout_rounds).map(|rounds| ("rollout_rounds", rounds)));
    Value::of_fields(fields)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::library::{CouplingTrainer, LibraryPlan, LibraryTrainer, PlannedMovement};
    use crate::models::{Dataset, Model, RolloutRequest, Source, VariationalSettings};
    use crate::motion::{parts, samples};
    use serde_json::json;
    use std::sync::OnceLock;

    fn trained() -> &'static TrainedLibrary {
        static LIBRARY: OnceLock<TrainedLibrary> = OnceLock::new();
        LIBRARY.get_or_init(|| {
            let clips = ["walk-1", "walk-wave-1"].map(|id| samples::clip(id).unwrap().cut(0, 90).unwrap());
            let sources = clips.each_ref().map(|clip| Source { clip, first_frames: None });
            let parts = &parts::presets(&clips[0].skeleton)[1].parts;
            let dataset = Dataset::new(&sources, parts, 30.0).unwrap();
            let settings = VariationalSettings {
                max_iterations: 10,
                dynamics_ips: 5,
                pose_ips: 4,
                ..Default::default()
            };
            let movement = |name: &str| PlannedMovement { name: name.to_owned(), sequences: 1 };
            let plan = LibraryPlan::new(vec![movement("walk"), movement("wave")], vec![true, false]).unwrap();
            let mut trainer = LibraryTrainer::new(&dataset, &plan, &settings, 0).unwrap();
            while !trainer.step().done {}
            let library = trainer.finish().unwrap();
            let uses = library.read_uses("lower=walk,upper=wave").unwrap();
            let fitted = library.encode(&clips[0]).unwrap();
            let mut fit = CouplingTrainer::new(&library, &uses, &[fitted], 4).unwrap();
            fit.run();
            fit.finish("fitted").unwrap()
        })
    }

    #[test]
    fn a_library_is_read_as_it_was_written() {
        let text = trained().to_json().unwrap();
        let again = TrainedLibrary::from_json(&text).unwrap();
        assert_eq!(again.library, trained().library);
        assert!(trained().library.parts.iter().all(|map| !map.column_noise().is_empty()));
        assert_eq!(again.body.sequences, trained().body.sequences);
        assert_eq!(again.provenance, trained().provenance);
        assert_eq!(again.to_json().unwrap(), text);
    }

    /// A combination is saved as a model of its own, which rolls out to the same bits.
    #[test]
    fn a_combination_is_a_document_of_its_own() {
        for index in 0..3 {
            let model = trained().movement(index).unwrap();
            let text = model.to_json().unwrap();
            assert!(text.contains("\"version\":4"));
            let again = Model::coupled_from_json(&text).unwrap();
            let (again, model) = (again.coupled().unwrap(), model.coupled().unwrap());
            assert_eq!(again.model, model.model);
            let request = RolloutRequest { frames: 30, ..Default::default() };
            assert_eq!(again.rollout(&request).unwrap().y, model.rollout(&request).unwrap().y);
        }
        let mut value: serde_json::Value =
            serde_json::from_str(&trained().movement(0).unwrap().to_json().unwrap()).unwrap();
        value["dynamics"][1].as_object_mut().unwrap().remove("other_precision");
        let refused =
            |value: &serde_json::Value| Model::coupled_from_json(&value.to_string()).unwrap_err().to_string();
        assert!(refused(&value).contains("other_b"), "{}", refused(&value));
        value["dynamics"][1].as_object_mut().unwrap().remove("other_b");
        assert!(refused(&value).contains("of all parts or of none"), "{}", refused(&value));
    }

    /// A single primitive is a library without a whole movement, with the origin of the primitive.
    #[test]
    fn a_single_primitive_is_read_as_it_was_written() {
        let library = trained();
        let alone = library.select(&[1]).unwrap();
        let text = alone.to_json().unwrap();
        let again = TrainedLibrary::from_json(&text).unwrap();
        assert_eq!(again.library, alone.library);
        assert_eq!(again.to_json().unwrap(), text);
        let origin = again.origin(0);
        assert_eq!(origin, library.origin(1));
        assert_eq!(origin.training, library.provenance);
        assert_eq!(origin.clips, library.body.sequences[..1]);
        assert_eq!((again.library.movements.len(), again.body.sequences.len()), (0, 0));
        // Files of earlier versions have no origin: their primitives come from the library's training.
        assert!(!library.to_json().unwrap().contains("origin"));
        let refusal = |change: fn(&mut serde_json::Value)| {
            let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
            change(&mut value["primitives"][0]);
            TrainedLibrary::from_json(&value.to_string()).unwrap_err().to_string()
        };
        assert!(refusal(|p| p["origin"]["seed"] = json!(1)).starts_with("at primitives[0].origin"));
        let missing = refusal(|p| drop(p["origin"].as_object_mut().unwrap().remove("clips")));
        assert!(missing.starts_with("at primitives[0].origin"), "{missing}");
        let unknown = json!({ "primitive": "walk", "frames": "dreamt", "clips": [] });
        let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
        value["primitives"][0]["origin"]["relearned"] = unknown;
        let refused = TrainedLibrary::from_json(&value.to_string()).unwrap_err().to_string();
        assert_eq!(
            refused,
            "at primitives[0].origin.relearned.frames: expected clips, remembered or generated, found a text"
        );
        assert!(
            refusal(|p| p["excerpts"][0]["alpha"] = json!([1.0]))
                .contains("excerpts[0].alpha: expected 2, found 1")
        );
        let short = refusal(|p| p["excerpts"][0]["starts"][0][0] = json!([[1.0, 2.0, 3.0]]));
        assert!(short.contains("excerpts[0].starts[0][0]"), "{short}");
        let negative = refusal(|p| p["excerpts"][0]["alpha"] = json!([1.0, -1.0]));
        assert!(negative.contains("excerpts[0].alpha: expected positive numbers"), "{negative}");
    }

    #[test]
    fn a_merge_adds_the_primitives_that_are_missing() {
        let whole = trained();
        // A library without the arms of the walk, and one with these alone.
        let mut some = whole.select(&[0, 2]).unwrap();
        let arms = whole.select(&[1]).unwrap();
        let movements = some.library.movements.clone();
        some.merge(&TrainedLibrary::from_json(&arms.to_json().unwrap()).unwrap()).unwrap();
        assert_eq!((some.library.primitives.len(), &some.library.movements), (3, &movements));
        assert_eq!(some.library.primitives[2].name, "walk");
        // The recorded combination exists again, with the couplings that a single primitive stores.
        let uses = some.read_uses("lower=walk+wave,upper=walk").unwrap();
        let alpha = some.library.nearest_couplings(&uses);
        assert_eq!(alpha.row(1), whole.library.movements[0].alpha.row(1));
        let path = |library: &TrainedLibrary, uses: &[usize]| {
            let model = library.combination(uses, &whole.library.movements[0].alpha).unwrap();
            let model = model.coupled().unwrap().model;
            let dynamics =
                model.dynamics(&model.alpha, crate::models::rollout::couplings::Reading::AsLearned);
            let start: Vec<_> =
                whole.library.movements[0].starts[0].iter().map(|x| x.rows(0, 2).into_owned()).collect();
            dynamics.unwrap().path(&start, 30).unwrap()
        };
        assert_eq!(path(&some, &uses), path(whole, &[0, 1]));
        // A second merge of the same primitive changes nothing.
        let merged = some.library.clone();
        some.merge(&arms).unwrap();
        assert_eq!(some.library, merged);
        // A movement is added with both of its primitives; rows are not counted twice.
        let mut legs = whole.select(&[0]).unwrap();
        legs.merge(whole).unwrap();
        assert_eq!(legs.library.primitives.len(), 3);
        assert!(legs.library.movements.iter().all(|movement| movement.sums.is_none()));
        assert_eq!(legs.body.sequences.len(), whole.body.sequences.len());
        let read = TrainedLibrary::from_json(&legs.to_json().unwrap()).unwrap();
        assert_eq!(read.library, legs.library);
    }

    /// A file of an earlier version has no noise variance for each column, but may have the same pose maps.
    #[test]
    fn primitives_of_a_file_without_noise_variances_of_columns_fit() {
        let (mut host, mut other) = (trained().select(&[1]).unwrap(), trained().select(&[0]).unwrap());
        let parts = other.library.parts.into_iter();
        other.library.parts = parts.map(|map| map.with_column_noise(Vec::new())).collect();
        host.merge(&other).unwrap();
        assert_eq!(host.library.primitives.len(), 2);
        assert!(host.library.parts.iter().all(|map| !map.column_noise().is_empty()));
    }

    #[test]
    fn primitives_that_do_not_fit_are_refused_with_the_reason() {
        use crate::models::library::{MergeError, Misfit};
        let refused = |change: &dyn Fn(&mut TrainedLibrary)| {
            let (mut host, mut other) = (trained().clone(), trained().select(&[1]).unwrap());
            change(&mut other);
            let MergeError::Misfit(misfit) = host.merge(&other).unwrap_err() else { panic!("no misfit") };
            assert_eq!(host.library, trained().library);
            (misfit.to_string(), misfit)
        };
        let (message, _) = refused(&|other| {
            let map = &other.library.parts[1];
            let (r, kernel, mean) = (map.r() * 1.5, map.kernel().clone(), map.mean().clone());
            let jitter = other.library.jitter;
            other.library.parts[1] = crate::models::variational::PoseMap::new(
                r,
                kernel,
                map.beta(),
                mean,
                map.covariance().clone(),
                jitter,
            )
            .unwrap();
        });
        assert_eq!(message, "the pose maps of upper differ: they come from different trainings");
        let (message, _) = refused(&|other| other.library.order = 3);
        assert_eq!(message, "the order of the dynamics differs: expected 2, found 3");
        let (_, misfit) = refused(&|other| other.body.column_means[0] += 1.0);
        assert_eq!(misfit, Misfit::Centre);
        let (message, _) = refused(&|other| {
            let mut parts = other.body.layout.parts().to_vec();
            parts[0].name = "legs".to_owned();
            other.body.layout = crate::motion::parts::PartsLayout::new(&parts, &other.body.mapping).unwrap();
        });
        assert_eq!(message, "the columns differ: expected the parts lower, upper, found legs, upper");
    }

    #[test]
    fn wrong_fields_are_refused_with_their_path() {
        type Change = fn(&mut serde_json::Value);
        let cases: [(&str, Change); 9] = [
            ("at movements[0].uses: expected a primitive of part 1", |v| {
                v["movements"][0]["uses"] = json!([0, 0]);
            }),
            ("at movements[0].uses: expected a primitive of part 0", |v| {
                v["movements"][0]["uses"] = json!([99, 1]);
            }),
            ("at movements[1]: expected a name of its own", |v| v["movements"][1]["name"] = json!("walk")),
            ("at movements[0].sums[0].sum_psi2", |v| {
                v["movements"][0]["sums"][0]["sum_psi2"] = json!([[1.0]]);
            }),
            ("at movements[2].couplings.from", |v| v["movements"][2]["couplings"]["from"] = json!("afar")),
            ("at primitives[0].part: expected from 0 to 1, found 2", |v| {
                v["primitives"][0]["part"] = json!(2)
            }),
            ("at primitives[2]: expected a name of its own", |v| v["primitives"][2]["name"] = json!("walk")),
            ("at primitives[0].experts[0].u_covariance", |v| {
                v["primitives"][0]["experts"][0]["u_covariance"] = json!([[1.0, 0.0]]);
            }),
            ("at parts[0].sum_psi2", |v| v["parts"][0]["sum_psi2"] = json!([[1.0]])),
        ];
        for (expected, change) in cases {
            let mut value: serde_json::Value = serde_json::from_str(&trained().to_json().unwrap()).unwrap();
            change(&mut value);
            let message = TrainedLibrary::from_json(&value.to_string()).unwrap_err().to_string();
            assert!(message.starts_with(expected), "{message}");
        }
    }

    #[test]
    fn models_and_libraries_are_distinguished() {
        let library = trained().to_json().unwrap();
        let message = Model::coupled_from_json(&library).unwrap_err().to_string();
        assert!(message.starts_with("expected a model, found a library of primitives"), "{message}");
        let model = trained().movement(0).unwrap().to_json().unwrap();
        let message = TrainedLibrary::from_json(&model).unwrap_err().to_string();
        assert_eq!(message, "expected a library of primitives, found a vcgpdm model");
    }

    #[test]
    fn combinations_are_chosen_by_primitive_or_by_movement() {
        let library = trained();
        assert_eq!(library.read_uses("lower=walk,upper=wave").unwrap(), [0, 2]);
        assert_eq!(library.read_uses("upper=walk, lower=walk+wave").unwrap(), [0, 1]);
        let refusal = |text: &str| library.read_uses(text).unwrap_err().to_string();
        assert_eq!(
            refusal("lower=walk"),
            "expected PART=PRIMITIVE for each part, such as lower=walk+wave,upper=walk, found \"lower=walk\""
        );
        assert_eq!(refusal("tail=walk"), "expected the part to be one of lower, upper, found \"tail\"");
        assert_eq!(
            refusal("lower=walk,upper=jump"),
            "expected the primitive to be one of walk, wave, found \"jump\""
        );
    }
}
