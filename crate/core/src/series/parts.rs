//! The columns of a model of tables, and splits of them into parts.

use crate::motion::parts::PartSpec;
use crate::series::error::SeriesError;
use serde::Deserialize;

/// All columns as one part.
pub fn whole(columns: usize) -> Vec<PartSpec> {
    vec![PartSpec { name: "whole".to_owned(), joints: (0..columns).collect() }]
}

/// Reads a split such as `arm=x,y;leg=z`, which lists the columns of each part. `x*` stands for all columns
/// whose names begin with `x`, and `*x` for all whose names end with it.
///
/// # Errors
///
/// A [`SeriesError::Parts`] when the text is not such a list, or a column is in no part or in two.
pub fn parse_parts(text: &str, columns: &[String]) -> Result<Vec<PartSpec>, SeriesError> {
    let mut parts = Vec::new();
    for part in text.split(';').filter(|part| !part.trim().is_empty()) {
        let (name, list) = part.split_once('=').ok_or_else(|| {
            SeriesError::Parts(format!("expected parts such as \"arm=x,y;leg=z\", found {part:?}"))
        })?;
        let named: Vec<&str> = list.split(',').map(str::trim).collect();
        parts.push(PartSpec { name: name.trim().to_owned(), joints: places(name.trim(), &named, columns)? });
    }
    check_parts(&parts, columns)?;
    Ok(parts)
}

/// Reads a split from JSON: `[{"name": "arm", "columns": ["x", "y"]}, ...]`.
///
/// # Errors
///
/// A [`SeriesError::Parts`] when the text is not such a list, or a column is in no part or in two.
pub fn parts_from_json(text: &str, columns: &[String]) -> Result<Vec<PartSpec>, SeriesError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Entry {
        name: String,
        columns: Vec<String>,
    }
    let entries: Vec<Entry> = serde_json::from_str(text).map_err(|problem| {
        SeriesError::Parts(format!(
            "expected a list like [{{\"name\": \"arm\", \"columns\": [\"x\", \"y\"]}}]: {problem}"
        ))
    })?;
    let mut parts = Vec::with_capacity(entries.len());
    for Entry { name, columns: list } in entries {
        let named: Vec<&str> = list.iter().map(String::as_str).collect();
        let joints = places(&name, &named, columns)?;
        parts.push(PartSpec { name, joints });
    }
    check_parts(&parts, columns)?;
    Ok(parts)
}

/// The indices of the named columns.
fn places(part: &str, named: &[&str], columns: &[String]) -> Result<Vec<usize>, SeriesError> {
    let mut places = Vec::new();
    for name in named {
        let found = places_of(name, columns);
        if found.is_empty() {
            return Err(SeriesError::Parts(format!(
                "part {part:?}: expected some of the columns {}, found {name:?}",
                shortened(columns)
            )));
        }
        places.extend(found);
    }
    Ok(places)
}

/// The indices of the columns with this name. `*` at its beginning or end stands for any letters.
pub(super) fn places_of(name: &str, columns: &[String]) -> Vec<usize> {
    let all = |fits: &dyn Fn(&String) -> bool| (0..columns.len()).filter(|&k| fits(&columns[k])).collect();
    if let Some(place) = columns.iter().position(|column| column == name) {
        return vec![place];
    }
    match (name.strip_suffix('*'), name.strip_prefix('*')) {
        (Some(start), _) => all(&|column| column.starts_with(start)),
        (_, Some(end)) => all(&|column| column.ends_with(end)),
        (None, None) => Vec::new(),
    }
}

/// Checks that every column is in exactly one part, and that every part has columns and a name of its own.
/// The `joints` of each [`PartSpec`] are columns.
///
/// # Errors
///
/// A [`SeriesError::Parts`] that names the wrong part or column.
pub fn check_parts(parts: &[PartSpec], columns: &[String]) -> Result<(), SeriesError> {
    let refuse = |problem: String| Err(SeriesError::Parts(problem));
    if parts.is_empty() {
        return refuse("expected at least one part, found none".to_owned());
    }
    let mut uses = vec![0_usize; columns.len()];
    for (k, part) in parts.iter().enumerate() {
        if part.name.trim().is_empty() || parts[..k].iter().any(|other| other.name == part.name) {
            return refuse(format!("part {}: expected a name of its own, found {:?}", k + 1, part.name));
        }
        if part.joints.is_empty() {
            return refuse(format!("part {:?}: expected at least one column, found none", part.name));
        }
        for &place in &part.joints {
            match uses.get_mut(place) {
                Some(count) => *count += 1,
                None => {
                    let last = columns.len().saturating_sub(1);
                    return refuse(format!(
                        "part {:?}: expected columns from 0 to {last}, found {place}",
                        part.name
                    ));
                }
            }
        }
    }
    let names = |wrong: &dyn Fn(usize) -> bool| -> Vec<String> {
        columns.iter().zip(&uses).filter(|(_, uses)| wrong(**uses)).map(|(name, _)| name.clone()).collect()
    };
    let (missing, repeated) = (names(&|uses| uses == 0), names(&|uses| uses > 1));
    if !repeated.is_empty() {
        return refuse(format!(
            "expected each column in one part, found {} more than once",
            shortened(&repeated)
        ));
    }
    if !missing.is_empty() {
        return refuse(format!(
            "expected each column in one part, found no part for {}",
            shortened(&missing)
        ));
    }
    Ok(())
}

pub(super) fn shortened(names: &[String]) -> String {
    let first: Vec<&str> = names.iter().take(8).map(String::as_str).collect();
    let more = names.len().saturating_sub(8);
    if more > 0 { format!("{} and {more} more", first.join(", ")) } else { first.join(", ") }
}

/// The columns of tables: their names and units.
///
/// A model divides each column by its unit, the standard deviation, because all columns of a part have one
/// noise variance. Otherwise the weight of a column would depend on its physical unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    pub(crate) names: Vec<String>,
    pub(crate) units: Vec<f64>,
}

impl Columns {
    /// Columns with these names and as many positive units.
    #[doc(hidden)]
    pub fn new(names: Vec<String>, units: Vec<f64>) -> Self {
        Self { names, units }
    }

    /// The names, in the order of the columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The unit of each column: its standard deviation over all training frames, or 1 for a constant column.
    pub fn units(&self) -> &[f64] {
        &self.units
    }
}
