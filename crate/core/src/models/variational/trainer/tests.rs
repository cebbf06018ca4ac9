use super::*;
use crate::models::rollout::couplings::Reading;
use crate::models::training::pose_weight::PoseWeight;

/// Two noisy loops, the second half a cycle behind the first.
fn loops(frames: usize) -> Vec<DMatrix<f64>> {
    let noise = |t: usize, d: usize| 0.01 * ((t * 37 + d * 101) as f64).sin();
    let part = |lag: f64| {
        let y = DMatrix::from_fn(frames, 4, |t, d| {
            (0.35 * t as f64 + lag + d as f64).sin()
                + 0.3 * (0.7 * t as f64 + 2.0 * d as f64).sin()
                + noise(t, d)
        });
        let mean = y.row_mean();
        DMatrix::from_fn(frames, 4, |t, d| y[(t, d)] - mean[d])
    };
    vec![part(0.0), part(std::f64::consts::PI)]
}

fn settings() -> VariationalSettings {
    VariationalSettings {
        latent: 2,
        dynamics_ips: 8,
        pose_ips: 8,
        order: 2,
        max_iterations: 250,
        ..Default::default()
    }
}

#[test]
fn training_raises_the_bound_and_the_rollout_keeps_moving() {
    let mut trainer = VariationalTrainer::new(loops(90), vec![50, 40], &settings(), 1).unwrap();
    let start = trainer.progress();
    let mut best = start.best;
    while !trainer.progress().done {
        let progress = trainer.step();
        assert!(progress.best >= best && progress.best.is_finite());
        assert!(
            (progress.terms.as_ref().unwrap().total() - progress.best).abs() < 1e-9 * progress.best.abs()
        );
        best = progress.best;
    }
    assert!(best > start.best + 100.0, "{} to {best}", start.best);
    let model = trainer.model().unwrap();
    let dynamics = model.dynamics(&model.alpha, Reading::AsLearned).unwrap();
    for (path, part) in
        dynamics.path(&model.start(0, 0).unwrap(), 300).unwrap().iter().zip(&trainer.best().parts)
    {
        let spread = |x: &DMatrix<f64>| x.row_variance().sum().sqrt();
        let (end, learned) = (spread(&path.rows(240, 60).into_owned()), spread(&part.latents.mean));
        assert!(end > 0.3 * learned, "the rollout stands still: {end}, learned {learned}");
    }
}

#[test]
fn the_same_seed_gives_the_same_training() {
    let run = |seed| {
        let mut trainer = VariationalTrainer::new(loops(60), vec![60], &settings(), seed).unwrap();
        for _ in 0..30 {
            trainer.step();
        }
        trainer.progress()
    };
    assert_eq!(run(7), run(7));
    assert_ne!(run(7).best, run(8).best);
}

#[test]
fn an_early_stop_gives_the_best_point_so_far() {
    let mut trainer = VariationalTrainer::new(loops(60), vec![60], &settings(), 1).unwrap();
    for _ in 0..12 {
        trainer.step();
    }
    let best = trainer.progress().best;
    let again = trainer.objective().terms(&trainer.best()).unwrap().total();
    assert!((again - best).abs() < 1e-9 * best.abs(), "{again} and {best}");
    assert!(trainer.model().is_ok());
}

#[test]
fn without_iterations_the_starting_point_remains() {
    let none = VariationalSettings { max_iterations: 0, ..settings() };
    let mut trainer = VariationalTrainer::new(loops(60), vec![60], &none, 1).unwrap();
    let start = trainer.progress().best;
    let progress = trainer.step();
    assert!(progress.done && progress.best == start && progress.fraction == 1.0);
    assert!(trainer.model().is_ok());
}

#[test]
fn refuses_bad_settings() {
    let wrong = |settings, lengths: Vec<usize>| {
        VariationalTrainer::new(loops(60), lengths, &settings, 1).err().unwrap().to_string()
    };
    let zero = VariationalSettings { latent: 0, ..settings() };
    assert_eq!(wrong(zero, vec![60]), "the latent dimension must be from 1 to 100, found 0");
    let trainer = VariationalTrainer::new(loops(60), vec![60], &settings(), 1).unwrap();
    let none = VariationalSettings { pose_ips: 0, ..settings() };
    let wrong_sequences =
        VariationalTrainer::from_start(trainer.objective(), trainer.best(), schedule(10), &none, 1);
    assert_eq!(
        wrong_sequences.err().unwrap().to_string(),
        "the number of pose inducing points must be from 1 to 1000, found 0"
    );
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e9] {
        let weighted = VariationalSettings { pose_weight: PoseWeight::Fixed(bad), ..settings() };
        let expected = "the weight of the pose terms must be a number from 0.001 to 1000";
        assert_eq!(wrong(weighted, vec![60]), format!("{expected}, found {bad}"));
    }
    assert_eq!(wrong(settings(), vec![59, 1]), "sequence 1 has 1 frame; dynamics of order 2 need at least 3");
    assert_eq!(
        wrong(settings(), vec![50]),
        "part 0 has 60 frames of observations, but the sequences have 50"
    );
}

#[test]
fn a_motionless_part_trains_without_nan() {
    let mut y = loops(60);
    y[1].fill(0.0);
    let mut trainer =
        VariationalTrainer::new(y, vec![60], &VariationalSettings { max_iterations: 40, ..settings() }, 1)
            .unwrap();
    for _ in 0..40 {
        assert!(trainer.step().best.is_finite());
    }
}

#[test]
fn an_extended_training_agrees_with_a_longer_one() {
    let from = |iterations: usize| {
        let settings = VariationalSettings { max_iterations: iterations, ..settings() };
        let trainer = VariationalTrainer::new(loops(60), vec![60], &settings, 1).unwrap();
        // The first phase has the same length for both.
        VariationalTrainer::from_start(trainer.objective(), trainer.best(), schedule(60), &settings, 1)
            .unwrap()
    };
    let (mut longer, mut resumed) = (from(60), from(30));
    while !longer.step().done {}
    let halfway = loop {
        let progress = resumed.step();
        if progress.done {
            break progress;
        }
    };
    assert_eq!((halfway.iteration, halfway.reason), (30, Some(EndReason::Iterations)));
    resumed.extend(30);
    let begun = resumed.progress();
    assert_eq!((begun.done, begun.best, begun.max_iterations), (false, halfway.best, 60));
    while !resumed.step().done {}
    assert!(resumed.progress().best > halfway.best);
    assert_eq!(resumed.progress(), longer.progress());
    assert_eq!(resumed.best(), longer.best());
    assert_eq!(resumed.settings(), longer.settings());
}

#[test]
fn a_settled_training_is_not_extended() {
    let mut trainer = VariationalTrainer::new(loops(60), vec![60], &settings(), 1).unwrap();
    trainer.extend(5000);
    while !trainer.step().done {}
    let settled = trainer.progress();
    assert_eq!(settled.reason, Some(EndReason::BoundSettled));
    trainer.extend(10);
    assert_eq!(trainer.step().iteration, settled.iteration);
}

#[test]
fn a_weighted_training_raises_its_objective_and_keeps_the_bound() {
    let balanced = VariationalSettings { pose_weight: PoseWeight::Balanced, ..settings() };
    let mut trainer = VariationalTrainer::new(loops(90), vec![50, 40], &balanced, 1).unwrap();
    let start = trainer.progress();
    while !trainer.step().done {}
    let (progress, objective, best) = (trainer.progress(), trainer.objective(), trainer.best());
    assert!(progress.best > start.best + 100.0, "{} to {}", start.best, progress.best);
    let terms = objective.terms(&best).unwrap();
    assert!((objective.value(&best, &terms) - progress.best).abs() < 1e-9 * progress.best.abs());
    // Each part has four columns and two latent dimensions.
    let poses: f64 = terms.kinematics.iter().sum();
    assert!((terms.total() - progress.best - 0.5 * poses).abs() < 1e-9 * poses.abs());
    let model = trainer.model().unwrap();
    assert!((model.bound() - terms.total()).abs() < 1e-9 * terms.total().abs());
    let provenance = trainer.provenance(30.0);
    assert_eq!((provenance.objective, provenance.bound()), (progress.best, model.bound()));
}

/// A part with as many columns as latent dimensions has the factor 1.
#[test]
fn balanced_parts_of_as_many_columns_as_dimensions_train_as_plain_ones() {
    let run = |pose_weight| {
        let settings = VariationalSettings { latent: 4, pose_weight, ..settings() };
        let mut trainer = VariationalTrainer::new(loops(60), vec![60], &settings, 1).unwrap();
        for _ in 0..30 {
            trainer.step();
        }
        trainer.best()
    };
    assert_eq!(run(PoseWeight::Balanced), run(PoseWeight::default()));
    assert_ne!(run(PoseWeight::Fixed(0.5)), run(PoseWeight::default()));
}

#[test]
fn without_couplings_each_part_moves_as_if_it_were_alone() {
    let train = |y: Vec<DMatrix<f64>>, uncoupled| {
        let settings = VariationalSettings { uncoupled, ..settings() };
        let mut trainer = VariationalTrainer::new(y, vec![50, 40], &settings, 1).unwrap();
        while !trainer.step().done {}
        trainer.model().unwrap()
    };
    // How far the first frames of the path of part i change with the first latents of the other part.
    let listens = |model: &Vcgpdm, i: usize| {
        let dynamics = model.dynamics(&model.alpha, Reading::AsLearned).unwrap();
        let mut start = model.start(0, 0).unwrap();
        let path = dynamics.path(&start, 3).unwrap();
        start[1 - i].fill(0.0);
        (&dynamics.path(&start, 3).unwrap()[i] - &path[i]).amax()
    };
    let (coupled, uncoupled) = (train(loops(90), false), train(loops(90), true));
    for i in 0..2 {
        assert!((uncoupled.alpha[(1 - i, i)] / LARGEST_COUPLING - 1.0).abs() < 1e-12);
        assert!(uncoupled.alpha[(i, i)] < 1.0, "{}", uncoupled.alpha);
        assert!(listens(&uncoupled, i) < 0.05, "{}", listens(&uncoupled, i));
        // The last frames of a long rollout move as much as those of a model of this part alone.
        let swing = |y: &DMatrix<f64>| y.rows(200, 60).row_variance().sum().sqrt();
        let alone = train(vec![loops(90).swap_remove(i)], false).rollout(0, 260).unwrap();
        let together = uncoupled.rollout(0, 260).unwrap();
        let ratio = swing(&together[i]) / swing(&alone[0]);
        assert!((0.8..1.25).contains(&ratio), "part {i}: {ratio}");
    }
    let most = listens(&coupled, 0).max(listens(&coupled, 1));
    assert!(most > 0.1, "the coupled parts listen to each other: {most}");
}
