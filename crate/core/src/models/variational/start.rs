//! The starting point of a variational training: slow latents, nearly linear pose maps, and inducing inputs
//! from a random subset of the latents.

use crate::gp::linalg::stacked;
use crate::gp::{Gaussians, Kernel};
use crate::models::data::sequences::Sequences;
use crate::models::search::parameters::SMALLEST_S;
use crate::models::training::latents::{STAND_IN, starting_couplings, starting_dynamics, starting_pose};
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::first_latents::first_latents;
use crate::models::variational::params::{Expert, Params, PartParams};
use crate::models::variational::repertoire::Repertoire;
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal, StandardUniform};

/// The variances S as a part of the mean absolute step of the latents.
const STEP_SHARE: f64 = 0.2;
/// The squared lengthscales of a pose map that is nearly linear where its latents are, which have unit
/// variance. Those of trained pose maps are mostly between 5 and 100. With 3 one seed of 120 ended in a low
/// bound; with 1 and 10 one and two of 40, nearly the same (docs/training.md).
const NEARLY_LINEAR: f64 = 3.0;

/// The starting point on the centred observations `y` [N x D_i] of each part.
///
/// The order of the random draws must not change, so that a seed gives the same start: the latents of all
/// parts, then the pose inducing inputs of all parts, then the dynamics inducing inputs, source by source and
/// for each source target by target.
pub fn starting_point(
    y: &[DMatrix<f64>],
    sequences: &Sequences,
    settings: &VariationalSettings,
    seed: u32,
) -> Params {
    starting_point_of(y, &Repertoire::plain(sequences.clone(), y.len()), settings, seed)
}

/// [`starting_point`] for movements that may share primitives. The dynamics inducing inputs of a
/// primitive are histories of the movements that use it; a primitive that none uses sees all.
pub(super) fn starting_point_of(
    y: &[DMatrix<f64>],
    repertoire: &Repertoire,
    settings: &VariationalSettings,
    seed: u32,
) -> Params {
    let sequences = repertoire.sequences();
    let mut rng = ChaCha8Rng::seed_from_u64(u64::from(seed));
    let mut latents = Vec::with_capacity(y.len());
    for y in y {
        let mean = first_latents(y, sequences, settings.latent, &mut rng);
        let s = first_variance(&mean, sequences);
        let variance = DMatrix::from_element(mean.nrows(), mean.ncols(), s);
        latents.push(Gaussians { mean, variance });
    }
    let mut parts = Vec::with_capacity(y.len());
    for (latents, y) in latents.iter().zip(y) {
        let (kernel, beta) = starting_pose(y, settings.latent);
        let kernel = nearly_linear(&kernel);
        let r = random_subset(&latents.mean, settings.pose_ips, &mut rng);
        parts.push(PartParams { latents: latents.clone(), r, kernel, beta });
    }
    let counts = vec![settings.dynamics_ips; y.len()];
    let mut experts = Vec::with_capacity(y.len());
    for (primitive, part) in repertoire.primitives().iter().enumerate() {
        experts.push(starting_experts(primitive, repertoire, &latents[*part].mean, &counts, &mut rng));
    }
    Params { parts, experts, alpha: vec![starting_couplings(y.len()); repertoire.movements().len()] }
}

/// The experts of a primitive, one about each part, with `counts` inducing inputs: histories of the latents
/// `x` [N x Q] of its part in the movements that use it.
pub fn starting_experts(
    primitive: usize,
    repertoire: &Repertoire,
    x: &DMatrix<f64>,
    counts: &[usize],
    rng: &mut ChaCha8Rng,
) -> Vec<Expert> {
    let histories = histories_of(primitive, repertoire, x);
    let order = repertoire.sequences().order();
    let expert = |count: &usize| Expert {
        z: random_subset(&histories, *count, rng),
        kernel: starting_dynamics(x.ncols(), order),
    };
    counts.iter().map(expert).collect()
}

/// The histories of latents `x` [N x Q] in the movements that use a primitive of their part [rows x pQ].
fn histories_of(primitive: usize, repertoire: &Repertoire, x: &DMatrix<f64>) -> DMatrix<f64> {
    let in_use = repertoire.movements().iter().filter(|movement| movement.uses().contains(&primitive));
    let blocks: Vec<_> = in_use.map(|movement| movement.sequences().windows(x)).collect();
    if blocks.is_empty() {
        return repertoire.sequences().windows(x);
    }
    stacked(&blocks)
}

/// A kernel of functions that are nearly linear in latents of unit variance and vary as much there as those
/// of `kernel`: of a slope with the variance sigma^2 / lambda in each of Q dimensions.
fn nearly_linear(kernel: &Kernel) -> Kernel {
    let latent = kernel.lambda.len();
    Kernel {
        lambda: DVector::from_element(latent, NEARLY_LINEAR),
        variance: kernel.variance * NEARLY_LINEAR / latent as f64,
    }
}

/// The variance S that latents with the means `x` [N x Q] start with.
pub fn first_variance(x: &DMatrix<f64>, sequences: &Sequences) -> f64 {
    (STEP_SHARE * mean_absolute_step(x, sequences)).max(SMALLEST_S)
}

fn mean_absolute_step(x: &DMatrix<f64>, sequences: &Sequences) -> f64 {
    let steps = sequences.lagged(x, 0) - sequences.lagged(x, 1);
    steps.abs().sum() / steps.len().max(1) as f64
}

/// `count` different rows of `x` in random order. If `x` has fewer, rows repeat with a little noise, because
/// two equal inducing inputs would make their covariance singular.
fn random_subset(x: &DMatrix<f64>, count: usize, rng: &mut ChaCha8Rng) -> DMatrix<f64> {
    let n = x.nrows();
    let mut rows: Vec<usize> = (0..n).collect();
    for k in 0..count.min(n) {
        let u: f64 = StandardUniform.sample(rng);
        let other = k + (u * (n - k) as f64) as usize;
        rows.swap(k, other.min(n - 1));
    }
    DMatrix::from_fn(count, x.ncols(), |k, q| {
        let repeat: f64 = if k < n { 0.0 } else { STAND_IN };
        let noise: f64 = if k < n { 0.0 } else { StandardNormal.sample(rng) };
        x[(rows[k % n], q)] + repeat * noise
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings() -> VariationalSettings {
        VariationalSettings { dynamics_ips: 6, pose_ips: 5, ..VariationalSettings::default() }
    }

    fn wave() -> (DMatrix<f64>, Sequences) {
        let y = DMatrix::from_fn(40, 4, |t, d| ((t as f64) * 0.3 + d as f64).sin() * (1.0 + d as f64));
        let mean = y.row_mean();
        let y = DMatrix::from_fn(40, 4, |t, d| y[(t, d)] - mean[d]);
        (y, Sequences::new(vec![25, 15], 2).unwrap())
    }

    #[test]
    fn the_same_seed_gives_the_same_start() {
        let (y, sequences) = wave();
        let start = starting_point(&[y.clone(), y.clone()], &sequences, &settings(), 4);
        assert_eq!(start, starting_point(&[y.clone(), y.clone()], &sequences, &settings(), 4));
        assert_ne!(start, starting_point(&[y.clone(), y], &sequences, &settings(), 5));
    }

    #[test]
    fn inducing_inputs_are_different_frames() {
        let (y, sequences) = wave();
        let start = starting_point(&[y], &sequences, &settings(), 1);
        let r = &start.parts[0].r;
        for a in 0..r.nrows() {
            for b in 0..a {
                assert!((r.row(a) - r.row(b)).norm() > 0.0);
            }
        }
    }

    #[test]
    fn more_rows_than_there_are_differ_too() {
        let x = DMatrix::from_column_slice(3, 1, &[1.0, 2.0, 3.0]);
        let rows = random_subset(&x, 7, &mut ChaCha8Rng::seed_from_u64(1));
        let mut values: Vec<f64> = rows.iter().copied().collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        assert_eq!(values.len(), 7);
    }

    #[test]
    fn motionless_and_thin_data_give_a_usable_start() {
        let y = DMatrix::zeros(12, 1);
        let sequences = Sequences::new(vec![12], 2).unwrap();
        let start = starting_point(&[y], &sequences, &settings(), 1);
        assert!(start.parts[0].latents.mean.iter().all(|v| v.is_finite()));
        assert!(start.parts[0].beta > 0.0 && start.parts[0].kernel.variance > 0.0);
    }
}
