//! The filter against brute force, against what the model itself draws, and in cases of which the answer is
//! known.

mod column_noise;
mod correction;
mod kalman;

use super::correction::{Observed, correct};
use crate::gp::Kernel;
use crate::models::rollout::couplings::Reading;
use crate::models::training::pose_weight::PoseWeight;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::filter::step::Filter;
use crate::models::variational::maps::PoseMap;
use crate::models::variational::model::Vcgpdm;
use crate::models::variational::moments::Belief;
use crate::models::variational::params::Params;
use crate::models::variational::testing::fitted;
use crate::models::variational::trainer::VariationalTrainer;
use approx::assert_relative_eq;
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::{PI, TAU};

fn normal(rng: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(rng)
}

/// Frames of the two training sequences.
const LENGTHS: [usize; 2] = [60, 40];

/// Noisy loops of two parts, the second half a cycle behind the first, [100 x 4] each.
fn loops() -> Vec<DMatrix<f64>> {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut part = |lag: f64| {
        let mut y = DMatrix::from_fn(LENGTHS.iter().sum(), 4, |t, d| {
            (0.35 * t as f64 + lag + d as f64).sin() + 0.25 * normal(&mut rng)
        });
        let mean = y.row_mean();
        y.row_iter_mut().for_each(|mut row| row -= &mean);
        y
    };
    vec![part(0.0), part(PI)]
}

/// A model that was trained on the loops, and its q(x).
fn trained(order: usize) -> (Vcgpdm, Params) {
    trained_on(loops(), order)
}

fn trained_on(y: Vec<DMatrix<f64>>, order: usize) -> (Vcgpdm, Params) {
    let settings = VariationalSettings {
        latent: 2,
        dynamics_ips: 6,
        pose_ips: 6,
        order,
        max_iterations: 80,
        ..Default::default()
    };
    let mut trainer = VariationalTrainer::new(y, LENGTHS.to_vec(), &settings, 1).unwrap();
    while !trainer.progress().done {
        trainer.step();
    }
    (trainer.model().unwrap(), trainer.best())
}

fn filter_of(model: &Vcgpdm) -> Filter {
    model.filter(&model.alpha, Reading::AsLearned, PoseWeight::default()).unwrap()
}

/// The model with the noise variance beta for all columns, as the filter draws them.
fn without_column_noise(mut model: Vcgpdm) -> Vcgpdm {
    model.parts = model.parts.into_iter().map(|map| map.with_column_noise(Vec::new())).collect();
    model
}

/// A belief about p frames of the first training sequence.
fn near(model: &Vcgpdm, frame: usize, variance: f64) -> Belief {
    let start = model.start(0, frame).unwrap();
    let mean: Vec<f64> = start.iter().flat_map(|x| x.transpose().as_slice().to_vec()).collect();
    let size = mean.len();
    Belief { mean: DVector::from_vec(mean), covariance: DMatrix::identity(size, size) * variance }
}

/// A latent path of every part [frames x Q_i] and its columns [frames x D_i], drawn from the model.
fn drawn(
    model: &Vcgpdm,
    start: &Belief,
    frames: usize,
    rng: &mut ChaCha8Rng,
) -> (Vec<DMatrix<f64>>, Vec<DMatrix<f64>>) {
    let filter = filter_of(model);
    let latents = path(&filter, &model.latent_dimensions(), start, frames, rng);
    let columns = latents.iter().enumerate().map(|(part, x)| {
        let map = &filter.poses[part];
        let all: Vec<usize> = (0..map.columns()).collect();
        let mut y = DMatrix::zeros(frames, map.columns());
        for t in 0..frames {
            let x: Vec<f64> = x.row(t).iter().copied().collect();
            let at = map.tangent(&x, &all);
            for c in 0..y.ncols() {
                y[(t, c)] = at.values[c] + at.variance.sqrt() * normal(rng);
            }
        }
        y
    });
    let columns = columns.collect();
    (latents, columns)
}

/// A latent path [frames x Q_i] of every part, drawn from the prior.
fn path(
    filter: &Filter,
    latent: &[usize],
    start: &Belief,
    frames: usize,
    rng: &mut ChaCha8Rng,
) -> Vec<DMatrix<f64>> {
    let root = start.covariance.clone().cholesky().unwrap().unpack();
    let history = &start.mean + root * DVector::from_fn(start.mean.len(), |_, _| normal(rng));
    let mut at = 0;
    let first = latent.iter().map(|q| {
        at += q * filter.order();
        DMatrix::from_row_slice(filter.order(), *q, &history.as_slice()[at - q * filter.order()..at])
    });
    let first: Vec<DMatrix<f64>> = first.collect();
    let drawn_seed = rand_chacha::rand_core::Rng::next_u64(rng);
    filter.dynamics.sample(&first, frames, drawn_seed).unwrap()
}

fn without(y: &[DMatrix<f64>], part: usize) -> Vec<DMatrix<f64>> {
    let mut y = y.to_vec();
    y[part].fill(f64::NAN);
    y
}

#[test]
#[ignore = "seldom: npm test -- --all"]
fn agrees_with_importance_sampling() {
    let (frames, tolerance) = (4, 0.2);
    for order in 1..=3 {
        let model = trained(order).0;
        let (filter, latent) = (filter_of(&model), model.latent_dimensions());
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let start = near(&model, 5, 0.05);
        let (_, y) = drawn(&model, &start, frames, &mut rng);
        // The second part is not observed, nor are one frame and one number of the first.
        let mut y = without(&y, 1);
        y[0].row_mut(2).fill(f64::NAN);
        y[0][(1, 0)] = f64::NAN;
        let run = filter.run(start.clone(), &y).unwrap();
        let smoothed = filter.smoothed(&run).unwrap();

        let draws = 100_000;
        let (mut weights, mut paths) = (Vec::with_capacity(draws), Vec::with_capacity(draws));
        for _ in 0..draws {
            let x = path(&filter, &latent, &start, frames, &mut rng);
            let mut log_weight = 0.0;
            for t in 0..frames {
                let observed: Vec<usize> = (0..y[0].ncols()).filter(|&c| !y[0][(t, c)].is_nan()).collect();
                let row: Vec<f64> = x[0].row(t).iter().copied().collect();
                let at = filter.poses[0].tangent(&row, &observed);
                for (value, &c) in at.values.iter().zip(&observed) {
                    log_weight -=
                        0.5 * ((y[0][(t, c)] - value).powi(2) / at.variance + (TAU * at.variance).ln());
                }
            }
            weights.push(log_weight);
            paths.push(x);
        }
        let largest = weights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let weights: Vec<f64> = weights.iter().map(|w| (w - largest).exp()).collect();
        let total: f64 = weights.iter().sum();
        let effective = total * total / weights.iter().map(|w| w * w).sum::<f64>();
        assert!(effective > 500.0, "order {order}: {effective} effective draws");
        let evidence = largest + (total / draws as f64).ln();
        assert!((run.evidence() - evidence).abs() < 0.2, "order {order}: {} {evidence}", run.evidence());
        for (part, q) in latent.iter().enumerate() {
            for t in 0..frames {
                for q in 0..*q {
                    let moment = |f: &dyn Fn(f64) -> f64| {
                        weights.iter().zip(&paths).map(|(w, x)| w * f(x[part][(t, q)])).sum::<f64>() / total
                    };
                    let mean = moment(&|x| x);
                    let deviation = moment(&|x| (x - mean).powi(2)).sqrt();
                    let own = smoothed.covariances[part][t][(q, q)].sqrt();
                    let apart = (smoothed.means[part][(t, q)] - mean).abs() / deviation;
                    let found =
                        format!("order {order}, part {part}, frame {t}, {q}: {apart} {}", own / deviation);
                    assert!(apart < tolerance + 3.0 / effective.sqrt(), "{found}");
                    assert!((own / deviation - 1.0).abs() < tolerance, "{found}");
                }
            }
        }
    }
}

#[test]
fn training_clips_give_the_latents_that_were_trained() {
    for order in 1..=3 {
        let (model, params) = trained(order);
        let filter = filter_of(&model);
        let y: Vec<_> = loops().iter().map(|y| y.rows(0, LENGTHS[0]).into_owned()).collect();
        let run = filter.run_from_best(&y, 10).unwrap();
        let found = filter.smoothed(&run).unwrap();
        for (part, of_part) in params.parts.iter().enumerate() {
            let (mut square, mut ratio) = (0.0, 0.0);
            for t in 0..LENGTHS[0] {
                for q in 0..2 {
                    let variance = of_part.latents.variance[(t, q)];
                    let apart = found.means[part][(t, q)] - of_part.latents.mean[(t, q)];
                    square += apart * apart / variance / (2 * LENGTHS[0]) as f64;
                    ratio += found.covariances[part][t][(q, q)] / variance / (2 * LENGTHS[0]) as f64;
                }
            }
            let words = format!("order {order}, part {part}: {square} {ratio}");
            assert!(square < 1.0 && (0.5..2.0).contains(&ratio), "{words}");
        }
    }
}

#[test]
fn without_a_sense_it_is_the_free_rollout() {
    for seed in [1, 2, 3] {
        let model = fitted(seed);
        let filter = filter_of(&model);
        let y: Vec<_> = filter.columns().iter().map(|&d| DMatrix::from_element(12, d, f64::NAN)).collect();
        let run = filter.run(near(&model, 0, 0.0), &y).unwrap();
        assert_eq!(run.evidence(), 0.0);
        let free = filter.dynamics.moments(&model.start(0, 0).unwrap(), 12).unwrap();
        let filtered = filter.filtered(&run);
        let smoothed = filter.smoothed(&run).unwrap();
        for part in 0..model.part_count() {
            assert_eq!(filtered.means[part], free.means[part]);
            assert_eq!(filtered.covariances[part], free.covariances[part]);
            // What never was observed teaches nothing about earlier frames.
            assert_relative_eq!(smoothed.means[part], free.means[part], epsilon = 1e-9);
        }
    }
}

#[test]
fn the_last_frame_is_smoothed_already_and_earlier_ones_become_surer() {
    let model = fitted(3);
    let (filter, start) = (filter_of(&model), near(&model, 0, 0.1));
    let (_, y) = drawn(&model, &start, 15, &mut ChaCha8Rng::seed_from_u64(2));
    let run = filter.run(start, &without(&y, 2)).unwrap();
    let (filtered, smoothed) = (filter.filtered(&run), filter.smoothed(&run).unwrap());
    for part in 0..3 {
        assert_eq!(filtered.means[part].row(14), smoothed.means[part].row(14));
        for t in 0..14 {
            let (before, after) = (&filtered.covariances[part][t], &smoothed.covariances[part][t]);
            assert!(after.trace() < before.trace(), "part {part}, frame {t}");
            assert!(after.clone().symmetric_eigenvalues().min() > 0.0);
        }
    }
}

#[test]
fn columns_that_never_changed_count_in_the_error_alone() {
    let mut y = loops();
    y[0] = y[0].clone().insert_column(4, 0.0);
    let model = trained_on(y.clone(), 1).0;
    let filter = filter_of(&model);
    let y: Vec<DMatrix<f64>> = y.iter().map(|part| part.rows(0, 20).into_owned()).collect();
    let run = filter.run(near(&model, 0, 0.1), &y).unwrap();
    let latents = filter.filtered(&run);
    let score = |value: f64| {
        let mut recorded = y[0].clone();
        recorded.column_mut(4).fill(value);
        filter.score(0, &latents, &recorded).unwrap()
    };
    let (still, moved) = (score(0.0), score(1.0));
    assert_eq!((still.coverage_95, still.log_density), (moved.coverage_95, moved.log_density));
    assert!(moved.mse > still.mse + 0.1);
    // The other numbers by hand.
    let frames: Vec<_> = filter.frames(0, &latents).map(Result::unwrap).collect();
    let row = |t: usize| y[0].row(t).iter().copied().collect::<Vec<f64>>();
    let mean = |of: &dyn Fn(usize, usize) -> f64| (0..100).map(|k| of(k / 5, k % 5)).sum::<f64>() / 100.0;
    assert_relative_eq!(still.mse, mean(&|t, c| (row(t)[c] - frames[t].mean[c]).powi(2)), epsilon = 1e-12);
    assert_relative_eq!(still.mse_mean_pose, mean(&|t, c| row(t)[c].powi(2)), epsilon = 1e-12);
    let densities = (0..20).map(|t| frames[t].log_density(&row(t), &[0, 1, 2, 3]).unwrap());
    assert_relative_eq!(still.log_density, densities.sum::<f64>() / 20.0, epsilon = 1e-12);
}

#[test]
fn an_observed_part_says_something_about_the_others_and_about_earlier_frames() {
    let model = fitted(1);
    let filter = filter_of(&model);
    let mut belief = filter.predict(&near(&model, 0, 0.3)).unwrap();
    let before = belief.clone();
    let row = [vec![0.3, -0.2, 0.1, 0.4], vec![f64::NAN; 6]];
    let density = filter.correct(&mut belief, 0, &row).unwrap();
    assert!(density.is_finite() && density < 0.0);
    for (part, lag) in [(0, 0), (0, 1), (1, 0)] {
        let variance = |belief: &Belief| filter.latents(belief, part, lag).1.trace();
        assert!(variance(&belief) < variance(&before), "part {part}, {lag} frames ago");
        assert_ne!(filter.latents(&belief, part, lag).0, filter.latents(&before, part, lag).0);
    }
}

#[test]
fn a_clamped_part_is_as_if_it_were_observed_without_noise() {
    let model = fitted(1);
    let filter = filter_of(&model);
    let predicted = filter.predict(&near(&model, 0, 0.3)).unwrap();
    let mut belief = predicted.clone();
    filter.clamp(&mut belief, 0, &[0.2, -0.4]).unwrap();
    let (mean, covariance) = filter.latents(&belief, 0, 0);
    assert_eq!((mean.as_slice(), covariance.amax()), (&[0.2, -0.4][..], 0.0));
    // The textbook's conditional of a Gaussian.
    let places: Vec<usize> = filter.places(0, 0).collect();
    let of = |rows: &[usize], columns: &[usize]| {
        DMatrix::from_fn(rows.len(), columns.len(), |a, b| predicted.covariance[(rows[a], columns[b])])
    };
    let rest: Vec<usize> = (0..predicted.mean.len()).filter(|k| !places.contains(k)).collect();
    let gain = of(&rest, &places) * of(&places, &places).try_inverse().unwrap();
    let change = DVector::from_fn(2, |k, _| [0.2, -0.4][k] - predicted.mean[places[k]]);
    let expected = of(&rest, &rest) - &gain * of(&places, &rest);
    let shift = &gain * change;
    for (k, &place) in rest.iter().enumerate() {
        assert_relative_eq!(belief.mean[place], predicted.mean[place] + shift[k], epsilon = 1e-10);
        for (l, &other) in rest.iter().enumerate() {
            assert_relative_eq!(belief.covariance[(place, other)], expected[(k, l)], epsilon = 1e-10);
        }
    }
    // The next frame follows from a belief without variance too.
    assert!(filter.predict(&belief).unwrap().mean.iter().all(|x| x.is_finite()));
}

#[test]
fn columns_at_uncertain_latents_are_those_of_drawn_latents() {
    let model = without_column_noise(fitted(3));
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    for map in &filter_of(&model).poses {
        let (q, all) = (map.latent(), (0..map.columns()).collect::<Vec<_>>());
        let root = DMatrix::from_fn(q, q, |a, b| if b > a { 0.0 } else { 0.5 - 0.2 * (a + b) as f64 });
        let mean = DVector::from_fn(q, |a, _| 0.3 - a as f64);
        let (draws, mut of, mut square) =
            (40_000, DVector::zeros(all.len()), DMatrix::zeros(all.len(), all.len()));
        for _ in 0..draws {
            let x = &mean + &root * DVector::from_fn(q, |_, _| normal(&mut rng));
            let at = map.tangent(x.as_slice(), &all);
            let values = DVector::from_vec(at.values);
            of += &values / f64::from(draws);
            square += &values * values.transpose() / f64::from(draws);
            square += DMatrix::identity(all.len(), all.len()) * (at.variance / f64::from(draws));
        }
        let found = map.moments(&mean, &(&root * root.transpose())).unwrap();
        assert_relative_eq!(found.mean, of, epsilon = 0.03);
        let covariance = square - &of * of.transpose();
        assert_relative_eq!(found.covariance, covariance, epsilon = 0.03);
        let error = DVector::from_fn(all.len(), |c, _| 0.2 + c as f64);
        let row = (&found.mean + &error).as_slice().to_vec();
        let inverse = found.covariance.clone().try_inverse().unwrap();
        let density = -0.5 * (error.dot(&(inverse * &error)) + (&found.covariance * TAU).determinant().ln());
        assert_relative_eq!(found.log_density(&row, &all).unwrap(), density, epsilon = 1e-9);
    }
}

#[test]
fn finds_the_place_of_the_training_where_a_recording_starts() {
    let model = trained(2).0;
    let filter = filter_of(&model);
    for frame in [3, 9, 14] {
        // One part of a training sequence from this frame on.
        let latents: Vec<DMatrix<f64>> =
            model.starts[0].iter().map(|x| x.rows(frame, 12).into_owned()).collect();
        let y = without(&model.observations(&latents), 1);
        let run = filter.run_from_best(&y, 8).unwrap();
        let found = filter.smoothed(&run).unwrap();
        for part in 0..2 {
            let spread = (model.starts[0][part].row_variance().sum()).sqrt();
            let apart =
                (&found.means[part] - &latents[part]).row_iter().map(|row| row.norm()).sum::<f64>() / 12.0;
            assert!(apart < 0.3 * spread, "frame {frame}, part {part}: {apart} of {spread}");
        }
        let best = filter.run_from_best(&y, 12).unwrap().evidence();
        let starts = filter.starts(&y, 8);
        let evidences = starts.iter().map(|start| filter.run(start.clone(), &y).unwrap().evidence());
        assert_eq!(best, evidences.fold(f64::NEG_INFINITY, f64::max));
        // A window has a whole history, and begins where something is observed.
        let mut late = y.clone();
        late[0].rows_mut(0, 3).fill(f64::NAN);
        assert_eq!([0, 4, 20].map(|window| filter.first_window(&late, window)[0].nrows()), [3, 7, 12]);
        let evidence = [0, 2].map(|window| filter.run_from_best(&y, window).unwrap().evidence());
        assert_eq!(evidence[0], evidence[1]);
        // The nearest place comes first, with a tenth of the covariance of all histories.
        let history = |k: usize, frame: usize| -> DVector<f64> {
            let parts = model.start(k, frame).unwrap();
            DVector::from_vec(parts.iter().flat_map(|x| x.transpose().as_slice().to_vec()).collect())
        };
        assert_eq!(starts[0].mean, history(0, frame));
        let places = (0..2).flat_map(|k| (0..LENGTHS[k] - 1).map(move |frame| (k, frame)));
        let all: Vec<DVector<f64>> = places.map(|(k, frame)| history(k, frame)).collect();
        let mean: DVector<f64> = all.iter().sum::<DVector<f64>>() / all.len() as f64;
        let squares = all.iter().map(|h| (h - &mean) * (h - &mean).transpose()).sum::<DMatrix<f64>>();
        let expected = squares * (0.1 / all.len() as f64) + DMatrix::identity(8, 8) * 1e-3;
        assert_relative_eq!(starts[0].covariance, expected, epsilon = 1e-9);
        // Of neighbours, one start is tried.
        let is_start =
            |&frame: &usize| starts.iter().any(|start| start.mean == near(&model, frame, 0.0).mean);
        let frames: Vec<usize> = (0..LENGTHS[0] - 1).filter(is_start).collect();
        assert!(frames.len() > 1 && frames.windows(2).all(|pair| pair[1] - pair[0] >= 3), "{frames:?}");
    }
}

#[test]
fn refuses_columns_that_do_not_fit() {
    let filter = filter_of(&fitted(1));
    let y =
        |frames: usize, columns: [usize; 2]| columns.map(|d| DMatrix::from_element(frames, d, 0.1)).to_vec();
    assert!(filter.run_from_best(&y(2, [4, 6]), 4).is_ok());
    let refused = |y: &[DMatrix<f64>]| filter.run_from_best(y, 4).unwrap_err().to_string();
    assert_eq!(refused(&y(5, [4, 6])[..1]), "expected columns of 2 parts, found 1");
    assert_eq!(refused(&y(5, [4, 5])), "expected 6 numbers of part 1 in a frame, found 5");
    assert_eq!(
        refused(&y(1, [4, 6])),
        "expected at least 2 frames, one for each latent state of a history, found 1"
    );
    let mut lengths = y(5, [4, 6]);
    lengths[1] = DMatrix::zeros(4, 6);
    assert_eq!(refused(&lengths), "expected 5 frames of part 1 as of part 0, found 4");
    let mut infinite = y(5, [4, 6]);
    infinite[1][(3, 2)] = f64::INFINITY;
    assert_eq!(refused(&infinite), "expected finite numbers of part 1 or none, found inf in frame 3");
    let mut belief = filter.unknown();
    assert!(filter.clamp(&mut belief, 5, &[1.0]).is_err());
    assert!(filter.correct(&mut belief, 0, &[vec![1.0; 3], vec![1.0; 6]]).is_err());
}
