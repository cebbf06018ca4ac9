//! `vcgpdm reproduce`: what a model's file says is enough to train it again.

use crate::call::{fails, folder, json, prints, run, taller_walk, text};
use crate::library::library;
use serde_json::Value;
use std::fs;

#[test]
fn a_model_is_trained_again_to_the_same_bits_from_its_file() {
    let folder = folder("reproduce");
    let taller = taller_walk(&folder);
    let (model, again) = (folder.join("model.json"), folder.join("again.json"));
    let mut train = vec!["train", "sample:walk-1", text(&taller), "--seed-frames", "sample:walk-3:4"];
    train.extend(["--first-bones", "--parts", "lower,upper", "--fps", "12", "--seed", "3"]);
    train.extend(["--max-iterations", "8", "--note", "for a test", "--out", text(&model)]);
    json(&train);
    let clips = ["sample:walk-3", text(&taller), "sample:walk-1"];
    let mut reproduce = vec!["reproduce", text(&model)];
    reproduce.extend(clips);
    // In two threads too.
    let said = json(&[&reproduce[..], &["--out", text(&again), "--threads", "2"]].concat());
    assert_eq!((said["same_bits"].as_bool(), said["iterations"].as_u64()), (Some(true), Some(8)));
    assert_eq!(said["objective"], said["recorded_objective"]);
    assert_eq!(said["largest_difference"], Value::Null);
    let written: Value = serde_json::from_str(&fs::read_to_string(&again).unwrap()).unwrap();
    let recorded: Value = serde_json::from_str(&fs::read_to_string(&model).unwrap()).unwrap();
    assert_eq!(written["sequences"], recorded["sequences"]);
    assert_eq!(written["sequences"][1]["bones_of"], "walk-1 (made by this project).bvh");
    assert_eq!(written["sequences"][2]["whole"], false);

    // Clips are known by their content, not by their names.
    let copy = folder.join("copy.bvh");
    prints(&["clip", "sample:walk-1", "--out", text(&copy)]);
    let copied = [&reproduce[..4], &[text(&copy)]].concat();
    let first = json(&["clip", "sample:walk-1"]);
    assert_eq!(json(&["clip", text(&copy)])["sha256"], first["sha256"]);
    assert_eq!(json(&copied)["same_bits"], true);

    // Somebody has touched a coupling.
    let mut touched = recorded;
    let alpha = touched["alpha"][0][1].as_f64().unwrap();
    touched["alpha"][0][1] = (1.001 * alpha).into();
    let other = folder.join("touched.json");
    fs::write(&other, touched.to_string()).unwrap();
    reproduce[1] = text(&other);
    let output = run(&reproduce);
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(!output.status.success() && out.contains("\"within_tolerance\":false"), "{out}");
    assert!(err.contains("alpha") && err.contains("differs"), "{err}");
    prints(&[&reproduce[..], &["--tolerance", "0.01"]].concat());
    for tolerance in ["nan", "-1", "inf"] {
        let said = fails(&[&reproduce[..], &["--tolerance", tolerance]].concat());
        assert!(said.contains(": expected a finite number from 0\n"), "{said}");
    }
}

#[test]
fn a_clip_that_is_missing_is_named() {
    let folder = folder("reproduce-missing");
    let model = folder.join("model.json");
    let line = "train sample:walk-1 sample:walk-2 --parts whole --model tmp --primitives 4 --fps 12";
    let mut train: Vec<&str> = line.split(' ').collect();
    train.extend(["--out", text(&model)]);
    json(&train);
    let said = fails(&["reproduce", text(&model), "sample:walk-2"]);
    assert!(said.contains("expected the clip walk-1 (made by this project).bvh (SHA-256 "), "{said}");
    let said = json(&["reproduce", text(&model), "sample:walk-2", "sample:walk-1"]);
    assert_eq!(said["same_bits"], true);
}

#[test]
fn a_model_that_was_put_together_is_not_trained_as_something_else() {
    let library = library("reproduce-library");
    let model = library.with_file_name("model.json");
    json(&["couple", text(&library), "--use", "lower=walk,upper=wave", "--out", text(&model)]);
    let said = fails(&["reproduce", text(&model), "sample:walk-wave-1"]);
    assert!(
        said.contains("model.json: expected a model that was trained on clips, found a combination"),
        "{said}"
    );
}
