//! The usual splits of a body: whole, lower and upper, body and arms, legs and trunk and arms.

use crate::motion::anatomy::{Anatomy, Region};
use crate::motion::joint_names::{Side, looks_like_head, looks_like_spine};
use crate::motion::parts::spec::PartSpec;
use crate::motion::skeleton::Skeleton;
use serde::Serialize;

/// A way to split the body, found from the names of its joints.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PartsPreset {
    /// "whole", "lower-upper", "body-arms" or "legs-trunk-arms".
    pub id: String,
    /// Its title for users.
    pub title: String,
    /// The parts; each joint is in one of them.
    pub parts: Vec<PartSpec>,
}

/// The splits of a body, found from the names of its joints or else from its shape: always "whole";
/// "lower-upper" if legs were found; "body-arms" (the three parts of Velychko et al. 2018, section 5.3) and
/// "legs-trunk-arms" if arms were found too.
///
/// ```
/// use vcgpdm_core::motion::{parts, samples};
///
/// let clip = samples::clip("walk-1").ok_or("no such sample")?;
/// let presets = parts::presets(&clip.skeleton);
/// let ids: Vec<&str> = presets.iter().map(|preset| preset.id.as_str()).collect();
/// assert_eq!(ids, ["whole", "lower-upper", "body-arms", "legs-trunk-arms"]);
/// let names: Vec<&str> = presets[1].parts.iter().map(|part| part.name.as_str()).collect();
/// assert_eq!(names, ["lower", "upper"]);
/// # Ok::<(), &str>(())
/// ```
pub fn presets(skeleton: &Skeleton) -> Vec<PartsPreset> {
    let every_joint: Vec<usize> = (0..skeleton.joints.len()).collect();
    let mut presets = vec![preset("whole", "Whole body", vec![("body", every_joint)])];
    let Some(anatomy) = Anatomy::find(skeleton) else { return presets };
    if let Some(from_trunk) = anatomy.from_trunk.as_deref() {
        let mut presets = self::presets(&from_trunk.body);
        for part in presets.iter_mut().flat_map(|preset| &mut preset.parts) {
            part.joints.iter_mut().for_each(|joint| *joint = from_trunk.nodes[*joint]);
            part.joints.sort_unstable();
        }
        return presets;
    }
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
        let arm = |side| anatomy.joints(Region::Arm(side));
        let (left, right) = (arm(Side::Left), arm(Side::Right));
        let trunk = joints(&|joint| anatomy.regions[joint] == Region::Trunk && !lower.contains(&joint));
        if !trunk.is_empty() {
            let body = joints(&|joint| lower.contains(&joint) || trunk.contains(&joint));
            let parts = vec![("body", body), ("left arm", left.clone()), ("right arm", right.clone())];
            presets.push(preset("body-arms", "Body, left arm, right arm", parts));
        }
        let parts = vec![("legs", lower), ("trunk", trunk), ("left arm", left), ("right arm", right)];
        // A body whose arms hang on its hips has no trunk.
        let parts = parts.into_iter().filter(|(_, joints)| !joints.is_empty()).collect();
        presets.push(preset("legs-trunk-arms", "Legs, trunk, left arm, right arm", parts));
    }
    presets
}

/// The parts of a preset, named by its id or by the names of its parts in any order: "lower-upper",
/// "upper,lower". `None` if the body has no such preset.
pub fn preset_parts(text: &str, skeleton: &Skeleton) -> Option<Vec<PartSpec>> {
    let presets = presets(skeleton);
    if let Some(preset) = presets.iter().find(|preset| preset.id == text) {
        return Some(preset.parts.clone());
    }
    // Names of the parts, in the order of the parts of the model.
    let names: Vec<&str> = text.split(',').map(str::trim).collect();
    let repeats = names.iter().enumerate().any(|(place, name)| names[..place].contains(name));
    let chosen = |preset: &PartsPreset| -> Option<Vec<PartSpec>> {
        names.iter().map(|name| preset.parts.iter().find(|part| part.name == *name).cloned()).collect()
    };
    presets.iter().filter(|preset| preset.parts.len() == names.len() && !repeats).find_map(chosen)
}

/// The splits of a body as a user writes them: "body; lower,upper; ...".
pub fn preset_names(skeleton: &Skeleton) -> String {
    let names = |preset: PartsPreset| -> String {
        preset.parts.into_iter().map(|part| part.name).collect::<Vec<_>>().join(",")
    };
    presets(skeleton).into_iter().map(names).collect::<Vec<_>>().join("; ")
}

fn preset(id: &str, title: &str, parts: Vec<(&str, Vec<usize>)>) -> PartsPreset {
    let spec = |(name, joints): (&str, Vec<usize>)| PartSpec { name: name.to_owned(), joints };
    PartsPreset { id: id.to_owned(), title: title.to_owned(), parts: parts.into_iter().map(spec).collect() }
}

/// For each joint, whether it belongs to the hips: trunk joints with a leg below them, up to the root. Names
/// of the back are no hips. In a tree that begins at the chest or the head, the hips end at the back, at the
/// head or at the joint that bears the arms.
fn hips(skeleton: &Skeleton, anatomy: &Anatomy) -> Vec<bool> {
    let [left, right] = [Side::Left, Side::Right].map(|side| anatomy.bearing(skeleton, Region::Leg(side)));
    let is_back = |joint: usize| looks_like_spine(&skeleton.joints[joint].name);
    let mut hips: Vec<bool> =
        (0..left.len()).map(|joint| (left[joint] || right[joint]) && !is_back(joint)).collect();
    let is_arm = |joint: usize| matches!(anatomy.regions[joint], Region::Arm(_));
    let mut above_hips = false;
    let mut next = skeleton.joints[anatomy.hips(skeleton)].parent;
    while let Some(joint) = next {
        above_hips |= is_back(joint)
            || looks_like_head(&skeleton.joints[joint].name)
            || skeleton.children(joint).any(is_arm);
        hips[joint] &= !above_hips;
        next = skeleton.joints[joint].parent;
    }
    hips[0] |= !above_hips;
    hips
}
