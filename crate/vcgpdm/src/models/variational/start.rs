//! Where training starts: latents from principal components, variances from the data's spread, inducing inputs from a random
//! subset of the latents.

use crate::gp::{Gaussians, Kernel};
use crate::models::sequences::Sequences;
use crate::models::variational::params::{Expert, Params, PartParams};
use crate::models::variational::trainer::TrainingSettings;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal, StandardUniform};

/// Noise variance as a part of the data's mean variance.
const NOISE_SHARE: f64 = 0.1;
/// The variances S as a part of the mean absolute step of the latents.
const STEP_SHARE: f64 = 0.1;
const SMALLEST_S: f64 = 1e-3;
/// Inducing inputs drawn from the same frame would make their covariance singular.
const SPREAD_OF_REPEATS: f64 = 0.1;
const ALPHA_OWN: f64 = 1.0;
const ALPHA_OTHER: f64 = 2.0;

/// The starting point on the centred observations `y` [N x D_i] of each part.
pub fn starting_point(y: &[DMatrix<f64>], sequences: &Sequences, settings: &TrainingSettings) -> Params {
    let mut rng = ChaCha8Rng::seed_from_u64(u64::from(settings.seed));
    let latents: Vec<Gaussians> = y
        .iter()
        .map(|y| {
            let mean = principal_components(y, settings.latent, &mut rng);
            let s = (STEP_SHARE * mean_absolute_step(&mean, sequences)).max(SMALLEST_S);
            let variance = DMatrix::from_element(mean.nrows(), mean.ncols(), s);
            Gaussians { mean, variance }
        })
        .collect();
    let parts = latents.iter().zip(y).map(|(latents, y)| {
        // A part that does not move at all still needs a positive variance.
        let variance = (y.norm_squared() / y.len().max(1) as f64).max(1e-6);
        PartParams {
            latents: latents.clone(),
            r: random_subset(&latents.mean, settings.pose_ips, &mut rng),
            kernel: Kernel { lambda: DVector::from_element(settings.latent, 1.0), variance },
            beta: NOISE_SHARE * variance,
        }
    });
    let parts: Vec<PartParams> = parts.collect();
    let dims = settings.latent * sequences.order();
    let histories: Vec<DMatrix<f64>> = latents.iter().map(|x| sequences.histories(x).mean).collect();
    let experts = histories.iter().map(|histories| {
        let expert = |_| Expert {
            z: random_subset(histories, settings.dynamics_ips, &mut rng),
            kernel: Kernel { lambda: DVector::from_element(dims, 1.0), variance: 1.0 },
        };
        (0..y.len()).map(expert).collect()
    });
    let experts = experts.collect();
    let alpha = DMatrix::from_fn(y.len(), y.len(), |j, i| if i == j { ALPHA_OWN } else { ALPHA_OTHER });
    Params { parts, experts, alpha }
}

/// The first `count` principal component scores of the centred rows `y` [N x D], scaled to unit variance [N x count].
///
/// Where the data have fewer dimensions than asked for, small noise stands in for the missing ones.
fn principal_components(y: &DMatrix<f64>, count: usize, rng: &mut ChaCha8Rng) -> DMatrix<f64> {
    let n = y.nrows();
    // Frames and columns have the same eigenvalues; the smaller of the two matrices is taken.
    let wide = y.ncols() > n;
    let products = if wide { y * y.transpose() } else { y.tr_mul(y) };
    let eigen = SymmetricEigen::new(products / n as f64);
    let mut left: Vec<usize> = (0..eigen.eigenvalues.len()).collect();
    let largest = eigen.eigenvalues.max();
    let mut scores = DMatrix::zeros(n, count);
    for q in 0..count {
        let place = (0..left.len())
            .max_by(|a, b| eigen.eigenvalues[left[*a]].total_cmp(&eigen.eigenvalues[left[*b]]));
        let next = place.map(|place| left.swap_remove(place));
        if let Some(k) = next.filter(|k| eigen.eigenvalues[*k] > 1e-10 * largest && largest > 0.0) {
            let vector = eigen.eigenvectors.column(k);
            let (score, loading) = if wide {
                (vector * (n as f64).sqrt(), y.tr_mul(&vector))
            } else {
                (y * vector / eigen.eigenvalues[k].sqrt(), vector.into_owned())
            };
            // An eigenvector's sign is arbitrary; the largest loading positive makes it one and the same everywhere.
            let sign = if loading[loading.iamax()] < 0.0 { -1.0 } else { 1.0 };
            scores.set_column(q, &(score * sign));
        } else {
            for t in 0..n {
                let noise: f64 = StandardNormal.sample(rng);
                scores[(t, q)] = SPREAD_OF_REPEATS * noise;
            }
        }
    }
    scores
}

fn mean_absolute_step(x: &DMatrix<f64>, sequences: &Sequences) -> f64 {
    let steps = sequences.lagged(x, 0) - sequences.lagged(x, 1);
    steps.abs().sum() / steps.len().max(1) as f64
}

/// `count` different rows of `x` in random order; when it has fewer, rows repeat with a little noise.
fn random_subset(x: &DMatrix<f64>, count: usize, rng: &mut ChaCha8Rng) -> DMatrix<f64> {
    let n = x.nrows();
    let mut rows: Vec<usize> = (0..n).collect();
    for k in 0..count.min(n) {
        let u: f64 = StandardUniform.sample(rng);
        let other = k + (u * (n - k) as f64) as usize;
        rows.swap(k, other.min(n - 1));
    }
    DMatrix::from_fn(count, x.ncols(), |k, q| {
        let repeat: f64 = if k < n { 0.0 } else { SPREAD_OF_REPEATS };
        let noise: f64 = if k < n { 0.0 } else { StandardNormal.sample(rng) };
        x[(rows[k % n], q)] + repeat * noise
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn settings(seed: u32) -> TrainingSettings {
        TrainingSettings { latent: 3, dynamics_ips: 6, pose_ips: 5, order: 2, seed, max_iterations: 10 }
    }

    fn wave() -> (DMatrix<f64>, Sequences) {
        let y = DMatrix::from_fn(40, 4, |t, d| ((t as f64) * 0.3 + d as f64).sin() * (1.0 + d as f64));
        let mean = y.row_mean();
        let y = DMatrix::from_fn(40, 4, |t, d| y[(t, d)] - mean[d]);
        (y, Sequences::new(vec![25, 15], 2).unwrap())
    }

    #[test]
    fn latents_have_unit_variance_and_start_is_seeded() {
        let (y, sequences) = wave();
        let start = starting_point(&[y.clone(), y.clone()], &sequences, &settings(4));
        let x = &start.parts[0].latents.mean;
        for q in 0..2 {
            assert_relative_eq!(x.column(q).norm_squared() / 40.0, 1.0, epsilon = 1e-9);
        }
        assert_eq!(start, starting_point(&[y.clone(), y.clone()], &sequences, &settings(4)));
        assert_ne!(start, starting_point(&[y.clone(), y], &sequences, &settings(5)));
    }

    #[test]
    fn a_body_with_more_columns_than_frames_starts_alike() {
        let (y, _) = wave();
        let wide = y.clone().resize_horizontally(60, 0.0);
        let scores = |y: &DMatrix<f64>| principal_components(y, 2, &mut ChaCha8Rng::seed_from_u64(1));
        assert_relative_eq!(scores(&wide), scores(&y), epsilon = 1e-9);
    }

    #[test]
    fn inducing_inputs_are_different_frames() {
        let (y, sequences) = wave();
        let start = starting_point(&[y], &sequences, &settings(1));
        let r = &start.parts[0].r;
        for a in 0..r.nrows() {
            for b in 0..a {
                assert!((r.row(a) - r.row(b)).norm() > 0.0);
            }
        }
    }

    #[test]
    fn motionless_and_thin_data_give_a_usable_start() {
        let y = DMatrix::zeros(12, 1);
        let sequences = Sequences::new(vec![12], 2).unwrap();
        let start = starting_point(&[y], &sequences, &settings(1));
        assert!(start.parts[0].latents.mean.iter().all(|v| v.is_finite()));
        assert!(start.parts[0].beta > 0.0 && start.parts[0].kernel.variance > 0.0);
    }
}
