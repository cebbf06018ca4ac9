//! Posterior of the weights of one column: the weights of all trials together with their mean.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, symmetric};
use nalgebra::{DMatrix, DVector};

/// q(mu_k, w_1k, ..., w_Sk) of a column k, a joint Gaussian.
#[derive(Clone, Debug)]
pub struct ColumnWeights {
    /// `E[w_sk]` `[Q]` of each trial.
    pub mean: Vec<DVector<f64>>,
    /// E[w_sk w_sk^T] [Q x Q] of each trial.
    pub second: Vec<DMatrix<f64>>,
    /// `E[mu_k]` `[Q]`.
    pub centre: DVector<f64>,
    /// E[mu_k mu_k^T] [Q x Q].
    pub centre_second: DMatrix<f64>,
    /// sum_s E[(w_sk - mu_k)(w_sk - mu_k)^T] [Q x Q].
    pub deviation: DMatrix<f64>,
    /// The log-determinant of the joint covariance.
    pub log_determinant: f64,
}

/// The posterior under mu_k ~ N(0, diag `centre_variance`), w_sk | mu_k ~ N(mu_k, `precision`^-1) and a log
/// likelihood of `h`_s^T w - 1/2 w^T `e`_s w for each trial s, given as (e_s [Q x Q], h_s `[Q]`).
///
/// Given mu_k the trials are independent, with C_s = (Lambda + e_s)^-1; integrating them out leaves mu_k with
/// the precision diag(1 / centre_variance) + sum_s Lambda C_s e_s and the information sum_s Lambda C_s h_s.
pub fn infer(
    precision: &DMatrix<f64>,
    centre_variance: &DVector<f64>,
    likelihoods: &[(DMatrix<f64>, DVector<f64>)],
) -> Result<ColumnWeights, NumericsError> {
    const WHAT: &str = "precision of a column's weights";
    let mut log_determinant = 0.0;
    let mut centre_precision = DMatrix::from_diagonal(&centre_variance.map(|v| 1.0 / v));
    let mut information = DVector::zeros(centre_variance.len());
    let mut conditionals = Vec::with_capacity(likelihoods.len());
    for (e, h) in likelihoods {
        let factor = Factor::new(&(precision + e), WHAT)?;
        log_determinant -= factor.log_determinant();
        let c = factor.inverse();
        let pull = &c * precision;
        centre_precision += symmetric(pull.tr_mul(e));
        information += pull.tr_mul(h);
        conditionals.push((c, pull));
    }
    let factor = Factor::new(&centre_precision, WHAT)?;
    log_determinant -= factor.log_determinant();
    let covariance = factor.inverse();
    let centre = &covariance * information;
    let mut deviation = DMatrix::zeros(centre.len(), centre.len());
    let (mut mean, mut second) = (Vec::new(), Vec::new());
    for ((_, h), (c, pull)) in likelihoods.iter().zip(&conditionals) {
        let w = c * h + pull * &centre;
        second.push(symmetric(c + pull * &covariance * pull.transpose()) + &w * w.transpose());
        let away = pull - DMatrix::identity(centre.len(), centre.len());
        let d = &w - &centre;
        deviation += symmetric(c + &away * &covariance * away.transpose()) + &d * d.transpose();
        mean.push(w);
    }
    let centre_second = covariance + &centre * centre.transpose();
    Ok(ColumnWeights { mean, second, centre, centre_second, deviation, log_determinant })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::{dmatrix, dvector};

    #[test]
    fn agrees_with_the_joint_gaussian() {
        let precision = dmatrix![2.0, 0.3; 0.3, 1.0];
        let variance = dvector![3.0, 0.5];
        let likelihoods = [
            (dmatrix![4.0, 1.0; 1.0, 2.0], dvector![1.0, -2.0]),
            (dmatrix![0.5, 0.1; 0.1, 0.2], dvector![0.3, 0.4]),
            (dmatrix![0.0, 0.0; 0.0, 0.0], dvector![0.0, 0.0]),
        ];
        let found = infer(&precision, &variance, &likelihoods).unwrap();
        // (mu, w_1, w_2, w_3) with its precision matrix, entry by entry.
        let mut joint = DMatrix::zeros(8, 8);
        let mut h = DVector::zeros(8);
        for q in 0..2 {
            joint[(q, q)] += 1.0 / variance[q];
        }
        for (s, (e, part)) in likelihoods.iter().enumerate() {
            let at = 2 + 2 * s;
            for (a, b, sign) in [(0, 0, 1.0), (at, at, 1.0), (0, at, -1.0), (at, 0, -1.0)] {
                let mut block = joint.view_mut((a, b), (2, 2));
                block += sign * &precision;
            }
            let mut block = joint.view_mut((at, at), (2, 2));
            block += e;
            h.rows_mut(at, 2).copy_from(part);
        }
        let cover = joint.clone().try_inverse().unwrap();
        let mean = &cover * h;
        assert_relative_eq!(found.log_determinant, -joint.determinant().ln(), epsilon = 1e-10);
        assert_relative_eq!(found.centre, mean.rows(0, 2).into_owned(), epsilon = 1e-12);
        let second = &cover + &mean * mean.transpose();
        let block = |a: usize, b: usize| second.view((2 * a, 2 * b), (2, 2)).into_owned();
        assert_relative_eq!(found.centre_second, block(0, 0), epsilon = 1e-12);
        let mut deviation = DMatrix::zeros(2, 2);
        for s in 0..3 {
            assert_relative_eq!(found.mean[s], mean.rows(2 + 2 * s, 2).into_owned(), epsilon = 1e-12);
            assert_relative_eq!(found.second[s], block(s + 1, s + 1), epsilon = 1e-12);
            deviation += block(s + 1, s + 1) - block(s + 1, 0) - block(0, s + 1) + block(0, 0);
        }
        assert_relative_eq!(found.deviation, deviation, epsilon = 1e-12);
        // A trial without observations has the mean of the others.
        assert_relative_eq!(found.mean[2], found.centre, epsilon = 1e-12);
    }
}
