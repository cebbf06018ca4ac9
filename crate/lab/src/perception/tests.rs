//! Tests of the documents of studies and of the trials of participants.

use super::*;
use crate::perception::testing::{answers, study};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashSet};

fn document() -> Value {
    serde_json::from_str(&study().to_json().unwrap()).unwrap()
}

/// The error of the reader after a value of the document is changed.
fn refused(pointer: &str, value: Value) -> String {
    let mut document = document();
    *document.pointer_mut(pointer).unwrap() = value;
    Study::from_json(&document.to_string()).unwrap_err().to_string()
}

#[test]
fn reads_what_it_has_written_to_the_bit() {
    let text = study().to_json().unwrap();
    let again = Study::from_json(&text).unwrap();
    assert!(again == study());
    assert_eq!(again.to_json().unwrap(), text);
}

#[test]
fn hashes_only_the_figure_and_the_movements() {
    let hash = study().hash().unwrap();
    let mut other = study().with_preset(Preset::P3Part1);
    other.texts.end = "bye".to_owned();
    other = other.with_failed(&["c0-trial-1".to_owned()]).unwrap();
    assert!(!other.stimuli.last().unwrap().failed());
    assert_eq!(other.hash().unwrap(), hash);
    // A study of an earlier version.
    for stimulus in &mut other.stimuli {
        if let MovementSource::Generated(generated) = &mut stimulus.source {
            generated.scores.training_mse = None;
        }
    }
    assert_eq!(other.hash().unwrap(), hash);
    other.stimuli[0].id = "another".to_owned();
    assert_ne!(other.hash().unwrap(), hash);
    let error = study().with_failed(&["natural-1".to_owned()]).unwrap_err().to_string();
    assert_eq!(error, "expected a movement of the study, found natural-1");
}

#[test]
fn names_the_path_of_a_wrong_field() {
    for (pointer, value, words) in [
        ("/format", json!("vcgpdm model"), "expected a study with \"format\": \"vcgpdm study\", found"),
        ("/version", json!(2), "expected a study of version 1, found version 2; a newer program wrote it"),
        ("/version", json!(0), "at version: expected 1, found 0"),
        ("/look", json!("film"), "at look: expected figure or points"),
        (
            "/seconds",
            json!(1.3),
            "at seconds: expected at most the 1.20 seconds of the shortest movement, found 1.3",
        ),
        ("/design/blocks", json!(0), "at design.blocks: expected from 1 to 100, found 0"),
        ("/design/seed", json!(-1), "at design.seed: expected a whole number, found -1"),
        (
            "/texts/end",
            json!("x".repeat(20_001)),
            "at texts.end: expected at most 20000 letters, found 20001",
        ),
        ("/figure/parents", json!([null, 1]), "at figure.parents[1]: expected 0, found 1"),
        (
            "/figure/parents",
            json!([0, 0]),
            "at figure.parents[0]: expected null, as the first node is the root",
        ),
        ("/figure/dots", json!([2]), "at figure.dots[0]: expected from 0 to 1, found 2"),
        ("/figure/dots", json!([]), "at figure.dots: expected from 1 to 2, found 0"),
        ("/stimuli/0/id", json!("1"), "at stimuli[0].id: expected letters, digits"),
        (
            "/stimuli/0/id",
            json!("natural-2"),
            "at stimuli: expected different ids, found \"natural-2\" twice",
        ),
        (
            "/stimuli/0/places",
            json!("A"),
            "at stimuli[0].places: expected the positions of 36 frames of 2 nodes",
        ),
        ("/stimuli/0/kind", json!("made"), "at stimuli[0].kind: expected natural or generated"),
        ("/stimuli/4/model", json!("gplvm"), "at stimuli[4].model: expected one of vcgpdm"),
        ("/stimuli/4/model", json!("tmp"), "at stimuli[4].settings: expected no field \"dynamics_ips\""),
        ("/stimuli/4/scores/mse", json!(-1), "at stimuli[4].scores.mse: expected an error from 0, found -1"),
        (
            "/stimuli/4/scores/terms/dynamics",
            json!([]),
            "at stimuli[4].scores.terms.dynamics: expected 1, found 0",
        ),
    ] {
        let found = refused(pointer, value);
        assert!(found.starts_with(words), "{pointer}: {found}");
    }
    let mut one = document();
    one["stimuli"].as_array_mut().unwrap().truncate(4);
    let error = Study::from_json(&one.to_string()).unwrap_err().to_string();
    assert_eq!(error, "at stimuli: expected a generated movement that has not failed, found none");
    let mut one = document();
    one["stimuli"].as_array_mut().unwrap().drain(..3);
    let error = Study::from_json(&one.to_string()).unwrap_err().to_string();
    assert_eq!(error, "at stimuli: expected a natural movement that is \"seen\", found none");
    let error = Study::from_json("{}").unwrap_err().to_string();
    assert!(error.ends_with("found no format"), "{error}");
    assert!(Study::from_json("[").unwrap_err().to_string().starts_with("expected a study as JSON: line 1"));
}

#[test]
fn needs_every_field_and_refuses_others() {
    fn objects(value: &Value, at: String, found: &mut Vec<String>) {
        match value {
            Value::Object(fields) => {
                found.push(at.clone());
                fields.iter().for_each(|(name, value)| objects(value, format!("{at}/{name}"), found));
            }
            Value::Array(items) => {
                let items = items.iter().enumerate();
                items.for_each(|(k, value)| objects(value, format!("{at}/{k}"), found));
            }
            _ => {}
        }
    }
    let mut places = Vec::new();
    objects(&document(), String::new(), &mut places);
    places.retain(|place| {
        !place.starts_with("/stimuli/") || ["0", "4"].contains(&place.split('/').nth(2).unwrap())
    });
    let optional = ["head", "feet", "training_mse", "bound", "terms"];
    for place in places {
        let whole = document();
        for name in whole.pointer(&place).unwrap().as_object().unwrap().keys() {
            let mut lacks = document();
            lacks.pointer_mut(&place).unwrap().as_object_mut().unwrap().remove(name);
            let read = Study::from_json(&lacks.to_string());
            assert_eq!(read.is_ok(), optional.contains(&name.as_str()), "{place} without {name}");
        }
        let mut more = document();
        more.pointer_mut(&place).unwrap()["more"] = json!(1);
        let error = Study::from_json(&more.to_string()).unwrap_err().to_string();
        assert!(error.contains("expected no field \"more\""), "{place}: {error}");
    }
}

#[test]
fn draws_the_trials_of_the_design() {
    let mut study = study();
    study.design = Preset::P3Part1.design(1);
    let trials = study.trials(42);
    assert_eq!(trials, study.trials(42));
    assert_ne!(trials, study.trials(43));
    let count = |kind: TrialKind| trials.iter().filter(|trial| trial.kind == kind).count();
    let kinds = [TrialKind::Comparison, TrialKind::Attention, TrialKind::Catch];
    assert_eq!(kinds.map(count), [620, 17, 6]);
    // Four blocks of 160 or 161, in order.
    let blocks: Vec<usize> = trials.iter().map(|trial| trial.block).collect();
    assert!(blocks.is_sorted());
    for block in 0..4 {
        assert!([160, 161].contains(&blocks.iter().filter(|b| **b == block).count()));
    }
    let mut settings: BTreeMap<String, usize> = BTreeMap::new();
    let mut movements: BTreeMap<usize, usize> = BTreeMap::new();
    let mut lefts = 0;
    for (k, trial) in trials.iter().enumerate() {
        let (left, right) = (&study.stimuli[trial.left], &study.stimuli[trial.right]);
        assert!(trial.heading_degrees < 360);
        match (trial.kind, trial.natural_side) {
            (TrialKind::Catch, NaturalSide::None) => {
                assert!(4 * k >= 3 * trials.len(), "{k}");
                let seen: HashSet<_> = [left, right].map(|stimulus| stimulus.natural()).into();
                assert_eq!(seen, HashSet::from([Some(true), Some(false)]));
            }
            (kind, side) => {
                assert_ne!(side, NaturalSide::None);
                lefts += usize::from(side == NaturalSide::Left);
                let (natural, other) = if side == NaturalSide::Left { (left, right) } else { (right, left) };
                assert_eq!(natural.natural(), Some(true));
                assert_eq!(other.failed(), kind == TrialKind::Attention);
                if kind == TrialKind::Comparison {
                    let candidate = format!("{:?}", other.generated().unwrap().candidate);
                    *settings.entry(candidate).or_default() += 1;
                    *movements.entry(study.find(&other.id).unwrap()).or_default() += 1;
                }
            }
        }
    }
    // 620 over nine settings of two movements each.
    assert_eq!((settings.len(), movements.len()), (9, 18));
    assert!(settings.values().all(|count| [68, 69].contains(count)), "{settings:?}");
    assert!(movements.values().all(|count| [34, 35].contains(count)), "{movements:?}");
    assert!((315..=322).contains(&lefts), "{lefts}");
    // One attention check in each of seventeen equal sections.
    let checks: Vec<usize> =
        (0..trials.len()).filter(|&k| trials[k].kind == TrialKind::Attention).map(|k| k * 17 / 643).collect();
    assert!(checks.iter().enumerate().all(|(k, stretch)| k.abs_diff(*stretch) <= 1), "{checks:?}");
}

#[test]
fn draws_no_checks_without_failed_or_unseen_movements() {
    let mut few = study();
    few.stimuli.retain(|stimulus| !stimulus.failed() && stimulus.natural() != Some(false));
    let trials = few.trials(0);
    assert_eq!(trials.len(), 52);
    assert!(trials.iter().all(|trial| trial.kind == TrialKind::Comparison && trial.block == 0));
}

#[test]
fn a_preset_displays_short_movements_whole() {
    let study = study().with_preset(Preset::P2);
    assert_eq!((study.seconds, study.cross_seconds, study.frames()), (1.2, 1.0, 36));
    assert_eq!(study.positions(0).unwrap().len(), 36 * 2 * 3);
    assert_eq!(study.positions(99), None);
    assert!(Study::from_json(&study.to_json().unwrap()).is_ok());
}

/// A text with some letters changed.
fn damaged(text: &str, changes: &[(usize, char)]) -> String {
    let mut letters: Vec<char> = text.chars().collect();
    let count = letters.len();
    changes.iter().for_each(|(place, letter)| letters[place % count] = *letter);
    letters.into_iter().collect()
}

fn changes() -> impl proptest::strategy::Strategy<Value = Vec<(usize, char)>> {
    prop::collection::vec((any::<usize>(), prop::char::range(' ', '~')), 1..4)
}

proptest! {
    #[test]
    fn no_damage_of_a_study_panics(changes in changes()) {
        if let Ok(study) = Study::from_json(&damaged(&study().to_json().unwrap(), &changes)) {
            prop_assert!(!study.trials(1).is_empty());
            prop_assert!(study.positions(0).unwrap().iter().all(|place| place.is_finite()));
            prop_assert!(Study::from_json(&study.to_json().unwrap()).unwrap() == study);
        }
    }

    #[test]
    fn no_damage_of_answers_panics(changes in changes()) {
        let text = damaged(&answers(&study(), "p", 1, true, &|_| 0.3), &changes);
        let options = AnalysisOptions { draws: 10, ..AnalysisOptions::default() };
        if let Ok(answers) = read_answers(&study(), &[AnswerFile { name: "damaged", text: &text }]) {
            prop_assert!(PerceptionResults::new(&study(), &answers, options).is_ok());
        }
    }
}
