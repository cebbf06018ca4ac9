//! Primitives of a library in clips that it was not trained on.

use crate::combinations::trained;
use nalgebra::DMatrix;
use vcgpdm_core::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary};
use vcgpdm_core::models::{Dataset, VariationalSettings};
use vcgpdm_core::motion::parts::presets;
use vcgpdm_core::motion::{Clip, samples};

/// The boundaries of a joined clip are found to within this time, in seconds.
const NEAR: f64 = 0.3;
/// Frames of each piece.
const PIECE: usize = 40;

#[test]
fn walking_then_waving_then_walking_is_cut_into_three_pieces() {
    let trained = trained(100);
    let clips = ["walk-3", "walk-wave-3", "walk-4"]
        .map(|id| samples::clip(id).unwrap().resample(30.0).unwrap().cut(0, PIECE).unwrap());
    let recognition = trained.recognise(&clips.each_ref()).unwrap();
    let segments = recognition.segments();
    let movements = &trained.library.movements;
    let found: Vec<usize> =
        segments.iter().filter_map(|s| movements.iter().position(|m| m.uses == s.uses)).collect();
    assert_eq!(found, [0, 1, 0], "{segments:?}");
    for (segment, joined) in segments.iter().zip([PIECE, 2 * PIECE]) {
        let error = segment.frames.end.abs_diff(joined) as f64 * trained.body.frame_time;
        assert!(error < NEAR, "{error} s");
    }
    // The legs of the two movements look alike; the arms are told apart with certainty.
    assert!(segments.iter().all(|segment| segment.probability > 0.75), "{segments:?}");
    let arms = recognition.part_posterior(1);
    let certain = arms.row_iter().map(|row| row.max()).sum::<f64>() / arms.nrows() as f64;
    assert!(certain > 0.95, "{certain}");
}

/// A sample clip at 15 frames a second; `backwards`: its frames in the opposite order.
fn sample(id: &str, backwards: bool) -> Clip {
    let mut clip = samples::clip(id).unwrap().resample(15.0).unwrap();
    if backwards {
        let last = clip.frames() - 1;
        clip.values = DMatrix::from_fn(last + 1, clip.values.ncols(), |t, c| clip.values[(last - t, c)]);
    }
    clip
}

/// A library of walking and of waving backwards. The legs of the two differ, unlike those of the samples.
fn forward_and_backward() -> TrainedLibrary {
    let clips = [
        sample("walk-1", false),
        sample("walk-2", false),
        sample("walk-wave-1", true),
        sample("walk-wave-2", true),
    ];
    let parts =
        presets(&clips[0].skeleton).into_iter().find(|preset| preset.id == "lower-upper").unwrap().parts;
    let dataset = Dataset::new(&clips.each_ref().map(|clip| clip.into()), &parts, 15.0).unwrap();
    let planned = ["walk", "wave back"].map(|name| PlannedMovement { name: name.to_owned(), sequences: 2 });
    let plan = LibraryPlan::new(planned.into(), vec![false; 2]).unwrap();
    let settings = VariationalSettings::default().with_max_iterations(60);
    let mut trainer = LibraryTrainer::new(&dataset, &plan, &settings, 0).unwrap();
    trainer.run();
    trainer.finish().unwrap()
}

#[test]
fn legs_of_one_movement_and_arms_of_another_are_told_apart() {
    let trained = forward_and_backward();
    let (walk, wave) = (sample("walk-3", false), sample("walk-wave-3", true));
    let upper = presets(&walk.skeleton).into_iter().find(|preset| preset.id == "lower-upper").unwrap();
    let upper = &upper.parts[1].joints;
    let frames = walk.frames().min(wave.frames());
    let mut mixed = walk.cut(0, frames).unwrap();
    let mut first = 0;
    for (joint, of_joint) in walk.skeleton.joints.iter().enumerate() {
        let count = of_joint.channels.len();
        if upper.contains(&joint) {
            mixed.values.columns_mut(first, count).copy_from(&wave.values.view((0, first), (frames, count)));
        }
        first += count;
    }
    let uses = |movement: usize| trained.library.movements[movement].uses.clone();
    for (clip, expected) in [(&walk, uses(0)), (&wave, uses(1)), (&mixed, vec![uses(0)[0], uses(1)[1]])] {
        let found = trained.recognise(&[clip]).unwrap();
        let segments = found.segments();
        assert_eq!(segments.len(), 1, "{segments:?}");
        assert_eq!(segments[0].uses, expected);
        for (part, used) in expected.iter().enumerate() {
            let posterior = found.part_posterior(part);
            let place = found.primitives[part].iter().position(|a| a == used).unwrap();
            assert!(posterior.column(place).mean() > 0.9, "part {part}");
            assert!(posterior.row_iter().all(|row| (row.sum() - 1.0).abs() < 1e-9));
        }
    }
}

#[test]
fn a_clip_of_another_body_is_refused() {
    let trained = trained(3);
    let mut other = samples::clip("walk-3").unwrap();
    other.skeleton.joints[2].offset[1] *= 2.0;
    let error = trained.recognise(&[&other]).unwrap_err().to_string();
    assert!(error.contains("is not of the body of the model"), "{error}");
}
