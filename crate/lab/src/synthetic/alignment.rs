//! Comparison of learned and true latents. Latents can only be found up to a change of coordinates.

use nalgebra::{DMatrix, RowDVector};
use vcgpdm_core::gp::NumericsError;
use vcgpdm_core::gp::linalg::Factor;

/// Learned latents in the coordinates of the true ones.
#[derive(Clone, Debug, PartialEq)]
pub struct LatentAlignment {
    /// The learned latents after the map [N x Q_true].
    pub latents: DMatrix<f64>,
    /// Share of the variance of the true latents that the learned ones explain, at most 1.
    pub explained: f64,
    /// A learned point x is at x `map` + `shift`: [Q x Q_true] and `[Q_true]`.
    map: DMatrix<f64>,
    shift: RowDVector<f64>,
}

impl LatentAlignment {
    /// Points of the learned latent space [n x Q] in the coordinates of the true latents [n x Q_true].
    pub fn place(&self, points: &DMatrix<f64>) -> DMatrix<f64> {
        let mut placed = points * &self.map;
        placed.row_iter_mut().for_each(|mut row| row += &self.shift);
        placed
    }
}

/// Maps the `learned` latents [N x Q] to the `actual` ones [N x Q_true] by the best affine map (least
/// squares).
///
/// # Errors
///
/// The covariance of the learned latents cannot be factorised.
pub fn align(learned: &DMatrix<f64>, actual: &DMatrix<f64>) -> Result<LatentAlignment, NumericsError> {
    let (mut x, mut y) = (learned.clone(), actual.clone());
    let (from, to) = (centre(&mut x), centre(&mut y));
    let mut map = x.tr_mul(&y);
    Factor::new(&x.tr_mul(&x), "covariance of the learned latents")?.solve_mut(&mut map);
    let total = y.norm_squared().max(f64::MIN_POSITIVE);
    y -= x * &map;
    let explained = 1.0 - y.norm_squared() / total;
    let shift = RowDVector::from_vec(to) - RowDVector::from_vec(from) * &map;
    let aligned = LatentAlignment { latents: DMatrix::zeros(0, 0), explained, map, shift };
    Ok(LatentAlignment { latents: aligned.place(learned), ..aligned })
}

/// Subtracts its mean from each column, and returns the means.
pub(super) fn centre(x: &mut DMatrix<f64>) -> Vec<f64> {
    let frames = x.nrows().max(1) as f64;
    let subtract_mean = |column: &mut [f64]| {
        let mean = column.iter().sum::<f64>() / frames;
        column.iter_mut().for_each(|value| *value -= mean);
        mean
    };
    x.as_mut_slice().chunks_exact_mut(frames as usize).map(subtract_mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn undoes_an_affine_change_of_coordinates() {
        let actual = DMatrix::from_fn(40, 2, |t, q| (t as f64 * 0.37 + 2.0 * q as f64).sin());
        let turn = DMatrix::from_row_slice(2, 3, &[0.5, -2.0, 0.3, 1.0, 0.7, -0.2]);
        let learned = (&actual * turn).add_scalar(3.0).columns(0, 2).into_owned();
        let aligned = align(&learned, &actual).unwrap();
        assert_relative_eq!(aligned.latents, actual, epsilon = 1e-9);
        assert_relative_eq!(aligned.explained, 1.0, epsilon = 1e-9);
    }

    #[test]
    fn constant_latents_explain_nothing() {
        let actual = DMatrix::from_fn(10, 2, |t, q| (t + q) as f64);
        let aligned = align(&DMatrix::from_element(10, 2, 1.0), &actual).unwrap();
        assert!(aligned.latents.iter().all(|v| v.is_finite()));
        assert_relative_eq!(aligned.explained, 0.0, epsilon = 1e-9);
    }
}
