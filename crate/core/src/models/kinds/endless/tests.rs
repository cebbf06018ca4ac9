//! Motions without an end that are taken back, driven and held.

use super::*;
use crate::models::data::dataset::Dataset;
use crate::models::rollout::request::RolloutRequest;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::Vcgpdm;
use crate::motion::{parts, samples};

/// A walk of two parts, after its first two frames.
fn walk(iterations: usize) -> Endless {
    let clip = samples::clip("walk-1").unwrap();
    let parts = &parts::presets(&clip.skeleton)[1].parts;
    let dataset = Dataset::new(&[(&clip).into()], parts, 30.0).unwrap();
    let settings = VariationalSettings::default().with_points(8, 8).with_max_iterations(iterations);
    let model = Vcgpdm::fit(&dataset, &settings, 0).unwrap();
    let request = RolloutRequest { frames: 2, ..RolloutRequest::default() };
    let rollout = model.coupled().unwrap().rollout(&request).unwrap();
    Endless::after(Arc::new(model), &rollout, 1, 0).unwrap()
}

#[test]
fn the_last_frames_of_one_long_advance_can_be_taken_back() {
    let mut walk = walk(1);
    let whole = walk.advance(REWINDS + 30).unwrap();
    walk.rewind(REWINDS).unwrap();
    let again = walk.advance(REWINDS).unwrap();
    assert_eq!(again.y, whole.y.rows(30, REWINDS));
}

#[test]
fn two_parts_that_are_driven_at_once_both_stand_still() {
    let mut walk = walk(50);
    let stands = |walk: &mut Endless| {
        let latents = walk.advance(60).unwrap().latents;
        [0, 1].map(|part| (latents[part].row(59) - latents[part].row(45)).amax() < 1e-3)
    };
    assert_eq!(stands(&mut walk), [false; 2]);
    walk.drive(0, 0.0).unwrap();
    walk.drive(1, 0.0).unwrap();
    assert_eq!(stands(&mut walk), [true; 2]);
    // One of them turns on, and the other one does not.
    walk.drive(0, 0.5).unwrap();
    let turned = walk.advance(60).unwrap().latents;
    assert!((turned[0].row(59) - turned[0].row(0)).amax() > 0.1);
    assert!((turned[1].row(59) - turned[1].row(0)).amax() < 1e-3);
}

#[test]
fn two_nodes_that_are_held_at_once_both_stay_at_their_places() {
    let mut walk = walk(50);
    let owner = Arc::clone(&walk.now.course.model);
    let model = coupled(&owner).unwrap();
    let nodes = [0, 1].map(|part| (0..99).rfind(|node| part_of(model, *node) == Ok(part)).unwrap());
    // In the directions of the figure.
    let places = |walk: &Endless| {
        let positions = model.body.positions(&walk.now.columns(model)).unwrap();
        let at = |node: usize| Vector3::from_fn(|axis, _| f64::from(positions[3 * node + axis]));
        nodes.map(|node| at(node) - at(0))
    };
    let frame = walk.advance(1).unwrap().positions;
    let begin = places(&walk);
    let mut free = walk.clone();
    for node in nodes {
        let place = [0, 1, 2].map(|axis| f64::from(frame[3 * node + axis] - frame[axis]));
        walk.reach(node, place).unwrap();
    }
    free.advance(15).unwrap();
    walk.advance(15).unwrap();
    let far = |walk: &Endless| [0, 1].map(|k| (places(walk)[k] - begin[k]).norm());
    let (free, held) = (far(&free), far(&walk));
    assert!((0..2).all(|k| free[k] > 0.1 && held[k] < 0.03), "{free:?} {held:?}");
}
