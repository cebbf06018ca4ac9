//! The golden cases, natively; crate/wasm/tests runs the same in wasm.

#[path = "../shared/golden.rs"]
mod cases;

#[test]
fn golden_cases_agree() {
    cases::golden_cases_agree();
}
