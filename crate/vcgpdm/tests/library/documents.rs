//! Documents from earlier versions (tests/library/documents) are read, and written with the same bytes.

use vcgpdm::document::Document;
use vcgpdm::models::Model;
use vcgpdm::models::library::TrainedLibrary;

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

#[test]
fn documents_of_earlier_versions_are_written_with_the_same_bytes() {
    for (name, text) in DOCUMENTS {
        if ["library", "primitives"].contains(&name) {
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
