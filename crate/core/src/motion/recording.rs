//! The rows of a file, and the T-pose that some conversions put before a motion.

use crate::motion::clip::Clip;
use crate::motion::period::upper_end;
use crate::motion::rotation;
use crate::motion::skeleton::{LocalPose, Skeleton};
use crate::plural::listed;
use nalgebra::DMatrix;
use thiserror::Error;

/// The rows of a file as recorded. The first rows may be a T-pose that does not belong to the motion:
/// [`Recording::into_clip`] finds and removes them.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// The file's name, for messages and provenance.
    pub name: String,
    /// The body.
    pub skeleton: Skeleton,
    /// Seconds from one frame to the next.
    pub frame_time: f64,
    /// Channel values [frames x channels], in the order of the joints and of each joint's channels (degrees,
    /// file units).
    pub values: DMatrix<f64>,
    /// What was unusual about the file, as sentences.
    pub warnings: Vec<String>,
    /// SHA-256 of the file's bytes in lower-case hexadecimal.
    pub sha256: String,
}

/// A root that was asked for and is not a joint of the file.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{file}: root: expected the name of a joint, found {found:?}; the joints are {joints}")]
pub struct UnknownJoint {
    /// The name of the file.
    pub file: String,
    /// The name asked for.
    pub found: String,
    /// The first joints of the file.
    pub joints: String,
}

/// A smaller step (degrees, mean over the joints) from the first frame is no change of pose.
const SMALLEST_STEP: f64 = 3.0;
/// Upper limit (degrees) for one joint's contribution to a step: a sensor that flips over is no new pose.
const LARGEST_ANGLE: f64 = 60.0;
/// The largest number of T-pose rows that is looked for.
const MOST_ADDED: usize = 3;

impl Recording {
    /// The number of rows.
    pub fn frames(&self) -> usize {
        self.values.nrows()
    }

    /// The motion without leading T-pose rows, and without a root that only carries a child that moves: the
    /// child becomes the root. Of several bodies below one root the first is kept. Bones are those of the
    /// frames where the position channels replace the OFFSETs. A warning says what was removed or changed.
    pub fn into_clip(self) -> Clip {
        let added = self.rows_before_motion();
        let mut clip = self.with_all_rows();
        if added > 0 {
            clip.values = clip.values.remove_rows(0, added);
            clip.warnings.push(if added == 1 {
                "the first row is a T-pose that does not belong to the motion: it was left out".to_owned()
            } else {
                format!(
                    "the first {added} rows are a T-pose that does not belong to the motion: they were \
                     left out"
                )
            });
        }
        clip.without_carrying_roots().with_recorded_bones().with_checked_root()
    }

    /// The motion as it is.
    pub(super) fn with_all_rows(self) -> Clip {
        let Recording { name, skeleton, frame_time, values, warnings, sha256 } = self;
        Clip {
            name,
            skeleton,
            frame_time,
            values,
            warnings,
            sha256,
            piece: None,
            bones_of: None,
            up: None,
            bodies: Vec::new(),
            found_up: None,
            file_frame_time: frame_time,
        }
    }

    /// The joint of this name and all joints below it, at the same places in the world: one body of a file
    /// that has several. `None`: the whole recording.
    ///
    /// # Errors
    ///
    /// [`UnknownJoint`] if there is no joint of this name, or more than one.
    pub fn of_root(self, name: Option<&str>) -> Result<Recording, UnknownJoint> {
        let Some(name) = name else { return Ok(self) };
        let mut places = (0..self.skeleton.joints.len()).filter(|&at| self.skeleton.joints[at].name == name);
        let (Some(place), None) = (places.next(), places.next()) else {
            let joints = listed(self.skeleton.joints.iter().map(|joint| joint.name.as_str()));
            return Err(UnknownJoint { file: self.name, found: name.to_owned(), joints });
        };
        if place == 0 {
            return Ok(self);
        }
        let Recording { name, skeleton, frame_time, values, warnings, sha256 } = self;
        let body = Clip::new(&name, skeleton, frame_time, values).below(place);
        Ok(Recording { name, skeleton: body.skeleton, frame_time, values: body.values, warnings, sha256 })
    }

    /// The number of leading T-pose rows.
    ///
    /// Conversions of the CMU recordings add the rest pose as row 0, sometimes twice. Rows whose angles are
    /// nearly all zero count as T-pose if the step to the next row is larger than the usual steps of the
    /// motion. A single first row counts whatever its angles are, if the step after it is far larger. A
    /// motion that starts smoothly from rest keeps its first frame.
    pub fn rows_before_motion(&self) -> usize {
        let steps = self.steps();
        let ends = |added: usize| {
            let Some((&step, later)) = steps.get(added - 1..).and_then(<[f64]>::split_first) else {
                return false;
            };
            if later.is_empty() || step < SMALLEST_STEP {
                return false;
            }
            let (usual, largest) = upper_end(later.to_vec());
            let at_rest = || (0..added).all(|row| self.share_at_rest(row, added) >= 0.75);
            step > 1.5 * usual && at_rest() || added == 1 && later.len() >= 10 && step > 4.0 * largest
        };
        (1..=MOST_ADDED).rev().find(|added| ends(*added)).unwrap_or(0)
    }

    /// The fraction of zero angles in a row, among the angles that are not zero in the row `first` of the
    /// motion.
    fn share_at_rest(&self, row: usize, first: usize) -> f64 {
        // Without the root: added rows keep its position, and sometimes its heading.
        let channels = self.skeleton.joints.iter().skip(1).flat_map(|joint| &joint.channels);
        let root_channels = self.skeleton.joints[0].channels.len();
        let used: Vec<usize> = (channels.zip(root_channels..))
            .filter(|(channel, column)| channel.is_rotation() && self.values[(first, *column)].abs() > 1e-6)
            .map(|(_, column)| column)
            .collect();
        let zero = used.iter().filter(|&&column| self.values[(row, column)].abs() <= 1e-6).count();
        zero as f64 / used.len().max(1) as f64
    }

    /// The mean angle, over all joints with angles, from each frame to the next [frames - 1], degrees.
    fn steps(&self) -> Vec<f64> {
        let turning: Vec<usize> = (self.skeleton.joints.iter().enumerate())
            .filter(|(_, joint)| joint.rotation_axes().next().is_some())
            .map(|(place, _)| place)
            .collect();
        let step = |a: &LocalPose, b: &LocalPose| {
            let angles = (turning.iter())
                .map(|&joint| rotation::angle_between(&a.rotations[joint], &b.rotations[joint]).to_degrees());
            angles.map(|angle| angle.min(LARGEST_ANGLE)).sum::<f64>() / turning.len().max(1) as f64
        };
        let mut poses = (0..self.frames()).map(|frame| self.skeleton.local_pose(&self.values, frame));
        let Some(mut before) = poses.next() else { return Vec::new() };
        let mut steps = Vec::with_capacity(self.frames() - 1);
        for pose in poses {
            steps.push(step(&before, &pose));
            before = pose;
        }
        steps
    }
}

crate::coded!(UnknownJoint => Clip);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::skeleton::{Channel, Joint};

    /// A chain of three joints that swing by `angle(frame)` degrees; row 0 may be a rest pose.
    fn swinging(frames: usize, first_row_at_rest: bool, angle: impl Fn(usize) -> f64) -> Recording {
        let rotations = [Channel::Zrotation, Channel::Xrotation, Channel::Yrotation];
        let joint = |place: usize| Joint {
            name: format!("joint {place}"),
            parent: place.checked_sub(1),
            offset: [0.0, 1.0, 0.0],
            channels: rotations.to_vec(),
            end_sites: Vec::new(),
        };
        let skeleton = Skeleton { joints: (0..3).map(joint).collect() };
        let values = DMatrix::from_fn(frames, 9, |frame, column| {
            let a = if frame == 0 && first_row_at_rest { 0.0 } else { angle(frame) };
            [0.0, 0.0, 0.0, a, a * 0.5, -a, a * 0.3, a, 1.0][column]
        });
        Recording::new("swing.bvh", skeleton, 0.008333, values)
    }

    fn swing(frame: usize) -> f64 {
        40.0 + 10.0 * (0.2 * frame as f64).sin()
    }

    #[test]
    fn an_added_row_at_rest_is_left_out_with_a_warning() {
        let recording = swinging(50, true, swing);
        assert_eq!(recording.rows_before_motion(), 1);
        let clip = recording.clone().into_clip();
        assert_eq!(clip.frames(), 49);
        assert_eq!(clip.values.row(0), recording.values.row(1));
        assert!(clip.warnings.iter().any(|warning| warning.contains("T-pose")));
    }

    #[test]
    fn a_first_row_with_one_angle_at_rest_is_kept() {
        let mut recording = swinging(50, false, swing);
        recording.values[(0, 6)] = 0.0;
        assert_eq!(recording.rows_before_motion(), 0);
    }

    /// CMU subject 7, trial 12 begins with two rest poses, the first with a few other angles. When the second
    /// was kept, predictions from the first frames began in the wrong pose. At a lower rate the motion's own
    /// steps are large, too.
    #[test]
    fn two_added_rows_are_left_out() {
        for slower in [1, 4, 12] {
            let mut recording = swinging(50, true, |frame| swing(slower * frame));
            recording.values.row_mut(1).fill(0.0);
            recording.values.row_mut(0).fill(0.0);
            recording.values[(0, 4)] = -21.0;
            let clip = recording.clone().into_clip();
            assert_eq!(clip.values, recording.values.rows(2, 48), "{slower}");
            assert_eq!(
                clip.warnings,
                ["the first 2 rows are a T-pose that does not belong to the motion: they were left out"]
            );
        }
    }

    /// A sensor that jumps early is no T-pose: the rows before the jump move like those after it.
    #[test]
    fn rows_before_a_jump_are_kept() {
        for place in [2, 3, 4, 6] {
            let jump = |frame: usize| swing(frame) + if frame < place { 90.0 } else { 0.0 };
            assert_eq!(swinging(50, false, jump).into_clip().frames(), 50, "{place}");
            let glitch = |frame: usize| swing(frame) + if frame == place { 90.0 } else { 0.0 };
            assert_eq!(swinging(50, false, glitch).into_clip().frames(), 50, "{place}");
        }
    }

    #[test]
    fn a_motion_that_starts_from_rest_keeps_its_first_frame() {
        assert_eq!(swinging(50, false, |frame| frame as f64).into_clip().frames(), 50);
        assert_eq!(swinging(50, false, |frame| 40.0 * (0.3 * frame as f64).sin()).into_clip().frames(), 50);
    }

    #[test]
    fn recordings_of_one_or_two_rows_are_kept_whole() {
        assert_eq!(swinging(2, true, |_| 40.0).into_clip().frames(), 2);
        assert_eq!(swinging(1, true, |_| 40.0).into_clip().frames(), 1);
    }
}
