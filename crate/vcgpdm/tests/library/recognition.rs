//! Movements of a library in clips that it was not trained on.

use crate::combinations::trained;
use vcgpdm::motion::samples;

/// The boundaries of a joined clip are found to within this time, in seconds.
const NEAR: f64 = 0.3;
/// Frames of each piece.
const PIECE: usize = 40;

#[test]
fn walking_then_waving_then_walking_is_cut_into_three_pieces() {
    let trained = trained(100);
    let clips = ["walk-3", "walk-wave-3", "walk-4"]
        .map(|id| samples::clip(id).unwrap().resample(30.0).unwrap().cut(0, PIECE).unwrap());
    let found = trained.recognise(&clips.each_ref()).unwrap();
    let segments = found.segments();
    let movements: Vec<usize> = segments.iter().map(|segment| segment.movement).collect();
    assert_eq!(movements, [0, 1, 0], "{segments:?}");
    for (segment, joined) in segments.iter().zip([PIECE, 2 * PIECE]) {
        let error = segment.frames.end.abs_diff(joined) as f64 * trained.body.frame_time;
        assert!(error < NEAR, "{error} s");
    }
    assert!(segments.iter().all(|segment| segment.probability > 0.9), "{segments:?}");
}

#[test]
fn a_clip_of_another_body_is_refused() {
    let trained = trained(3);
    let mut other = samples::clip("walk-3").unwrap();
    other.skeleton.joints[2].offset[1] *= 2.0;
    let error = trained.recognise(&[&other]).unwrap_err().to_string();
    assert!(error.contains("is not of the body of the model"), "{error}");
}
