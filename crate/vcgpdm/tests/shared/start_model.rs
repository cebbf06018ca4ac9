//! The model that the page opens with.

use vcgpdm_core::models::Model;

pub fn start_model() -> Model {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../www/first/model.json");
    Model::coupled_from_json(&std::fs::read_to_string(path).unwrap()).unwrap()
}
