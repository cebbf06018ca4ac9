//! What `vcgpdm train --columns` trains on: CSV files.

use crate::files;
use crate::numbers::check_within;
use crate::usage::usage;
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm::models::Dataset;
use vcgpdm::motion::parts::PartSpec;
use vcgpdm::series::{Columns, SeriesError, Table, parts_from_json, parts_from_words, read, whole};

/// The tables as a data set, and its parts. `split` is what `--parts` says; `rate` are the rows a second of
/// files without times.
pub fn dataset(paths: &[PathBuf], split: &str, rate: f64) -> Result<Dataset<Columns>, Box<dyn Error>> {
    check_within("--fps", "rows a second", 0.1..=100_000.0, rate)?;
    let tables = paths.iter().map(|path| table(path)).collect::<Result<Vec<_>, _>>()?;
    let parts = parts(split, &tables[0].columns)?;
    Ok(Dataset::of_tables(&tables, &parts, rate)?)
}

fn table(path: &Path) -> Result<Table, Box<dyn Error>> {
    let bytes = files::read_bytes(path)?;
    Ok(read(&files::read_name(path), &bytes)?)
}

/// The parts that `--parts` asks for.
fn parts(asked: &str, columns: &[String]) -> Result<Vec<PartSpec>, Box<dyn Error>> {
    if asked == "whole" {
        return Ok(whole(columns.len()));
    }
    let path = Path::new(asked);
    if !asked.contains('=') || path.exists() {
        let text = files::read_text(path)?;
        return parts_from_json(&text, columns).map_err(|error| files::with_path(path, &error));
    }
    parts_from_words(asked, columns).map_err(|error: SeriesError| usage(format!("--parts {asked}: {error}")))
}
