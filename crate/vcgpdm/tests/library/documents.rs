//! Documents that an earlier program wrote are read, and written again to the letter: tests/documents/*.json.

use vcgpdm::models::variational::Vcgpdm;
use vcgpdm::models::{Model, TrainedModel};

const DOCUMENTS: [(&str, &str); 5] = [
    ("vcgpdm", include_str!("documents/vcgpdm.json")),
    ("map-cgpdm", include_str!("documents/map-cgpdm.json")),
    ("tmp", include_str!("documents/tmp.json")),
    ("dmp-discrete", include_str!("documents/dmp-discrete.json")),
    ("dmp-rhythmic", include_str!("documents/dmp-rhythmic.json")),
];

#[test]
fn earlier_documents_are_written_again_to_the_letter() {
    for (kind, text) in DOCUMENTS {
        let trained = TrainedModel::<Model>::from_json(text).unwrap();
        assert_eq!((trained.kind().id(), trained.to_json().unwrap().as_str()), (kind, text));
        assert!(trained.rollout(0, 20).unwrap().iter().all(|value| value.is_finite()), "{kind}");
    }
    let (_, text) = DOCUMENTS[0];
    assert_eq!(TrainedModel::<Vcgpdm>::from_json(text).unwrap().to_json().unwrap(), text);
}
