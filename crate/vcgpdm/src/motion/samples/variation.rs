//! Random variation between trials and between steps: seeded, and smooth in time.

use crate::elementary::Elementary;
use crate::motion::rotation;
use crate::motion::samples::body::joint;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardUniform};
use std::f64::consts::TAU;

/// A slow, nearly aperiodic variation: a sum of sinusoids with seeded frequencies and phases. Standard
/// deviation about 1.
#[derive(Clone, Debug)]
pub(super) struct Drift {
    /// Amplitude, frequency (hertz) and phase (cycles) of each sinusoid.
    waves: [[f64; 3]; 4],
}

impl Drift {
    /// Draws a drift that changes over seconds.
    pub fn new(random: &mut ChaCha8Rng) -> Drift {
        let mut waves = [[0.0; 3]; 4];
        for (wave, slowest) in waves.iter_mut().zip([0.05, 0.12, 0.22, 0.35]) {
            let amplitude = 0.55 + 0.3 * between(random, 0.0, 1.0);
            *wave = [amplitude, slowest * between(random, 1.0, 1.6), between(random, 0.0, 1.0)];
        }
        Drift { waves }
    }

    /// The drift at a time in seconds.
    pub fn at(&self, seconds: f64) -> f64 {
        self.waves
            .iter()
            .map(|[amplitude, hertz, phase]| amplitude * (TAU * (hertz * seconds + phase)).sine())
            .sum()
    }
}

/// A number drawn uniformly between two others.
pub(super) fn between(random: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
    let u: f64 = StandardUniform.sample(random);
    low + (high - low) * u
}

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

/// Frames a second.
pub(super) const RATE: f64 = 60.0;

/// The frames of a clip of [`skeleton`](super::body::skeleton).
pub(super) struct Frames {
    /// [frames x channels]: positions in centimetres, angles in degrees.
    pub values: DMatrix<f64>,
    /// The angles of the last frame, radians: the next ones are those nearest to them.
    angles: [[f64; 3]; joint::COUNT],
    added: usize,
}

impl Frames {
    /// `frames` frames, all zero.
    pub fn new(frames: usize) -> Frames {
        let values = DMatrix::zeros(frames, 3 + 3 * joint::COUNT);
        Frames { values, angles: [[0.0; 3]; joint::COUNT], added: 0 }
    }

    /// Writes the next frame: the place of the root and the local rotations of the joints.
    pub fn add(&mut self, place: &Vector3<f64>, q: &[UnitQuaternion<f64>; joint::COUNT]) {
        let mut row = self.values.row_mut(self.added);
        for (column, coordinate) in place.iter().enumerate() {
            row[column] = *coordinate;
        }
        for (k, rotation) in q.iter().enumerate() {
            self.angles[k] = rotation::euler_near(rotation, [2, 1, 0], self.angles[k]);
            for (column, angle) in self.angles[k].iter().enumerate() {
                row[3 + 3 * k + column] = angle.to_degrees();
            }
        }
        self.added += 1;
    }
}
