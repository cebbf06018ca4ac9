//! The examples that teach run and do what they say.

use std::path::PathBuf;
use vcgpdm::motion::bvh;

#[allow(dead_code)]
#[path = "../../examples/couplings.rs"]
mod couplings;
#[allow(dead_code)]
#[path = "../../examples/own_data.rs"]
mod own_data;
#[allow(dead_code)]
#[path = "../../examples/rollout.rs"]
mod rollout;
#[allow(dead_code)]
#[path = "../../examples/train.rs"]
mod train;

/// An empty folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn a_model_is_trained_rolled_out_and_coupled_otherwise() {
    let folder = folder("walk");
    let error = rollout::run(&folder).unwrap_err().to_string();
    assert!(error.ends_with("run the example train first"), "{error}");
    train::run(&folder).unwrap();
    rollout::run(&folder).unwrap();
    let text = std::fs::read(folder.join("new-walk.bvh")).unwrap();
    let walk = bvh::read("new-walk.bvh", &text).unwrap().into_clip();
    let travelled = (walk.world_pose(199).positions[0] - walk.world_pose(0).positions[0]).norm();
    assert_eq!(walk.frames(), 200);
    assert!(travelled > 3.0 * walk.height(), "in ten seconds it goes {travelled} cm far");
    couplings::run(&folder).unwrap();
}

#[test]
fn a_model_is_trained_on_a_matrix() {
    let folder = folder("matrix");
    own_data::run(&folder).unwrap();
    let table = std::fs::read_to_string(folder.join("predicted.csv")).unwrap();
    assert_eq!(table.lines().count(), 101);
}
