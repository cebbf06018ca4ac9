//! Finds the axis that points up from the motion, the rest pose, the way of the root and the floor.

use crate::motion::anatomy::Anatomy;
use crate::motion::clip::Clip;
use crate::motion::joint_names::Side;
use crate::motion::limbs::{Limbs, extents};
use crate::motion::skeleton::WorldPose;
use crate::motion::stage_axes::UpAxis;
use nalgebra::{Matrix3, Vector3};

/// The start of the warning about an axis that is not certain.
const UNCERTAIN: &str = "the up axis is not certain";

/// The lowest point of a body on a floor at zero, as shares of the body's height: a joint is above the sole,
/// and noise puts points below the floor.
const FLOOR: [f64; 2] = [-0.1, 0.12];
/// A body touches the floor in this share of the frames, also if it runs or jumps,
const TOUCHED: f64 = 0.2;
/// and is below the floor in a smaller share.
const BELOW: f64 = 0.05;
/// The lowest point of a body on a bench.
const BENCH: [f64; 2] = [-0.1, 0.7];
/// A root that comes as near to the origin, in body heights, may begin there: a thin body then touches a plane
/// at zero by chance, and an upright body is certain without a floor.
const NEAR_ORIGIN: f64 = 0.03;
/// A root that moves farther, in body heights, travels, ...
const TRAVELS: f64 = 0.5;
/// ... and along one axis alone if it moves less along the others.
const ASIDE: f64 = 0.3;
/// A body turns about itself when the mean of a direction of its root is shorter.
const STRAIGHT: f64 = 0.7;
/// A root that moves farther along one axis than this and than along the others climbs or swims.
const FAR: f64 = 0.7;
/// A body stands along an axis when the vector from its feet to its head has this component.
const STANDS: f64 = 0.7;
/// The limbs carry a body when their vector has this component.
const CARRIED: f64 = 0.3;
/// The weights of the rest pose, of the limbs and of a floor that is the only one, beside 1 for the vector from
/// the feet to the head and for one of several floors, and the lead of an axis along which a body lies without
/// doubt. They were chosen on 5,700 made clips in all worlds; other weights of about this size give nearly the
/// same answers.
const REST: f64 = 0.8;
const LIMBS: f64 = 0.4;
const ONLY_FLOOR: f64 = 1.3;
const LEAD: f64 = 0.3;
/// The lead before an axis that has a floor as well.
const FLOOR_LEAD: f64 = 1.0;

/// Directions and extremes of a body over a whole clip, in file units.
struct Reach {
    /// The sum of the unit vectors from the feet to the head; `None` if feet or head were not found.
    upward: Option<Vector3<f64>>,
    /// The smallest coordinate along each axis.
    low: Vector3<f64>,
    /// The largest coordinate along each axis.
    high: Vector3<f64>,
    /// For each of [`UpAxis::ALL`] the numbers of frames in which the body touches a floor at zero, and in which
    /// it is below this floor.
    touched: [[usize; 2]; 6],
    /// The limbs, if there are any.
    limbs: Option<LimbSums>,
    /// The smallest and largest coordinate of the root along each axis.
    root: [Vector3<f64>; 2],
    /// The sum of the rotations of the root.
    turns: Matrix3<f64>,
}

/// What the limbs do over a whole clip.
struct LimbSums {
    limbs: Limbs,
    /// The sum of [`Limbs::upward`].
    upward: Vector3<f64>,
}

/// The axis that points up.
pub(super) struct FoundAxis {
    pub(super) axis: UpAxis,
    /// Axes that may point up instead.
    others: Vec<UpAxis>,
    /// Whether limbs carry the body on a floor at zero.
    is_carried: bool,
}

/// What speaks for one axis.
struct Evidence {
    axis: UpAxis,
    /// The component of the vector from the feet to the head.
    stands: f64,
    /// Whether the body of the rest pose stands along the axis.
    is_rest: bool,
    /// The component of the vector of the limbs.
    limbs: f64,
    /// Whether there is a floor at zero.
    is_floor: bool,
    /// The way of the root along the axis, in body heights.
    way: f64,
    /// The sum of what speaks for the axis, less the way up to one body height: a body travels along the
    /// ground.
    score: f64,
}

/// Whether the root moves farther along the axis than this limit, and than along the others.
fn is_farthest(way: &Vector3<f64>, axis: UpAxis, limit: f64) -> bool {
    let along = axis.height(way).abs();
    along > limit && along >= way.amax()
}

impl Reach {
    /// The way of the root in body heights.
    fn way(&self, height: f64) -> Vector3<f64> {
        (self.root[1] - self.root[0]) / height
    }

    /// Whether the root may begin at the origin.
    fn is_near_origin(&self, height: f64) -> bool {
        self.root[0].sup(&Vector3::zeros()).inf(&self.root[1]).norm() < NEAR_ORIGIN * height
    }

    /// For each of [`UpAxis::ALL`] whether there is a floor at zero for a body whose length is along `length`.
    fn floors(&self, frames: usize, height: f64, length: UpAxis) -> [bool; 6] {
        let (way, frames) = (self.way(height), frames as f64);
        let is_along = |axis: UpAxis| axis.letter() == length.letter();
        let across = UpAxis::ALL.into_iter().filter(|axis| !is_along(*axis));
        let walks = across.map(|axis| axis.height(&way)).fold(0.0, f64::max) > TRAVELS;
        let turns = self.turns.column_iter().any(|column| column.norm() < STRAIGHT * frames);
        let rolls = turns && way.iter().filter(|way| **way > ASIDE).count() == 1;
        let lies = rolls || !walks && !self.is_near_origin(height);
        let mut floors = self
            .touched
            .map(|[touched, below]| touched as f64 > TOUCHED * frames && (below as f64) < BELOW * frames);
        for (floor, axis) in floors.iter_mut().zip(UpAxis::ALL) {
            // A body that moves far along an axis passes zero by chance.
            *floor &= (is_along(axis) || lies) && !is_farthest(&way, axis, FAR);
            // The hips of a lying body are above the floor; a plane through the hips is no floor.
            *floor &= is_along(axis) || axis.lowest(&self.root[0], &self.root[1]) > NEAR_ORIGIN * height;
        }
        floors
    }
}

impl Clip {
    /// The axis that points up: [`Clip::up`] if it is stated, else [`Clip::found_up`]. A clip without both is
    /// searched for the axis for which most speaks: the vector from the feet to the head, the rest pose, the
    /// limbs, a floor at zero, and a root that does not travel along the axis.
    pub fn up_axis(&self) -> UpAxis {
        self.up.or(self.found_up).unwrap_or_else(|| self.search_up_axis().axis)
    }

    /// The clip in which this axis points up.
    #[must_use]
    pub fn with_up(&self, up: UpAxis) -> Clip {
        Clip { up: Some(up), ..self.clone() }.without_axis_warning()
    }

    /// The clip without the warning about its axis.
    pub(super) fn without_axis_warning(mut self) -> Clip {
        self.warnings.retain(|warning| !warning.starts_with(UNCERTAIN));
        self
    }

    /// The clip with the axis found in it, and with a warning if other axes may point up.
    pub(super) fn with_checked_axis(mut self) -> Clip {
        let FoundAxis { axis, others, .. } = self.search_up_axis();
        self.found_up = Some(axis);
        if !others.is_empty() {
            let axis = axis.name();
            let other = others.iter().map(|other| other.name()).collect::<Vec<_>>().join(" or ");
            self.warnings.push(format!(
                "{UNCERTAIN}: {axis} is used, but {other} is possible too, because the body may lie, moves along \
                 its own length or is above no floor at 0. If {axis} is wrong, state the axis: --up in the \
                 terminal, with_up in Python, withUp in the npm package"
            ));
        }
        self
    }

    /// Whether an upright body has a floor at height zero below its feet; `None` if it is not clearly upright, or
    /// another axis points up.
    pub(super) fn stands_on_floor(&self) -> Option<bool> {
        let reach = self.reach();
        let upward = reach.upward? / self.frames().max(1) as f64;
        let axis = UpAxis::along(&upward);
        let floors = reach.floors(self.frames(), self.skeleton.height(), axis);
        let is_floor = UpAxis::ALL.into_iter().zip(floors).any(|(other, floor)| floor && other == axis);
        let is_this = is_floor || self.search_up_axis().axis == axis;
        (axis.height(&upward) > STANDS && is_this).then_some(is_floor)
    }

    /// Whether limbs carry the body on a floor at zero; `None` if the up axis is certain for another reason.
    pub(super) fn is_carried(&self) -> Option<bool> {
        let FoundAxis { others, is_carried, .. } = self.search_up_axis();
        if others.is_empty() && !is_carried { None } else { Some(is_carried) }
    }

    /// Computes the reach frame by frame, without the positions of all frames in memory.
    fn reach(&self) -> Reach {
        let ends = Anatomy::find(&self.skeleton).and_then(|anatomy| {
            let foot = |side| anatomy.foot(&self.skeleton, side);
            Some((anatomy.head(&self.skeleton)?, foot(Side::Left)?, foot(Side::Right)?))
        });
        let mut reach = Reach {
            upward: ends.map(|_| Vector3::zeros()),
            touched: [[0; 2]; 6],
            low: Vector3::repeat(f64::INFINITY),
            high: Vector3::repeat(f64::NEG_INFINITY),
            limbs: Limbs::find(&self.skeleton).map(|limbs| LimbSums { limbs, upward: Vector3::zeros() }),
            root: [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)],
            turns: Matrix3::zeros(),
        };
        let floor = FLOOR.map(|share| share * self.skeleton.height());
        for frame in 0..self.frames() {
            let WorldPose { positions: places, rotations } = self.world_pose(frame);
            reach.turns += rotations[0].to_rotation_matrix().into_inner();
            if let (Some((head, left, right)), Some(sum)) = (ends, reach.upward.as_mut()) {
                let upward = places[head] - 0.5 * (places[left] + places[right]);
                *sum += upward.try_normalize(0.0).unwrap_or_default();
            }
            if let Some(LimbSums { limbs, upward }) = reach.limbs.as_mut() {
                *upward += limbs.upward(&places);
            }
            reach.root = [reach.root[0].inf(&places[0]), reach.root[1].sup(&places[0])];
            let start = [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)];
            let [low, high] =
                places.iter().fold(start, |[low, high], place| [low.inf(place), high.sup(place)]);
            for ([touched, below], up) in reach.touched.iter_mut().zip(UpAxis::ALL) {
                let lowest = up.lowest(&low, &high);
                *touched += usize::from((floor[0]..floor[1]).contains(&lowest));
                *below += usize::from(lowest < floor[0]);
            }
            reach.low = reach.low.inf(&low);
            reach.high = reach.high.sup(&high);
        }
        reach
    }

    pub(super) fn search_up_axis(&self) -> FoundAxis {
        let reach = self.reach();
        let Some(upward) = reach.upward else {
            return FoundAxis { axis: self.axis_without_head(&reach), others: Vec::new(), is_carried: false };
        };
        let frames = self.frames().max(1) as f64;
        let height = self.skeleton.height();
        let (length, way) = (UpAxis::along(&upward), reach.way(height));
        let floors = reach.floors(self.frames(), height, length);
        let is_near_origin = reach.is_near_origin(height);
        let floor_weight = if floors.iter().filter(|floor| **floor).count() == 1 { ONLY_FLOOR } else { 1.0 };
        let rest = self.skeleton.rest_axis();
        let limbs = reach.limbs.as_ref().map_or_else(Vector3::zeros, |sums| sums.upward / frames);
        let evidence = |(axis, is_floor): (UpAxis, bool)| {
            let is_rest = rest == Some(axis);
            let floor_behind =
                UpAxis::ALL.into_iter().zip(floors).any(|(other, floor)| floor && other.is_opposite(axis));
            let (stands, limbs) = (axis.height(&upward) / frames, axis.height(&limbs));
            // A handstand: the head is below the feet, and arms carry the body.
            let is_usual = is_rest || [UpAxis::Y, UpAxis::Z].contains(&axis);
            let on_hands = is_floor && !floor_behind && is_usual && limbs > -CARRIED;
            let stands = if on_hands { stands.abs() } else { stands };
            let way = axis.height(&way).abs();
            let floor = if is_floor { floor_weight } else { 0.0 };
            let rest = if is_rest { REST } else { 0.0 };
            Evidence {
                axis,
                stands,
                is_rest,
                limbs,
                is_floor,
                way,
                score: stands + rest + LIMBS * limbs + floor - way.min(1.0),
            }
        };
        let mut all = UpAxis::ALL.into_iter().zip(floors).map(evidence).collect::<Vec<_>>();
        all.sort_by(|a, b| b.score.total_cmp(&a.score));
        let (best, rivals) = (&all[0], &all[1..]);
        let is_across = |other: &Evidence| other.axis.letter() != best.axis.letter();
        let is_on_limbs = |other: &Evidence| other.is_floor && other.limbs > CARRIED;
        let is_carried = best.is_floor && best.limbs > CARRIED;
        let found = |others| FoundAxis { axis: best.axis, others, is_carried };
        let is_certain = if best.stands > STANDS {
            // A floor below hands and knees says more than one below the feet of a body that may lie. Without a
            // floor, a body that travels along the ground stands, and so may one at the origin.
            let travels = way.amax() > best.way.max(TRAVELS);
            best.is_floor && (best.is_rest || !rivals.iter().any(is_on_limbs))
                || is_near_origin
                || travels && !rivals.iter().any(|other| is_across(other) && other.is_floor)
        } else {
            // A body that is cut by the plane at zero has a floor on both sides of the plane.
            let loses = |other: &Evidence| {
                let lead = if other.is_floor { FLOOR_LEAD } else { LEAD };
                best.score - other.score >= lead && !(other.is_floor && other.axis.is_opposite(best.axis))
            };
            best.is_floor && rivals.iter().all(loses) && (best.is_rest || best.limbs > CARRIED)
        };
        if is_certain {
            return found(Vec::new());
        }
        let climbs = is_farthest(&way, length, TRAVELS);
        let is_possible = |other: &&Evidence| {
            let lowest = other.axis.lowest(&reach.low, &reach.high) / height;
            let above_ground =
                (BENCH[0]..BENCH[1]).contains(&lowest) || climbs && other.axis.letter() != length.letter();
            other.way < TRAVELS && above_ground || climbs && other.stands > STANDS
        };
        let mut others: Vec<UpAxis> = rivals.iter().filter(is_possible).map(|other| other.axis).collect();
        if others.is_empty() && best.stands <= STANDS {
            others.push(rivals[0].axis);
        }
        found(others)
    }

    /// The axis of a body in which no head and feet are found: the longest side of the rest pose's box
    /// along which the body does not travel, y before z before x.
    fn axis_without_head(&self, reach: &Reach) -> UpAxis {
        let way = reach.root[1] - reach.root[0];
        let extent = extents(&self.skeleton.rest_pose().positions);
        let stays = |axis: &usize| way[*axis] <= extent.max();
        let longest = [1, 2, 0].into_iter().filter(stays).map(|axis| extent[axis]).fold(0.0, f64::max);
        let axis = [1, 2, 0].into_iter().filter(stays).find(|&axis| extent[axis] >= 0.999 * longest);
        UpAxis::new(axis.unwrap_or(1), false)
    }
}

#[cfg(test)]
pub(super) mod tests;
