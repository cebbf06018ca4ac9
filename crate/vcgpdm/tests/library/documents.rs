//! Documents from earlier versions (tests/library/documents) are read, and written with the same bytes; the examples
//! write files.

use std::path::PathBuf;
use vcgpdm_core::document::Document;
use vcgpdm_core::models::Model;
use vcgpdm_core::models::library::TrainedLibrary;
use vcgpdm_core::motion::bvh;

/// One document of each kind, with a name.
pub const DOCUMENTS: [(&str, &str); 9] = [
    ("vcgpdm", include_str!("documents/vcgpdm.json")),
    ("map-cgpdm", include_str!("documents/map-cgpdm.json")),
    ("tmp", include_str!("documents/tmp.json")),
    ("dmp-discrete", include_str!("documents/dmp-discrete.json")),
    ("dmp-rhythmic", include_str!("documents/dmp-rhythmic.json")),
    ("combination of primitives", include_str!("documents/combination.json")),
    ("tables", include_str!("documents/series.json")),
    ("library", include_str!("documents/library.json")),
    ("primitives", include_str!("documents/primitives.json")),
];

/// Whether the document of this name is a library, not a model.
pub fn is_library(name: &str) -> bool {
    ["library", "primitives"].contains(&name)
}

#[test]
fn documents_of_earlier_versions_are_written_with_the_same_bytes() {
    for (name, text) in DOCUMENTS {
        if is_library(name) {
            let library = TrainedLibrary::from_json(text).unwrap();
            assert_eq!(library.to_json().unwrap(), text);
            continue;
        }
        let (kind, again, rolled) = match Document::from_json(text).unwrap() {
            Document::Body(trained) => (trained.kind(), trained.to_json(), trained.rollout(0, 20)),
            Document::Series(trained) => (trained.kind(), trained.to_json(), trained.rollout(0, 20)),
        };
        assert_eq!(again.unwrap(), text, "{name}");
        assert!(["combination of primitives", "tables", kind.id()].contains(&name), "{name}");
        assert!(rolled.unwrap().iter().all(|value| value.is_finite()), "{name}");
    }
    let (_, text) = DOCUMENTS[0];
    assert_eq!(Model::coupled_from_json(text).unwrap().to_json().unwrap(), text);
}

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
