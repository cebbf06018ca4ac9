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
