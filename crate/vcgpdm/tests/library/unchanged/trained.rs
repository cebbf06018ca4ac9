//! Short trainings of all kinds of models with other settings than the usual ones.

use super::{Lines, short};
use serde_json::Value;
use vcgpdm_core::models::{
    Dataset, DmpSettings, MapSettings, PoseWeight, Settings, Source, TmpSettings, Trainer,
    VariationalSettings,
};
use vcgpdm_core::motion::parts;

/// All numbers of a document, those of one list on one line.
fn add_numbers(lines: &mut Lines, name: &str, value: &Value) {
    match value {
        Value::Object(fields) => fields.iter().for_each(|(name, value)| add_numbers(lines, name, value)),
        Value::Array(values) if values.iter().all(Value::is_number) => {
            lines.numbers(name, &values.iter().filter_map(Value::as_f64).collect::<Vec<_>>());
        }
        Value::Array(values) => values.iter().for_each(|value| add_numbers(lines, name, value)),
        Value::Number(number) => lines.numbers(name, &number.as_f64()),
        Value::Null | Value::Bool(_) | Value::String(_) => lines.said(name, value),
    }
}

/// The progress of a training, and the numbers of its model.
fn train(lines: &mut Lines, dataset: &Dataset, settings: &Settings, most_steps: usize) {
    let mut trainer = Trainer::new(dataset, settings, 2).unwrap();
    for _ in 0..most_steps {
        let progress = trainer.step();
        lines.numbers("objective", [&progress.objective, &progress.best]);
        lines.said("phase", (progress.phase, progress.reason, progress.evaluations));
        if progress.done {
            break;
        }
    }
    for warning in trainer.warnings() {
        lines.said("warning", warning);
    }
    let model = trainer.finish().unwrap();
    let document: Value = serde_json::from_str(&model.to_json().unwrap()).unwrap();
    for (name, value) in document.as_object().unwrap() {
        if name != "pose" && name != "training" {
            add_numbers(lines, name, value);
        }
    }
    for sequence in 0..3 {
        lines.numbers("rollout", &model.rollout(sequence, 60).unwrap());
    }
}

/// Three walks or three bottles that are passed; of the last only the beginning is known.
fn dataset(movement: &str, split: usize) -> Dataset {
    let clips = [("1", 60), ("2", 51), ("3", 66)]
        .map(|(trial, frames)| short(&format!("{movement}-{trial}"), frames));
    let parts = parts::presets(&clips[0].skeleton).swap_remove(split).parts;
    let [a, b, c] = &clips;
    let sources = [Source::from(a), Source::from(b), Source { clip: c, first_frames: Some(7) }];
    Dataset::new(&sources, &parts, 15.0).unwrap()
}

pub fn trained() -> Lines {
    let mut lines = Lines::default();
    let small = VariationalSettings::default().with_latent(2).with_points(7, 6).with_max_iterations(6);
    let map = MapSettings { latent: 2, max_iterations: 8, ..MapSettings::default() };
    let settings: Vec<(Settings, usize)> = vec![
        (Settings::Vcgpdm(small.clone()), 12),
        (Settings::Vcgpdm(small.clone().with_order(1).with_uncoupled(true)), 12),
        (Settings::Vcgpdm(small.clone().with_pose_weight(PoseWeight::Balanced).with_own_rollouts(true)), 60),
        (Settings::Vgpdm(small.clone().with_order(3).with_pose_weight(PoseWeight::Fixed(0.3))), 12),
        (Settings::MapCgpdm(map.clone()), 12),
        (Settings::MapCgpdm(MapSettings { balanced: true, linear: true, order: 1, ..map.clone() }), 12),
        (Settings::MapGpdm(map), 12),
        (Settings::Tmp(TmpSettings { primitives: Some(3), normalised_time: false }), 30),
        (Settings::Tmp(TmpSettings { primitives: Some(3), normalised_time: true }), 30),
        (Settings::Tmp(TmpSettings::default()), 200),
        (Settings::DmpDiscrete(DmpSettings { bases: 9 }), 2),
        (Settings::DmpRhythmic(DmpSettings { bases: 9 }), 2),
    ];
    for movement in ["walk", "bottle"] {
        let [whole, halves] = [0, 1].map(|split| dataset(movement, split));
        for (settings, most_steps) in &settings {
            lines.said(movement, settings.kind().id());
            let is_of_one_part = matches!(settings, Settings::Vgpdm(_) | Settings::MapGpdm(_));
            train(&mut lines, if is_of_one_part { &whole } else { &halves }, settings, *most_steps);
        }
    }
    lines
}
