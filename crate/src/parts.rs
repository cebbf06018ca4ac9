//! Named groups of joints, and the columns of Y that belong to each.

use crate::anatomy::{Anatomy, Region};
use crate::joint_names::{Side, looks_like_spine};
use crate::pose::PoseMapping;
use crate::skeleton::Skeleton;
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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
    /// Columns or frames that do not fit together.
    #[error("part {part}: expected {expected}, found {found}")]
    Shape {
        /// Counted from 1.
        part: usize,
        /// What should be.
        expected: String,
        /// What is.
        found: String,
    },
}

/// The ways to split a body that its joints' names, or else its shape, tell: always "whole"; "lower-upper" where legs were
/// found; "legs-trunk-arms" where arms were found too.
pub fn presets(skeleton: &Skeleton) -> Vec<PartsPreset> {
    let all: Vec<usize> = (0..skeleton.joints.len()).collect();
    let mut presets = vec![preset("whole", "Whole body", vec![("body", all)])];
    let Some(anatomy) = Anatomy::of(skeleton) else { return presets };
    let leg = |region: Region| matches!(region, Region::Leg(_));
    let hips = hips(skeleton, &anatomy);
    let joints = |wanted: &dyn Fn(usize) -> bool| -> Vec<usize> {
        (0..skeleton.joints.len()).filter(|&joint| wanted(joint)).collect()
    };
    let lower = joints(&|joint| hips[joint] || leg(anatomy.regions[joint]));
    let upper = joints(&|joint| !lower.contains(&joint));
    if upper.is_empty() {
        return presets;
    }
    presets.push(preset(
        "lower-upper",
        "Lower and upper body",
        vec![("lower", lower.clone()), ("upper", upper)],
    ));
    if anatomy.has_both_arms() {
        let trunk = joints(&|joint| anatomy.regions[joint] == Region::Trunk && !lower.contains(&joint));
        let parts = vec![
            ("legs", lower.clone()),
            ("trunk", trunk),
            ("left arm", anatomy.joints(Region::Arm(Side::Left))),
            ("right arm", anatomy.joints(Region::Arm(Side::Right))),
        ];
        // A body whose arms hang on its hips has no trunk to speak of.
        let parts = parts.into_iter().filter(|(_, joints)| !joints.is_empty()).collect();
        presets.push(preset("legs-trunk-arms", "Legs, trunk, left arm, right arm", parts));
    }
    presets
}

fn preset(id: &str, title: &str, parts: Vec<(&str, Vec<usize>)>) -> PartsPreset {
    let spec = |(name, joints): (&str, Vec<usize>)| PartSpec { name: name.to_owned(), joints };
    PartsPreset { id: id.to_owned(), title: title.to_owned(), parts: parts.into_iter().map(spec).collect() }
}

/// The root, and what lies between it and the legs unless it is called a part of the back.
fn hips(skeleton: &Skeleton, anatomy: &Anatomy) -> Vec<bool> {
    let mut bears_legs = vec![false; skeleton.joints.len()];
    for (place, joint) in skeleton.joints.iter().enumerate().rev() {
        if let Some(parent) = joint.parent
            && (bears_legs[place] || matches!(anatomy.regions[place], Region::Leg(_)))
        {
            bears_legs[parent] = true;
        }
    }
    (skeleton.joints.iter().enumerate())
        .map(|(place, joint)| {
            place == 0
                || bears_legs[place]
                    && anatomy.regions[place] == Region::Trunk
                    && !looks_like_spine(&joint.name)
        })
        .collect()
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
    width: usize,
}

impl PartsLayout {
    /// The columns of each part, in their order in Y.
    pub fn new(parts: &[PartSpec], mapping: &PoseMapping) -> Result<PartsLayout, PartsError> {
        check(parts, mapping.skeleton())?;
        let all = mapping.columns();
        let columns = (parts.iter())
            .map(|part| (0..all.len()).filter(|&column| part.joints.contains(&all[column].joint)).collect())
            .collect();
        Ok(PartsLayout { parts: parts.to_vec(), columns, width: all.len() })
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

    /// The inverse of [`PartsLayout::split`].
    pub fn join(&self, parts: &[DMatrix<f64>]) -> Result<DMatrix<f64>, PartsError> {
        let frames = parts.first().map_or(0, DMatrix::nrows);
        let mut y = DMatrix::zeros(frames, self.width);
        for (at, columns) in self.columns.iter().enumerate() {
            let shape = parts.get(at).map(DMatrix::shape);
            if shape != Some((frames, columns.len())) || parts.len() != self.columns.len() {
                return Err(PartsError::Shape {
                    part: at + 1,
                    expected: format!(
                        "{frames} frames of {} columns, {} parts",
                        columns.len(),
                        self.columns.len()
                    ),
                    found: format!("{shape:?}, {} parts", parts.len()),
                });
            }
            for (from, &to) in columns.iter().enumerate() {
                y.set_column(to, &parts[at].column(from));
            }
        }
        Ok(y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Clip;

    /// A body as BVH text from lines "name parent x y z"; z up if asked for.
    fn body(joints: &[(&str, Option<usize>, [f64; 3])]) -> Skeleton {
        let joints = joints.iter().map(|&(name, parent, offset)| crate::Joint {
            name: name.to_owned(),
            parent,
            offset,
            channels: crate::Channel::ALL[if parent.is_none() { 0 } else { 3 }..].to_vec(),
            end_sites: Vec::new(),
        });
        let skeleton = Skeleton { joints: joints.collect() };
        skeleton.validate().unwrap();
        skeleton
    }

    /// A small body with the given names: hips, two legs of three joints, spine, head, two arms of two joints.
    fn person(names: [&str; 13]) -> Skeleton {
        body(&[
            (names[0], None, [0.0, 1.0, 0.0]),
            (names[1], Some(0), [0.1, 0.0, 0.0]),
            (names[2], Some(1), [0.0, -0.5, 0.0]),
            (names[3], Some(2), [0.0, -0.4, 0.1]),
            (names[4], Some(0), [-0.1, 0.0, 0.0]),
            (names[5], Some(4), [0.0, -0.5, 0.0]),
            (names[6], Some(5), [0.0, -0.4, 0.1]),
            (names[7], Some(0), [0.0, 0.5, 0.0]),
            (names[8], Some(7), [0.0, 0.3, 0.0]),
            (names[9], Some(7), [0.2, 0.1, 0.0]),
            (names[10], Some(9), [0.4, 0.0, 0.0]),
            (names[11], Some(7), [-0.2, 0.1, 0.0]),
            (names[12], Some(11), [-0.4, 0.0, 0.0]),
        ])
    }

    fn parts_of(skeleton: &Skeleton, id: &str) -> Vec<(String, Vec<usize>)> {
        let preset = presets(skeleton).into_iter().find(|preset| preset.id == id).unwrap();
        check(&preset.parts, skeleton).unwrap();
        preset.parts.into_iter().map(|part| (part.name, part.joints)).collect()
    }

    #[test]
    fn bodies_of_many_conventions_split_the_same() {
        let conventions = [
            [
                "Hips",
                "LeftUpLeg",
                "LeftLeg",
                "LeftFoot",
                "RightUpLeg",
                "RightLeg",
                "RightFoot",
                "Spine",
                "Head",
                "LeftArm",
                "LeftForeArm",
                "RightArm",
                "RightForeArm",
            ],
            [
                "Hips",
                "LeftHip",
                "LeftKnee",
                "LeftAnkle",
                "RightHip",
                "RightKnee",
                "RightAnkle",
                "Chest",
                "Head",
                "LeftShoulder",
                "LeftElbow",
                "RightShoulder",
                "RightElbow",
            ],
            [
                "Bip01",
                "Bip01 L Thigh",
                "Bip01 L Calf",
                "Bip01 L Foot",
                "Bip01 R Thigh",
                "Bip01 R Calf",
                "Bip01 R Foot",
                "Bip01 Spine",
                "Bip01 Head",
                "Bip01 L UpperArm",
                "Bip01 L Forearm",
                "Bip01 R UpperArm",
                "Bip01 R Forearm",
            ],
            [
                "root",
                "lfemur",
                "ltibia",
                "lfoot",
                "rfemur",
                "rtibia",
                "rfoot",
                "lowerback",
                "head",
                "lhumerus",
                "lradius",
                "rhumerus",
                "rradius",
            ],
            [
                "pelvis",
                "thigh_l",
                "calf_l",
                "foot_l",
                "thigh_r",
                "calf_r",
                "foot_r",
                "spine_01",
                "head",
                "upperarm_l",
                "lowerarm_l",
                "upperarm_r",
                "lowerarm_r",
            ],
            // No names at all: the shape tells.
            ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m"],
        ];
        for names in conventions {
            let skeleton = person(names);
            let split = parts_of(&skeleton, "legs-trunk-arms");
            let wanted = [
                ("legs", vec![0, 1, 2, 3, 4, 5, 6]),
                ("trunk", vec![7, 8]),
                ("left arm", vec![9, 10]),
                ("right arm", vec![11, 12]),
            ];
            assert_eq!(split, wanted.map(|(name, joints)| (name.to_owned(), joints)), "{names:?}");
            assert_eq!(parts_of(&skeleton, "lower-upper")[1].1, vec![7, 8, 9, 10, 11, 12]);
        }
    }

    #[test]
    fn sides_without_names_follow_the_toes() {
        // The same body turned to face -z: its left is now at -x.
        let mut skeleton = person(["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m"]);
        for joint in &mut skeleton.joints {
            joint.offset = [-joint.offset[0], joint.offset[1], -joint.offset[2]];
        }
        assert_eq!(parts_of(&skeleton, "legs-trunk-arms")[2], ("left arm".to_owned(), vec![9, 10]));
    }

    #[test]
    fn a_body_that_is_no_person_is_one_part() {
        let tail =
            body(&[("a", None, [0.0; 3]), ("b", Some(0), [0.0, 1.0, 0.0]), ("c", Some(1), [0.0, 1.0, 0.0])]);
        assert_eq!(presets(&tail).len(), 1);
        assert_eq!(parts_of(&tail, "whole"), vec![("body".to_owned(), vec![0, 1, 2])]);
    }

    #[test]
    fn a_split_by_hand_names_joints_or_counts_them() {
        let tail =
            body(&[("a", None, [0.0; 3]), ("b", Some(0), [0.0, 1.0, 0.0]), ("b", Some(1), [0.0, 1.0, 0.0])]);
        let read = |text: &str| from_json(text, &tail).map_err(|error| error.to_string());
        let parts = read(r#"[{"name": "one", "joints": ["A", 2]}, {"name": "two", "joints": [1]}]"#).unwrap();
        assert_eq!(parts[0].joints, vec![0, 2]);
        for (text, wanted) in [
            (r#"[{"name": "one", "joints": ["a", 2]}]"#, r#"no part for "b" (1)"#),
            (r#"[{"name": "one", "joints": [0, 1, 2, 1]}]"#, r#"found "b" (1) more than once"#),
            (
                r#"[{"name": "one", "joints": [0, 1, 2]}, {"name": "two", "joints": []}]"#,
                r#"part 2 ("two"): expected at least one joint"#,
            ),
            (
                r#"[{"name": "one", "joints": [0, 1]}, {"name": "one", "joints": [2]}]"#,
                r#"part 2: expected a name of its own, found "one""#,
            ),
            (
                r#"[{"name": "one", "joints": [0, "leg"]}]"#,
                r#"part 1 ("one"), joint 2: expected the name of one of the skeleton's 3 joints, found "leg""#,
            ),
            (r#"[{"name": "one", "joints": [0, "b"]}]"#, "2 joints have this name ([1, 2])"),
            (r#"[{"name": "one", "joints": [0, 1, 3]}]"#, "a number from 0 to 2, found 3"),
            (r#"[{"name": "one", "joints": [0, 1.5]}]"#, "found 1.5"),
            (r#"[{"name": "one", "joints": 3}]"#, "found at [0].joints"),
            (r#"[{"name": "one"}]"#, "missing field `joints`"),
            (r#"[] []"#, "trailing characters"),
            ("[]", "at least one part"),
            ("", "expected a list like"),
        ] {
            let message = read(text).unwrap_err();
            assert!(message.contains(wanted), "{message}");
        }
    }

    #[test]
    fn columns_split_and_join() {
        let skeleton = person(["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m"]);
        let channels = skeleton.channel_count();
        let clip = Clip::new("still", skeleton, 0.1, DMatrix::zeros(2, channels));
        let mapping = PoseMapping::new(&clip);
        let parts = vec![
            PartSpec { name: "even".to_owned(), joints: (0..13).step_by(2).collect() },
            PartSpec { name: "odd".to_owned(), joints: (1..13).step_by(2).collect() },
        ];
        let layout = PartsLayout::new(&parts, &mapping).unwrap();
        assert_eq!(layout.columns(0)[..9], [0, 1, 2, 3, 4, 5, 9, 10, 11]);
        let y = DMatrix::from_fn(4, mapping.column_count(), |row, column| (row * 100 + column) as f64);
        let split = layout.split(&y);
        assert_eq!((split[0].ncols(), split[1].ncols()), (24, 18));
        assert_eq!(layout.join(&split).unwrap(), y);
        assert!(layout.join(&split[..1]).is_err());
    }
}
