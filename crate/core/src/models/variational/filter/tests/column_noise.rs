//! Bands of columns whose noise differs, in frames that were not trained on.

use super::{filter_of, normal, without_column_noise};
use crate::gp::{Gaussians, Kernel};
use crate::models::data::sequences::Sequences;
use crate::models::variational::elbo::Objective;
use crate::models::variational::model::Vcgpdm;
use crate::models::variational::moments::LatentMoments;
use crate::models::variational::params::{Expert, Params, PartParams};
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

const FRAMES: usize = 200;
const COLUMNS: usize = 8;
/// Standard deviation of the noise of each column but the last one, and of the last one.
const NOISE: [f64; 2] = [0.03, 0.25];

/// Latents on a circle [200 x 2].
fn circle() -> DMatrix<f64> {
    DMatrix::from_fn(FRAMES, 2, |t, q| (0.35 * t as f64 + 1.57 * q as f64).cos())
}

/// Noisy columns at these latents [200 x 8].
fn columns(seed: u64) -> DMatrix<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    DMatrix::from_fn(FRAMES, COLUMNS, |t, d| {
        let noise = NOISE[usize::from(d + 1 == COLUMNS)] * normal(&mut rng);
        (0.35 * t as f64 + d as f64).sin() + noise
    })
}

/// A model of one part with these latents, and with the noise variance that all columns have in the mean.
fn model(lengths: &[usize]) -> Vcgpdm {
    let points =
        |radius: f64| DMatrix::from_fn(8, 2, |k, q| radius * (0.785 * (k as f64 - 2.0 * q as f64)).cos());
    let kernel = || Kernel { lambda: DVector::from_element(2, 2.0), variance: 1.0 };
    let variances = NOISE.map(|deviation| deviation * deviation);
    let part = PartParams {
        latents: Gaussians { mean: circle(), variance: DMatrix::from_element(FRAMES, 2, 1e-5) },
        r: points(1.0),
        kernel: kernel(),
        beta: (variances[0] * (COLUMNS - 1) as f64 + variances[1]) / COLUMNS as f64,
    };
    let expert = Expert { z: points(1.0), kernel: kernel() };
    let alpha = vec![DMatrix::from_element(1, 1, 0.01)];
    let params = Params { parts: vec![part], experts: vec![vec![expert]], alpha };
    let objective = Objective::new(vec![columns(1)], Sequences::new(lengths.to_vec(), 1).unwrap(), 1e-6);
    let terms = objective.terms(&params).unwrap();
    Vcgpdm::at_optimum(&objective, &params, terms).unwrap()
}

/// The coverage of each column in other frames, and the log density of a frame.
fn coverage(model: &Vcgpdm) -> (Vec<f64>, f64) {
    let (filter, recorded) = (filter_of(model), columns(2));
    let covariances = vec![vec![DMatrix::identity(2, 2) * 1e-5; FRAMES]];
    let latents = LatentMoments { means: vec![circle()], covariances };
    let of_column = |column: usize| {
        let mut only = DMatrix::from_element(FRAMES, COLUMNS, f64::NAN);
        only.set_column(column, &recorded.column(column));
        filter.score(0, &latents, &only).unwrap().coverage_95
    };
    ((0..COLUMNS).map(of_column).collect(), filter.score(0, &latents, &recorded).unwrap().log_density)
}

#[test]
fn bands_hold_columns_of_much_and_of_little_noise() {
    // Two training sequences, and a single one.
    for lengths in [&[120, 80][..], &[FRAMES]] {
        let model = model(lengths);
        let (found, density) = coverage(&model);
        assert!(found.iter().all(|share| (0.9..=0.995).contains(share)), "{found:?}");
        let (of_beta, lower) = coverage(&without_column_noise(model));
        assert!(of_beta[COLUMNS - 1] < 0.7 && of_beta[..COLUMNS - 1].iter().all(|share| *share > 0.995));
        assert!(density > lower + 3.0, "{density}, {lower}");
    }
}
