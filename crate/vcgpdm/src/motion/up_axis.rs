//! Finds the axis that points up from the motion, the rest pose, the way of the root and the floor.

use crate::motion::anatomy::{Anatomy, Standing, standing_at_rest};
use crate::motion::clip::Clip;
use crate::motion::joint_names::Side;
use crate::motion::limbs::{Limbs, extents, is_clear};
use crate::motion::stage_axes::UpAxis;
use nalgebra::Vector3;

/// The start of the warning about an axis that is not certain.
const UNCERTAIN: &str = "the up axis is not certain";
/// A point is near zero within this share of the body's height.
const NEAR_ZERO: f64 = 0.1;
/// The floor is a plane near zero that the body touches in this share of the frames.
const TOUCHED: f64 = 0.95;
/// A body whose root moves by this share of its height along its up axis, and farther than along the others,
/// climbs or lies.
const CLIMBS: f64 = 0.7;
/// A lying body is thinner than this share of its height.
const THIN: f64 = 0.5;
/// The least evidence against the axis of the rest pose: a body on a ladder climbs along this axis too.
const EVIDENCE: f64 = 0.35;
/// The evidence for an axis along which the body of the rest pose stands.
const REST: f64 = 0.6;
/// A body stays when its root moves by less than this share of its height. A standing body that stays far from
/// the origin and above no floor at zero may lie on a bench,
const STAYS: f64 = 0.3;
/// which is lower than this share of its height.
const BENCH: f64 = 0.7;
/// Fewer frames show nothing.
const FEW_FRAMES: usize = 10;
/// Axes are equally likely when their evidence differs by less.
const EQUAL: f64 = 0.5;

/// Directions and extremes of a body over a whole clip, in file units.
pub(super) struct Reach {
    /// The sum of the unit vectors from the feet to the head; `None` if feet or head were not found.
    upward: Option<Vector3<f64>>,
    /// The smallest coordinate along each axis.
    pub(super) low: Vector3<f64>,
    /// The largest coordinate along each axis.
    pub(super) high: Vector3<f64>,
    /// For each of [`UpAxis::ALL`] the number of frames whose lowest point along the axis is near zero.
    at_zero: [usize; 6],
    /// The sum of the sizes of the body along each axis.
    extent: Vector3<f64>,
    /// The limbs, if there are any.
    limbs: Option<LimbSums>,
    /// The smallest and largest coordinate of the root along each axis.
    root: [Vector3<f64>; 2],
}

/// What the limbs do over a whole clip.
struct LimbSums {
    limbs: Limbs,
    /// The sum of [`Limbs::upward`].
    upward: Vector3<f64>,
    /// The sum of [`Limbs::on_ground`] for each of [`UpAxis::ALL`].
    on_ground: [f64; 6],
}

/// The axis that points up.
pub(super) struct FoundAxis {
    pub(super) axis: UpAxis,
    /// Axes that may point up instead.
    pub(super) others: Vec<UpAxis>,
}

impl Reach {
    /// How well the axis explains the clip: the mean share of the limbs on one plane, less the way of the root
    /// along the axis in body heights. A body travels along the ground.
    fn evidence(&self, sums: &LimbSums, up: UpAxis, frames: usize, height: f64) -> f64 {
        let place = UpAxis::ALL.iter().position(|&axis| axis == up).unwrap_or_default();
        let way = up.height(&(self.root[1] - self.root[0])).abs();
        sums.on_ground[place] / frames.max(1) as f64 - (way / height).min(1.0)
    }
}

impl Clip {
    /// The axis that points up: [`Clip::up`] if it is stated. Else from the feet to the head in the motion, or
    /// in the rest pose if the motion is not clear. Where the limbs carry the body along another axis, as those
    /// of animals do, the axis counts that has more limbs on one plane and less travel. A body that travels
    /// along its own length, or that lies on a floor at zero, lies: limbs, floor and rest pose decide.
    pub fn up_axis(&self) -> UpAxis {
        self.up.unwrap_or_else(|| self.up_axis_of(&self.reach()).axis)
    }

    /// The clip in which this axis points up.
    #[must_use]
    pub fn with_up(&self, up: UpAxis) -> Clip {
        let mut clip = Clip { up: Some(up), ..self.clone() };
        clip.warnings.retain(|warning| !warning.starts_with(UNCERTAIN));
        clip
    }

    /// The clip with a warning if two axes are equally likely to point up.
    pub(super) fn with_checked_axis(mut self) -> Clip {
        let FoundAxis { axis, others } = self.up_axis_of(&self.reach());
        if !others.is_empty() {
            let axis = axis.name();
            let other = others.iter().map(|other| other.name()).collect::<Vec<_>>().join(" or ");
            self.warnings.push(format!(
                "{UNCERTAIN}: {axis} is used, but {other} is possible too, because the body moves along its own \
                 length or is above no floor at 0. If {axis} is wrong, state the axis: --up in the \
                 terminal, with_up in Python, withUp in the npm package"
            ));
        }
        self
    }

    /// Computes the reach frame by frame, without the positions of all frames in memory.
    pub(super) fn reach(&self) -> Reach {
        let ends = Anatomy::find(&self.skeleton).and_then(|anatomy| {
            let foot = |side| anatomy.foot(&self.skeleton, side);
            Some((anatomy.head(&self.skeleton)?, foot(Side::Left)?, foot(Side::Right)?))
        });
        let mut reach = Reach {
            upward: ends.map(|_| Vector3::zeros()),
            at_zero: [0; 6],
            extent: Vector3::zeros(),
            low: Vector3::repeat(f64::INFINITY),
            high: Vector3::repeat(f64::NEG_INFINITY),
            limbs: Limbs::find(&self.skeleton).map(|limbs| LimbSums {
                limbs,
                upward: Vector3::zeros(),
                on_ground: [0.0; 6],
            }),
            root: [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)],
        };
        let near = NEAR_ZERO * self.skeleton.height();
        for frame in 0..self.frames() {
            let places = self.world_pose(frame).positions;
            if let (Some((head, left, right)), Some(sum)) = (ends, reach.upward.as_mut()) {
                let upward = places[head] - 0.5 * (places[left] + places[right]);
                *sum += upward.try_normalize(0.0).unwrap_or_default();
            }
            if let Some(LimbSums { limbs, upward, on_ground }) = reach.limbs.as_mut() {
                *upward += limbs.upward(&places);
                for (sum, up) in on_ground.iter_mut().zip(UpAxis::ALL) {
                    *sum += limbs.on_ground(&places, up);
                }
            }
            reach.root = [reach.root[0].inf(&places[0]), reach.root[1].sup(&places[0])];
            let start = [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)];
            let [low, high] =
                places.iter().fold(start, |[low, high], place| [low.inf(place), high.sup(place)]);
            for (count, up) in reach.at_zero.iter_mut().zip(UpAxis::ALL) {
                *count += usize::from(up.height(&low).min(up.height(&high)).abs() < near);
            }
            reach.extent += high - low;
            reach.low = reach.low.inf(&low);
            reach.high = reach.high.sup(&high);
        }
        reach
    }

    pub(super) fn up_axis_of(&self, reach: &Reach) -> FoundAxis {
        if let Some(axis) = self.up {
            return FoundAxis { axis, others: Vec::new() };
        }
        let rest =
            Anatomy::find(&self.skeleton).and_then(|anatomy| standing_at_rest(&self.skeleton, &anatomy));
        let usual = self.standing_axis(reach, rest.as_ref());
        match (&reach.limbs, reach.upward) {
            (Some(sums), Some(_)) => self.lying_axis(reach, sums, rest.as_ref(), usual),
            _ => FoundAxis { axis: usual, others: Vec::new() },
        }
    }

    /// Another axis than `usual`, along which the body stands, if the body lies.
    fn lying_axis(
        &self,
        reach: &Reach,
        sums: &LimbSums,
        rest: Option<&Standing>,
        usual: UpAxis,
    ) -> FoundAxis {
        let frames = self.frames().max(1) as f64;
        let height = self.skeleton.height();
        let way = reach.root[1] - reach.root[0];
        let along = |axis: UpAxis, sizes: &Vector3<f64>| axis.height(sizes).abs();
        let climbs = along(usual, &way) > CLIMBS * height && along(usual, &way) >= way.amax();
        let place = |axis: UpAxis| UpAxis::ALL.iter().position(|&other| other == axis).unwrap_or_default();
        let touched = |axis: UpAxis| reach.at_zero[place(axis)] as f64 / frames;
        let is_floor =
            |axis: UpAxis| touched(axis) > TOUCHED && along(axis, &reach.extent) < THIN * height * frames;
        let floors = UpAxis::ALL.into_iter().filter(|&axis| is_floor(axis)).count();
        let lies = touched(usual) < 1.0 - TOUCHED && floors == 1;
        let floats = touched(usual) < 1.0 - TOUCHED && self.floats(reach, height);
        if !climbs && !lies && !floats {
            return FoundAxis { axis: usual, others: Vec::new() };
        }
        let rest = rest.map(|rest| UpAxis::new(rest.upward.iamax(), rest.upward[rest.upward.iamax()] < 0.0));
        let limbs = sums.upward / frames;
        let evidence = |&axis: &UpAxis| {
            let stands = if rest == Some(axis) { REST } else { 0.0 };
            let floor = if is_floor(axis) { 1.0 } else { 0.0 };
            let thickness = 0.5 * along(axis, &reach.extent) / frames;
            axis.height(&limbs) + floor + stands - (along(axis, &way).min(height) + thickness) / height
        };
        let mut others: Vec<UpAxis> =
            UpAxis::ALL.into_iter().filter(|axis| axis.letter() != usual.letter()).collect();
        others.sort_unstable_by(|a, b| evidence(b).total_cmp(&evidence(a)));
        let (first, second) = (others[0], others[1]);
        let lowest = |axis: UpAxis| axis.height(&reach.low).min(axis.height(&reach.high)) / height;
        // The axes of a body on a bench, but `axis`.
        let bench = |axis: UpAxis| -> Vec<UpAxis> {
            let is_bench = |other: &UpAxis| *other != axis && (-NEAR_ZERO..BENCH).contains(&lowest(*other));
            others.iter().copied().filter(|other| floats && is_bench(other)).collect()
        };
        let is_rest = rest.is_none_or(|rest| rest == usual);
        let points_up = is_clear(&limbs) && first.height(&limbs) == limbs.amax();
        let is_lying =
            (evidence(&first) >= EVIDENCE || points_up) && (climbs || first.height(&limbs) >= EVIDENCE);
        // A body on a ladder climbs along the axis of its rest pose, and one beside a wall touches the wall.
        if is_rest && !is_lying || !climbs && !lies {
            return FoundAxis { axis: usual, others: if climbs { vec![first] } else { bench(usual) } };
        }
        let is_equal = evidence(&first) - evidence(&second) < EQUAL;
        let others = match (is_equal, rest == Some(first)) {
            (true, _) => vec![second],
            (false, true) => Vec::new(),
            (false, false) => bench(first),
        };
        FoundAxis { axis: first, others }
    }

    /// Whether the body stays at one place that is not the origin of the world.
    fn floats(&self, reach: &Reach, height: f64) -> bool {
        let [low, high] = reach.root.map(|corner| corner / height);
        let stays = (high - low).amax() < STAYS;
        stays && (0.5 * (low + high)).norm() > STAYS && self.frames() >= FEW_FRAMES
    }

    /// The axis along which the body stands.
    fn standing_axis(&self, reach: &Reach, rest: Option<&Standing>) -> UpAxis {
        let usual = self.up_axis_of_head(reach, rest);
        let Some(sums) = &reach.limbs else { return usual };
        let is_upright = |rest: &Standing| {
            !rest.on_limbs && UpAxis::new(rest.upward.iamax(), false).letter() == usual.letter()
        };
        if rest.is_some_and(is_upright) {
            return usual;
        }
        let upward = sums.upward / self.frames().max(1) as f64;
        let by_limbs = UpAxis::new(upward.iamax(), upward[upward.iamax()] < 0.0);
        if !is_clear(&upward) || by_limbs.letter() == usual.letter() {
            return usual;
        }
        let evidence = |up| reach.evidence(sums, up, self.frames(), self.skeleton.height());
        if evidence(by_limbs) > evidence(usual) { by_limbs } else { usual }
    }

    fn up_axis_of_head(&self, reach: &Reach, rest: Option<&Standing>) -> UpAxis {
        if Anatomy::find(&self.skeleton).is_none() {
            // Without limbs: the longest side of the rest pose's box along which the body does not travel, y
            // before z before x.
            let extent = extents(&self.skeleton.rest_pose().positions);
            let way = reach.root[1] - reach.root[0];
            let stays = |axis: &usize| way[*axis] <= extent.max();
            let longest = [1, 2, 0].into_iter().filter(stays).map(|axis| extent[axis]).fold(0.0, f64::max);
            let axis = [1, 2, 0].into_iter().filter(stays).find(|&axis| extent[axis] >= 0.999 * longest);
            return UpAxis::new(axis.unwrap_or(1), false);
        }
        let Some(mean) = reach.upward else { return UpAxis::Y };
        let (clear, axis) = (mean.amax() > 0.8 * mean.norm(), mean.iamax());
        let ends = |axis: usize| (reach.low[axis], reach.high[axis]);
        let near_zero = |x: f64| x.abs() < NEAR_ZERO * self.skeleton.height();
        if let Some(Standing { upward: rest, .. }) = rest {
            let standing = rest.iamax();
            // A body that lies on the ground in the whole clip points along another axis than the rest pose.
            // Its lowest point is then near zero along the true up axis.
            let on_ground = near_zero(ends(standing).0) && !near_zero(ends(axis).0);
            if standing != axis && (!clear || on_ground) {
                return UpAxis::new(standing, rest[standing] < 0.0);
            }
        }
        // A body upside down means that the axis points down, unless it stands on its hands on the ground.
        let (low, high) = ends(axis);
        let on_hands = near_zero(low) && !near_zero(high);
        UpAxis::new(axis, clear && mean[axis] < 0.0 && !on_hands)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{rotation, samples};
    use nalgebra::{DMatrix, UnitQuaternion};
    use std::f64::consts::{FRAC_PI_2, TAU};

    /// A motion of the sample body in a world with y up, from the angle about x that tilts the root, the place
    /// of the root, its turn about its own length, and the rotation of each joint.
    fn motion(
        tilt: f64,
        place: impl Fn(f64) -> Vector3<f64>,
        roll: impl Fn(f64) -> f64,
        joint: impl Fn(&str, f64) -> UnitQuaternion<f64>,
    ) -> Clip {
        let body = samples::clip("walk-1").unwrap().skeleton;
        let mut clip = Clip::new("made", body.clone(), 0.05, DMatrix::zeros(60, body.channel_count()));
        set(&mut clip, |frame, index, name| {
            let t = 0.05 * frame as f64;
            let root = rotation::about_axis(0, tilt) * rotation::about_axis(1, roll(t));
            (if index == 0 { root } else { joint(name, t) }, place(t))
        });
        clip
    }

    /// Sets the rotations of all joints and the place of the root.
    fn set(clip: &mut Clip, pose: impl Fn(usize, usize, &str) -> (UnitQuaternion<f64>, Vector3<f64>)) {
        let starts = clip.skeleton.channel_starts();
        for frame in 0..clip.frames() {
            for (index, joint) in clip.skeleton.joints.iter().enumerate() {
                let (turn, place) = pose(frame, index, &joint.name);
                let axes: Vec<usize> = joint.rotation_axes().collect();
                let mut angles = rotation::angles_near(&turn, &axes, &[0.0; 3]).into_iter();
                for (column, channel) in (starts[index]..).zip(&joint.channels) {
                    clip.values[(frame, column)] = if channel.is_rotation() {
                        angles.next().unwrap().to_degrees()
                    } else {
                        place[channel.axis()]
                    };
                }
            }
        }
    }

    /// The same motion in a turned world: by the root alone, or by the rest pose too.
    fn in_world(clip: &Clip, turn: UnitQuaternion<f64>, with_rest: bool) -> Clip {
        let mut other = clip.clone();
        if with_rest {
            for joint in &mut other.skeleton.joints {
                joint.offset = (turn * Vector3::from(joint.offset)).into();
                joint.end_sites.iter_mut().for_each(|end| *end = (turn * Vector3::from(*end)).into());
            }
        }
        set(&mut other, |frame, index, _| {
            let pose = clip.local_pose(frame);
            let own = pose.rotations[index];
            let turned = match (with_rest, index) {
                (true, _) => turn * own * turn.inverse(),
                (false, 0) => turn * own,
                (false, _) => own,
            };
            (turned, turn * pose.positions[0])
        });
        other
    }

    fn about(axis: usize, degrees: f64) -> UnitQuaternion<f64> {
        rotation::about_axis(axis, degrees.to_radians())
    }

    fn swing(t: f64, side: f64) -> f64 {
        side * (TAU * t / 1.2).sin()
    }

    fn side(name: &str) -> f64 {
        if name.starts_with("Left") { 1.0 } else { -1.0 }
    }

    /// On hands and knees, at the place of the world where the recording began.
    fn crawl(start: Vector3<f64>) -> Clip {
        motion(
            FRAC_PI_2,
            |t| start + Vector3::new(0.0, 75.0, 45.0 * t),
            |_| 0.0,
            |name, t| match name {
                "LeftArm" | "RightArm" => about(1, -side(name) * (90.0 + 20.0 * swing(t, side(name)))),
                "LeftUpLeg" | "RightUpLeg" => about(0, -90.0 + 15.0 * swing(t, side(name))),
                "LeftLeg" | "RightLeg" => about(0, 90.0),
                _ => UnitQuaternion::identity(),
            },
        )
    }

    fn swim(start: Vector3<f64>) -> Clip {
        motion(
            FRAC_PI_2,
            |t| start + Vector3::new(0.0, 100.0, 70.0 * t),
            |t| 0.3 * swing(t, 1.0),
            |name, t| match name {
                "LeftArm" | "RightArm" => about(2, side(name) * (80.0 + 40.0 * swing(t, side(name)))),
                "LeftUpLeg" | "RightUpLeg" => about(0, 12.0 * swing(t, side(name))),
                _ => UnitQuaternion::identity(),
            },
        )
    }

    fn roll(start: Vector3<f64>) -> Clip {
        motion(
            -FRAC_PI_2,
            |t| start + Vector3::new(30.0 * t, 14.0, 0.0),
            |t| -2.0 * t,
            |name, _| match name {
                "LeftArm" | "RightArm" => about(2, side(name) * -85.0),
                _ => UnitQuaternion::identity(),
            },
        )
    }

    fn is_certain(clip: &Clip) -> bool {
        clip.up_axis_of(&clip.reach()).others.is_empty()
    }

    #[test]
    fn the_axis_is_found_in_every_world_or_two_axes_are_named() {
        let places = [Vector3::new(120.0, 0.0, 260.0), Vector3::new(-200.0, 0.0, -400.0)];
        let mut clips = vec![("walk", samples::clip("walk-1").unwrap())];
        for place in places {
            clips.extend([("crawl", crawl(place)), ("swim", swim(place)), ("roll", roll(place))]);
        }
        let mut wrong = Vec::new();
        for (name, clip) in &clips {
            for up in UpAxis::ALL {
                for with_rest in [false, true] {
                    let turned = in_world(clip, up.to_y_up().inverse(), with_rest);
                    let found = turned.up_axis();
                    let is_named = *name == "swim" && !with_rest && !is_certain(&turned);
                    // A swimmer in a world that points down looks as one on its back, and a body that rolls
                    // about the axis of its rest pose looks as one that turns while it stands.
                    let hidden = [("swim", UpAxis::MinusY), ("roll", UpAxis::Z)];
                    let is_hidden = !with_rest && hidden.contains(&(*name, up));
                    let is_named = is_named || *name == "roll" && !is_certain(&turned);
                    if found != up && !is_named && !is_hidden || *name == "walk" && !is_certain(&turned) {
                        let certain = is_certain(&turned);
                        wrong.push(format!("{name}, {up:?}, {with_rest}: {found:?} {certain}"));
                    }
                }
            }
        }
        assert!(wrong.is_empty(), "{wrong:#?}");
    }

    #[test]
    fn a_body_on_a_bench_may_lie_or_stand() {
        let place = Vector3::new(150.0, 60.0, 230.0);
        let bench = motion(
            -FRAC_PI_2,
            |_| place,
            |_| 0.0,
            |name, t| match name {
                "LeftArm" | "RightArm" => about(1, side(name) * (20.0 * swing(t, 1.0) - 90.0)),
                _ => UnitQuaternion::identity(),
            },
        );
        for up in UpAxis::ALL {
            let turned = in_world(&bench, up.to_y_up().inverse(), false);
            let FoundAxis { axis, others } = turned.up_axis_of(&turned.reach());
            assert!(axis == up || others.contains(&up), "{up:?}: {axis:?}, {others:?}");
        }
    }

    #[test]
    fn an_axis_that_is_not_certain_is_said_until_it_is_stated() {
        let turned = in_world(&swim(Vector3::zeros()), UpAxis::Z.to_y_up().inverse(), false);
        let clip = turned.with_checked_axis();
        assert!(clip.warnings[0].starts_with(UNCERTAIN), "{:?}", clip.warnings);
        let stated = clip.with_up(UpAxis::Z);
        assert_eq!((stated.up_axis(), stated.warnings.len()), (UpAxis::Z, 0));
        assert!(samples::clip("walk-1").unwrap().with_checked_axis().warnings.is_empty());
    }
}
