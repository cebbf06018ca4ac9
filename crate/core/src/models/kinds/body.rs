//! The body of a model: from centred columns of its parts to all columns, poses, positions and clips.

use crate::models::data::column_mapping::ColumnMapping;
use crate::models::data::dataset::Dataset;
use crate::models::data::sequences::MOST_FRAMES;
use crate::models::data::sequences::SequenceInfo;
use crate::models::rollout::request::{Handles, PosePush, RolloutError};
use crate::motion::Clip;
use crate::motion::parts::PartsLayout;
use crate::motion::pose::{PoseError, PoseMapping, RootStart};
use crate::motion::skeleton::MAX_POSITIONS;
use nalgebra::DMatrix;

/// The body that a model of any kind moves; with [`Columns`](crate::series::Columns) as the mapping, the
/// table whose columns it predicts.
#[derive(Clone, Debug)]
pub struct Body<S = PoseMapping> {
    /// From columns to joint rotations; for tables, the names and units of the columns.
    pub mapping: S,
    /// Which columns belong to which part.
    pub layout: PartsLayout,
    /// The mean of every column `[D]`.
    pub column_means: Vec<f64>,
    /// Seconds from one frame to the next.
    pub frame_time: f64,
    /// The training sequences, from which a rollout can start.
    pub sequences: Vec<SequenceInfo>,
}

impl<S: ColumnMapping> Body<S> {
    /// The body, or table, of a data set.
    pub fn new(dataset: &Dataset<S>) -> Self {
        Self {
            mapping: dataset.mapping.clone(),
            layout: dataset.layout.clone(),
            column_means: dataset.column_means.clone(),
            frame_time: dataset.frame_time,
            sequences: dataset.sequences.clone(),
        }
    }

    /// Checks that a rollout of `frames` frames, with `width` latent dimensions in all, can be written as
    /// BVH, read again and stored in memory.
    ///
    /// # Errors
    ///
    /// When the number of frames is 0 or too large.
    pub fn check_frames(&self, frames: usize, width: usize) -> Result<(), RolloutError> {
        let most = MOST_FRAMES.min(self.mapping.most_frames()).min(MAX_POSITIONS / width.max(1));
        if (1..=most).contains(&frames) { Ok(()) } else { Err(RolloutError::Frames { most, found: frames }) }
    }

    /// All columns, means included [frames x D], from the centred columns of each part [frames x D_i]; a part
    /// without rows stays at its mean pose.
    pub fn columns(&self, parts: &[DMatrix<f64>]) -> DMatrix<f64> {
        let frames = parts.iter().map(|y| y.nrows()).max().unwrap_or(0);
        let mut columns = DMatrix::from_fn(frames, self.column_means.len(), |_, d| self.column_means[d]);
        for (part, y) in parts.iter().enumerate().filter(|(_, y)| y.nrows() > 0) {
            for (c, column) in self.layout.columns(part).iter().enumerate() {
                let unit = self.mapping.unit(*column);
                let mut out = columns.column_mut(*column);
                out.axpy(unit, &y.column(c), 1.0);
            }
        }
        columns
    }

    /// Multiplies the columns of a body that are changes from frame to frame, such as its way over the ground.
    pub(super) fn scale_rates(&self, y: &mut DMatrix<f64>, speed: f64) {
        let root = self.mapping.poses().into_iter().flat_map(PoseMapping::root_columns);
        for (d, _) in root.enumerate().filter(|(_, column)| column.kind.is_rate()) {
            y.column_mut(d).scale_mut(speed);
        }
    }

    /// Handles with centred columns in the order of the parts, as fitted models have them.
    pub(super) fn handles_of_parts(&self, handles: &Handles) -> Handles {
        let ordered = |by: &Vec<f64>| {
            let parts = (0..self.layout.parts().len()).flat_map(|part| self.layout.columns(part));
            parts.map(|&column| by[column] / self.mapping.unit(column)).collect()
        };
        let push = handles.push.as_ref();
        Handles {
            tempo: handles.tempo,
            goal: handles.goal.as_ref().map(ordered),
            push: push.map(|push| PosePush { frame: push.frame, by: ordered(&push.by) }),
        }
    }

    /// Centred columns of each part [frames x D_i] from all columns, means included [frames x D]: the inverse of
    /// [`columns`](Self::columns). A missing number is NaN.
    pub fn centred(&self, y: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        let part = |part: usize| {
            let columns = self.layout.columns(part);
            DMatrix::from_fn(y.nrows(), columns.len(), |t, c| {
                let column = columns[c];
                (y[(t, column)] - self.column_means[column]) / self.mapping.unit(column)
            })
        };
        (0..self.layout.parts().len()).map(part).collect()
    }
}

impl<S: ColumnMapping> Body<S> {
    /// The body, if it is one with poses: not a table.
    pub(crate) fn with_poses(&self) -> Option<Body> {
        Some(Body {
            mapping: self.mapping.poses()?.clone(),
            layout: self.layout.clone(),
            column_means: self.column_means.clone(),
            frame_time: self.frame_time,
            sequences: self.sequences.clone(),
        })
    }
}

impl Body {
    /// All columns [frames x D] as a clip, starting at the origin.
    ///
    /// # Errors
    ///
    /// When the columns cannot be turned into poses.
    pub fn clip(&self, y: &DMatrix<f64>, name: &str) -> Result<Clip, PoseError> {
        let mut clip = self.mapping.decode(y, &RootStart::default(), self.frame_time)?;
        clip.name = name.to_owned();
        Ok(clip)
    }

    /// World positions of the figure's nodes [frames x nodes x 3] at all columns [frames x D], y up, for a
    /// body 1.7 m tall.
    ///
    /// # Errors
    ///
    /// When the columns cannot be turned into poses.
    pub fn positions(&self, y: &DMatrix<f64>) -> Result<Vec<f32>, PoseError> {
        self.mapping.decode_positions(y, &RootStart::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::kinds::health::tests::walk;

    #[test]
    fn a_rollout_with_many_latents_has_fewer_frames() {
        let body = walk().0.body;
        let width = MAX_POSITIONS / 1000;
        assert!(body.check_frames(1000, width).is_ok());
        assert_eq!(body.check_frames(1001, width), Err(RolloutError::Frames { most: 1000, found: 1001 }));
        assert!(body.check_frames(1001, 1).is_ok());
    }

    #[test]
    fn a_part_without_rows_stays_at_its_mean_pose() {
        let body = walk().0.body;
        let ones = DMatrix::from_element(3, body.layout.columns(1).len(), 1.0);
        let y = body.columns(&[DMatrix::zeros(0, body.layout.columns(0).len()), ones]);
        assert_eq!(y.nrows(), 3);
        assert!(body.layout.columns(0).iter().all(|d| y[(2, *d)] == body.column_means[*d]));
        assert!(body.layout.columns(1).iter().all(|d| y[(2, *d)] == body.column_means[*d] + 1.0));
    }
}
