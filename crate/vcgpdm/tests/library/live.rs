//! Live rollouts of the model that the page opens with, and moment matching compared with its sampled futures.

use crate::start_model;
use nalgebra::DMatrix;
use start_model::start_model;
use std::sync::Arc;
use vcgpdm_core::models::{Endless, Push, RolloutRequest};

#[test]
fn an_undisturbed_live_rollout_equals_the_rollout() {
    let owner = Arc::new(start_model());
    let model = owner.coupled().unwrap();
    let request = RolloutRequest { frames: 60, ..RolloutRequest::default() };
    let rollout = model.rollout(&request).unwrap();
    let expected = model.positions(&rollout).unwrap();
    let mut live = Endless::after(owner.clone(), &rollout, 19, 0).unwrap();
    let mut positions = Vec::new();
    let mut last = DMatrix::zeros(0, 0);
    for frames in [1, 4, 20, 15] {
        let next = live.advance(frames).unwrap();
        positions.extend(next.positions);
        last = next.latents[0].clone();
    }
    let begin = 20 * expected.len() / 60;
    assert_eq!(positions.len(), expected.len() - begin);
    // Too many frames are refused before memory is allocated.
    let error = live.clone().advance(1_000_000_000).unwrap_err().to_string();
    assert!(error.starts_with("expected from 1 to ") && error.ends_with("found 1000000000"), "{error}");
    for (a, b) in positions.iter().zip(&expected[begin..]) {
        assert!((a - b).abs() < 1e-4, "{a} {b}");
    }
    assert!((last.row(14) - rollout.latents[0].row(59)).amax() < 1e-9);
}

#[test]
fn a_rollout_starts_from_as_many_frames_as_a_clip_has() {
    let owner = start_model();
    let model = owner.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 12, ..RolloutRequest::default() }).unwrap();
    let clip = model.clip(&rollout, "short.bvh").unwrap();
    assert_eq!(model.latents_of_clip(&clip, 12).unwrap()[0].nrows(), 12);
    let error = model.latents_of_clip(&clip, 13).unwrap_err().to_string();
    assert!(
        error.starts_with("short.bvh: expected 13 frames or more to start from, found 12 frames"),
        "{error}"
    );
}

#[test]
fn a_pulled_node_moves_in_the_direction_of_the_pull() {
    let owner = Arc::new(start_model());
    let model = owner.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 40, ..RolloutRequest::default() }).unwrap();
    let live = Endless::after(owner.clone(), &rollout, 30, 0).unwrap();
    let figure = model.body.mapping.skeleton().figure();
    let joints = &model.body.mapping.skeleton().joints;
    let hand = figure.iter().position(|node| joints[node.joint].name.contains("Hand")).unwrap();
    let push = live.pull(hand, [0.0, 0.0, 0.05]).unwrap();
    let part = &model.body.layout.parts()[push.part];
    assert!(part.joints.contains(&figure[hand].joint));
    let place = |mut live: Endless| live.advance(1).unwrap().positions[3 * hand + 2];
    let (free, mut pulled) = (place(live.clone()), live);
    pulled.push(&push).unwrap();
    let moved = place(pulled) - free;
    assert!(moved > 0.005 && moved < 0.1, "{moved}");
    let error = Endless::after(owner.clone(), &rollout, 30, 0).unwrap().pull(999, [0.0; 3]).unwrap_err();
    assert!(error.to_string().starts_with("expected a node of the figure from 0 to "));
}

#[test]
fn parts_on_the_cycle_are_in_phase_and_a_push_moves_a_part_off_it() {
    let owner = Arc::new(start_model());
    let model = owner.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 250, ..RolloutRequest::default() }).unwrap();
    let mut live = Endless::after(owner.clone(), &rollout, 240, 0).unwrap();
    let settled = live.advance(10).unwrap().places;
    assert_eq!(settled.len(), 10 * 2);
    for both in settled.chunks_exact(2) {
        let apart = (both[0].phase - both[1].phase + 0.5).rem_euclid(1.0) - 0.5;
        assert!(apart.abs() < 0.05 && both[0].distance < 0.2 && both[1].distance < 0.2, "{both:?}");
    }
    live.push(&Push { part: 1, by: vec![1.0, 1.0, 0.0], ..Push::default() }).unwrap();
    let pushed = live.advance(1).unwrap().places;
    assert!(pushed[1].distance > 0.3, "{pushed:?}");
}

#[test]
fn a_driven_part_has_the_phase_that_it_is_given_and_the_other_follows() {
    let owner = Arc::new(start_model());
    let model = owner.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 250, ..RolloutRequest::default() }).unwrap();
    let mut live = Endless::after(owner.clone(), &rollout, 240, 0).unwrap();
    let begin = live.clone().advance(1).unwrap().places;
    let apart = |a: f64, b: f64| (a - b + 0.5).rem_euclid(1.0) - 0.5;
    // Held still, the lower body stays, and the arms cannot go on for long without it.
    let mut held = live.clone();
    held.drive(0, 0.0).unwrap();
    let still = held.advance(90).unwrap();
    let lower = &still.latents[0];
    assert!((lower.row(89) - lower.row(60)).amax() < 1e-6);
    // The body does not glide on while its legs stand still: the root is the first node.
    let nodes = still.positions.len() / 90;
    let root = |frame: usize| [0, 2].map(|axis| still.positions[frame * nodes + axis]);
    assert_eq!(root(89), root(0));
    // Its columns are the motion itself.
    let shape = |positions: &[f32]| (positions[3] - positions[0], positions[4] - positions[1]);
    let again = model.body.positions(&still.y).unwrap();
    assert!((shape(&again[89 * nodes..]).1 - shape(&still.positions[89 * nodes..]).1).abs() < 1e-5);
    // Half a turn in 20 frames, in one request or in several.
    live.drive(0, 0.5).unwrap();
    let driven = live.clone().advance(20).unwrap();
    let places: Vec<_> = driven.places.chunks_exact(2).map(|both| (both[0].phase, both[1].phase)).collect();
    let turned = apart(places[19].0, begin[0].phase);
    assert!((turned.abs() - 0.5).abs() < 0.06, "{turned}");
    assert!(places.windows(2).all(|pair| (apart(pair[1].0, pair[0].0) - 0.025).abs() < 0.02), "{places:?}");
    // A turn is as long a way, however long it takes.
    let way = |turns: f64, frames: usize| {
        let mut led = live.clone();
        led.rewind(0).unwrap();
        led.drive(0, turns).unwrap();
        let positions = led.advance(frames).unwrap().positions;
        (positions[positions.len() - nodes] - positions[0])
            .hypot(positions[positions.len() - nodes + 2] - positions[2])
    };
    assert!((way(1.0, 40) / way(1.0, 80) - 1.0).abs() < 0.05, "{} {}", way(1.0, 40), way(1.0, 80));
    // Back again: the arms are drawn along, so they are not where they would be by themselves.
    let mut back = live.clone();
    back.advance(20).unwrap();
    back.drive(0, -0.5).unwrap();
    let returned = back.advance(20).unwrap();
    assert!((returned.latents[0].row(19) - lower.row(89)).amax() < 0.2);
    back.release(0);
    let free = back.advance(120).unwrap().places;
    let last = &free[free.len() - 2..];
    assert!(apart(last[0].phase, last[1].phase).abs() < 0.1 && last[0].distance < 0.5, "{last:?}");

    live.clone().drive(0, 10.0).unwrap();
    let error = |part, turns| live.clone().drive(part, turns).unwrap_err().to_string();
    assert_eq!(error(0, f64::NAN), "expected from -10 to 10 turns, found NaN");
    assert_eq!(error(0, 11.0), "expected from -10 to 10 turns, found 11");
    assert!(error(2, 0.5).starts_with("expected a part"), "{}", error(2, 0.5));
}

#[test]
fn a_recording_moves_a_part_round_and_round_and_the_model_goes_on_when_it_is_released() {
    let owner = Arc::new(start_model());
    let model = owner.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 300, ..RolloutRequest::default() }).unwrap();
    // The model's own walk as a recording: its legs, 90 frames of it.
    let recorded = rollout.latents[0].rows(200, 90).into_owned();
    let mut live = Endless::after(owner.clone(), &rollout, 150, 0).unwrap();
    live.record(0, recorded.clone()).unwrap();
    let moved = live.advance(200).unwrap();
    let frames: Vec<usize> = moved.recorded.chunks_exact(2).map(|both| both[0].unwrap()).collect();
    assert!(moved.recorded.chunks_exact(2).all(|both| both[1].is_none()));
    assert!(frames.windows(2).filter(|pair| pair[1] != pair[0] + 1).count() >= 2, "{frames:?}");
    for (t, frame) in frames.iter().enumerate().skip(20) {
        assert!((moved.latents[0].row(t) - recorded.row(*frame)).amax() < 0.2, "{t}");
    }
    // The arms follow: they are in step with the recorded legs.
    let apart = |a: f64, b: f64| (a - b + 0.5).rem_euclid(1.0) - 0.5;
    for both in moved.places.chunks_exact(2).skip(60) {
        assert!(apart(both[0].phase, both[1].phase).abs() < 0.1, "{both:?}");
    }
    live.release(0);
    let free = live.advance(60).unwrap();
    assert!(free.recorded.iter().all(Option::is_none));
    let jump = (free.latents[0].row(0) - moved.latents[0].row(199)).amax();
    // The legs' loop has a radius of about 2, so a step is about 0.4.
    assert!(jump < 0.8, "{jump}");
    assert!(free.places.iter().all(|place| place.distance < 0.3), "{:?}", free.places);

    let error = |part, rows, value| {
        let latents = DMatrix::from_element(rows, 3, value);
        live.clone().record(part, latents).unwrap_err().to_string()
    };
    let expected = "expected latents of a recording for part 1: 4 or more x 3 finite numbers, found ";
    assert_eq!(error(1, 3, 0.0), format!("{expected}3 x 3"));
    assert_eq!(error(1, 90, f64::NAN), format!("{expected}NaN"));
    assert_eq!(error(2, 90, 0.0), "expected a part from 0 to 1, found 2");
}

/// The horizontal axis of the pelvis, and the place of a node relative to the root, in each of the frames
/// [frames x nodes x 3].
fn places(positions: &[f32], nodes: usize, node: usize, hips: [usize; 2]) -> Vec<([f64; 2], [f64; 3])> {
    let at = |frame: &[f32], node: usize, axis: usize| f64::from(frame[3 * node + axis]);
    let place = |frame: &[f32]| {
        let [x, z] = [0, 2].map(|axis| at(frame, hips[1], axis) - at(frame, hips[0], axis));
        let length = (x * x + z * z).sqrt();
        let place = std::array::from_fn(|axis| at(frame, node, axis) - at(frame, 0, axis));
        ([x / length, z / length], place)
    };
    positions.chunks_exact(3 * nodes).map(place).collect()
}

/// A place turned from one axis of the pelvis to another.
fn turned([x, y, z]: [f64; 3], from: [f64; 2], to: [f64; 2]) -> [f64; 3] {
    let (cosine, sine) = (from[0] * to[0] + from[1] * to[1], from[0] * to[1] - from[1] * to[0]);
    [cosine * x - sine * z, y, sine * x + cosine * z]
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn a_dragged_node_reaches_its_place_and_distant_places_leave_the_pose_plausible() {
    let owner = Arc::new(start_model());
    let model = owner.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 300, ..RolloutRequest::default() }).unwrap();
    let skeleton = model.body.mapping.skeleton();
    let figure = skeleton.figure();
    let of = |name: &str| {
        figure.iter().position(|node| !node.end_site && skeleton.joints[node.joint].name == name).unwrap()
    };
    let mut free = Endless::after(owner.clone(), &rollout, 150, 0).unwrap();
    let free = free.advance(40).unwrap().positions;
    let hips = [of("LeftUpLeg"), of("RightUpLeg")];
    let all = model.positions(&rollout).unwrap();
    let seen = |positions: &[f32], node| places(positions, figure.len(), node, hips);
    let (now, _) = seen(&all, 0)[150];
    let held = |node: usize, place: [f64; 3], frames: usize| {
        let mut live = Endless::after(owner.clone(), &rollout, 150, 0).unwrap();
        live.reach(node, place).unwrap();
        let next = live.advance(frames).unwrap();
        assert!(next.latents.iter().flat_map(|x| x.iter()).all(|x| x.is_finite()));
        (live, next)
    };
    let (mut reached, mut strange) = (0, 1.0_f64);
    for name in ["RightHand", "LeftHand", "RightFoot", "LeftFoot"] {
        let node = of(name);
        // The places of the node in a step can be reached, and the node stays within 5 cm of them although the
        // other part walks on.
        for (axis, place) in seen(&free, node).into_iter().step_by(5) {
            let (_, next) = held(node, turned(place, axis, now), 60);
            let stays = seen(&next.positions, node)[20..]
                .iter()
                .all(|(to, found)| distance(found, &turned(place, axis, *to)) < 0.05);
            reached += usize::from(stays);
        }
        for far in [[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-1.0, 0.5, 4.0], [1e9, 0.0, 0.0]] {
            let (mut live, next) = held(node, far, 90);
            let share = model.model.familiarity(&next.latents).unwrap();
            let least = share.iter().flatten().copied().fold(1.0, f64::min);
            strange = strange.min(least);
            // The model takes over and walks on.
            live.release(0);
            live.release(1);
            let home = live.advance(150).unwrap().places;
            assert!(
                home[298..].iter().all(|place| place.distance < 0.1),
                "{name} {far:?} {:?}",
                &home[298..]
            );
        }
    }
    // Between the foot and two of the 32 places lie poses from which every small step leads away.
    assert!(reached >= 30, "{reached}");
    assert!(strange > 0.95, "{strange}");

    let mut live = Endless::after(owner.clone(), &rollout, 150, 0).unwrap();
    let error = live.reach(0, [0.0, f64::NAN, 0.0]).unwrap_err().to_string();
    assert_eq!(error, "expected a place of three finite numbers, found NaN");
    assert!(live.reach(999, [0.0; 3]).unwrap_err().to_string().starts_with("expected a node"));
}

#[test]
fn frames_that_are_taken_back_obey_later_changes_and_keep_earlier_turns() {
    let owner = Arc::new(start_model());
    let model = owner.coupled().unwrap();
    let rollout = model.rollout(&RolloutRequest { frames: 60, ..RolloutRequest::default() }).unwrap();
    let mut live = Endless::after(owner.clone(), &rollout, 40, 0).unwrap();
    assert!(live.rewind(1).is_err(), "no frame was computed");
    live.advance(2).unwrap();
    let begin = live.clone();
    live.drive(0, 0.25).unwrap();
    let whole = live.clone().advance(2).unwrap();
    // The second half of the turn is left when the second frame is taken back.
    live.advance(2).unwrap();
    live.rewind(1).unwrap();
    let again = live.advance(1).unwrap();
    assert!((again.latents[0].row(0) - whole.latents[0].row(1)).amax() < 1e-12);
    // The turn itself is taken back with both frames, and so is a recording.
    live.rewind(2).unwrap();
    let free = live.advance(1).unwrap();
    assert_eq!(free.latents, begin.clone().advance(1).unwrap().latents);
    live.record(0, rollout.latents[0].clone()).unwrap();
    let recorded = live.advance(3).unwrap();
    live.rewind(1).unwrap();
    let again = live.advance(1).unwrap();
    assert_eq!(again.recorded[..], recorded.recorded[4..]);
    assert!((again.latents[0].row(0) - recorded.latents[0].row(2)).amax() < 1e-12);
    live.rewind(1).unwrap();
    live.rewind(2).unwrap();
    assert_eq!(live.advance(1).unwrap().recorded, [None, None]);
}

#[test]
fn moments_agree_with_those_of_sampled_futures_for_the_first_frames() {
    let model = start_model();
    let model = model.coupled().unwrap();
    let request = RolloutRequest { frames: 60, ..RolloutRequest::default() };
    let dynamics = model.predictive_dynamics(&request).unwrap();
    let start = &model.model.start(0, 0).unwrap();
    let moments = dynamics.moments(start, 60).unwrap();
    let draws = 1000;
    let futures: Vec<_> = (0..draws).map(|seed| dynamics.sample(start, 60, seed).unwrap()).collect();
    let count = draws as f64;
    for (part, means) in moments.means.iter().enumerate() {
        for t in 2..60 {
            for q in 0..means.ncols() {
                let values: Vec<f64> = futures.iter().map(|future| future[part][(t, q)]).collect();
                let mean = values.iter().sum::<f64>() / count;
                let variance = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (count - 1.0);
                let (matched_mean, matched_variance) = (means[(t, q)], moments.covariances[part][t][(q, q)]);
                let (shift, ratio) = (
                    (mean - matched_mean).abs() / matched_variance.sqrt(),
                    (variance / matched_variance).sqrt(),
                );
                let found = format!("part {part}, frame {t}, dimension {q}: {shift}, {ratio}");
                // Moment matching is exact for two frames: the tolerance is four standard errors.
                if t < 4 {
                    assert!(shift < 4.0 / count.sqrt(), "{found}");
                    assert!((ratio * ratio - 1.0).abs() < 4.0 * (2.0 / count).sqrt(), "{found}");
                }
                // Later the futures differ in phase along a curved cycle, which a Gaussian describes less and
                // less well: docs/uncertainty.md.
                if t < 15 {
                    assert!(shift < 0.25 && (0.8..1.25).contains(&ratio), "{found}");
                }
                assert!(matched_mean.is_finite() && matched_variance > 0.0, "{found}");
            }
        }
    }
}
