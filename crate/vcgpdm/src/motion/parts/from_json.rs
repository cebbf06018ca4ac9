//! Reads a split that a user wrote as JSON.

use crate::json::place;
use crate::motion::parts::spec::{PartSpec, PartsError, check};
use crate::motion::skeleton::Skeleton;
use serde::Deserialize;

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

/// The index of a joint given by name or number, or the expectation that it does not meet.
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
