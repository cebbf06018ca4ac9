//! Functions that call the program.

use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Runs a command to its end.
pub fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_vcgpdm")).args(arguments).output().unwrap()
}

/// Runs a command that reads this from stdin.
pub fn run_with(arguments: &[&str], stdin: &[u8]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_vcgpdm"));
    let piped = command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = piped.spawn().unwrap();
    // A program that refuses its command line reads nothing.
    let _ = child.stdin.take().unwrap().write_all(stdin);
    child.wait_with_output().unwrap()
}

/// Runs a command that must succeed and reads the one JSON object that it prints.
pub fn json(arguments: &[&str]) -> Value {
    let out = prints(arguments);
    assert_eq!(out.lines().count(), 1, "{arguments:?}: one JSON object");
    serde_json::from_str(&out).unwrap()
}

/// The same of a command that also writes to stderr: its JSON object and the lines on stderr.
pub fn json_and_stderr(arguments: &[&str]) -> (Value, String) {
    let output = run(arguments);
    let err = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {err}");
    (serde_json::from_slice(&output.stdout).unwrap(), err)
}

/// Runs a command that must succeed, and returns its stdout.
pub fn prints(arguments: &[&str]) -> String {
    let output = run(arguments);
    let err = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && err.is_empty(), "{arguments:?}: {err}");
    String::from_utf8(output.stdout).unwrap()
}

/// Runs a command that must fail, with one line on stderr and nothing on stdout. The status is 2 if the line
/// names an option or ends with (try --help), and otherwise 1.
pub fn fails(arguments: &[&str]) -> String {
    let output = run(arguments);
    let err = String::from_utf8(output.stderr).unwrap();
    let status = 1 + i32::from(err.starts_with("vcgpdm: -") || err.ends_with("(try --help)\n"));
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {err}");
    assert_eq!(err.matches('\n').count(), 1, "{arguments:?}: one line, found {err:?}");
    assert!(err.ends_with('\n') && !err.contains("panicked"), "{err}");
    assert_eq!(output.stdout, b"", "{arguments:?}");
    err
}

/// An empty folder for a test.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    // An older build may have left files.
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// A path as an argument.
pub fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// The second sample walk, with bones that are longer by a tenth.
pub fn taller_walk(folder: &Path) -> PathBuf {
    let taller = folder.join("taller.bvh");
    prints(&["clip", "sample:walk-2", "--out", text(&taller)]);
    let written = fs::read_to_string(&taller).unwrap();
    let longer = |line: &str| {
        let Some(offset) = line.trim_start().strip_prefix("OFFSET") else { return format!("{line}\n") };
        let numbers = offset.split_whitespace().map(|x| (1.1 * x.parse::<f64>().unwrap()).to_string());
        format!("OFFSET {}\n", numbers.collect::<Vec<_>>().join(" "))
    };
    fs::write(&taller, written.lines().map(longer).collect::<String>()).unwrap();
    taller
}

/// The first frame of the first sample walk.
pub fn one_frame(folder: &Path) -> PathBuf {
    let (short, walk) = (folder.join("short.bvh"), folder.join("walk.bvh"));
    prints(&["clip", "sample:walk-1", "--out", text(&walk)]);
    let walk = fs::read_to_string(&walk).unwrap().replacen("Frames: 252", "Frames: 1", 1);
    let header = walk.lines().position(|line| line.starts_with("Frame Time")).unwrap();
    fs::write(&short, walk.lines().take(header + 2).map(|line| format!("{line}\n")).collect::<String>())
        .unwrap();
    short
}

/// Writes a clip below another root, which stands still, as MotionBuilder and game engines do. All names have a
/// prefix. The root turns the motion by `turn` degrees about x: by 90, z points up.
pub fn under_a_still_root(clip: &str, turn: f64, out: &Path) {
    prints(&["clip", clip, "--out", text(out)]);
    let text = fs::read_to_string(out).unwrap();
    let (hierarchy, motion) = text.split_once("MOTION\n").unwrap();
    let body = hierarchy.trim_start_matches("HIERARCHY\n").replacen("ROOT ", "JOINT ", 1);
    let body = body.replace("JOINT ", "JOINT rig:");
    let (head, rows) = motion.split_at(motion.find("Frame Time").unwrap());
    let (time, rows) = rows.split_once('\n').unwrap();
    let rows: String = rows.lines().map(|row| format!("0 0 0 0 {turn} 0 {row}\n")).collect();
    let root = "ROOT rig:Reference\n{\n\tOFFSET 0 0 0\n\tCHANNELS 6 Xposition Yposition Zposition Zrotation \
                Xrotation Yrotation\n";
    fs::write(out, format!("HIERARCHY\n{root}{body}}}\nMOTION\n{head}{time}\n{rows}")).unwrap();
}
