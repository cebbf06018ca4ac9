//! The parts of a body, and a hint for clips of different bodies.

use crate::files;
use crate::usage::usage;
use std::error::Error;
use std::path::Path;
use vcgpdm_core::models::DatasetError;
use vcgpdm_core::motion::parts::PartSpec;
use vcgpdm_core::motion::{Skeleton, parts};

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
    if let Some(parts) = parts::preset_parts(text, skeleton) {
        return Ok(parts);
    }
    let path = Path::new(text);
    if path.exists() {
        return parts::from_json(&files::read_text(path)?, skeleton)
            .map_err(|error| files::with_path(path, &error));
    }
    let splits = parts::preset_names(skeleton);
    Err(usage(format!("--parts {text}: expected whole, a file, or a split of this body ({splits})")))
}
