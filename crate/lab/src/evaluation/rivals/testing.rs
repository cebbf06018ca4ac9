//! Movements for tests.

use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use vcgpdm_core::models::{Movements, Sequence};

/// Movements of one part: the columns of each sequence, and whether it is a whole trial.
pub fn movements(trials: &[(DMatrix<f64>, bool)]) -> Movements {
    let frames = trials.iter().map(|(y, _)| y.nrows()).sum();
    let mut joined = DMatrix::zeros(frames, trials[0].0.ncols());
    let mut at = 0;
    for (y, _) in trials {
        joined.rows_mut(at, y.nrows()).copy_from(y);
        at += y.nrows();
    }
    let sequence = |(y, whole): &(DMatrix<f64>, bool)| Sequence { frames: y.nrows(), whole: *whole };
    Movements { y: vec![joined], sequences: trials.iter().map(sequence).collect() }
}

/// Standard Gaussian numbers.
pub fn noise(rows: usize, columns: usize, seed: u64) -> DMatrix<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    DMatrix::from_fn(rows, columns, |_, _| StandardNormal.sample(&mut rng))
}
