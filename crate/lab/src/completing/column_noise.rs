//! A noise variance for each column, measured on training trials that the pose map did not see.
//!
//! The model has one noise variance beta for all columns of a part, fitted to trials that it has seen. Here
//! the pose map of a part is inferred again without one training trial after the other, at the learned
//! latents and with the learned kernel: the posterior mean of its inducing outputs is K (K + Phi^T Phi /
//! beta)^-1 Phi^T y / beta (Titsias 2009), Phi = k(x, r) over the frames of the other trials.

use nalgebra::DMatrix;
use vcgpdm::gp::NumericsError;
use vcgpdm::internals::Factor;
use vcgpdm::models::variational::PoseMap;

/// The least variance of a column, as a share of beta.
const LEAST: f64 = 1e-3;

/// The mean squared error of each column `[D_i]` in trials left out, of learned latents `x` [frames x Q_i]
/// and columns `y` [frames x D_i] of each training trial.
pub fn column_noise(
    map: &PoseMap,
    jitter: f64,
    x: &[&DMatrix<f64>],
    y: &[&DMatrix<f64>],
) -> Result<Vec<f64>, NumericsError> {
    let (r, beta) = (map.r(), map.beta());
    let phis: Vec<DMatrix<f64>> = x.iter().map(|x| map.kernel().cross_covariance(x, r)).collect();
    let width = y.first().map_or(0, |y| y.ncols());
    let (mut squares, mut frames) = (vec![0.0; width], 0);
    for (left_out, (phi, recorded)) in phis.iter().zip(y).enumerate() {
        let mut precision = map.kernel().inducing_covariance(r, jitter);
        let mut pull = DMatrix::zeros(r.nrows(), width);
        for (k, (phi, y)) in phis.iter().zip(y).enumerate() {
            if k != left_out {
                precision += phi.tr_mul(phi) / beta;
                pull += phi.tr_mul(y) / beta;
            }
        }
        let weights = Factor::new(&precision, "precision of a pose map without a trial")?.solve(&pull);
        let errors = phi * weights - *recorded;
        for (sum, column) in squares.iter_mut().zip(errors.column_iter()) {
            *sum += column.norm_squared();
        }
        frames += recorded.nrows();
    }
    Ok(squares.iter().map(|sum| (sum / frames.max(1) as f64).max(LEAST * beta)).collect())
}
