//! Splits of bodies with and without names.

use super::*;
use crate::motion::clip::Clip;
use crate::motion::pose::PoseMapping;
use crate::motion::skeleton::Skeleton;
use nalgebra::DMatrix;

/// A body of joints (name, parent, offset).
fn body(joints: &[(&str, Option<usize>, [f64; 3])]) -> Skeleton {
    let joints = joints.iter().map(|&(name, parent, offset)| crate::motion::skeleton::Joint {
        name: name.to_owned(),
        parent,
        offset,
        channels: crate::motion::skeleton::Channel::ALL[if parent.is_none() { 0 } else { 3 }..].to_vec(),
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
fn bodies_of_many_naming_conventions_have_the_same_parts() {
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
        // Names without meaning: the parts follow from the shape.
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
        let body_and_arms = parts_of(&skeleton, "body-arms");
        assert_eq!(body_and_arms[0], ("body".to_owned(), vec![0, 1, 2, 3, 4, 5, 6, 7, 8]), "{names:?}");
        assert_eq!(body_and_arms[1..], split[2..]);
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
fn a_body_with_one_arm_has_no_parts_for_arms() {
    let one_armed = body(&[
        ("Hips", None, [0.0, 90.0, 0.0]),
        ("LeftUpLeg", Some(0), [10.0, 0.0, 0.0]),
        ("LeftFoot", Some(1), [0.0, -80.0, 0.0]),
        ("RightUpLeg", Some(0), [-10.0, 0.0, 0.0]),
        ("RightFoot", Some(3), [0.0, -80.0, 0.0]),
        ("Spine", Some(0), [0.0, 20.0, 0.0]),
        ("LeftArm", Some(5), [20.0, 20.0, 0.0]),
        ("LeftHand", Some(6), [40.0, 0.0, 0.0]),
    ]);
    let ids: Vec<String> = presets(&one_armed).into_iter().map(|preset| preset.id).collect();
    assert_eq!(ids, ["whole", "lower-upper"]);
}

#[test]
fn a_body_that_is_no_person_is_one_part() {
    let tail =
        body(&[("a", None, [0.0; 3]), ("b", Some(0), [0.0, 1.0, 0.0]), ("c", Some(1), [0.0, 1.0, 0.0])]);
    assert_eq!(presets(&tail).len(), 1);
    assert_eq!(parts_of(&tail, "whole"), vec![("body".to_owned(), vec![0, 1, 2])]);
}

#[test]
fn a_split_as_json_has_joints_by_name_or_index() {
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
        ("", "found at the top of the document: EOF"),
        (r#"{"name": "one"}"#, "found at the top of the document: invalid type: map"),
    ] {
        let message = read(text).unwrap_err();
        assert!(message.contains(wanted), "{message}");
    }
}

#[test]
fn an_error_names_eight_joints_that_are_in_no_part() {
    let names: Vec<String> = (0..10).map(|joint| format!("j{joint}")).collect();
    let joints: Vec<_> =
        (0..10_usize).map(|joint| (names[joint].as_str(), joint.checked_sub(1), [0.0, 1.0, 0.0])).collect();
    let error = |joints_in: Vec<usize>| {
        let part = PartSpec { name: "some".to_owned(), joints: joints_in };
        check(&[part], &body(&joints)).unwrap_err().to_string()
    };
    let eight = error(vec![0, 1]);
    assert!(eight.contains("\"j9\" (9)") && !eight.contains("more"), "{eight}");
    let nine = error(vec![0]);
    assert!(nine.contains("\"j8\" (8) and 1 more"), "{nine}");
}

#[test]
fn each_part_gets_its_columns_in_their_order() {
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
    for (part, rows) in split.iter().enumerate() {
        for (at, &column) in layout.columns(part).iter().enumerate() {
            assert_eq!(rows.column(at), y.column(column));
        }
    }
}

/// A body whose tree begins at the head or, without the first joint, at the chest.
fn hanging(names: [&str; 12]) -> Skeleton {
    body(&[
        (names[0], None, [0.0, 1.7, 0.0]),
        (names[1], Some(0), [0.0, -0.3, 0.0]),
        (names[2], Some(1), [0.2, 0.0, 0.0]),
        (names[3], Some(2), [0.5, 0.0, 0.0]),
        (names[4], Some(1), [-0.2, 0.0, 0.0]),
        (names[5], Some(4), [-0.5, 0.0, 0.0]),
        (names[6], Some(1), [0.0, -0.2, 0.0]),
        (names[7], Some(6), [0.0, -0.2, 0.0]),
        (names[8], Some(7), [0.1, -0.1, 0.0]),
        (names[9], Some(8), [0.0, -0.8, 0.0]),
        (names[10], Some(7), [-0.1, -0.1, 0.0]),
        (names[11], Some(10), [0.0, -0.8, 0.0]),
    ])
}

fn from_the_chest(mut skeleton: Skeleton) -> Skeleton {
    skeleton.joints.remove(0);
    for joint in &mut skeleton.joints {
        joint.parent = joint.parent.and_then(|parent| parent.checked_sub(1));
    }
    skeleton.joints[0].offset = [0.0, 1.4, 0.0];
    skeleton
}

#[test]
fn a_tree_that_begins_at_the_head_or_chest_has_its_legs_below() {
    let names = [
        "Head",
        "Chest",
        "Left-Shoulder",
        "Left-Elbow",
        "Right-Shoulder",
        "Right-Elbow",
        "Waist",
        "Hip",
        "Left-Hip",
        "Left-Knee",
        "Right-Hip",
        "Right-Knee",
    ];
    let nameless = std::array::from_fn(|_| "joint");
    for (first, names) in [names, nameless].into_iter().enumerate() {
        for (removed, skeleton) in [hanging(names), from_the_chest(hanging(names))].into_iter().enumerate() {
            let place = |joint: usize| joint - removed;
            let parts = parts_of(&skeleton, "lower-upper");
            assert_eq!(parts[0].1, (6..12).map(place).collect::<Vec<_>>(), "{first} {removed}");
            let ids: Vec<String> = presets(&skeleton).into_iter().map(|preset| preset.id).collect();
            assert_eq!(ids, ["whole", "lower-upper", "body-arms", "legs-trunk-arms"]);
            let height = skeleton.height();
            assert!((height - [1.6, 1.3][removed]).abs() < 1e-9, "{height}");
        }
    }
}
