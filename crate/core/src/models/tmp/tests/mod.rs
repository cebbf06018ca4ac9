//! The bound against quadrature, its rise in every update, and the learned primitives.

mod posterior;

use super::*;
use crate::models::Learner;
use crate::models::data::movements::{Movements, Sequence};
use crate::models::data::phase::Alignment;
use crate::models::rollout::request::{Handles, PosePush};
use crate::models::tmp::learner::Limits;
use crate::models::tmp::partial_trial::PartialTrial;
use crate::models::tmp::posterior::Posterior;
use crate::models::tmp::trial_features::TrialFeatures;
use crate::models::training::interface::Training;
use crate::models::training::progress::EndReason;
use crate::models::training::settings::TmpSettings;
use approx::assert_relative_eq;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::{PI, TAU};

fn noise(rng: &mut ChaCha8Rng) -> f64 {
    StandardNormal.sample(rng)
}

/// Trials of the model: two primitives, weights around a mean, noise; rhythmic or not; the last is partial.
fn problem(seed: u64, rhythmic: bool) -> Vec<Trial> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let columns = 4;
    let mean = DMatrix::from_fn(columns, 2, |_, _| noise(&mut rng));
    let mut trials = Vec::new();
    for (s, frames) in [40, 47, 52, 5].into_iter().enumerate() {
        let weights = mean.map(|w| w + 0.2 * noise(&mut rng));
        let (period, start) = (16.0 + 0.3 * s as f64, 0.3 * s as f64);
        let y = DMatrix::from_fn(frames, columns, |t, k| {
            let phase = if rhythmic { t as f64 / period + start } else { t as f64 / 50.0 };
            let m = if rhythmic {
                [(TAU * phase).sin(), (2.0 * TAU * phase).cos()]
            } else {
                [(6.0 * (phase - 0.5)).tanh(), (-20.0 * (phase - 0.4).powi(2)).exp()]
            };
            m[0] * weights[(k, 0)] + m[1] * weights[(k, 1)] + 0.05 * noise(&mut rng)
        });
        trials.push(Trial { y, whole: s < 3 });
    }
    trials
}

fn movements(trials: &[Trial]) -> Movements {
    let sequences = trials.iter().map(|t| Sequence { frames: t.y.nrows(), whole: t.whole }).collect();
    let rows: Vec<_> = trials.iter().flat_map(|t| t.y.row_iter().map(|r| r.into_owned())).collect();
    let all = DMatrix::from_rows(&rows);
    Movements { y: vec![all.columns(0, 3).into_owned(), all.columns(3, 1).into_owned()], sequences }
}

#[test]
fn no_update_lowers_the_bound() {
    for seed in 0..6 {
        let mut trials = problem(seed, seed % 2 == 0);
        trials.pop();
        let alignment = Alignment::new(&trials, None);
        let groups: &[usize] = if seed < 3 { &[1, 1, 1, 1] } else { &[3, 1] };
        let expected = if seed % 2 == 0 { PhaseAxis::Cycle } else { PhaseAxis::Trial };
        assert_eq!(alignment.axis, expected);
        for count in [1, 3] {
            let mut posterior = Posterior::start(&trials, &alignment, groups, count, seed == 3).unwrap();
            let mut bound = posterior.bound(&trials).unwrap();
            let first = bound;
            for sweep in 0..24 {
                for update in 0..5 {
                    match update {
                        0 => posterior.update_primitives().unwrap(),
                        1 => posterior.update_weights().unwrap(),
                        2 => posterior.update_hyperparameters(&trials).unwrap(),
                        3 if sweep % 4 == 3 => {
                            posterior.update_lengthscale(&trials, 1.2).unwrap();
                        }
                        4 if sweep % 4 == 3 => posterior.update_phases(&trials, 0.01),
                        _ => {}
                    }
                    let next = posterior.bound(&trials).unwrap();
                    assert!(
                        next >= bound - 1e-9 * bound.abs(),
                        "seed {seed}, Q {count}, sweep {sweep}, update {update}: {bound} -> {next}"
                    );
                    bound = next;
                }
            }
            assert!(bound > first + 10.0, "seed {seed}, Q {count}: {first} -> {bound}");
        }
    }
}

#[test]
fn one_more_primitive_keeps_the_determinant_of_the_covariance() {
    let mut trials = problem(4, false);
    trials.pop();
    let alignment = Alignment::new(&trials, None);
    let one = Posterior::start(&trials, &alignment, &[4], 1, false).unwrap();
    let two = one.with_one_more(&trials).unwrap();
    let log_determinant = nalgebra::Cholesky::new(two.v_covariance.clone()).unwrap().ln_determinant();
    let size = two.v.len() as f64;
    let divergence = 0.5 * (two.v.norm_squared() + two.v_covariance.trace() - size - log_determinant);
    assert_relative_eq!(two.divergence(), divergence, max_relative = 1e-9);
}

/// The phases move by the part of the bound that depends on them, which must rank moves as the whole bound does.
#[test]
fn phases_move_where_the_bound_rises() {
    for rhythmic in [true, false] {
        let mut trials = problem(4, rhythmic);
        trials.pop();
        let alignment = Alignment::new(&trials, None);
        let mut posterior = Posterior::start(&trials, &alignment, &[3, 1], 3, false).unwrap();
        for _ in 0..4 {
            posterior.update_primitives().unwrap();
            posterior.update_weights().unwrap();
            posterior.update_hyperparameters(&trials).unwrap();
        }
        let mut moves = 0;
        for step in [0.03, 0.01, 0.003, 0.001] {
            let mut expected = posterior.clone();
            for (s, trial) in trials.iter().enumerate() {
                for (shift, stretch) in [(step, 0.0), (-step, 0.0), (0.0, 2.0 * step), (0.0, -2.0 * step)] {
                    let mut moved = expected.clone();
                    moved.maps[s] = moved.maps[s].moved(trial.y.nrows(), shift, stretch);
                    moved.features[s] = TrialFeatures::new(&moved.kernel, trial, &moved.maps[s]);
                    if moved.bound(&trials).unwrap() > expected.bound(&trials).unwrap() {
                        expected = moved;
                        moves += 1;
                    }
                }
            }
            posterior.update_phases(&trials, step);
            assert_eq!(posterior.maps, expected.maps, "{step}");
        }
        assert!(moves > 3, "{moves} moves");
    }
}

/// Gauss-Hermite nodes and weights for N(0, 1): exact for polynomials up to degree 7.
const NODES: [(f64, f64); 4] = [
    (-2.334_414_218_338_977_3, 0.045_875_854_768_068_49),
    (-0.741_963_784_302_725_9, 0.454_124_145_231_931_5),
    (0.741_963_784_302_725_9, 0.454_124_145_231_931_5),
    (2.334_414_218_338_977_3, 0.045_875_854_768_068_49),
];

fn log_normal(x: f64, mean: f64, variance: f64) -> f64 {
    -0.5 * ((2.0 * PI * variance).ln() + (x - mean).powi(2) / variance)
}

/// Means of the primitives at `phases` [T x Q] and the covariance of the first one there [T x T].
fn primitive(posterior: &Posterior, phases: &[f64]) -> (DMatrix<f64>, DMatrix<f64>) {
    let (p, r) = (posterior.kernel.features(phases), posterior.v.nrows());
    let left = DMatrix::identity(phases.len(), phases.len())
        - DMatrix::from_diagonal(&(&p * p.transpose()).diagonal());
    let covariance = &p * posterior.v_covariance.view((0, 0), (r, r)) * p.transpose() + left;
    (&p * &posterior.v, covariance)
}

#[test]
fn the_bound_is_the_expected_log_joint_plus_entropies() {
    // One column, one primitive, one trial of four frames: the expectation of the log joint is one of
    // polynomials, which quadrature over every single Gaussian variable gives exactly.
    let y = DMatrix::from_column_slice(4, 1, &[0.4, -0.3, 0.9, 0.2]);
    let trials = [Trial { y, whole: true }];
    let maps = vec![PhaseMap { start: 0.05, rate: 0.3 }];
    let alignment = Alignment { axis: PhaseAxis::Trial, maps: maps.clone() };
    let mut posterior = Posterior::start(&trials, &alignment, &[1], 1, false).unwrap();
    for _ in 0..3 {
        posterior.update_primitives().unwrap();
        posterior.update_weights().unwrap();
        posterior.update_hyperparameters(&trials).unwrap();
    }
    let phases: Vec<f64> = (0..4).map(|t| maps[0].at(t)).collect();
    let (noise, scale) = (posterior.noise[0], posterior.scale[0]);
    let (centre_variance, spread) = (scale * posterior.relevance[0], scale * posterior.spread[(0, 0)]);

    // q(mu, w) written out from its own precision matrix, at the posterior's E[m^2] and E[m].
    let (m, covariance) = primitive(&posterior, &phases);
    posterior.update_weights().unwrap();
    let precision = 1.0 / spread;
    let energy: f64 = (0..4).map(|t| m[(t, 0)].powi(2) + covariance[(t, t)]).sum();
    let joint = DMatrix::from_row_slice(
        2,
        2,
        &[1.0 / centre_variance + precision, -precision, -precision, precision + energy / noise],
    );
    let joint_covariance = joint.try_inverse().unwrap();
    let projection = m.column(0).dot(&trials[0].y.column(0)) / noise;
    let mean = &joint_covariance * nalgebra::dvector![0.0, projection];
    let root = nalgebra::Cholesky::new(joint_covariance.clone()).unwrap().l();

    let mut expectation = 0.0;
    for (a, wa) in NODES {
        for (b, wb) in NODES {
            let mu = mean[0] + root[(0, 0)] * a;
            let w = mean[1] + root[(1, 0)] * a + root[(1, 1)] * b;
            let mut log = log_normal(mu, 0.0, centre_variance) + log_normal(w, mu, spread);
            for t in 0..4 {
                let root = covariance[(t, t)].sqrt();
                for (c, wc) in NODES {
                    log += wc * log_normal(trials[0].y[t], w * (m[(t, 0)] + root * c), noise);
                }
            }
            expectation += wa * wb * log;
        }
    }
    expectation += 0.5 * (2.0 * (TAU * std::f64::consts::E).ln() + joint_covariance.determinant().ln());
    expectation -= posterior.divergence();
    let bound = posterior.bound(&trials).unwrap();
    assert_relative_eq!(bound, expectation, epsilon = 1e-9);

    // It is below the log evidence, with w integrated numerically and m in closed form.
    let total = centre_variance + spread;
    let k = DMatrix::from_fn(4, 4, |a, b| {
        kernel::covariance(PhaseAxis::Trial, posterior.kernel.lengthscale, phases[a] - phases[b])
    });
    let (mut evidence, step) = (0.0, 0.01);
    for i in -800..=800 {
        let z = step * f64::from(i);
        let covariance = &k * (total * z * z) + DMatrix::identity(4, 4) * noise;
        let quadratic = trials[0].y.dot(&(covariance.clone().try_inverse().unwrap() * &trials[0].y));
        let log = -0.5 * (4.0 * TAU.ln() + covariance.determinant().ln() + quadratic);
        evidence += step * (log - 0.5 * z * z).exp() / TAU.sqrt();
    }
    let evidence = evidence.ln();
    assert!(bound < evidence && evidence - bound < 2.0, "bound {bound}, log evidence {evidence}");
}

/// Two slow primitives have a long lengthscale, which kept faster primitives at 0 in the search.
#[test]
#[ignore = "seldom: npm test -- --all"]
fn the_search_is_no_worse_than_any_number_alone() {
    for (seed, size) in [(2, 0.02), (3, 0.05), (4, 0.0)] {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let y = DMatrix::from_fn(120, 6, |t, k| {
            let phase = TAU * t as f64 / 39.0;
            let clean = match k {
                2 => 0.5 * (2.0 * phase).sin(),
                5 => 0.3 * (2.0 * phase).cos(),
                k => (phase + k as f64).sin(),
            };
            clean + size * noise(&mut rng)
        });
        let sequences = vec![Sequence { frames: 120, whole: true }];
        let movements = Movements { y: vec![y], sequences };
        let bound = |primitives| {
            let settings = TmpSettings { primitives, ..TmpSettings::default() };
            let mut learner = TmpLearner::new(&movements, &settings).unwrap();
            while !learner.step().done {}
            learner.fitted().unwrap().bound
        };
        let found = bound(None);
        for alone in [3, 4] {
            assert!(found >= bound(Some(alone)), "{size}: {found}, {alone} alone: {}", bound(Some(alone)));
        }
    }
}

#[test]
fn finds_the_number_of_primitives_and_predicts_a_partial_trial() {
    for rhythmic in [true, false] {
        let trials = problem(8, rhythmic);
        let limits = Limits { most_primitives: 5, max_sweeps: 150 };
        let settings = TmpSettings::default();
        let mut learner = TmpLearner::within(&movements(&trials), &settings, limits).unwrap();
        let mut best = f64::NEG_INFINITY;
        while !learner.progress().done {
            let progress = learner.step();
            assert!(progress.best >= best && progress.objective.is_finite() && progress.fraction <= 1.0);
            best = progress.best;
        }
        let model = learner.fitted().unwrap();
        assert_eq!(model.centre.ncols(), 2, "{:?}", model.bounds);
        assert_eq!(learner.progress().reason, Some(EndReason::MorePrimitivesAreWorse { best: 2 }));
        // The best bound is that of the whole trials; the model's bound includes the partial trial.
        assert!(model.bounds.contains(&(2, best)), "{best}: {:?}", model.bounds);
        assert!(model.bound > best, "{} {best}", model.bound);
        assert!(model.noise.iter().all(|n| (0.03..0.08).contains(&n.sqrt())), "{}", model.noise);
        // A training trial is reproduced up to its noise.
        let y = model.rollout(0, 40, &Handles::default()).unwrap();
        let difference = &y[0] - trials[0].y.columns(0, 3);
        assert!((difference.norm_squared() / difference.len() as f64).sqrt() < 0.07, "{difference}");
        let stored = model.inducing.len() * 2 + 4 * 2 + if rhythmic { 3 } else { 5 };
        assert_eq!(model.stored_numbers(), stored);
        // A push is over in the next frame; half the tempo takes twice as long, within the range of the phases.
        let push = Some(PosePush { frame: 7, by: vec![1.0; 4] });
        let pushed = model.rollout(0, 40, &Handles { push, ..Handles::default() }).unwrap();
        let off = &pushed[0] - &y[0];
        assert!(off.row(7).add_scalar(-1.0).amax() < 1e-12 && off.remove_row(7).amax() == 0.0);
        let half = model.rollout(0, 39, &Handles { tempo: 0.5, ..Handles::default() }).unwrap();
        assert!((half[0].row(38) - y[0].row(19)).amax() < 1e-9);
        // Twice the tempo, with more frames than the trial has.
        let [once, twice] = [1.0, 2.0].map(|tempo| {
            model.rollout(0, 81, &Handles { tempo, ..Handles::default() }).unwrap().swap_remove(0)
        });
        assert!((twice.row(20) - once.row(40)).amax() < 1e-9);
        assert!(rhythmic || (twice.row(40) - twice.row(80)).amax() < 1e-9);
        let goal = Handles { goal: Some(vec![0.0; 4]), ..Handles::default() };
        assert_eq!(model.rollout(0, 40, &goal), Err(RolloutError::NoGoal));
        // The rollout of the partial trial starts as its five frames.
        let y = model.rollout(3, 60, &Handles::default()).unwrap();
        let start = y[0].rows(0, 5) - trials[3].y.columns(0, 3);
        assert!(start.amax() < 0.25, "{start}");
        assert!(
            model.rollout(4, 60, &Handles::default()).is_err()
                && model.rollout(3, 0, &Handles::default()).is_err()
        );
    }
}

#[test]
fn still_and_single_trials_give_finite_models() {
    let still = vec![Trial { y: DMatrix::zeros(20, 3), whole: true }];
    let mut moving = problem(2, true);
    moving.truncate(1);
    for trial in &mut moving {
        trial.y.column_mut(1).fill(0.0);
    }
    for trials in [still, moving] {
        let d = trials[0].y.ncols();
        let sequences = vec![Sequence { frames: trials[0].y.nrows(), whole: true }];
        let movements = Movements { y: vec![trials[0].y.clone()], sequences };
        let limits = Limits { most_primitives: 3, max_sweeps: 20 };
        let mut learner = TmpLearner::within(&movements, &TmpSettings::default(), limits).unwrap();
        while !learner.step().done {}
        let y = learner.model().unwrap().rollout(0, 30).unwrap();
        assert!(y[0].shape() == (30, d) && y[0].iter().all(|v| v.is_finite()));
        assert!(y[0].column(1).amax() < 1e-3);
    }
    let partial =
        Movements { y: vec![DMatrix::zeros(5, 1)], sequences: vec![Sequence { frames: 5, whole: false }] };
    let error = TmpLearner::new(&partial, &TmpSettings::default()).err().unwrap().to_string();
    assert_eq!(error, "expected at least one whole movement to learn from, found none");
    let error = TmpLearner::new(&partial, &TmpSettings { primitives: Some(0), ..TmpSettings::default() })
        .err()
        .unwrap()
        .to_string();
    assert_eq!(error, "the number of primitives must be from 1 to 40, found 0");
}

/// A brisk walk among slower ones needs a combination of weights that no whole trial has. When the model
/// learned V from its first frames too, that combination became likely, and the prediction was a hundred
/// times larger than any trial.
#[test]
#[ignore = "seldom: npm test -- --all"]
fn an_unusual_partial_trial_gives_no_extreme_prediction() {
    for seed in 0..4 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let columns = 12;
        let mean = DMatrix::from_fn(columns, 4, |_, _| noise(&mut rng));
        let mut trials = Vec::new();
        // The last trial is faster by a third, swings further, and has five frames.
        for (s, (frames, period, swing)) in
            [(70, 36.0, 1.0), (76, 38.0, 0.95), (64, 34.0, 1.05), (60, 26.0, 1.4)].into_iter().enumerate()
        {
            let weights = mean.map(|w| swing * w + 0.1 * noise(&mut rng));
            let y = DMatrix::from_fn(frames, columns, |t, k| {
                let phase = TAU * (t as f64 / period + 0.3 * s as f64);
                let m = [phase.sin(), phase.cos(), 0.4 * (2.0 * phase).sin(), 0.3 * (3.0 * phase).cos()];
                (0..4).map(|q| m[q] * weights[(k, q)]).sum::<f64>() + 0.02 * noise(&mut rng)
            });
            trials.push(Trial { y, whole: s < 3 });
        }
        let actual = trials[3].y.clone();
        trials[3].y = actual.rows(0, 5).into_owned();
        let sequences = trials.iter().map(|t| Sequence { frames: t.y.nrows(), whole: t.whole }).collect();
        let rows: Vec<_> = trials.iter().flat_map(|t| t.y.row_iter().map(|r| r.into_owned())).collect();
        let movements = Movements { y: vec![DMatrix::from_rows(&rows)], sequences };
        for normalised_time in [false, true] {
            let settings = TmpSettings { primitives: Some(6), normalised_time };
            let mut learner = TmpLearner::new(&movements, &settings).unwrap();
            while !learner.step().done {}
            let predicted = learner.model().unwrap().rollout(3, actual.nrows()).unwrap().swap_remove(0);
            // At a wrong speed, the prediction may be in antiphase; a swing of the same size then has up to
            // four times this error.
            let still = actual.norm_squared();
            let error = (&predicted - &actual).norm_squared();
            assert!(error < 4.0 * still, "seed {seed}: {:.2} times a motionless prediction", error / still);
            let furthest = trials.iter().map(|trial| trial.y.amax()).fold(0.0, f64::max);
            assert!(predicted.amax() < 1.5 * furthest, "seed {seed}: {} {furthest}", predicted.amax());
        }
    }
}

/// The trials of [`problem`] without the partial one, the partial one, and the primitives with which learning of the
/// others begins.
fn with_partial(seed: u64, rhythmic: bool, primitives: usize) -> (Vec<Trial>, Trial, Posterior) {
    let mut trials = problem(seed, rhythmic);
    let partial = trials.pop().unwrap();
    let alignment = Alignment::new(&trials, None);
    let posterior = Posterior::start(&trials, &alignment, &[3, 1], primitives, false).unwrap();
    (trials, partial, posterior)
}

#[test]
fn whitened_frames_have_the_density_of_frames_with_correlated_noise() {
    let (trials, partial, posterior) = with_partial(2, true, 2);
    let correlations = posterior.residual_correlations(&trials, 5);
    let all = DMatrix::from_fn(5, 5, |a, b| correlations[a.abs_diff(b)] + if a == b { 1e-3 } else { 0.0 });
    let trial = PartialTrial::new(&posterior, &trials, &partial).unwrap();
    // Half the logarithm for each of four columns.
    assert_relative_eq!(trial.log_determinant(), 2.0 * all.determinant().ln(), epsilon = 1e-9);
}

#[test]
fn no_start_near_that_of_a_partial_trial_is_likelier() {
    for rhythmic in [true, false] {
        let (trials, partial, posterior) = with_partial(2, rhythmic, 2);
        let trial = PartialTrial::new(&posterior, &trials, &partial).unwrap();
        let best = trial.best_map().unwrap();
        let most = trial.value(&best).unwrap();
        for shift in [-1e-2, -1e-3, 1e-3, 1e-2] {
            let other = trial.value(&PhaseMap { start: best.start + shift, ..best }).unwrap();
            assert!(other < most, "{rhythmic}, {shift}: {other} {most}");
        }
    }
}

#[test]
fn in_normalised_time_all_trials_have_the_same_weights() {
    let trials = problem(3, false);
    let settings = TmpSettings { primitives: Some(2), normalised_time: true };
    let mut learner = TmpLearner::new(&movements(&trials), &settings).unwrap();
    while !learner.step().done {}
    let model = learner.fitted().unwrap();
    assert_eq!(model.axis, PhaseAxis::Trial);
    assert!(model.trials.iter().all(|trial| trial.weights == model.trials[0].weights));
    for (trial, found) in trials.iter().zip(&model.trials).filter(|(trial, _)| trial.whole) {
        assert_eq!(found.map, PhaseMap { start: 0.0, rate: 1.0 / (trial.y.nrows() - 1) as f64 });
    }
    // The partial trial has the mean rate of the others.
    assert_relative_eq!(model.trials[3].map.rate, (1.0 / 39.0 + 1.0 / 46.0 + 1.0 / 51.0) / 3.0);
}
