//! What the library's own tests hold natively holds in wasm: the same numbers, with the same code.

#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use wasm_bindgen_test::wasm_bindgen_test;

#[path = "../../lab/tests/shared/golden.rs"]
mod golden;
#[path = "../../vcgpdm/tests/shared/training.rs"]
mod training;

#[wasm_bindgen_test]
fn golden_cases_agree() {
    golden::golden_cases_agree();
}

#[wasm_bindgen_test]
fn native_and_wasm_training_give_the_same_bounds() {
    training::native_and_wasm_training_give_the_same_bounds();
}

#[wasm_bindgen_test]
fn a_model_of_sample_walks_walks_and_is_read_from_its_document() {
    training::a_model_of_sample_walks_walks_and_is_read_from_its_document();
}

#[wasm_bindgen_test]
fn each_kind_of_model_trains_and_rolls_out() {
    training::each_kind_of_model_trains_and_rolls_out();
}

#[wasm_bindgen_test]
fn alpha_live_rollouts_and_completing_give_the_same_numbers() {
    training::alpha_live_rollouts_and_completing_give_the_same_numbers();
}

#[wasm_bindgen_test]
fn a_library_of_primitives_trains_and_rolls_out() {
    training::a_library_of_primitives_trains_and_rolls_out();
}

#[wasm_bindgen_test]
fn a_table_trains_and_rolls_out() {
    training::a_table_trains_and_rolls_out();
}

#[wasm_bindgen_test]
fn the_same_training_gives_the_same_file() {
    training::the_same_training_gives_the_same_file();
}
