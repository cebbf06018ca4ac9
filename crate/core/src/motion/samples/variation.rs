//! Random variation between trials and between steps: seeded, and smooth in time.

use crate::elementary::Elementary;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardUniform};
use std::f64::consts::TAU;

/// A slow, nearly aperiodic variation: a sum of sinusoids with seeded frequencies and phases. Standard
/// deviation about 1.
#[derive(Clone, Debug)]
pub(super) struct Drift {
    /// Amplitude, frequency (hertz) and phase (cycles) of each sinusoid.
    waves: [[f64; 3]; 4],
}

impl Drift {
    /// Draws a drift that changes over seconds.
    pub fn new(random: &mut ChaCha8Rng) -> Drift {
        let mut waves = [[0.0; 3]; 4];
        for (wave, slowest) in waves.iter_mut().zip([0.05, 0.12, 0.22, 0.35]) {
            let amplitude = 0.55 + 0.3 * between(random, 0.0, 1.0);
            *wave = [amplitude, slowest * between(random, 1.0, 1.6), between(random, 0.0, 1.0)];
        }
        Drift { waves }
    }

    /// The drift at a time in seconds.
    pub fn at(&self, seconds: f64) -> f64 {
        self.waves
            .iter()
            .map(|[amplitude, hertz, phase]| amplitude * (TAU * (hertz * seconds + phase)).sine())
            .sum()
    }
}

/// A number drawn uniformly between two others.
pub(super) fn between(random: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
    let u: f64 = StandardUniform.sample(random);
    low + (high - low) * u
}
