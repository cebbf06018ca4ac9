use super::*;
use crate::models::Learner;
use crate::models::data::movements::Sequence;
use crate::models::training::kind::ModelKind;
use nalgebra::DMatrix;

/// Two noisy loops, the second half a cycle after the first; the last five frames are a partial trial.
fn loops() -> Movements {
    let part = |lag: f64| {
        let y = DMatrix::from_fn(75, 4, |t, d| {
            let noise = 0.01 * ((t * 37 + d * 101) as f64).sin();
            (0.35 * t as f64 + lag + d as f64).sin() + 0.3 * (0.7 * t as f64 + 2.0 * d as f64).sin() + noise
        });
        let mean = y.row_mean();
        DMatrix::from_fn(75, 4, |t, d| y[(t, d)] - mean[d])
    };
    let sequence = |frames, whole| Sequence { frames, whole };
    let sequences = vec![sequence(40, true), sequence(30, true), sequence(5, false)];
    Movements { y: vec![part(0.0), part(std::f64::consts::PI)], sequences }
}

fn settings() -> MapSettings {
    MapSettings { latent: 2, order: 2, max_iterations: 150, balanced: false, linear: false }
}

fn spread(y: &DMatrix<f64>) -> f64 {
    y.row_variance().sum().sqrt()
}

#[test]
fn training_raises_the_density_and_the_rollout_keeps_moving() {
    for (movements, kind) in [(loops(), ModelKind::MapCgpdm), (loops().as_one_part(), ModelKind::MapGpdm)] {
        let mut learner = MapLearner::new(movements.clone(), &settings(), 1).unwrap();
        let start = learner.progress().best;
        let mut best = start;
        while !learner.progress().done {
            let progress = learner.step();
            assert!(progress.best >= best && progress.best.is_finite() && progress.fraction <= 1.0);
            best = progress.best;
        }
        assert!(best > start + 100.0, "{start} to {best}");
        assert!((learner.terms().total() - best).abs() < 1e-9 * best.abs());
        let model = learner.model().unwrap();
        assert_eq!((model.kind(), model.bound()), (kind, None));
        for (rolled, trained) in model.rollout(2, 200).unwrap().iter().zip(&movements.y) {
            assert_eq!(rolled.shape(), (200, trained.ncols()));
            let (end, learned) = (spread(&rolled.rows(140, 60).into_owned()), spread(trained));
            assert!(end > 0.3 * learned, "the rollout stands still: {end}, in training {learned}");
        }
    }
}

/// One step from training latents leads near the next latent, and the poses are those of training up to
/// noise.
#[test]
fn a_rollout_starts_as_its_sequence() {
    let movements = loops();
    let mut learner = MapLearner::new(movements.clone(), &settings(), 1).unwrap();
    while !learner.step().done {}
    let (params, model) = (learner.best(), learner.fitted().unwrap());
    let start = model.latents(1, 3).unwrap();
    for i in 0..2 {
        let x = &params.parts[i].latents;
        assert_eq!(start[i].rows(0, 2), x.rows(40, 2));
        let step = (start[i].row(2) - x.row(42)).norm();
        assert!(step < 0.2 * (x.row(42) - x.row(41)).norm() + 0.05, "{step}");
        let rolled = model.rollout(1, 2).unwrap();
        let error = (&rolled[i] - movements.y[i].rows(40, 2)).amax();
        assert!(error < 5.0 * params.parts[i].beta.sqrt() + 1e-6, "{error}");
    }
    // One part of 75 frames: latents, coefficients of both maps, kernels, couplings.
    let one = MapLearner::new(movements.as_one_part(), &settings(), 1).unwrap().model().unwrap();
    assert_eq!(one.stored_numbers(), 75 * 2 + 75 * 8 + (75 - 6) * 2 + 2 + 1 + 4 + 1);
}

#[test]
fn the_same_seed_gives_the_same_numbers() {
    let run = |seed| {
        let mut learner = MapLearner::new(loops(), &settings(), seed).unwrap();
        for _ in 0..15 {
            learner.step();
        }
        learner.progress()
    };
    assert_eq!(run(7), run(7));
    assert_ne!(run(7).best, run(8).best);
}

#[test]
fn refuses_settings_out_of_range_and_trains_on_a_still_part() {
    let error = |settings| MapLearner::new(loops(), &settings, 1).err().unwrap().to_string();
    assert_eq!(
        error(MapSettings { latent: 0, ..settings() }),
        "the latent dimension must be from 1 to 100, found 0"
    );
    assert_eq!(
        error(MapSettings { order: 6, ..settings() }),
        "sequence 2 has 5 frames; dynamics of order 6 need at least 7"
    );
    let mut still = loops();
    still.y[1].fill(0.0);
    let mut learner = MapLearner::new(still, &MapSettings { max_iterations: 40, ..settings() }, 1).unwrap();
    while !learner.step().done {}
    assert!(learner.progress().best.is_finite());
    let model = learner.model().unwrap();
    assert!(model.rollout(2, 100).unwrap().iter().all(|y| y.iter().all(|v| v.is_finite())));
}
