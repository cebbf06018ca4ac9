//! Tests of every kind of model: trained, written, read, rolled out and scored.

use crate::call::{fails, folder, json_and_stderr, prints, text};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use vcgpdm_core::models::variational::LARGEST_COUPLING;
use vcgpdm_core::models::{
    Body, Dataset, DmpSettings, MapSettings, Model, ModelKind, Movements, PoseWeight, Sequence, Settings,
    Source, TmpSettings, VariationalSettings,
};
use vcgpdm_core::motion::{Clip, bvh, parts, samples};
use vcgpdm_lab::evaluation::dtw_mse;

const FPS: f64 = 12.0;
const START_FRAMES: usize = 5;
/// The first frames of a third walk.
const SEQUENCE: usize = 2;

/// Trains two walks and the first frames of a third.
fn train(out: &Path, more: &str) -> Value {
    let line =
        format!("train sample:walk-1 sample:walk-2 --seed-frames sample:walk-3:{START_FRAMES} --fps {FPS}");
    let mut arguments: Vec<&str> = line.split(' ').chain(more.split_whitespace()).collect();
    arguments.extend(["--out", text(out)]);
    // A model of few iterations seldom moves on, as it says on stderr.
    json_and_stderr(&arguments).0
}

/// The same with the library: all columns of a rollout from the first frames of the third walk.
fn rolled_out(candidate: &Settings, preset: &str, seed: u32, frames: usize) -> nalgebra::DMatrix<f64> {
    let clips: Vec<Clip> = [1, 2, 3].map(|k| samples::clip(&format!("walk-{k}")).unwrap()).into();
    let parts = parts::presets(&clips[0].skeleton).into_iter().find(|p| p.id == preset).unwrap().parts;
    let first = |k: usize| (k == SEQUENCE).then_some(START_FRAMES);
    let sources: Vec<Source> =
        clips.iter().enumerate().map(|(k, clip)| Source { clip, first_frames: first(k) }).collect();
    let dataset = Dataset::new(&sources, &parts, FPS).unwrap();
    let sequences = dataset.lengths().into_iter().enumerate();
    let sequences = sequences.map(|(k, frames)| Sequence { frames, whole: k != SEQUENCE }).collect();
    let mut learner = candidate.learner(&Movements { y: dataset.y.clone(), sequences }, seed).unwrap();
    while !learner.step().done {}
    Body::new(&dataset).columns(&learner.model().unwrap().rollout(SEQUENCE, frames).unwrap())
}

/// The library, the npm package, the page and the Python package are held against the same number.
#[test]
fn trains_with_the_usual_settings() {
    let golden = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/defaults.json");
    let golden: Value = serde_json::from_str(&fs::read_to_string(golden).unwrap()).unwrap();
    let clips: Vec<String> = golden["clips"]
        .as_array()
        .unwrap()
        .iter()
        .map(|id| format!("sample:{}", id.as_str().unwrap()))
        .collect();
    let (out, most) = (folder("defaults").join("model.json"), golden["max_iterations"].to_string());
    let mut arguments =
        vec!["train", "--parts", "lower,upper", "--max-iterations", &most, "--out", text(&out)];
    arguments.extend(clips.iter().map(String::as_str));
    let (found, expected) = (json_and_stderr(&arguments).0["elbo"].as_f64(), golden["bound"].as_f64());
    let (found, expected) = (found.unwrap(), expected.unwrap());
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
}

#[test]
fn rolls_out_every_kind_of_model_as_it_was_trained() {
    let gpdm = VariationalSettings {
        latent: 2,
        order: 1,
        dynamics_ips: 4,
        pose_ips: 5,
        max_iterations: 8,
        ..Default::default()
    };
    let point = |balanced| MapSettings { latent: 2, order: 1, max_iterations: 8, balanced, linear: false };
    let small = "--latent 2 --order 1 --seed 3 --max-iterations 8";
    let ips = "--dynamics-ips 4 --pose-ips 5 --as-in-papers";
    let split = "--parts lower,upper";
    let cases = [
        (Settings::Vcgpdm(gpdm.clone()), "lower-upper", format!("{split} {small} {ips}")),
        (Settings::Vgpdm(gpdm), "whole", format!("{small} {ips}")),
        (Settings::MapGpdm(point(false)), "whole", format!("--parts whole {small}")),
        (Settings::MapCgpdm(point(true)), "lower-upper", format!("{split} {small} --balanced")),
        (
            Settings::Tmp(TmpSettings { primitives: Some(2), ..TmpSettings::default() }),
            "lower-upper",
            format!("{split} --primitives 2"),
        ),
        (Settings::DmpDiscrete(DmpSettings { bases: 7 }), "whole", "--bases 7".to_owned()),
        (Settings::DmpRhythmic(DmpSettings { bases: 6 }), "whole", "--bases 6".to_owned()),
    ];
    let folder = folder("models-kinds");
    assert_eq!(cases.each_ref().map(|(candidate, ..)| candidate.kind()), ModelKind::ALL);
    for (candidate, preset, options) in cases {
        let id = candidate.kind().id();
        let (file, motion) = (folder.join(format!("{id}.json")), folder.join(format!("{id}.bvh")));
        let printed = train(&file, &format!("--model {id} {options} --note from-the-test"));
        assert_eq!(printed["kind"], id);
        assert!(printed["seconds"].as_f64().unwrap() > 0.0 && printed["reason"].is_string(), "{printed}");

        let written = fs::read_to_string(&file).unwrap();
        let model = Model::from_json(&written).unwrap();
        assert_eq!((model.kind(), model.to_json().unwrap()), (candidate.kind(), written.clone()));
        let again = rolled_out(&candidate, preset, 3, 40);
        assert_eq!(model.rollout(SEQUENCE, 40).unwrap(), again, "{id}");

        // What the program makes of the file is what the library makes of it.
        let arguments = ["rollout", text(&file), "--frames", "40", "--from", "2", "--out", text(&motion)];
        let variational = model.coupled().is_some();
        if variational {
            let (report, _) = json_and_stderr(&arguments);
            assert!(report["health"]["state"].is_string(), "{id}: {report}");
        } else {
            assert_eq!(prints(&arguments), "");
        }
        let clip = model.body.clip(&again, &format!("{id}.bvh")).unwrap();
        assert_eq!(fs::read_to_string(&motion).unwrap(), bvh::write(&clip), "{id}");
        let score: Value =
            serde_json::from_str(&prints(&["score", text(&file), "sample:walk-3", "--from", "2"])).unwrap();
        let trial = samples::clip("walk-3").unwrap().resample(1.0 / model.body.frame_time).unwrap();
        let actual = model.body.mapping.encode(&trial).unwrap().y;
        let expected = dtw_mse(&model.rollout(SEQUENCE, actual.nrows()).unwrap(), &actual).unwrap();
        assert_eq!(score["dtw_mse"].as_f64(), Some(expected.dtw_mse), "{id}");

        // Couplings and latents are there where the model has some.
        let latents = folder.join("latents.csv");
        let _ = fs::remove_file(&latents);
        for (option, value) in [("--alpha", "0:0=2"), ("--latents", text(&latents))] {
            let arguments: Vec<&str> = arguments.into_iter().chain([option, value]).collect();
            if variational {
                json_and_stderr(&arguments);
            } else if option == "--alpha" && candidate.kind() == ModelKind::MapCgpdm {
                let learned = fs::read_to_string(&motion).unwrap();
                assert_eq!(prints(&arguments), "");
                assert_ne!(fs::read_to_string(&motion).unwrap(), learned, "{id}");
            } else {
                let found = fails(&arguments);
                let expected = format!("{option}: expected a vcgpdm or vgpdm model, found a {id} model");
                assert!(found.contains(&expected), "{found}");
            }
        }
        assert_eq!(latents.exists(), variational);
        let document: Value = serde_json::from_str(&written).unwrap();
        assert_eq!(document["provenance"]["note"], "from-the-test");
        assert_eq!((&model.provenance.settings, model.provenance.iterations > 0), (&candidate, true));
        if variational {
            continue;
        }
        assert_eq!(printed["objective"].as_f64(), Some(model.provenance.objective));
        assert_eq!(printed["bound"].as_f64(), model.fitted.bound());
        let settings: Vec<(&str, f64)> = document["provenance"]["settings"]
            .as_object()
            .unwrap()
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_f64().unwrap()))
            .collect();
        let asked: &[(&str, f64)] = match candidate.kind() {
            ModelKind::Tmp => &[("primitives", 2.0)],
            ModelKind::DmpDiscrete => &[("bases", 7.0)],
            ModelKind::DmpRhythmic => &[("bases", 6.0)],
            kind => &[
                ("balanced", if kind == ModelKind::MapCgpdm { 1.0 } else { 0.0 }),
                ("latent", 2.0),
                ("max_iterations", 8.0),
                ("order", 1.0),
                ("seed", 3.0),
            ],
        };
        assert_eq!(settings, asked, "{id}");
    }
}

/// The objective is not the bound on the evidence: the program prints and stores both.
#[test]
fn trains_with_weighted_pose_terms_and_without_couplings() {
    let folder = folder("models-weighted");
    let few = "--latent 2 --dynamics-ips 3 --pose-ips 3 --max-iterations 4";
    for (option, pose_weight) in [
        ("", PoseWeight::Balanced),
        (" --balanced", PoseWeight::Balanced),
        (" --pose-weight balanced", PoseWeight::Balanced),
        (" --pose-weight 0.1", PoseWeight::Fixed(0.1)),
    ] {
        let out = folder.join(format!("{pose_weight:?}.json"));
        let printed = train(&out, &format!("--parts lower,upper {few}{option}"));
        let model = Model::from_json(&fs::read_to_string(&out).unwrap()).unwrap();
        assert_eq!(model.provenance.settings.variational().unwrap().pose_weight, pose_weight);
        assert_eq!(printed["objective"].as_f64(), Some(model.provenance.objective));
        assert_eq!(printed["elbo"].as_f64(), model.fitted.bound());
        assert_eq!(model.provenance.plain_bound, model.fitted.bound());
        assert_ne!(printed["elbo"], printed["objective"]);
    }
    let out = folder.join("uncoupled.json");
    let alpha = train(&out, &format!("--parts lower,upper {few} --uncoupled"))["alpha"].clone();
    for (j, i) in [(0, 1), (1, 0)] {
        assert!((alpha[j][i].as_f64().unwrap() - LARGEST_COUPLING).abs() < 1e-9, "{alpha}");
        assert!(alpha[j][j].as_f64().unwrap() < 5.0, "{alpha}");
    }
    let plain = train(&folder.join("plain.json"), &format!("--parts lower,upper {few} --pose-weight 1"));
    assert!(plain["objective"].is_null() && plain["elbo"].is_f64(), "{plain}");
}

/// After 40 iterations this model visits 38 % of the poses of its clip.
#[test]
fn a_model_that_would_stop_learns_from_its_rollouts_unless_told_otherwise() {
    let out = folder("models-rollouts").join("model.json");
    let line = "train sample:walk-1 --parts lower,upper --max-iterations 40 --pose-weight 1 --out";
    let arguments: Vec<&str> = line.split(' ').chain([text(&out)]).collect();
    let printed = json_and_stderr(&arguments).0;
    let rounds = printed["rollout_rounds"].as_u64().unwrap();
    assert!(rounds > 0 && printed["health"]["state"] == "moves-on", "{printed}");
    let model = Model::from_json(&fs::read_to_string(&out).unwrap()).unwrap();
    assert_eq!(model.provenance.rollout_rounds as u64, rounds);
    let plain = json_and_stderr(&[&arguments[..], &["--no-own-rollouts"]].concat()).0;
    assert!(plain["rollout_rounds"] == 0 && plain["health"]["state"] != "moves-on", "{plain}");
    assert_eq!(plain["elbo"], printed["elbo"]);
}

#[test]
fn chooses_the_kind_by_the_parts_unless_it_is_named() {
    let out = folder("models-default").join("model.json");
    let few = "--latent 2 --dynamics-ips 3 --pose-ips 3 --max-iterations 1";
    assert_eq!(train(&out, &format!("--parts lower,upper {few}"))["kind"], "vcgpdm");
    assert_eq!(train(&out, &format!("--parts whole {few}"))["kind"], "vgpdm");
}

#[test]
fn refuses_options_of_other_kinds() {
    let out = folder("models-refused").join("model.json");
    for (more, found) in [
        (
            "--model gplvm",
            "'gplvm' for '--model <KIND>': expected one of vcgpdm, vgpdm, map-gpdm, map-cgpdm, tmp, dmp-discrete",
        ),
        (
            "--model tmp --dynamics-ips 5",
            "--dynamics-ips: expected a model that has it (vcgpdm, vgpdm), found tmp",
        ),
        (
            "--model map-gpdm --pose-ips 12",
            "--pose-ips: expected a model that has it (vcgpdm, vgpdm), found map-",
        ),
        (
            "--model dmp-discrete --seed 1",
            "--seed: expected a model that has it (vcgpdm, vgpdm, map-gpdm, map-c",
        ),
        (
            "--model dmp-rhythmic --primitives 3",
            "--primitives: expected a model that has it (tmp), found dmp-r",
        ),
        (
            "--parts lower,upper --bases 9",
            "--bases: expected a model that has it (dmp-discrete, dmp-rhythmic), fou",
        ),
        (
            "--model tmp --balanced",
            "--balanced: expected a model that has it (vcgpdm, vgpdm, map-gpdm, map-cgpdm), found tmp",
        ),
        ("--model vgpdm --uncoupled", "--uncoupled: expected a model that has it (vcgpdm), found vgpdm"),
        (
            "--model map-gpdm --pose-weight 0.1",
            "--pose-weight: expected a model that has it (vcgpdm, vgpdm), found map-gpdm",
        ),
        ("--model vgpdm --balanced --pose-weight 0.1", "cannot be used with"),
        (
            "--model vgpdm --pose-weight 0",
            "'0' for '--pose-weight <W|balanced>': expected a number from 0.001 to 1000, or balanced",
        ),
        (
            "--model vgpdm --pose-weight=-1",
            "'-1' for '--pose-weight <W|balanced>': expected a number from 0.001 to 1000, or balanced",
        ),
        (
            "--model vgpdm --pose-weight NaN",
            "'NaN' for '--pose-weight <W|balanced>': expected a number from 0.001 to 1000, or balanced",
        ),
        (
            "--model vgpdm --pose-weight 1e9",
            "'1e9' for '--pose-weight <W|balanced>': expected a number from 0.001 to 1000, or balanced",
        ),
        (
            "--model tmp --write-start s.json",
            "--write-start: expected a model that has it (vcgpdm, vgpdm), found ",
        ),
        ("--model tmp --primitives 0", "'0' for '--primitives <N>': expected a whole number from 1 to 40"),
        ("", "--parts: expected how to split the body of a coupled model, such as lower,upper"),
        ("--model map-cgpdm", "--parts: expected how to split the body of a coupled model"),
        (
            "--model vcgpdm --parts whole",
            "--parts whole: expected two parts or more for a vcgpdm model, found 1; with one part choose vgpdm",
        ),
        (
            "--model map-gpdm --parts lower,upper",
            "--parts lower,upper: expected one part (whole) for a map-gpdm model, found 2; with several parts choose map-cgpdm",
        ),
    ] {
        let arguments: Vec<&str> = ["train", "sample:walk-1", "--out", text(&out)]
            .into_iter()
            .chain(more.split_whitespace())
            .collect();
        let error = fails(&arguments);
        assert!(error.contains(found), "{more}: {error}");
    }
    assert!(!out.exists(), "nothing is left behind");
}

/// Forty frames of two joints: the root goes as `x` says, the upper joint turns by the degrees of `angle`.
fn small_clip(folder: &Path, name: &str, x: impl Fn(usize) -> f64, angle: impl Fn(usize) -> f64) -> PathBuf {
    const HEADER: &str = "HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
        JOINT Chest { OFFSET 0 5 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 5 0 } } }
        MOTION\nFrames: 40\nFrame Time: 0.0333333\n";
    let rows: String = (0..40).map(|t| format!("{} 2 3 0 0 0 5 {} 7\n", x(t), 6.0 + angle(t))).collect();
    let file = folder.join(name);
    fs::write(&file, HEADER.to_owned() + &rows).unwrap();
    file
}

/// The command that trains each kind of model on a clip, with two parts if the kind needs parts.
fn of_each_kind(folder: &Path, clip: &Path) -> Vec<Vec<String>> {
    let parts = folder.join("parts.json");
    fs::write(&parts, r#"[{"name": "low", "joints": ["Hips"]}, {"name": "high", "joints": ["Chest"]}]"#)
        .unwrap();
    let command = |kind: ModelKind| {
        let model = folder.join(format!("{}.json", kind.id()));
        let split = if kind.id().contains("cgpdm") { text(&parts) } else { "whole" };
        ["train", text(clip), "--model", kind.id(), "--parts", split, "--out", text(&model)]
            .map(str::to_owned)
            .to_vec()
    };
    ModelKind::ALL.map(command).to_vec()
}

/// Once the TMP wrote a model of such a clip that could not be read.
#[test]
fn writes_a_readable_model_of_a_nearly_still_clip() {
    let folder = folder("models-still");
    let wave = |t: usize| (t as f64 / 3.0).sin();
    for (name, size) in [("still", 0.0), ("nearly", 1e-6), ("slight", 1e-3)] {
        let clip = small_clip(&folder, &format!("{name}.bvh"), |_| 1.0, |t| size * wave(t));
        for command in of_each_kind(&folder, &clip) {
            let command: Vec<&str> = command.iter().map(String::as_str).collect();
            // A warning says that the clip is still.
            json_and_stderr(&command);
            let (model, motion) = (command[command.len() - 1], folder.join("motion.bvh"));
            prints(&["rollout", model, "--frames", "60", "--out", text(&motion)]);
            assert!(!fs::read_to_string(&motion).unwrap().contains("NaN"), "{name}: {command:?}");
        }
    }
}

/// Once one distant frame gave a model with numbers that no document can have.
#[test]
fn names_the_frame_of_a_spike() {
    let folder = folder("models-spike");
    let spike = |t: usize| if t == 20 { 1e9 } else { t as f64 };
    let clip = small_clip(&folder, "spike.bvh", spike, |t| 10.0 * (t as f64 / 3.0).sin());
    for command in of_each_kind(&folder, &clip) {
        let err = fails(&command.iter().map(String::as_str).collect::<Vec<_>>());
        assert!(err.contains("spike.bvh: frame 20: expected the root less than"), "{command:?}: {err}");
    }
}
