//! Trainings on the project's own clips with the same numbers natively and in wasm, and their rollouts and
//! documents.

use nalgebra::DMatrix;
use std::sync::Arc;
use vcgpdm_core::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement};
use vcgpdm_core::models::{
    ColumnMapping, Dataset, DmpSettings, Endless, MapSettings, Model, PoseWeight, RolloutRequest, Settings,
    Source, TmpSettings, Trainer, VariationalSettings,
};
use vcgpdm_core::motion::sha256;
use vcgpdm_core::motion::{bvh, parts, samples};
use vcgpdm_core::series::{Table, parse_parts, read, write};

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

/// Standard deviation of latents over frames, all dimensions together.
fn spread(x: &DMatrix<f64>) -> f64 {
    x.row_variance().sum().sqrt()
}

/// The reference numbers come from a native run of this test, so the test checks that native and wasm agree.
/// A difference in the last bit of a sine once grew to 0.1 % after fifty iterations.
pub fn native_and_wasm_training_give_the_same_bounds() {
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
const AFTER_FIFTY: f64 = 58046.38162256442;

pub fn a_model_of_sample_walks_walks_and_is_read_from_its_document() {
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
        assert!(
            end > 0.3 * learned,
            "the rollout stands still: its latents vary by {end}, those of the training by {learned}"
        );
    }

    let again = Model::coupled_from_json(&model.to_json().unwrap()).unwrap();
    assert_eq!(again.coupled().unwrap().rollout(&request).unwrap().y, rollout.y);

    let clip = coupled.clip(&rollout, "rollout.bvh").unwrap();
    let read = bvh::read("rollout.bvh", bvh::write(&clip).as_bytes()).unwrap().into_clip();
    assert_eq!(read.frames(), 300);
    let hips = |frame: usize| read.world_pose(frame).positions[0];
    let travelled = (hips(299) - hips(0)).norm() / read.height();
    assert!(travelled > 3.0, "the body travels {travelled} body heights in ten seconds");
}

const SMALL: VariationalSettings = VariationalSettings {
    latent: 2,
    order: 2,
    dynamics_ips: 6,
    pose_ips: 6,
    max_iterations: 5,
    pose_weight: PoseWeight::Fixed(1.0),
    uncoupled: false,
    own_rollouts: false,
};

/// The walks with these ids at ten frames a second.
fn walks(names: &[&str], split: &str) -> Dataset {
    let clips: Vec<_> = names.iter().map(|id| samples::clip(id).unwrap()).collect();
    let parts = parts::presets(&clips[0].skeleton).into_iter().find(|p| p.id == split).unwrap().parts;
    let sources: Vec<_> = clips.iter().map(Source::from).collect();
    Dataset::new(&sources, &parts, 10.0).unwrap()
}

/// The norm of two seconds of a model's rollout minus its mean.
fn size<S: ColumnMapping>(model: &Model<S>) -> f64 {
    let y = model.rollout(0, 20).unwrap();
    assert_eq!(y.nrows(), 20);
    let mean = y.row_mean();
    DMatrix::from_fn(y.nrows(), y.ncols(), |row, column| y[(row, column)] - mean[column]).norm()
}

/// The reference numbers come from a native run. A few iterations amplify a difference in a last digit only
/// little, so another order of a sum needs no new numbers.
fn assert_near(case: &str, found: [f64; 2], expected: [f64; 2]) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-7 * expected.abs(), "{case}: {found:?} is not {expected:?}");
    }
}

/// SHA-256 of a model's document, without the version of the program, and of two seconds of its rollout.
fn fingerprint(model: &Model) -> String {
    let text = model.to_json().unwrap().replace(&model.provenance.engine, "");
    let rollout = model.rollout(0, 20).unwrap();
    let bytes = rollout.iter().flat_map(|value| value.to_le_bytes());
    sha256(&text.into_bytes().into_iter().chain(bytes).collect::<Vec<_>>())
}

/// A model of these kinds is the same file natively and in wasm, and its rollout the same to the last bit. The
/// other kinds multiply large matrices with the instructions of the processor.
pub fn the_same_training_gives_the_same_file() {
    let dmp = DmpSettings { bases: 5 };
    let trained = [
        (Settings::Vcgpdm(SMALL), "lower-upper"),
        (Settings::Vgpdm(SMALL), "whole"),
        (Settings::DmpDiscrete(dmp.clone()), "lower-upper"),
        (Settings::DmpRhythmic(dmp), "lower-upper"),
    ];
    let found = trained.map(|(settings, split)| {
        let mut trainer = Trainer::new(&walks(&["walk-1", "walk-2"], split), &settings, 1).unwrap();
        trainer.run();
        fingerprint(&trainer.finish().unwrap())
    });
    assert_eq!(found, SAME_FILES);
}

const SAME_FILES: [&str; 4] = [
    "2a092b3bf1b2388ebc9549b67c34dff656bc447808fc175cbe79499d5dda2ce5",
    "8a99b7b352ed28a36942db08bc21f52511b244bfd957d99e2c794d2567726828",
    "784b281189dd8f5cd15979dfd8a249bb52b243066fb36dced527e7700d93fdaf",
    "dd21af8dc29d6432d87a1960b37dd372136db2ab6971318bbcc9d926aa6fac67",
];

pub fn each_kind_of_model_trains_and_rolls_out() {
    let point = MapSettings { max_iterations: 3, ..MapSettings::default() };
    let tmp = TmpSettings { primitives: Some(3), ..TmpSettings::default() };
    let dmp = DmpSettings { bases: 5 };
    for (settings, split, expected) in [
        (Settings::Vcgpdm(SMALL), "lower-upper", [10445.07678834946, 3.292225389918295]),
        (Settings::Vgpdm(SMALL), "whole", [10220.303554125923, 3.396096928372359]),
        (Settings::MapGpdm(point.clone()), "whole", [15293.207428668122, 3.9035621040668933]),
        (Settings::MapCgpdm(point), "lower-upper", [14562.541066671312, 3.838534736503963]),
        (Settings::Tmp(tmp), "lower-upper", [11187.478602318604, 3.6348283367010583]),
        (Settings::DmpDiscrete(dmp.clone()), "lower-upper", [-0.02180366081320099, 3.39647721704717]),
        (Settings::DmpRhythmic(dmp), "lower-upper", [-0.0006795167600272311, 3.7410425537028242]),
    ] {
        let mut trainer = Trainer::new(&walks(&["walk-1", "walk-2"], split), &settings, 1).unwrap();
        let objective = trainer.run().best;
        let model = trainer.finish().unwrap();
        assert_eq!(model.kind(), settings.kind());
        let read = Model::from_json(&model.to_json().unwrap()).unwrap();
        assert_eq!(read.rollout(0, 20).unwrap(), model.rollout(0, 20).unwrap(), "{}", settings.kind().id());
        assert_near(settings.kind().id(), [objective, size(&model)], expected);
    }
}

/// Of the models with couplings: other couplings and a live rollout; of several parts: completing.
pub fn alpha_live_rollouts_and_completing_give_the_same_numbers() {
    for (settings, split, expected) in [
        (Settings::Vcgpdm(SMALL), "lower-upper", [15.75884973494433, 717.7683649920364, 15.693584342010519]),
        (Settings::Vgpdm(SMALL), "whole", [15.892736376786871, 729.5220314805338, 0.0]),
    ] {
        let dataset = walks(&["walk-1", "walk-2"], split);
        let mut trainer = Trainer::new(&dataset, &settings, 1).unwrap();
        trainer.run();
        let model = Arc::new(trainer.finish().unwrap());
        let coupled = model.coupled().unwrap();
        let alpha = coupled
            .model
            .alpha
            .map_with_location(|source, target, alpha| if source == target { alpha } else { 100.0 * alpha });
        let request = RolloutRequest { frames: 20, alpha: Some(alpha.clone()), ..RolloutRequest::default() };
        let rollout = coupled.rollout(&request).unwrap();
        let mut live = Endless::after(Arc::clone(&model), &rollout, 9, 0).unwrap();
        live.set_couplings(alpha, request.reading).unwrap();
        let next = live.advance(10).unwrap();
        assert_eq!(next.latents[0], rollout.latents[0].rows(10, 10).into_owned(), "the live rollout");
        let completed = match split {
            "whole" => 0.0,
            _ => coupled.complete(&request, &rollout.y, &[0], None).unwrap().y.norm(),
        };
        let positions: f64 = next.positions.iter().map(|x| f64::from(*x)).sum();
        assert_near(split, [rollout.y.norm(), positions], [expected[0], expected[1]]);
        assert_near(split, [completed, 0.0], [expected[2], 0.0]);
    }
}

pub fn a_library_of_primitives_trains_and_rolls_out() {
    let dataset = walks(&["walk-1", "walk-wave-1"], "lower-upper");
    let movement = |name: &str| PlannedMovement { name: name.to_owned(), sequences: 1 };
    let plan = LibraryPlan::new(vec![movement("walk"), movement("wave")], vec![false, false]).unwrap();
    let mut trainer = LibraryTrainer::new(&dataset, &plan, &SMALL, 1).unwrap();
    while !trainer.step().done {}
    let trained = trainer.finish().unwrap();
    let uses = trained.read_uses("lower=walk,upper=wave").unwrap();
    let model = trained.combination(&uses, &trained.library.nearest_couplings(&uses)).unwrap();
    assert_near("library", [trainer.progress().best, size(&model)], [7489.858046600491, 3.8700766998827385]);
    let found = trained.recognise(&[&samples::clip("walk-1").unwrap()]).unwrap();
    let density = found.log_densities.iter().map(DMatrix::sum).sum::<f64>();
    assert_near("recognition", [found.posterior.norm(), density], [6.423899022708125, 7960.6778424130225]);
}

pub fn a_table_trains_and_rolls_out() {
    let values = DMatrix::from_fn(60, 2, |row, column| {
        let phase = ((row + 5 * column) % 24) as f64 / 12.0 - 1.0;
        phase * (1.0 - phase.abs())
    });
    let text = write(&["leader", "follower"].map(str::to_owned), &values, 0.02);
    let table: Table = read("table.csv", text.as_bytes()).unwrap();
    let parts = parse_parts("leader=leader;follower=follower", &table.columns).unwrap();
    let dataset = Dataset::of_tables(&[table], &parts, 30.0).unwrap();
    let mut trainer = Trainer::new(&dataset, &Settings::Vcgpdm(SMALL), 1).unwrap();
    let objective = trainer.run().best;
    assert_near(
        "table",
        [objective, size(&trainer.finish().unwrap())],
        [-204.84407612706713, 1.0337255318358685],
    );
}
