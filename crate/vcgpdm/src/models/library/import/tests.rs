use super::*;
use crate::models::data::dataset::{Dataset, Source};
use crate::models::library::TrainedLibrary;
use crate::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement};
use crate::models::training::settings::VariationalSettings;
use crate::motion::{Clip, parts, samples};
use std::sync::OnceLock;

fn clip(id: &str) -> Clip {
    samples::clip(id).unwrap().cut(0, 90).unwrap()
}

/// A library of the movement `name` from these clips.
fn library(name: &str, ids: &[&str], latent: usize, seed: u32) -> TrainedLibrary {
    let clips: Vec<Clip> = ids.iter().map(|id| clip(id)).collect();
    let sources: Vec<Source> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let dataset = Dataset::new(&sources, &parts::presets(&clips[0].skeleton)[1].parts, 30.0).unwrap();
    let settings = VariationalSettings {
        latent,
        dynamics_ips: 8,
        pose_ips: 8,
        max_iterations: 60,
        ..Default::default()
    };
    let movement = PlannedMovement { name: name.to_owned(), sequences: ids.len() };
    let plan = LibraryPlan::new(vec![movement], vec![false, false]).unwrap();
    let mut trainer = LibraryTrainer::new(&dataset, &plan, &settings, seed).unwrap();
    trainer.run();
    trainer.finish().unwrap()
}

fn host() -> &'static TrainedLibrary {
    static HOST: OnceLock<TrainedLibrary> = OnceLock::new();
    HOST.get_or_init(|| library("wave", &["walk-wave-1"], 3, 1))
}

/// A library of other latent dimensions.
fn donor() -> &'static TrainedLibrary {
    static DONOR: OnceLock<TrainedLibrary> = OnceLock::new();
    DONOR.get_or_init(|| library("walk", &["walk-1"], 2, 2))
}

fn request(host: &TrainedLibrary, donor: &TrainedLibrary) -> ImportRequest {
    ImportRequest { companions: host.companions(donor), max_iterations: 40, seed: 1 }
}

#[test]
fn an_import_adds_a_primitive_and_keeps_the_host_unchanged() {
    let legs = donor().select(&[0]).unwrap();
    assert_eq!(
        host().check_fit(&legs).unwrap_err().to_string(),
        "the latent dimensions of lower differ: expected 3, found 2"
    );
    let encoded = [host().encode(&clip("walk-1")).unwrap()];
    for frames in [ImportFrames::Remembered, ImportFrames::Clips(&encoded)] {
        let mut trainer = ImportTrainer::new(host(), &legs, frames, &request(host(), &legs)).unwrap();
        let begin = trainer.progress().objective;
        trainer.run();
        assert!(trainer.progress().best > begin + 100.0);
        let lost = trainer.lost();
        assert!(lost[0] < 0.05 && (0.0..1.0).contains(&lost[1]), "{lost:?}");
        let library = trainer.finish().unwrap();
        let before = &host().library;
        assert_eq!(library.library.parts, before.parts);
        assert_eq!(library.library.primitives[..2], before.primitives[..]);
        assert_eq!(library.library.movements[..1], before.movements[..]);
        let (new, movement) = (&library.library.primitives[2], &library.library.movements[1]);
        assert_eq!((new.name.as_str(), new.part, new.experts.len()), ("walk", 0, 2));
        // The host's arms are the companion of the new legs; they stay as they are.
        assert_eq!((movement.name.as_str(), &movement.uses), ("walk", &vec![2, 1]));
        assert!(movement.sums.is_none());
        let origin = library.origin(2);
        let relearned = origin.relearned.unwrap();
        assert_eq!((relearned.primitive.as_str(), relearned.frames), ("walk", frames.source()));
        assert_eq!(relearned.clips, donor().body.sequences);
        assert_eq!(origin.training.objective, trainer.progress().best);
        // The stored evidence gives the mean of the outputs.
        for expert in &new.experts {
            let evidence = expert.external.as_ref().unwrap();
            let a = expert.fitted.k() + &evidence.precision;
            let mean = expert.fitted.k() * a.try_inverse().unwrap() * &evidence.b;
            approx::assert_relative_eq!(mean, *expert.fitted.mean(), epsilon = 1e-5);
        }
        let again = TrainedLibrary::from_json(&library.to_json().unwrap()).unwrap();
        assert_eq!(again.library, library.library);
        assert!(library.movement(1).unwrap().fitted.rollout(0, 60).is_ok());
    }
}

#[test]
fn a_movement_of_new_primitives_alone_keeps_its_rows() {
    let mut trainer =
        ImportTrainer::new(host(), donor(), ImportFrames::Generated, &request(host(), donor())).unwrap();
    trainer.run();
    let library = trainer.finish().unwrap();
    let movement = &library.library.movements[1];
    assert_eq!(movement.uses, [2, 3]);
    assert!(movement.sums.is_some());
    assert!(library.library.primitives[2].experts.iter().all(|expert| expert.external.is_none()));
    // Experts inferred again from the rows are those that were learned.
    let model = library.movement(1).unwrap();
    let model = model.coupled().unwrap().model;
    use crate::models::rollout::couplings::Reading;
    let step = |reading| {
        let dynamics = model.dynamics(&model.alpha, reading).unwrap();
        dynamics.path(&model.start(0, 0).unwrap(), model.order + 1).unwrap()
    };
    for (a, b) in step(Reading::AsLearned).iter().zip(&step(Reading::ReInferred)) {
        approx::assert_relative_eq!(a, b, epsilon = 1e-6);
    }
}

#[test]
fn refuses_imports_without_frames_or_companions() {
    let message = |donor: &TrainedLibrary, frames: ImportFrames, companions: Vec<Option<usize>>| {
        let request = ImportRequest { companions, ..request(host(), donor) };
        ImportTrainer::new(host(), donor, frames, &request).err().unwrap().to_string()
    };
    let legs = donor().select(&[0]).unwrap();
    let no_frames = "the file keeps no movement to learn its primitives again from: expected clips";
    assert_eq!(message(&legs, ImportFrames::Generated, vec![Some(0), Some(1)]), no_frames);
    assert_eq!(message(&legs, ImportFrames::Clips(&[]), vec![Some(0), Some(1)]), no_frames);
    assert!(
        message(&legs, ImportFrames::Remembered, vec![Some(0), None])
            .starts_with("expected a primitive of upper")
    );
    assert_eq!(
        message(&legs, ImportFrames::Remembered, vec![Some(0), Some(0)]),
        "expected a primitive of part 1, found primitive 0"
    );
    assert_eq!(
        message(&legs, ImportFrames::Remembered, vec![]),
        "expected a primitive for each of 2 parts, found 0"
    );
    // A donor that stores only the first frames.
    let mut short = legs.clone();
    for start in short.library.primitives[0].excerpts.iter_mut().flat_map(|excerpt| &mut excerpt.starts) {
        *start = start.iter().map(|x| x.rows(0, 2).into_owned()).collect();
    }
    assert_eq!(message(&short, ImportFrames::Remembered, vec![Some(0), Some(1)]), no_frames);
}
