//! Any text as answers to a small study: read and analysed.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;
use vcgpdm_lab::perception::{AnalysisOptions, AnswerFile, PerceptionResults, Study, read_answers};

fuzz_target!(|text: &str| {
    static STUDY: OnceLock<Study> = OnceLock::new();
    let study = STUDY.get_or_init(|| {
        Study::from_json(include_str!("../../www/public/study/walks.study.json")).expect("the page's study")
    });
    let Ok(answers) = read_answers(study, &[AnswerFile { name: "fuzzed", text }]) else { return };
    let options = AnalysisOptions { draws: 10, ..AnalysisOptions::default() };
    if let Ok(results) = PerceptionResults::new(study, &answers, options) {
        assert!(results.figures().iter().all(|figure| !figure.csv.contains("NaN") && !figure.csv.contains("inf,")));
    }
});
