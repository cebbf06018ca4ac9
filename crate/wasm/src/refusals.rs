//! What is refused to the model that walks first on the page, in words: once it was done, half done, or ended
//! the program.

use crate::convert::to_js;
use crate::error::VcgpdmError;
use crate::given::{Text, Whole};
use crate::live::LiveRollout;
use crate::model::Model;
use crate::rollout::{Rollout, best_to_show};
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

fn refusal<T>(done: Result<T, VcgpdmError>) -> String {
    let error: js_sys::Error = JsValue::from(done.err().unwrap()).unchecked_into();
    error.message().into()
}

#[wasm_bindgen_test]
fn a_live_rollout_stays_usable_after_what_it_refuses() {
    let (_, rollout) = walk();
    let mut live = LiveRollout::new(&rollout, &whole(30)).ok().unwrap();
    let said = refusal(live.advance(&whole(1_000_000_000)));
    assert!(said.starts_with("expected from 1 to ") && said.ends_with(" frames, found 1000000000"), "{said}");
    let said = refusal(live.push(&whole(0), vec![f64::NAN, 0.0, 0.0]));
    assert_eq!(said, "expected a push of part 0 by finite numbers, found NaN");
    let said = refusal(live.set_couplings(&[1.0; 3], false));
    assert_eq!(said, "expected coupling variances for 2 x 2 parts, found 3 numbers");
    assert!(live.advance(&whole(5)).is_ok());
}

#[wasm_bindgen_test]
fn sampled_rollouts_have_room_together() {
    let (model, _) = walk();
    let sampled = |frames, count| model.sampled_rollouts(options(frames), &whole(count), &whole(1));
    for count in [0, 1001] {
        let expected = format!("the number of rollouts: expected from 1 to 1000, found {count}");
        assert_eq!(refusal(sampled(5, count)), expected);
    }
    let said = refusal(sampled(100_000, 1000));
    assert!(
        said.starts_with("all rollouts together: expected from 1 to ") && said.ends_with("found 100000000"),
        "{said}"
    );
    assert_eq!(sampled(5, 2).ok().unwrap().len(), 2);
}

#[wasm_bindgen_test]
fn measures_begin_at_a_frame_that_is_there() {
    let (_, rollout) = walk();
    assert_eq!(refusal(rollout.measures(&whole(40))), "the first frame: expected one from 0 to 39, found 40");
    assert!(rollout.measures(&whole(39)).is_ok());
}

#[wasm_bindgen_test]
fn ranks_and_bounds_are_pairs() {
    let best = |ranks: &[f64], bounds: &[f64]| best_to_show(ranks, bounds);
    assert_eq!(best(&[1.0, 2.0, 2.0], &[30.0, 10.0, 20.0]).ok(), Some(2));
    assert_eq!(
        refusal(best(&[1.0, 2.0], &[30.0])),
        "the ranks: expected as many as there are bounds, found 2"
    );
    for rank in [256.0, 1.5, -1.0, f64::NAN] {
        let expected = format!("the ranks: expected whole numbers from 0 to 255, found {rank}");
        assert_eq!(refusal(best(&[rank], &[30.0])), expected);
    }
}
