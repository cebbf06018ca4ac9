//! Tests of libraries of primitives: trained, combined, and coupled to a clip.

use crate::call::{fails, folder, json_and_stderr, one_frame, prints, text};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use vcgpdm_core::models::Model;
use vcgpdm_core::models::library::{CouplingsFrom, TrainedLibrary};

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&prints(arguments)).unwrap()
}

/// A small library of two movements with the lower body in common.
pub fn library(name: &str) -> PathBuf {
    let out = folder(name).join("library.json");
    let line = "train --movement walk=sample:walk-1,sample:walk-2 --movement wave=sample:walk-wave-1 --share lower \
                --parts lower,upper --fps 12 --latent 2 --dynamics-ips 6 --pose-ips 6 --max-iterations 20";
    let mut arguments: Vec<&str> = line.split_whitespace().collect();
    arguments.extend(["--out", text(&out)]);
    let printed = json(&arguments);
    let names: Vec<&str> =
        printed["primitives"].as_array().unwrap().iter().map(|p| p["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["walk+wave", "walk", "wave"]);
    assert_eq!(printed["movements"][1]["uses"]["upper"], "wave");
    out
}

#[test]
fn couples_primitives_of_a_library_in_a_new_combination() {
    let library = library("couple");
    let (out, again) = (library.with_file_name("model.json"), library.with_file_name("again.json"));
    // As it was learned.
    let uses = ["couple", text(&library), "--use", "lower=walk,upper=wave"];
    let printed = json(&[&uses[..], &["--out", text(&out)]].concat());
    assert_eq!(printed["couplings"]["from"], "training");
    let model = Model::coupled_from_json(&fs::read_to_string(&out).unwrap()).unwrap();
    assert_eq!(model.body.sequences[0].name, "walk-wave-1 (made by this project).bvh");
    prints(&["rollout", text(&out), "--frames", "30", "--out", text(&library.with_file_name("motion.bvh"))]);
    // To a clip; the library keeps the combination.
    let fit = [
        "--clip",
        "sample:walk-wave-2",
        "--max-iterations",
        "12",
        "--name",
        "again",
        "--library-out",
        text(&again),
    ];
    let printed = json(&[&uses[..], &["--out", text(&out)], &fit].concat());
    assert_eq!(printed["couplings"]["from"], "clips");
    let kept = TrainedLibrary::from_json(&fs::read_to_string(&again).unwrap()).unwrap();
    let movement = kept.library.movements.last().unwrap();
    assert_eq!((movement.name.as_str(), &movement.uses), ("again", &vec![0, 2]));
    assert!(matches!(movement.couplings, CouplingsFrom::Clips { iterations: 1..=12, .. }));
    // It makes way for another one; what was learned does not.
    let more =
        ["couple", text(&again), "--use", "lower=walk,upper=wave", "--out", text(&out), "--library-out"];
    let others = library.with_file_name("others.json");
    json(&[&more[..], &[text(&others), "--name", "again"]].concat());
    let kept = TrainedLibrary::from_json(&fs::read_to_string(&others).unwrap()).unwrap();
    assert_eq!(kept.library.movements.len(), 3);
    let words = fails(&[&more[..], &[text(&others), "--name", "wave"]].concat());
    assert!(
        words.contains("--name: expected a name that no learned movement has, found \"wave\""),
        "{words}"
    );
    let words = fails(&[&more[..], &[text(&out), "--name", "other"]].concat());
    assert!(
        words.contains("--library-out ") && words.contains("expected a file of its own, found that of --out"),
        "{words}"
    );
    // The clip is named that is too short, not the number of its sequence.
    let short = one_frame(library.parent().unwrap());
    let words = fails(
        &[&uses[..], &["--out", text(&out), "--clip", "sample:walk-1", "--clip", text(&short)]].concat(),
    );
    assert_eq!(words, "vcgpdm: the clip short.bvh has 1 frame; dynamics of order 2 need at least 3\n");
    let alpha: Vec<Vec<f64>> = serde_json::from_value(printed["alpha"].clone()).unwrap();
    assert_eq!(movement.alpha[(0, 1)], alpha[0][1]);
}

/// After 20 iterations both movements come to rest.
#[test]
fn movements_that_would_stop_learn_from_their_rollouts_unless_told_otherwise() {
    let out = folder("library-rollouts").join("library.json");
    let line = "train --movement walk=sample:walk-1 --movement wave=sample:stand-wave-1 --parts lower,upper \
                --dynamics-ips 8 --pose-ips 8 --max-iterations 20";
    let arguments: Vec<&str> = line.split_whitespace().chain(["--out", text(&out)]).collect();
    let ends = |options: &[&str]| {
        let (printed, stderr) = json_and_stderr(&[&arguments[..], options].concat());
        let movements = printed["movements"].as_array().unwrap().clone();
        let end = |movement: &Value| movement["health"]["state"].as_str().unwrap().to_owned();
        let learned = movements.iter().all(|movement| movement["rollout_rounds"].as_u64() > Some(0));
        (movements.iter().map(end).collect::<Vec<_>>(), learned, stderr)
    };
    let (after, learned, _) = ends(&[]);
    assert!(learned && after == ["moves-on", "moves-on"], "{after:?}");
    let (before, learned, stderr) = ends(&["--no-own-rollouts"]);
    assert!(!learned && before == ["keeps-one-pose", "stands-still"], "{before:?}");
    assert!(stderr.contains("warning: the movement wave stands still from"), "{stderr}");
}

#[test]
fn refuses_wrong_combinations() {
    let library = library("refuse");
    let out = library.with_file_name("model.json");
    let couple = |uses: &str| fails(&["couple", text(&library), "--use", uses, "--out", text(&out)]);
    assert!(
        couple("lower=walk").contains("expected PART=PRIMITIVE for each part"),
        "{}",
        couple("lower=walk")
    );
    let words = couple("lower=walk,upper=walk,upper=wave");
    assert!(words.contains("for each part, such as lower=walk+wave,upper=walk, found \"lower="), "{words}");
    assert!(couple("lower=walk,upper=jump").contains("to be one of walk, wave, found \"jump\""));
    let words = fails(&["rollout", text(&library), "--frames", "9", "--out", text(&out)]);
    assert!(words.contains("found a library of primitives"), "{words}");
    let train = |movement: &str| {
        fails(&["train", "--movement", movement, "--parts", "lower,upper", "--out", text(&out)])
    };
    assert!(train("walk").contains("--movement walk: expected NAME=CLIP,CLIP"), "{}", train("walk"));
    assert!(train("a+b=sample:walk-1").contains("expected a name for each movement"));
    let share =
        ["--movement", "a=sample:walk-1", "--share", "tail", "--parts", "lower,upper", "--out", text(&out)];
    let words = fails(&[&["train"], &share[..]].concat());
    let alone = ["train", "sample:walk-1", "--share", "lower", "--parts", "lower,upper", "--out", text(&out)];
    assert!(fails(&alone).contains("--share: expected --movement with it"));
    assert!(words.contains("--share tail: expected one of the parts lower, upper"), "{words}");
}

#[test]
fn saves_primitives_and_adds_them_to_other_libraries() {
    let library = library("primitives");
    let sibling = |name: &str| library.with_file_name(name);
    let listed = json(&["primitives", text(&library)]);
    assert_eq!(listed["primitives"][0]["part"], "lower");
    assert_eq!(listed["primitives"][0]["origin"]["clips"].as_array().unwrap().len(), 3);
    // One alone, and all but that one.
    let (arms, rest, whole) = (sibling("arms.json"), sibling("rest.json"), sibling("whole.json"));
    let save =
        |what: &str, out: &PathBuf| json(&["primitives", text(&library), "--save", what, "--out", text(out)]);
    assert_eq!(save("upper=wave", &arms)["primitives"][0]["name"], "wave");
    assert_eq!(save("lower=walk,upper=walk", &rest)["movements"][0]["name"], "walk");
    let printed = json(&["primitives", text(&rest), "--add", text(&arms), "--out", text(&whole)]);
    assert_eq!(printed["added"][0]["name"], "wave");
    // Twice is once.
    let out = sibling("again.json");
    let twice = ["primitives", text(&whole), "--add", text(&arms), "--out", text(&out)];
    assert_eq!(json(&twice)["added"], serde_json::json!([]));

    // Of another training: refused with the reason.
    let other = sibling("other.json");
    let line = "train --movement stroll=sample:walk-3 --parts lower,upper --fps 12 --latent 3 --dynamics-ips 6 --pose-ips 6 \
                --max-iterations 20";
    json(&[&line.split_whitespace().collect::<Vec<_>>()[..], &["--out", text(&other)]].concat());
    let adding = ["primitives", text(&library), "--add", text(&other), "--out", text(&out)];
    let words = fails(&adding);
    assert!(words.ends_with("the latent dimensions of lower differ: expected 2, found 3\n"), "{words}");
    let save = ["primitives", text(&library), "--out", text(&out), "--save", "lower=run"];
    assert!(fails(&save).contains("--save: expected the primitive to be one of walk+wave, found \"run\""));
    assert!(fails(&save[..4]).contains("--out: expected --save or --add with it"));
}
