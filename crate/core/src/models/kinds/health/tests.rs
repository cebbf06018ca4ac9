//! The health of rollouts of small models.

use super::*;
use crate::models::data::dataset::Dataset;
use crate::models::kinds::model::Model;
use crate::models::kinds::trainer::Trainer;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::KeptPoints;
use crate::motion::{parts, samples};

/// A model, and a rollout that repeats the clip as the model makes it, with latents at inducing points.
pub(in crate::models::kinds) fn walk() -> (Model, Rollout) {
    let clip = samples::clip("walk-1").unwrap();
    let parts = &parts::presets(&clip.skeleton)[1].parts;
    let dataset = Dataset::new(&[(&clip).into()], parts, 30.0).unwrap();
    let settings = VariationalSettings::default().with_latent(2).with_points(4, 4).with_order(2);
    let settings = settings.with_max_iterations(1);
    let trainer = Trainer::new(&dataset, &settings.into(), 1).unwrap();
    let model = trainer.finish().unwrap();
    let fitted = model.coupled().unwrap().model;
    let y = model.body.columns(&fitted.observations(&fitted.starts[0]));
    let latents = fitted.parts.iter().map(|part| {
        let r = part.r();
        DMatrix::from_fn(y.nrows(), r.ncols(), |t, q| r[(t % r.nrows(), q)])
    });
    let rollout = Rollout { latents: latents.collect(), y, weights: DMatrix::from_element(2, 2, 0.5) };
    (model, rollout)
}

/// Keeps the columns of these parts as they are in frame 60, from then on.
fn freeze(model: &Model, rollout: &mut Rollout, parts: &[usize]) {
    for &column in parts.iter().flat_map(|part| model.body.layout.columns(*part)) {
        let value = rollout.y[(60, column)];
        rollout.y.column_mut(column).rows_range_mut(60..).fill(value);
    }
}

/// Neither steps nor turns from frame 60 on.
fn stop(rollout: &mut Rollout) {
    rollout.y.columns_mut(0, TRAVEL_COLUMNS).rows_range_mut(60..).fill(0.0);
}

fn health(model: &Model, rollout: &Rollout) -> Health {
    let model = model.coupled().unwrap();
    model.health(rollout, &RolloutRequest::default(), &model.positions(rollout).unwrap()).unwrap()
}

#[test]
fn a_walk_moves_on_and_visits_all_poses_of_its_clip() {
    let (model, rollout) = walk();
    let found = health(&model, &rollout);
    assert_eq!((found.state, found.from, found.rank), (Ending::MovesOn, None, 3));
    assert!(found.parts.iter().all(|part| part.visited == Some(1.0) && part.still_from.is_none()));
}

#[test]
fn a_frozen_walk_stands_still_or_glides_in_one_pose() {
    let (model, mut rollout) = walk();
    freeze(&model, &mut rollout, &[0, 1]);
    let glides = health(&model, &rollout);
    assert_eq!((glides.state, glides.rank), (Ending::KeepsOnePose, 1), "{glides:?}");
    rollout.y.columns_mut(1, 2).rows_range_mut(60..).neg_mut();
    assert_eq!(health(&model, &rollout).state, Ending::KeepsOnePose, "glides back");
    stop(&mut rollout);
    let found = health(&model, &rollout);
    assert_eq!((found.state, found.from), (Ending::StandsStill, glides.from), "{found:?}");
    assert!((found.from.unwrap() - 2.0).abs() < 0.1, "{found:?}");
    assert!(found.parts.iter().all(|part| (part.still_from.unwrap() - 2.0).abs() < 0.1), "{found:?}");
}

#[test]
fn a_body_is_still_although_one_fingertip_moves() {
    let (model, mut rollout) = walk();
    freeze(&model, &mut rollout, &[0, 1]);
    stop(&mut rollout);
    // The last joint of the arm turns by 0.2 radians and back, twice a second.
    let column = rollout.y.ncols() - 1;
    for t in 60..rollout.y.nrows() {
        rollout.y[(t, column)] += if t % 15 < 7 { 0.2 } else { 0.0 };
    }
    assert_eq!(health(&model, &rollout).state, Ending::StandsStill);
}

#[test]
fn a_walk_whose_arm_turns_back_in_every_frame_shakes() {
    let (model, mut rollout) = walk();
    // The last joint of the arm turns by 0.5 radians and back in every frame of one half.
    let (calm, column, middle) = (rollout.y.clone(), rollout.y.ncols() - 1, rollout.y.nrows() / 2);
    for half in [0..middle, middle..2 * middle] {
        rollout.y.copy_from(&calm);
        half.step_by(2).for_each(|t| rollout.y[(t, column)] += 0.5);
        let found = health(&model, &rollout);
        assert_eq!((found.state, found.part, found.rank), (Ending::Shakes, Some(1), 0), "{found:?}");
        let [lower, upper] = found.parts[..] else { panic!("two parts") };
        assert!(!lower.pace.shakes() && upper.pace.turns_back > 0.5, "{found:?}");
    }
}

#[test]
fn a_walk_at_three_times_its_speed_shakes_and_at_one_and_a_half_does_not() {
    let (model, rollout) = walk();
    for (share, shakes) in [(1.5, false), (3.0, true)] {
        let frames = (rollout.y.nrows() as f64 / share) as usize;
        let y =
            DMatrix::from_fn(frames, rollout.y.ncols(), |t, d| rollout.y[((t as f64 * share) as usize, d)]);
        let rows = |x: &DMatrix<f64>| x.rows(0, frames).into_owned();
        let fast = Rollout { latents: rollout.latents.iter().map(rows).collect(), y, ..rollout.clone() };
        let found = health(&model, &fast);
        assert_eq!(found.state == Ending::Shakes, shakes, "{found:?}");
    }
}

#[test]
fn a_walk_with_frozen_arms_visits_few_poses_of_the_arms() {
    let (model, mut rollout) = walk();
    freeze(&model, &mut rollout, &[1]);
    let found = health(&model, &rollout);
    assert_eq!((found.state, found.part, found.rank), (Ending::VisitsFewPoses, Some(1), 2), "{found:?}");
    let [lower, upper] = found.parts[..] else { panic!("two parts") };
    assert!(lower.still_from.is_none() && (upper.still_from.unwrap() - 2.0).abs() < 0.1, "{found:?}");
    assert!(lower.visited > Some(0.9) && upper.visited < Some(FEW), "{found:?}");
    assert!(found.is_no_worse_than(&found), "{found:?}");
}

#[test]
fn files_of_earlier_versions_have_too_few_frames_for_a_share_of_poses() {
    let (model, mut rollout) = walk();
    let mut fitted = model.coupled().unwrap().model.clone();
    for start in fitted.starts.iter_mut().flatten() {
        *start = start.rows(0, 2).into_owned();
    }
    freeze(&model, &mut rollout, &[1]);
    let earlier = Coupled::new(&fitted, &model.body, &model.provenance);
    let positions = earlier.positions(&rollout).unwrap();
    let found = earlier.health(&rollout, &RolloutRequest::default(), &positions).unwrap();
    assert_eq!((found.state, found.parts[0].visited), (Ending::MovesOn, None), "{found:?}");
    assert!((found.parts[1].still_from.unwrap() - 2.0).abs() < 0.1, "{found:?}");
}

#[test]
fn a_rollout_may_rest_where_its_recording_rests() {
    let (mut model, mut rollout) = walk();
    freeze(&model, &mut rollout, &[0, 1]);
    stop(&mut rollout);
    for (recorded, rests) in [(None, false), (Some(1.5), true), (Some(2.3), true), (Some(3.0), false)] {
        model.body.sequences[0].rests_from = recorded;
        let found = health(&model, &rollout).state;
        assert_eq!(found == Ending::RestsAsRecorded, rests, "{recorded:?} {found:?}");
    }
    // The same motion, started at a later frame of the recording, and from start latents, without a recording.
    let from = |frame, start| RolloutRequest { frame, start, ..RolloutRequest::default() };
    let model = model.coupled().unwrap();
    for (request, state) in [
        (from(30, None), Ending::RestsAsRecorded),
        (from(10, None), Ending::StandsStill),
        (from(30, Some(Vec::new())), Ending::StandsStill),
    ] {
        let found = model.health(&rollout, &request, &model.positions(&rollout).unwrap()).unwrap();
        assert_eq!(found.state, state);
    }
}

#[test]
fn clips_are_compared_from_the_begin_of_each_at_thirty_frames_a_second() {
    let (mut model, rollout) = walk();
    model.body.frame_time = 1.0 / 120.0;
    let mut fitted = model.coupled().unwrap().model.clone();
    fitted.starts = vec![fitted.starts[0].clone(), fitted.starts[0].clone()];
    let two = Coupled::new(&fitted, &model.body, &model.provenance);
    assert_eq!((two.judged_stride(), two.clip_columns().1), (4, vec![0, rollout.y.nrows()]));
}

#[test]
fn models_that_keep_moving_come_before_smaller_errors() {
    let [moves, few, still, broken] =
        [Ending::MovesOn, Ending::VisitsFewPoses, Ending::StandsStill, Ending::NotFinite].map(Ending::rank);
    assert_eq!(best_to_show([]), None);
    assert_eq!(best_to_show([(still, 0.1), (moves, 0.3), (moves, 0.2), (moves, 0.2)]), Some(2));
    assert_eq!(best_to_show([(broken, 0.1), (still, 0.2), (few, 0.3)]), Some(2));
}

#[test]
fn a_part_that_leaves_its_training_is_named() {
    let (model, mut rollout) = walk();
    for t in 45..rollout.y.nrows() {
        rollout.latents[1][(t, 0)] += 1000.0;
    }
    let found = health(&model, &rollout);
    assert_eq!((found.state, found.part), (Ending::LeavesTrainingRange, Some(1)), "{found:?}");
    assert!((found.from.unwrap() - 1.5).abs() < 0.01, "{found:?}");
    // The part returns at the end.
    let last = rollout.y.nrows() - 1;
    rollout.latents[1][(last, 0)] -= 1000.0;
    assert_eq!(health(&model, &rollout).state, Ending::MovesOn);
}

#[test]
fn reports_numbers_that_are_not_finite() {
    let (model, mut rollout) = walk();
    let positions = model.coupled().unwrap().positions(&rollout).unwrap();
    rollout.latents[0][(7, 0)] = f64::NAN;
    let found = model.coupled().unwrap().health(&rollout, &RolloutRequest::default(), &positions).unwrap();
    assert_eq!((found.state, found.rank, found.parts.len()), (Ending::NotFinite, 0, 0));
}

/// Without the frames of the clips, the inducing points that every part has stand for them.
#[test]
fn parts_of_files_of_earlier_versions_may_have_different_numbers_of_points() {
    let (model, _) = walk();
    let mut fitted = model.coupled().unwrap().model.clone();
    for start in fitted.starts.iter_mut().flatten() {
        *start = start.rows(0, 2).into_owned();
    }
    let dynamics = fitted.experts.iter().map(|row| row.iter().map(|_| (0..4).collect()).collect());
    let kept = KeptPoints { poses: vec![vec![0, 1, 2, 3], vec![0, 1, 2]], dynamics: dynamics.collect() };
    let fewer = fitted.with_points(&kept).unwrap();
    let (clips, begins) = Coupled::new(&fewer, &model.body, &model.provenance).clip_columns();
    assert_eq!((clips.nrows(), begins.len()), (3, 0));
}
