//! A library of sample walks, and combinations that were never recorded.

use nalgebra::DMatrix;
use vcgpdm_core::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary};
use vcgpdm_core::models::{Dataset, Endless, Push, REWINDS, Reading, Source, VariationalSettings};
use vcgpdm_core::motion::{Clip, parts, samples};

const FRAMES: usize = 600;
/// Largest latent of a rollout, relative to the range of the latents of the training.
const LARGEST: f64 = 1.5;

pub fn trained(max_iterations: usize) -> TrainedLibrary {
    let clips: Vec<Clip> =
        ["walk-1", "walk-2", "walk-wave-1", "walk-wave-2"].map(|id| samples::clip(id).unwrap()).into();
    let sources: Vec<Source> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let parts = parts::presets(&clips[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
    let dataset = Dataset::new(&sources, &parts, 30.0).unwrap();
    let movement = |name: &str| PlannedMovement { name: name.to_owned(), sequences: 2 };
    let plan = LibraryPlan::new(vec![movement("walk"), movement("wave")], vec![false, false]).unwrap();
    let settings = VariationalSettings { max_iterations, ..VariationalSettings::default() };
    let mut trainer = LibraryTrainer::new(&dataset, &plan, &settings, 1).unwrap();
    while !trainer.step().done {}
    trainer.finish().unwrap()
}

fn range(x: &DMatrix<f64>, q: usize) -> (f64, f64) {
    (x.column(q).min(), x.column(q).max())
}

#[test]
fn legs_of_the_walk_and_arms_of_the_wave_keep_moving_together() {
    let trained = trained(150);
    let library = &trained.library;
    let uses = trained.read_uses("lower=walk,upper=wave").unwrap();
    assert_eq!(library.recorded_movement(&uses), None);
    let model = trained.combination(&uses, &library.nearest_couplings(&uses)).unwrap();
    let model = model.coupled().unwrap();
    let dynamics = model.model.dynamics(&model.model.alpha, Reading::AsLearned).unwrap();
    let path = dynamics.path(&model.model.start(0, 0).unwrap(), FRAMES).unwrap();
    for (part, x) in path.iter().enumerate() {
        let training: Vec<_> = library.movements.iter().flat_map(|m| &m.starts).map(|s| &s[part]).collect();
        let mut moves = 0.0_f64;
        for q in 0..x.ncols() {
            let ranges = training.iter().map(|x| range(x, q));
            let (low, high) = ranges.fold((0.0_f64, 0.0_f64), |a, b| (a.0.min(b.0), a.1.max(b.1)));
            let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
            let (least, most) = range(x, q);
            let furthest = (least - middle).abs().max((most - middle).abs());
            assert!(
                furthest <= LARGEST * half,
                "part {part}, latent {q}: {least} to {most}, trained {low} to {high}"
            );
            let end = x.rows(FRAMES - 100, 100).into_owned();
            moves = moves.max((range(&end, q).1 - range(&end, q).0) / (high - low));
        }
        assert!(moves > 0.3, "part {part} moves by {moves} of its training's range at the end");
    }
}

/// `rewind` removes the last frames of a motion, with the changes among them.
#[test]
fn a_rewound_motion_continues_as_if_the_removed_frames_had_never_existed() {
    let trained = trained(10);
    let mut walk = trained.endless(&[0, 2]).unwrap();
    let whole = walk.clone().advance(50).unwrap();
    walk.advance(30).unwrap();
    let mut expected = walk.clone();
    // Frames in pieces with changes among them, all of which are removed.
    walk.advance(3).unwrap();
    trained.use_primitive(&mut walk, 1, 3, None).unwrap();
    walk.advance(4).unwrap();
    walk.set_tempo(0, 0.5).unwrap();
    walk.rewind(7).unwrap();
    assert_eq!(walk.uses(), [0, 2]);
    let again = walk.advance(20).unwrap();
    assert_eq!(again.positions, whole.positions[30 * whole.positions.len() / 50..]);
    // A later change acts from this frame on.
    walk.rewind(20).unwrap();
    for walk in [&mut walk, &mut expected] {
        trained.use_primitive(walk, 1, 3, None).unwrap();
    }
    let (found, expected) = (walk.advance(9), expected.advance(9));
    assert_eq!(found.unwrap().positions, expected.unwrap().positions);
    // Rewinding by no frame removes the changes since the last frame.
    trained.use_primitive(&mut walk, 0, 1, None).unwrap();
    walk.rewind(0).unwrap();
    assert_eq!(walk.uses(), [0, 3]);
    // A motion cannot be rewound before its start, nor to frames that are no longer stored.
    let refusal = |walk: &mut Endless, frames| walk.rewind(frames).unwrap_err().to_string();
    assert_eq!(refusal(&mut walk, 40), "expected frames to take back from 0 to 39, found 40");
    walk.advance(100).unwrap();
    assert_eq!(refusal(&mut walk, 65), "expected frames to take back from 0 to 64, found 65");
    walk.rewind(REWINDS).unwrap();
    assert!(walk.rewind(1).is_err());
    assert_eq!(walk.set_tempo(0, 3.0).unwrap_err().to_string(), "expected a tempo from 0.25 to 2, found 3");
}

#[test]
fn a_motion_of_primitives_begins_at_any_frame_and_its_parts_are_pushed_and_driven() {
    let trained = trained(60);
    let mut walk = trained.endless_from(&[0, 2], (0, 1, 12)).unwrap();
    let model = trained.movement(0).unwrap();
    let model = model.coupled().unwrap().model;
    let start: Vec<_> = model.starts[1].iter().map(|x| x.rows(12, 2).into_owned()).collect();
    let path = model.dynamics(&model.alpha, Reading::AsLearned).unwrap().path(&start, 42).unwrap();
    let walked = walk.advance(40).unwrap();
    for (found, path) in walked.latents.iter().zip(&path) {
        assert!((found - path.rows(2, 40)).amax() < 1e-9);
    }
    // The arms become those of the waving movement.
    trained.use_primitive(&mut walk, 1, 3, None).unwrap();
    assert_eq!(walk.uses(), [0, 3]);
    walk.advance(1).unwrap();
    let mut pushed = walk.clone();
    pushed.push(&Push { part: 1, by: vec![0.5; 3], ..Push::default() }).unwrap();
    pushed.cut(1, 0, true).unwrap();
    let (free, pushed) = (walk.advance(1).unwrap(), pushed.advance(1).unwrap());
    assert!((&free.latents[1] - &pushed.latents[1]).amax() > 0.05);
    if !free.places.is_empty() {
        walk.drive(0, 0.0).unwrap();
        let still = walk.advance(60).unwrap();
        assert!((still.latents[0].row(59) - still.latents[0].row(40)).amax() < 1e-3);
    }
    let message = |place| trained.endless_from(&[0, 2], place).unwrap_err().to_string();
    assert_eq!(message((2, 0, 0)), "expected a movement from 0 to 1, found 2");
    assert_eq!(message((1, 2, 0)), "expected a sequence of the movement from 0 to 1, found 2");
    let message = message((1, 1, 100_000));
    assert!(message.starts_with("expected a frame of the sequence with a whole history from 0 to "));
}
