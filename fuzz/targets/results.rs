//! Any text as the results of an evaluation: read, compared, written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vcgpdm_lab::evaluation::{Comparison, Results};

fuzz_target!(|text: &str| {
    let Ok(results) = Results::from_json(text) else { return };
    let _ = Comparison::new(&results);
    let written = results.to_json().expect("results that were read can be written");
    let again = Results::from_json(&written).expect("results that were written can be read");
    assert_eq!(again.finished().len(), results.finished().len());
});
