//! The parts of a body, and a hint for clips of different bodies.

use crate::files;
use crate::usage::usage;
use std::error::Error;
use std::path::Path;
use vcgpdm::models::DatasetError;
use vcgpdm::motion::parts::PartSpec;
use vcgpdm::motion::{Skeleton, parts};

/// The reason, with a hint if only the bones differ.
pub fn with_hint(reason: DatasetError) -> Box<dyn Error> {
    match &reason {
        DatasetError::Body { reason: body, .. } if body.only_bones_differ() => {
            format!("{reason}; --first-bones gives all clips the bones of the first").into()
        }
        _ => reason.into(),
    }
}

/// The parts of `--parts`.
pub fn parts(text: &str, skeleton: &Skeleton) -> Result<Vec<PartSpec>, Box<dyn Error>> {
    let presets = parts::presets(skeleton);
    if let Some(preset) = presets.iter().find(|preset| preset.id == text) {
        return Ok(preset.parts.clone());
    }
    // Names of the parts, in the order of the parts of the model.
    let names: Vec<&str> = text.split(',').map(str::trim).collect();
    for preset in presets.iter().filter(|preset| preset.parts.len() == names.len()) {
        let chosen: Option<Vec<PartSpec>> =
            names.iter().map(|name| preset.parts.iter().find(|part| part.name == *name).cloned()).collect();
        if let Some(chosen) =
            chosen.filter(|_| names.iter().all(|a| names.iter().filter(|b| a == *b).count() == 1))
        {
            return Ok(chosen);
        }
    }
    let path = Path::new(text);
    if path.exists() {
        return parts::from_json(&files::read_text(path)?, skeleton)
            .map_err(|error| files::with_path(path, &error));
    }
    let splits: Vec<String> = presets
        .iter()
        .map(|preset| preset.parts.iter().map(|part| part.name.as_str()).collect::<Vec<_>>().join(","))
        .collect();
    Err(usage(format!(
        "--parts {text}: expected whole, a file, or a split of this body ({})",
        splits.join("; ")
    )))
}
