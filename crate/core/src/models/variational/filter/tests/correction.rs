//! A latent that is corrected by a value: on a hill, where a whole step leads too far.

use super::*;

/// The mean of a latent on the flank of a hill, exp(-x^2 / 2), that is corrected by a value with this weight.
fn corrected_on_a_hill(value: f64, weight: f64) -> f64 {
    let one = |value: f64| DMatrix::from_element(1, 1, value);
    let kernel = Kernel { lambda: DVector::from_element(1, 1.0), variance: 1.0 };
    let hill = PoseMap::new(one(0.0), kernel, 0.1, one(1.0), one(1.0), 0.0).unwrap();
    let map = crate::models::variational::filter::pose_process::PoseProcess::new(&hill, 0.0).unwrap();
    let mut belief = Belief { mean: DVector::from_element(1, 2.0), covariance: one(4.0) };
    let part = Observed { map: &map, weight, places: vec![0], columns: vec![0], values: vec![value] };
    correct(&mut belief, &[part]).unwrap();
    belief.mean[0]
}

/// A whole step towards a value above the hill leads far beyond the hill.
#[test]
fn a_step_that_would_make_the_error_larger_is_halved() {
    let found = corrected_on_a_hill(2.0, 100.0);
    assert!(found.abs() < 0.1, "{found}");
}

#[test]
fn a_value_without_noise_is_met_exactly() {
    let found = corrected_on_a_hill(0.5, 1e12);
    assert_relative_eq!(found, (2.0 * 2.0_f64.ln()).sqrt(), epsilon = 1e-6);
}
