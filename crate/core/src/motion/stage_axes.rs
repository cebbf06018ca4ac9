//! The axis of a file's world that points up.

use crate::motion::rotation;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// The axis that points up in a file, away from the ground; "-z": z points down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "types",
    derive(ts_rs::TS),
    ts(type = "\"x\" | \"y\" | \"z\" | \"-x\" | \"-y\" | \"-z\"")
)]
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
    pub(crate) const ALL: [UpAxis; 6] =
        [UpAxis::X, UpAxis::Y, UpAxis::Z, UpAxis::MinusX, UpAxis::MinusY, UpAxis::MinusZ];

    /// Its name in a document and in the terminal: "x", or "-x" where x points down.
    pub fn name(self) -> &'static str {
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
    pub fn from_name(name: &str) -> Option<UpAxis> {
        UpAxis::ALL.into_iter().find(|axis| axis.name() == name)
    }

    pub(crate) fn new(axis: usize, down: bool) -> UpAxis {
        match (axis, down) {
            (0, false) => UpAxis::X,
            (0, true) => UpAxis::MinusX,
            (1, false) => UpAxis::Y,
            (1, true) => UpAxis::MinusY,
            (_, false) => UpAxis::Z,
            (_, true) => UpAxis::MinusZ,
        }
    }

    /// The axis along which a vector has its largest component.
    pub(crate) fn along(vector: &Vector3<f64>) -> UpAxis {
        UpAxis::new(vector.iamax(), vector[vector.iamax()] < 0.0)
    }

    /// Whether the other axis points the other way.
    pub(crate) fn is_opposite(self, other: UpAxis) -> bool {
        self != other && self.letter() == other.letter()
    }

    /// The height of the lowest point of a box between two corners.
    pub(crate) fn lowest(self, low: &Vector3<f64>, high: &Vector3<f64>) -> f64 {
        self.height(low).min(self.height(high))
    }

    /// The height of a point.
    pub(crate) fn height(self, place: &Vector3<f64>) -> f64 {
        match self {
            UpAxis::X => place.x,
            UpAxis::Y => place.y,
            UpAxis::Z => place.z,
            UpAxis::MinusX => -place.x,
            UpAxis::MinusY => -place.y,
            UpAxis::MinusZ => -place.z,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_axis_has_one_opposite() {
        for axis in UpAxis::ALL {
            let opposites: Vec<UpAxis> =
                UpAxis::ALL.into_iter().filter(|other| axis.is_opposite(*other)).collect();
            assert_eq!(opposites.len(), 1, "{axis:?}: {opposites:?}");
            assert_eq!(opposites[0].height(&Vector3::repeat(1.0)), -axis.height(&Vector3::repeat(1.0)));
        }
    }
}
