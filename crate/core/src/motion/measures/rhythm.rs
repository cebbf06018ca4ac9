//! Whether two limbs swing in step: their phases by complex demodulation.

use crate::elementary::Elementary;
use nalgebra::Vector2;
use std::f64::consts::TAU;

/// The phase relation of two swings.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// Phase of the first relative to the second, in cycles, -0.5 to 0.5.
    pub(super) ahead: f64,
    /// Constancy of that phase, 0 to 1.
    pub(super) locking: f64,
}

/// The phase relation of two swings of equal length at a common `period` in frames; `None` if they are
/// shorter than one period.
pub(super) fn step(a: &[f64], b: &[f64], period: f64) -> Option<Step> {
    let (a, b) = (demodulated(a, period), demodulated(b, period));
    // exp(i difference) at each time: the direction of a times the conjugate of b.
    let directions = a.iter().zip(&b).map(|(a, b)| {
        let product = Vector2::new(a.dot(b), a.y * b.x - a.x * b.y);
        product.try_normalize(0.0).unwrap_or_default()
    });
    let sum: Vector2<f64> = directions.sum();
    let step = Step { ahead: sum.y.arctangent(sum.x) / TAU, locking: sum.norm() / a.len() as f64 };
    (!a.is_empty()).then_some(step)
}

/// The complex demodulation [real, imaginary] of a swing: 2 / W sum_k (x_k - mean) exp(-i 2 pi k / period)
/// for each window of W frames, where W is the period rounded to frames.
fn demodulated(swing: &[f64], period: f64) -> Vec<Vector2<f64>> {
    let width = (period.round() as usize).max(2);
    let turns: Vec<Vector2<f64>> = (0..swing.len())
        .map(|k| {
            let (sin, cos) = (TAU * k as f64 / period).sine_cosine();
            Vector2::new(cos, -sin)
        })
        .collect();
    let windows = swing.windows(width).zip(turns.windows(width));
    windows
        .map(|(swing, turns)| {
            let mean = swing.iter().sum::<f64>() / width as f64;
            let sum: Vector2<f64> = swing.iter().zip(turns).map(|(x, turn)| turn * (x - mean)).sum();
            sum * (2.0 / width as f64)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn swing(period: f64, start: f64) -> Vec<f64> {
        (0..300).map(|t| 0.7 + 0.2 * (TAU * (t as f64 / period + start)).cos()).collect()
    }

    #[test]
    fn a_swing_becomes_its_amplitude_and_phase() {
        for z in demodulated(&swing(30.0, 0.15), 30.0) {
            assert!((z.norm() - 0.2).abs() < 1e-9, "{z}");
            assert!((z.y.atan2(z.x) / TAU - 0.15).abs() < 1e-9, "{z}");
        }
    }

    #[test]
    fn two_swings_at_one_pace_are_locked_with_their_phase_difference() {
        let found = step(&swing(33.4, 0.35), &swing(33.4, 0.1), 33.4).unwrap();
        assert!((found.ahead - 0.25).abs() < 0.01 && found.locking > 0.999, "{found:?}");
    }

    #[test]
    fn two_swings_at_different_paces_are_not_locked() {
        // 9 and 10 cycles in 300 frames: the phase difference passes through nearly a whole cycle.
        let found = step(&swing(30.0, 0.0), &swing(100.0 / 3.0, 0.0), 31.6).unwrap();
        assert!(found.locking < 0.2, "{found:?}");
    }

    #[test]
    fn less_than_one_period_has_no_phase() {
        assert!(step(&[0.0; 20], &[0.0; 20], 30.0).is_none());
    }
}
