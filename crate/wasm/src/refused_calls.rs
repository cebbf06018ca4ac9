//! Regression tests: invalid calls that once crashed, or half changed an object, now throw.

use crate::models::endless::Endless;
use crate::models::model::Model;
use crate::models::rollout::{Rollout, best_to_show};
use crate::values::arguments::{Text, Whole};
use crate::values::convert::to_js;
use crate::values::error::VcgpdmError;
use serde::Serialize;
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

#[derive(Serialize)]
struct Options {
    frames: usize,
    sequence: usize,
}

fn whole(number: u32) -> Whole {
    JsValue::from(number).unchecked_into()
}

fn options(frames: usize) -> JsValue {
    to_js(&Options { frames, sequence: 0 }).ok().unwrap()
}

fn walk() -> (Model, Rollout) {
    let text: Text = JsValue::from(include_str!("../../../www/first/model.json")).unchecked_into();
    let model = Model::from_json(&text).ok().unwrap();
    let rollout = model.rollout(options(40)).ok().unwrap();
    (model, rollout)
}

fn message_of<T>(done: Result<T, VcgpdmError>) -> String {
    let error: js_sys::Error = JsValue::from(done.err().unwrap()).unchecked_into();
    error.message().into()
}

#[wasm_bindgen_test]
fn a_live_rollout_stays_usable_after_invalid_calls() {
    let (_, rollout) = walk();
    let mut live = Endless::new(&rollout, &whole(30)).ok().unwrap();
    let message = message_of(live.advance(&whole(1_000_000_000)));
    assert!(
        message.starts_with("expected from 1 to ") && message.ends_with(" frames, found 1000000000"),
        "{message}"
    );
    let message = message_of(live.push(&whole(0), vec![f64::NAN, 0.0, 0.0]));
    assert_eq!(message, "expected a push of part 0 by finite numbers, found NaN");
    let message = message_of(live.set_couplings(&[1.0; 3], false));
    assert_eq!(message, "expected coupling variances for 2 x 2 parts, found 3 numbers");
    assert!(live.advance(&whole(5)).is_ok());
}

#[wasm_bindgen_test]
fn all_sampled_rollouts_together_have_a_limit() {
    let (model, _) = walk();
    let sampled = |frames, count| model.sampled_rollouts(options(frames), Some(whole(count)), Some(whole(1)));
    for count in [0, 1001] {
        let expected = format!("the number of rollouts: expected from 1 to 1000, found {count}");
        assert_eq!(message_of(sampled(5, count)), expected);
    }
    let message = message_of(sampled(100_000, 1000));
    assert!(
        message.starts_with("all rollouts together: expected from 1 to ")
            && message.ends_with("found 100000000"),
        "{message}"
    );
    assert_eq!(sampled(5, 2).ok().unwrap().len(), 2);
}

#[wasm_bindgen_test]
fn measures_begin_at_an_existing_frame() {
    let (_, rollout) = walk();
    assert_eq!(
        message_of(rollout.measures(&whole(40))),
        "the first frame: expected one from 0 to 39, found 40"
    );
    assert!(rollout.measures(&whole(39)).is_ok());
}

#[wasm_bindgen_test]
fn there_is_one_error_for_each_rank() {
    let best = |ranks: &[f64], errors: &[f64]| best_to_show(ranks, errors);
    assert_eq!(best(&[1.0, 2.0, 2.0], &[0.1, 0.3, 0.2]).ok(), Some(2));
    assert_eq!(
        message_of(best(&[1.0, 2.0], &[30.0])),
        "the ranks: expected as many as there are errors, found 2"
    );
    for rank in [256.0, 1.5, -1.0, f64::NAN] {
        let expected = format!("the ranks: expected whole numbers from 0 to 255, found {rank}");
        assert_eq!(message_of(best(&[rank], &[30.0])), expected);
    }
}
