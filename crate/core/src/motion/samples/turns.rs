//! Rotations about the axes by angles in degrees. They are not inlined: the many calls would make the wasm of a
//! first visit larger.

use crate::motion::rotation;
use nalgebra::UnitQuaternion;

/// The rotation about x by an angle in degrees.
#[inline(never)]
pub(super) fn x(degrees: f64) -> UnitQuaternion<f64> {
    rotation::about_axis(0, degrees.to_radians())
}

/// The rotation about y by an angle in degrees.
#[inline(never)]
pub(super) fn y(degrees: f64) -> UnitQuaternion<f64> {
    rotation::about_axis(1, degrees.to_radians())
}

/// The rotation about z by an angle in degrees.
#[inline(never)]
pub(super) fn z(degrees: f64) -> UnitQuaternion<f64> {
    rotation::about_axis(2, degrees.to_radians())
}

/// Half the way of a rotation.
#[inline(never)]
pub(super) fn half(q: &UnitQuaternion<f64>) -> UnitQuaternion<f64> {
    rotation::exp(&(rotation::log(q) * 0.5))
}
