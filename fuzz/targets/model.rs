//! Any text as a model of any kind: read, rolled out, turned into poses, written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vcgpdm_core::models::Model;

fuzz_target!(|text: &str| {
    let Ok(model): Result<Model, _> = Model::from_json(text) else { return };
    if let Ok(columns) = model.rollout(0, 20)
        && columns.iter().all(|value| value.is_finite())
    {
        let _ = model.body.positions(&columns);
    }
    let written = model.to_json().expect("a model that was read can be written");
    let again: Model = Model::from_json(&written).expect("a model that was written can be read");
    assert_eq!(again.to_json().ok(), Some(written));
});
