//! Tests of `vcgpdm recognise`.

use crate::call::{fails, folder, json, prints, text};
use std::fs;

#[test]
fn recognises_movements_in_clips_that_were_not_trained_on() {
    let folder = folder("recognise");
    let (library, out) = (folder.join("library.json"), folder.join("out.csv"));
    let train = "train --movement walk=sample:walk-1,sample:walk-2 --movement wave=sample:walk-wave-1,sample:walk-wave-2 --parts lower,upper --fps 15 --max-iterations 60 --out";
    prints(&train.split(' ').chain([text(&library)]).collect::<Vec<_>>());
    for (clip, movement) in [("sample:walk-3", "walk"), ("sample:walk-wave-3", "wave")] {
        let found = json(&["recognise", text(&library), clip, "--out", text(&out)]);
        assert!(found["share"][movement].as_f64().unwrap() > 0.9, "{found}");
        let segments = found["segments"].as_array().unwrap();
        assert_eq!(segments[0]["from"].as_f64(), Some(0.0));
        assert_eq!(segments.last().unwrap()["to"], found["seconds"]);
        let rows = fs::read_to_string(&out).unwrap();
        assert_eq!(rows.lines().next(), Some("frame,time,walk,wave,walk log density,wave log density"));
        // The means of the columns.
        let numbers: Vec<Vec<f64>> = (rows.lines().skip(1))
            .map(|row| row.split(',').map(|number| number.parse().unwrap()).collect())
            .collect();
        let mean = |column: usize| numbers.iter().map(|row| row[column]).sum::<f64>() / numbers.len() as f64;
        let density = |name: &str| found["log_density"][name].as_f64().unwrap();
        assert!((density("walk") - mean(4)).abs() < 1e-5 * mean(4).abs(), "{found}");
        assert!((density("wave") - mean(5)).abs() < 1e-5 * mean(5).abs(), "{found}");
        let other = if movement == "walk" { "wave" } else { "walk" };
        assert!(density(movement) > density(other), "{found}");
        assert!(segments[0]["log_density"].as_f64().unwrap() > density(other), "{found}");
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
