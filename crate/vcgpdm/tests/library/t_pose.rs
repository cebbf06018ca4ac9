//! A T-pose before the motion is removed when a recording becomes a clip, and only then.

use nalgebra::DMatrix;
use vcgpdm_core::models::{Dataset, Source};
use vcgpdm_core::motion::{Clip, Recording, bvh, parts, samples};

/// The number of frames in a data set of a clip at its own rate.
fn frames_trained_on(clip: &Clip) -> usize {
    let whole = &parts::presets(&clip.skeleton)[0].parts;
    let sources = [Source { clip, first_frames: None }];
    Dataset::new(&sources, whole, 1.0 / clip.frame_time).unwrap().sequences[0].frames
}

#[test]
fn the_t_pose_of_a_file_is_removed_once() {
    let walk = samples::clip("walk-1").unwrap();
    // As in conversions of the CMU recordings: a row with all angles zero at the position where the walk
    // begins.
    let mut values = walk.values.clone().insert_row(0, 0.0);
    for column in 0..3 {
        values[(0, column)] = walk.values[(0, column)];
    }
    let text = bvh::write(&Clip::new("walk.bvh", walk.skeleton.clone(), walk.frame_time, values));
    let recording = bvh::read("walk.bvh", text.as_bytes()).unwrap();
    assert_eq!(recording.frames(), walk.frames() + 1);

    let clip = recording.into_clip();
    assert_eq!(clip.values, walk.values);
    let warnings = clip.warnings.iter().filter(|warning| warning.contains("T-pose")).count();
    assert_eq!((warnings, clip.piece), (1, None));
    assert_eq!(frames_trained_on(&clip), walk.frames());
}

#[test]
fn a_cut_that_begins_at_a_jerk_keeps_its_first_frame() {
    let walk = samples::clip("walk-1").unwrap();
    // Up to frame 30 arms and legs have other angles, so the pose jumps from frame 30 to 31.
    let values = DMatrix::from_fn(walk.frames(), walk.values.ncols(), |frame, column| {
        walk.values[(frame, column)] + if frame <= 30 && column >= 6 { 40.0 } else { 0.0 }
    });
    let clip = Recording::new("jerk.bvh", walk.skeleton.clone(), walk.frame_time, values).into_clip();
    assert_eq!(clip.frames(), walk.frames());

    let cut = clip.cut(30, clip.frames()).unwrap();
    // As a separate file, its first frame would count as a T-pose.
    let alone = Recording::new("cut.bvh", cut.skeleton.clone(), cut.frame_time, cut.values.clone());
    assert_eq!(alone.rows_before_motion(), 1);
    assert_eq!(cut.piece, Some((30, clip.frames())));
    assert_eq!(frames_trained_on(&cut), clip.frames() - 30);
    assert_eq!(cut.stage_positions().len(), (clip.frames() - 30) * cut.skeleton.figure().len() * 3);
}
