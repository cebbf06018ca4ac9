//! Splits as users write them, with joints by name or by index.

use crate::json::place;
use crate::motion::parts::spec::{PartSpec, PartsError, check};
use crate::motion::skeleton::Skeleton;
use serde::Deserialize;

/// A part as a user gives it.
pub struct GivenPart {
    /// Its name.
    pub name: String,
    /// Its joints.
    pub joints: Vec<GivenJoint>,
}

/// A joint as a user gives it.
pub enum GivenJoint {
    /// By its name.
    Name(String),
    /// By another value.
    Other {
        /// The index, counted from 0, if the value is one.
        index: Option<usize>,
        /// The value for an error.
        shown: String,
    },
}

/// The parts with the indices of their joints. Every joint must be in one part.
///
/// # Errors
///
/// A [`PartsError`] for a joint that the skeleton does not have, or a split that [`check`] refuses.
pub fn from_given(entries: Vec<GivenPart>, skeleton: &Skeleton) -> Result<Vec<PartSpec>, PartsError> {
    let mut parts = Vec::with_capacity(entries.len());
    for (part, entry) in entries.into_iter().enumerate() {
        let mut joints = Vec::with_capacity(entry.joints.len());
        for (at, joint) in entry.joints.iter().enumerate() {
            let joint = find_joint(joint, skeleton).map_err(|expected| PartsError::UnknownJoint {
                part: part + 1,
                name: entry.name.clone(),
                entry: at + 1,
                expected,
                found: match joint {
                    GivenJoint::Name(name) => format!("{name:?}"),
                    GivenJoint::Other { shown, .. } => shown.clone(),
                },
            })?;
            joints.push(joint);
        }
        parts.push(PartSpec { name: entry.name, joints });
    }
    check(&parts, skeleton)?;
    Ok(parts)
}

/// Reads a split: `[{"name": "legs", "joints": ["LeftUpLeg", 3]}, ...]` with joints by name or
/// by index (counted from 0). Every joint must be in one part.
///
/// # Errors
///
/// A [`PartsError`] for a text that is not such a list, a joint that the skeleton does not have, or a split
/// that [`check`] refuses.
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
    let entries = entries.map_err(|error| problem(place(error.path()), error.inner()))?;
    reader.end().map_err(|error| problem("the end".to_owned(), &error))?;
    let given = |entry: Entry| {
        let joint = |value: serde_json::Value| match value {
            serde_json::Value::String(name) => GivenJoint::Name(name),
            other => GivenJoint::Other {
                index: other.as_u64().and_then(|index| usize::try_from(index).ok()),
                shown: other.to_string(),
            },
        };
        GivenPart { name: entry.name, joints: entry.joints.into_iter().map(joint).collect() }
    };
    from_given(entries.into_iter().map(given).collect(), skeleton)
}

/// The index of a joint given by name or number, or the expectation that it does not meet.
fn find_joint(given: &GivenJoint, skeleton: &Skeleton) -> Result<usize, String> {
    let last = skeleton.joints.len() - 1;
    let name = match given {
        GivenJoint::Name(name) => name.as_str(),
        GivenJoint::Other { index, .. } => {
            let expected = || format!("the name of a joint or a number from 0 to {last}");
            return index.filter(|&index| index <= last).ok_or_else(expected);
        }
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
