//! From rows of Y to clips and to positions on the stage.

use crate::motion::clip::Clip;
use crate::motion::pose::mapping::{PoseError, PoseMapping, ROOT_COLUMNS};
use crate::motion::pose::root::{RootPose, RootStart, RootTrack};
use crate::motion::rotation;
use crate::motion::skeleton::{LARGEST_NUMBER, WorldPose};
use nalgebra::{DMatrix, UnitQuaternion, Vector3};

impl PoseMapping {
    /// The clip of rows of Y [frames x columns] that begins at `start`, with `frame_time` in seconds: the
    /// inverse of [`PoseMapping::encode`]. Angles are continuous in time where that is possible. A joint with
    /// fewer than three angles gets the part of its rotation that they can express.
    ///
    /// # Errors
    ///
    /// [`PoseError::Columns`] for rows of another width, [`PoseError::NotFinite`] and [`PoseError::Field`]
    /// for numbers that are not finite or too large, [`PoseError::Away`] for a root that goes farther than a
    /// file can store.
    pub fn decode(&self, y: &DMatrix<f64>, start: &RootStart, frame_time: f64) -> Result<Clip, PoseError> {
        self.check_start(start)?;
        self.check(y)?;
        let mut values = DMatrix::zeros(y.nrows(), self.skeleton.channel_count());
        let to_file = self.stage.up.to_y_up().inverse();
        let axes: Vec<Vec<usize>> =
            self.skeleton.joints.iter().map(|joint| joint.rotation_axes().collect()).collect();
        let mut previous = vec![[0.0; 3]; self.skeleton.joints.len()];
        let mut positions = self.local_positions();
        self.each_frame(y, &mut self.track(start), |t, root, rotations| {
            rotations[0] = to_file * rotations[0];
            positions[0] = to_file * (root.place * self.leg());
            let mut column = 0;
            for (place, joint) in self.skeleton.joints.iter().enumerate() {
                let angles = rotation::angles_near(&rotations[place], &axes[place], &previous[place]);
                previous[place] = angles;
                let mut angles = angles.into_iter();
                for channel in &joint.channels {
                    values[(t, column)] = if channel.is_rotation() {
                        angles.next().unwrap_or(0.0).to_degrees()
                    } else {
                        positions[place][channel.axis()]
                    };
                    column += 1;
                }
            }
        });
        if let Some(index) = values.iter().position(|x| x.abs() > LARGEST_NUMBER) {
            return Err(PoseError::Away { frame: index % y.nrows(), found: values.as_slice()[index] });
        }
        Ok(Clip::new("motion.bvh", self.skeleton.clone(), frame_time, values))
    }

    /// Stage positions [frames x nodes x 3] of the motion of rows of Y, computed directly from the rotation
    /// vectors: y up, metres, the body 1.7 m tall, the ground where the mapping's clip has it.
    ///
    /// # Errors
    ///
    /// As [`PoseMapping::decode`].
    pub fn decode_positions(&self, y: &DMatrix<f64>, start: &RootStart) -> Result<Vec<f32>, PoseError> {
        self.check_start(start)?;
        self.continue_positions(y, &mut self.track(start))
    }

    /// The state before the first row of a motion that begins at `start`.
    pub fn track(&self, start: &RootStart) -> RootTrack {
        let mut place = self.stage.up.to_y_up() * Vector3::from(start.position) / self.leg();
        if let Some(first) = self.climbs_from {
            place.y += first;
        }
        RootTrack::new(RootPose { place, angles: [start.yaw, 0.0, 0.0] }, self.climbs_from.is_some())
    }

    /// As [`decode_positions`](Self::decode_positions) for the next rows of a motion; `track` is its state
    /// before the rows, and after the call its state behind them.
    ///
    /// # Errors
    ///
    /// As [`PoseMapping::decode`].
    pub fn continue_positions(&self, y: &DMatrix<f64>, track: &mut RootTrack) -> Result<Vec<f32>, PoseError> {
        self.check(y)?;
        let nodes = self.skeleton.figure().len();
        let mut places = Vec::with_capacity(y.nrows() * nodes * 3);
        let mut positions = self.local_positions();
        let mut pose = WorldPose::default();
        self.each_frame(y, track, |_, root, rotations| {
            positions[0] = root.place * self.leg();
            self.skeleton.forward_kinematics_into(rotations, &positions, &mut pose);
            places.extend(pose.positions.iter().flat_map(|place| self.stage.place(place)));
        });
        Ok(places)
    }

    /// Calls `frame(t, root, local rotations)` for each row; rotation 0 is the root's in a world with y up.
    fn each_frame(
        &self,
        y: &DMatrix<f64>,
        track: &mut RootTrack,
        mut frame: impl FnMut(usize, &RootPose, &mut [UnitQuaternion<f64>]),
    ) {
        let upright = self.upright();
        let mut rotations = vec![UnitQuaternion::identity(); self.skeleton.joints.len()];
        for t in 0..y.nrows() {
            let row: [f64; 6] = std::array::from_fn(|column| y[(t, column)]);
            let root = track.push(&row);
            rotations[0] = root.orientation() * upright;
            for (joint, rotation) in rotations.iter_mut().enumerate().skip(1) {
                let column = ROOT_COLUMNS.len() + 3 * (joint - 1);
                *rotation =
                    rotation::exp(&Vector3::new(y[(t, column)], y[(t, column + 1)], y[(t, column + 2)]));
            }
            frame(t, &root, &mut rotations);
        }
    }

    fn check(&self, y: &DMatrix<f64>) -> Result<(), PoseError> {
        if y.ncols() != self.column_count() {
            return Err(PoseError::Columns { expected: self.column_count(), found: y.ncols() });
        }
        let valid = |x: &f64| x.abs() <= LARGEST_NUMBER;
        // A loop without an early exit can use SIMD.
        if y.as_slice().iter().fold(true, |all, x| all & valid(x)) {
            return Ok(());
        }
        let index = y.iter().position(|x| !valid(x)).unwrap_or_default();
        Err(PoseError::NotFinite { frame: index % y.nrows(), column: index / y.nrows(), found: y[index] })
    }

    fn check_start(&self, start: &RootStart) -> Result<(), PoseError> {
        if !start.position.iter().chain([&start.yaw]).all(|x| (-1e12..1e12).contains(x)) {
            return Err(PoseError::Field { field: "start", expected: "finite numbers".to_owned() });
        }
        Ok(())
    }
}
