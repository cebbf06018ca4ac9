//! Whether two clips show the same body, and if not, what differs.

use crate::motion::anatomy::{Anatomy, standing_at_rest};
use crate::motion::clip::Clip;
use crate::motion::skeleton::{Joint, Skeleton};
use crate::motion::stage_axes::UpAxis;
use nalgebra::Vector3;
use std::borrow::Cow;
use thiserror::Error;

/// Why two joint trees are not the same body.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum BodyMismatch {
    /// The numbers of joints differ.
    #[error("expected {expected} joints, found {found}{}", .difference.as_ref().map_or(String::new(), |m| format!(" ({m})")))]
    JointCount {
        /// Joints of the first body.
        expected: usize,
        /// Joints of the other.
        found: usize,
        /// The first difference, as a phrase.
        difference: Option<String>,
    },
    /// The joints at one place have different names.
    #[error("joint {joint}: expected {expected:?}, found {found:?}")]
    Name {
        /// The place of the joint.
        joint: usize,
        /// Its name in the first body.
        expected: String,
        /// Its name in the other.
        found: String,
    },
    /// The joints have the same names in another order, and the names do not say which joint is which.
    #[error(
        "the same joints in another order: joint {joint} is {found:?} instead of {expected:?}; bring the clip onto \
         the other body first (Clip::onto, vcgpdm clip --onto)"
    )]
    Order {
        /// The first place with another joint.
        joint: usize,
        /// The name there in the first body.
        expected: String,
        /// The name there in the other.
        found: String,
    },
    /// The joints at one place have different parents.
    #[error("joint {joint} ({name:?}): expected it to hang on {expected:?}, found it on {found:?}")]
    Parent {
        /// The place of the joint.
        joint: usize,
        /// The name of the joint.
        name: String,
        /// The parent's name in the first body.
        expected: String,
        /// The parent's name in the other.
        found: String,
    },
    /// A bone has clearly another length or direction.
    #[error(
        "joint {joint} ({name:?}): its offset differs by {percent}% of the body's height (at most \
         {limit}%): expected {expected:?}, found {found:?}"
    )]
    Offset {
        /// The place of the joint.
        joint: usize,
        /// The name of the joint.
        name: String,
        /// The difference in percent of the body's height.
        percent: f64,
        /// The largest difference within one body, in percent.
        limit: f64,
        /// The offset in the first body, in its file's units.
        expected: [f64; 3],
        /// The offset in the other.
        found: [f64; 3],
    },
    /// The rest pose stands along another axis.
    #[error(
        "its rest pose stands along {}, not along {}; bring the clip onto the other body first (Clip::onto, vcgpdm \
         clip --onto)", found.name(), expected.name()
    )]
    Axis {
        /// The axis of the first body.
        expected: UpAxis,
        /// The axis of the other.
        found: UpAxis,
    },
    /// The same body in other units.
    #[error("all its bones are {factor} times as long: is it in other units?")]
    Units {
        /// The ratio of the bones to those of the first body.
        factor: f64,
    },
    /// A rest pose whose directions mean nothing, so that no motion can be transferred from or to this body.
    #[error("{name}: expected a rest pose that stands on two legs, found one that does not")]
    Rest {
        /// The name of the clip.
        name: String,
    },
}

impl BodyMismatch {
    /// Whether the joints are the same and only the bones differ. Then
    /// [`Clip::with_bones_of`](crate::motion::Clip::with_bones_of) can give both clips the same bones.
    pub fn only_bones_differ(&self) -> bool {
        matches!(self, BodyMismatch::Offset { .. } | BodyMismatch::Units { .. })
    }
}

/// Largest difference of an offset within one body, relative to the body's height. Files of one subject have
/// equal offsets up to rounding; adults recorded with the same joints differ by 2% or more in some bone.
const SAME_BODY_TOLERANCE: f64 = 0.01;

/// No two people differ by this factor.
const OTHER_UNITS: f64 = 2.2;

impl Skeleton {
    /// Checks that the other is the same body: the same joint tree, and offsets equal to 1% of the body's
    /// height. Channels may differ.
    ///
    /// # Errors
    ///
    /// A [`BodyMismatch`] with the first difference of the tree, or else the largest difference of an offset.
    pub fn same_body(&self, other: &Skeleton) -> Result<(), BodyMismatch> {
        self.same_joints(other)?;
        let height = self.height().max(f64::MIN_POSITIVE);
        // The root's offset is a place in the world, not a bone.
        let differences =
            (self.joints.iter().zip(&other.joints).enumerate().skip(1)).map(|(joint, (a, b))| {
                (joint, (Vector3::from(a.offset) - Vector3::from(b.offset)).norm() / height)
            });
        let worst = differences.max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some(factor) = self.unit_factor(other) {
            return Err(BodyMismatch::Units { factor });
        }
        if let [Some(expected), Some(found)] = [self, other].map(Skeleton::rest_axis)
            && expected != found
        {
            return Err(BodyMismatch::Axis { expected, found });
        }
        if let Some((joint, difference)) = worst.filter(|(_, difference)| *difference > SAME_BODY_TOLERANCE) {
            return Err(BodyMismatch::Offset {
                joint,
                name: self.joints[joint].name.clone(),
                percent: (1000.0 * difference).round() / 10.0,
                limit: 100.0 * SAME_BODY_TOLERANCE,
                expected: self.joints[joint].offset,
                found: other.joints[joint].offset,
            });
        }
        Ok(())
    }

    /// The axis along which the rest pose stands.
    pub(crate) fn rest_axis(&self) -> Option<UpAxis> {
        Anatomy::find(self)
            .and_then(|anatomy| standing_at_rest(self, &anatomy))
            .map(|upward| UpAxis::along(&upward))
    }

    /// The ratio of all bones of the other to those of this body, if it is one ratio and far from 1.
    fn unit_factor(&self, other: &Skeleton) -> Option<f64> {
        let length = |joint: &Joint| Vector3::from(joint.offset).norm();
        let pairs = self.joints.iter().zip(&other.joints).skip(1);
        let pairs: Vec<(f64, f64)> = pairs.map(|(a, b)| (length(a), length(b))).collect();
        let (own, others) = pairs.iter().fold((0.0, 0.0), |(own, others), (a, b)| (own + a, others + b));
        let factor = others / own;
        let fits = |&(a, b): &(f64, f64)| (b - factor * a).abs() <= SAME_BODY_TOLERANCE * others;
        let is_far = factor.is_finite() && !(1.0 / OTHER_UNITS..=OTHER_UNITS).contains(&factor);
        (is_far && pairs.iter().all(fits)).then_some((1000.0 * factor).round() / 1000.0)
    }

    /// Checks that the other has the same joint tree; offsets may differ.
    pub(crate) fn same_joints(&self, other: &Skeleton) -> Result<(), BodyMismatch> {
        for (joint, (a, b)) in self.joints.iter().zip(&other.joints).enumerate() {
            if a.name != b.name {
                if self.joints.len() != other.joints.len() {
                    let difference =
                        Some(format!("joint {joint} is {:?} in one and {:?} in the other", a.name, b.name));
                    return Err(self.count_mismatch(other, difference));
                }
                let (expected, found) = (a.name.clone(), b.name.clone());
                return Err(if self.has_names_of(other) {
                    BodyMismatch::Order { joint, expected, found }
                } else {
                    BodyMismatch::Name { joint, expected, found }
                });
            }
            if a.parent != b.parent {
                let name = |body: &Skeleton, parent: Option<usize>| {
                    parent.map_or("nothing".to_owned(), |p| body.joints[p].name.clone())
                };
                return Err(BodyMismatch::Parent {
                    joint,
                    name: a.name.clone(),
                    expected: name(self, a.parent),
                    found: name(other, b.parent),
                });
            }
        }
        if self.joints.len() != other.joints.len() {
            return Err(self.count_mismatch(other, None));
        }
        Ok(())
    }

    /// For each joint its place in the other body, whose joints are the same in another order; `None` if the order
    /// is the same, a name repeats, or the trees differ.
    pub(crate) fn places_in(&self, other: &Skeleton) -> Option<Vec<usize>> {
        let names = |body: &Skeleton| body.joints.iter().map(|joint| joint.name.clone()).collect::<Vec<_>>();
        let (own, others) = (names(self), names(other));
        if own == others || !self.has_names_of(other) {
            return None;
        }
        let place = |name: &String| others.iter().position(|other| other == name);
        let places = own.iter().map(place).collect::<Option<Vec<usize>>>()?;
        let has_same_parent = |(joint, &place): (&Joint, &usize)| {
            other.joints[place].parent == joint.parent.map(|parent| places[parent])
        };
        let repeats = (0..places.len()).any(|joint| places[..joint].contains(&places[joint]));
        (!repeats && self.joints.iter().zip(&places).all(has_same_parent)).then_some(places)
    }

    fn has_names_of(&self, other: &Skeleton) -> bool {
        let names = |skeleton: &Skeleton| {
            let mut names: Vec<String> = skeleton.joints.iter().map(|joint| joint.name.clone()).collect();
            names.sort_unstable();
            names
        };
        names(self) == names(other)
    }

    fn count_mismatch(&self, other: &Skeleton, difference: Option<String>) -> BodyMismatch {
        BodyMismatch::JointCount { expected: self.joints.len(), found: other.joints.len(), difference }
    }
}

impl Clip {
    /// The clip with its joints in the order of `body`, if they have the same names and parents there.
    #[doc(hidden)]
    pub fn in_order_of(&self, body: &Skeleton) -> Cow<'_, Clip> {
        let Some(places) = body.places_in(&self.skeleton) else { return Cow::Borrowed(self) };
        let starts = self.skeleton.channel_starts();
        let own = |place: usize| &self.skeleton.joints[place];
        let columns: Vec<usize> =
            places.iter().flat_map(|&place| (starts[place]..).take(own(place).channels.len())).collect();
        let joints = body.joints.iter().zip(&places);
        let joints =
            joints.map(|(joint, &place)| Joint { parent: joint.parent, ..own(place).clone() }).collect();
        let values = self.values.select_columns(&columns);
        Cow::Owned(Clip { skeleton: Skeleton { joints }, ..self.with_values(values, self.frame_time) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::pose::PoseMapping;
    use crate::motion::samples;
    use crate::motion::skeleton::Channel;

    fn chain(names: &[&str]) -> Skeleton {
        let joints = names.iter().enumerate().map(|(place, name)| Joint {
            name: (*name).to_owned(),
            parent: place.checked_sub(1),
            offset: [0.0, 10.0, 0.0],
            channels: vec![Channel::Xrotation],
            end_sites: Vec::new(),
        });
        Skeleton { joints: joints.collect() }
    }

    #[test]
    fn other_channels_and_rounding_are_the_same_body() {
        let first = chain(&["a", "b", "c"]);
        let mut second = first.clone();
        second.joints[1].channels.clear();
        second.joints[2].offset[0] = 0.1;
        // The root's offset does not belong to the body.
        second.joints[0].offset = [99.0, 0.0, 0.0];
        assert_eq!(first.same_body(&second), Ok(()));
    }

    #[test]
    fn a_rest_pose_along_another_axis_is_named() {
        let body = samples::clip("walk-1").unwrap().skeleton;
        let mut turned = body.clone();
        turned.joints.iter_mut().for_each(|joint| joint.offset.rotate_left(2));
        let error = body.same_body(&turned).unwrap_err();
        assert!(error.to_string().starts_with("its rest pose stands along z, not along y"), "{error}");
        assert!(!error.only_bones_differ());
    }

    #[test]
    fn the_error_names_the_difference() {
        let first = chain(&["a", "b", "c"]);
        let mut longer = first.clone();
        longer.joints[1].offset[1] = 10.4;
        longer.joints[2].offset[1] = 12.0;
        let mut elsewhere = first.clone();
        elsewhere.joints[2].parent = Some(0);
        let mut metres = first.clone();
        metres.joints.iter_mut().for_each(|joint| joint.offset[1] *= 0.01);
        let mut inches = first.clone();
        inches.joints.iter_mut().for_each(|joint| joint.offset[1] /= 2.54);
        for (other, wanted) in [
            (inches, "all its bones are 0.394 times as long: is it in other units?"),
            (longer, "joint 2 (\"c\"): its offset differs by 10% of the body's height"),
            (elsewhere, "joint 2 (\"c\"): expected it to hang on \"b\", found it on \"a\""),
            (metres, "all its bones are 0.01 times as long: is it in other units?"),
            (chain(&["a", "c", "b"]), "the same joints in another order: joint 1 is \"c\" instead of \"b\""),
            (chain(&["a", "b", "d"]), "joint 2: expected \"c\", found \"d\""),
            (chain(&["a", "b"]), "expected 3 joints, found 2"),
            (chain(&["a", "x"]), "joint 1 is \"b\" in one and \"x\" in the other"),
        ] {
            let message = first.same_body(&other).unwrap_err().to_string();
            assert!(message.contains(wanted), "{message}");
            assert_eq!(
                first.same_body(&other).unwrap_err().only_bones_differ(),
                wanted.contains("offset") || wanted.contains("units")
            );
        }
    }

    #[test]
    fn joints_in_another_order_are_matched_by_their_names() {
        let walk = samples::clip("walk-1").unwrap().resample(30.0).unwrap();
        let mut body = walk.skeleton.clone();
        let right = body.joints.iter().position(|joint| joint.name == "RightUpLeg").unwrap();
        let legs = ["RightUpLeg", "RightLeg", "RightFoot", "RightToeBase"];
        body.joints.sort_by_key(|joint| (joint.parent.is_some(), !legs.contains(&joint.name.as_str())));
        let places = body.clone();
        let place = |name: &str| places.joints.iter().position(|joint| joint.name == name).unwrap();
        let parents: Vec<Option<usize>> = (body.joints.iter())
            .map(|joint| joint.parent.map(|parent| place(&walk.skeleton.joints[parent].name)))
            .collect();
        body.joints.iter_mut().zip(parents).for_each(|(joint, parent)| joint.parent = parent);
        let other = walk.in_order_of(&body).into_owned();
        assert!(other.skeleton == body && place("RightUpLeg") < right);
        let mapping = PoseMapping::new(&walk);
        let (own, others) = (mapping.encode(&walk).unwrap(), mapping.encode(&other).unwrap());
        assert_eq!(others.y, own.y);
        let [warning] = &others.warnings[..] else { panic!("{:?}", others.warnings) };
        assert!(warning.contains("matched by their names"), "{warning}");
        assert!(walk.skeleton.same_body(&body).is_err());
        assert_eq!(other.with_bones_of(&walk).unwrap(), other);
        body.joints[right].name = "tail".to_owned();
        assert!(body.places_in(&walk.skeleton).is_none());
    }

    #[test]
    fn joints_of_another_tree_or_with_repeated_names_are_not_matched() {
        let star = |names: &[&str]| {
            let mut body = chain(names);
            body.joints.iter_mut().skip(1).for_each(|joint| joint.parent = Some(0));
            body
        };
        assert_eq!(star(&["r", "a", "b"]).places_in(&star(&["r", "b", "a"])), Some(vec![0, 2, 1]));
        assert_eq!(star(&["r", "a", "a", "b"]).places_in(&star(&["r", "b", "a", "a"])), None);
        assert_eq!(chain(&["r", "a", "b"]).places_in(&chain(&["r", "b", "a"])), None);
    }
}
