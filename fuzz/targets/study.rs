//! Any text as a study: read, shown, written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vcgpdm_lab::perception::Study;

fuzz_target!(|text: &str| {
    let Ok(study) = Study::from_json(text) else { return };
    let trials = study.trials(1);
    assert!(trials.iter().all(|trial| trial.left < study.stimuli.len() && trial.right < study.stimuli.len()));
    for stimulus in 0..study.stimuli.len() {
        assert!(study.positions(stimulus).is_some_and(|places| places.iter().all(|place| place.is_finite())));
    }
    let written = study.to_json().expect("a study that was read can be written");
    assert!(Study::from_json(&written).expect("a study that was written can be read") == study);
});
