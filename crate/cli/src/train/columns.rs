//! `vcgpdm train --columns`: data from CSV files.

use crate::files;
use crate::numbers::check_within;
use crate::usage::usage;
use std::error::Error;
use std::path::{Path, PathBuf};
use vcgpdm_core::models::Dataset;
use vcgpdm_core::motion::parts::PartSpec;
use vcgpdm_core::series::{Columns, SeriesError, Table, parse_parts, parts_from_json, read, whole};

/// The tables as a data set. `split` is the value of `--parts`; `rate` is the number of rows a second of
/// files without times; the columns of `without` are left out.
pub fn dataset(
    paths: &[PathBuf],
    split: &str,
    without: &[String],
    rate: f64,
) -> Result<Dataset<Columns>, Box<dyn Error>> {
    check_within("--fps", "rows a second", 0.1..=100_000.0, rate)?;
    let without: Vec<&str> = without.iter().map(|name| name.trim()).collect();
    let tables = paths.iter().map(|path| table(path, &without)).collect::<Result<Vec<_>, _>>()?;
    let parts = parts(split, &tables[0].columns)?;
    Ok(Dataset::of_tables(&tables, &parts, rate)?)
}

fn table(path: &Path, without: &[&str]) -> Result<Table, Box<dyn Error>> {
    let bytes = files::read_bytes(path)?;
    read(&files::read_name(path), &bytes)?
        .without(without)
        .map_err(|error| usage(format!("--without: {error}")))
}

/// The parts of `--parts`.
fn parts(text: &str, columns: &[String]) -> Result<Vec<PartSpec>, Box<dyn Error>> {
    if text == "whole" {
        return Ok(whole(columns.len()));
    }
    let path = Path::new(text);
    if !text.contains('=') || path.exists() {
        return parts_from_json(&files::read_text(path)?, columns)
            .map_err(|error| files::with_path(path, &error));
    }
    parse_parts(text, columns).map_err(|error: SeriesError| usage(format!("--parts {text}: {error}")))
}
