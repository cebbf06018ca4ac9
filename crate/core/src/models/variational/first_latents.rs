//! The first latents of a training: slow ones, scaled by their share of the data.

use crate::elementary::Elementary;
use crate::models::data::sequences::Sequences;
use crate::models::training::latents::{STAND_IN, principal_components};
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;

/// The Gaussian is cut off at this number of standard deviations.
const REACH: f64 = 4.0;

/// The first `count` principal components [N x count] of the columns `y` [N x D], smoothed along time. The
/// first has unit variance; the others are smaller in proportion to their share in the columns.
///
/// Dynamics need latents from which the next frame can be predicted. Fast or noisy components mislead a
/// training: some seeds then end in a lower bound (docs/training.md).
pub(super) fn first_latents(
    y: &DMatrix<f64>,
    sequences: &Sequences,
    count: usize,
    rng: &mut ChaCha8Rng,
) -> DMatrix<f64> {
    let slow = smoothed(y, sequences);
    let mut x = principal_components(&slow, count, rng);
    let spread: Vec<f64> = x.column_iter().map(|x| y.tr_mul(&x).norm()).collect();
    for (mut x, own) in x.column_iter_mut().zip(&spread) {
        let deviation = x.norm() / (x.len() as f64).sqrt();
        // The noise in place of a missing component is small already.
        let smallest = STAND_IN / deviation.max(STAND_IN);
        x *= (own / spread[0].max(f64::MIN_POSITIVE)).clamp(smallest, 1.0);
    }
    x
}

/// Averages of neighbouring rows of `x` [N x D] in the same sequence, with the weights of a Gaussian. Its
/// standard deviation is the [`pace`] of the movement: what is slow for one movement is fast for another.
fn smoothed(x: &DMatrix<f64>, sequences: &Sequences) -> DMatrix<f64> {
    let width = pace(x, sequences);
    let reach = (REACH * width).ceil() as usize;
    let weight = |distance: usize| (-0.5 * (distance as f64 / width).powi(2)).exponential();
    let weights: Vec<f64> = (1..=reach).map(weight).collect();
    let mut averages = x.clone();
    for frames in sequences.ranges() {
        for t in frames.clone() {
            let mut average = averages.row_mut(t);
            let mut total = 1.0;
            for near in frames.start.max(t.saturating_sub(reach))..frames.end.min(t + reach + 1) {
                if near != t {
                    let weight = weights[near.abs_diff(t) - 1];
                    average += x.row(near) * weight;
                    total += weight;
                }
            }
            average /= total;
        }
    }
    averages
}

/// Number of frames in which the centred columns `x` [N x D] change by their standard deviation; for a wave,
/// one radian. 0 for motionless columns.
fn pace(x: &DMatrix<f64>, sequences: &Sequences) -> f64 {
    let steps = sequences.lagged(x, 0) - sequences.lagged(x, 1);
    let variance = |x: &DMatrix<f64>| x.norm_squared() / x.nrows().max(1) as f64;
    let step = variance(&steps);
    if step > 0.0 { (variance(x) / step).sqrt().min(x.nrows() as f64) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use rand_chacha::rand_core::SeedableRng;

    fn latents(y: &DMatrix<f64>, count: usize) -> DMatrix<f64> {
        let sequences = Sequences::new(vec![y.nrows()], 2).unwrap();
        first_latents(y, &sequences, count, &mut ChaCha8Rng::seed_from_u64(1))
    }

    #[test]
    fn slow_columns_come_before_fast_ones() {
        let slow = |t: usize| (t as f64 * 0.05).sin();
        let fast = |t: usize| if t % 4 < 2 { 1.0 } else { -1.0 };
        // The fast column varies more than each slow one, but is no principal component after smoothing.
        let y =
            DMatrix::from_fn(
                252,
                4,
                |t, d| if d == 0 { 1.5 * fast(t) } else { slow(t) * (1.0 + d as f64 / 8.0) },
            );
        let x = latents(&y, 1);
        let cosine = x.column(0).dot(&y.column(1)) / (x.norm() * y.column(1).norm());
        assert!(cosine.abs() > 0.98, "{cosine}");
    }

    #[test]
    fn a_pace_is_the_time_of_one_radian() {
        let sequences = Sequences::new(vec![126], 2).unwrap();
        let wave = |slowness: f64| DMatrix::from_fn(126, 1, |t, _| (t as f64 / slowness).sin());
        assert_relative_eq!(pace(&wave(10.0), &sequences), 10.0, max_relative = 0.05);
        assert_relative_eq!(pace(&wave(2.0), &sequences), 2.0, max_relative = 0.05);
        assert_eq!(pace(&wave(0.0).map(|_| 0.0), &sequences), 0.0);
    }

    #[test]
    fn latents_are_scaled_by_their_share() {
        let y = DMatrix::from_fn(126, 2, |t, d| {
            if d == 0 { 4.0 * (t as f64 * 0.1).sin() } else { (t as f64 * 0.1).cos() }
        });
        let x = latents(&y, 3);
        let deviation = |q: usize| x.column(q).norm() / (x.nrows() as f64).sqrt();
        assert_relative_eq!(deviation(0), 1.0, epsilon = 1e-9);
        assert_relative_eq!(deviation(1), 0.25, epsilon = 0.02);
        // There is no third component: noise takes its place, and is not scaled.
        assert_relative_eq!(deviation(2), STAND_IN, epsilon = 0.05);
    }

    #[test]
    fn smooths_each_sequence_separately() {
        let sequences = Sequences::new(vec![20, 15], 2).unwrap();
        let apart = DMatrix::from_fn(35, 1, |t, _| if t < 20 { -1.0 } else { 2.0 });
        assert_relative_eq!(smoothed(&apart, &sequences), apart, epsilon = 1e-12);
    }

    #[test]
    fn motionless_columns_give_finite_latents() {
        assert!(latents(&DMatrix::zeros(12, 2), 3).iter().all(|x| x.is_finite()));
    }
}
