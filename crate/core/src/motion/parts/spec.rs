//! A part, the conditions for a valid split into parts, and the columns of Y that belong to each.

use crate::motion::pose::PoseMapping;
use crate::motion::skeleton::Skeleton;
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A part is a named group of joints that move together, by their place in the skeleton.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PartSpec {
    /// Its name, e.g. "left arm".
    pub name: String,
    /// The indices of its joints in the skeleton; for a part of a table, those of its columns.
    pub joints: Vec<usize>,
}

/// Why a split of a body into parts is invalid.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum PartsError {
    /// No part at all.
    #[error("expected at least one part, found none")]
    NoParts,
    /// A part without joints.
    #[error("part {part} ({name:?}): expected at least one joint, found none")]
    EmptyPart {
        /// The number of the part, counted from 1.
        part: usize,
        /// The name of the part.
        name: String,
    },
    /// An empty name, or a name that two parts have.
    #[error("part {part}: expected a name of its own, found {name:?}")]
    PartName {
        /// The number of the part, counted from 1.
        part: usize,
        /// The name of the part.
        name: String,
    },
    /// A joint that the skeleton does not have.
    #[error("part {part} ({name:?}), joint {entry}: expected {expected}, found {found}")]
    UnknownJoint {
        /// The number of the part, counted from 1.
        part: usize,
        /// The name of the part.
        name: String,
        /// The entry among its joints, counted from 1.
        entry: usize,
        /// What was expected.
        expected: String,
        /// What was found.
        found: String,
    },
    /// Joints that are in more than one part, or twice in one part.
    #[error("expected each joint in one part, found {0} more than once")]
    Doubled(String),
    /// Joints that are in no part.
    #[error("expected each joint in one part, found no part for {0}")]
    Missing(String),
    /// A text that is not a list of parts.
    #[error(
        "expected a list like [{{\"name\": \"legs\", \"joints\": [\"LeftUpLeg\", 3]}}], found at {path}: \
         {problem}"
    )]
    Json {
        /// The path of the wrong entry.
        path: String,
        /// The message of the JSON reader.
        problem: String,
    },
}

/// Checks that every joint is in exactly one part, and that every part has joints and a name of its own.
///
/// # Errors
///
/// A [`PartsError`] about the first part that is wrong, or the joints that are in no part or in several.
pub fn check(parts: &[PartSpec], skeleton: &Skeleton) -> Result<(), PartsError> {
    if parts.is_empty() {
        return Err(PartsError::NoParts);
    }
    let mut uses = vec![0_usize; skeleton.joints.len()];
    for (index, part) in parts.iter().enumerate() {
        let (number, name) = (index + 1, part.name.clone());
        if part.name.trim().is_empty() || parts[..index].iter().any(|other| other.name == part.name) {
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
        let first =
            joints.iter().take(8).map(|&joint| format!("{:?} ({joint})", skeleton.joints[joint].name));
        let mut text = first.collect::<Vec<_>>().join(", ");
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

crate::coded!(PartsError => Parts);

/// Which columns of Y belong to which part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartsLayout {
    parts: Vec<PartSpec>,
    columns: Vec<Vec<usize>>,
}

impl PartsLayout {
    /// The layout for these parts of the mapping's body.
    ///
    /// # Errors
    ///
    /// When a column has no part or two parts, or a part has no column.
    pub fn new(parts: &[PartSpec], mapping: &PoseMapping) -> Result<PartsLayout, PartsError> {
        check(parts, mapping.skeleton())?;
        let mapped = mapping.columns();
        let columns = (parts.iter())
            .map(|part| {
                (0..mapped.len()).filter(|&column| part.joints.contains(&mapped[column].joint)).collect()
            })
            .collect();
        Ok(PartsLayout { parts: parts.to_vec(), columns })
    }

    /// The layout of the parts of a table, whose `joints` are columns.
    pub fn for_table(parts: &[PartSpec]) -> PartsLayout {
        let sorted = |part: &PartSpec| {
            let mut columns = part.joints.clone();
            columns.sort_unstable();
            columns
        };
        PartsLayout { parts: parts.to_vec(), columns: parts.iter().map(sorted).collect() }
    }

    /// The parts, in their order.
    pub fn parts(&self) -> &[PartSpec] {
        &self.parts
    }

    /// The columns of a part in Y, ascending; empty for a part that does not exist.
    pub fn columns(&self, part: usize) -> &[usize] {
        self.columns.get(part).map_or(&[], Vec::as_slice)
    }

    /// Splits Y [frames x columns] into Y^i [frames x columns of part i], one for each part.
    pub fn split(&self, y: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        self.columns.iter().map(|columns| y.select_columns(columns)).collect()
    }
}
