//! Whether the motion of a trained model moves on, and the inducing points that depend on the length of clips.

use crate::call::{folder, json_and_stderr, text};
use serde_json::Value;
use std::fs;
use std::path::Path;
use vcgpdm_core::motion::{bvh, samples};

fn train(clip: &str, out: &Path, more: &[&str]) -> (Value, String) {
    let train = ["train", clip, "--parts", "lower,upper", "--fps", "15", "--out", text(out)];
    json_and_stderr(&[&train, more].concat())
}

#[test]
fn says_whether_the_motion_moves_on_and_what_may_help() {
    let folder = folder("moving");
    let model = folder.join("model.json");
    let (summary, stderr) = train("sample:walk-1", &model, &["--max-iterations", "60"]);
    assert_eq!((&summary["health"]["state"], &summary["advice"]), (&"moves-on".into(), &Value::Null));
    assert_eq!(stderr, "");
    // A few points cannot hold a walk.
    let few = ["--max-iterations", "1", "--dynamics-ips", "1", "--pose-ips", "1", "--latent", "1"];
    let (summary, stderr) = train("sample:walk-1", &model, &few);
    assert_ne!(summary["health"]["state"], "moves-on", "{summary}");
    let advice = summary["advice"].as_str().unwrap();
    assert!(advice.contains("--seed") && advice.contains("--dynamics-ips 12"), "{advice}");
    assert!(stderr.contains("warning: a motion of the model ") && stderr.contains(advice), "{stderr}");
}

#[test]
fn gives_long_clips_more_inducing_points() {
    let folder = folder("length");
    let (slow, model) = (folder.join("slow.bvh"), folder.join("model.json"));
    let mut clip = samples::clip("walk-1").unwrap();
    clip.frame_time *= 8.0 / (clip.frames() as f64 * clip.frame_time) + 0.01;
    fs::write(&slow, bvh::write(&clip)).unwrap();
    let points = |clip: &str, more: &[&str]| {
        let (summary, _) = train(clip, &model, &[&["--max-iterations", "1"], more].concat());
        (summary["dynamics_ips"].clone(), summary["pose_ips"].clone())
    };
    assert_eq!(points("sample:walk-1", &[]), (12.into(), 12.into()));
    assert_eq!(points(text(&slow), &[]), (30.into(), 30.into()));
    assert_eq!(points(text(&slow), &["--dynamics-ips", "9"]), (9.into(), 30.into()));
}
