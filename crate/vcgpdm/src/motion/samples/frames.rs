//! The channel values of a clip, written frame by frame.

use crate::motion::rotation;
use crate::motion::samples::body::joint;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};

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
