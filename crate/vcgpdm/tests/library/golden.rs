//! The golden cases, natively; crate/wasm/tests runs the same in wasm.

#[path = "../shared/golden.rs"]
mod golden;

#[test]
fn golden_cases_agree() {
    golden::golden_cases_agree();
}
