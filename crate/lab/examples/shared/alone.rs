//! Clips that are trained on each alone, in several splits of the body.

#[path = "clips.rs"]
mod clips;

use clips::read_clips;
use std::path::PathBuf;
use vcgpdm::models::{Dataset, Source};
use vcgpdm::motion::{Clip, parts, samples};

pub const FRAMES_PER_SECOND: f64 = 30.0;

/// The data of one clip in one split, the preset of this id.
pub struct Alone {
    pub clip: String,
    pub preset: String,
    pub dataset: Dataset,
}

/// Each clip, by default the first bundled walk, in each of these splits that its skeleton has.
pub fn alone(places: &[PathBuf], presets: &[String]) -> Vec<Alone> {
    let mut clips: Vec<Clip> = read_clips(places).collect();
    if clips.is_empty() {
        clips.push(samples::clip("walk-1").unwrap());
    }
    let mut all = Vec::new();
    for clip in &clips {
        let known = parts::presets(&clip.skeleton);
        for chosen in presets.iter().filter_map(|id| known.iter().find(|preset| preset.id == *id)) {
            let dataset =
                Dataset::new(&[Source { clip, first_frames: None }], &chosen.parts, FRAMES_PER_SECOND);
            all.push(Alone { clip: clip.name.clone(), preset: chosen.id.clone(), dataset: dataset.unwrap() });
        }
    }
    all
}
