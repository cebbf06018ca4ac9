//! What a comparison needs of a trained model.

use nalgebra::DMatrix;
use vcgpdm_core::models::variational::{BoundTerms, Vcgpdm};
use vcgpdm_core::models::{FittedModel, Reading, RolloutError};

/// Number of sampled futures from which the bands of a variational model are computed.
const FUTURES: u64 = 100;

/// A trained model that predicts the columns of its parts. A model of the whole body has one part with the
/// columns of all parts side by side.
pub trait Predictor {
    /// Centred columns of each part [frames x D_i], from the beginning of a training sequence.
    ///
    /// # Errors
    /// There is no such sequence, or the number of frames is 0 or too large.
    fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError>;

    /// The same with variances, observation noise included; `None` for models that predict no variance.
    ///
    /// # Errors
    /// As [`Predictor::rollout`], or a covariance cannot be factorised.
    fn forecast(&self, sequence: usize, frames: usize) -> Result<Option<Forecast>, RolloutError>;

    /// Numbers that a rollout of one sequence needs.
    fn stored_numbers(&self) -> usize;

    /// The bound on the log evidence, in nats, if the model has one.
    fn bound(&self) -> Option<f64> {
        None
    }

    /// The terms of the bound, if the model has them.
    fn terms(&self) -> Option<&BoundTerms> {
        None
    }
}

/// A Gaussian for each frame and centred column of each part.
#[derive(Clone, Debug)]
pub struct Forecast {
    /// Means of each part [frames x D_i].
    pub means: Vec<DMatrix<f64>>,
    /// Variances of each part [frames x D_i], positive.
    pub variances: Vec<DMatrix<f64>>,
}

impl Predictor for FittedModel {
    fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        FittedModel::rollout(self, sequence, frames)
    }

    fn forecast(&self, sequence: usize, frames: usize) -> Result<Option<Forecast>, RolloutError> {
        match self {
            FittedModel::Vcgpdm(model) => futures(model, sequence, frames).map(Some),
            FittedModel::Map(_) | FittedModel::Tmp(_) | FittedModel::Dmp(_) => Ok(None),
        }
    }

    fn stored_numbers(&self) -> usize {
        FittedModel::stored_numbers(self)
    }

    fn bound(&self) -> Option<f64> {
        FittedModel::bound(self)
    }

    fn terms(&self) -> Option<&BoundTerms> {
        FittedModel::terms(self)
    }
}

/// Means and variances over sampled futures, plus the observation noise beta of each part. The variance of the
/// pose map itself is left out, as in `vcgpdm rollout --samples`.
fn futures(model: &Vcgpdm, sequence: usize, frames: usize) -> Result<Forecast, RolloutError> {
    let dynamics = model.predictive_dynamics(&model.alpha, Reading::AsLearned)?;
    let start = model.start(sequence, 0)?;
    let (mut sums, mut squares): (Vec<DMatrix<f64>>, Vec<DMatrix<f64>>) = (model.parts.iter())
        .map(|map| (DMatrix::zeros(frames, map.mean().ncols()), DMatrix::zeros(frames, map.mean().ncols())))
        .unzip();
    for seed in 0..FUTURES {
        let made = model.observations(&dynamics.sample(&start, frames, seed)?);
        for ((sum, squares), y) in sums.iter_mut().zip(&mut squares).zip(&made) {
            *sum += y;
            *squares += y.component_mul(y);
        }
    }
    let count = FUTURES as f64;
    let means: Vec<DMatrix<f64>> = sums.iter().map(|sum| sum / count).collect();
    let variance = |((mean, squares), beta): ((&DMatrix<f64>, &DMatrix<f64>), f64)| {
        mean.zip_map(squares, |mean, squares| {
            beta + ((squares - count * mean * mean) / (count - 1.0)).max(0.0)
        })
    };
    let betas = model.parts.iter().map(|map| map.beta());
    let variances = means.iter().zip(&squares).zip(betas).map(variance).collect();
    Ok(Forecast { means, variances })
}
