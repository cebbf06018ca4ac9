use super::coupling_trainer::{fit_of, fitted_movement};
use super::library_trainer::{library_of, trainer_of};
use super::*;
use crate::models::rollout::couplings::Reading;
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::training::pose_weight::PoseWeight;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::testing::fitted;
use approx::assert_relative_eq;

/// Two parts that move in circles [frames x 3] each. The second waves when `waving`.
fn circles(frames: usize, speed: f64, waving: bool) -> Vec<DMatrix<f64>> {
    let legs = DMatrix::from_fn(frames, 3, |t, d| (speed * t as f64 + d as f64).sin());
    let arms = DMatrix::from_fn(frames, 3, |t, d| {
        let phase = speed * t as f64 + 0.5;
        if waving { (2.0 * phase + d as f64).sin() } else { (phase + 1.3 * d as f64).cos() }
    });
    vec![legs, arms]
}

fn stacked(sequences: &[Vec<DMatrix<f64>>]) -> Vec<DMatrix<f64>> {
    (0..2)
        .map(|part| {
            let rows: Vec<_> =
                sequences.iter().flat_map(|s| s[part].row_iter().map(|row| row.into_owned())).collect();
            let y = DMatrix::from_rows(&rows);
            let mean = y.row_mean();
            DMatrix::from_fn(y.nrows(), y.ncols(), |t, d| y[(t, d)] - mean[d])
        })
        .collect()
}

fn settings() -> VariationalSettings {
    VariationalSettings {
        latent: 2,
        order: 2,
        dynamics_ips: 8,
        pose_ips: 8,
        max_iterations: 120,
        ..Default::default()
    }
}

fn trained(shared: [bool; 2]) -> Library {
    let y = stacked(&[circles(40, 0.3, false), circles(35, 0.32, false), circles(45, 0.3, true)]);
    let movement = |name: &str, sequences| PlannedMovement { name: name.to_owned(), sequences };
    let plan = LibraryPlan::new(vec![movement("walk", 2), movement("wave", 1)], shared.to_vec()).unwrap();
    let mut trainer = trainer_of(y, vec![40, 35, 45], &plan, &settings(), 1).unwrap();
    while !trainer.step().done {}
    library_of(&trainer, &plan).unwrap()
}

#[test]
fn movements_share_a_primitive() {
    let library = trained([true, false]);
    let names: Vec<_> = library.primitives.iter().map(|p| (p.part, p.name.as_str())).collect();
    assert_eq!(names, [(0, "walk+wave"), (1, "walk"), (1, "wave")]);
    // Of the movements with a primitive, the one that shares most counts.
    assert_eq!(library.couplings_of_sources(&[0, 2]), library.movements[1].alpha);
    for (index, movement) in library.movements.iter().enumerate() {
        let model = library.movement(index).unwrap();
        let y = model.rollout(0, 60).unwrap();
        for y in &y {
            let moved = y.rows(40, 20).row_variance().sum();
            assert!(moved > 0.3, "{} stands still: {moved}", movement.name);
        }
    }
}

/// Other movements and primitives are integrated out of the information about a movement's experts. So
/// experts that are inferred again under the learned couplings must be those that all rows together gave.
#[test]
fn a_movement_inferred_again_under_its_couplings_is_as_learned() {
    let library = trained([true, false]);
    for index in 0..2 {
        let model = library.movement(index).unwrap();
        for reading in [Reading::AsLearned, Reading::ReInferred] {
            let path = model.dynamics(&model.alpha, reading).unwrap();
            let path = path.path(&model.start(0, 0).unwrap(), 40).unwrap();
            let learned = model.dynamics(&model.alpha, Reading::AsLearned).unwrap();
            let learned = learned.path(&model.start(0, 0).unwrap(), 40).unwrap();
            for (a, b) in path.iter().zip(&learned) {
                assert_relative_eq!(a, b, epsilon = 1e-6);
            }
        }
        for (i, covariance) in model.dynamics_covariance.iter().enumerate() {
            let mut at = 0;
            for primitive in &library.movements[index].uses {
                let expert = &library.primitives[*primitive].experts[i];
                let points = expert.covariance.nrows();
                let block = covariance.view((at, at), (points, points)).into_owned();
                assert_relative_eq!(block, expert.covariance, epsilon = 1e-7);
                at += points;
            }
        }
        let mut other = model.alpha.clone();
        other[(0, 1)] *= 5.0;
        let predictive = model.predictive_dynamics(&other, Reading::ReInferred).unwrap();
        assert!(predictive.predict(&model.starts[0], model.order).is_ok());
    }
}

#[test]
fn a_library_of_one_movement_is_the_plain_model() {
    let y = stacked(&[circles(40, 0.3, false), circles(35, 0.32, false)]);
    let movement = PlannedMovement { name: "walk".to_owned(), sequences: 2 };
    let plan = LibraryPlan::new(vec![movement], vec![false, true]).unwrap();
    let mut library = trainer_of(y.clone(), vec![40, 35], &plan, &settings(), 1).unwrap();
    let mut plain =
        crate::models::variational::VariationalTrainer::new(y, vec![40, 35], &settings(), 1).unwrap();
    for _ in 0..10 {
        assert_eq!(library.step(), plain.step());
    }
    let (library, plain) =
        (library_of(&library, &plan).unwrap().movement(0).unwrap(), plain.model().unwrap());
    assert!(library.external.is_empty());
    assert_eq!(library.experts, plain.experts);
    assert_eq!((library.sums, library.alpha, library.starts), (plain.sums, plain.alpha, plain.starts));
}

#[test]
fn a_new_combination_starts_at_the_nearest_states_of_its_parts() {
    let library = trained([false, false]);
    let uses = [0, 3];
    assert_eq!(library.movements[0].uses, [0, 2]);
    // Each part listens to itself as in its own movement, and hardly to a part that it never met.
    let alpha = library.nearest_couplings(&uses);
    let own = |part: usize| library.movements[part].alpha[(part, part)];
    assert_eq!(alpha, DMatrix::from_row_slice(2, 2, &[own(0), 10.0, 10.0, own(1)]));
    let named = library.nearest_combination("half", &uses).unwrap();
    assert_eq!(named.couplings, CouplingsFrom::Movement { movement: "walk+wave".to_owned() });
    assert_eq!(library.nearest_couplings(&[1, 3]), library.movements[1].alpha);
    let model = library.combination(&uses, &library.nearest_couplings(&uses)).unwrap();
    assert_eq!(model.starts.len(), 3);
    // Legs of the walk, with arms as they were when the legs of the waving movement were nearest.
    assert_eq!(model.starts[0][0], library.movements[0].starts[0][0].rows(0, 2).into_owned());
    let waving = &library.movements[1].starts[0];
    let found = (0..44).find(|t| waving[1].rows(*t, 2) == model.starts[0][1]);
    let distance = |t: usize| (waving[0].rows(t, 2) - &model.starts[0][0]).norm();
    let nearest = (0..44).min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
    assert_eq!(found, nearest);
    let y = model.rollout(0, 60).unwrap();
    assert!(y.iter().all(|y| y.iter().all(|v| v.is_finite())));
    // Without rows of its own, its experts cannot be inferred again: they stay as learned.
    let mut other = model.alpha.clone();
    other[(0, 1)] *= 5.0;
    let paths = [Reading::AsLearned, Reading::ReInferred].map(|reading| {
        model.dynamics(&other, reading).unwrap().path(&model.start(0, 0).unwrap(), 30).unwrap()
    });
    assert_relative_eq!(paths[0][1], paths[1][1], epsilon = 1e-6);
}

#[test]
fn the_nearest_latents_of_a_pose_of_the_library_are_its_own() {
    let library = trained([false, false]);
    let latents = &library.movements[1].starts[0];
    let poses: Vec<_> = library.parts.iter().zip(latents).map(|(part, x)| part.observations(x)).collect();
    assert_eq!(library.nearest_latents(&poses), *latents);
}

#[test]
fn a_fit_learns_couplings_and_keeps_the_primitives() {
    let library = trained([true, false]);
    // The walk again at another tempo, its columns centred as in the training.
    let all = stacked(&[circles(40, 0.3, false), circles(35, 0.32, false), circles(45, 0.3, true)]);
    let y: Vec<_> = all.iter().map(|y| y.rows(5, 30).into_owned()).collect();
    let mut fit = fit_of(&library, &[0, 1], y.clone(), vec![30], PoseWeight::default(), 150).unwrap();
    let begin = fit.progress().objective;
    while !fit.step().done {}
    assert!(fit.progress().best > begin);
    let mut extended = library.clone();
    extended.movements.push(fitted_movement(&fit, &[0, 1], "walk again"));
    let model = extended.movement(2).unwrap();
    assert_eq!(model.experts[1], library.movement(0).unwrap().experts[1]);
    let latents: Vec<_> = model.starts[0].clone();
    for (found, y) in model.observations(&latents).iter().zip(&y) {
        assert!((found - y).amax() < 0.3, "{}", (found - y).amax());
    }
    let message = |uses: &[usize], y: Vec<DMatrix<f64>>| {
        fit_of(&library, uses, y, vec![30], PoseWeight::default(), 10).err().unwrap().to_string()
    };
    assert_eq!(message(&[0, 0], y.clone()), "expected a primitive of part 1, found primitive 0");
    assert_eq!(message(&[0], y.clone()), "expected a primitive for each of 2 parts, found 1");
    let narrow = vec![y[0].clone(), y[1].columns(0, 2).into_owned()];
    assert_eq!(message(&[0, 1], narrow), "part 1 has 2 columns, expected 3");
}

/// At half the tempo, a turn of an uncoupled part takes twice as many frames.
#[test]
fn a_tempo_changes_the_speed_of_a_part() {
    let model = trained([true, false]).movement(0).unwrap();
    let alone = DMatrix::from_fn(2, 2, |j, i| if i == j { 0.1 } else { 1e6 });
    let dynamics = model.dynamics(&alone, Reading::AsLearned).unwrap();
    let turns = |tempo: f64| {
        let start = model.start(0, 0).unwrap();
        let mut paths = LatentPaths::new(&start, model.order, &model.latent_dimensions()).unwrap();
        paths.set_tempo(0, tempo);
        dynamics.extend(&mut paths, 800);
        let path = &paths.matrices(200..800)[0];
        let mean = path.column(0).mean();
        (1..600).filter(|t| path[(t - 1, 0)] < mean && path[(*t, 0)] >= mean).count()
    };
    let (whole, half) = (turns(1.0), turns(0.5));
    assert!(whole >= 20 && (half as f64 / whole as f64 - 0.5).abs() < 0.1, "{whole} and {half} turns");
}

/// A selection gives the same models as its library.
#[test]
fn a_selection_keeps_what_its_primitives_learned() {
    let library = trained([true, false]);
    // The shared legs and the arms of the walk, with the movement walk and an excerpt of the waving.
    let some = library.select(&[1, 0]).unwrap();
    assert_eq!(some.primitives.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(), ["walk+wave", "walk"]);
    assert_eq!(some.movements.iter().map(|m| m.name.as_str()).collect::<Vec<_>>(), ["walk"]);
    assert_eq!(some.primitives[0].excerpts[0].movement, "wave");
    assert_eq!(some.primitives[0].excerpts[0].starts, library.movements[1].starts);
    assert!(some.primitives[1].excerpts.is_empty() && some.primitives[1].experts[0].external.is_none());
    let (before, after) = (library.movement(0).unwrap(), some.movement(0).unwrap());
    assert_eq!((&before.experts, &before.sums), (&after.experts, &after.sums));
    for (a, b) in before.external.iter().zip(&after.external) {
        assert_relative_eq!(a.precision, b.precision, epsilon = 1e-9, max_relative = 1e-9);
        assert_relative_eq!(a.b, b.b, epsilon = 1e-9, max_relative = 1e-9);
    }
    // A primitive alone has the same mean and covariance of its outputs as in the library.
    for a in 0..3 {
        let alone = library.select(&[a]).unwrap();
        let (primitive, before) = (&alone.primitives[0], &library.primitives[a]);
        assert_eq!(alone.movements.len(), 0);
        assert_eq!(primitive.excerpts.len(), if a == 0 { 2 } else { 1 });
        for (expert, before) in primitive.experts.iter().zip(&before.experts) {
            let k = expert.fitted.k();
            let evidence = expert.external.as_ref().unwrap();
            let inverse = (k + &evidence.precision).try_inverse().unwrap();
            assert_relative_eq!(k * &inverse * k, before.covariance, epsilon = 1e-6);
            assert_relative_eq!(k * &inverse * &evidence.b, *before.fitted.mean(), epsilon = 1e-6);
        }
    }
    let message = |chosen: &[usize]| library.select(chosen).unwrap_err().to_string();
    assert_eq!(message(&[]), "expected primitives from 0 to 2, one or more, found none");
    assert_eq!(message(&[0, 3]), "expected primitives from 0 to 2, one or more, found 3");
}

/// A primitive without its movement still has couplings and start latents.
#[test]
fn an_excerpt_gives_couplings_and_starts() {
    let library = trained([false, false]);
    // Without the legs of the walk, its arms have an excerpt of it.
    let some = library.select(&[1, 2, 3]).unwrap();
    let uses = [0, 1];
    assert_eq!(some.movements.len(), 1);
    assert_eq!(some.nearest_couplings(&uses).row(1), library.movements[0].alpha.row(1));
    let named = some.nearest_combination("half", &uses).unwrap();
    assert_eq!(named.couplings, CouplingsFrom::Movement { movement: "wave+walk".to_owned() });
    let at = |frame: usize| -> Vec<_> {
        library.movements[0].starts[0].iter().map(|x| x.rows(frame, 2).into_owned()).collect()
    };
    let (mut window, arms) = (at(7), at(7).swap_remove(1));
    assert_eq!(some.nearest_state(1, &window, &[]).unwrap(), arms);
    // Legs that change too are ignored: the arms of frame 20, much larger, decide alone.
    window[1] = at(20).swap_remove(1) * 100.0;
    assert_eq!(some.nearest_state(1, &window, &[]).unwrap(), arms);
    assert_ne!(some.nearest_state(1, &window, &[true, false]).unwrap(), arms);
    assert!(some.combination(&uses, &some.nearest_couplings(&uses)).unwrap().rollout(0, 30).is_ok());
}

#[test]
fn motion_tells_still_parts_and_their_leaders() {
    let library = trained([false, false]);
    let recorded = library.motion(&[0, 2], &library.movements[0].alpha).unwrap();
    assert!(recorded.iter().all(|part| !part.still && part.share > 0.3), "{recorded:?}");
    assert!(recorded.iter().all(|part| part.leader.as_ref().unwrap().met));
    // Arms that are driven only by legs of another movement, which did not learn together with them.
    let driven = DMatrix::from_row_slice(2, 2, &[0.1, 0.1, 1e6, 1e6]);
    let motion = library.motion(&[0, 3], &driven).unwrap();
    let leader = motion[1].leader.as_ref().unwrap();
    assert_eq!((leader.part, leader.met), (0, false));
    assert!(leader.weight > 0.99);
    assert!(library.motion(&[0], &driven).is_err());
}

#[test]
fn the_latent_dimensions_of_a_library_are_those_of_its_largest_part() {
    let movement = PlannedMovement { name: "walk".to_owned(), sequences: 1 };
    let plan = LibraryPlan::new(vec![movement], vec![false, false]).unwrap();
    let trainer = trainer_of(circles(40, 0.3, false), vec![40], &plan, &settings(), 1).unwrap();
    let mut library = library_of(&trainer, &plan).unwrap();
    library.parts = fitted(1).parts;
    assert_eq!((library.latent_dimensions(), library.largest_latent()), (vec![2, 3], 3));
}
