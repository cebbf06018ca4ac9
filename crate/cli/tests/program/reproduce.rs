//! Tests of `vcgpdm reproduce`.

use crate::call::{fails, folder, json, json_and_stderr, prints, run, taller_walk, text};
use crate::library::library;
use serde_json::Value;
use std::fs;

#[test]
fn trains_a_model_again_to_the_same_bits() {
    let folder = folder("reproduce");
    let taller = taller_walk(&folder);
    let (model, again) = (folder.join("model.json"), folder.join("again.json"));
    let mut train = vec!["train", "sample:walk-1", text(&taller), "--seed-frames", "sample:walk-3:4"];
    train.extend(["--first-bones", "--parts", "lower,upper", "--fps", "12", "--seed", "3"]);
    train.extend(["--max-iterations", "8", "--note", "for a test", "--out", text(&model)]);
    // A warning says that the bones are those of the first clip.
    json_and_stderr(&train);
    let clips = ["sample:walk-3", text(&taller), "sample:walk-1"];
    let mut reproduce = vec!["reproduce", text(&model)];
    reproduce.extend(clips);
    // In two threads too.
    let found = json(&[&reproduce[..], &["--out", text(&again), "--threads", "2"]].concat());
    assert_eq!((found["same_bits"].as_bool(), found["iterations"].as_u64()), (Some(true), Some(8)));
    assert_eq!(found["objective"], found["recorded_objective"]);
    assert_eq!(found["largest_difference"], Value::Null);
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

    // An earlier version wrote no noise variance of each column.
    let mut earlier = recorded.clone();
    assert_eq!(earlier["version"], 4);
    earlier["version"] = 1.into();
    for part in earlier["parts"].as_array_mut().unwrap() {
        assert!(part.as_object_mut().unwrap().remove("column_noise").is_some());
    }
    let file = folder.join("earlier.json");
    fs::write(&file, earlier.to_string()).unwrap();
    reproduce[1] = text(&file);
    assert_eq!(json(&reproduce)["same_bits"], true);

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
        let found = fails(&[&reproduce[..], &["--tolerance", tolerance]].concat());
        assert!(found.contains(": expected a finite number from 0\n"), "{found}");
    }
}

#[test]
fn names_a_missing_clip() {
    let folder = folder("reproduce-missing");
    let model = folder.join("model.json");
    let line = "train sample:walk-1 sample:walk-2 --parts whole --model tmp --primitives 4 --fps 12";
    let mut train: Vec<&str> = line.split(' ').collect();
    train.extend(["--out", text(&model)]);
    json(&train);
    let found = fails(&["reproduce", text(&model), "sample:walk-2"]);
    assert!(found.contains("expected the clip walk-1 (made by this project).bvh (SHA-256 "), "{found}");
    let found = json(&["reproduce", text(&model), "sample:walk-2", "sample:walk-1"]);
    assert_eq!(found["same_bits"], true);
}

#[test]
fn refuses_a_combination_of_primitives() {
    let library = library("reproduce-library");
    let model = library.with_file_name("model.json");
    json(&["couple", text(&library), "--use", "lower=walk,upper=wave", "--out", text(&model)]);
    let found = fails(&["reproduce", text(&model), "sample:walk-wave-1"]);
    assert!(
        found.contains("model.json: expected a model that was trained on clips, found a combination"),
        "{found}"
    );
}
