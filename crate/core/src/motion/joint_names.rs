//! Finds limb and side in the name of a joint. The word lists cover CMU, Mixamo, Biovision, Perception
//! Neuron, Biped, Xsens, Acclaim and other conventions, in any spelling.

/// A side of the body, as the body itself sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Side {
    Left,
    Right,
}

/// A kind of limb.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Limb {
    Arm,
    Leg,
}

/// Legs come first: "LeftFootIndex" is a toe.
const LEG_WORDS: [&str; 13] = [
    "leg", "hip", "thigh", "femur", "knee", "shin", "calf", "tibia", "ankle", "foot", "toe", "heel",
    "buttock",
];
const ARM_WORDS: [&str; 22] = [
    "arm", "shoulder", "shldr", "collar", "clavicle", "scapula", "humerus", "elbow", "radius", "ulna",
    "wrist", "hand", "palm", "carpal", "finger", "thumb", "index", "middle", "ring", "pinky", "little",
    "carpus",
];
const SPINE_WORDS: [&str; 9] =
    ["spine", "chest", "torso", "abdomen", "back", "thorax", "neck", "lumbar", "vertebra"];

/// The limb and the side that a name contains; `None` for the trunk and for names without limb or side.
pub(crate) fn limb_of(name: &str) -> Option<(Limb, Side)> {
    let (side, rest) = side_of(&split_words(name))?;
    let contains = |list: &[&str]| rest.iter().any(|word| list.iter().any(|part| word.contains(part)));
    if contains(&LEG_WORDS) {
        Some((Limb::Leg, side))
    } else if contains(&ARM_WORDS) {
        Some((Limb::Arm, side))
    } else {
        None
    }
}

/// Whether the name tells a side.
pub(crate) fn is_sided(name: &str) -> bool {
    side_of(&split_words(name)).is_some()
}

/// Whether the name contains "head". Callers also check the joint's region, because a hand may hold a
/// "headlight".
pub(crate) fn looks_like_head(name: &str) -> bool {
    split_words(name).iter().any(|word| word.contains("head"))
}

/// Whether the name is that of the back or chest.
pub(crate) fn looks_like_spine(name: &str) -> bool {
    split_words(name).iter().any(|word| SPINE_WORDS.iter().any(|part| word.contains(part)))
}

/// A joint's name without what programs spell differently: its side, its other words without a prefix that
/// all joints share, and its numbers. Two programs' names of one joint are often equal in this form.
pub(crate) type CommonName = (Option<Side>, String, Vec<u32>);

/// The common names of all joints of a body; the first is the root's.
pub(crate) fn common_names(names: &[&str]) -> Vec<CommonName> {
    let last = |name: &str| name.rsplit(':').find(|word| !word.is_empty()).unwrap_or_default().to_owned();
    let names: Vec<String> = names.iter().map(|name| last(name)).collect();
    // A prefix ends at a separator: "Bip01 " of "Bip01 Pelvis", not "Left" of "LeftArm".
    let others = names.get(1..).unwrap_or_default();
    let is_separator = |c: char| !c.is_alphanumeric();
    let mut prefixes = others.first().into_iter().flat_map(|name| name.match_indices(is_separator));
    let is_shared = |end: usize| others.iter().all(|name| name.starts_with(&others[0][..end]));
    let shared = (prefixes.rfind(|(at, separator)| others.len() > 1 && is_shared(at + separator.len())))
        .map_or("", |(at, separator)| &others[0][..at + separator.len()]);
    let common = |name: &String| {
        let name = name.strip_prefix(shared).unwrap_or(name);
        let numbers = name.split(|c: char| !c.is_ascii_digit()).filter_map(|digits| digits.parse().ok());
        let words = split_words(name);
        let (side, words) = side_of(&words).map_or((None, words), |(side, rest)| (Some(side), rest));
        (side, words.concat(), numbers.collect())
    };
    names.iter().map(common).collect()
}

/// The words of a name in lower case: split at separators, digits and changes of case (`mixamorig:LeftUpLeg`
/// gives mixamorig, left, up, leg).
fn split_words(name: &str) -> Vec<String> {
    let letters: Vec<char> = name.chars().collect();
    let mut words: Vec<String> = Vec::new();
    let mut word = String::new();
    for (at, &c) in letters.iter().enumerate() {
        let before = at.checked_sub(1).map(|at| letters[at]);
        let after = letters.get(at + 1).copied();
        // A new word starts at U in LeftUp, and at H in LHip: the last capital of several.
        let new = c.is_ascii_uppercase()
            && (before.is_some_and(|c| c.is_ascii_lowercase())
                || before.is_some_and(|c| c.is_ascii_uppercase())
                    && after.is_some_and(|c| c.is_ascii_lowercase()));
        if (new || !is_letter(c)) && !word.is_empty() {
            words.push(std::mem::take(&mut word));
        }
        if is_letter(c) {
            word.push(c.to_ascii_lowercase());
        }
    }
    if !word.is_empty() {
        words.push(word);
    }
    words
}

/// All words in the lists are ASCII. Tables of all other letters would be a twentieth of the wasm.
fn is_letter(c: char) -> bool {
    c.is_ascii_alphabetic() || !c.is_ascii()
}

/// The side, and the words without it.
fn side_of(words: &[String]) -> Option<(Side, Vec<String>)> {
    let side = |text: &str| match text {
        "l" | "left" | "lft" => Some(Side::Left),
        "r" | "right" | "rgt" => Some(Side::Right),
        _ => None,
    };
    // A separate word: Left Arm, arm_l, Bip01 L Thigh.
    if let Some(found) = words.iter().find_map(|word| side(word)) {
        let rest = words.iter().filter(|word| side(word).is_none()).cloned().collect();
        return Some((found, rest));
    }
    // The start of a word: leftarm, lfemur, and LU of LUArm.
    for (at, word) in words.iter().enumerate() {
        for prefix in ["left", "right", "l", "r"] {
            let Some(rest) = word.strip_prefix(prefix) else { continue };
            let is_limb = LEG_WORDS.iter().chain(&ARM_WORDS).any(|limb| rest.starts_with(limb))
                || ["u", "f", "up", "upper", "lower", "fore"].contains(&rest) && at + 1 < words.len()
                || ["upleg", "uparm", "upperarm", "upperleg", "lowerarm", "lowerleg", "forearm"]
                    .contains(&rest);
            if is_limb {
                let mut others = words.to_vec();
                others[at] = rest.to_owned();
                return side(prefix).map(|side| (side, others));
            }
        }
    }
    // The end of a word: armleft, thighright.
    for (at, word) in words.iter().enumerate() {
        for suffix in ["left", "right"] {
            if let Some(rest) = word.strip_suffix(suffix) {
                let mut others = words.to_vec();
                others[at] = rest.to_owned();
                return side(suffix).map(|side| (side, others));
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn legs_of_many_conventions() {
        for name in [
            "LHipJoint",
            "LeftUpLeg",
            "mixamorig:LeftUpLeg",
            "LeftHip",
            "LeftKnee",
            "Bip01 L Thigh",
            "Bip001 L Calf",
            "lfemur",
            "ltibia",
            "ltoes",
            "lhipjoint",
            "thigh_l",
            "thigh.L",
            "Thigh-L",
            "L_Ankle",
            "left_foot",
            "LeftToeBase",
            "lShin",
            "LThigh",
            "J_Bip_L_UpperLeg",
            "LeftLowerLeg",
            "leftupleg",
            "ValveBiped.Bip01_L_Foot",
            "Character1_LeftLeg",
            "LeftFootIndex",
            "LEFT_KNEE",
            "footLeft",
        ] {
            assert_eq!(limb_of(name), Some((Limb::Leg, Side::Left)), "{name}");
        }
    }

    #[test]
    fn arms_of_many_conventions() {
        for name in [
            "RightArm",
            "RightForeArm",
            "mixamorig:RightHandIndex1",
            "RightCollar",
            "RightShoulder",
            "RThumb",
            "rhand",
            "RFingers",
            "rhumerus",
            "rradius",
            "rclavicle",
            "rwrist",
            "Bip01 R UpperArm",
            "Bip01 R Finger0",
            "hand_r",
            "upperarm_r",
            "clavicle.R",
            "R_Elbow",
            "rShldr",
            "RUArm",
            "RFArm",
            "RightInHandPinky",
            "index_01_r",
            "right_wrist",
            "RightHandThumb2",
            "rightforearm",
        ] {
            assert_eq!(limb_of(name), Some((Limb::Arm, Side::Right)), "{name}");
        }
    }

    #[test]
    fn names_of_several_programs_are_the_same() {
        let names = common_names(&["Hips", "LeftUpLeg", "Spine1"]);
        for others in [
            ["mixamorig:Hips", "mixamorig:LeftUpLeg", "mixamorig:Spine1"],
            ["HIPS", "LEFT_UPLEG", "SPINE1"],
            ["Bip01 Hips", "Bip01 L UpLeg", "Bip01 Spine_01"],
        ] {
            assert_eq!(common_names(&others), names, "{others:?}");
        }
        assert_ne!(common_names(&["Hips", "RightUpLeg", "Spine2"])[1..], names[1..]);
        assert!(common_names(&[]).is_empty());
    }

    #[test]
    fn trunks_of_many_conventions() {
        for name in [
            "Hips",
            "hip",
            "LowerBack",
            "lowerback",
            "Spine1",
            "Neck",
            "Head",
            "Chest",
            "Bip01 Pelvis",
            "Bip01",
            "L5",
            "T8",
            "LeftEye",
            "mixamorig:HeadTop_End",
            "root",
            "lowerneck",
            "upperback",
            "Armature",
            "Reference",
            "",
        ] {
            assert_eq!(limb_of(name), None, "{name}");
        }
        assert!(
            looks_like_head("mixamorig:HeadTop_End") && looks_like_head("head") && !looks_like_head("Neck")
        );
        assert!(
            looks_like_spine("Bip01 Spine1")
                && looks_like_spine("lowerback")
                && !looks_like_spine("Bip01 Pelvis")
        );
    }
}
