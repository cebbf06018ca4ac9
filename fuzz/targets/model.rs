//! Any text as a model of any kind: read, rolled out, turned into poses, written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vcgpdm::models::{Model, TrainedModel};

fuzz_target!(|text: &str| {
    let Ok(model) = TrainedModel::<Model>::from_json(text) else { return };
    if let Ok(latents) = model.model.rollout(0, 20) {
        let columns = model.body.columns(&latents);
        if columns.iter().all(|value| value.is_finite()) {
            let _ = model.body.positions(&columns);
        }
    }
    let written = model.to_json().expect("what was read can be written");
    let again = TrainedModel::<Model>::from_json(&written).expect("what was written can be read");
    assert_eq!(again.to_json().ok(), Some(written));
});
