//! Tests of pipes, signals of schedulers, completions of shells and pages of `man`.

use crate::call::{fails, folder, prints, run, run_with, text};
use serde_json::Value;
use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

#[test]
fn reads_stdin_and_writes_stdout_for_a_file_called_minus() {
    let written = run(&["clip", "sample:walk-1", "--out", "-"]);
    assert!(written.stdout.starts_with(b"HIERARCHY"));
    let about: Value = serde_json::from_slice(&written.stderr).unwrap();
    assert_eq!(about["frames"].as_u64(), Some(252));

    let train = ["train", "-", "--model", "dmp-discrete", "--fps", "15", "--bases", "5", "--out", "-"];
    let model = run_with(&train, &written.stdout);
    assert!(serde_json::from_slice::<Value>(&model.stderr).unwrap()["seconds"].is_number());
    let document: Value = serde_json::from_slice(&model.stdout).unwrap();
    assert_eq!(document["format"], "vcgpdm model");
    assert!(document.to_string().contains("\"stdin\""), "the clip has a name");

    let rolled = run_with(&["rollout", "-", "--frames", "9", "--out", "-"], &model.stdout);
    assert!(String::from_utf8(rolled.stdout).unwrap().contains("Frames: 9"));
    assert!(rolled.status.success() && rolled.stderr.is_empty());

    let twice = run_with(&["train", "-", "-", "--parts", "whole", "--out", "-"], &written.stdout);
    assert_eq!(twice.status.code(), Some(2));
    let both = run_with(&["rollout", "-", "--frames", "9", "--out", "-", "--latents", "-"], &model.stdout);
    assert_eq!((both.status.code(), both.stdout.is_empty()), (Some(2), true));
}

/// A scheduler sends SIGTERM when the time of a job is over.
#[cfg(unix)]
#[test]
fn keeps_the_best_model_after_sigterm() {
    let folder = folder("sigterm");
    let (model, start) = (folder.join("model.json"), folder.join("start.json"));
    // A bound that does not settle for minutes: a small one had settled before the signal came.
    let child = Command::new(env!("CARGO_BIN_EXE_vcgpdm"))
        .args(["train", "sample:walk-1", "sample:walk-2", "sample:walk-3", "--parts", "lower,upper"])
        .args(["--dynamics-ips", "40", "--pose-ips", "40", "--max-iterations", "1000000"])
        .args(["--out", text(&model), "--write-start", text(&start)])
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    // It trains, and listens to signals, from shortly after that file is there.
    let begin = Instant::now();
    while !start.exists() && begin.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(10));
    }
    std::thread::sleep(Duration::from_millis(500));
    assert!(Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{:?}", output.status);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["reason"], "stopped");
    let kept: Value = serde_json::from_str(&fs::read_to_string(&model).unwrap()).unwrap();
    assert_eq!(kept["provenance"]["iterations"], found["iterations"]);
}

/// Every command that trains warns of a training that would take days.
#[test]
fn warns_of_a_long_training_before_it_begins() {
    let folder = folder("long");
    let walks = ["sample:walk-1", "sample:walk-2", "--parts", "lower,upper", "--max-iterations", "100000000"];
    let out = folder.join("out.json");
    for (command, models) in
        [("train", ["--model", "map-cgpdm"]), ("evaluate", ["--models", "vcgpdm,map-gpdm"])]
    {
        let mut child = Command::new(env!("CARGO_BIN_EXE_vcgpdm"))
            .arg(command)
            .args(walks)
            .args(models)
            .args(["--out", text(&out)])
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut found = String::new();
        BufReader::new(child.stderr.take().unwrap()).read_line(&mut found).unwrap();
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(found.contains(" hours on ") && found.contains(" need less"), "{command}: {found}");
    }
}

#[test]
fn prints_completions_and_pages_for_every_command() {
    let commands =
        ["bound", "clip", "train", "reproduce", "rollout", "score", "evaluate", "report", "results"];
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = prints(&["completions", shell]);
        assert!(commands.iter().all(|command| script.contains(command)), "{shell}");
        assert!(script.contains("max-iterations"), "{shell}");
    }
    assert!(commands.iter().all(|command| prints(&["man"]).contains(&format!("vcgpdm\\-{command}"))));
    for command in commands {
        let page = prints(&["man", command]);
        assert!(page.contains(".TH") && page.contains("SYNOPSIS"), "{command}: {page}");
    }
    assert!(fails(&["completions", "tcsh"]).contains("'tcsh'"));
    assert_eq!(run(&["man", "dance"]).status.code(), Some(2));
}
