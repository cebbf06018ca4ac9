//! Trainings on the project's own clips, natively. crate/wasm/tests runs the same tests in wasm.

use std::fs;
use vcgpdm::{Clip, Dataset, Source, VariationalSettings, Vcgpdm, part_presets, sample_clip};
use vcgpdm_core::motion::samples;

#[path = "../shared/training.rs"]
mod cases;

/// The terminal program, the npm package, the page and the Python package are held against the same number.
#[test]
fn the_usual_settings_give_the_bound_that_every_program_gives() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/defaults.json");
    let golden: serde_json::Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let names = golden["clips"].as_array().unwrap().iter();
    let clips: Vec<_> = names.map(|name| sample_clip(name.as_str().unwrap()).unwrap()).collect();
    let sources: Vec<Source> = clips.iter().map(Source::from).collect();
    let dataset = Dataset::new(&sources, &part_presets(&clips[0].skeleton)[1].parts, 30.0).unwrap();
    let most = golden["max_iterations"].as_u64().unwrap() as usize;
    let settings = VariationalSettings::for_dataset(&dataset).with_max_iterations(most);
    let model = Vcgpdm::fit(&dataset, &settings, 0).unwrap();
    let (found, expected) = (model.provenance.bound(), golden["bound"].as_f64().unwrap());
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
}

#[test]
fn the_usual_settings_go_by_the_longest_clip() {
    let [short, long] = [3.0, 9.0].map(|seconds| samples::trial("walk", 1, seconds).unwrap());
    let points = |clips: &[&Clip]| {
        let sources: Vec<Source> = clips.iter().map(|clip| Source::from(*clip)).collect();
        let dataset = Dataset::new(&sources, &part_presets(&clips[0].skeleton)[1].parts, 30.0).unwrap();
        VariationalSettings::for_dataset(&dataset).dynamics_ips
    };
    assert_eq!([points(&[&short]), points(&[&short, &long]), points(&[&long, &short])], [12, 30, 30]);
}

#[test]
fn native_and_wasm_training_give_the_same_bounds() {
    cases::native_and_wasm_training_give_the_same_bounds();
}

#[test]
fn a_model_of_sample_walks_walks_and_is_read_from_its_document() {
    cases::a_model_of_sample_walks_walks_and_is_read_from_its_document();
}

#[test]
fn each_kind_of_model_trains_and_rolls_out() {
    cases::each_kind_of_model_trains_and_rolls_out();
}

#[test]
fn alpha_live_rollouts_and_completing_give_the_same_numbers() {
    cases::alpha_live_rollouts_and_completing_give_the_same_numbers();
}

#[test]
fn a_library_of_primitives_trains_and_rolls_out() {
    cases::a_library_of_primitives_trains_and_rolls_out();
}

#[test]
fn a_table_trains_and_rolls_out() {
    cases::a_table_trains_and_rolls_out();
}

#[test]
fn the_same_training_gives_the_same_file() {
    cases::the_same_training_gives_the_same_file();
}
