//! Tests of `vcgpdm complete` and `vcgpdm recognise`.

use crate::call::{fails, folder, json, prints, taller_walk, text};
use serde_json::Value;
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

#[test]
#[ignore = "seldom: npm test -- --all"]
fn recognises_movements_in_clips_that_were_not_trained_on() {
    let folder = folder("recognise");
    let (library, out) = (folder.join("library.json"), folder.join("out.csv"));
    let train = "train --movement walk=sample:walk-1,sample:walk-2 --movement wave=sample:walk-wave-1,sample:walk-wave-2 --parts lower,upper --fps 15 --max-iterations 60 --out";
    prints(&train.split(' ').chain([text(&library)]).collect::<Vec<_>>());
    for (clip, movement) in [("sample:walk-3", "walk"), ("sample:walk-wave-3", "wave")] {
        let found = json(&["recognise", text(&library), clip, "--out", text(&out)]);
        let segments = found["segments"].as_array().unwrap();
        assert_eq!(segments[0]["from"].as_f64(), Some(0.0));
        assert_eq!(segments.last().unwrap()["to"], found["seconds"]);
        assert_eq!((segments.len(), &segments[0]["movement"]), (1, &Value::from(movement)), "{found}");
        assert_eq!(segments[0]["primitives"]["upper"], movement);
        let rows = fs::read_to_string(&out).unwrap();
        let heads: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
        assert_eq!(heads[..4], ["frame", "time", "lower walk", "lower walk log density"]);
        assert_eq!(heads.len(), 10);
        // The means of the columns.
        let numbers: Vec<Vec<f64>> = (rows.lines().skip(1))
            .map(|row| row.split(',').map(|number| number.parse().unwrap()).collect())
            .collect();
        let mean = |column: &str| {
            let place = heads.iter().position(|head| *head == column).unwrap();
            numbers.iter().map(|row| row[place]).sum::<f64>() / numbers.len() as f64
        };
        let upper = &found["parts"]["upper"];
        let density = |name: &str| upper["log_density"][name].as_f64().unwrap();
        for name in ["walk", "wave"] {
            let expected = mean(&format!("upper {name} log density"));
            assert!((density(name) - expected).abs() < 1e-5 * expected.abs(), "{found}");
            assert_eq!(upper["share"][name].as_f64(), Some(f64::from(u8::from(name == movement))));
        }
        let other = if movement == "walk" { "wave" } else { "walk" };
        assert!(density(movement) > density(other), "{found}");
        assert!(mean(&format!("upper {movement}")) > 0.9, "{found}");
    }
    let both = json(&["recognise", text(&library), "sample:walk-3", "sample:walk-wave-3"]);
    let movements: Vec<_> =
        both["segments"].as_array().unwrap().iter().map(|segment| &segment["movement"]).collect();
    assert_eq!(movements, ["walk", "wave"], "{both}");
    assert_eq!(both["clips"].as_array().unwrap().len(), 2);
    let one = folder.join("one.json");
    let train = "train --movement walk=sample:walk-1 --parts lower,upper --fps 15 --max-iterations 3 --out";
    prints(&train.split(' ').chain([text(&one)]).collect::<Vec<_>>());
    let refused = fails(&["recognise", text(&one), "sample:walk-3"]);
    assert!(refused.contains("expected a library of two movements or more, found 1"), "{refused}");
}
