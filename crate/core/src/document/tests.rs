use super::*;
use crate::models::{
    Dataset, DmpSettings, MapSettings, ModelKind, PoseWeight, RolloutRequest, Settings, TmpSettings, Trainer,
    VariationalSettings,
};
use crate::motion::{parts, samples};
use serde_json::{Value, json};
use std::sync::OnceLock;

fn trained() -> &'static Model {
    static MODEL: OnceLock<Model> = OnceLock::new();
    MODEL.get_or_init(|| {
        let clip = samples::clip("walk-1").unwrap();
        let parts = &parts::presets(&clip.skeleton)[1].parts;
        let dataset = Dataset::new(&[(&clip).into()], parts, 30.0).unwrap();
        let settings =
            VariationalSettings { max_iterations: 20, dynamics_ips: 5, pose_ips: 4, ..Default::default() };
        let mut trainer = Trainer::new(&dataset, &settings.into(), 0).unwrap();
        trainer.run();
        trainer.finish().unwrap()
    })
}

fn document() -> Value {
    serde_json::from_str(&trained().to_json().unwrap()).unwrap()
}

fn refused(change: impl FnOnce(&mut Value)) -> String {
    let mut value = document();
    change(&mut value);
    Model::coupled_from_json(&value.to_string()).unwrap_err().to_string()
}

#[test]
fn a_model_is_read_as_it_was_written_and_rolls_out_to_the_same_bits() {
    let model = trained();
    let again = Model::coupled_from_json(&model.to_json().unwrap()).unwrap();
    let (coupled, coupled_again) = (model.coupled().unwrap(), again.coupled().unwrap());
    assert_eq!(coupled_again.model, coupled.model);
    assert_eq!(again.provenance, model.provenance);
    assert_eq!(again.body.sequences, model.body.sequences);
    let request = RolloutRequest { frames: 50, ..Default::default() };
    assert_eq!(coupled.rollout(&request).unwrap().y, coupled_again.rollout(&request).unwrap().y);
    assert_eq!(again.to_json().unwrap(), model.to_json().unwrap());
}

/// A noise variance for each column needs version 4; without them a file has the version that it had before.
#[test]
fn a_file_without_noise_variances_of_columns_is_read_and_stays_as_it_is() {
    let mut old = document();
    assert_eq!(old["version"], json!(4));
    for (part, map) in trained().coupled().unwrap().model.parts.iter().enumerate() {
        let noise = map.column_noise();
        assert_eq!(noise.len(), map.mean().ncols());
        assert_eq!(old["parts"][part]["column_noise"], json!(noise));
        old["parts"][part].as_object_mut().unwrap().remove("column_noise");
    }
    old["version"] = json!(1);
    let read = Model::coupled_from_json(&old.to_string()).unwrap();
    let again: Value = serde_json::from_str(&read.to_json().unwrap()).unwrap();
    assert_eq!(again, old);
    let (old, new) = (read.coupled().unwrap().model, trained().coupled().unwrap().model);
    assert!(old.parts.iter().all(|map| map.column_noise().is_empty()));
    // The variances at the latents where training began: they differ by noise - beta.
    let filter = |model: &Coupled| model.filter(&RolloutRequest::default()).unwrap();
    let [of_old, of_new] = [&read, trained()].map(|model| filter(&model.coupled().unwrap()));
    for (part, (map, start)) in new.parts.iter().zip(&new.starts[0]).enumerate() {
        let (mean, none) = (start.row(0).transpose(), nalgebra::DMatrix::zeros(3, 3));
        let [old, new] = [&of_old, &of_new].map(|filter| filter.column_moments(part, &mean, &none).unwrap());
        assert_eq!(old.mean, new.mean);
        for (c, noise) in map.column_noise().iter().enumerate() {
            let more = new.covariance[(c, c)] - old.covariance[(c, c)];
            assert!((more - (noise - map.beta())).abs() < 1e-12, "{more}");
        }
    }
}

/// A weighted training has two numbers: the objective, and the bound on the evidence.
#[test]
fn a_model_of_a_weighted_training_keeps_objective_and_bound() {
    for (pose_weight, written) in
        [(PoseWeight::Balanced, json!("balanced")), (PoseWeight::Fixed(0.25), json!(0.25))]
    {
        let settings =
            VariationalSettings { max_iterations: 4, dynamics_ips: 4, pose_weight, ..Default::default() };
        let model = learned(settings.into(), 40, 2);
        let text = model.to_json().unwrap();
        let again = Model::coupled_from_json(&text).unwrap();
        assert_eq!(again.provenance, model.provenance);
        assert_eq!(again.to_json().unwrap(), text);
        let mut value: Value = serde_json::from_str(&text).unwrap();
        let provenance = &value["provenance"];
        assert_eq!(provenance["settings"]["pose_weight"], written);
        assert_eq!(provenance["objective"].as_f64(), Some(model.provenance.objective));
        assert_eq!(provenance["bound"].as_f64(), model.fitted.bound());
        assert_ne!(provenance["bound"], provenance["objective"]);
        for bad in [json!(0), json!(-1), json!(1e9), json!("even"), json!(true), Value::Null] {
            value["provenance"]["settings"]["pose_weight"] = bad;
            let error = Model::coupled_from_json(&value.to_string()).unwrap_err().to_string();
            let expected = "expected balanced, or a number from 0.001 to 1000, found";
            assert!(error.contains("at provenance.settings.pose_weight: "), "{error}");
            assert!(error.contains(expected), "{error}");
        }
    }
    let uncoupled = VariationalSettings { max_iterations: 2, uncoupled: true, ..Default::default() };
    let model = learned(uncoupled.into(), 40, 2);
    let text = model.to_json().unwrap();
    assert!(text.contains(r#""uncoupled":1"#));
    assert_eq!(Model::coupled_from_json(&text).unwrap().provenance, model.provenance);
    let plain = &document()["provenance"];
    assert!(plain["settings"]["uncoupled"].is_null());
    assert!(plain["objective"].is_null() && plain["settings"]["pose_weight"].is_null());
}

#[test]
fn the_hash_of_a_model_is_that_of_its_document() {
    let hash = trained().coupled().unwrap().sha256().unwrap();
    let text = trained().to_json().unwrap();
    assert_eq!(hash, crate::motion::sha256(text.as_bytes()));
    let sha256 = |model: Model| model.coupled().unwrap().sha256().unwrap();
    assert_eq!(sha256(Model::coupled_from_json(&text).unwrap()), hash);
    let mut other = document();
    other["provenance"]["note"] = json!("another");
    let other = Model::coupled_from_json(&other.to_string()).unwrap();
    assert_ne!(sha256(other), hash);
}

#[test]
fn a_document_does_not_contain_the_training_clips() {
    // The clips would be the largest part of the file.
    let model = trained();
    let numbers = |v: &Value| -> usize {
        fn count(v: &Value) -> usize {
            match v {
                Value::Array(a) => a.iter().map(count).sum(),
                Value::Object(o) => o.values().map(count).sum(),
                Value::Number(_) => 1,
                _ => 0,
            }
        }
        count(v)
    };
    let frames = model.body.sequences[0].frames;
    assert!(numbers(&document()) < frames * model.body.column_means.len() / 2);
}

#[test]
fn other_files_are_refused_with_the_reason() {
    let error = |text: &str| Model::coupled_from_json(text).unwrap_err().to_string();
    assert!(error("HIERARCHY").starts_with("expected a model as JSON: "));
    assert_eq!(error("{}"), "expected a model with \"format\": \"vcgpdm model\", found no format");
    assert_eq!(
        refused(|v| v["format"] = json!("pose")),
        "expected a model with \"format\": \"vcgpdm model\", found \"pose\""
    );
    assert!(refused(|v| v["format"] = json!(vec![1; 100_000])).len() < 200, "a line can be read");
    assert_eq!(
        refused(|v| v["version"] = json!(7)),
        "expected a model of version 4 or earlier, found version 7; a newer program wrote it"
    );
}

#[test]
fn wrong_fields_are_refused_with_their_path() {
    type Change = fn(&mut Value);
    let cases: [(&str, Change); 17] = [
        ("at parts[1].beta: expected positive numbers", |v| v["parts"][1]["beta"] = json!(-1.0)),
        ("at parts[0].column_noise: expected 30, found 1", |v| v["parts"][0]["column_noise"] = json!([1.0])),
        ("at parts[1].column_noise: expected positive numbers", |v| {
            v["parts"][1]["column_noise"][4] = json!(0.0)
        }),
        ("at parts[0].r: expected rows of 3 numbers, found 1 in row 1", |v| {
            v["parts"][0]["r"][1] = json!([1.0])
        }),
        ("at parts[0].r[1][0]: expected a number, found null", |v| v["parts"][0]["r"][1][0] = Value::Null),
        ("at parts[0].v_mean: expected 4 x ", |v| v["parts"][0]["v_mean"] = json!([vec![1.0; 30]])),
        ("at dynamics[1].experts[0].lambda: expected 6, found 1", |v| {
            v["dynamics"][1]["experts"][0]["lambda"] = json!([1.0]);
        }),
        ("at dynamics[0].sum_psi2: expected 10 x 10", |v| v["dynamics"][0]["sum_psi2"] = json!([])),
        ("at alpha: expected positive numbers", |v| v["alpha"][0][1] = json!(0.0)),
        ("at alpha: expected 2 x 2 numbers, found 1 x 2", |v| v["alpha"] = json!([[1.0, 1.0]])),
        ("at order: expected from 1 to 100, found 1000000", |v| v["order"] = json!(1_000_000)),
        ("at provenance.terms.dynamics: expected 2, found 1", |v| {
            v["provenance"]["terms"]["dynamics"] = json!([1.0]);
        }),
        ("at frame_time: expected seconds", |v| v["frame_time"] = json!(0.0)),
        ("at sequences[0].start[0]: expected 2 x 3 numbers", |v| {
            v["sequences"][0]["start"][0] = json!([[1, 2, 3]])
        }),
        ("at sequences[0].start[1]: expected 126 x 3 numbers, found 2 x 3", |v| {
            v["sequences"][0]["start"][1].as_array_mut().unwrap().truncate(2)
        }),
        ("at sequences[0].start[0]: expected 40 x 3 numbers, found 126 x 3", |v| {
            v["sequences"][0]["frames"] = json!(40)
        }),
        ("at sequences[0]: expected a field \"frames\", found none", |v| {
            v["sequences"][0].as_object_mut().unwrap().remove("frames");
        }),
    ];
    for (expected, change) in cases {
        let error = refused(change);
        assert!(error.starts_with(expected), "expected {expected:?}, found {error:?}");
    }
    // A joint that is in no part.
    assert!(
        refused(|v| v["parts"][0]["joints"] = json!([0]))
            .starts_with("at parts: expected each joint in one part")
    );
    // A number beyond the range of f64.
    let huge = trained().to_json().unwrap().replacen("\"jitter\":1e-6", "\"jitter\":1e999", 1);
    assert!(Model::coupled_from_json(&huge).unwrap_err().to_string().contains("out of range"));
}

#[test]
fn settings_that_no_training_accepts_are_refused_with_their_path() {
    let written = |settings, frames| -> Value {
        serde_json::from_str(&learned(settings, frames, 1).to_json().unwrap()).unwrap()
    };
    let mut documents = [
        document(),
        serde_json::from_str(&baseline().to_json().unwrap()).unwrap(),
        written(Settings::Tmp(TmpSettings { primitives: Some(2), ..TmpSettings::default() }), 60),
        written(Settings::DmpRhythmic(DmpSettings::default()), 60),
    ];
    let set = |document: &mut Value, name: &str, value: Value| {
        document["provenance"]["settings"][name] = value;
        Model::from_json(&document.to_string()).err().map(|error| error.to_string())
    };
    for (name, good, bad, expected) in [
        ("latent", json!(100), json!(0), "expected from 1 to 100, found 0"),
        ("order", json!(1), json!(101), "expected from 1 to 100, found 101"),
        ("dynamics_ips", json!(1000), json!(1001), "expected from 1 to 1000, found 1001"),
        ("pose_ips", json!(12), json!(0), "expected from 1 to 1000, found 0"),
        ("max_iterations", json!(0), json!(0.5), "expected a whole number, found 0.5"),
        ("seed", json!(4294967295u32), json!(-1), "expected a whole number, found -1"),
        ("balanced", json!(1), json!(2), "expected from 0 to 1, found 2"),
        ("primitives", json!(4), json!(0), "expected from 1 to 1000, found 0"),
        ("bases", json!(20), json!(1e9), "expected from 1 to 1000, found 1000000000"),
    ] {
        let mut found = 0;
        for document in &mut documents {
            if document["provenance"]["settings"].get(name).is_none() {
                continue;
            }
            found += 1;
            let error = set(document, name, bad.clone()).unwrap();
            assert!(error.starts_with(&format!("at provenance.settings.{name}: {expected}")), "{error}");
            assert_eq!(set(document, name, good.clone()), None, "{name}");
        }
        assert!(found > 0, "no document has {name}");
    }
    for mut document in documents {
        let mut unknown = document.clone();
        let error = set(&mut unknown, "colour", json!(1)).unwrap();
        assert_eq!(error, "at provenance.settings: expected no field \"colour\", or only one");
        document["provenance"]["frames_per_second"] = json!(0);
        let error = Model::from_json(&document.to_string()).err().unwrap().to_string();
        let expected = "at provenance.frames_per_second: expected frames a second from 0.1 to 10000, found 0";
        assert_eq!(error, expected);
    }
}

#[test]
fn a_broken_body_is_refused_with_the_path_of_the_field() {
    let broken: [(&str, Value, &str); 13] = [
        ("/pose/stage/up", json!("w"), "at pose.stage.up: expected one of \"x\""),
        ("/pose/stage/height", json!(0.0), "at pose.stage.height: expected a positive number, found 0"),
        ("/pose/stage/ground", json!(-1e300), "at pose.stage.ground: expected a height below 1e12"),
        ("/pose/upright/0", json!(2.0), "at pose.upright: expected four numbers"),
        ("/pose/upright", json!([1.0]), "at pose.upright: expected a list of 4 numbers, found a list of 1"),
        ("/pose/positions", json!([]), "at pose.positions: expected three numbers for each of the"),
        ("/pose/first/0/0", json!(1e300), "at pose.first: expected numbers below 1e12"),
        ("/pose/first/0/0", json!("a"), "at pose.first[0][0]: expected a number, found a text"),
        ("/pose/skeleton/joints/3/parent", json!(99), "at pose.skeleton: joint 3"),
        ("/pose/skeleton/joints/0/parent", json!(0), "at pose.skeleton: joint 0"),
        ("/pose/skeleton/joints/3/parent", json!(-1), "at pose.skeleton.joints[3].parent: expected a whole"),
        (
            "/pose/skeleton/joints/3/channels/0",
            json!("x"),
            "at pose.skeleton.joints[3].channels[0]: expected",
        ),
        ("/pose/skeleton/joints", json!([]), "at pose.skeleton: expected at least one joint"),
    ];
    for (path, value, wanted) in broken {
        let message = refused(|v| *v.pointer_mut(path).unwrap() = value);
        assert!(message.starts_with(wanted), "{path}: {message}");
    }
}

#[test]
fn unknown_and_repeated_fields_are_refused() {
    assert!(
        refused(|v| v["colour"] = json!("red")).starts_with("at the top of the document: expected no field")
    );
    assert!(
        refused(|v| v["parts"][1]["gamma"] = json!(1))
            .starts_with("at parts[1]: expected no field \"gamma\"")
    );
    let twice = trained().to_json().unwrap().replacen("\"order\":2", "\"order\":2,\"order\":2", 1);
    let message = Model::coupled_from_json(&twice).unwrap_err().to_string();
    assert_eq!(message, "at the top of the document: expected no field \"order\", or only one");
}

#[test]
fn a_model_with_nan_is_not_written() {
    let mut model = trained().clone();
    model.provenance.objective = f64::NAN;
    assert!(model.to_json().unwrap_err().to_string().ends_with("expected finite numbers, found NaN"));
}

/// A model of the first `frames` frames of a sample walk in two parts, trained for at most `steps` steps.
fn learned(settings: Settings, frames: usize, steps: usize) -> Model {
    let clip = samples::clip("walk-1").unwrap().cut(0, frames).unwrap();
    let parts = &parts::presets(&clip.skeleton)[1].parts;
    let dataset = Dataset::new(&[(&clip).into()], parts, 30.0).unwrap();
    let mut trainer = Trainer::new(&dataset, &settings, 3).unwrap();
    for _ in 0..steps {
        trainer.step();
    }
    trainer.finish().unwrap()
}

/// A MAP CGPDM after a few steps.
fn baseline() -> Model {
    let settings = MapSettings { latent: 2, max_iterations: 10, ..MapSettings::default() };
    learned(Settings::MapCgpdm(settings), 40, 11)
}

#[test]
fn a_baseline_is_read_as_it_was_written() {
    let model = baseline();
    let text = model.to_json().unwrap();
    let again = Model::from_json(&text).unwrap();
    assert_eq!(again.kind(), ModelKind::MapCgpdm);
    assert_eq!(again.to_json().unwrap(), text);
    let y = model.rollout(0, 60).unwrap();
    assert_eq!(again.rollout(0, 60).unwrap(), y);
    assert!(y.iter().all(|v| v.is_finite()));
    assert_eq!(again.provenance, model.provenance);
    assert_eq!(again.fitted.stored_numbers(), model.fitted.stored_numbers());
    assert_eq!(again.body.clip(&y, "walk.bvh").unwrap().frames(), 60);
    assert_eq!(
        Model::coupled_from_json(&text).unwrap_err().to_string(),
        "expected a vcgpdm or vgpdm model, found a map-cgpdm model"
    );
}

#[test]
fn documents_without_a_kind_are_variational() {
    let any = Model::from_json(&trained().to_json().unwrap()).unwrap();
    assert_eq!(any.to_json().unwrap(), trained().to_json().unwrap());
    let request = RolloutRequest { frames: 20, ..Default::default() };
    let coupled = trained().coupled().unwrap();
    assert_eq!(any.rollout(0, 20).unwrap(), coupled.rollout(&request).unwrap().y);
    assert_eq!(any.coupled().unwrap().model, coupled.model);
    assert!(baseline().coupled().is_none());
    let named = |kind: &str| refused(|v| v["kind"] = json!(kind));
    let kinds = "vcgpdm, vgpdm, map-gpdm, map-cgpdm, tmp, dmp-discrete, dmp-rhythmic";
    assert_eq!(named("gplvm"), format!("at kind: expected one of {kinds}, found \"gplvm\""));
    assert_eq!(named("vgpdm"), "at kind: expected vcgpdm for 2 parts, found vgpdm");
}

#[test]
fn wrong_fields_of_a_baseline_are_refused_with_their_path() {
    type Change = fn(&mut Value);
    let document: Value = serde_json::from_str(&baseline().to_json().unwrap()).unwrap();
    let cases: [(&str, Change); 10] = [
        ("at kind: expected map-cgpdm for 2 parts, found map-gpdm", |v| v["kind"] = json!("map-gpdm")),
        ("at model.order: expected from 1 to 100, found 0", |v| v["model"]["order"] = json!(0)),
        ("at model: sequence 0 has ", |v| v["model"]["order"] = json!(100)),
        ("at model.parts[0].latents: expected ", |v| v["sequences"][0]["frames"] = json!(39)),
        ("at model.parts[1].variance: expected positive", |v| v["model"]["parts"][1]["variance"] = json!(0)),
        ("at model.parts[1].coefficients: expected ", |v| v["model"]["parts"][1]["coefficients"] = json!([])),
        ("at model.dynamics[0].lambda[1]: expected 4, found 1", |v| {
            v["model"]["dynamics"][0]["lambda"][1] = json!([1.0]);
        }),
        ("at model.dynamics[1].coefficients: expected numbers up to 1e12", |v| {
            v["model"]["dynamics"][1]["coefficients"][3][0] = json!(1e13);
        }),
        ("at model.alpha: expected positive numbers", |v| v["model"]["alpha"][1][0] = json!(-1.0)),
        ("at provenance.settings.latent: expected a whole number, found a text", |v| {
            v["provenance"]["settings"]["latent"] = json!("two");
        }),
    ];
    for (expected, change) in cases {
        let mut value = document.clone();
        change(&mut value);
        let error = Model::from_json(&value.to_string()).err().unwrap().to_string();
        assert!(error.starts_with(expected), "expected {expected:?}, found {error:?}");
    }
}

#[test]
fn movement_primitives_are_read_as_they_were_written() {
    for settings in [
        Settings::Tmp(TmpSettings::default()),
        Settings::Tmp(TmpSettings { primitives: Some(2), ..TmpSettings::default() }),
        Settings::DmpDiscrete(DmpSettings::default()),
        Settings::DmpRhythmic(DmpSettings::default()),
    ] {
        let kind = settings.kind();
        let model = learned(settings, 120, 3);
        let text = model.to_json().unwrap();
        let again = Model::from_json(&text).unwrap();
        assert_eq!((again.kind(), again.to_json().unwrap()), (kind, text.clone()));
        assert_eq!(again.provenance, model.provenance);
        assert_eq!(again.rollout(0, 50).unwrap(), model.rollout(0, 50).unwrap());
        // Every field of a model is required and checked.
        let value: Value = serde_json::from_str(&text).unwrap();
        for name in value["model"].as_object().unwrap().keys() {
            let mut broken = value.clone();
            broken["model"].as_object_mut().unwrap().remove(name);
            let error = Model::from_json(&broken.to_string()).err().unwrap().to_string();
            assert_eq!(error, format!("at model: expected a field \"{name}\", found none"));
            broken["model"][name] = json!([["x"]]);
            let error = Model::from_json(&broken.to_string()).err().unwrap().to_string();
            assert!(error.starts_with(&format!("at model.{name}")), "{error}");
        }
    }
}

/// The text is no JSON, but that is found only after its length.
#[test]
fn a_text_of_the_largest_size_is_read() {
    let error = |bytes: usize| Model::from_json(&"x".repeat(bytes)).unwrap_err();
    assert!(matches!(error(error::MOST_BYTES), DocumentError::Json(_)));
    assert!(matches!(error(error::MOST_BYTES + 1), DocumentError::Size { .. }));
}
