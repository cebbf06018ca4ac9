//! Any bytes as a motion clip: read, measured, cut, resampled, written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vcgpdm_core::motion::{bvh, parts};

fuzz_target!(|bytes: &[u8]| {
    let Ok(recording) = bvh::read("fuzzed.bvh", bytes) else { return };
    let clip = recording.into_clip();
    assert!(clip.values.iter().all(|value| value.is_finite()));
    // Long clips take long and test nothing more.
    if clip.frames() * clip.skeleton.joints.len() > 20_000 {
        return;
    }
    let _ = clip.stage_positions();
    let _ = parts::presets(&clip.skeleton);
    let _ = clip.cut(0, clip.frames().div_ceil(2));
    if clip.frame_time < 1.0 {
        let _ = clip.resample(10.0);
    }
    let written = bvh::write(&clip);
    let again = bvh::read("again.bvh", written.as_bytes()).expect("a clip that was written can be read");
    assert_eq!(again.values.nrows(), clip.frames());
});
