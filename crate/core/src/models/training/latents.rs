//! Starting values of models with latents: latents from principal components, variances from the data.

use crate::gp::Kernel;
use crate::models::data::sequences::Sequences;
use crate::models::errors::{TrainingError, in_range};
use crate::models::training::settings::MOST_DIMENSIONS;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// Noise variance as a share of the data's mean variance.
const NOISE_SHARE: f64 = 0.1;
/// Standard deviation of the noise in place of missing principal components.
pub(crate) const STAND_IN: f64 = 0.1;
const ALPHA_OWN: f64 = 1.0;
const ALPHA_OTHER: f64 = 2.0;

/// Checks the centred observations `y` [N x D_i], the lengths T_s of the sequences and the settings of a
/// model with latents.
///
/// # Errors
///
/// When a setting is out of its range, there is no part, a sequence is too short for the order, or a part
/// does not have one row for each frame.
pub(crate) fn check_training(
    y: &[DMatrix<f64>],
    lengths: Vec<usize>,
    latent: usize,
    order: usize,
) -> Result<Sequences, TrainingError> {
    check_dimensions(latent, order)?;
    if y.is_empty() {
        return Err(TrainingError::NoParts);
    }
    let sequences = Sequences::new(lengths, order)?;
    let expected = sequences.frames();
    if let Some(part) = y.iter().position(|y| y.nrows() != expected) {
        return Err(TrainingError::Frames { part, expected, found: y[part].nrows() });
    }
    Ok(sequences)
}

/// Checks the number of latent dimensions and the order of the dynamics.
///
/// # Errors
///
/// When one of them is out of its range.
pub(crate) fn check_dimensions(latent: usize, order: usize) -> Result<(), TrainingError> {
    in_range("the latent dimension", latent, MOST_DIMENSIONS)?;
    in_range("the order of the dynamics", order, MOST_DIMENSIONS)
}

/// The pose kernel and the noise variance beta that a part with the centred observations `y` [N x D] starts
/// with.
pub(crate) fn starting_pose(y: &DMatrix<f64>, latent: usize) -> (Kernel, f64) {
    // A part that does not move still needs a positive variance.
    let variance = (y.norm_squared() / y.len().max(1) as f64).max(1e-6);
    (Kernel { lambda: DVector::from_element(latent, 1.0), variance }, NOISE_SHARE * variance)
}

/// The kernel that the dynamics from a part of `latent` dimensions start with, in histories of `order`
/// frames.
pub(crate) fn starting_dynamics(latent: usize, order: usize) -> Kernel {
    Kernel { lambda: DVector::from_element(latent * order, 1.0), variance: 1.0 }
}

/// The coupling variances alpha [M x M] that training starts with: each part has a larger weight on its own
/// dynamics than the others have.
pub(crate) fn starting_couplings(parts: usize) -> DMatrix<f64> {
    DMatrix::from_fn(parts, parts, |j, i| if i == j { ALPHA_OWN } else { ALPHA_OTHER })
}

/// The first `count` principal component scores of the centred rows `y` [N x D], scaled to unit variance [N x
/// count].
///
/// Where the data have fewer dimensions than `count`, the missing ones are small noise.
pub(crate) fn principal_components(y: &DMatrix<f64>, count: usize, rng: &mut ChaCha8Rng) -> DMatrix<f64> {
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
            // The sign of an eigenvector is arbitrary; here its largest loading is positive.
            let sign = if loading[loading.iamax()] < 0.0 { -1.0 } else { 1.0 };
            scores.set_column(q, &(score * sign));
        } else {
            for t in 0..n {
                let noise: f64 = StandardNormal.sample(rng);
                scores[(t, q)] = STAND_IN * noise;
            }
        }
    }
    scores
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use rand_chacha::rand_core::SeedableRng;

    #[test]
    fn more_columns_than_frames_give_the_same_scores() {
        let y = DMatrix::from_fn(40, 4, |t, d| ((t as f64) * 0.3 + d as f64).sin() * (1.0 + d as f64));
        let mean = y.row_mean();
        let y = DMatrix::from_fn(40, 4, |t, d| y[(t, d)] - mean[d]);
        let wide = y.clone().resize_horizontally(60, 0.0);
        let scores = |y: &DMatrix<f64>| principal_components(y, 2, &mut ChaCha8Rng::seed_from_u64(1));
        assert_relative_eq!(scores(&wide), scores(&y), epsilon = 1e-9);
    }
}
