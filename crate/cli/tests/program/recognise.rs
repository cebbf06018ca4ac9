//! Tests of `vcgpdm recognise`.

use crate::call::{fails, folder, json, prints, text};
use serde_json::Value;
use std::fs;

#[test]
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
