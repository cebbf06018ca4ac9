//! The clips that ship with the page. They are made here, not stored: a procedural walker built from published gait curves
//! and body proportions, several trials of two movements, each with natural variation. The same on every machine.

mod body;
mod gait;
mod variation;
mod walker;

use crate::clip::Clip;
use serde::Serialize;
use walker::Arms;

/// A clip that this project makes itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct SampleInfo {
    /// What [`clip`] knows it by.
    pub id: &'static str,
    /// For a person to read.
    pub title: &'static str,
    /// What the walker does: "walk" or "walk and wave". Trials of one movement belong together.
    pub movement: &'static str,
}

struct Recipe {
    info: SampleInfo,
    arms: Arms,
    seed: u64,
    seconds: f64,
}

const fn walk(id: &'static str, title: &'static str, seed: u64, seconds: f64) -> Recipe {
    Recipe { info: SampleInfo { id, title, movement: "walk" }, arms: Arms::Swing, seed, seconds }
}

const fn wave(id: &'static str, title: &'static str, seed: u64, seconds: f64) -> Recipe {
    Recipe { info: SampleInfo { id, title, movement: "walk and wave" }, arms: Arms::Wave, seed, seconds }
}

const RECIPES: [Recipe; 10] = [
    walk("walk-1", "Walk, trial 1", 1, 4.2),
    walk("walk-2", "Walk, trial 2", 2, 3.9),
    walk("walk-3", "Walk, trial 3", 3, 4.4),
    walk("walk-4", "Walk, trial 4", 4, 4.0),
    walk("walk-5", "Walk, trial 5", 5, 3.7),
    walk("walk-6", "Walk, trial 6", 6, 4.3),
    wave("walk-wave-1", "Walk and wave, trial 1", 11, 4.1),
    wave("walk-wave-2", "Walk and wave, trial 2", 12, 4.3),
    wave("walk-wave-3", "Walk and wave, trial 3", 13, 3.8),
    wave("walk-wave-4", "Walk and wave, trial 4", 14, 4.0),
];

/// All sample clips, in the order of the movements and trials.
pub fn list() -> Vec<SampleInfo> {
    RECIPES.iter().map(|recipe| recipe.info).collect()
}

/// Makes a sample clip (60 frames a second, centimetres, y up); `None` when there is none of that id.
pub fn clip(id: &str) -> Option<Clip> {
    let recipe = RECIPES.iter().find(|recipe| recipe.info.id == id)?;
    let mut clip = walker::walk(recipe.arms, recipe.seed, recipe.seconds);
    clip.name = format!("{id} (made by this project).bvh");
    Some(clip)
}
