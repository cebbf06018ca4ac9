//! Libraries of primitives, for the commands that read them.

use crate::files;
use serde_json::{Map, Value};
use std::error::Error;
use std::path::Path;
use vcgpdm_core::models::library::TrainedLibrary;

/// Reads a library.
pub fn read(path: &Path) -> Result<TrainedLibrary, Box<dyn Error>> {
    TrainedLibrary::from_json(&files::read_text(path)?).map_err(|error| files::with_path(path, &error))
}

/// The names of the primitives that a movement uses, by part.
pub fn primitives_by_part(library: &TrainedLibrary, uses: &[usize]) -> Map<String, Value> {
    let parts = library.body.layout.parts().iter().zip(uses);
    let primitives = &library.library.primitives;
    parts.map(|(part, index)| (part.name.clone(), primitives[*index].name.clone().into())).collect()
}
