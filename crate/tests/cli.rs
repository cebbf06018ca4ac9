//! The terminal program as a user meets it: what it prints, what it writes, how it fails.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_vcgpdm")).args(arguments).output().unwrap()
}

/// Runs a command that must succeed and reads the one JSON object that it prints.
fn json(arguments: &[&str]) -> Value {
    let output = run(arguments);
    let (out, err) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert!(output.status.success(), "{arguments:?}: {err}");
    assert_eq!(err, "", "{arguments:?}: nothing but results without a terminal");
    assert_eq!(out.lines().count(), 1, "{arguments:?}: one JSON object");
    serde_json::from_str(&out).unwrap()
}

/// Runs a command that must fail with status 1, one line on stderr and nothing on stdout.
fn fails(arguments: &[&str]) -> String {
    let output = run(arguments);
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{arguments:?}: {err}");
    assert_eq!(err.matches('\n').count(), 1, "{arguments:?}: one line, found {err:?}");
    assert!(err.ends_with('\n') && !err.contains("panicked"), "{err}");
    assert_eq!(output.stdout, b"", "{arguments:?}");
    err
}

/// A folder of its own for each test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

#[test]
fn help_and_version_are_no_errors() {
    for arguments in [&["--help"][..], &["--version"], &["clip", "--help"], &["bound", "--help"]] {
        let output = run(arguments);
        assert!(output.status.success() && !output.stdout.is_empty() && output.stderr.is_empty());
    }
}

#[test]
fn a_wrong_command_line_gets_one_line() {
    assert!(fails(&[]).contains("expected one of the commands"));
    assert!(fails(&["dance"]).contains("'dance'"));
    assert!(fails(&["clip"]).contains("CLIP"));
    assert!(fails(&["clip", "sample:walk-1", "--fps", "many"]).contains("'many'"));
    assert!(fails(&["clip", "sample:walk-1", "--speed", "3"]).contains("--speed"));
    assert!(fails(&["bound", "case.json", "--repeat", "0"]).contains("--repeat"));
}

#[test]
fn clip_tells_what_a_clip_holds() {
    let info = json(&["clip", "sample:walk-1"]);
    assert_eq!(info["name"], "walk-1 (made by this project).bvh");
    assert_eq!((info["up_axis"].as_str(), info["frames"].as_u64()), (Some("y"), Some(252)));
    assert_eq!(info["frame_time"].as_f64(), Some(1.0 / 60.0));
    let height = info["height"].as_f64().unwrap();
    assert!((height - 172.0).abs() < 6.0, "{height}");
    assert_eq!(info["warnings"].as_array().map(Vec::len), Some(0));
    let joints = info["joints"].as_array().unwrap();
    assert_eq!(joints.len(), 21);
    assert_eq!((&joints[0]["name"], &joints[0]["parent"]), (&"Hips".into(), &Value::Null));
    assert_eq!(joints[0]["channels"].as_array().map(Vec::len), Some(6));
    assert_eq!((&joints[2]["name"], &joints[2]["parent"]), (&"LeftLeg".into(), &1.into()));
}

#[test]
fn a_clip_is_written_back_and_resampled() {
    let folder = folder("clip");
    let (same, slower) = (folder.join("same.bvh"), folder.join("slower.bvh"));
    let made = json(&["clip", "sample:walk-wave-2", "--out", text(&same)]);
    let read = json(&["clip", text(&same), "--fps", "30", "--out", text(&slower)]);
    for key in ["joints", "height", "sha256"] {
        assert_eq!(made[key], read[key], "{key}");
    }
    assert_eq!(read["name"], "same.bvh");
    let again = json(&["clip", text(&slower)]);
    assert_eq!(made["frames"].as_u64().unwrap().div_ceil(2), again["frames"].as_u64().unwrap());
    assert_eq!(again["frame_time"].as_f64(), Some(1.0 / 30.0));
}

#[test]
fn clips_that_cannot_be_read_or_written_say_why_and_where() {
    let folder = folder("bad-clips");
    let broken = folder.join("broken.bvh");
    fs::write(&broken, "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 zero 0\n}\n").unwrap();
    let error = fails(&["clip", text(&broken)]);
    assert!(error.contains("broken.bvh, line 4: ") && error.contains("zero"), "{error}");
    assert!(fails(&["clip", "no-such-file.bvh"]).contains("no-such-file.bvh: "));
    assert!(fails(&["clip", text(&folder)]).contains("bad-clips: "));
    assert!(fails(&["clip", "sample:run-1"]).contains("walk-wave-1"));
    assert!(fails(&["clip", "sample:walk-1", "--fps", "-3"]).contains("-3"));
    let nowhere = folder.join("no-such-folder").join("out.bvh");
    assert!(fails(&["clip", "sample:walk-1", "--out", text(&nowhere)]).contains("no-such-folder"));
}
