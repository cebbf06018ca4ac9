//! Short trainings of all kinds of models with other settings than the usual ones.

use super::{Lines, short};
use serde_json::Value;
use std::ops::ControlFlow;
use vcgpdm_core::models::{
    Dataset, DmpSettings, MapSettings, PoseWeight, Settings, Source, TmpSettings, Trainer,
    VariationalSettings,
};
use vcgpdm_core::motion::parts;

/// A training that has not ended after so many steps is stopped.
const MOST_STEPS: usize = 200;

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
fn train(lines: &mut Lines, dataset: &Dataset, settings: &Settings) {
    let mut trainer = Trainer::new(dataset, settings, 2).unwrap();
    trainer.run_with(|progress| {
        lines.numbers("objective", [&progress.objective, &progress.best]);
        lines.said("phase", (progress.phase, &progress.reason, progress.evaluations));
        if progress.iteration < MOST_STEPS { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    lines.said("warnings", trainer.warnings());
    let model = trainer.finish().unwrap();
    let document: Value = serde_json::from_str(&model.to_json().unwrap()).unwrap();
    for (name, value) in document.as_object().unwrap() {
        // The provenance has the version of the program.
        if name != "pose" && name != "provenance" {
            add_numbers(lines, name, value);
        }
    }
    for sequence in 0..3 {
        lines.numbers("rollout", &model.rollout(sequence, 60).unwrap());
    }
}

/// Three trials of a movement, as the parts of a preset; of the last only the beginning is known.
fn dataset(movement: &str, preset: usize) -> Dataset {
    let clips = [("1", 60), ("2", 51), ("3", 66)]
        .map(|(trial, frames)| short(&format!("{movement}-{trial}"), frames));
    let parts = parts::presets(&clips[0].skeleton).swap_remove(preset).parts;
    let [a, b, c] = &clips;
    let sources = [Source::from(a), Source::from(b), Source { clip: c, first_frames: Some(7) }];
    Dataset::new(&sources, &parts, 15.0).unwrap()
}

pub fn trained() -> Lines {
    let mut lines = Lines::default();
    let [whole, halves] = [0, 1].map(|preset| dataset("walk", preset));
    let small = VariationalSettings::default().with_latent(2).with_points(7, 6).with_max_iterations(6);
    let map = MapSettings { latent: 2, max_iterations: 8, ..MapSettings::default() };
    let own = small.clone().with_pose_weight(PoseWeight::Balanced).with_own_rollouts(true);
    let third = small.clone().with_order(3).with_pose_weight(PoseWeight::Fixed(0.3));
    for (dataset, settings) in [
        (&halves, Settings::Vcgpdm(small.clone())),
        (&halves, Settings::Vcgpdm(small.with_order(1).with_uncoupled(true))),
        (&halves, Settings::Vcgpdm(own)),
        (&whole, Settings::Vgpdm(third)),
        (&halves, Settings::MapCgpdm(map.clone())),
        (&halves, Settings::MapCgpdm(MapSettings { balanced: true, linear: true, order: 1, ..map.clone() })),
        (&whole, Settings::MapGpdm(map)),
    ] {
        train(&mut lines, dataset, &settings);
    }
    // The training of a model with latents amplifies the last digits of a movement that does not repeat itself.
    for dataset in [halves, dataset("bottle", 1)] {
        for settings in [
            Settings::Tmp(TmpSettings { primitives: Some(3), normalised_time: false }),
            Settings::Tmp(TmpSettings { primitives: Some(3), normalised_time: true }),
            Settings::Tmp(TmpSettings::default()),
            Settings::DmpDiscrete(DmpSettings { bases: 9 }),
            Settings::DmpRhythmic(DmpSettings { bases: 9 }),
        ] {
            train(&mut lines, &dataset, &settings);
        }
    }
    lines
}
