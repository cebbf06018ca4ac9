//! Tests of the data, the training and the verdict.

use super::data::{COLUMNS, FRAMES};
use super::*;
use nalgebra::DMatrix;
use vcgpdm_core::document::Document;
use vcgpdm_core::models::VariationalSettings;

#[test]
fn both_parts_move_and_depend_only_on_the_seed() {
    for seed in 0..20 {
        let data = Synthetic::draw(seed, DRIVE).unwrap();
        assert_eq!(data.latents.len(), 2);
        for (x, y) in data.latents.iter().zip(&data.y) {
            assert_eq!((x.shape(), y.shape()), ((FRAMES, 2), (FRAMES, COLUMNS)));
            // The last third moves too.
            assert!(x.rows(200, 100).row_variance().sum() >= 0.05, "a part rests with seed {seed}");
            assert!(y.row_mean().amax() < 1e-12);
        }
    }
    assert_eq!(Synthetic::draw(3, DRIVE).unwrap(), Synthetic::draw(3, DRIVE).unwrap());
    assert_ne!(Synthetic::draw(3, DRIVE).unwrap(), Synthetic::draw(4, DRIVE).unwrap());
}

#[test]
fn the_first_part_influences_the_second_but_not_the_reverse() {
    let (alone, driven) = (Synthetic::draw(0, 0.0).unwrap(), Synthetic::draw(0, DRIVE).unwrap());
    assert_eq!(alone.latents[0], driven.latents[0]);
    assert!((&alone.latents[1] - &driven.latents[1]).amax() > 0.05);
}

#[test]
fn refuses_a_share_outside_0_to_1() {
    for drive in [-0.1, 1.5, f64::NAN] {
        let error = Synthetic::draw(0, drive).unwrap_err().to_string();
        assert_eq!(
            error,
            format!("the share of the first part in the second must be from 0 to 1, found {drive:?}")
        );
    }
}

#[test]
fn training_finds_who_drives_whom() {
    let data = Synthetic::draw(2, DRIVE).unwrap();
    let settings = VariationalSettings { max_iterations: 400, ..Synthetic::settings() };
    let mut experiment = Experiment::new(data, &settings, 2).unwrap();
    let at_first = experiment.findings().unwrap();
    assert_eq!(&at_first.now, experiment.start());
    while !experiment.step().done {}
    let found = experiment.findings().unwrap();
    assert!(found.verdict.right(DRIVE), "{:?}, alpha {}", found.verdict, found.alpha);
    for w in found.weights.column_iter() {
        assert!((w.sum() - 1.0).abs() < 1e-12, "weights into a part sum to 1, found {w}");
    }
    assert!(found.weights[(1, 0)] < 0.01 && found.weights[(0, 1)] > 0.2, "weights {}", found.weights);
    let (before, after) = (experiment.start().fit, found.now.fit);
    assert!(after.bound > before.bound && after.bound == experiment.progress().best);
    assert!(after.mse < 0.5 * before.mse, "the rollout's error went from {} to {}", before.mse, after.mse);
    for (part, now) in found.now.learned.iter().enumerate() {
        assert!(now.explained > 0.9, "{}", now.explained);
        let at_first = &at_first.now.learned[part];
        assert!(now.explained > at_first.explained, "training brings them nearer the truth");
    }
    // The mean path goes round as far as the true latents do, also in its last frames.
    for (part, share) in found.now.late_spread(experiment.data()).into_iter().enumerate() {
        assert!((0.9..1.1).contains(&share), "{share}");
        let points = (&found.now.dynamics_ips[part], &found.now.pose_ips[part]);
        assert_eq!((points.0.shape(), points.1.shape()), ((10, 4), (10, 2)));
    }
    // The saved model makes the same curves, in a file of tables.
    let text = experiment.model().unwrap().to_json().unwrap();
    let Document::Series(saved) = Document::from_json(&text).unwrap() else { panic!("a model of tables") };
    let y = saved.rollout(0, FRAMES).unwrap();
    for (part, generated) in found.now.generated.iter().enumerate() {
        let columns = y.columns(part * COLUMNS, COLUMNS);
        assert!((columns - generated).amax() < 1e-9, "{}", (columns - generated).amax());
    }
    assert_eq!(saved.body.mapping.names()[13], "part 2 curve 4");
}

#[test]
fn a_verdict_can_be_wrong() {
    let verdict = |back: f64, forth: f64| {
        Verdict::new(&DMatrix::from_row_slice(2, 2, &[0.1, 0.2 * forth, 0.1 * back, 0.2]))
    };
    assert!(verdict(50.0, 2.0).right(DRIVE));
    assert!(!verdict(2.0, 2.0).right(DRIVE), "nor does the second part drive the first");
    assert!(!verdict(50.0, 20.0).right(DRIVE), "the first part drives the second");
    assert!(!verdict(50.0, 0.1).right(DRIVE), "and does not rule it alone");
    assert!(verdict(2.0, 2.0).forth_is_right(DRIVE) && !verdict(2.0, 2.0).back_is_right());
    assert!(verdict(50.0, 20.0).right(0.0));
    assert!(!verdict(50.0, 2.0).right(0.0), "nothing drives the second part");
}
