//! Positions of a figure's nodes over time.

use crate::motion::Skeleton;
use nalgebra::Vector3;

/// Positions of nodes [frames x nodes x 3], y up, in metres.
pub(super) struct Track<'a> {
    positions: &'a [f32],
    pub(super) nodes: usize,
    /// Seconds from one frame to the next.
    pub(super) frame_time: f64,
}

impl<'a> Track<'a> {
    pub(super) fn new(skeleton: &Skeleton, positions: &'a [f32], frame_time: f64) -> Self {
        Self { positions, nodes: skeleton.figure().len(), frame_time }
    }

    pub(super) fn frames(&self) -> usize {
        self.positions.len() / (3 * self.nodes)
    }

    pub(super) fn at(&self, frame: usize, node: usize) -> Vector3<f64> {
        let first = 3 * (frame * self.nodes + node);
        Vector3::from_fn(|axis, _| f64::from(self.positions[first + axis]))
    }

    /// The vector from the root to the node.
    pub(super) fn root_to(&self, frame: usize, node: usize) -> Vector3<f64> {
        self.at(frame, node) - self.at(frame, 0)
    }
}
