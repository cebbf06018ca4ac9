//! Measures of computed motions, whose correct values are known.

use super::*;
use crate::motion::samples;
use crate::motion::skeleton::{Channel, Joint};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};

const FRAME_TIME: f64 = 1.0 / 30.0;

/// Hips, two legs of two joints and two arms of two joints; the figure has no more nodes than that.
fn skeleton() -> Skeleton {
    let joint = |name: &str, parent, offset| Joint {
        name: name.to_owned(),
        parent,
        offset,
        channels: Channel::ALL.to_vec(),
        end_sites: Vec::new(),
    };
    Skeleton {
        joints: vec![
            joint("Hips", None, [0.0, 1.0, 0.0]),
            joint("LeftUpLeg", Some(0), [0.1, 0.0, 0.0]),
            joint("LeftFoot", Some(1), [0.0, -1.0, 0.0]),
            joint("RightUpLeg", Some(0), [-0.1, 0.0, 0.0]),
            joint("RightFoot", Some(3), [0.0, -1.0, 0.0]),
            joint("LeftArm", Some(0), [0.2, 0.5, 0.0]),
            joint("LeftHand", Some(5), [0.0, -0.5, 0.0]),
            joint("RightArm", Some(0), [-0.2, 0.5, 0.0]),
            joint("RightHand", Some(7), [0.0, -0.5, 0.0]),
        ],
    }
}

/// A walking body: amplitudes in metres and periods in seconds of hands and feet, the heading in radians from
/// z about y, the speed in metres a second.
#[derive(Clone, Copy)]
struct Made {
    hands: (f64, f64),
    feet: (f64, f64),
    heading: f64,
    speed: f64,
    seconds: f64,
}

const WALK: Made = Made { hands: (0.15, 1.1), feet: (0.25, 1.1), heading: 0.0, speed: 1.4, seconds: 15.0 };

impl Made {
    fn positions(self) -> Vec<f32> {
        let forward = Vector3::new(self.heading.sin(), 0.0, self.heading.cos());
        let left = Vector3::new(self.heading.cos(), 0.0, -self.heading.sin());
        let frames = (self.seconds / FRAME_TIME).round() as usize;
        let rest = skeleton().rest_pose().positions;
        let places = (0..frames).flat_map(|frame| {
            let seconds = frame as f64 * FRAME_TIME;
            let swing = move |(amplitude, period): (f64, f64), start: f64| {
                amplitude * (TAU * seconds / period + start).sin() * forward
            };
            let walked = self.speed * seconds * forward;
            let rest = rest.clone();
            rest.into_iter().enumerate().map(move |(node, at)| {
                let moved = match node {
                    2 => swing(self.feet, PI),
                    4 => swing(self.feet, 0.0),
                    6 => swing(self.hands, 0.0),
                    8 => swing(self.hands, PI),
                    _ => Vector3::zeros(),
                };
                at.x * left + at.y * Vector3::y() + moved + walked
            })
        });
        places.flat_map(|place| [place.x as f32, place.y as f32, place.z as f32]).collect()
    }

    fn measures(self) -> Measures {
        measures(&skeleton(), &self.positions(), FRAME_TIME)
    }
}

fn near(found: f64, expected: f64, tolerance: f64) -> bool {
    (found - expected).abs() < tolerance
}

#[test]
fn hands_and_feet_of_a_walk_swing_in_step_whatever_the_heading() {
    for heading in [0.0, 1.0, -2.5] {
        let found = Made { heading, ..WALK }.measures();
        assert!(near(found.walking_speed, 1.4, 1e-3), "{found:?}");
        let names = [Limb::LeftHand, Limb::RightHand, Limb::LeftFoot, Limb::RightFoot];
        let joints = [6, 8, 2, 4];
        assert_eq!(found.limbs.len(), 4);
        for (limb, (name, joint)) in found.limbs.iter().zip(names.into_iter().zip(joints)) {
            let amplitude = if name.is_hand() { 0.15 } else { 0.25 };
            assert_eq!((limb.limb, limb.joint), (name, joint));
            assert!(near(limb.swing, amplitude / 2.0_f64.sqrt(), 2e-3), "{limb:?}");
            assert!(near(limb.period.unwrap(), 1.1, 0.02), "{limb:?}");
            assert!(limb.locking.unwrap() > 0.999 && near(limb.ahead.unwrap(), 0.0, 0.01), "{limb:?}");
        }
    }
}

#[test]
fn hands_with_another_period_than_the_feet_are_not_in_step() {
    let found = Made { hands: (0.15, 1.45), ..WALK }.measures();
    for limb in &found.limbs {
        assert!(limb.locking.unwrap() < 0.2, "{limb:?}");
        let period = if limb.limb.is_hand() { 1.45 } else { 1.1 };
        assert!(near(limb.period.unwrap(), period, 0.02), "{limb:?}");
    }
}

#[test]
fn a_swing_of_less_than_three_periods_has_no_period() {
    // An arm of a walk in five parts lost its leg, and the page gave it a period of five steps.
    for (period, expected) in [(4.9, true), (5.2, false)] {
        let found = Made { hands: (0.15, period), ..WALK }.measures();
        assert_eq!(found.limbs[0].period.is_some(), expected, "{found:?}");
    }
}

#[test]
fn hands_that_hang_have_no_phase() {
    let found = Made { hands: (0.01, 1.1), ..WALK }.measures();
    assert!(near(found.limbs[0].swing, 0.01 / 2.0_f64.sqrt(), 1e-4), "{found:?}");
    assert!(found.limbs.iter().all(|limb| limb.locking.is_none() && limb.ahead.is_none()), "{found:?}");
    assert_eq!((found.limbs[0].period, found.limbs[2].period.is_some()), (None, true));
}

#[test]
fn joints_move_as_fast_as_they_swing() {
    // A sine of amplitude A goes 4 A in a period. Four of the eight nodes other than the root move.
    let found = WALK.measures();
    let expected = (2.0 * 4.0 * 0.15 + 2.0 * 4.0 * 0.25) / 1.1 / 8.0;
    assert!(near(found.joint_speed, expected, 0.01 * expected), "{found:?} {expected}");
}

#[test]
fn feet_that_are_carried_along_slide_at_walking_speed() {
    let gliding = Made { feet: (0.0, 1.1), ..WALK }.measures();
    assert!(near(gliding.foot_slide.unwrap(), 1.0, 1e-3), "{gliding:?}");
    assert_eq!(Made { speed: 0.0, ..WALK }.measures().foot_slide, None);
    // A recorded walk has a foot on the ground.
    let clip = samples::clip("walk-1").unwrap();
    let walk = measures(&clip.skeleton, &clip.stage_positions(), clip.frame_time);
    assert!(walk.foot_slide.unwrap() < 0.2, "{walk:?}");
    assert!((0.8..2.0).contains(&walk.walking_speed), "{walk:?}");
}

#[test]
fn a_recorded_body_that_glides_in_one_pose_rests() {
    let moves = Made { seconds: 3.0, ..WALK }.positions();
    let width = 3 * skeleton().joints.len();
    let last = moves[moves.len() - width..].to_vec();
    // It continues in the last pose.
    let glide = |frames: usize| {
        let steps = (1..=frames).flat_map(|frame| {
            let way = (WALK.speed * FRAME_TIME * frame as f64) as f32;
            last.iter().enumerate().map(move |(k, place)| if k % 3 == 2 { place + way } else { *place })
        });
        [moves.clone(), steps.collect()].concat()
    };
    let from = |positions: &[f32]| rests_from(&skeleton(), positions, FRAME_TIME);
    assert_eq!(from(&moves), None);
    assert_eq!(from(&glide(5)), None, "the body must rest for a quarter of a second");
    assert!(near(from(&glide(60)).unwrap(), 3.0 - FRAME_TIME, 0.5 * FRAME_TIME), "{:?}", from(&glide(60)));
}

#[test]
fn measures_of_a_part_are_the_means_over_its_limbs() {
    let found = Made { hands: (0.15, 1.45), ..WALK }.measures();
    let upper = found.part(&[5, 6, 7, 8]);
    assert!(near(upper.swing.unwrap(), 0.15 / 2.0_f64.sqrt(), 5e-3), "{upper:?}");
    assert!(upper.locking.unwrap() < 0.2, "{upper:?}");
    assert_eq!(found.part(&[0]), PartMeasures { swing: None, period: None, locking: None });
}

#[test]
fn few_frames_and_bodies_without_limbs_have_few_measures() {
    let bone = Skeleton { joints: skeleton().joints[..1].to_vec() };
    let found = measures(&bone, &[0.0, 1.0, 0.0, 0.0, 1.0, 0.1], FRAME_TIME);
    assert_eq!((found.limbs.len(), found.foot_slide), (0, None));
    let found = measures(&skeleton(), &WALK.positions()[..27], FRAME_TIME);
    assert_eq!((found.joint_speed, found.walking_speed), (0.0, 0.0));
    assert!(found.limbs.iter().all(|limb| limb.swing == 0.0 && limb.locking.is_none()));
}
