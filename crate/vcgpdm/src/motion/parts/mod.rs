//! Named groups of joints, and the columns of Y that belong to each.

mod presets;
#[cfg(test)]
mod tests;

pub use presets::presets;

use crate::motion::pose::PoseMapping;
use crate::motion::skeleton::Skeleton;
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A part: joints that share a latent space.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PartSpec {
    /// Its name, e.g. "left arm".
    pub name: String,
    /// The places of its joints in the skeleton.
    pub joints: Vec<usize>,
}

/// A way to split a body.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PartsPreset {
    /// "whole", "lower-upper" or "legs-trunk-arms".
    pub id: String,
    /// What to call it on a page.
    pub title: String,
    /// The parts; each joint is in one of them.
    pub parts: Vec<PartSpec>,
}

/// Why a split is none.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PartsError {
    /// No part at all.
    #[error("expected at least one part, found none")]
    NoParts,
    /// A part without joints.
    #[error("part {part} ({name:?}): expected at least one joint, found none")]
    EmptyPart {
        /// Counted from 1.
        part: usize,
        /// Its name.
        name: String,
    },
    /// A name that is empty, or that two parts have.
    #[error("part {part}: expected a name of its own, found {name:?}")]
    PartName {
        /// Counted from 1.
        part: usize,
        /// Its name.
        name: String,
    },
    /// A joint that the skeleton does not have.
    #[error("part {part} ({name:?}), joint {entry}: expected {expected}, found {found}")]
    UnknownJoint {
        /// Counted from 1.
        part: usize,
        /// Its name.
        name: String,
        /// The entry among its joints, counted from 1.
        entry: usize,
        /// What could stand there.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// Joints that are in more than one part, or twice in one.
    #[error("expected each joint in one part, found {0} more than once")]
    Doubled(String),
    /// Joints that are in no part.
    #[error("expected each joint in one part, found no part for {0}")]
    Missing(String),
    /// A text that is no list of parts.
    #[error(
        "expected a list like [{{\"name\": \"legs\", \"joints\": [\"LeftUpLeg\", 3]}}], found at {path}: {problem}"
    )]
    Json {
        /// Where in the text.
        path: String,
        /// What the JSON reader says.
        problem: String,
    },
}

/// Reads a split made by hand: `[{"name": "legs", "joints": ["LeftUpLeg", 3]}, ...]` with joints by name or by place
/// (counted from 0). Every joint has to be in one part.
pub fn from_json(text: &str, skeleton: &Skeleton) -> Result<Vec<PartSpec>, PartsError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Entry {
        name: String,
        joints: Vec<serde_json::Value>,
    }
    let mut reader = serde_json::Deserializer::from_str(text);
    let entries: Result<Vec<Entry>, _> = serde_path_to_error::deserialize(&mut reader);
    let problem =
        |path: String, error: &serde_json::Error| PartsError::Json { path, problem: error.to_string() };
    let entries = entries.map_err(|error| problem(error.path().to_string(), error.inner()))?;
    reader.end().map_err(|error| problem("the end".to_owned(), &error))?;
    let mut parts = Vec::with_capacity(entries.len());
    for (part, entry) in entries.into_iter().enumerate() {
        let mut joints = Vec::with_capacity(entry.joints.len());
        for (at, joint) in entry.joints.iter().enumerate() {
            let joint = find_joint(joint, skeleton).map_err(|expected| PartsError::UnknownJoint {
                part: part + 1,
                name: entry.name.clone(),
                entry: at + 1,
                expected,
                found: joint.to_string(),
            })?;
            joints.push(joint);
        }
        parts.push(PartSpec { name: entry.name, joints });
    }
    check(&parts, skeleton)?;
    Ok(parts)
}

/// The place of a joint given by name or number, or what was expected instead.
fn find_joint(value: &serde_json::Value, skeleton: &Skeleton) -> Result<usize, String> {
    let last = skeleton.joints.len() - 1;
    let Some(name) = value.as_str() else {
        let place = value.as_u64().and_then(|place| usize::try_from(place).ok());
        return place
            .filter(|&place| place <= last)
            .ok_or(format!("the name of a joint or a number from 0 to {last}"));
    };
    let places = |same: &dyn Fn(&str) -> bool| -> Vec<usize> {
        (0..=last).filter(|&place| same(&skeleton.joints[place].name)).collect()
    };
    let exact = places(&|joint| joint == name);
    let found = if exact.is_empty() { places(&|joint| joint.eq_ignore_ascii_case(name)) } else { exact };
    match found[..] {
        [place] => Ok(place),
        [] => Err(format!("the name of one of the skeleton's {} joints", last + 1)),
        _ => Err(format!("a number, as {} joints have this name ({found:?})", found.len())),
    }
}

/// Checks that every joint is in exactly one part, and that every part has joints and a name of its own.
pub fn check(parts: &[PartSpec], skeleton: &Skeleton) -> Result<(), PartsError> {
    if parts.is_empty() {
        return Err(PartsError::NoParts);
    }
    let mut uses = vec![0_usize; skeleton.joints.len()];
    for (at, part) in parts.iter().enumerate() {
        let (number, name) = (at + 1, part.name.clone());
        if part.name.trim().is_empty() || parts[..at].iter().any(|other| other.name == part.name) {
            return Err(PartsError::PartName { part: number, name });
        }
        if part.joints.is_empty() {
            return Err(PartsError::EmptyPart { part: number, name });
        }
        for (entry, &joint) in part.joints.iter().enumerate() {
            let Some(count) = uses.get_mut(joint) else {
                return Err(PartsError::UnknownJoint {
                    part: number,
                    name,
                    entry: entry + 1,
                    expected: format!("a number from 0 to {}", skeleton.joints.len() - 1),
                    found: joint.to_string(),
                });
            };
            *count += 1;
        }
    }
    let names = |wanted: &dyn Fn(usize) -> bool| -> Option<String> {
        let joints: Vec<usize> = (0..uses.len()).filter(|&joint| wanted(uses[joint])).collect();
        let shown =
            joints.iter().take(8).map(|&joint| format!("{:?} ({joint})", skeleton.joints[joint].name));
        let mut text = shown.collect::<Vec<_>>().join(", ");
        if joints.len() > 8 {
            text += &format!(" and {} more", joints.len() - 8);
        }
        (!joints.is_empty()).then_some(text)
    };
    if let Some(doubled) = names(&|uses| uses > 1) {
        return Err(PartsError::Doubled(doubled));
    }
    names(&|uses| uses == 0).map_or(Ok(()), |missing| Err(PartsError::Missing(missing)))
}

/// Which columns of Y belong to which part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartsLayout {
    parts: Vec<PartSpec>,
    columns: Vec<Vec<usize>>,
}

impl PartsLayout {
    /// The columns of each part, in their order in Y.
    pub fn new(parts: &[PartSpec], mapping: &PoseMapping) -> Result<PartsLayout, PartsError> {
        check(parts, mapping.skeleton())?;
        let all = mapping.columns();
        let columns = (parts.iter())
            .map(|part| (0..all.len()).filter(|&column| part.joints.contains(&all[column].joint)).collect())
            .collect();
        Ok(PartsLayout { parts: parts.to_vec(), columns })
    }

    /// The parts.
    pub fn parts(&self) -> &[PartSpec] {
        &self.parts
    }

    /// The columns of a part in Y; none for a part that is not there.
    pub fn columns(&self, part: usize) -> &[usize] {
        self.columns.get(part).map_or(&[], Vec::as_slice)
    }

    /// Y [frames x columns] taken apart: Y^i [frames x columns of part i] for each part.
    pub fn split(&self, y: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        self.columns.iter().map(|columns| y.select_columns(columns)).collect()
    }
}
