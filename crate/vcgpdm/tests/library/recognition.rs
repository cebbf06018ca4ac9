//! Movements of a library in clips that it was not trained on.

use crate::combinations::trained;
use nalgebra::DMatrix;
use vcgpdm::motion::{Clip, samples};

/// The boundaries of a joined clip are found to within this time, in seconds.
const NEAR: f64 = 0.3;
/// Frames of each piece.
const PIECE: usize = 70;

/// The first frames of these samples, one after the other. The body jumps between them.
fn joined(ids: &[&str]) -> (Clip, Vec<f64>) {
    let clips: Vec<Clip> = ids.iter().map(|id| samples::clip(id).unwrap().cut(0, PIECE).unwrap()).collect();
    let rows: usize = clips.iter().map(Clip::frames).sum();
    let mut values = DMatrix::zeros(rows, clips[0].values.ncols());
    let (mut row, mut times) = (0, Vec::new());
    for clip in &clips {
        values.rows_mut(row, clip.frames()).copy_from(&clip.values);
        row += clip.frames();
        times.push(row as f64 * clip.frame_time);
    }
    times.pop();
    (Clip { values, ..clips[0].clone() }, times)
}

#[test]
fn walking_then_waving_then_walking_is_cut_into_three_pieces() {
    let trained = trained(100);
    let (clip, times) = joined(&["walk-3", "walk-wave-3", "walk-4"]);
    let found = trained.recognise(&clip).unwrap();
    let segments = found.segments();
    let movements: Vec<usize> = segments.iter().map(|segment| segment.movement).collect();
    assert_eq!(movements, [0, 1, 0], "{segments:?}");
    for (segment, time) in segments.iter().zip(times) {
        let end = segment.frames.end as f64 * trained.body.frame_time;
        assert!((end - time).abs() < NEAR, "{end} s, joined at {time} s");
    }
    assert!(segments.iter().all(|segment| segment.probability > 0.9), "{segments:?}");
}

#[test]
fn a_clip_of_another_body_is_refused() {
    let trained = trained(3);
    let mut other = samples::clip("walk-3").unwrap();
    other.skeleton.joints[2].offset[1] *= 2.0;
    let error = trained.recognise(&other).unwrap_err().to_string();
    assert!(error.contains("is not of the body of the model"), "{error}");
}
