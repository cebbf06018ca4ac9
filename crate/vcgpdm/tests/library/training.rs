//! Training on the project's own clips, natively; crate/wasm/tests runs the same in wasm.

#[path = "../shared/training.rs"]
mod cases;

#[test]
fn native_and_wasm_take_the_same_path() {
    cases::native_and_wasm_take_the_same_path();
}

#[test]
fn the_sample_walk_trains_to_a_model_that_walks_and_can_be_shared() {
    cases::the_sample_walk_trains_to_a_model_that_walks_and_can_be_shared();
}

#[test]
fn each_kind_of_model_trains_and_rolls_out() {
    cases::each_kind_of_model_trains_and_rolls_out();
}

#[test]
fn a_library_of_primitives_trains_and_rolls_out() {
    cases::a_library_of_primitives_trains_and_rolls_out();
}

#[test]
fn a_table_trains_and_rolls_out() {
    cases::a_table_trains_and_rolls_out();
}
