//! A motion that is ready for use: a skeleton and its channel values, row by row.

use crate::motion::rotation;
use crate::motion::skeleton::{LocalPose, Skeleton, WorldPose};
use crate::motion::stage_axes::UpAxis;
use nalgebra::DMatrix;
use sha2::{Digest, Sha256};
use std::ops::RangeInclusive;
use thiserror::Error;

/// A motion: recorded, made by the project, or rolled out from a model.
///
/// Every row belongs to the motion: the T-pose that some files put before the motion is removed where a
/// [`Recording`](crate::motion::Recording) becomes a clip. A cut never removes frames for this reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
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
    /// SHA-256 of the file's bytes in lower-case hexadecimal. For a clip that does not come from a file: of
    /// the text that [`bvh::write`](crate::motion::bvh::write) returns. A cut or resampled clip keeps the
    /// hash of the whole clip.
    pub sha256: String,
    /// The frames of the file that this cut clip contains: the first, and the one after the last. `None` if
    /// the clip was not cut. Counted from 0 at the file's rate, without a leading T-pose.
    pub piece: Option<(usize, usize)>,
    /// Seconds from one frame of the file to the next. Resampling changes [`frame_time`](Self::frame_time),
    /// not this.
    pub file_frame_time: f64,
    /// The name of the clip whose bones this clip was given ([`Clip::with_bones_of`]); `None` if it has its
    /// own bones.
    pub bones_of: Option<String>,
    /// The axis that points up, if the user states it; `None`: [`Clip::up_axis`] finds it.
    pub up: Option<UpAxis>,
    /// The root joints of the bodies in the file, where it has several; the first of them is this clip's.
    pub bodies: Vec<String>,
    /// The axis that was found when the file was read. A part of a clip has the axis of the whole clip.
    pub found_up: Option<UpAxis>,
}

/// Why a clip could not be cut or resampled.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ClipError {
    /// A range that is empty or goes beyond the clip.
    #[error("{name}: expected frames from 0 to {frames}, the first before the end, found {first} to {end}")]
    Range {
        /// The name of the clip.
        name: String,
        /// Frames of the clip.
        frames: usize,
        /// The first frame asked for.
        first: usize,
        /// One after the last frame asked for.
        end: usize,
    },
    /// A rate outside [`Clip::RATES`].
    #[error("{name}: expected {} to {} frames a second, found {found}", Clip::RATES.start(), Clip::RATES.end())]
    Rate {
        /// The name of the clip.
        name: String,
        /// The rate asked for.
        found: f64,
    },
    /// The resampled clip would have more frames than [`Skeleton::max_frames`].
    #[error("{name}: expected at most {most} frames of this body, found {frames} at {rate} frames a second")]
    TooLong {
        /// The name of the clip.
        name: String,
        /// The rate asked for.
        rate: f64,
        /// Frames at that rate.
        frames: usize,
        /// The limit.
        most: usize,
    },
}

/// Rates that differ by a smaller fraction count as equal: files write 1/30 as .033333 and 1/120 as .0083.
const RATE_TOLERANCE: f64 = 0.02;

impl Clip {
    /// Frames a second to which a clip can be resampled.
    pub const RATES: RangeInclusive<f64> = 0.1..=10_000.0;

    /// The number of frames.
    pub fn frames(&self) -> usize {
        self.values.nrows()
    }

    /// The rotations and positions of all joints in their parents' frames: `R = R_first R_second R_third` in
    /// the order of the joint's channels. A position channel replaces the joint's offset, axis by axis.
    pub fn local_pose(&self, frame: usize) -> LocalPose {
        self.skeleton.local_pose(&self.values, frame)
    }

    /// The positions of all nodes of [`Skeleton::figure`] and the rotations of all joints in the world of the
    /// file: in its units and axes.
    pub fn world_pose(&self, frame: usize) -> WorldPose {
        let local = self.local_pose(frame);
        self.skeleton.forward_kinematics(&local.rotations, &local.positions)
    }

    /// The frames from `first` up to but not including `end`, counted from 0. [`Clip::piece`] of the result
    /// says which frames of the file these are.
    ///
    /// ```
    /// use vcgpdm_core::motion::samples;
    ///
    /// let clip = samples::clip("walk-1").ok_or("no such sample")?; // 60 frames a second
    /// let second = clip.resample(30.0)?.cut(30, 60)?;
    /// assert_eq!((second.frames(), second.piece), (30, Some((60, 119))));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ClipError::Range`] when the range is empty or goes beyond the clip.
    pub fn cut(&self, first: usize, end: usize) -> Result<Clip, ClipError> {
        if first >= end || end > self.frames() {
            let (name, frames) = (self.name.clone(), self.frames());
            return Err(ClipError::Range { name, frames, first, end });
        }
        let mut cut = self.with_values(self.values.rows(first, end - first).into_owned(), self.frame_time);
        if end - first < self.frames() {
            let (start, _) = self.piece.unwrap_or((0, 0));
            let step = self.frame_time / self.file_frame_time;
            let file_frame = |frame: usize| start + (frame as f64 * step).round() as usize;
            cut.piece = Some((file_frame(first), file_frame(end - 1) + 1));
        }
        Ok(cut)
    }

    /// The same motion at about `fps` frames a second.
    ///
    /// If the clip's rate is a whole multiple k of `fps` (to 2%), every k-th frame is kept unchanged and the
    /// frame time is exactly k times the clip's. Otherwise positions are interpolated linearly, and rotations
    /// on the shortest arc (slerp), written back to each joint's own channels.
    ///
    /// ```
    /// use vcgpdm_core::motion::samples;
    ///
    /// let clip = samples::clip("walk-1").ok_or("no such sample")?; // 60 frames a second
    /// let slow = clip.resample(20.0)?; // every third frame
    /// assert_eq!(slow.values.row(1), clip.values.row(3));
    /// assert!((slow.frame_time - 0.05).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ClipError::Rate`] for a rate outside [`Clip::RATES`], [`ClipError::TooLong`] when the result would
    /// be too large.
    pub fn resample(&self, fps: f64) -> Result<Clip, ClipError> {
        if !Self::RATES.contains(&fps) {
            return Err(ClipError::Rate { name: self.name.clone(), found: fps });
        }
        let rate = 1.0 / self.frame_time;
        let step = (rate / fps).round().max(1.0);
        if (rate / (step * fps) - 1.0).abs() <= RATE_TOLERANCE {
            let step = step as usize;
            let rows: Vec<usize> = (0..self.frames()).step_by(step).collect();
            return Ok(self.with_values(self.values.select_rows(&rows), self.frame_time * step as f64));
        }
        let Some(last) = self.frames().checked_sub(1) else {
            return Ok(self.with_values(self.values.clone(), 1.0 / fps));
        };
        let last = last as f64;
        // The small addition keeps the last frame when the product is rounded down.
        let frames = (last * self.frame_time * fps + 1e-6).floor() as usize + 1;
        let most = self.skeleton.max_frames();
        if frames > most {
            return Err(ClipError::TooLong { name: self.name.clone(), rate: fps, frames, most });
        }
        let mut values = DMatrix::zeros(frames, self.values.ncols());
        for row in 0..frames {
            let at = (row as f64 * rate / fps).min(last);
            self.interpolate(at, row, &mut values);
        }
        Ok(self.with_values(values, 1.0 / fps))
    }

    /// Writes the pose at time `at` (in frames of this clip) into a row. Its angles are those nearest to the
    /// angles of the row before.
    fn interpolate(&self, at: f64, row: usize, values: &mut DMatrix<f64>) {
        let before = at.floor() as usize;
        let after = (before + 1).min(self.frames() - 1);
        let share = at - before as f64;
        let (pose, next) = (self.local_pose(before), self.local_pose(after));
        let mut column = 0;
        for (place, joint) in self.skeleton.joints.iter().enumerate() {
            let columns = column..column + joint.channels.len();
            column = columns.end;
            let turned: Vec<usize> =
                columns.clone().filter(|c| joint.channels[c - columns.start].is_rotation()).collect();
            for c in columns {
                let (a, b) = (self.values[(before, c)], self.values[(after, c)]);
                // The shorter way round. Joints with three angles are overwritten below.
                let change =
                    if turned.contains(&c) { (b - a) - 360.0 * ((b - a) / 360.0).round() } else { b - a };
                values[(row, c)] = a + share * change;
            }
            if turned.len() == 3 {
                let (from, to) = (pose.rotations[place], next.rotations[place]);
                let arc = rotation::log(&(from.inverse() * to));
                let between = from * rotation::exp(&(arc * share));
                let axes: Vec<usize> = joint.rotation_axes().collect();
                let previous: Vec<f64> = turned
                    .iter()
                    .map(|&c| if row > 0 { values[(row - 1, c)] } else { self.values[(0, c)] }.to_radians())
                    .collect();
                let angles = rotation::angles_near(&between, &axes, &previous);
                for (&c, angle) in turned.iter().zip(angles) {
                    values[(row, c)] = angle.to_degrees();
                }
            }
        }
    }

    /// This clip with other values and another frame time.
    pub(crate) fn with_values(&self, values: DMatrix<f64>, frame_time: f64) -> Clip {
        Clip {
            name: self.name.clone(),
            skeleton: self.skeleton.clone(),
            frame_time,
            values,
            warnings: self.warnings.clone(),
            sha256: self.sha256.clone(),
            piece: self.piece,
            bones_of: self.bones_of.clone(),
            up: self.up,
            bodies: self.bodies.clone(),
            found_up: self.found_up,
            file_frame_time: self.file_frame_time,
        }
    }
}

/// SHA-256 in lower-case hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

crate::coded!(ClipError => Clip);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::skeleton::{Channel, Joint};
    use crate::motion::testing::any_clip;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    /// One joint that moves along x by 1 and turns about y by `degrees` in each frame.
    fn turning(frames: usize, frame_time: f64, degrees: f64) -> Clip {
        let channels = vec![Channel::Xposition, Channel::Zrotation, Channel::Yrotation, Channel::Xrotation];
        let root =
            Joint { name: "r".to_owned(), parent: None, offset: [0.0; 3], channels, end_sites: Vec::new() };
        let values = DMatrix::from_fn(frames, 4, |t, column| match column {
            0 => t as f64,
            2 => degrees * t as f64,
            _ => 0.0,
        });
        Clip::new("turning.bvh", Skeleton { joints: vec![root] }, frame_time, values)
    }

    #[test]
    fn a_cut_clip_says_which_frames_of_the_file_it_contains() {
        let clip = turning(40, 0.1, 3.0);
        assert_eq!(clip.cut(0, 40).unwrap().piece, None);
        let piece = clip.cut(10, 30).unwrap();
        assert_eq!(piece.piece, Some((10, 30)));
        assert_eq!(piece.cut(5, 20).unwrap().piece, Some((15, 30)));
        // At another rate the piece is the same; a cut of it still counts frames of the file.
        let slow = piece.resample(5.0).unwrap();
        assert_eq!(slow.cut(0, 10).unwrap().piece, Some((10, 30)));
        assert_eq!(slow.cut(1, 3).unwrap().piece, Some((12, 15)));
        let slow = clip.resample(2.5).unwrap();
        assert_eq!((slow.frames(), slow.piece), (10, None));
        assert_eq!(slow.cut(3, 10).unwrap().piece, Some((12, 37)));
    }

    #[test]
    fn whole_multiples_of_the_rate_keep_frames_as_they_are() {
        for (frame_time, fps, step) in [
            (0.0083333, 30.0, 4),
            (0.008342, 30.0, 4),
            (1.0 / 30.0, 30.0, 1),
            (0.0333, 31.0, 0),
            (0.1, 10.1, 1),
        ] {
            let clip = turning(41, frame_time, 3.0);
            let less = clip.resample(fps).unwrap();
            if step == 0 {
                assert_abs_diff_eq!(less.frame_time, 1.0 / fps);
                continue;
            }
            assert_eq!(less.frames(), 40 / step + 1);
            assert_eq!(less.frame_time, frame_time * step as f64);
            for t in 0..less.frames() {
                assert_eq!(less.values.row(t), clip.values.row(t * step));
            }
        }
    }

    #[test]
    fn other_rates_interpolate() {
        for (frame_time, fps) in [(1.0 / 24.0, 30.0), (1.0 / 100.0, 30.0), (1.0 / 25.0, 50.0)] {
            // Through the lock of this joint's channels at 90 degrees, and round more than once.
            let clip = turning(101, frame_time, 7.0);
            let other = clip.resample(fps).unwrap();
            assert_eq!(other.frames(), (100.0 * frame_time * fps + 1e-6) as usize + 1);
            for t in 0..other.frames() {
                let at = t as f64 / fps / frame_time;
                assert_abs_diff_eq!(other.values[(t, 0)], at, epsilon = 1e-9);
                let wanted = rotation::about_axis(1, (7.0 * at).to_radians());
                assert!(rotation::angle_between(&other.local_pose(t).rotations[0], &wanted) < 1e-9, "{t}");
            }
        }
    }

    #[test]
    fn a_clip_without_frames_gets_the_rate() {
        let empty = turning(1, 0.01, 1.0).with_values(DMatrix::zeros(0, 1), 0.01);
        assert_eq!(empty.resample(30.0).unwrap().frame_time, 1.0 / 30.0);
    }

    #[test]
    fn absurd_rates_and_ranges_are_refused() {
        let clip = turning(10, 0.1, 1.0);
        for fps in [0.0, -30.0, f64::NAN, f64::INFINITY, 1e9] {
            assert!(clip.resample(fps).unwrap_err().to_string().contains("0.1 to 10000"));
        }
        assert_eq!(clip.cut(2, 5).unwrap().values, clip.values.rows(2, 3).into_owned());
        for (first, end) in [(3, 3), (5, 2), (0, 11), (usize::MAX, 1)] {
            let message = clip.cut(first, end).unwrap_err().to_string();
            assert!(message.contains("turning.bvh: expected frames from 0 to 10"), "{message}");
        }
        let slow = Clip { frame_time: 3600.0, ..turning(10, 0.1, 1.0) };
        assert!(slow.resample(10_000.0).unwrap_err().to_string().contains("expected at most"));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn interpolation_stays_on_the_shortest_arc(clip in any_clip(), fps in 26.0..80.0) {
            let other = clip.resample(fps).unwrap();
            for t in 0..other.frames() {
                let at = (t as f64 / fps / clip.frame_time).min((clip.frames() - 1) as f64);
                let (before, after) = (at.floor() as usize, (at.floor() as usize + 1).min(clip.frames() - 1));
                let (a, b, now) = (clip.local_pose(before), clip.local_pose(after), other.local_pose(t));
                for (j, joint) in clip.skeleton.joints.iter().enumerate() {
                    if joint.rotation_axes().count() != 3 {
                        continue;
                    }
                    let arc = rotation::angle_between(&a.rotations[j], &b.rotations[j]);
                    let done = rotation::angle_between(&a.rotations[j], &now.rotations[j]);
                    prop_assert!((done - arc * (at - before as f64)).abs() < 1e-6, "{} {}", done, arc);
                }
            }
        }
    }
}
