//! Tests of `vcgpdm clip`, and of files that are read and written.

use crate::call::{fails, folder, json, json_and_stderr, prints, text, under_a_still_root};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
fn prints_the_contents_of_a_clip() {
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
fn prints_the_parts_of_each_preset() {
    let info = json(&["clip", "sample:walk-1"]);
    let presets = info["presets"].as_array().unwrap();
    let ids: Vec<&str> = presets.iter().map(|preset| preset["id"].as_str().unwrap()).collect();
    assert_eq!(ids, ["whole", "lower-upper", "body-arms", "legs-trunk-arms"]);
    let lower = &presets[1]["parts"][0];
    assert_eq!((&lower["name"], &lower["joints"][1]), (&"lower".into(), &"LeftUpLeg".into()));
    for preset in presets {
        let parts = preset["parts"].as_array().unwrap();
        assert_eq!(parts.iter().map(|part| part["joints"].as_array().unwrap().len()).sum::<usize>(), 21);
    }
}

#[test]
fn the_user_can_state_the_axis_that_points_up() {
    for (axis, height) in [("z", 172.0), ("-x", 172.0), ("y", 172.0)] {
        let info = json(&["clip", "sample:walk-1", "--up", axis]);
        assert_eq!(info["up_axis"], axis);
        assert!((info["height"].as_f64().unwrap() - height).abs() < 6.0);
    }
    let err = fails(&["clip", "sample:walk-1", "--up", "w"]);
    assert!(err.contains("expected x, y, z, -x, -y or -z"), "{err}");
}

/// The way over the ground of the root of a BVH file, in file units a second.
fn speed(path: &Path) -> f64 {
    let text = fs::read_to_string(path).unwrap();
    let (_, motion) = text.split_once("Frame Time: ").unwrap();
    let (time, rows) = motion.split_once('\n').unwrap();
    let places: Vec<[f64; 2]> = rows
        .lines()
        .map(|row| {
            let numbers: Vec<f64> =
                row.split_whitespace().take(3).map(|word| word.parse().unwrap()).collect();
            [numbers[0], numbers[2]]
        })
        .collect();
    let (first, last) = (places[0], places[places.len() - 1]);
    let way = (last[0] - first[0]).hypot(last[1] - first[1]);
    way / (time.parse::<f64>().unwrap() * (places.len() - 1) as f64)
}

/// Once the walk marched on the spot.
#[test]
fn hips_below_a_still_root_travel_at_their_own_speed_after_training() {
    let folder = folder("still-root");
    let [walk, own, model, out] =
        ["walk.bvh", "own.bvh", "model.json", "out.bvh"].map(|name| folder.join(name));
    under_a_still_root("sample:walk-1", 0.0, &walk);
    let info = json(&["clip", text(&walk), "--out", text(&own)]);
    assert_eq!(info["joints"].as_array().map(Vec::len), Some(21));
    assert_eq!(
        info["warnings"][1],
        "the root \"rig:Reference\" only carries \"rig:Hips\", which moves: \"rig:Hips\" is the root now"
    );
    let train =
        ["train", text(&walk), "--parts", "lower,upper", "--max-iterations", "40", "--out", text(&model)];
    let (summary, _) = json_and_stderr(&train);
    assert!(summary["warnings"].as_array().unwrap().iter().any(|warning| {
        warning.as_str().unwrap().starts_with("walk.bvh: the root \"rig:Reference\" only carries")
    }));
    let roll = ["rollout", text(&model), "--frames", "120", "--plain-names", "--out", text(&out)];
    json_and_stderr(&roll);
    let share = speed(&out) / speed(&own);
    assert!((0.85..1.1).contains(&share), "{share} of the clip's speed");
    let written = fs::read_to_string(&out).unwrap();
    assert!(written.contains("ROOT Hips\n") && !written.contains("rig:"));
}

#[test]
fn writes_a_clip_back_and_resamples_it() {
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

/// Once the old file was lost when the disk was full.
#[cfg(unix)]
#[test]
fn keeps_the_old_file_if_the_disk_is_full() {
    let folder = folder("no-room");
    for file in fs::read_dir(&folder).unwrap() {
        fs::remove_file(file.unwrap().path()).unwrap();
    }
    let out = folder.join("walk.bvh");
    fs::write(&out, "what was there").unwrap();
    // The shell lets no file grow beyond a kilobyte, as a full disk would.
    let script = "trap '' XFSZ; ulimit -f 1; exec \"$0\" clip sample:walk-1 --out \"$1\"";
    let output =
        Command::new("sh").args(["-c", script, env!("CARGO_BIN_EXE_vcgpdm"), text(&out)]).output().unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{err}");
    assert!(err.contains("walk.bvh: "), "{err}");
    assert_eq!(fs::read_to_string(&out).unwrap(), "what was there");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "no partial file stays");
}

#[cfg(unix)]
#[test]
fn writes_the_target_of_a_link() {
    let folder = folder("linked");
    let (file, link) = (folder.join("file.bvh"), folder.join("link.bvh"));
    fs::write(&file, "").unwrap();
    let _ = fs::remove_file(&link);
    std::os::unix::fs::symlink("file.bvh", &link).unwrap();
    json(&["clip", "sample:walk-1", "--out", text(&link)]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::read_to_string(&file).unwrap().starts_with("HIERARCHY"));
}

/// Once the link was replaced by the file.
#[cfg(unix)]
#[test]
fn writes_the_target_of_a_link_that_does_not_exist_yet() {
    let folder = folder("dangling");
    let link = folder.join("link.bvh");
    std::os::unix::fs::symlink("target.bvh", &link).unwrap();
    json(&["clip", "sample:walk-1", "--out", text(&link)]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::read_to_string(folder.join("target.bvh")).unwrap().starts_with("HIERARCHY"));
    let circle = folder.join("circle.bvh");
    std::os::unix::fs::symlink("circle.bvh", &circle).unwrap();
    let error = fails(&["clip", "sample:walk-1", "--out", text(&circle)]);
    assert!(error.contains("circle.bvh: expected at most 40 links to follow, found more"), "{error}");
}

/// Once such a clip was refused, without its name.
#[cfg(unix)]
#[test]
fn reads_clips_whose_names_are_not_utf_8() {
    use std::os::unix::ffi::OsStrExt;
    let folder = folder("names");
    let name = |bytes: &[u8]| folder.join(std::ffi::OsStr::from_bytes(bytes));
    let clip = name(b"na\xffme.bvh");
    let walk = folder.join("walk.bvh");
    json(&["clip", "sample:walk-1", "--out", text(&walk)]);
    fs::rename(&walk, &clip).unwrap();
    let run = |arguments: &[&std::ffi::OsStr]| {
        let output = Command::new(env!("CARGO_BIN_EXE_vcgpdm")).args(arguments).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    assert_eq!(run(&["clip".as_ref(), clip.as_ref()])["name"], "na\u{fffd}me.bvh");
    let out = folder.join("model.json");
    let train = |more: &[&std::ffi::OsStr]| {
        let fixed = ["train", "--parts", "lower,upper", "--fps", "10", "--max-iterations", "1", "--out"];
        let fixed = fixed.iter().map(std::ffi::OsStr::new).chain([out.as_os_str()]);
        run(&fixed.chain(more.iter().copied()).collect::<Vec<_>>())
    };
    train(&[clip.as_ref()]);
    train(&["sample:walk-2".as_ref(), "--seed-frames".as_ref(), name(b"na\xffme.bvh:5").as_ref()]);
    let movement = [b"walk=", clip.as_os_str().as_bytes(), b",sample:walk-2"].concat();
    train(&["--movement".as_ref(), std::ffi::OsStr::from_bytes(&movement)]);
}

#[test]
fn keeps_control_characters_of_names_from_the_terminal() {
    let clip = folder("controls").join("walk.bvh");
    json(&["clip", "sample:walk-1", "--out", text(&clip)]);
    let changed = fs::read_to_string(&clip).unwrap().replace("Hips", "Hips\u{202e}\u{9b}2J");
    fs::write(&clip, changed).unwrap();
    let printed = prints(&["clip", text(&clip)]);
    assert!(printed.contains("Hips\\u202e\\u009b2J"), "{}", printed.escape_unicode());
    assert!(!printed.contains(['\u{202e}', '\u{9b}']));
}

#[test]
fn refuses_to_overwrite_an_input_file() {
    let clip = folder("read-and-written").join("walk.bvh");
    json(&["clip", "sample:walk-1", "--out", text(&clip)]);
    let before = fs::read(&clip).unwrap();
    let same = clip.parent().unwrap().join("..").join("read-and-written").join("walk.bvh");
    for arguments in [
        vec!["clip", text(&clip), "--fps", "30", "--out", text(&same)],
        vec!["train", text(&clip), "--parts", "whole", "--out", text(&same)],
        vec![
            "train",
            "sample:walk-2",
            "--seed-frames",
            &format!("{}:5", text(&clip)),
            "--parts",
            "whole",
            "--out",
            text(&same),
        ],
    ] {
        assert!(fails(&arguments).contains("expected another file to write to"), "{arguments:?}");
    }
    assert_eq!(fs::read(&clip).unwrap(), before);
}

/// Once the second output silently overwrote the first.
#[test]
fn refuses_two_outputs_in_one_file() {
    let folder = folder("outputs");
    let (out, other) = (folder.join("out.json"), folder.join("out-2.json"));
    let same = folder.join("..").join("outputs").join("out.json");
    json(&["train", "sample:walk-1", "--parts", "whole", "--max-iterations", "1", "--out", text(&other)]);
    let model = folder.join("model.json");
    fs::rename(&other, &model).unwrap();
    let (out, other, same) = (text(&out), text(&other), text(&same));
    let rollout = ["rollout", text(&model), "--frames", "9", "--out", out];
    for (option, place, arguments) in [
        (
            "--write-start",
            same,
            &["train", "sample:walk-1", "--parts", "whole", "--out", out, "--write-start", same][..],
        ),
        ("--latents", same, &[&rollout[..], &["--latents", same]].concat()),
        ("--columns", same, &[&rollout[..], &["--columns", same]].concat()),
        ("--variance", same, &[&rollout[..], &["--variance", same]].concat()),
        (
            "--variance",
            other,
            &[&rollout[..], &["--variance", other, "--samples", "2", "--seed", "1"]].concat(),
        ),
    ] {
        let begin = format!("vcgpdm: {option} {place}: expected a file of its own, found that of --out: ");
        assert!(fails(arguments).starts_with(&begin), "{arguments:?}");
    }
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "nothing is written");
    // Outputs can share the null device.
    #[cfg(unix)]
    json(&[
        "train",
        "sample:walk-1",
        "--parts",
        "whole",
        "--max-iterations",
        "1",
        "--out",
        "/dev/null",
        "--write-start",
        "/dev/null",
    ]);
}

#[test]
fn names_the_file_and_reason_of_clips_that_cannot_be_read_or_written() {
    let folder = folder("bad-clips");
    let broken = folder.join("broken.bvh");
    fs::write(&broken, "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 zero 0\n}\n").unwrap();
    let error = fails(&["clip", text(&broken)]);
    assert!(error.contains("broken.bvh, line 4: ") && error.contains("zero"), "{error}");
    assert!(fails(&["clip", "no-such-file.bvh"]).contains("no-such-file.bvh: "));
    assert!(fails(&["clip", text(&folder)]).contains("bad-clips: "));
    assert!(fails(&["clip", "sample:run-1"]).contains("walk-wave-1"));
    assert!(fails(&["clip", "sample:walk-1", "--fps", "-3"]).contains("--fps: expected frames a second"));
    let nowhere = folder.join("no-such-folder").join("out.bvh");
    assert!(fails(&["clip", "sample:walk-1", "--out", text(&nowhere)]).contains("no-such-folder"));
}

#[test]
fn recognises_other_formats_and_says_how_to_convert_them() {
    let folder = folder("foreign");
    let found = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        fs::write(&path, bytes).unwrap();
        fails(&["clip", text(&path)])
    };
    let c3d: Vec<u8> = [2, 0x50].into_iter().chain([0; 600]).collect();
    for (name, bytes, expected) in [
        (
            "walk.fbx",
            &b"Kaydara FBX Binary  \0\x1a\0"[..],
            "walk.fbx, line 1: expected a BVH file, found an FBX file",
        ),
        ("text.fbx", b"; FBX 7.4.0 project file\n", "found an FBX file (Blender turns it into BVH"),
        ("walk.glb", b"glTF\x02\0\0\0", "to_bvh.py -- IN.glb OUT.bvh"),
        ("walk.c3d", &c3d, "found a C3D file, which holds markers"),
        ("walk.npz", b"PK\x03\x04\x14\0", "such as AMASS's npz"),
        (
            "walk.amc",
            b"#!OML:ASF F:\\x.ASF\n:FULLY-SPECIFIED\n:DEGREES\n1\n",
            "vcgpdm clip BODY.asf MOTION.amc",
        ),
        ("body.asf", b"# AST/ASF file\n:version 1.10\n:name VICON\n:units\n", "found an ASF skeleton"),
    ] {
        let found = found(name, bytes);
        assert!(found.contains(expected), "{name}: {found}");
    }
}

#[test]
fn reads_an_acclaim_skeleton_and_motion() {
    let folder = folder("acclaim");
    let (asf, amc, out) = (folder.join("body.asf"), folder.join("walk.amc"), folder.join("walk.bvh"));
    let bones = "begin\nid 1\nname lfemur\ndirection 0 -1 0\nlength 7\naxis 0 0 20 XYZ\ndof rx ry rz\nend\n";
    let hierarchy = ":hierarchy\nbegin\nroot lfemur\nend\n";
    let root = ":root\norder TX TY TZ RX RY RZ\naxis XYZ\nposition 0 0 0\norientation 0 0 0\n";
    fs::write(&asf, format!(":version 1.10\n{root}:bonedata\n{bones}{hierarchy}")).unwrap();
    fs::write(&amc, ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 1 8 3 0 90 0\nlfemur 10 0 0\n2\nroot 1 8 4 0 91 0\nlfemur 11 0 0\n")
        .unwrap();
    let about = json(&["clip", text(&asf), text(&amc), "--out", text(&out)]);
    assert_eq!((about["name"].as_str(), about["frames"].as_u64()), (Some("walk.amc"), Some(2)));
    assert_eq!(about["frame_time"].as_f64(), Some(1.0 / 120.0));
    assert_eq!(about["joints"][1]["name"], "LeftUpLeg");
    assert_eq!(json(&["clip", text(&out)])["joints"], about["joints"]);
    let half = json(&["clip", text(&asf), text(&amc), "--clip-fps", "60"]);
    assert_eq!(half["frame_time"].as_f64(), Some(1.0 / 60.0));
    fs::write(&amc, "1\nroot 1 8 3 0 90 0\nlfemur 10 0\n").unwrap();
    assert!(
        fails(&["clip", text(&asf), text(&amc)]).contains("walk.amc, line 3: expected 3 numbers of lfemur")
    );
}
