//! Trainings on the project's own clips, natively. crate/wasm/tests runs the same tests in wasm.

#[path = "../shared/training.rs"]
mod cases;

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
