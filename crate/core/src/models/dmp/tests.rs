//! Reproduction of movements, other goals, other speeds, stable cycles.

use super::*;
use crate::models::Learner;
use crate::models::data::movements::{Movements, Sequence};
use crate::models::data::phase::Trial;
use crate::models::rollout::request::{Handles, PosePush};
use crate::models::training::interface::Training;
use crate::models::training::kind::ModelKind;
use crate::models::training::settings::DmpSettings;
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// Two columns that go a clear way, and a third that returns to its start.
fn reach(frames: usize) -> DMatrix<f64> {
    DMatrix::from_fn(frames, 3, |t, k| {
        let s = t as f64 / (frames - 1) as f64;
        let minimum_jerk = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
        match k {
            0 => 0.3 + 1.2 * minimum_jerk + 0.4 * (TAU * s).sin() * s * (1.0 - s),
            1 => 1.0 - 2.0 * minimum_jerk,
            _ => 0.5 * (std::f64::consts::PI * minimum_jerk).sin(),
        }
    })
}

fn walk(frames: usize, period: f64, start: f64) -> DMatrix<f64> {
    DMatrix::from_fn(frames, 3, |t, d| {
        let phase = TAU * (t as f64 / period + start);
        0.2 + (phase + d as f64).sin() + 0.3 * (2.0 * phase + 0.5 * d as f64).cos()
    })
}

fn whole(y: DMatrix<f64>) -> Trial {
    Trial { y, whole: true }
}

fn root_mean_square(a: &DMatrix<f64>) -> f64 {
    (a.norm_squared() / a.len() as f64).sqrt()
}

#[test]
fn more_bases_reproduce_a_movement_better() {
    let trials = [whole(reach(90))];
    let error = |bases| {
        let model = Dmp::discrete(&trials, &[3], bases).unwrap();
        let Canonical::Discrete { scaled, .. } = &model.canonical else { panic!("no goal") };
        assert_eq!(*scaled, [true, true, false]);
        root_mean_square(&(model.path(0, 90, &Handles::default()).unwrap() - &trials[0].y))
    };
    let (few, some, many) = (error(3), error(12), error(40));
    assert!(few > some && some > many, "{few} {some} {many}");
    // The movements have sizes from 1 to 2.
    assert!(many < 0.005, "{many}");

    let trials = [whole(walk(110, 34.0, 0.1))];
    let error = |bases| {
        let model = Dmp::rhythmic(&trials, &[3], bases).unwrap();
        root_mean_square(&(model.path(0, 110, &Handles::default()).unwrap() - &trials[0].y))
    };
    let (few, many) = (error(3), error(25));
    assert!(few > many && many < 0.02, "{few} {many}");
}

#[test]
fn another_goal_is_reached_and_scales_the_movement() {
    let trials = [whole(reach(90)), whole(reach(80))];
    let model = Dmp::discrete(&trials, &[2, 1], 30).unwrap();
    let (plain, learned) = (model.path(0, 160, &Handles::default()).unwrap(), &model.goal);
    let goal = learned + nalgebra::dvector![1.0, -0.5, 0.7];
    let handles = Handles { goal: Some(vec![1.0, -0.5, 0.7]), ..Handles::default() };
    let moved = model.path(0, 160, &handles).unwrap();
    let last = moved.row(159).transpose();
    assert!((&last - &goal).amax() < 1e-3, "{last} {goal}");
    // A scaled column keeps its shape: (y - y0) / (g - y0) is the same, but for the initial velocity.
    let way = (goal[0] - moved[(0, 0)]) / (learned[0] - plain[(0, 0)]);
    for t in 0..160 {
        let expected = plain[(0, 0)] + way * (plain[(t, 0)] - plain[(0, 0)]);
        assert!((moved[(t, 0)] - expected).abs() < 0.02, "{t}");
    }
    // Another start of a scaled column changes the way, too.
    let start = PosePush { frame: 0, by: vec![0.4, 0.0, 0.0] };
    let moved = model.path(0, 160, &Handles { push: Some(start), ..Handles::default() }).unwrap();
    assert!((moved[(0, 0)] - plain[(0, 0)] - 0.4).abs() < 1e-12);
    let way = (learned[0] - moved[(0, 0)]) / (learned[0] - plain[(0, 0)]);
    assert!((moved[(45, 0)] - learned[0] - way * (plain[(45, 0)] - learned[0])).abs() < 0.02);
    let opposite = Dmp::discrete(&[whole(reach(90)), whole(-reach(90))], &[3], 3).unwrap();
    let Canonical::Discrete { scaled, .. } = opposite.canonical else { panic!("no goal") };
    assert_eq!(scaled, [false; 3], "trials go opposite ways");
    // The column that returns stays small, although its goal is its start.
    assert!(plain.column(2).amax() < 0.6, "{}", plain.column(2));
}

#[test]
fn half_the_rate_takes_twice_as_long() {
    let discrete = Dmp::discrete(&[whole(reach(100).rows(10, 90).into_owned())], &[3], 25).unwrap();
    let rhythmic = Dmp::rhythmic(&[whole(walk(110, 34.0, 0.1))], &[3], 25).unwrap();
    let fast = [
        discrete.path(0, 60, &Handles::default()).unwrap(),
        rhythmic.path(0, 60, &Handles::default()).unwrap(),
    ];
    let half = Handles { tempo: 0.5, ..Handles::default() };
    let slow = [discrete.path(0, 119, &half).unwrap(), rhythmic.path(0, 119, &half).unwrap()];
    for (fast, slow) in fast.iter().zip(&slow) {
        for t in 0..60 {
            let (a, b) = (fast.row(t), slow.row(2 * t));
            assert!((a - b).amax() < 1e-3, "{t}: {a} {b}");
        }
    }
}

#[test]
fn the_limit_cycle_is_stable() {
    let trials = [
        whole(walk(110, 34.0, 0.1)),
        whole(walk(97, 34.0, 0.7)),
        Trial { y: walk(5, 34.0, 0.4), whole: false },
    ];
    let mut model = Dmp::rhythmic(&trials, &[3], 25).unwrap();
    let y = model.path(2, 1000, &Handles::default()).unwrap();
    let difference = &y - walk(1000, 34.0, 0.4);
    assert!(root_mean_square(&difference.rows(0, 100).into_owned()) < 0.08, "{difference}");
    assert!((y.rows(34, 34) - y.rows(34 * 20, 34)).amax() < 0.3);
    let found = crate::motion::period(&[y.rows(500, 500).into_owned()]).unwrap();
    assert!((found.frames - 34.0).abs() < 0.2, "{found:?}");

    // Five frames of a movement three times as large are no reason to move more than twice as far.
    let large = Trial { y: walk(5, 34.0, 0.4) * 3.0, whole: false };
    let large = Dmp::rhythmic(&[trials[0].clone(), trials[1].clone(), large], &[3], 25).unwrap();
    assert_eq!(large.starts[2].amplitude, 2.0);

    // A rollout that is pushed away from the cycle returns to it. Twice the amplitude doubles the movement
    // around the same centre.
    for frame in [0, 20] {
        let push = Some(PosePush { frame, by: vec![3.0; 3] });
        let pushed = model.path(2, 200, &Handles { push, ..Handles::default() }).unwrap();
        let off = pushed - y.rows(0, 200);
        assert!(frame == 0 || off.rows(0, frame).amax() == 0.0);
        assert!(off.row(frame).add_scalar(-3.0).amax() < 1e-9 && off.rows(frame + 34, 100).amax() < 1e-6);
    }
    model.starts[2].amplitude *= 2.0;
    let larger = model.path(2, 200, &Handles::default()).unwrap();
    for t in 34..134 {
        let expected = 2.0 * (y.row(t).transpose() - &model.goal) + &model.goal;
        assert!((larger.row(t).transpose() - expected).amax() < 1e-6);
    }
}

#[test]
fn a_learner_needs_one_step_and_refuses_0_bases() {
    let y =
        vec![walk(60, 20.0, 0.0).columns(0, 2).into_owned(), walk(60, 20.0, 0.0).columns(2, 1).into_owned()];
    let movements = Movements {
        y,
        sequences: vec![Sequence { frames: 55, whole: true }, Sequence { frames: 5, whole: false }],
    };
    let [discrete, rhythmic]: [learner::Fit; 2] = [Dmp::discrete, Dmp::rhythmic];
    for (fit, kind, numbers) in [
        (discrete, ModelKind::DmpDiscrete, 10 * 3 + 4 * 3 + 3),
        (rhythmic, ModelKind::DmpRhythmic, 10 * 3 + 3 * 3 + 4),
    ] {
        let mut learner = DmpLearner::new(&movements, fit, &DmpSettings { bases: 10 }).unwrap();
        let progress = learner.step();
        assert!(progress.done && progress.best.is_finite() && progress.best <= 0.0, "{progress:?}");
        let model = learner.model().unwrap();
        assert_eq!((model.kind(), model.stored_numbers(), model.bound()), (kind, numbers, None));
        let y = model.rollout(1, 80).unwrap();
        assert_eq!((y[0].shape(), y[1].shape()), ((80, 2), (80, 1)));
        assert!(y[0].iter().all(|v| v.is_finite()));
        assert!(model.rollout(2, 80).is_err() && model.rollout(0, 0).is_err());
    }
    let none = DmpLearner::new(&movements, rhythmic, &DmpSettings { bases: 0 });
    assert_eq!(none.err().unwrap().to_string(), "the number of bases must be from 1 to 200, found 0");
    // A still movement stays where it is.
    let still =
        Movements { y: vec![DMatrix::zeros(20, 2)], sequences: vec![Sequence { frames: 20, whole: true }] };
    for fit in [discrete, rhythmic] {
        for bases in [1, 30] {
            let learner = DmpLearner::new(&still, fit, &DmpSettings { bases }).unwrap();
            let model = learner.model().unwrap();
            assert!(model.rollout(0, 30).unwrap()[0].amax() < 1e-9);
        }
    }
    let frames = |frames: usize, whole: bool| Trial { y: DMatrix::zeros(frames, 2), whole };
    let model = Dmp::rhythmic(&[frames(20, true), frames(5, false)], &[2], 8).unwrap();
    assert!(model.starts.iter().all(|start| start.amplitude == 1.0 && start.map.start == 0.0), "{model:?}");
}
