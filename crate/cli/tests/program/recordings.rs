//! A test with a recorded clip of the folder VCGPDM_CLIPS, which is not part of the project.

use crate::call::{folder, json, text};
use std::path::PathBuf;

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn describes_and_writes_back_a_recorded_clip() {
    let clips = PathBuf::from(std::env::var_os("VCGPDM_CLIPS").unwrap());
    let clip = clips.join("cmu-walk/35_01.bvh");
    let out = folder("real").join("out.bvh");
    let first = json(&["clip", text(&clip), "--out", text(&out)]);
    assert_eq!((first["up_axis"].as_str(), first["joints"].as_array().map(Vec::len)), (Some("y"), Some(31)));
    assert!(first["warnings"].to_string().contains("T-pose"));
    let again = json(&["clip", text(&out)]);
    for key in ["frames", "frame_time", "joints", "height", "up_axis"] {
        assert_eq!(first[key], again[key], "{key}");
    }
    assert_eq!(
        again["warnings"].as_array().map(Vec::len),
        Some(0),
        "the T-pose was dropped once and for all"
    );
}
