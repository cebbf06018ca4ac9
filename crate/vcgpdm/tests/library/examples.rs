//! Runs the examples and checks the files that they write.

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

/// An empty folder for one test.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn the_examples_train_rollout_and_couplings_run() {
    let folder = folder("walk");
    let error = rollout::run(&folder).unwrap_err().to_string();
    assert!(error.ends_with("run the example train first"), "{error}");
    train::run(&folder).unwrap();
    rollout::run(&folder).unwrap();
    let text = std::fs::read(folder.join("new-walk.bvh")).unwrap();
    let walk = bvh::read("new-walk.bvh", &text).unwrap().into_clip();
    let travelled = (walk.world_pose(199).positions[0] - walk.world_pose(0).positions[0]).norm();
    assert_eq!(walk.frames(), 200);
    assert!(travelled > 3.0 * walk.height(), "the body travels {travelled} cm in ten seconds");
    couplings::run(&folder).unwrap();
}

#[test]
fn the_example_own_data_writes_a_prediction_of_100_rows() {
    let folder = folder("own-data");
    own_data::run(&folder).unwrap();
    let table = std::fs::read_to_string(folder.join("predicted.csv")).unwrap();
    assert_eq!(table.lines().count(), 101);
}
