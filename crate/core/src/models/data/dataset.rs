//! From clips to training data: one pose mapping, parts, centred columns, sequences.

use crate::gp::linalg::stacked;
use crate::models::data::sequences::SequenceInfo;
use crate::models::data::warnings::{CLIP, changing_columns, constant_warning, sequence_warnings};
use crate::models::errors::TrainingError;
use crate::motion::measures::rests_from;
use crate::motion::parts::{PartSpec, PartsError, PartsLayout};
use crate::motion::pose::{Encoded, PoseError, PoseMapping, RootStart};
use crate::motion::{BodyMismatch, Clip, ClipError};
use crate::plural::counted;
use nalgebra::DMatrix;
use thiserror::Error;

/// A clip that becomes a sequence of the training set.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The clip, at any frame rate.
    pub clip: &'a Clip,
    /// Use only its first frames, this many at the frame rate of the data set; `None`: all.
    pub first_frames: Option<usize>,
}

impl<'a> From<&'a Clip> for Source<'a> {
    fn from(clip: &'a Clip) -> Self {
        Source { clip, first_frames: None }
    }
}

/// Why clips cannot be trained on together.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DatasetError {
    /// There is no clip.
    #[error("expected at least one clip to train on, found none")]
    Empty,
    /// The bodies differ.
    #[error("{clip} cannot be trained together with {first}: {reason}")]
    Body {
        /// The clip that differs.
        clip: String,
        /// The clip it was compared with.
        first: String,
        /// The difference.
        reason: Box<BodyMismatch>,
    },
    /// The body is not that of a model.
    #[error("{clip} is not of the body of the model: {reason}")]
    OtherBody {
        /// The clip.
        clip: String,
        /// The difference.
        reason: Box<BodyMismatch>,
    },
    /// The clip has fewer frames than were asked for.
    #[error("{clip} has {}, but the first {expected} were asked for", counted(*found, "frame"))]
    Short {
        /// The clip.
        clip: String,
        /// Frames asked for.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// The clip cannot be brought to the frame rate.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// The clip's poses cannot be turned into rows.
    #[error("{clip}: {reason}")]
    Pose {
        /// The clip.
        clip: String,
        /// The reason.
        reason: Box<PoseError>,
    },
    /// The parts do not fit the body.
    #[error(transparent)]
    Parts(#[from] PartsError),
    /// Training cannot start because of one clip.
    #[error("{}", message_with_clip(clip, reason))]
    Sequence {
        /// The clip.
        clip: String,
        /// The reason.
        reason: Box<TrainingError>,
    },
    /// Training cannot start, and not because of a single clip.
    #[error(transparent)]
    Training(TrainingError),
}

/// The reason with the name of the clip instead of the number of its sequence.
fn message_with_clip(clip: &str, reason: &TrainingError) -> String {
    match reason.sequence_problem() {
        Some((_, problem)) => format!("the clip {clip} {problem}"),
        None => format!("{clip}: {reason}"),
    }
}

impl DatasetError {
    /// The error of a training on these sequences, with the clip's name where the reason is in one clip.
    pub fn from_training(reason: TrainingError, sequences: &[SequenceInfo]) -> Self {
        match reason.sequence().and_then(|sequence| sequences.get(sequence)) {
            Some(info) => DatasetError::Sequence { clip: info.name.clone(), reason: Box::new(reason) },
            None => DatasetError::Training(reason),
        }
    }
}

/// A training set: the rows of all sequences, one after the other, divided into the columns of the parts.
///
/// `S` is the meaning of the columns: the poses of a body, or the [columns of
/// tables](crate::series::Columns).
#[derive(Clone, Debug)]
pub struct Dataset<S = PoseMapping> {
    /// From joint rotations to columns and back; for tables, the names and units of the columns.
    pub mapping: S,
    /// Which columns belong to which part.
    pub layout: PartsLayout,
    /// Centred observations of each part [N x D_i].
    pub y: Vec<DMatrix<f64>>,
    /// The mean of every column of the mapping `[D]`.
    pub column_means: Vec<f64>,
    /// The sequences, in the order given.
    pub sequences: Vec<SequenceInfo>,
    /// Seconds from one frame to the next.
    pub frame_time: f64,
    /// The frame rate asked for, in frames a second; `frame_time` is near its inverse.
    pub frames_per_second: f64,
    /// What a user should know about the clips, such as a T-pose that was left out or a clip that does not
    /// move: sentences without a full stop, each with the name of its clip, part or column.
    pub warnings: Vec<String>,
}

/// Checks that clips have the same body, so that they can be trained on together. The order of the joints may
/// differ where names say which joint is which.
///
/// # Errors
///
/// The bodies differ; the error names both clips and says how.
pub fn same_body(first: &Clip, clip: &Clip) -> Result<(), DatasetError> {
    let ordered = clip.in_order_of(&first.skeleton);
    first.skeleton.same_body(&ordered.skeleton).map_err(|reason| body_error(first, clip, reason))
}

/// The clip with the bones of `first`; see [`Clip::with_bones_of`].
///
/// # Errors
///
/// The joints differ; the error names both clips and says how.
pub fn with_bones_of(clip: &Clip, first: &Clip) -> Result<Clip, DatasetError> {
    clip.with_bones_of(first).map_err(|reason| body_error(first, clip, reason))
}

fn body_error(first: &Clip, clip: &Clip, reason: BodyMismatch) -> DatasetError {
    DatasetError::Body { clip: clip.name.clone(), first: first.name.clone(), reason: Box::new(reason) }
}

/// Rates that differ by less than this share are the same rate.
const SAME_RATE: f64 = 0.02;

impl Dataset {
    /// Brings the clips to about `frames_per_second`, encodes their poses and centres the columns over all
    /// training frames. The body and the frame time are those of the first clip.
    ///
    /// # Errors
    ///
    /// When there is no clip, the bodies differ, a clip is too short, cannot be resampled or cannot be turned
    /// into rows, or the parts do not fit the body.
    pub fn new(sources: &[Source], parts: &[PartSpec], frames_per_second: f64) -> Result<Self, DatasetError> {
        let first = sources.first().ok_or(DatasetError::Empty)?;
        for source in &sources[1..] {
            same_body(first.clip, source.clip)?;
        }
        let mut clips: Vec<Clip> = Vec::new();
        for source in sources {
            let mut clip = source.clip.resample(frames_per_second)?;
            // Two clips can both be near the rate asked for and differ: then the first clip's rate counts.
            if let Some(first) = clips.first()
                && (clip.frame_time / first.frame_time - 1.0).abs() > SAME_RATE
            {
                clip = clip.resample(1.0 / first.frame_time)?;
            }
            if let Some(count) = source.first_frames {
                if clip.frames() < count {
                    let (name, found) = (clip.name.clone(), clip.frames());
                    return Err(DatasetError::Short { clip: name, expected: count, found });
                }
                clip = clip.cut(0, count)?;
            }
            clips.push(clip);
        }
        let mut mapping = PoseMapping::new(&clips[0]);
        let layout = PartsLayout::new(parts, &mapping)?;
        let mut encoded = encoded(&mapping, &clips)?;
        let climbs =
            encoded.iter().zip(&clips).find_map(|(rows, clip)| Some((mapping.climb(&rows.y)?, clip)));
        if climbs.is_some() {
            mapping = mapping.climbing(&encoded[0].y);
            encoded = self::encoded(&mapping, &clips)?;
        }
        let (mut rows, mut warnings) = (Vec::new(), Vec::new());
        for (encoded, clip) in encoded.into_iter().zip(&clips) {
            rows.push(encoded.y);
            let own = clip.warnings.iter().chain(&encoded.warnings);
            warnings.extend(own.map(|warning| format!("{}: {warning}", clip.name)));
        }
        warnings.extend(climbs.map(|(change, clip)| climb_warning(change, &clip.name)));
        let mut all = stacked(&rows);
        let column_means: Vec<f64> = all.row_mean().iter().copied().collect();
        for (mut column, mean) in all.column_iter_mut().zip(&column_means) {
            column.add_scalar_mut(-mean);
        }
        let y = layout.split(&all);
        let frame_time = clips[0].frame_time;
        let info = |((clip, y), source): ((&Clip, &DMatrix<f64>), &Source)| {
            // Rows of a recording are poses.
            let positions = mapping.decode_positions(y, &RootStart::default()).unwrap_or_default();
            SequenceInfo {
                name: clip.name.clone(),
                sha256: clip.sha256.clone(),
                frames: y.nrows(),
                rests_from: rests_from(mapping.skeleton(), &positions, frame_time),
                piece: clip.piece,
                bones_of: clip.bones_of.clone(),
                whole: source.first_frames.is_none(),
            }
        };
        let sequences: Vec<SequenceInfo> = clips.iter().zip(&rows).zip(sources).map(info).collect();
        warnings.extend(sequence_warnings(&rows, &sequences, &CLIP));
        warnings.extend(still_parts(&layout, &changing_columns(&all)));
        Ok(Self { mapping, layout, y, column_means, sequences, frame_time, frames_per_second, warnings })
    }
}

fn encoded(mapping: &PoseMapping, clips: &[Clip]) -> Result<Vec<Encoded>, DatasetError> {
    let error =
        |clip: &Clip, reason| DatasetError::Pose { clip: clip.name.clone(), reason: Box::new(reason) };
    clips.iter().map(|clip| mapping.encode(clip).map_err(|reason| error(clip, reason))).collect()
}

fn climb_warning(change: f64, clip: &str) -> String {
    let (verb, goes_on) = if change > 0.0 { ("rises", "rising") } else { ("falls", "falling") };
    let legs = (100.0 * change.abs()).round() / 100.0;
    format!(
        "{clip}: the root {verb} steadily, by {legs} leg lengths in all: the model learns the changes of the height \
         from frame to frame, and its motion goes on {goes_on}"
    )
}

/// A warning about parts that no clip moves. A body has many columns that never change, such as those of
/// fingers; only a part of nothing else is worth a warning.
fn still_parts(layout: &PartsLayout, changing: &[bool]) -> Option<String> {
    let is_still = |part: &usize| !layout.columns(*part).iter().any(|column| changing[*column]);
    let still: Vec<&str> =
        (0..layout.parts().len()).filter(is_still).map(|part| layout.parts()[part].name.as_str()).collect();
    // In a data set of still clips, each clip has its warning.
    if still.len() == layout.parts().len() { None } else { constant_warning("part", &still) }
}

impl<S> Dataset<S> {
    /// The error of a training on this data set, with the clip's name where the reason is in one clip.
    pub fn training_error(&self, reason: TrainingError) -> DatasetError {
        DatasetError::from_training(reason, &self.sequences)
    }

    /// The numbers of frames T_s of the sequences.
    pub fn lengths(&self) -> Vec<usize> {
        self.sequences.iter().map(|s| s.frames).collect()
    }
}

crate::coded!(DatasetError {
    Self::Body { reason, .. } | Self::OtherBody { reason, .. } if reason.only_bones_differ() => Bones,
    Self::Short { .. } | Self::Clip(_) | Self::Pose { .. } => Clip,
    Self::Parts(_) => Parts,
    Self::Sequence { reason, .. } => reason.code(),
    Self::Training(reason) => reason.code(),
    _ => Clips,
});

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{parts, samples};
    use nalgebra::{UnitQuaternion, Vector3};
    use std::f64::consts::FRAC_PI_2;

    /// The clip with the pose of its first frame in all frames.
    fn still(clip: &Clip, name: &str) -> Clip {
        let mut still = Clip { name: name.to_owned(), sha256: "another".to_owned(), ..clip.clone() };
        for frame in 0..still.frames() {
            still.values.set_row(frame, &clip.values.row(0));
        }
        still
    }

    fn warnings(clips: &[&Clip]) -> Vec<String> {
        let parts = &parts::presets(&clips[0].skeleton)[1].parts;
        let sources: Vec<Source> = clips.iter().map(|clip| Source::from(*clip)).collect();
        Dataset::new(&sources, parts, 30.0).unwrap().warnings
    }

    #[test]
    fn samples_give_no_warning() {
        let clips = ["walk-1", "walk-2", "walk-wave-1"].map(|id| samples::clip(id).unwrap());
        assert!(warnings(&clips.each_ref()).is_empty());
    }

    #[test]
    fn warns_of_a_clip_that_does_not_move() {
        let walk = samples::clip("walk-1").unwrap().cut(0, 40).unwrap();
        let still = still(&walk, "still.bvh");
        let expected = "the clip still.bvh has the same pose in all of its 20 frames";
        assert_eq!(warnings(&[&walk, &still]), [expected]);
        assert_eq!(warnings(&[&still]), [expected]);
    }

    #[test]
    fn warns_of_a_part_that_no_clip_moves() {
        let mut walk = samples::clip("walk-1").unwrap();
        let upper = parts::presets(&walk.skeleton)[1].parts[1].clone();
        let starts = walk.skeleton.channel_starts();
        let channels =
            |joint: usize| starts[joint]..starts[joint] + walk.skeleton.joints[joint].channels.len();
        let channels: Vec<usize> = upper.joints.iter().flat_map(|joint| channels(*joint)).collect();
        for channel in channels {
            let first = walk.values[(0, channel)];
            walk.values.column_mut(channel).fill(first);
        }
        let expected = "the part upper never changes, so a model learns nothing about it";
        assert_eq!(warnings(&[&walk]), [expected]);
    }

    #[test]
    fn a_clip_with_another_axis_is_turned() {
        let walk = samples::clip("walk-1").unwrap().resample(30.0).unwrap();
        let mut turned =
            Clip { name: "z.bvh".to_owned(), sha256: "another".to_owned(), found_up: None, ..walk.clone() };
        let upward = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2);
        for t in 0..turned.frames() {
            let pose = walk.local_pose(t);
            let place = upward * pose.positions[0];
            (0..3).for_each(|axis| turned.values[(t, axis)] = place[axis]);
            // The root turns about z, y and x, in this order.
            let (x, y, z) = (upward * pose.rotations[0]).euler_angles();
            (3..6).zip([z, y, x]).for_each(|(column, angle)| turned.values[(t, column)] = angle.to_degrees());
        }
        let parts = &parts::presets(&walk.skeleton)[1].parts;
        let dataset = Dataset::new(&[Source::from(&walk), Source::from(&turned)], parts, 30.0).unwrap();
        for y in &dataset.y {
            let rows = walk.frames();
            assert!((y.rows(0, rows) - y.rows(rows, rows)).amax() < 1e-6);
        }
        let [warning] = &dataset.warnings[..] else { panic!("{:?}", dataset.warnings) };
        assert!(warning.starts_with("z.bvh: the up axis is z here and y in the body"), "{warning}");
    }

    #[test]
    fn a_model_of_a_climb_learns_changes_of_the_height() {
        let mut stairs = samples::clip("walk-1").unwrap();
        for t in 0..stairs.frames() {
            stairs.values[(t, 1)] += 0.6 * t as f64;
        }
        let [warning] = &warnings(&[&stairs])[..] else { panic!() };
        assert!(warning.contains("the root rises steadily"), "{warning}");
    }

    #[test]
    fn warns_of_a_clip_given_twice_but_not_of_its_pieces() {
        let walk = samples::clip("walk-1").unwrap();
        let copy = Clip { name: "copy.bvh".to_owned(), ..walk.clone() };
        let name = &walk.name;
        assert_eq!(
            warnings(&[&walk, &walk]),
            [format!("the clip {name} is given twice, so its frames count twice")]
        );
        assert_eq!(
            warnings(&[&walk, &copy]),
            [format!("the clip copy.bvh has the same content as {name}, so these frames count twice")]
        );
        let pieces = [walk.cut(0, 40).unwrap(), walk.cut(40, 80).unwrap()];
        assert!(warnings(&pieces.each_ref()).is_empty());
    }

    #[test]
    fn all_clips_get_the_rate_of_the_first_where_it_is_near_the_rate_asked_for() {
        let walk = samples::clip("walk-1").unwrap().resample(30.0).unwrap();
        let [fast, slow] = [30.5, 29.5].map(|rate| Clip { frame_time: 1.0 / rate, ..walk.clone() });
        let parts = &parts::presets(&walk.skeleton)[1].parts;
        let dataset = Dataset::new(&[Source::from(&fast), Source::from(&slow)], parts, 30.0).unwrap();
        assert_eq!(dataset.frame_time, fast.frame_time);
        // As long as before, in seconds.
        let steps = (walk.frames() - 1) as f64;
        let expected = (steps * 30.5 / 29.5).floor() as usize + 1;
        assert_eq!(dataset.lengths(), [walk.frames(), expected]);
    }

    #[test]
    fn a_climb_is_said_in_hundredths_of_leg_lengths() {
        let warning = climb_warning(-1.234, "down.bvh");
        let expected = "down.bvh: the root falls steadily, by 1.23 leg lengths in all: ";
        assert!(warning.starts_with(expected) && warning.ends_with("goes on falling"), "{warning}");
    }
}
