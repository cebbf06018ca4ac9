//! Tests of `vcgpdm study` and `vcgpdm perception`.

use crate::call::{fails, folder, json, prints, run, text};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

fn of_project(place: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(place)
}

fn read(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn makes_a_study_of_an_evaluation_and_changes_a_study() {
    let folder = folder("study");
    let results = folder.join("results.json");
    let clips = ["sample:walk-1", "sample:walk-2"];
    let options = "--parts lower,upper --models tmp,dmp-discrete,vgpdm --primitives 3 --bases 5,20 --ips 4 --max-iterations 5 --seeds 0,1";
    let mut evaluate = vec!["evaluate"];
    evaluate.extend(clips);
    evaluate.extend(options.split(' '));
    evaluate.extend(["--out", text(&results)]);
    assert!(run(&evaluate).status.success());
    let made = folder.join("study.json");
    let mut study = vec!["study", text(&results), clips[1], clips[0], "--unseen", "sample:walk-6"];
    study.extend(["--title", "Two walks", "--failed", "dmp-discrete-5-trial-2", "--out", text(&made)]);
    let found = json(&study);
    let count = |name: &str| found[name].as_u64().unwrap();
    assert_eq!(["natural", "unseen", "generated", "failed"].map(count), [2, 1, 8, 1]);
    assert_eq!(["blocks", "comparisons", "attention_checks", "catch_trials"].map(count), [1, 52, 4, 4]);
    let document = read(&made);
    assert_eq!((&document["title"], &document["frames_per_second"]), (&"Two walks".into(), &30.into()));
    let stimuli = document["stimuli"].as_array().unwrap();
    let find =
        |id: &str| stimuli.iter().find(|stimulus| stimulus["id"] == id).unwrap_or_else(|| panic!("{id}"));
    assert_eq!(find("trial-2")["trial"], "walk-2 (made by this project).bvh");
    // Trained again, it is as good as in the evaluation; of two seeds that whose rollouts repeat the training
    // trials best.
    let evaluated = read(&results);
    for (id, model) in [("vgpdm-4-4-trial-1", "vgpdm"), ("tmp-3-trial-1", "tmp")] {
        let error = |outcome: &Value| outcome["training_mse"].as_f64().unwrap();
        let outcomes: Vec<&Value> = (evaluated["finished"].as_array().unwrap().iter())
            .filter(|f| f["job"]["candidate"]["model"] == model && f["job"]["held_out"] == 1)
            .map(|f| &f["outcome"])
            .collect();
        let best = outcomes.iter().min_by(|a, b| error(a).total_cmp(&error(b))).unwrap();
        assert_eq!(find(id)["scores"]["dtw_mse"], best["score"]["dtw_mse"], "{id}");
        assert_eq!(find(id)["scores"]["bound"], best["bound"], "{id}");
    }
    assert!(find("vgpdm-4-4-trial-1")["scores"]["terms"]["entropy"].is_number());

    let other = folder.join("other.json");
    let mut change = vec!["study", text(&made), "--preset", "p3-part-1", "--look", "points", "--seed", "9"];
    change.extend(["--failed", "tmp-3-trial-1,tmp-3-trial-2", "--out", text(&other)]);
    let changed = json(&change);
    assert_eq!(changed["hash"], found["hash"], "the same movements");
    let count = |name: &str| changed[name].as_u64().unwrap();
    assert_eq!(
        ["blocks", "comparisons", "attention_checks", "catch_trials", "failed"].map(count),
        [4, 620, 17, 6, 2]
    );
    let document = read(&other);
    assert_eq!((&document["look"], &document["design"]["seed"]), (&"points".into(), &9.into()));

    let refused =
        |more: &[&str]| fails(&[&["study", text(&results)], more, &["--out", text(&other)]].concat());
    let missing = refused(&["sample:walk-1", "sample:walk-3"]);
    assert!(missing.contains("expected the clip walk-2 (made by this project).bvh (SHA-256 "), "{missing}");
    let preset = refused(&["sample:walk-1", "sample:walk-2", "--preset", "p9"]);
    assert!(preset.contains("--preset p9: expected one of class, p3-part-1, p3-part-2, p2"), "{preset}");
    let long = refused(&["sample:walk-1", "sample:walk-2", "--models", "tmp", "--seconds", "9"]);
    assert!(long.contains("trial-1: expected a movement of at least 9.00 seconds, found 4.20"), "{long}");
    for seconds in ["0", "-1", "61", "NaN"] {
        let found = refused(&["sample:walk-1", "sample:walk-2", "--seconds", seconds]);
        assert_eq!(found, format!("vcgpdm: --seconds: expected seconds from 0.1 to 60, found {seconds}\n"));
    }
    let no_study = refused(&[]);
    assert!(no_study.contains("expected a study with \"format\": \"vcgpdm study\", found"), "{no_study}");
    let id = fails(&["study", text(&made), "--failed", "trial-1", "--out", text(&other)]);
    assert!(id.contains("expected a movement of the study, found trial-1"), "{id}");
    let making = ["--models tmp", "--folds 1", "--unseen sample:walk-6", "--seconds 2", "--up z"];
    for option in making.map(|option| option.split(' ').collect::<Vec<_>>()) {
        let found = fails(&[&["study", text(&made), "--out", text(&other)], &option[..]].concat());
        let expected = format!("{}: expected the clips of an evaluation with it", option[0]);
        assert!(found.contains(&expected), "{found}");
    }
    let itself = fails(&["study", text(&made), "--out", text(&made)]);
    assert!(itself.contains("expected another file to write to: this one is read"), "{itself}");
}

/// The study of the page, and the answers of two simulated participants.
fn answer_files() -> (PathBuf, [PathBuf; 2]) {
    let answers = ["p1", "p2"].map(|name| of_project(&format!("tests/perception/{name}.csv")));
    (of_project("www/public/study/walks.study.json"), answers)
}

/// Checks that two documents are equal up to the last digits of their numbers.
fn assert_close(a: &Value, b: &Value, at: &str) {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
            assert!((a - b).abs() <= 1e-6 * (1.0 + a.abs()), "{at}: {a} {b}");
        }
        (Value::Array(a), Value::Array(b)) => {
            assert_eq!(a.len(), b.len(), "{at}");
            a.iter().zip(b).enumerate().for_each(|(k, (a, b))| assert_close(a, b, &format!("{at}[{k}]")));
        }
        (Value::Object(a), Value::Object(b)) => {
            assert!(a.keys().eq(b.keys()), "{at}");
            a.iter().for_each(|(name, a)| assert_close(a, &b[name], &format!("{at}.{name}")));
        }
        _ => assert_eq!(a, b, "{at}"),
    }
}

#[test]
fn gives_the_same_results_as_the_npm_package() {
    let folder = folder("perception");
    let (study, [p1, p2]) = answer_files();
    let (out, figures) = (folder.join("results.json"), folder.join("figures"));
    let mut analyse = vec!["perception", text(&study), text(&p1), text(&p2), "--out", text(&out)];
    analyse.extend(["--figures", text(&figures)]);
    let tables = prints(&analyse);
    // The test of the npm package compares with the same file.
    let mut stored = read(&of_project("tests/perception/results.json"));
    // The version does not count.
    stored["engine"] = vcgpdm_core::models::ENGINE.into();
    assert_close(&read(&out), &stored, "results");
    for words in [
        "| p1 | 52 | 0 | 4 of 4 |",
        "2 participants, 0 left out",
        "| model | score S |",
        "| best setting of each kind |",
    ] {
        assert!(tables.contains(words), "{words}: {tables}");
    }
    for table in read(&figures.join("figures.json")).as_array().unwrap() {
        let csv = fs::read_to_string(figures.join(table["file"].as_str().unwrap())).unwrap();
        assert!(csv.lines().count() > 1, "{table}");
    }
    let settings = fs::read_to_string(figures.join("settings.csv")).unwrap();
    assert!(settings.contains("dmp-discrete,3 bases,,,,3,0,2,"), "an attention check: {settings}");
    // With another ceiling there are other curves.
    let other = prints(&[&analyse[..4], &["--ceiling", "1"]].concat());
    assert!(other.contains("p = 1 / (1 + exp(w0 + w1 S))") && other != tables);

    let wrong = folder.join("wrong.csv");
    let with = |from: &str, to: &str| {
        fs::write(&wrong, fs::read_to_string(&p1).unwrap().replacen(from, to, 1)).unwrap();
        fails(&["perception", text(&study), text(&wrong)])
    };
    let row = with("\"comparison\"", "\"guess\"");
    assert!(
        row.contains("wrong.csv: line 2, kind: expected comparison, attention or catch, found \"guess\""),
        "{row}"
    );
    let twice = fails(&["perception", text(&study), text(&p1), text(&p1)]);
    assert!(twice.contains("expected every trial of a participant once"), "{twice}");
    let option = fails(&["perception", text(&study), text(&p1), "--ceiling", "2"]);
    assert!(option.contains("vcgpdm: --ceiling: expected a number above 0, up to 1, found 2"), "{option}");
}

#[test]
fn prints_the_numbers_of_the_paper() {
    let found = prints(&["perception", "--paper"]);
    for words in [
        "| 0.36 | 0.356",
        "P(TMP > vGPDM) | 0.87 | 0.869",
        "P(vGPDM > vCGPDM) | 0.86 | 0.857",
        "| about 0.8 | 0.79",
        "| 158 | 158 |",
    ] {
        assert!(found.contains(words), "{words}: {found}");
    }
    let none = fails(&["perception"]);
    assert!(none.contains("STUDY.json"), "{none}");
}
