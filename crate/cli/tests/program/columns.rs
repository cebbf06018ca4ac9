//! Tests of time series: `vcgpdm train --columns`, `rollout --columns`.

use crate::call::{fails, folder, json, json_and_stderr, prints, text};
use std::fs;
use std::path::{Path, PathBuf};

/// Two trials of two machines, the second of which follows the first.
fn trials(folder: &Path) -> [PathBuf; 2] {
    [0, 1].map(|trial| {
        let path = folder.join(format!("trial-{trial}.csv"));
        let rows = (0..60).map(|row| {
            let phase = 0.25 * f64::from(row) + f64::from(trial);
            let (x, y, z) = (10.0 + phase.sin(), 200.0 * phase.cos(), 5.0 + 0.8 * (phase - 0.7).sin());
            format!("{},{x},{y},{z}\n", 0.02 * f64::from(row))
        });
        fs::write(&path, format!("time,arm_x,arm_y,leg\n{}", rows.collect::<String>())).unwrap();
        path
    })
}

const PARTS: &str = "arm=arm_*;leg=leg";
const SMALL: [&str; 8] =
    ["--latent", "2", "--dynamics-ips", "6", "--pose-ips", "6", "--max-iterations", "60"];

#[test]
fn trains_on_columns_and_rolls_them_out() {
    let folder = folder("columns");
    let [one, other] = trials(&folder);
    let (model, out, latents) = (folder.join("m.json"), folder.join("out.csv"), folder.join("latents.csv"));
    let train = ["train", text(&one), text(&other), "--columns", "--parts", PARTS, "--out", text(&model)];
    // A warning says that one part has fewer columns than latent dimensions.
    let (found, _) = json_and_stderr(&[&train[..], &SMALL].concat());
    assert_eq!((found["kind"].as_str(), found["alpha"].as_array().map(Vec::len)), (Some("vcgpdm"), Some(2)));
    let roll =
        ["rollout", text(&model), "--frames", "80", "--columns", text(&out), "--latents", text(&latents)];
    assert_eq!(prints(&roll), "");
    let written = fs::read_to_string(&out).unwrap();
    assert_eq!(written.lines().next(), Some("frame,time,arm_x,arm_y,leg"));
    assert_eq!(written.lines().count(), 81);
    let row = |k: usize| -> Vec<f64> {
        written.lines().nth(k + 1).unwrap().split(',').map(|word| word.parse().unwrap()).collect()
    };
    assert_eq!(row(5)[1], 0.1, "seconds as the trials have them");
    // It begins as the first trial does, in the trial's units.
    assert!((row(0)[2] - 10.0).abs() < 0.3 && (row(0)[3] - 200.0).abs() < 40.0, "{:?}", row(0));
    assert!(fs::read_to_string(&latents).unwrap().starts_with("frame,time,arm_0,arm_1,leg_0,leg_1"));
    // What was written can be trained on, and the other kinds know columns too.
    let dmp =
        ["train", text(&out), "--columns", "--model", "dmp-rhythmic", "--bases", "5", "--out", text(&model)];
    json(&dmp);
    prints(&["rollout", text(&model), "--frames", "9", "--columns", text(&out)]);
    assert_eq!(fs::read_to_string(&out).unwrap().lines().count(), 10);
}

#[test]
fn leaves_columns_out_by_name() {
    let folder = folder("columns-left-out");
    let [one, other] = trials(&folder);
    let (model, out) = (folder.join("m.json"), folder.join("out.csv"));
    let train = |without| {
        let tables = ["train", text(&one), text(&other), "--columns", "--model", "dmp-rhythmic"];
        [&tables[..], &["--without", without, "--out", text(&model)]].concat()
    };
    json(&train("*_y, leg"));
    prints(&["rollout", text(&model), "--frames", "9", "--columns", text(&out)]);
    assert_eq!(fs::read_to_string(&out).unwrap().lines().next(), Some("frame,time,arm_x"));
    let found = fails(&train("arm_z"));
    assert!(found.contains("expected some of the columns arm_x, arm_y, leg to leave out"), "{found}");
    let found =
        fails(&["train", "sample:walk-1", "--parts", "whole", "--without", "x", "--out", text(&model)]);
    assert!(found.contains("--columns"), "{found}");
}

#[test]
fn warns_of_a_column_that_never_changes() {
    let folder = folder("constant-column");
    let (table, model) = (folder.join("t.csv"), folder.join("m.json"));
    let rows: String = (0..20).map(|row| format!("{},7\n", (0.4 * f64::from(row)).sin())).collect();
    fs::write(&table, format!("x,y\n{rows}")).unwrap();
    let train = ["train", text(&table), "--columns", "--model", "dmp-discrete", "--out", text(&model)];
    let (summary, stderr) = json_and_stderr(&train);
    let warning = "the column y never changes, so a model learns nothing about it";
    assert_eq!(summary["warnings"], serde_json::json!([warning]));
    assert_eq!(stderr, format!("vcgpdm: {warning}\n"));
}

#[test]
fn writes_the_columns_of_a_body() {
    let folder = folder("columns-of-a-body");
    let (model, out) = (folder.join("m.json"), folder.join("out.csv"));
    json(&["train", "sample:walk-1", "--model", "dmp-rhythmic", "--fps", "15", "--out", text(&model)]);
    prints(&["rollout", text(&model), "--frames", "9", "--columns", text(&out)]);
    let written = fs::read_to_string(&out).unwrap();
    let header: Vec<&str> = written.lines().next().unwrap().split(',').collect();
    assert_eq!((header[2], header[8], header.len()), ("Hips.yaw_rate", "LeftUpLeg.x", 2 + 6 + 20 * 3));
}

#[test]
fn names_the_reason_of_wrong_tables_and_options() {
    let folder = folder("bad-columns");
    let [one, other] = trials(&folder);
    let (model, parts) = (folder.join("m.json"), folder.join("parts.json"));
    let train = |clips: &[&Path], split: &str| {
        let clips: Vec<&str> = clips.iter().map(|path| text(path)).collect();
        fails(&[&["train"], &clips[..], &["--columns", "--parts", split, "--out", text(&model)]].concat())
    };
    let broken = folder.join("broken.csv");
    fs::write(&broken, fs::read_to_string(&other).unwrap().replace("0.1,", "0.1,gap")).unwrap();
    let found = train(&[&one, &broken], PARTS);
    assert!(
        found.contains("broken.csv, line 7, column 2 (arm_x): expected a number, found \"gap"),
        "{found}"
    );
    fs::write(&broken, "arm_x,leg\n1,2\n3,4\n").unwrap();
    assert!(train(&[&one, &broken], PARTS).contains("expected a column \"arm_y\", found none"));
    assert!(train(&[&one], "arm=arm_*").contains("found no part for leg"));
    // Once this message spoke of a body.
    let found = fails(&["train", text(&one), "--columns", "--out", text(&model)]);
    assert!(found.contains("--parts: expected how to split the columns of a coupled model"), "{found}");
    fs::write(&parts, r#"[{"name": "arm", "columns": ["arm_x", "knee"]}]"#).unwrap();
    let found = train(&[&one], text(&parts));
    assert!(found.contains("parts.json: ") && found.contains("found \"knee\""), "{found}");
    json(&["train", text(&one), "--columns", "--model", "dmp-discrete", "--out", text(&model)]);
    let bvh = folder.join("out.bvh");
    let found = fails(&["rollout", text(&model), "--frames", "9", "--out", text(&bvh)]);
    assert!(found.contains("expected --columns for a model of tables"), "{found}");
    let found = fails(&["score", text(&model), "sample:walk-1"]);
    assert!(found.contains("expected a model of a body, found a model of tables"), "{found}");
    assert!(fails(&["rollout", text(&model), "--frames", "9"]).contains("--out"));
}
