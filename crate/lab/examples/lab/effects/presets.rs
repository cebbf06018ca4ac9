//! The presets of the first model of the page.

use crate::effects::sweep::{Learned, health_text, number, scale};
use crate::models::read_first;
use serde::Deserialize;
use vcgpdm::Coupled;
use vcgpdm::models::Reading;

#[derive(Deserialize)]
struct Preset {
    name: String,
    reading: Reading,
    couplings: Vec<Change>,
}

#[derive(Deserialize)]
struct Change {
    source: String,
    target: String,
    factor: f64,
}

pub fn print(model: Coupled) {
    let presets: Vec<Preset> = serde_json::from_str(&read_first("presets.json")).unwrap();
    let learned = Learned::new(model);
    let part_index = |name: &str| {
        let parts = model.body.layout.parts();
        parts.iter().position(|part| part.name == name).unwrap_or_else(|| panic!("no part {name}"))
    };
    println!(
        "| preset | reading | couplings | hands swing | feet swing | in step | period of hands, s | of feet, s | m/s | ends |"
    );
    println!("{}|", "|---".repeat(10));
    for preset in presets {
        let changes: Vec<(usize, usize, f64)> = (preset.couplings.iter())
            .map(|change| (part_index(&change.source), part_index(&change.target), change.factor))
            .collect();
        let effect = learned.effect(model, scale(&model.model.alpha, &changes), preset.reading);
        let couplings: Vec<String> = (preset.couplings.iter())
            .map(|change| format!("{} to {} x {}", change.source, change.target, change.factor))
            .collect();
        let reading = if preset.reading == Reading::AsLearned { "as learned" } else { "re-inferred" };
        let [hands, feet] = effect.periods().map(number);
        println!(
            "| {} | {reading} | {} | {:.2} | {:.2} | {} | {hands} | {feet} | {:.2} | {} |",
            preset.name,
            if couplings.is_empty() { "as learned".to_owned() } else { couplings.join(", ") },
            effect.hands,
            effect.feet,
            number(effect.locking),
            effect.measures.walking_speed,
            health_text(&effect.health),
        );
    }
    println!();
}
