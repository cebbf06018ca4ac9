//! The latents that training starts with: slow ones, as large as what they explain.

use crate::elementary::Elementary;
use crate::models::latents::{STAND_IN, principal_components};
use crate::models::sequences::Sequences;
use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;

/// Standard deviation of the weights of a moving average, in frames.
const WIDTH: f64 = 4.0;
/// Frames on either side that count; those farther away weigh less than 0.001.
const REACH: usize = 15;

/// The first `count` principal components [N x count] of the columns `y` [N x D], smoothed along time. The first has unit variance; the
/// variance of each other is smaller as its share in the smoothed columns is.
///
/// The dynamics ask for latents that the next frame can be predicted from. What changes fast, or differs from frame to frame without
/// a rule, misleads a training that begins with it: most seeds then end in a lower bound. See docs/training.md.
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
        // What stands in for a component that the columns do not have is as small already.
        let smallest = STAND_IN / deviation.max(STAND_IN);
        x *= (own / spread[0].max(f64::MIN_POSITIVE)).clamp(smallest, 1.0);
    }
    x
}

/// The averages of the rows around each row of `x` [N x D], of its own sequence.
fn smoothed(x: &DMatrix<f64>, sequences: &Sequences) -> DMatrix<f64> {
    let weights: Vec<f64> =
        (0..=REACH).map(|distance| (-0.5 * (distance as f64 / WIDTH).powi(2)).exponential()).collect();
    let mut averages = DMatrix::zeros(x.nrows(), x.ncols());
    for frames in sequences.ranges() {
        for t in frames.clone() {
            let mut average = averages.row_mut(t);
            let mut total = 0.0;
            for near in frames.start.max(t.saturating_sub(REACH))..frames.end.min(t + REACH + 1) {
                let weight = weights[near.abs_diff(t)];
                average += x.row(near) * weight;
                total += weight;
            }
            average /= total;
        }
    }
    averages
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
        let slow = |t: usize| (t as f64 * 0.1).sin();
        // The second column varies more, but to and fro in every frame.
        let y = DMatrix::from_fn(
            126,
            2,
            |t, d| if d == 0 { slow(t) } else { 3.0 * (1.0 - 2.0 * (t % 2) as f64) },
        );
        let x = latents(&y, 1);
        let cosine = x.column(0).dot(&y.column(0)) / (x.norm() * y.column(0).norm());
        assert!(cosine > 0.98, "{cosine}");
    }

    #[test]
    fn latents_are_as_large_as_what_they_explain() {
        let y = DMatrix::from_fn(126, 2, |t, d| {
            if d == 0 { 4.0 * (t as f64 * 0.1).sin() } else { (t as f64 * 0.1).cos() }
        });
        let x = latents(&y, 3);
        let deviation = |q: usize| x.column(q).norm() / (x.nrows() as f64).sqrt();
        assert_relative_eq!(deviation(0), 1.0, epsilon = 1e-9);
        assert_relative_eq!(deviation(1), 0.25, epsilon = 0.02);
        // There is no third component: noise stands in for it, and stays.
        assert_relative_eq!(deviation(2), STAND_IN, epsilon = 0.05);
    }

    #[test]
    fn sequences_are_smoothed_each_for_itself() {
        let sequences = Sequences::new(vec![20, 15], 2).unwrap();
        let apart = DMatrix::from_fn(35, 1, |t, _| if t < 20 { -1.0 } else { 2.0 });
        assert_relative_eq!(smoothed(&apart, &sequences), apart, epsilon = 1e-12);
    }

    #[test]
    fn motionless_columns_give_finite_latents() {
        assert!(latents(&DMatrix::zeros(12, 2), 3).iter().all(|x| x.is_finite()));
    }
}
