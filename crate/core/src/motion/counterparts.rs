//! Which joints of two bodies correspond: by their names, and where names say nothing, by the shape of the
//! tree from the hips on.

use crate::motion::anatomy::{Anatomy, Region};
use crate::motion::joint_names::common_names;
use crate::motion::skeleton::Skeleton;
use std::collections::BTreeMap;

/// For each joint of `body` the joint of `other` that corresponds to it; `None` if there is no such joint.
///
/// The roots correspond. In trees of one shape, the children of two corresponding joints are paired by their
/// names, then by limb and side, then in their order. In other trees, names alone decide.
pub(super) fn counterparts(body: &Skeleton, other: &Skeleton) -> Vec<Option<usize>> {
    let names = [body, other].map(|skeleton| {
        common_names(&skeleton.joints.iter().map(|joint| joint.name.as_str()).collect::<Vec<_>>())
    });
    let mut found = vec![None; body.joints.len()];
    // The root moves the whole body, whatever its name is.
    found[0] = Some(0);
    // Names that differ by their numbers alone say nothing.
    let differ = names.iter().all(|names| names.iter().skip(1).any(|name| name.1 != names[1].1));
    let mut codes = BTreeMap::new();
    let shapes = [body, other].map(|skeleton| shapes(skeleton, &mut codes));
    if shapes[0][0] == shapes[1][0] {
        let regions = [body, other].map(|skeleton| Anatomy::find(skeleton).map(|anatomy| anatomy.regions));
        let same_limb = |joint: usize, source: usize| match &regions {
            [Some(own), Some(others)] => own[joint] == others[source] && own[joint] != Region::Trunk,
            _ => false,
        };
        for joint in 0..body.joints.len() {
            let Some(source) = found[joint] else { continue };
            let same_name = |joint: usize, source: usize| differ && names[0][joint] == names[1][source];
            let same_shape = |joint: usize, source: usize| shapes[0][joint] == shapes[1][source];
            let limb_and_shape = |joint, source| same_limb(joint, source) && same_shape(joint, source);
            let rules: [&dyn Fn(usize, usize) -> bool; 3] = [&same_name, &limb_and_shape, &same_shape];
            for is_pair in rules {
                for child in body.children(joint) {
                    if found[child].is_none() {
                        let mut free = other.children(source).filter(|place| !found.contains(&Some(*place)));
                        found[child] = free.find(|&place| is_pair(child, place));
                    }
                }
            }
        }
    }
    for joint in 1..found.len() {
        if found[joint].is_none() {
            let place = names[1].iter().position(|name| *name == names[0][joint]);
            found[joint] =
                place.filter(|place| shapes[0][0] != shapes[1][0] || !found.contains(&Some(*place)));
        }
    }
    found
}

/// A number for each joint; joints have the same number if the trees below them have the same shape, in
/// whatever order. `codes` holds the numbers given so far.
fn shapes(skeleton: &Skeleton, codes: &mut BTreeMap<Vec<usize>, usize>) -> Vec<usize> {
    let mut below: Vec<Vec<usize>> = vec![Vec::new(); skeleton.joints.len()];
    let mut shapes = vec![0; skeleton.joints.len()];
    for (place, joint) in skeleton.joints.iter().enumerate().rev() {
        let mut children = std::mem::take(&mut below[place]);
        children.sort_unstable();
        let next = codes.len();
        shapes[place] = *codes.entry(children).or_insert(next);
        if let Some(parent) = joint.parent {
            below[parent].push(shapes[place]);
        }
    }
    shapes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::testing::tree;

    const LEFT_FIRST: [(&str, Option<usize>); 7] = [
        ("Hips", None),
        ("LeftUpLeg", Some(0)),
        ("LeftLeg", Some(1)),
        ("RightUpLeg", Some(0)),
        ("RightLeg", Some(3)),
        ("Spine", Some(0)),
        ("Head", Some(5)),
    ];
    const LEFT_RIGHT_SWAPPED: [Option<usize>; 7] =
        [Some(0), Some(3), Some(4), Some(1), Some(2), Some(5), Some(6)];

    fn right_first(names: [&str; 7]) -> Skeleton {
        tree(&std::array::from_fn::<_, 7, _>(|place| (names[place], LEFT_FIRST[place].1)))
    }

    #[test]
    fn names_decide_before_places() {
        let body = tree(&LEFT_FIRST);
        for names in [
            ["Hips", "RightUpLeg", "RightLeg", "LeftUpLeg", "LeftLeg", "Spine", "Head"],
            ["HIPS", "RIGHTUPLEG", "RIGHTLEG", "LEFTUPLEG", "LEFTLEG", "SPINE", "HEAD"],
            ["B:Hips", "B:RightUpLeg", "B:RightLeg", "B:LeftUpLeg", "B:LeftLeg", "B:Spine", "B:Head"],
            ["my_Hips", "my_R_UpLeg", "my_R_Leg", "my_L_UpLeg", "my_L_Leg", "my_Spine", "my_Head"],
            // No name is the same; limbs and sides are.
            ["Pelvis", "R_Thigh", "R_Shin", "L_Thigh", "L_Shin", "Torso", "Skull"],
        ] {
            assert_eq!(counterparts(&body, &right_first(names)), LEFT_RIGHT_SWAPPED, "{names:?}");
        }
    }

    #[test]
    fn the_order_decides_where_names_say_nothing() {
        let body = tree(&LEFT_FIRST);
        let nameless = right_first(["a", "b", "c", "d", "e", "f", "g"]);
        let all: Vec<Option<usize>> = (0..7).map(Some).collect();
        assert_eq!(counterparts(&body, &nameless), all);
        // Numbers that follow another order of the same tree: the tree counts.
        let numbered = tree(&[("j0", None), ("j1", Some(0)), ("j2", Some(1)), ("j3", Some(0))]);
        let otherwise = tree(&[("j0", None), ("j2", Some(0)), ("j3", Some(0)), ("j1", Some(2))]);
        assert_eq!(counterparts(&numbered, &otherwise), [Some(0), Some(2), Some(3), Some(1)]);
    }

    #[test]
    fn a_joint_without_a_partner_has_none() {
        let mut longer = LEFT_FIRST.to_vec();
        longer.push(("Tail", Some(0)));
        let found = counterparts(&tree(&longer), &tree(&LEFT_FIRST));
        assert_eq!(found[..7], (0..7).map(Some).collect::<Vec<_>>());
        assert_eq!(found[7], None);
    }
}
