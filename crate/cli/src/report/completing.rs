//! The tables of `vcgpdm evaluate --task complete`.

use crate::files;
use crate::report::one_line::one_line;
use serde::Deserialize;
use serde_json::json;
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm_lab::completing::{Completing, tables};

/// The outermost field that names a document.
#[derive(Deserialize)]
struct Document {
    format: String,
}

/// Whether a file has results of completing. A damaged file has none, and stdin can be read only once.
pub fn is_completing(path: &Path) -> Result<bool, Box<dyn Error>> {
    if files::is_standard(path) {
        return Ok(false);
    }
    let document = serde_json::from_str::<Document>(&files::read_text(path)?);
    Ok(document.is_ok_and(|document| document.format == Completing::FORMAT))
}

/// Reads results of completing.
pub fn read(path: &Path) -> Result<Completing, Box<dyn Error>> {
    Completing::from_json(&files::read_text(path)?).map_err(|error| files::with_path(path, &error))
}

/// Prints the tables of these files, each of which has its own trials, or all their numbers as JSON.
pub fn print(paths: &[PathBuf], as_json: bool) -> Result<(), Box<dyn Error>> {
    let all = paths.iter().map(|path| {
        let name = path.file_stem().map(|stem| one_line(&stem.to_string_lossy()));
        Ok((name.unwrap_or_default(), read(path)?))
    });
    let all: Vec<(String, Completing)> = all.collect::<Result<_, Box<dyn Error>>>()?;
    if as_json {
        let subjects = all.iter().map(|(name, results)| json!({ "name": name, "completing": results }));
        return files::print_json(&json!({ "subjects": subjects.collect::<Vec<_>>() }));
    }
    let all: Vec<(String, &Completing)> = all.iter().map(|(name, results)| (name.clone(), results)).collect();
    files::print(&files::escape(&tables(&all)))
}
