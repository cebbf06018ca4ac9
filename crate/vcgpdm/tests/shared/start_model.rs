//! The model that walks first on the page.

use vcgpdm::models::TrainedModel;
use vcgpdm::models::variational::Vcgpdm;

pub fn start_model() -> TrainedModel<Vcgpdm> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../www/first/model.json");
    TrainedModel::<Vcgpdm>::from_json(&std::fs::read_to_string(path).unwrap()).unwrap()
}
