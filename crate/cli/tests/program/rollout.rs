//! Tests of `vcgpdm rollout` with the first model of the page: cuts, pushes, samples and variances.

use crate::call::{folder, json_and_stderr, run, text};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Output;

const MODEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../www/first/model.json");

fn rollout(folder: &Path, more: &[&str]) -> Output {
    let out = folder.join("walk.bvh");
    let latents = folder.join("latents.csv");
    let whole = ["rollout", MODEL, "--frames", "90", "--out", text(&out), "--latents", text(&latents)];
    run(&[&whole, more].concat())
}

/// The latents of a rollout, one row for each frame, without the header.
fn latents(folder: &Path, more: &[&str]) -> Vec<String> {
    let output = rollout(folder, more);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    rows(&folder.join("latents.csv"))
}

fn rows(path: &Path) -> Vec<String> {
    fs::read_to_string(path).unwrap().lines().skip(1).map(str::to_owned).collect()
}

#[test]
fn starts_from_a_frame_of_a_training_sequence() {
    let folder = folder("frame");
    let model = folder.join("model.json");
    let settings =
        ["--parts", "lower,upper", "--max-iterations", "2", "--dynamics-ips", "4", "--pose-ips", "4"];
    let train = ["train", "sample:walk-1", "--out", text(&model)];
    let output = run(&[&train[..], &settings[..]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let start = |frame: &str| {
        let (out, latents) = (folder.join("walk.bvh"), folder.join("latents.csv"));
        let whole = ["rollout", text(&model), "--frames", "2", "--frame", frame, "--out", text(&out)];
        let output = run(&[&whole[..], &["--latents", text(&latents)]].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let latent = |row: &String| row.split(',').skip(2).map(str::to_owned).collect::<Vec<_>>();
        rows(&latents).iter().map(latent).collect::<Vec<_>>()
    };
    // Two frames are the start: the second of one is the first of the next.
    assert_eq!(start("40")[1], start("41")[0]);
    assert_ne!(start("40")[0], start("41")[0]);

    let error = rollout(&folder, &["--frame", "1"]);
    let words = String::from_utf8_lossy(&error.stderr).into_owned();
    assert!(words.contains("expected a frame of the sequence from 0 to 0 to start from, found 1"), "{words}");
}

#[test]
fn cuts_and_pushes_act_from_their_frame_on() {
    let folder = folder("disturbed");
    let learned = latents(&folder, &[]);
    for (option, from) in [("lower:upper@30-60", 30), ("0:1@45-50", 45)] {
        let cut = latents(&folder, &["--cut", option]);
        assert_eq!(cut[..from], learned[..from]);
        assert_ne!(cut[from], learned[from]);
    }
    for option in ["upper@40=0.5,0,0", "1@40=3f"] {
        let pushed = latents(&folder, &["--push", option]);
        assert_eq!(pushed[..40], learned[..40]);
        assert_ne!(pushed[40], learned[40]);
    }
    let coupling = ["--alpha", "lower:upper=5"];
    let as_learned = latents(&folder, &coupling);
    let re_inferred = latents(&folder, &[&coupling[..], &["--reading", "re-inferred"]].concat());
    assert_ne!(as_learned, re_inferred);
}

#[test]
fn samples_depend_on_the_seed_and_variances_grow_from_zero() {
    let folder = folder("uncertain");
    let variances = folder.join("variances.csv");
    let learned = latents(&folder, &[]);
    let options = ["--samples", "2", "--seed", "7", "--variance", variances.to_str().unwrap()];
    assert_eq!(latents(&folder, &options), learned, "the mean rollout stays what it was");
    let (one, two) = (rows(&folder.join("latents-1.csv")), rows(&folder.join("latents-2.csv")));
    assert_eq!((one.len(), two.len()), (90, 90));
    assert_ne!(one, two);
    assert!(folder.join("walk-2.bvh").exists());
    latents(&folder, &["--samples", "1", "--seed", "8"]);
    assert_eq!(rows(&folder.join("latents-1.csv")), two, "seeds count on");
    latents(&folder, &["--samples", "1"]);
    let without = rows(&folder.join("latents-1.csv"));
    latents(&folder, &["--samples", "1", "--seed", "0"]);
    assert_eq!(rows(&folder.join("latents-1.csv")), without, "the seed is 0 without the option");

    let table = rows(&variances);
    let variance = |frame: usize| -> f64 { table[frame].split(',').nth(3).unwrap().parse().unwrap() };
    assert_eq!((variance(0), variance(1)), (0.0, 0.0));
    assert!(variance(2) > 0.0 && variance(20) > variance(2));
    // The latents themselves, up to how a number is written.
    let mean: f64 = table[2].split(',').nth(2).unwrap().parse().unwrap();
    let rolled: f64 = learned[2].split(',').nth(2).unwrap().parse().unwrap();
    assert!((mean - rolled).abs() < 1e-6, "{mean} {rolled}");
}

#[test]
fn refuses_options_that_do_not_fit_the_model() {
    let folder = folder("refused");
    for (options, status, found) in [
        (&["--cut", "lower:tail@3-9"][..], 2, "expected two of the parts lower, upper"),
        (&["--cut", "lower:upper@3-9", "1:1@3-9"], 1, "nothing would say where it goes"),
        (&["--push", "upper@3=1,2"], 1, "expected a push of part 1 by 3 finite numbers"),
        (&["--push", "upper@90=3f"], 1, "from 2 on and before 90, found 90"),
        (&["--cut", "lower:upper@150-160"], 1, "from 2 on and before 90, found 150"),
        (&["--cut", "lower:upper@3-9", "--samples", "1", "--seed", "1"], 2, "cannot be used with"),
    ] {
        let output = rollout(&folder, options);
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(status), "{options:?}");
        assert!(error.contains(found) && error.matches('\n').count() == 1, "{options:?}: {error}");
    }
}

#[test]
fn starts_with_frames_of_a_clip_that_was_not_trained_on() {
    let folder = folder("from-clip");
    let (model, out, file) = (folder.join("model.json"), folder.join("out.bvh"), folder.join("latents.csv"));
    let train = "train sample:walk-1 --parts lower,upper --max-iterations 30 --out";
    assert!(run(&train.split(' ').chain([text(&model)]).collect::<Vec<_>>()).status.success());
    let rollout = |more: &[&str]| {
        let whole =
            ["rollout", text(&model), "--frames", "90", "--out", text(&out), "--latents", text(&file)];
        run(&[&whole[..], more].concat())
    };
    let latents = |more: &[&str]| {
        let output = rollout(more);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        rows(&file)
    };
    let plain = latents(&[]);
    let start = latents(&["--from", "sample:walk-5:10"]);
    assert_eq!(start.len(), 90);
    assert_ne!(start, plain);
    // The first frames are inferred, and do not depend on how long the rollout is or on what happens later.
    let cut = latents(&["--from", "sample:walk-5:10", "--cut", "lower:upper@20-40"]);
    assert_eq!(cut[..20], start[..20]);
    assert_ne!(cut[20], start[20]);
    assert_ne!(latents(&["--from", "sample:walk-5:20"])[15], start[15]);
    // A sampled rollout starts with the same frames.
    assert_eq!(latents(&["--from", "sample:walk-5:10", "--samples", "1", "--seed", "1"]), start);
    let sample = rows(&folder.join("latents-1.csv"));
    assert_eq!(sample[..10], start[..10]);
    assert_ne!(sample[10], start[10]);
    for (options, status, found) in [
        (&["--from", "sample:walk-5:1"][..], 1, "expected at least 2 frames"),
        (&["--from", "sample:walk-5:9999"], 1, "expected 9999 frames or more to start from, found"),
        (&["--from", "sample:walk-5"], 2, "or CLIP:FRAMES"),
        (&["--from", "sample:walk-5:9", "--frame", "3"], 2, "--frame: expected --from SEQUENCE"),
        (&["--from", "sample:walk-5:9", "--push", "upper@3=3f"], 1, "from 9 on and before 90, found 3"),
    ] {
        let output = rollout(options);
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(status), "{options:?}: {error}");
        assert!(error.contains(found) && error.matches('\n').count() == 1, "{options:?}: {error}");
    }
}

#[test]
fn other_couplings_make_the_latents_less_likely() {
    let folder = folder("likely");
    let (model, out) = (folder.join("model.json"), folder.join("out.bvh"));
    let train = "train sample:walk-1 --parts lower,upper --max-iterations 60 --out";
    assert!(run(&train.split(' ').chain([text(&model)]).collect::<Vec<_>>()).status.success());
    let predicted = |model: &str, more: &[&str]| {
        let whole = ["rollout", model, "--frames", "90", "--out", text(&out)];
        let summary = json_and_stderr(&[&whole[..], more].concat()).0;
        assert!(summary["dynamics_elbo"].is_number(), "{summary}");
        summary["latent_log_density"].clone()
    };
    let learned = predicted(text(&model), &[]);
    let number = |value: &Value, name: &str| value[name].as_f64().unwrap();
    let difference = number(&learned, "rollout") - number(&learned, "training");
    assert!((number(&learned, "difference") - difference).abs() < 1e-9, "{learned}");
    let changed = predicted(text(&model), &["--alpha", "lower:upper=50", "upper:upper=0.001"]);
    assert!(number(&changed, "rollout") < number(&learned, "rollout"), "{learned} {changed}");
    assert_eq!(changed["training"], learned["training"]);
    // A file of an earlier version has the first latents only.
    let first = predicted(MODEL, &[]);
    assert!(first["rollout"].is_number() && first["difference"].is_null(), "{first}");
}
