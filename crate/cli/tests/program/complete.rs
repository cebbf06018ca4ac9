//! Tests of `vcgpdm complete`.

use crate::call::{fails, folder, json, prints, taller_walk, text};
use std::fs;

#[test]
fn completes_a_walk_that_was_not_trained_on_from_either_half() {
    let folder = folder("complete");
    let (model, out) = (folder.join("model.json"), folder.join("out.bvh"));
    let train = "train sample:walk-1 sample:walk-2 --fps 15 --parts lower,upper --max-iterations 100 --out";
    prints(&train.split(' ').chain([text(&model)]).collect::<Vec<_>>());
    for (given, other) in [("lower", "upper"), ("1", "lower")] {
        let line = ["complete", text(&model), "sample:walk-3", "--given", given, "--out", text(&out)];
        let found = json(&line);
        let parts = found["parts"].as_object().unwrap();
        assert_eq!(parts.keys().collect::<Vec<_>>(), [other]);
        let number = |name: &str| parts[other][name].as_f64().unwrap();
        assert!(number("mse") < 0.9 * number("mse_mean_pose"), "{found}");
        assert!((0.5..=1.0).contains(&number("coverage_95")), "{found}");
        assert!(number("log_density") > 0.0, "{found}");
        let written = fs::read_to_string(&out).unwrap();
        assert!(written.contains(&format!("Frames: {}", found["frames"])));
    }
    // The legs are observed for a second; then the model goes on by itself.
    let line = ["complete", text(&model), "sample:walk-3", "--given", "lower", "--until", "1"];
    let upper = &json(&line)["parts"]["upper"];
    let error = |score: &serde_json::Value| score["mse"].as_f64().unwrap();
    assert!(error(upper) > 0.0 && error(&upper["after_cut"]) > 0.0, "{upper}");
    assert_ne!(error(upper), error(&upper["after_cut"]));

    let refused = |words: &[&str]| fails(&[&["complete", text(&model)], words].concat());
    let expected = "--given arms: expected one of the parts lower, upper";
    assert!(refused(&["sample:walk-3", "--given", "arms"]).contains(expected));
    let all = refused(&["sample:walk-3", "--given", "lower,upper"]);
    assert!(all.contains("--given: expected a part of the model that is not given, found all"), "{all}");
    let late = refused(&["sample:walk-3", "--given", "lower", "--until", "60"]);
    assert!(late.contains("--until: expected seconds from 0.13"), "{late}");
    let other_body = refused(&[text(&taller_walk(&folder)), "--given", "lower"]);
    assert!(other_body.contains("taller.bvh"), "{other_body}");
    let same = refused(&["sample:walk-3", "--given", "lower", "--out", text(&model)]);
    assert!(same.contains("expected another file to write to"), "{same}");

    let tmp = folder.join("tmp.json");
    let train = "train sample:walk-1 --model tmp --primitives 3 --out";
    prints(&train.split(' ').chain([text(&tmp)]).collect::<Vec<_>>());
    let kind = fails(&["complete", text(&tmp), "sample:walk-3", "--given", "0"]);
    assert!(kind.contains("expected a vcgpdm model, found a tmp model"), "{kind}");
}
