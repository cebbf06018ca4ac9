//! The stage: the world in which bodies are shown, in metres, with y up, the ground at y = 0 and every body
//! 1.7 m tall. Finds the up axis, the height of the body and the ground of a clip.

use crate::motion::anatomy::{Anatomy, extents, standing_at_rest};
use crate::motion::clip::Clip;
use crate::motion::joint_names::Side;
use crate::motion::percentile::upper_end;
use crate::motion::rotation;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// The height of every body on the stage, in metres.
pub const STAGE_HEIGHT: f64 = 1.7;

/// The axis of the file's world that points away from the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpAxis {
    /// x points up.
    X,
    /// y points up.
    Y,
    /// z points up.
    Z,
    /// x points down.
    MinusX,
    /// y points down.
    MinusY,
    /// z points down.
    MinusZ,
}

impl UpAxis {
    const ALL: [UpAxis; 6] =
        [UpAxis::X, UpAxis::Y, UpAxis::Z, UpAxis::MinusX, UpAxis::MinusY, UpAxis::MinusZ];

    /// Its name in a document: "x", or "-x" where x points down.
    pub(crate) fn name(self) -> &'static str {
        match self {
            UpAxis::X => "x",
            UpAxis::Y => "y",
            UpAxis::Z => "z",
            UpAxis::MinusX => "-x",
            UpAxis::MinusY => "-y",
            UpAxis::MinusZ => "-z",
        }
    }

    /// The axis of that name.
    pub(crate) fn from_name(name: &str) -> Option<UpAxis> {
        UpAxis::ALL.into_iter().find(|axis| axis.name() == name)
    }

    fn new(axis: usize, down: bool) -> UpAxis {
        match (axis, down) {
            (0, false) => UpAxis::X,
            (0, true) => UpAxis::MinusX,
            (1, false) => UpAxis::Y,
            (1, true) => UpAxis::MinusY,
            (_, false) => UpAxis::Z,
            (_, true) => UpAxis::MinusZ,
        }
    }

    /// The axis without its sign: "x", "y" or "z".
    pub fn letter(self) -> &'static str {
        self.name().trim_start_matches('-')
    }

    /// The rotation from the file's world to one with y up.
    pub fn to_y_up(self) -> UnitQuaternion<f64> {
        match self {
            UpAxis::X => rotation::about_axis(2, FRAC_PI_2),
            UpAxis::Y => UnitQuaternion::identity(),
            UpAxis::Z => rotation::about_axis(0, -FRAC_PI_2),
            UpAxis::MinusX => rotation::about_axis(2, -FRAC_PI_2),
            UpAxis::MinusY => rotation::about_axis(0, PI),
            UpAxis::MinusZ => rotation::about_axis(0, FRAC_PI_2),
        }
    }
}

/// The quantities that bring a clip to the stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// The axis that points up in the file.
    pub up: UpAxis,
    /// Height of the body in file units.
    pub height: f64,
    /// Height of the ground in file units: the lowest point of the body in the clip.
    pub ground: f64,
}

impl Stage {
    /// Metres on the stage for one file unit.
    pub fn metres_per_unit(&self) -> f64 {
        STAGE_HEIGHT / self.height
    }

    /// The stage coordinates [x, y, z] of a point with y up in file units.
    pub(crate) fn place(&self, y_up: &Vector3<f64>) -> [f32; 3] {
        let scale = self.metres_per_unit();
        [(y_up.x * scale) as f32, ((y_up.y - self.ground) * scale) as f32, (y_up.z * scale) as f32]
    }
}

/// Directions and extremes of a body over a whole clip, in file units.
struct Reach {
    /// The sum of the unit vectors from the feet to the head; `None` if feet or head were not found.
    upward: Option<Vector3<f64>>,
    /// The smallest coordinate along each axis.
    low: Vector3<f64>,
    /// The largest coordinate along each axis.
    high: Vector3<f64>,
}

impl Clip {
    /// The up axis, the height of the body and the ground.
    pub fn stage(&self) -> Stage {
        let reach = self.reach();
        let up = self.up_axis_of(&reach);
        let turn = up.to_y_up();
        let lowest =
            [reach.low, reach.high].map(|corner| (turn * corner).y).into_iter().fold(f64::INFINITY, f64::min);
        let ground = if lowest.is_finite() { lowest } else { 0.0 };
        Stage { up, height: self.height_with(up), ground }
    }

    /// The axis that points up: from the feet to the head in the motion, or in the rest pose if the motion is
    /// not clear.
    pub fn up_axis(&self) -> UpAxis {
        self.up_axis_of(&self.reach())
    }

    /// The body's height in file units: see [`Skeleton::height`](crate::motion::skeleton::Skeleton::height);
    /// for a skeleton whose rest pose does not stand, the 95th percentile of the height of the body without
    /// its arms over the frames.
    pub fn height(&self) -> f64 {
        self.height_with(self.up_axis())
    }

    /// Stage positions of the figure's nodes [frames x nodes x 3]: y up, metres, the body 1.7 m tall, its
    /// lowest point over the clip at y = 0.
    pub fn stage_positions(&self) -> Vec<f32> {
        let stage = self.stage();
        let turn = stage.up.to_y_up();
        let mut all = Vec::with_capacity(self.frames() * self.skeleton.node_count() * 3);
        for frame in 0..self.frames() {
            let places = self.world_pose(frame).positions;
            all.extend(places.iter().flat_map(|place| stage.place(&(turn * place))));
        }
        all
    }

    /// Computes the reach frame by frame, without the positions of all frames in memory.
    fn reach(&self) -> Reach {
        let ends = Anatomy::find(&self.skeleton).and_then(|anatomy| {
            let foot = |side| anatomy.foot(&self.skeleton, side);
            Some((anatomy.head(&self.skeleton)?, foot(Side::Left)?, foot(Side::Right)?))
        });
        let mut reach = Reach {
            upward: ends.map(|_| Vector3::zeros()),
            low: Vector3::repeat(f64::INFINITY),
            high: Vector3::repeat(f64::NEG_INFINITY),
        };
        for frame in 0..self.frames() {
            let places = self.world_pose(frame).positions;
            if let (Some((head, left, right)), Some(sum)) = (ends, reach.upward.as_mut()) {
                let upward = places[head] - 0.5 * (places[left] + places[right]);
                *sum += upward.try_normalize(0.0).unwrap_or_default();
            }
            for place in &places {
                reach.low = reach.low.inf(place);
                reach.high = reach.high.sup(place);
            }
        }
        reach
    }

    fn up_axis_of(&self, reach: &Reach) -> UpAxis {
        let Some(anatomy) = Anatomy::find(&self.skeleton) else {
            // Without limbs: the longest side of the rest pose's box, y before z before x.
            let extent = extents(&self.skeleton.rest_pose().positions);
            let longest = extent.max() * 0.999;
            let axis = [1, 2, 0].into_iter().find(|&axis| extent[axis] >= longest).unwrap_or(1);
            return UpAxis::new(axis, false);
        };
        let rest = standing_at_rest(&self.skeleton, &anatomy);
        let Some(mean) = reach.upward else { return UpAxis::Y };
        let (clear, axis) = (mean.amax() > 0.8 * mean.norm(), mean.iamax());
        let ends = |axis: usize| (reach.low[axis], reach.high[axis]);
        let near_zero = |x: f64| x.abs() < 0.1 * self.skeleton.height();
        if let Some(rest) = rest {
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

    fn height_with(&self, up: UpAxis) -> f64 {
        let height = match Anatomy::find(&self.skeleton) {
            Some(anatomy) if self.frames() > 0 && standing_at_rest(&self.skeleton, &anatomy).is_none() => {
                let turn = up.to_y_up();
                let extent = |frame| {
                    let body = anatomy.without_arms(&self.skeleton, &self.world_pose(frame).positions);
                    extents(&body.iter().map(|place| turn * place).collect::<Vec<_>>()).y
                };
                upper_end((0..self.frames()).map(extent).collect()).0
            }
            _ => self.skeleton.height(),
        };
        // A single joint has no height; a positive number avoids a division by zero.
        if height > 1e-9 { height } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::samples;

    fn clips() -> Vec<Clip> {
        samples::list().iter().map(|info| samples::clip(info.id).unwrap()).collect()
    }

    /// A sample clip whose world is turned.
    fn in_other_world(clip: &Clip, turn: UnitQuaternion<f64>) -> Clip {
        let mut clip = clip.clone();
        let channels = clip.skeleton.joints[0].channels.clone();
        let axes: Vec<usize> = clip.skeleton.joints[0].rotation_axes().collect();
        for t in 0..clip.frames() {
            let pose = clip.local_pose(t);
            let place = turn * pose.positions[0];
            let angles = rotation::angles_near(&(turn * pose.rotations[0]), &axes, &[0.0; 3]);
            let mut angles = angles.into_iter();
            for (column, channel) in channels.iter().enumerate() {
                clip.values[(t, column)] = if channel.is_rotation() {
                    angles.next().unwrap().to_degrees()
                } else {
                    place[channel.axis()]
                };
            }
        }
        clip
    }

    #[test]
    fn every_up_axis_is_found_and_gives_the_same_positions() {
        let clip = &clips()[0];
        let upright = clip.stage_positions();
        assert_eq!(clip.up_axis(), UpAxis::Y);
        for up in [UpAxis::X, UpAxis::Y, UpAxis::Z, UpAxis::MinusX, UpAxis::MinusY, UpAxis::MinusZ] {
            let turned = in_other_world(clip, up.to_y_up().inverse());
            assert_eq!(turned.up_axis(), up);
            for (a, b) in turned.stage_positions().iter().zip(&upright) {
                assert!((a - b).abs() < 1e-5, "{up:?}");
            }
        }
    }

    #[test]
    fn the_body_stands_on_the_ground_and_is_1_7_m_tall() {
        for clip in clips() {
            let nodes = clip.skeleton.figure().len();
            let places = clip.stage_positions();
            assert_eq!(places.len(), clip.frames() * nodes * 3);
            let heights: Vec<f32> = places.chunks_exact(3).map(|place| place[1]).collect();
            let low = heights.iter().copied().fold(f32::INFINITY, f32::min);
            assert!(low.abs() < 1e-6, "{low}");
            for frame in heights.chunks_exact(nodes) {
                let top = frame[..clip.skeleton.joints.len()].iter().copied().fold(0.0, f32::max);
                assert!((1.3..1.9).contains(&top), "{}: {top}", clip.name);
            }
        }
    }

    #[test]
    fn a_body_lying_on_the_ground_does_not_turn_the_world() {
        let mut clip = in_other_world(&clips()[0], rotation::about_axis(0, FRAC_PI_2));
        // Somewhere on the ground of a world with y up, on its front.
        let stage = clip.stage();
        let columns = clip.skeleton.joints[0]
            .channels
            .iter()
            .position(|channel| *channel == crate::motion::skeleton::Channel::Zposition);
        clip.values.column_mut(columns.unwrap()).add_scalar_mut(7.3 * stage.height);
        let low = (0..clip.frames())
            .flat_map(|t| clip.world_pose(t).positions)
            .map(|p| p.y)
            .fold(f64::INFINITY, f64::min);
        let y = clip.skeleton.joints[0]
            .channels
            .iter()
            .position(|channel| *channel == crate::motion::skeleton::Channel::Yposition);
        clip.values.column_mut(y.unwrap()).add_scalar_mut(-low);
        assert_eq!(clip.up_axis(), UpAxis::Y);
    }
}
