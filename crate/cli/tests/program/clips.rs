//! Tests of what holds for every command that reads clips: warnings, and the axis that points up.

use crate::call::{fails, folder, json_and_stderr, run, text, under_a_still_root};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;

/// Two walks under a still root, a model and two libraries that were trained on them, and the first walk with
/// z up.
struct Files {
    folder: PathBuf,
    walk: String,
    other: String,
    turned: String,
    model: String,
    library: String,
}

impl Files {
    fn new(name: &str) -> Self {
        let folder = folder(name);
        let file = |name: &str| text(&folder.join(name)).to_owned();
        let files = Files {
            walk: file("walk.bvh"),
            other: file("other.bvh"),
            turned: file("turned.bvh"),
            model: file("model.json"),
            library: file("library.json"),
            folder,
        };
        under_a_still_root("sample:walk-1", 0.0, files.walk.as_ref());
        under_a_still_root("sample:walk-2", 0.0, files.other.as_ref());
        under_a_still_root("sample:walk-1", 90.0, files.turned.as_ref());
        files
    }

    /// The summary of a command line with the names of files in braces, and its lines on stderr.
    fn run(&self, line: &str) -> (Value, String) {
        let line = self.line(line);
        json_and_stderr(&line.iter().map(String::as_str).collect::<Vec<_>>())
    }

    fn line(&self, line: &str) -> Vec<String> {
        let word = |word: &str| {
            let named = [
                ("{walk}", &self.walk),
                ("{other}", &self.other),
                ("{turned}", &self.turned),
                ("{model}", &self.model),
                ("{library}", &self.library),
            ];
            let named =
                named.into_iter().fold(word.to_owned(), |word, (name, file)| word.replace(name, file));
            named.replace("{folder}", text(&self.folder))
        };
        line.split_whitespace().map(word).collect()
    }

    fn train(&self) {
        let small =
            "--parts lower,upper --fps 10 --latent 2 --dynamics-ips 4 --pose-ips 4 --max-iterations 3";
        self.run(&format!("train {{walk}} {small} --out {{model}}"));
        self.run(&format!("train --movement a={{walk}} --movement b={{other}} {small} --out {{library}}"));
    }
}

#[test]
fn every_command_says_once_what_is_unusual_in_a_clip() {
    let files = Files::new("warnings");
    files.train();
    let split = "--parts lower,upper --fps 10";
    for line in [
        &format!("train {{walk}} {split} --max-iterations 1 --out {{folder}}/again.json"),
        &format!("train --movement a={{walk}} {split} --max-iterations 1 --out {{folder}}/again.json"),
        "complete {model} {walk} --given lower",
        "rollout {model} --frames 12 --from {walk}:5 --out {folder}/out.bvh",
        "score {model} {walk}",
        "reproduce {model} {walk}",
        "recognise {library} {walk}",
        "couple {library} --use lower=a,upper=b --clip {walk} --max-iterations 1 --out {folder}/fitted.json",
        &format!("evaluate {{walk}} {{other}} {split} --models dmp-rhythmic --out {{folder}}/results.json"),
        "study {folder}/results.json {walk} {other} --out {folder}/study.json",
    ] {
        let (_, err) = files.run(line);
        let said = err.matches("vcgpdm: walk.bvh: the root \"rig:Reference\" only carries").count();
        assert_eq!(said, 1, "{line}: {err}");
    }
    // The summary of a clip has the warnings.
    let clip = run(&["clip", &files.walk]);
    assert!(clip.stderr.is_empty() && String::from_utf8(clip.stdout).unwrap().contains("only carries"));
}

/// The numbers of a summary, without times.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(number) => vec![number.as_f64().unwrap()],
        Value::Array(values) => values.iter().flat_map(numbers).collect(),
        Value::Object(fields) => fields
            .iter()
            .filter(|(name, _)| *name != "seconds")
            .flat_map(|(_, value)| numbers(value))
            .collect(),
        _ => Vec::new(),
    }
}

/// The largest difference of two lists, relative to the larger number.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs() / a.abs().max(b.abs()).max(1e-9)).fold(0.0, f64::max)
}

#[test]
fn a_clip_can_have_another_axis_than_the_model() {
    let files = Files::new("axes");
    files.train();
    for line in [
        "complete {model} CLIP --given lower",
        "rollout {model} --frames 12 --from CLIP:5 --out {folder}/out.bvh",
        "score {model} CLIP",
        "recognise {library} CLIP",
        "couple {library} --use lower=a,upper=b --clip CLIP --max-iterations 1 --out {folder}/fitted.json",
    ] {
        let summary = |clip: &str, option: &str| {
            numbers(&files.run(&format!("{} {option}", line.replace("CLIP", clip))).0)
        };
        let as_in_model = summary("{walk}", "");
        for option in ["", "--up z"] {
            let apart = difference(&summary("{turned}", option), &as_in_model);
            assert!(apart < 1e-6, "{line} {option}: {apart}");
        }
        // A body that lies is unlike every movement, and the shares can stay the same.
        if !line.starts_with("recognise") {
            let lying = difference(&summary("{turned}", "--up y"), &as_in_model);
            assert!(lying > 1e-3, "{line}: {lying}");
        }
    }
    // Only clips have the axis.
    for (line, expected) in [
        ("rollout {model} --frames 12 --up z --out {folder}/out.bvh", "--from CLIP:FRAMES"),
        ("couple {library} --use lower=a,upper=b --up z --out {folder}/fitted.json", "--clip"),
    ] {
        let line = files.line(line);
        let refused = fails(&line.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(refused, format!("vcgpdm: --up: expected {expected} with it\n"));
    }
}

#[test]
fn writes_a_completed_motion_with_plain_names() {
    let files = Files::new("names");
    let train = "train {walk} --parts lower,upper --fps 10 --max-iterations 1 --out {model}";
    files.run(train);
    files.run("complete {model} {walk} --given lower --plain-names --out {folder}/out.bvh");
    let written = std::fs::read_to_string(files.folder.join("out.bvh")).unwrap();
    assert!(written.contains("ROOT Hips\n") && !written.contains("rig:"));
    let line = files.line("complete {model} {walk} --given lower --plain-names");
    let refused = run(&line.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(refused.status.code(), Some(2), "--plain-names needs --out");
}

/// The interpolation of a clip with frames of seconds would take minutes, without a word.
#[test]
fn a_frame_time_of_seconds_is_said_before_the_work_and_a_rate_is_refused() {
    let folder = folder("frame-time");
    let (walk, model) = (folder.join("walk.bvh"), folder.join("model.json"));
    run(&["clip", "sample:walk-1", "--frames", "0-20", "--fps", "10", "--out", text(&walk)]);
    let bvh = fs::read_to_string(&walk).unwrap();
    let with_time = |time: &str| fs::write(&walk, bvh.replace("Frame Time: 0.1", time)).unwrap();
    with_time("Frame Time: 30");
    let train = ["train", text(&walk), "--parts", "whole", "--max-iterations", "1", "--out", text(&model)];
    assert!(fails(&train).contains("expected the seconds of a frame, from 0.00001 to 10, not a rate"));
    let (clip, err) = json_and_stderr(&["clip", text(&walk), "--clip-fps", "30"]);
    assert_eq!((clip["frame_time"].as_f64(), err.as_str()), (Some(1.0 / 30.0), ""));
    with_time("Frame Time: 2");
    let (summary, err) = json_and_stderr(&[&train[..], &["--fps", "0.5"]].concat());
    let warning = summary["warnings"][0].as_str().unwrap();
    assert!(warning.contains("a frame lasts 2 s"), "{warning}");
    assert_eq!(err.matches(warning).count(), 1, "{err}");
}
