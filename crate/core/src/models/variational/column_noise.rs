//! The noise variance of each column of a part, measured on training sequences that the pose map does not see.
//!
//! The bound has one noise variance beta for all columns of a part, and its pose map has seen all sequences. For
//! the bands of columns, each sequence s is left out in turn (each half of a single one). With the psi statistics
//! of the other sequences under q(x), the mean of the pose map is f(x) = k(x, r) w with
//! w = (K + Psi2 / beta)^-1 psi1^T y / beta (Titsias and Lawrence 2010), and the noise variance of a column is the
//! expected squared residual,
//!
//! 1 / N sum_s E[ |y^s - k(x, r) w^{-s}|^2 ]
//!     = 1 / N sum_s ( |y^s - psi1^s w^{-s}|^2 + w^{-s T} (Psi2^s - psi1^{s T} psi1^s) w^{-s} ),
//!
//! the second term being the variance of f under q(x). Training, beta and q stay as they are.

use crate::gp::linalg::Factor;
use crate::gp::psi::{PairWorkspace, PsiStatistics, Purpose};
use crate::gp::tall::{add_tr_product, product};
use crate::gp::{Gaussians, NumericsError};
use crate::models::variational::elbo::Objective;
use crate::models::variational::params::Params;
use nalgebra::DMatrix;
use std::ops::Range;

/// The least noise variance of a column, as a share of beta: a column that never changes has no residual.
const LEAST: f64 = 1e-3;

/// Some frames, as the pose map sees them.
struct Frames {
    /// The centred columns [T x D].
    y: DMatrix<f64>,
    statistics: PsiStatistics,
    /// psi1^T y [L x D].
    b: DMatrix<f64>,
}

impl Frames {
    fn new(objective: &Objective, params: &Params, i: usize, rows: &Range<usize>) -> Self {
        let part = &params.parts[i];
        let of = |matrix: &DMatrix<f64>| matrix.rows(rows.start, rows.len()).into_owned();
        let x = Gaussians { mean: of(&part.latents.mean), variance: of(&part.latents.variance) };
        let mut statistics = PsiStatistics::new(rows.len(), part.r.nrows(), x.mean.ncols());
        statistics.compute(&x, &part.r, &part.kernel, Purpose::Value, &mut PairWorkspace::default());
        let y = of(&objective.observations()[i]);
        let mut b = DMatrix::zeros(part.r.nrows(), y.ncols());
        add_tr_product(&statistics.psi1, &y, &mut b);
        Self { y, statistics, b }
    }

    /// Adds the expected squared residuals of each column `[D]` under the weights w [L x D].
    fn add_squares(&self, w: &DMatrix<f64>, into: &mut [f64]) {
        let PsiStatistics { psi1, psi2, .. } = &self.statistics;
        let residuals = &self.y - product(psi1, w);
        let mut squares_of_means = DMatrix::zeros(psi2.nrows(), psi2.ncols());
        add_tr_product(psi1, psi1, &mut squares_of_means);
        let spread = product(&(psi2 - squares_of_means), w);
        for (c, sum) in into.iter_mut().enumerate() {
            *sum += residuals.column(c).norm_squared() + w.column(c).dot(&spread.column(c)).max(0.0);
        }
    }
}

/// The frames that are left out together: those of a sequence, or of each half of the only one.
fn left_out(objective: &Objective) -> Vec<Range<usize>> {
    let mut ranges: Vec<Range<usize>> = objective.sequences().ranges().collect();
    if let [only] = ranges.as_slice() {
        let middle = only.start + only.len() / 2;
        ranges = vec![only.start..middle, middle..only.end];
    }
    ranges
}

/// The noise variance of each column of part i `[D_i]` at these parameters.
///
/// # Errors
///
/// When a covariance cannot be factorised.
pub(super) fn column_noise(
    objective: &Objective,
    params: &Params,
    i: usize,
) -> Result<Vec<f64>, NumericsError> {
    let part = &params.parts[i];
    let frames: Vec<Frames> =
        left_out(objective).iter().map(|rows| Frames::new(objective, params, i, rows)).collect();
    let mut a = part.kernel.inducing_covariance(&part.r, objective.jitter());
    let mut b = DMatrix::zeros(part.r.nrows(), objective.observations()[i].ncols());
    for one in &frames {
        a += &one.statistics.psi2 / part.beta;
        b += &one.b;
    }
    let mut squares = vec![0.0; b.ncols()];
    for one in &frames {
        let others = &a - &one.statistics.psi2 / part.beta;
        let w = Factor::new(&others, "precision of a pose map without a sequence")?.solve(&(&b - &one.b));
        one.add_squares(&(w / part.beta), &mut squares);
    }
    let count = objective.sequences().frames() as f64;
    Ok(squares.into_iter().map(|sum| (sum / count).max(LEAST * part.beta)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::data::sequences::Sequences;
    use crate::models::variational::testing::random_case;
    use approx::assert_relative_eq;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    /// The residuals of points drawn from q(x), under the pose map of the frames before or after `left_out`.
    fn drawn(objective: &Objective, params: &Params, i: usize, left_out: &[Range<usize>]) -> Vec<f64> {
        let (part, y) = (&params.parts[i], &objective.observations()[i]);
        let k = part.kernel.inducing_covariance(&part.r, objective.jitter());
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let (draws, mut squares) = (40_000, vec![0.0; y.ncols()]);
        for rows in left_out {
            let others: Vec<usize> = (0..y.nrows()).filter(|t| !rows.contains(t)).collect();
            let x = Gaussians {
                mean: part.latents.mean.select_rows(&others),
                variance: part.latents.variance.select_rows(&others),
            };
            let mut psi = PsiStatistics::new(others.len(), part.r.nrows(), x.mean.ncols());
            psi.compute(&x, &part.r, &part.kernel, Purpose::Value, &mut PairWorkspace::default());
            let a = &k + &psi.psi2 / part.beta;
            let w = a.try_inverse().unwrap() * psi.psi1.transpose() * y.select_rows(&others) / part.beta;
            for t in rows.clone() {
                let x = DMatrix::from_fn(draws, part.r.ncols(), |_, q| {
                    let normal: f64 = StandardNormal.sample(&mut rng);
                    part.latents.mean[(t, q)] + part.latents.variance[(t, q)].sqrt() * normal
                });
                let f = part.kernel.cross_covariance(&x, &part.r) * &w;
                for (c, sum) in squares.iter_mut().enumerate() {
                    *sum += f.column(c).iter().map(|f| (y[(t, c)] - f).powi(2)).sum::<f64>() / draws as f64;
                }
            }
        }
        squares.into_iter().map(|sum| sum / y.nrows() as f64).collect()
    }

    #[test]
    fn it_is_the_expected_square_of_residuals_in_sequences_left_out() {
        for (seed, left_out) in [(1, vec![0..11, 11..19]), (2, vec![0..7, 7..14])] {
            let (params, objective) = random_case(seed);
            for i in 0..2 {
                let found = column_noise(&objective, &params, i).unwrap();
                for (found, expected) in found.iter().zip(drawn(&objective, &params, i, &left_out)) {
                    assert_relative_eq!(*found, expected, max_relative = 0.01);
                }
            }
        }
    }

    #[test]
    fn a_column_that_never_changes_has_the_least_noise() {
        let (params, objective) = random_case(1);
        let mut y = objective.observations().to_vec();
        y[0].column_mut(2).fill(0.0);
        let sequences = Sequences::new(vec![11, 8], 2).unwrap();
        let found = column_noise(&Objective::new(y, sequences, 0.0), &params, 0).unwrap();
        assert_relative_eq!(found[2], LEAST * params.parts[0].beta, max_relative = 1e-12);
        assert!(found[0] > params.parts[0].beta, "{found:?}");
    }
}
