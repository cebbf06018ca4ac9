//! TMP and DMP on recorded walks: what they predict of a trial of which they saw five frames.
//!
//! A measurement: `cargo test --release --test primitives -- --ignored --nocapture`, with the folder of clips in VCGPDM_CLIPS.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use nalgebra::DMatrix;
use std::path::PathBuf;
use std::time::Instant;
use vcgpdm::evaluation::{Score, dtw_mse};
use vcgpdm::models::PhaseAxis;
use vcgpdm::models::dmp::Canonical;
use vcgpdm::models::dmp::{DmpLearner, DmpSettings};
use vcgpdm::models::tmp::{NoiseSharing, TmpLearner, TmpSettings};
use vcgpdm::models::{Dataset, Learner, MovementModel, Movements, Sequence, Source};
use vcgpdm::motion::{bvh, parts};

/// All but one walk and five frames of that one; and all of it.
fn walks(held_out: usize, trials: usize) -> Option<(Movements, DMatrix<f64>)> {
    let beside = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/bvh");
    let folder = std::env::var_os("VCGPDM_CLIPS").map_or(beside, PathBuf::from).join("cmu-walk");
    if !folder.is_dir() {
        eprintln!("skipped: no recorded walks in {}", folder.display());
        return None;
    }
    let read = |k: usize| {
        let name = format!("35_{k:02}.bvh");
        bvh::read(&name, &std::fs::read(folder.join(&name)).unwrap()).unwrap().into_clip()
    };
    let mut clips: Vec<_> = (1..=trials).filter(|&k| k != held_out).map(read).collect();
    clips.push(read(held_out));
    let last = clips.len() - 1;
    let sources: Vec<Source> = clips
        .iter()
        .enumerate()
        .map(|(k, clip)| Source { clip, first_frames: (k == last).then_some(5) })
        .collect();
    let parts = &parts::presets(&clips[0].skeleton)[1].parts;
    let data = Dataset::new(&sources, parts, 30.0).unwrap();
    let trial = data.mapping.encode(&clips[last].resample(30.0).unwrap()).unwrap().y;
    let sequences =
        data.lengths().into_iter().enumerate().map(|(k, frames)| Sequence { frames, whole: k < last });
    // The order of columns of the trial is that of the mapping; the parts' is put back for the score.
    let actual = data.layout.split(&trial);
    let all = Movements { y: actual, sequences: Vec::new() }.as_one_part().y.swap_remove(0);
    Some((Movements { y: data.y, sequences: sequences.collect() }, all))
}

fn score(model: &dyn MovementModel, sequence: usize, actual: &DMatrix<f64>) -> Score {
    let y = model.rollout(sequence, actual.nrows()).unwrap();
    let y = Movements { y, sequences: Vec::new() }.as_one_part().y.swap_remove(0);
    dtw_mse(&y, actual).unwrap()
}

fn learn(learner: &mut dyn Learner) -> (f64, usize) {
    let begin = Instant::now();
    while !learner.step().done {}
    (begin.elapsed().as_secs_f64(), learner.progress().iteration)
}

#[test]
fn a_held_out_walk_is_predicted_from_its_first_five_frames() {
    let Some((movements, actual)) = walks(6, 6) else { return };
    let settings = TmpSettings { primitives: Some(6), max_sweeps: 60, ..TmpSettings::default() };
    let mut tmp = TmpLearner::new(&movements, settings).unwrap();
    let mut dmp = DmpLearner::new(&movements, DmpSettings::new(Canonical::Rhythmic)).unwrap();
    for learner in [&mut tmp as &mut dyn Learner, &mut dmp] {
        learn(learner);
        let s = score(learner.model().unwrap().as_ref(), 5, &actual);
        // A motionless prediction scores the variance, the vCGPDM 0.0007.
        assert!((s.variance - 0.00586).abs() < 1e-5 && s.dtw_mse < 0.0011, "{s:?}");
    }
}

#[test]
#[ignore = "a measurement, not a check"]
fn temporal_movement_primitives() {
    let Some((movements, actual)) = walks(6, 6) else { return };
    let held_out = movements.sequences.len() - 1;
    let counts: Vec<usize> = std::env::var("COUNTS")
        .map_or((2..=10).collect(), |c| c.split(',').map(|v| v.parse().unwrap()).collect());
    for (axis, noise) in [
        (PhaseAxis::Cycle, NoiseSharing::Part),
        (PhaseAxis::Cycle, NoiseSharing::Column),
        (PhaseAxis::Trial, NoiseSharing::Part),
    ] {
        for &count in &counts {
            let settings =
                TmpSettings { primitives: Some(count), axis: Some(axis), noise, ..TmpSettings::default() };
            let mut learner = TmpLearner::new(&movements, settings).unwrap();
            let (seconds, sweeps) = learn(&mut learner);
            let model = learner.fitted().unwrap();
            let s = score(&model, held_out, &actual);
            println!(
                "{axis:?} {noise:?} Q {count}: bound {:.0}, dtw mse {:.6}, mse {:.6} (variance {:.6}), {seconds:.2} s, {sweeps} sweeps, {} numbers, l {:.3}, R {}, noise {:.5}",
                model.bound,
                s.dtw_mse,
                s.mse,
                s.variance,
                model.stored_numbers(),
                model.lengthscale,
                model.inducing.len(),
                model.noise.mean(),
            );
        }
    }
}

#[test]
#[ignore = "a measurement, not a check"]
fn dynamic_movement_primitives() {
    let Some((movements, actual)) = walks(6, 6) else { return };
    let held_out = movements.sequences.len() - 1;
    let lengths: Vec<usize> = movements.lengths();
    let mut settings = vec![(Canonical::Rhythmic, 25.0 / 3.0)];
    settings.extend([25.0 / 3.0, 2.0].map(|alpha_x| (Canonical::Discrete, alpha_x)));
    for (canonical, alpha_x) in settings {
        for bases in [5, 10, 15, 20, 30, 40, 80] {
            let settings = DmpSettings { bases, alpha_x, ..DmpSettings::new(canonical) };
            let mut learner = DmpLearner::new(&movements, settings).unwrap();
            let (seconds, _) = learn(&mut learner);
            let model = learner.model().unwrap();
            let s = score(model.as_ref(), held_out, &actual);
            println!(
                "{canonical:?} alpha_x {alpha_x:.1} B {bases}: training error {:.6}, dtw mse {:.6}, mse {:.6} (variance {:.6}), {seconds:.2} s, {} numbers",
                -learner.progress().best,
                s.dtw_mse,
                s.mse,
                s.variance,
                model.stored_numbers(),
            );
        }
    }
    // One trial alone, so that nothing but the number of bases stands between the model and the recording.
    let one = Movements {
        y: movements.y.iter().map(|y| y.rows(0, lengths[0]).into_owned()).collect(),
        sequences: vec![movements.sequences[0]],
    };
    for canonical in [Canonical::Discrete, Canonical::Rhythmic] {
        for bases in [20, 40, 80, 120] {
            let settings = DmpSettings { bases, ..DmpSettings::new(canonical) };
            let mut learner = DmpLearner::new(&one, settings).unwrap();
            println!("one trial, {canonical:?} B {bases}: training error {:.7}", -learner.step().best);
        }
    }
}
