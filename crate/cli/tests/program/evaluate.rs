//! Tests of `vcgpdm evaluate`, `report` and `results merge`.

use crate::call::{run, run_with};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

const TRIALS: [&str; 3] = ["sample:walk-1", "sample:walk-2", "sample:walk-3"];
const SMALL: [&str; 8] = ["--parts", "lower,upper", "--fps", "15", "--max-iterations", "8", "--latent", "2"];

fn evaluate(out: &Path, more: &[&str]) -> Output {
    let all = [&["evaluate"], &TRIALS[..], &SMALL, more, &["--out", out.to_str().unwrap()]].concat();
    run(&all)
}

fn summary(output: &Output) -> Value {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn refusal(output: &Output) -> String {
    let err = String::from_utf8(output.stderr.clone()).unwrap();
    let status = 1 + i32::from(err.starts_with("vcgpdm: -") || err.ends_with("(try --help)\n"));
    assert_eq!((output.status.code(), err.matches('\n').count()), (Some(status), 1), "{err}");
    err
}

fn file(name: &str) -> PathBuf {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("evaluate-{name}.json"));
    let _ = fs::remove_file(&file);
    file
}

fn results(file: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap()
}

#[test]
fn does_not_compute_a_finished_job_again() {
    let out = file("twice");
    let first = evaluate(&out, &["--models", "vgpdm,dmp-rhythmic", "--folds", "2"]);
    let log = String::from_utf8_lossy(&first.stderr).into_owned();
    assert_eq!(log.matches(" held out, seed 0, done in ").count(), 2, "a line a job: {log}");
    let first = summary(&first);
    assert_eq!((first["computed"].as_u64(), first["known_before"].as_u64()), (Some(2), Some(0)));
    let before = results(&out);
    let second =
        summary(&evaluate(&out, &["--models", "vgpdm,dmp-rhythmic", "--folds", "2,3", "--seeds", "0,1"]));
    // The DMP has no seeds: one run in each fold. Fold 2 with seed 0 of both models is done.
    assert_eq!((second["computed"].as_u64(), second["known_before"].as_u64()), (Some(4), Some(2)));
    let after = results(&out);
    assert_eq!(after["finished"].as_array().unwrap().len(), 6);
    for k in 0..2 {
        assert_eq!(
            after["finished"][k], before["finished"][k],
            "it was not computed again: the seconds are equal"
        );
    }
    let score = &after["finished"][0]["outcome"]["score"];
    assert!(score["dtw_mse"].as_f64().unwrap() > 0.0 && score["variance"].as_f64().unwrap() > 0.0);
    let files: Vec<String> = fs::read_dir(out.parent().unwrap())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .filter(|name| name.starts_with("evaluate-twice.json."))
        .collect();
    assert_eq!(files, ["evaluate-twice.json.lock"], "no other file stays");
}

#[test]
fn computes_failed_jobs_again() {
    let out = file("failed");
    let models = ["--models", "dmp-rhythmic", "--folds", "1,2"];
    summary(&evaluate(&out, &models));
    let whole = results(&out);
    let mut failed = whole.clone();
    failed["finished"][0]["outcome"] = Value::Null;
    failed["finished"][0]["failure"] = "a bug that is fixed".into();
    fs::write(&out, failed.to_string()).unwrap();
    let again = summary(&evaluate(&out, &models));
    assert_eq!((again["computed"].as_u64(), again["known_before"].as_u64()), (Some(1), Some(1)));
    let mended = results(&out);
    assert_eq!(mended["finished"].as_array().unwrap().len(), 2);
    assert_eq!(mended["finished"][0]["outcome"]["score"], whole["finished"][0]["outcome"]["score"]);
    assert_eq!(mended["finished"][0]["failure"], Value::Null);
}

/// A workflow goes on if only some jobs failed: the exit status is 1 only if all failed.
#[test]
fn reports_failures_at_the_end() {
    let out = file("all-failed");
    let order = ["--folds", "1,1,2", "--order", "100"];
    let output = evaluate(&out, &[&order[..], &["--models", "vgpdm,vgpdm"]].concat());
    let last = |output: &Output| String::from_utf8_lossy(&output.stderr).lines().last().unwrap().to_owned();
    let found = last(&output);
    assert_eq!(output.status.code(), Some(1), "{found}");
    assert!(found.starts_with("vcgpdm: 2 of 2 jobs failed, first vgpdm, "), "{found}");
    assert!(
        found.contains("; dynamics of order 100 need at least 101") && !found.contains("sequence"),
        "{found}"
    );
    assert_eq!(results(&out)["finished"].as_array().map(Vec::len), Some(2));
    let output = evaluate(&out, &[&order[..], &["--models", "vgpdm,dmp-rhythmic"]].concat());
    assert!(last(&output).starts_with("vcgpdm: 2 of 4 jobs failed, first "), "{}", last(&output));
    assert_eq!(summary(&output)["failed"].as_u64(), Some(2));
}

#[test]
fn leaves_out_coupled_models_for_a_body_in_one_part() {
    let out = file("one-part");
    let whole =
        ["evaluate", "sample:walk-1", "sample:walk-2", "--parts", "whole", "--fps", "15", "--folds", "1"];
    let asked = |models| run(&[&whole[..], &["--models", models, "--out", out.to_str().unwrap()]].concat());
    let found = refusal(&asked("vcgpdm,map-cgpdm"));
    assert!(
        found.contains("--parts whole: expected two parts or more for vcgpdm, map-cgpdm, found 1"),
        "{found}"
    );
    let output = asked("map-cgpdm,dmp-rhythmic");
    let found = String::from_utf8_lossy(&output.stderr);
    assert!(found.contains("--parts whole is one part: map-cgpdm left out"), "{found}");
    assert_eq!(summary(&output)["jobs"].as_u64(), Some(1));
}

#[test]
fn computes_the_same_results_in_shares() {
    let (one, whole) = (file("share"), file("whole"));
    let models = ["--models", "vgpdm,dmp-discrete", "--ips", "4,5", "--threads", "1"];
    let mut computed = 0;
    for k in ["1", "2", "4"] {
        let share = [&models[..], &["--job", k, "of", "4"]].concat();
        computed += summary(&evaluate(&one, &share))["computed"].as_u64().unwrap();
    }
    let rest = summary(&evaluate(&one, &models));
    assert_eq!(rest["known_before"].as_u64(), Some(computed));
    assert_eq!(rest["jobs"].as_u64(), Some(9));
    summary(&evaluate(&whole, &models));
    // The same numbers in any order.
    let numbers = |file: &Path| {
        let found = results(file);
        let mut lines: Vec<String> = found["finished"]
            .as_array()
            .unwrap()
            .iter()
            .map(|f| format!("{} {}", f["job"], f["outcome"]["score"]))
            .collect();
        lines.sort();
        lines
    };
    assert_eq!(numbers(&one), numbers(&whole));
}

#[test]
fn reports_a_row_for_each_model_and_the_claims() {
    let out = file("report");
    summary(&evaluate(&out, &["--models", "all", "--folds", "1", "--bases", "5,6", "--primitives", "3"]));
    let text = String::from_utf8(run(&["report", out.to_str().unwrap()]).stdout).unwrap();
    for id in
        ["vcgpdm", "vgpdm", "map-gpdm", "map-cgpdm", "tmp", "dmp-discrete", "dmp-rhythmic", "promp", "ar"]
    {
        assert!(text.contains(&format!("\n| {id} | ")), "{id} in {text}");
    }
    assert!(text.contains("| 5 bases | ") && text.contains("| 6 bases | "), "{text}");
    // One trial has no interval: nothing is decided.
    assert!(text.contains("performs best in terms of MSE.\u{201d} (2017, section 3.2) | "), "{text}");
    assert!(text.contains(" | undecided |\n") && !text.contains(" | yes |\n"), "{text}");
    // Results of other trials are a subject of their own.
    let other = file("report-other");
    let cut = ["--models", "dmp-rhythmic", "--whole-cycles", "--start-frames", "2"];
    summary(&evaluate(&other, &cut));
    let both = run(&["report", out.to_str().unwrap(), other.to_str().unwrap()]);
    let both = String::from_utf8(both.stdout).unwrap();
    assert!(both.contains("predictions start from 2 frames.") && both.contains("### All together"), "{both}");
    // The same clips count once.
    let together = both.split("### All together").nth(1).unwrap();
    assert!(!together.contains("20 bases"), "{together}");
}

#[test]
fn reports_the_primary_claims_over_persons() {
    let results = |name: &str| format!("{}/../../docs/comparison/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let found = run(&["report", "--primary", &results("cmu-12"), &results("bandai-walk")]);
    let text = String::from_utf8(found.stdout).unwrap();
    assert!(text.starts_with("| primary claim | ") && !text.contains("| secondary claim | "), "{text}");
    assert!(text.contains("in the mean of 2 persons") && text.contains(" persons would decide it"), "{text}");
    // Ten claims, one row a person.
    assert!(text.lines().any(|line| line.starts_with("| cmu-12 | 3 |") && line.matches('|').count() == 13));
}

#[test]
fn writes_the_file_of_an_empty_share_and_merges_files() {
    let shares = ["1", "2", "3"].map(|k| file(&format!("merge-{k}")));
    let models = ["--models", "dmp-discrete", "--folds", "1,2"];
    for (path, k) in shares.iter().zip(["1", "2", "3"]) {
        let done = summary(&evaluate(path, &[&models[..], &["--job", k, "of", "3"]].concat()));
        assert_eq!(done["computed"].as_u64(), Some(u64::from(k != "3")), "share {k}");
    }
    let texts: Vec<&str> = shares.iter().map(|path| path.to_str().unwrap()).collect();
    let merged = run(&[&["results", "merge"], &texts[..], &["--out", "-"]].concat());
    let found: Value = serde_json::from_slice(&merged.stderr).unwrap();
    assert_eq!((found["jobs"].as_u64(), found["failed"].as_u64()), (Some(2), Some(0)));
    let whole: Value = serde_json::from_slice(&merged.stdout).unwrap();
    assert_eq!(whole["finished"].as_array().map(Vec::len), Some(2));
    // Results come from stdin as well, and their tables as numbers.
    let piped = run_with(&["report", "--json", "-"], &merged.stdout);
    let report: Value = serde_json::from_slice(&piped.stdout).unwrap();
    let models = report["subjects"][0]["comparison"]["models"].as_array().unwrap();
    assert_eq!((models[0]["folds"].as_u64(), &report["all_together"]), (Some(2), &Value::Null));
    assert!(
        refusal(&run(&[&["results", "merge"], &texts[..], &["--out", texts[0]]].concat()))
            .contains("expected another file to write to")
    );
    assert!(refusal(&evaluate(Path::new("-"), &["--models", "dmp-discrete"])).contains("expected a file"));
}

/// Once the number of the first file silently stayed.
#[test]
fn refuses_files_with_different_numbers_of_a_job() {
    let (first, second) = (file("agree"), file("disagree"));
    summary(&evaluate(&first, &["--models", "dmp-rhythmic", "--folds", "1"]));
    let mut changed = results(&first);
    let outcome = &mut changed["finished"][0]["outcome"];
    outcome["seconds"] = 99.0.into();
    fs::write(&second, changed.to_string()).unwrap();
    let texts = [first.to_str().unwrap(), second.to_str().unwrap()];
    let merge = |more: &[&str]| run(&[&["results", "merge"], &texts[..], more, &["--out", "-"]].concat());
    assert!(merge(&[]).status.success(), "other seconds are no disagreement");
    changed["finished"][0]["outcome"]["score"]["dtw_mse"] = 1e99.into();
    fs::write(&second, changed.to_string()).unwrap();
    let found = refusal(&merge(&[]));
    for part in [texts[0], texts[1], "dmp-rhythmic, 20 bases; trial 1 held out", "DTW MSE 0.", "--prefer"] {
        assert!(found.contains(part), "{part}: {found}");
    }
    let error = |output: &Output| {
        let merged: Value = serde_json::from_slice(&output.stdout).unwrap();
        merged["finished"][0]["outcome"]["score"]["dtw_mse"].as_f64().unwrap()
    };
    assert!(error(&merge(&["--prefer", "first"])) < 1.0);
    assert_eq!(error(&merge(&["--prefer", "last"])), 1e99);
    let report = |more: &[&str]| run(&[&["report"], &texts[..], more].concat());
    assert!(refusal(&report(&[])).contains("expected the same numbers of the job"));
    // A stranger's number does not fill the table.
    let printed = String::from_utf8(report(&["--prefer", "last"]).stdout).unwrap();
    assert!(printed.contains("| dmp-rhythmic | 20 bases | 1.00e99 | 1.00e99 | "), "{printed}");
}

/// Once both computed all jobs. The claim of a killed program does not block its job.
#[cfg(unix)]
#[test]
fn computes_each_job_once_in_two_programs() {
    let out = file("two");
    let seeds = ["--seeds", "0,1,2,3", "--models", "vgpdm", "--folds", "1,2", "--threads", "1"];
    let program = |more: &[&str]| {
        let options = ["--parts", "lower,upper", "--fps", "30", "--out", out.to_str().unwrap()];
        let arguments = [&["evaluate"], &TRIALS[..], &options, &seeds, more].concat();
        let mut command = Command::new(env!("CARGO_BIN_EXE_vcgpdm"));
        command.args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    };
    let claims = || {
        let files = fs::read_dir(out.parent().unwrap()).unwrap().map(|file| file.unwrap().path());
        files.filter(|file| file.to_string_lossy().contains("evaluate-two.json.lock-")).collect::<Vec<_>>()
    };
    // Of a run before this one.
    claims().iter().for_each(|file| fs::remove_file(file).unwrap());
    // This one has a job that takes long.
    let mut killed = program(&["--max-iterations", "100000", "--ips", "40", "--latent", "9"]);
    while claims().is_empty() {
        assert!(killed.try_wait().unwrap().is_none(), "it works");
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    let short = ["--max-iterations", "30"];
    let both =
        [program(&short), program(&short)].map(|program| summary(&program.wait_with_output().unwrap()));
    let count = |name: &str| both.iter().map(|found| found[name].as_u64().unwrap()).sum::<u64>();
    assert_eq!((count("computed"), count("left")), (8, 0), "{both:?}");
    assert_eq!(count("computed_elsewhere") + count("known_before"), 8, "{both:?}");
    killed.kill().unwrap();
    killed.wait().unwrap();
    assert_eq!(claims().len(), 1, "the killed program's claim");
    let again = [&["evaluate"], &TRIALS[..], &["--parts", "lower,upper", "--fps", "30"], &seeds, &short];
    let again = summary(&run(&[&again.concat()[..], &["--out", out.to_str().unwrap()]].concat()));
    assert_eq!(again["known_before"].as_u64(), Some(8));
}

#[test]
fn stores_objective_and_bound_of_balanced_models() {
    let out = file("balanced");
    let models = ["--models", "vgpdm", "--folds", "1"];
    summary(&evaluate(&out, &[&models[..], &["--balanced"]].concat()));
    // Jobs of another weight are other jobs.
    let again = summary(&evaluate(&out, &[&models[..], &["--pose-weight", "0.5"]].concat()));
    assert_eq!((again["computed"].as_u64(), again["known_before"].as_u64()), (Some(1), Some(0)));
    let coupled = ["--models", "vcgpdm,vgpdm", "--folds", "1", "--uncoupled", "--balanced"];
    // The vGPDM has nothing to couple: its job is known.
    assert_eq!(summary(&evaluate(&out, &coupled))["known_before"].as_u64(), Some(1));
    let results: Value = serde_json::from_str(&fs::read_to_string(&out).unwrap()).unwrap();
    let finished = results["finished"].as_array().unwrap();
    assert_eq!(finished[2]["job"]["candidate"]["uncoupled"], true);
    let weights: Vec<&Value> = finished.iter().map(|f| &f["job"]["candidate"]["pose_weight"]).collect();
    assert_eq!(weights, [&json!("balanced"), &json!(0.5), &json!("balanced")]);
    for outcome in finished.iter().map(|finished| &finished["outcome"]) {
        assert!(outcome["bound"].is_f64() && outcome["objective"].is_f64(), "{outcome}");
        assert_ne!(outcome["bound"], outcome["objective"]);
    }
    let report = String::from_utf8(run(&["report", out.to_str().unwrap()]).stdout).unwrap();
    assert!(report.contains("inducing points, balanced |"), "{report}");
    assert!(report.contains("inducing points, pose weight 0.5 |"), "{report}");
    assert!(report.contains("inducing points, balanced, uncoupled |"), "{report}");
}

#[test]
fn refuses_bad_input_before_the_first_training() {
    let out = file("refused");
    assert!(refusal(&evaluate(&out, &["--models", "gplvm"])).contains("expected all, or some of vcgpdm"));
    assert!(refusal(&evaluate(&out, &["--folds", "4"])).contains("numbers from 1 to 3"));
    assert!(refusal(&evaluate(&out, &["--job", "3", "of", "2"])).contains("K of N with K from 1 to N"));
    assert!(refusal(&evaluate(&out, &["--training-trials", "3"])).contains("from 1 to 2 trials"));
    assert!(refusal(&evaluate(&out, &["--primitives", "some"])).contains("expected bound, or a number"));
    let weight = refusal(&evaluate(&out, &["--pose-weight", "0"]));
    assert!(weight.contains("expected a number from 0.001 to 1000"), "{weight}");
    assert!(refusal(&evaluate(&out, &["sample:walk-2"])).contains("trials 2 and 4 are the same motion"));
    assert!(!out.exists());
    summary(&evaluate(&out, &["--models", "dmp-rhythmic", "--folds", "1"]));
    let other = [
        &["evaluate", "sample:walk-4", "sample:walk-5"],
        &SMALL[..],
        &["--models", "dmp-rhythmic", "--out", out.to_str().unwrap()],
    ]
    .concat();
    assert!(refusal(&run(&other)).contains("these results are of other trials"));
    fs::write(&out, "{}").unwrap();
    assert!(refusal(&evaluate(&out, &[])).contains("expected the results of an evaluation"));
    assert!(
        refusal(&run(&["report", out.to_str().unwrap()])).contains("expected the results of an evaluation")
    );
}
