//! Training on the project's own clips, natively and in wasm: the same numbers, a rollout that walks, a model
//! that can be shared.

use vcgpdm::models::{Dataset, Model, RolloutRequest, Source, Trainer, VariationalSettings};
use vcgpdm::motion::{bvh, parts, samples};

const FRAMES_PER_SECOND: f64 = 30.0;

fn dataset() -> Dataset {
    let clips: Vec<_> = ["walk-1", "walk-2"].iter().map(|id| samples::clip(id).unwrap()).collect();
    let parts = parts::presets(&clips[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap().parts;
    let sources: Vec<_> = clips.iter().map(|clip| Source { clip, first_frames: None }).collect();
    Dataset::new(&sources, &parts, FRAMES_PER_SECOND).unwrap()
}

fn trainer(dataset: &Dataset, max_iterations: usize) -> Trainer {
    let settings = VariationalSettings { max_iterations, ..VariationalSettings::default() };
    Trainer::new(dataset, &settings.into(), 3).unwrap()
}

/// Standard deviation of the latents over some frames, all dimensions together.
fn spread(x: &nalgebra::DMatrix<f64>) -> f64 {
    x.row_variance().sum().sqrt()
}

/// The reference numbers are this test's own, printed by a native run: what they guard is that native and
/// wasm agree. A difference in the last bit of a sine was once a difference of 0.1 % after fifty iterations.
pub fn native_and_wasm_take_the_same_path() {
    let dataset = dataset();
    let mut trainer = trainer(&dataset, 160);
    let start = trainer.progress().best;
    let mut progress = trainer.progress();
    for _ in 0..50 {
        progress = trainer.step();
    }
    let found = [start, progress.best];
    for (found, expected) in found.into_iter().zip([START, AFTER_FIFTY]) {
        assert!((found - expected).abs() <= 1e-13 * expected, "{found:?} is not {expected:?}");
    }
}

const START: f64 = 33311.327883799226;
const AFTER_FIFTY: f64 = 58046.4319108062;

pub fn the_sample_walk_trains_to_a_model_that_walks_and_can_be_shared() {
    let dataset = dataset();
    let mut trainer = trainer(&dataset, 300);
    trainer.run();
    let model = trainer.finish().unwrap();
    let request = RolloutRequest { frames: 300, ..RolloutRequest::default() };
    let coupled = model.coupled().unwrap();
    let rollout = coupled.rollout(&request).unwrap();
    for (part, path) in rollout.latents.iter().enumerate() {
        let learned = trainer.latents(part).unwrap();
        let (end, learned) = (spread(&path.rows(240, 60).into_owned()), spread(&learned));
        assert!(end > 0.3 * learned, "the rollout stands still: {end} beside {learned}");
    }

    let again = Model::coupled_from_json(&model.to_json().unwrap()).unwrap();
    assert_eq!(again.coupled().unwrap().rollout(&request).unwrap().y, rollout.y);

    let clip = coupled.clip(&rollout, "rollout.bvh").unwrap();
    let read = bvh::read("rollout.bvh", bvh::write(&clip).as_bytes()).unwrap().into_clip();
    assert_eq!(read.frames(), 300);
    let hips = |frame: usize| read.world_pose(frame).positions[0];
    let travelled = (hips(299) - hips(0)).norm() / read.height();
    assert!(travelled > 3.0, "ten seconds of walking lead {travelled} body heights away");
}
