//! Live rollouts of the model that the page opens with.

use crate::start_model;

use nalgebra::DMatrix;
use start_model::start_model;
use vcgpdm::models::{LiveRollout, Push, Reading, RolloutRequest};

#[test]
fn an_undisturbed_live_rollout_equals_the_rollout() {
    let model = start_model();
    let model = model.coupled().unwrap();
    let request = RolloutRequest { frames: 60, ..RolloutRequest::default() };
    let rollout = model.rollout(&request).unwrap();
    let expected = model.positions(&rollout).unwrap();
    let mut live = LiveRollout::after(model, &rollout, 19, 0).unwrap();
    let dynamics = model.model.dynamics(&model.model.alpha, Reading::AsLearned).unwrap();
    let mut positions = Vec::new();
    let mut last = DMatrix::zeros(0, 0);
    for frames in [1, 4, 20, 15] {
        let next = live.advance(model, &dynamics, frames).unwrap();
        positions.extend(next.positions);
        last = next.latents[0].clone();
    }
    let begin = 20 * expected.len() / 60;
    assert_eq!(positions.len(), expected.len() - begin);
    // Too many frames are refused before memory is allocated.
    let error = live.clone().advance(model, &dynamics, 1_000_000_000).unwrap_err().to_string();
    assert!(error.starts_with("expected from 1 to ") && error.ends_with("found 1000000000"), "{error}");
    for (a, b) in positions.iter().zip(&expected[begin..]) {
        assert!((a - b).abs() < 1e-4, "{a} {b}");
    }
    assert!((last.row(14) - rollout.latents[0].row(59)).amax() < 1e-9);
}

#[test]
fn a_pulled_node_moves_in_the_direction_of_the_pull() {
    let model = start_model();
    let model = model.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 40, ..RolloutRequest::default() }).unwrap();
    let live = LiveRollout::after(model, &rollout, 30, 0).unwrap();
    let figure = model.body.mapping.skeleton().figure();
    let joints = &model.body.mapping.skeleton().joints;
    let hand = figure.iter().position(|node| joints[node.joint].name.contains("Hand")).unwrap();
    let push = live.pull(model, hand, [0.0, 0.0, 0.05]).unwrap();
    let part = &model.body.layout.parts()[push.part];
    assert!(part.joints.contains(&figure[hand].joint));
    let dynamics = model.model.dynamics(&model.model.alpha, Reading::AsLearned).unwrap();
    let place = |mut live: LiveRollout| live.advance(model, &dynamics, 1).unwrap().positions[3 * hand + 2];
    let (free, mut pulled) = (place(live.clone()), live);
    pulled.push(&push).unwrap();
    let moved = place(pulled) - free;
    assert!(moved > 0.005 && moved < 0.1, "{moved}");
    let error = LiveRollout::after(model, &rollout, 30, 0).unwrap().pull(model, 999, [0.0; 3]).unwrap_err();
    assert!(error.to_string().starts_with("expected a node of the figure from 0 to "));
}

#[test]
fn parts_on_the_cycle_are_in_phase_and_a_push_moves_a_part_off_it() {
    let model = start_model();
    let model = model.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 250, ..RolloutRequest::default() }).unwrap();
    let mut live = LiveRollout::after(model, &rollout, 240, 0).unwrap();
    let dynamics = model.model.dynamics(&model.model.alpha, Reading::AsLearned).unwrap();
    let settled = live.advance(model, &dynamics, 10).unwrap().places;
    assert_eq!(settled.len(), 10 * 2);
    for both in settled.chunks_exact(2) {
        let apart = (both[0].phase - both[1].phase + 0.5).rem_euclid(1.0) - 0.5;
        assert!(apart.abs() < 0.05 && both[0].distance < 0.2 && both[1].distance < 0.2, "{both:?}");
    }
    live.push(&Push { part: 1, by: vec![1.0, 1.0, 0.0], ..Push::default() }).unwrap();
    let pushed = live.advance(model, &dynamics, 1).unwrap().places;
    assert!(pushed[1].distance > 0.3, "{pushed:?}");
}

#[test]
fn a_driven_part_has_the_phase_that_it_is_given_and_the_other_follows() {
    let model = start_model();
    let model = model.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 250, ..RolloutRequest::default() }).unwrap();
    let mut live = LiveRollout::after(model, &rollout, 240, 0).unwrap();
    let dynamics = model.model.dynamics(&model.model.alpha, Reading::AsLearned).unwrap();
    let begin = live.clone().advance(model, &dynamics, 1).unwrap().places;
    let apart = |a: f64, b: f64| (a - b + 0.5).rem_euclid(1.0) - 0.5;
    // Held still, the lower body stays, and the arms cannot go on for long without it.
    let mut held = live.clone();
    held.drive(0, 0.0).unwrap();
    let still = held.advance(model, &dynamics, 90).unwrap();
    let lower = &still.latents[0];
    assert!((lower.row(89) - lower.row(60)).amax() < 1e-6);
    // Half a turn in 20 frames, in one request or in several.
    live.drive(0, 0.5).unwrap();
    let driven = live.clone().advance(model, &dynamics, 20).unwrap();
    let places: Vec<_> = driven.places.chunks_exact(2).map(|both| (both[0].phase, both[1].phase)).collect();
    let turned = apart(places[19].0, begin[0].phase);
    assert!((turned.abs() - 0.5).abs() < 0.06, "{turned}");
    assert!(places.windows(2).all(|pair| (apart(pair[1].0, pair[0].0) - 0.025).abs() < 0.02), "{places:?}");
    // Back again: the arms are drawn along, so they are not where they would be by themselves.
    let mut back = live.clone();
    back.advance(model, &dynamics, 20).unwrap();
    back.drive(0, -0.5).unwrap();
    let returned = back.advance(model, &dynamics, 20).unwrap();
    assert!((returned.latents[0].row(19) - lower.row(89)).amax() < 0.2);
    back.release(0);
    let free = back.advance(model, &dynamics, 120).unwrap().places;
    let last = &free[free.len() - 2..];
    assert!(apart(last[0].phase, last[1].phase).abs() < 0.1 && last[0].distance < 0.5, "{last:?}");

    let error = |part, turns| live.clone().drive(part, turns).unwrap_err().to_string();
    assert_eq!(error(0, f64::NAN), "expected from -10 to 10 turns, found NaN");
    assert_eq!(error(0, 11.0), "expected from -10 to 10 turns, found 11");
    assert!(error(2, 0.5).starts_with("expected a part"), "{}", error(2, 0.5));
}
