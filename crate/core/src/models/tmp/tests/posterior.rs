//! Starts of partial trials, and what a posterior makes of residuals, relevances and phases.

use super::*;

#[test]
fn on_a_cycle_a_start_one_cycle_later_is_as_likely() {
    let (trials, partial, posterior) = with_partial(2, true, 2);
    let trial = PartialTrial::new(&posterior, &trials, &partial).unwrap();
    let value = |start: f64| trial.value(&PhaseMap { start, rate: 0.06 }).unwrap();
    assert_relative_eq!(value(0.3), value(1.3), epsilon = 1e-9);
}

#[test]
fn the_value_of_a_start_is_an_integral_over_the_weights() {
    let (trials, partial, posterior) = with_partial(3, true, 1);
    let trial = PartialTrial::new(&posterior, &trials, &partial).unwrap();
    let map = PhaseMap { start: 0.2, rate: 0.06 };
    let features = trial.features(&map);
    let energy = posterior.energy(&features)[(0, 0)];
    let mut expected = 0.0;
    for (k, weights) in posterior.weights.iter().enumerate() {
        let y = trial.whitened().y.column(k);
        let projection = posterior.v.column(0).dot(&features.projected.column(k));
        let (mean, noise) = (weights.centre[0], posterior.noise[k]);
        // The weights of the other trials are around their mean by V c_k.
        let uncertain = weights.centre_second[(0, 0)] - mean * mean;
        let deviation = (uncertain + posterior.spread[(0, 0)] * posterior.scale[k]).sqrt();
        let (mut sum, step) = (0.0, 0.002);
        for i in -4000..=4000 {
            let z = step * f64::from(i);
            let w = mean + deviation * z;
            let squares = y.norm_squared() - 2.0 * w * projection + w * w * energy;
            let log = -0.5 * (5.0 * (TAU * noise).ln() + squares / noise + z * z);
            sum += step * log.exp() / TAU.sqrt();
        }
        expected += sum.ln();
    }
    assert_relative_eq!(trial.value(&map).unwrap(), expected, epsilon = 1e-6);
}

/// Two shapes, and weights of the same size in every trial.
fn two_shapes() -> Vec<Trial> {
    let y = DMatrix::from_fn(40, 4, |t, k| {
        let phase = TAU * t as f64 / 20.0;
        phase.sin() + if k % 2 == 0 { 0.3 } else { -0.3 } * (2.0 * phase).cos()
    });
    vec![Trial { y: y.clone(), whole: true }, Trial { y, whole: true }]
}

#[test]
fn one_more_primitive_is_what_the_others_do_not_explain() {
    let trials = two_shapes();
    let maps = vec![PhaseMap { start: 0.0, rate: 0.05 }; 2];
    let alignment = Alignment { axis: PhaseAxis::Cycle, maps };
    let one = Posterior::start(&trials, &alignment, &[4], 1, false).unwrap();
    let two = one.with_one_more(&trials).unwrap();
    let (shapes, _) = primitive(&two, &(0..20).map(|t| 0.05 * f64::from(t)).collect::<Vec<_>>());
    let like = |q: usize, wave: &dyn Fn(f64) -> f64| {
        let wave = DMatrix::from_fn(20, 1, |t, _| wave(TAU * t as f64 / 20.0));
        shapes.column(q).dot(&wave).abs() / (shapes.column(q).norm() * wave.norm())
    };
    assert!(like(0, &f64::sin) > 0.99 && like(1, &|phase| (2.0 * phase).cos()) > 0.99, "{shapes}");
    // The sizes of the new weights are shares: they do not depend on the unit of the columns.
    let large: Vec<Trial> = trials.iter().map(|t| Trial { y: &t.y * 100.0, whole: true }).collect();
    let other = Posterior::start(&large, &alignment, &[4], 1, false).unwrap();
    let other = other.with_one_more(&large).unwrap();
    assert_relative_eq!(other.relevance, two.relevance, max_relative = 1e-9);
}

#[test]
fn correlations_of_residuals_count_every_column_in_units_of_its_noise() {
    // Without primitives, all is residual: one column turns back in each frame, the other stays.
    let y = DMatrix::from_fn(10, 2, |t, k| if k == 1 { 2.0 } else { [1.0, -1.0][t % 2] });
    let trials = [Trial { y, whole: true }];
    let mut posterior =
        Posterior::start(&trials, &Alignment::normalised_time(&trials), &[1, 1], 1, false).unwrap();
    posterior.v.fill(0.0);
    posterior.noise = nalgebra::dvector![0.1, 0.4];
    let found = posterior.residual_correlations(&trials, 4);
    for (found, expected) in found.iter().zip([1.0, 0.0, 0.8, 0.0]) {
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    }
}

#[test]
fn phases_never_stop() {
    // The second trial stays where the first has its highest value.
    let wave = |t: usize| (TAU * t as f64 / 20.0).sin();
    let y = [DMatrix::from_fn(41, 1, |t, _| wave(t)), DMatrix::from_element(5, 1, 1.0)];
    let trials = y.map(|y| Trial { y, whole: true });
    let step = 1.0 / 64.0;
    let slow = PhaseMap { start: 0.25 - step, rate: 2.0 * step / 4.0 };
    let alignment =
        Alignment { axis: PhaseAxis::Cycle, maps: vec![PhaseMap { start: 0.0, rate: 0.05 }, slow] };
    let mut posterior = Posterior::start(&trials, &alignment, &[1], 1, false).unwrap();
    for _ in 0..10 {
        posterior.update_primitives().unwrap();
        posterior.update_weights().unwrap();
        posterior.update_hyperparameters(&trials).unwrap();
    }
    posterior.update_phases(&trials, step);
    assert!(posterior.maps.iter().all(|map| map.rate > 0.0), "{:?}", posterior.maps);
}
