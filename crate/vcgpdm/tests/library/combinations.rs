//! A library of the sample walks: a combination that was never recorded.

use nalgebra::DMatrix;
use vcgpdm::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement, TrainedLibrary};
use vcgpdm::models::{Dataset, Reading, Source, VariationalSettings};
use vcgpdm::motion::{Clip, parts, samples};

const FRAMES: usize = 600;
/// How far a rollout may go beyond the latents of the training.
const ROOM: f64 = 1.5;

fn trained() -> TrainedLibrary {
    let clips: Vec<Clip> =
        ["walk-1", "walk-2", "walk-wave-1", "walk-wave-2"].map(|id| samples::clip(id).unwrap()).into();
    let sources: Vec<Source> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let parts = parts::presets(&clips[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
    let dataset = Dataset::new(&sources, &parts, 30.0).unwrap();
    let movement = |name: &str| PlannedMovement { name: name.to_owned(), sequences: 2 };
    let plan = LibraryPlan::new(vec![movement("walk"), movement("wave")], vec![false, false]).unwrap();
    let settings = VariationalSettings { max_iterations: 150, ..VariationalSettings::default() };
    let mut trainer = LibraryTrainer::new(dataset.y.clone(), dataset.lengths(), plan, &settings, 1).unwrap();
    while !trainer.step().done {}
    TrainedLibrary::trained(&dataset, &trainer, 30.0).unwrap()
}

fn range(x: &DMatrix<f64>, q: usize) -> (f64, f64) {
    (x.column(q).min(), x.column(q).max())
}

#[test]
fn legs_of_the_walk_and_arms_of_the_wave_move_on_together() {
    let trained = trained();
    let library = &trained.library;
    let uses = trained.uses("lower=walk,upper=wave").unwrap();
    assert_eq!(library.recorded(&uses), None);
    let model = trained.combination(&uses, &library.nearest_couplings(&uses)).unwrap();
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
                furthest <= ROOM * half,
                "part {part}, latent {q}: {least} to {most}, trained {low} to {high}"
            );
            let end = x.rows(FRAMES - 100, 100).into_owned();
            moves = moves.max((range(&end, q).1 - range(&end, q).0) / (high - low));
        }
        assert!(moves > 0.3, "part {part} moves by {moves} of its training's range at the end");
    }
}
