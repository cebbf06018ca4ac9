//! Couplings: how strongly each part drives each other part.
//!
//! The product of experts turns coupling variances `alpha[source][target]` into weights (Velychko et al.
//! 2018, equation 1): alpha^i = 1 / sum_j (1 / alpha^{ji}) and w_{ji} = alpha^i / alpha^{ji}. The larger the
//! variance, the smaller the weight of the source.

use crate::models::errors::CouplingsError;
use nalgebra::DMatrix;
use serde::Deserialize;

/// The effect of changed couplings on the experts: they stay as learned, or they are inferred again from the
/// same data.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Reading {
    /// The experts stay as learned; only their weights change.
    #[default]
    #[serde(rename = "as-learned", alias = "as learned")]
    AsLearned,
    /// The experts are inferred again from the training data under the changed couplings.
    #[serde(rename = "re-inferred")]
    ReInferred,
}

/// Checks that `alpha` holds a positive coupling variance for each pair of `parts` parts.
///
/// # Errors
///
/// When it has another shape, or an entry is not from 1e-100 to 1e100.
pub fn check_couplings(alpha: &DMatrix<f64>, parts: usize) -> Result<(), CouplingsError> {
    if alpha.shape() != (parts, parts) {
        return Err(CouplingsError::Shape { parts, rows: alpha.nrows(), columns: alpha.ncols() });
    }
    for target in 0..parts {
        for source_part in 0..parts {
            let value = alpha[(source_part, target)];
            // Within these limits, 1 / alpha and its sums are finite.
            if !(1e-100..=1e100).contains(&value) {
                return Err(CouplingsError::Variance { source_part, target, value });
            }
        }
    }
    Ok(())
}

/// The combined variance alpha^i and the weights w_{ji} `[M]` that the coupling variances `alpha` `[M]` into
/// one target i give.
pub fn coupling_weights(alpha: &[f64]) -> (f64, Vec<f64>) {
    let mut weights = vec![0.0; alpha.len()];
    (coupling_weights_into(alpha, &mut weights), weights)
}

/// As [`coupling_weights`], with the weights in an existing vector; returns alpha^i.
pub(crate) fn coupling_weights_into(alpha: &[f64], weights: &mut [f64]) -> f64 {
    let combined = 1.0 / alpha.iter().map(|a| 1.0 / a).sum::<f64>();
    for (w, a) in weights.iter_mut().zip(alpha) {
        *w = combined / a;
    }
    combined
}

/// The weights `w[source][target]` that coupling variances `alpha[source][target]` give [M x M]; those into
/// each part sum to 1.
///
/// ```
/// use nalgebra::DMatrix;
/// use vcgpdm_core::models::coupling_weight_matrix;
///
/// // For part 0, part 1 has a quarter of the weight of part 0 itself.
/// let weights = coupling_weight_matrix(&DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 4.0, 1.0]));
/// assert_eq!(weights, DMatrix::from_row_slice(2, 2, &[0.8, 0.5, 0.2, 0.5]));
/// ```
pub fn coupling_weight_matrix(alpha: &DMatrix<f64>) -> DMatrix<f64> {
    let mut weights = alpha.clone();
    for (mut column, alpha) in weights.column_iter_mut().zip(alpha.column_iter()) {
        coupling_weights_into(alpha.as_slice(), column.as_mut_slice());
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn refuses_couplings_that_are_not_positive_variances() {
        let mut alpha = DMatrix::from_element(2, 2, 1.0);
        assert_eq!(check_couplings(&alpha, 2), Ok(()));
        for (value, found) in [(-1.0, "-1.0"), (1e-308, "1e-308"), (f64::NAN, "NaN")] {
            alpha[(0, 1)] = value;
            let error = check_couplings(&alpha, 2).unwrap_err().to_string();
            let expected =
                "expected a positive coupling variance from part 0 to part 1, 1e-100 to 1e100, found ";
            assert_eq!(error, format!("{expected}{found}"));
        }
        let error = check_couplings(&alpha, 3).unwrap_err().to_string();
        assert_eq!(error, "expected coupling variances for 3 x 3 parts, found 2 x 2");
    }

    #[test]
    fn weights_into_a_part_sum_to_one() {
        let (combined, weights) = coupling_weights(&[0.5, 2.0, 4.0]);
        assert_relative_eq!(weights.iter().sum::<f64>(), 1.0, epsilon = 1e-15);
        assert_relative_eq!(combined, 1.0 / (2.0 + 0.5 + 0.25));
    }
}
