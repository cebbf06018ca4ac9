//! Tests of the commands: outputs, files and errors.

use crate::call::{fails, folder, json, json_and_stderr, one_frame, run, taller_walk, text};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

#[test]
fn prints_help_and_version_without_an_error() {
    let commands = ["bound", "clip", "train", "rollout", "score", "evaluate", "report"]
        .map(|command| vec![command, "--help"]);
    for arguments in commands.iter().map(Vec::as_slice).chain([&["--help"][..], &["--version"]]) {
        let output = run(arguments);
        assert!(output.status.success() && !output.stdout.is_empty() && output.stderr.is_empty());
    }
}

#[test]
fn answers_a_wrong_command_line_with_one_line() {
    assert!(fails(&[]).contains("expected one of the commands"));
    assert!(fails(&["dance"]).contains("'dance'"));
    assert!(fails(&["clip"]).contains("CLIP"));
    assert!(fails(&["clip", "sample:walk-1", "--fps", "many"]).contains("'many'"));
    assert!(fails(&["clip", "sample:walk-1", "--speed", "3"]).contains("--speed"));
    assert!(fails(&["bound", "case.json", "--repeat", "0"]).contains("--repeat"));
}

/// Once a negative number had another message and another exit status than zero.
#[test]
fn states_the_range_of_an_option_in_the_error() {
    let seed = "from 0 to 4294967295";
    for (line, option, wrong, range) in [
        ("train c.bvh --out m --latent", "--latent <Q>", "-1 0 1.5 101", "from 1 to 100"),
        ("train c.bvh --out m --order", "--order <P>", "-1 0 1.5 101", "from 1 to 100"),
        ("train c.bvh --out m --dynamics-ips", "--dynamics-ips <K>", "-1 0 1001", "from 1 to 1000"),
        ("train c.bvh --out m --pose-ips", "--pose-ips <L>", "-1 0 1001", "from 1 to 1000"),
        ("train c.bvh --out m --max-iterations", "--max-iterations <N>", "-1 few", "from 0"),
        ("train c.bvh --out m --primitives", "--primitives <N>", "-2 0 41", "from 1 to 40"),
        ("train c.bvh --out m --bases", "--bases <B>", "-2 0 201", "from 1 to 200"),
        ("train c.bvh --out m --seed", "--seed <S>", "-1 0.5 4294967296", seed),
        ("train c.bvh --out m --threads", "--threads <T>", "-1 0 65536", "from 1 to 65535"),
        ("evaluate c.bvh --parts p --out r --ips", "--ips <K,K>", "-1 0 12,0 1001", "from 1 to 1000"),
        ("evaluate c.bvh --parts p --out r --pose-ips", "--pose-ips <L,L>", "-1 0", "from 1 to 1000"),
        ("evaluate c.bvh --parts p --out r --bases", "--bases <B,B>", "-1 0", "from 1 to 200"),
        ("evaluate c.bvh --parts p --out r --latent", "--latent <Q>", "-1 0", "from 1 to 100"),
        ("evaluate c.bvh --parts p --out r --order", "--order <P>", "-1 0", "from 1 to 100"),
        ("evaluate c.bvh --parts p --out r --seeds", "--seeds <S,S>", "-1 0,0.5", seed),
        ("evaluate c.bvh --parts p --out r --training-trials", "--training-trials <N,N>", "-1 0", "from 1"),
        ("evaluate c.bvh --parts p --out r --threads", "--threads <T>", "-1 0", "from 1 to 65535"),
        (
            "couple l --use u --out m --max-iterations",
            "--max-iterations <N>",
            "-1 0 10001",
            "from 1 to 10000",
        ),
        ("rollout m --out o --frames", "--frames <N>", "-1 0 99999999999999999999", "from 1 to 1000000"),
        ("rollout m --out o --frames 9 --seed 1 --samples", "--samples <N>", "-1 0 1001", "from 1 to 1000"),
        ("score m c.bvh --from", "--from <SEQUENCE>", "-1", "from 0"),
        ("bound c.json --repeat", "--repeat <N>", "-1 0", "from 1 to 4294967295"),
        ("perception s a --folds", "--folds <N>", "-1 0 1 1001", "from 2 to 1000"),
        ("perception s a --draws", "--draws <N>", "-1 0", "from 1 to 10000000"),
    ] {
        for wrong in wrong.split(' ') {
            let error = fails(&line.split(' ').chain([wrong]).collect::<Vec<_>>());
            let one = wrong.rsplit(',').next().unwrap();
            let found = format!("'{one}' for '{option}': expected a whole number {range} (try --help)");
            assert!(error.contains(&found), "{line} {wrong}: {error}");
        }
    }
    for (line, found) in [
        ("score m c.bvh --from 99999999999999999999", "expected a smaller number (try --help)"),
        (
            "rollout m --out o --frames 9 --from -1",
            "expected a training sequence, a whole number from 0, or CLIP",
        ),
        ("clip c.bvh --fps many", "'many' for '--fps <F>': expected a number (try --help)"),
        // No option: it is still taken for one.
        ("clip -1", "unexpected argument '-1'"),
    ] {
        let error = fails(&line.split(' ').collect::<Vec<_>>());
        assert!(error.contains(found), "{line}: {error}");
    }
}

#[test]
fn suggests_a_similar_name_for_a_wrong_one() {
    for (line, hint) in [
        (
            "train --outt x",
            "unexpected argument '--outt' found; a similar argument exists: '--out' (try --help)",
        ),
        ("trian c.bvh", "unrecognized subcommand 'trian'; a similar subcommand exists: 'train' (try --help)"),
    ] {
        let error = fails(&line.split(' ').collect::<Vec<_>>());
        assert!(error.contains(hint), "{line}: {error}");
    }
}

/// Once the message named the clip's file.
#[test]
fn names_the_option_of_an_impossible_frame_rate() {
    for (line, expected) in [
        ("clip sample:walk-1", "frames a second from 0.1 to 10000"),
        ("train sample:walk-1 --parts whole --out m", "frames a second from 0.1 to 10000"),
        ("train --movement a=sample:walk-1 --parts lower,upper --out m", "frames a second from 0.1 to 10000"),
        ("train no-such-table.csv --columns --parts whole --out m", "rows a second from 0.1 to 100000"),
        (
            "evaluate sample:walk-1 sample:walk-2 --parts whole --whole-cycles --out r",
            "frames a second from 0.1 to 10000",
        ),
    ] {
        for rate in ["0", "-1", "NaN", "inf", "100001"] {
            let error = fails(&line.split(' ').chain(["--fps", rate]).collect::<Vec<_>>());
            assert_eq!(error, format!("vcgpdm: --fps: expected {expected}, found {rate}\n"), "{line}");
        }
    }
}

#[test]
fn bound_prints_the_numbers_of_a_golden_case() {
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/case-1.json");
    let printed = json(&["bound", case, "--repeat", "3"]);
    let golden: Value = serde_json::from_str(&fs::read_to_string(case).unwrap()).unwrap();
    let expected = golden["expected"].as_object().unwrap();
    for (key, value) in expected {
        assert!(!printed[key].is_null(), "{key} is missing");
        assert_eq!(printed[key].as_array().map(Vec::len), value.as_array().map(Vec::len), "{key}");
    }
    let (elbo, wanted) = (printed["elbo"].as_f64().unwrap(), expected["elbo"].as_f64().unwrap());
    assert!((elbo / wanted - 1.0).abs() < 1e-9, "{elbo} is not {wanted}");
    assert!(printed["median_ms"].as_f64().unwrap() > 0.0);
    assert!(json(&["bound", case])["median_ms"].is_null());
}

#[test]
fn names_the_file_and_field_of_a_wrong_case() {
    let folder = folder("bad-cases");
    let case = folder.join("case.json");
    fs::write(&case, r#"{"input": {"params": {"parts": 3}}}"#).unwrap();
    let error = fails(&["bound", text(&case)]);
    assert!(error.contains("case.json: ") && error.contains("input.params.parts"), "{error}");
    // The place of the root was once a dot.
    fs::write(&case, "{}").unwrap();
    let error = fails(&["bound", text(&case)]);
    assert!(error.contains("case.json: at the top of the document: missing field `input`"), "{error}");
    fs::write(&case, b"\xff\xfe").unwrap();
    assert!(fails(&["bound", text(&case)]).contains("case.json: "));
    assert!(fails(&["bound", "no-such-case.json"]).contains("no-such-case.json: "));
}

/// Trains a small model for a few iterations.
fn train(folder: &Path, more: &[&str]) -> (PathBuf, Value) {
    let model = folder.join("model.json");
    let mut arguments = vec!["train", "sample:walk-1", "sample:walk-2", "--out", text(&model), "--parts"];
    arguments.extend([
        "lower,upper",
        "--dynamics-ips",
        "5",
        "--pose-ips",
        "6",
        "--latent",
        "2",
        "--seed",
        "3",
    ]);
    arguments.extend(["--fps", "15", "--max-iterations", "40", "--seed-frames", "sample:walk-3:5"]);
    arguments.extend(more);
    let printed = json(&arguments);
    (model, printed)
}

#[test]
fn trains_the_same_model_with_several_threads() {
    let folder = folder("threads");
    let (model, _) = train(&folder, &[]);
    let alone = fs::read(&model).unwrap();
    for threads in ["1", "2", "5"] {
        let (model, _) = train(&folder, &["--threads", threads]);
        assert!(fs::read(model).unwrap() == alone, "{threads} threads");
    }
    let model = folder.join("tmp.json");
    let alone = ["train", "sample:walk-1", "--model", "tmp", "--threads", "2", "--out", text(&model)];
    assert!(fails(&alone).contains("--threads: expected a model that has it (vcgpdm, vgpdm), found tmp"));
}

#[test]
fn trains_rolls_out_and_scores() {
    let folder = folder("train");
    let (start, motion, latents) =
        (folder.join("start.json"), folder.join("motion.bvh"), folder.join("latents.csv"));
    let (model, printed) = train(&folder, &["--write-start", text(&start)]);
    assert_eq!(printed["alpha"].as_array().unwrap().len(), 2);
    assert_eq!(printed["iterations"].as_u64(), Some(40));
    assert!(printed["evaluations"].as_u64().unwrap() >= 40 && printed["seconds"].as_f64().unwrap() > 0.0);
    let elbo = printed["elbo"].as_f64().unwrap();
    let sum = |value: &Value| value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).sum::<f64>();
    let terms = &printed["terms"];
    let total = sum(&terms["kinematics"])
        + sum(&terms["dynamics"])
        + terms["initial"].as_f64().unwrap()
        + terms["entropy"].as_f64().unwrap();
    assert!((elbo / total - 1.0).abs() < 1e-9);

    // The starting point is a case of its own, with a bound below the trained one.
    let input: Value = serde_json::from_str(&fs::read_to_string(&start).unwrap()).unwrap();
    assert_eq!(input["input"]["lengths"].as_array().unwrap().len(), 3);
    assert_eq!(input["input"]["lengths"][2].as_u64(), Some(5));
    assert!(json(&["bound", text(&start)])["elbo"].as_f64().unwrap() < elbo);

    let (model, motion, latents) = (text(&model), text(&motion), text(&latents));
    let roll = |more: &[&str]| {
        let mut arguments = vec!["rollout", model, "--frames", "50", "--out", motion, "--latents", latents];
        arguments.extend(more);
        let summary = json(&arguments);
        let visited = summary["health"]["parts"][1]["visited"].as_f64();
        assert!(visited.is_some_and(|share| (0.0..=1.0).contains(&share)), "{summary}");
        assert!(summary["measures"]["walking_speed"].is_number(), "{summary}");
        fs::read_to_string(latents).unwrap()
    };
    let learned = roll(&[]);
    assert_eq!(learned.lines().next(), Some("frame,time,lower_0,lower_1,upper_0,upper_1"));
    assert_eq!(learned.lines().count(), 51);
    assert!(
        learned.lines().skip(1).flat_map(|row| row.split(',')).all(|v| v.parse::<f64>().unwrap().is_finite())
    );
    let info = json(&["clip", motion]);
    assert_eq!((info["frames"].as_u64(), info["joints"].as_array().map(Vec::len)), (Some(50), Some(21)));
    assert_eq!(info["warnings"].as_array().map(Vec::len), Some(0));
    // Another coupling into the upper body changes the upper body and, hardly coupled back, the start of
    // neither.
    let changed = roll(&["--alpha", "lower:upper=0.001", "1:0=10"]);
    assert_ne!(learned, changed);
    assert_eq!(learned.lines().take(3).collect::<Vec<_>>(), changed.lines().take(3).collect::<Vec<_>>());
    assert_ne!(learned, roll(&["--from", "1"]));

    let score = json(&["score", model, "sample:walk-3", "--from", "2"]);
    let number = |key: &str| score[key].as_f64().unwrap();
    assert!(number("dtw_mse") > 0.0 && number("dtw_mse") <= number("mse") && number("variance") > 1e-3);

    // A place that cannot be written to is found before anything is computed or written.
    let (nowhere, unwritten) = (folder.join("no-such-folder").join("file"), folder.join("unwritten"));
    let (nowhere, unwritten) = (text(&nowhere), text(&unwritten));
    for (out, latents) in [(nowhere, unwritten), (unwritten, nowhere)] {
        let error = fails(&["rollout", model, "--frames", "9", "--out", out, "--latents", latents]);
        assert!(error.contains("no-such-folder"), "{error}");
        assert!(!Path::new(unwritten).exists(), "one of two files is left behind");
    }

    for (arguments, found) in [
        (&["score", model, "sample:walk-3", "--from", "7"][..], "from 0 to 2, found 7"),
        (&["rollout", model, "--frames", "9", "--from", "3", "--out", motion], "found 3"),
        (&["rollout", model, "--frames", "0", "--out", motion], "0"),
        (&["rollout", model, "--frames", "9", "--alpha", "lower:tail=2", "--out", motion], "lower, upper"),
        (&["rollout", model, "--frames", "9", "--alpha", "lower:upper=0", "--out", motion], "positive"),
        (&["rollout", text(&start), "--frames", "9", "--out", motion], "start.json: "),
        (&["score", motion, "sample:walk-3"], "motion.bvh: "),
    ] {
        let error = fails(arguments);
        assert!(error.contains(found), "{arguments:?}: {error}");
    }
}

#[test]
fn trains_the_same_model_from_the_same_seed() {
    let (first, _) = train(&folder("seed-a"), &[]);
    let (second, _) = train(&folder("seed-b"), &[]);
    assert_eq!(fs::read(first).unwrap(), fs::read(second).unwrap());
}

#[test]
fn reads_parts_by_name_or_from_a_file() {
    let folder = folder("parts");
    let (parts, model) = (folder.join("parts.json"), folder.join("model.json"));
    let train = |parts: &str| {
        [
            "train",
            "sample:walk-1",
            "--parts",
            parts,
            "--out",
            text(&model),
            "--max-iterations",
            "2",
            "--fps",
            "10",
        ]
        .map(str::to_owned)
        .to_vec()
    };
    let ask = |parts: &str| {
        let arguments = train(parts);
        json(&arguments.iter().map(String::as_str).collect::<Vec<_>>())["alpha"].as_array().unwrap().len()
    };
    let refuse = |parts: &str| {
        let arguments = train(parts);
        fails(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
    };
    let names: Vec<String> = (0..21).map(|joint| joint.to_string()).collect();
    let list = format!(
        r#"[{{"name": "a", "joints": [{}]}}, {{"name": "b", "joints": ["RightHand"]}}]"#,
        names[..20].join(",")
    );
    fs::write(&parts, &list).unwrap();
    assert_eq!(
        [ask("whole"), ask("upper,lower"), ask("legs,trunk,left arm,right arm"), ask(text(&parts))],
        [1, 2, 4, 2]
    );
    fs::write(&parts, list.replace("RightHand", "LeftWing")).unwrap();
    let error = refuse(text(&parts));
    assert!(error.contains("parts.json: ") && error.contains("LeftWing"), "{error}");
    assert!(refuse("head,tail").contains("lower,upper"));
    assert!(refuse("lower,lower").contains("lower,upper"));
}

#[test]
fn names_the_reason_why_a_training_cannot_begin() {
    let folder = folder("bad-training");
    let model = folder.join("model.json");
    let other = folder.join("other.bvh");
    fs::write(&other, "HIERARCHY\nROOT Stick\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 4\nFrame Time: 0.1\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n").unwrap();
    let refuse = |more: &[&str]| {
        let mut arguments = vec!["train", "sample:walk-1", "--parts", "whole", "--out", text(&model)];
        arguments.extend(more);
        fails(&arguments)
    };
    assert!(refuse(&[text(&other)]).contains("other.bvh"));
    assert!(refuse(&["--order", "100", "--fps", "20"]).contains("order 100 need"));
    let short = one_frame(&folder);
    let told = "vcgpdm: the clip short.bvh has 1 frame; dynamics of order 2 need at least 3";
    assert!(refuse(&[text(&short)]).contains(told), "the clip's name says more than its number");
    let told = "vcgpdm: the clip short.bvh has 1 frame; expected at least 4";
    assert!(refuse(&[text(&short), "--model", "tmp"]).contains(told));
    let told =
        "vcgpdm: the clip walk-2 (made by this project).bvh has 1 frame; dynamics of order 2 need at least 3";
    assert!(refuse(&["--seed-frames", "sample:walk-2:1"]).contains(told));
    assert!(refuse(&["--seed-frames", "sample:walk-2"]).contains("CLIP:COUNT"));
    assert!(refuse(&["--seed-frames", "sample:walk-2:9999"]).contains("9999"));
    // Found before the training, which here could not begin either.
    assert!(refuse(&["--write-start", text(&folder), text(&short)]).contains("bad-training"));
    assert!(
        fails(&["train", "sample:walk-1", "--parts", "whole", "--out", text(&folder)])
            .contains("bad-training")
    );
    assert!(!model.exists(), "nothing is left behind");
}

#[test]
fn warns_of_a_clip_that_is_given_twice() {
    let model = folder("twice").join("model.json");
    let sources = ["sample:walk-1", "sample:walk-1"];
    let name = "walk-1 (made by this project).bvh";
    let warning = format!("the clip {name} is given twice, so its frames count twice");
    let plain = ["train", sources[0], sources[1]];
    let library = ["train", "--movement", "a=sample:walk-1", "--movement", "b=sample:walk-1"];
    for arguments in [&plain[..], &library] {
        let options =
            ["--parts", "lower,upper", "--fps", "10", "--max-iterations", "1", "--out", text(&model)];
        let (summary, stderr) = json_and_stderr(&[arguments, &options].concat());
        assert_eq!(summary["warnings"], serde_json::json!([warning]));
        assert_eq!(stderr.lines().next(), Some(&*format!("vcgpdm: {warning}")));
    }
}

#[test]
fn trains_on_clips_of_other_bones_with_the_bones_of_the_first() {
    let folder = folder("bones");
    let taller = taller_walk(&folder);
    let model = folder.join("model.json");
    let mut arguments = vec!["train", "sample:walk-1", text(&taller), "--parts", "whole", "--fps", "15"];
    arguments.extend(["--max-iterations", "5", "--out", text(&model)]);
    let refused = fails(&arguments);
    assert!(refused.contains("its offset differs") && refused.contains("--first-bones"), "{refused}");
    arguments.push("--first-bones");
    let (summary, stderr) = json_and_stderr(&arguments);
    for warnings in [summary["warnings"].to_string(), stderr] {
        assert!(warnings.contains("the way of the root is scaled by 0.9"), "{warnings}");
    }
    assert!(model.exists());
}

#[test]
fn keeps_some_frames_of_a_clip_and_transfers_it_to_another_body() {
    let folder = folder("onto");
    let (taller, out) = (taller_walk(&folder), folder.join("out.bvh"));
    let clip = ["clip", "sample:walk-1", "--out", text(&out)];
    let cut = json(&[&clip[..], &["--frames", "10-40"]].concat());
    assert_eq!(cut["frames"], 30);
    let moved = json(&[&clip[..], &["--onto", text(&taller)]].concat());
    let body = json(&["clip", text(&taller)]);
    assert_eq!(json(&["clip", text(&out)])["joints"], body["joints"]);
    assert!(moved["warnings"].to_string().contains("the way of the root is scaled by 1.1"), "{moved}");
    for (frames, words) in [("40-10", "found 40 to 10"), ("10", "expected two frames FROM-TO")] {
        assert!(fails(&["clip", "sample:walk-1", "--frames", frames]).contains(words));
    }
    let itself = fails(&["clip", "sample:walk-1", "--onto", text(&taller), "--out", text(&taller)]);
    assert!(itself.contains("expected another file to write to"), "{itself}");
}

#[test]
#[ignore = "seldom: npm test -- --all"]
fn runs_the_commands_of_the_document() {
    let document = include_str!("../../../../docs/terminal.md").replace("\\\n", "");
    let folder = folder("document");
    let commands: Vec<&str> = document.lines().filter(|line| line.starts_with("vcgpdm ")).collect();
    assert!(commands.len() >= 15, "the commands of docs/terminal.md: {commands:?}");
    for trial in ["trial-1.csv", "trial-2.csv"] {
        let row = |k: i32| format!("{},{},{}\n", f64::from(k).sin(), k % 7, f64::from(k).cos());
        let table = "shoulder,elbow,hip_left\n".to_owned() + &(0..20).map(row).collect::<String>();
        fs::write(folder.join(trial), table).unwrap();
    }
    for command in commands {
        // No quoted word has a space.
        let output = Command::new(env!("CARGO_BIN_EXE_vcgpdm"))
            .args(command.split_whitespace().skip(1).map(|word| word.trim_matches('"')))
            .current_dir(&folder)
            .output()
            .unwrap();
        assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
    }
    for file in ["walk-1.bvh", "model.json", "new-walk.bvh", "latents.csv", "other-arms.bvh", "tmp.bvh"] {
        assert!(folder.join(file).exists(), "{file}");
    }
}
