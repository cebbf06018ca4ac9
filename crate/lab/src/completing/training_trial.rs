//! A training trial completed step by step: where the error comes from.

use crate::completing::answer::finite;
use crate::completing::results::TrainingTrial;
use crate::evaluation::EvaluationError;
use nalgebra::{DMatrix, DVector};
use vcgpdm::models::variational::{Belief, Filter};
use vcgpdm::models::{Coupled, RolloutRequest};

/// The variance of a latent that is known.
const KNOWN: f64 = 1e-6;

/// The errors of a part of the first training trial, `recorded` [frames x D_i] of each part, as multiples of
/// the error of the model's own reconstruction.
pub(super) fn training_trial(
    coupled: Coupled,
    recorded: &[DMatrix<f64>],
    part: usize,
    searched: usize,
) -> Result<TrainingTrial, EvaluationError> {
    let model = coupled.model;
    let (learned, order) = (&model.starts[0], coupled.order());
    let filter = coupled.filter(&RolloutRequest::default())?;
    let frames = recorded[part].nrows();
    // All errors are over the frames that can be predicted.
    let error = |y: &DMatrix<f64>| {
        let rows = |y: &DMatrix<f64>| y.rows(order, frames - order).into_owned();
        (rows(y) - rows(&recorded[part])).norm_squared()
    };
    let own = error(&model.observations(learned)[part]);
    let times = |y: &DMatrix<f64>| finite("the error of a training trial", error(y) / own);

    let completed = |observed: &[DMatrix<f64>]| -> Result<f64, EvaluationError> {
        let latents = filter.smoothed(&filter.run_from_best(observed, searched)?)?;
        times(&filter.mean_columns(part, &latents)?)
    };
    let mut given = recorded.to_vec();
    given[part].fill(f64::NAN);

    Ok(TrainingTrial {
        all_observed: completed(recorded)?,
        completed: completed(&given)?,
        given_latents: times(&with_given_latents(&filter, learned, part)?)?,
        one_frame: times(&one_frame_ahead(&filter, learned, part)?)?,
    })
}

/// The belief that the first p frames have these latents.
fn known_start(filter: &Filter, latents: &[DMatrix<f64>], frame: usize) -> Belief {
    let order = filter.order();
    let history = |x: &DMatrix<f64>| x.rows(frame, order).transpose().as_slice().to_vec();
    let mean = DVector::from_vec(latents.iter().flat_map(history).collect());
    let size = mean.len();
    Belief { mean, covariance: DMatrix::identity(size, size) * KNOWN }
}

/// The mean columns of a part in every frame when the other parts have their learned latents, and this part
/// follows from the dynamics.
fn with_given_latents(
    filter: &Filter,
    latents: &[DMatrix<f64>],
    part: usize,
) -> Result<DMatrix<f64>, EvaluationError> {
    let mut belief = known_start(filter, latents, 0);
    columns_after(filter, latents, part, |t| {
        belief = filter.predict(&belief)?;
        for (other, x) in latents.iter().enumerate().filter(|(other, _)| *other != part) {
            let row: Vec<f64> = x.row(t).iter().copied().collect();
            filter.clamp(&mut belief, other, &row)?;
        }
        Ok(belief.clone())
    })
}

/// The mean columns of a part in every frame, predicted from the learned latents of all parts until then.
fn one_frame_ahead(
    filter: &Filter,
    latents: &[DMatrix<f64>],
    part: usize,
) -> Result<DMatrix<f64>, EvaluationError> {
    let order = filter.order();
    columns_after(filter, latents, part, |t| Ok(filter.predict(&known_start(filter, latents, t - order))?))
}

/// The mean columns of a part under the belief about each frame that has a history; the first frames are 0.
fn columns_after(
    filter: &Filter,
    latents: &[DMatrix<f64>],
    part: usize,
    mut belief: impl FnMut(usize) -> Result<Belief, EvaluationError>,
) -> Result<DMatrix<f64>, EvaluationError> {
    let frames = latents[part].nrows();
    let mut columns = DMatrix::zeros(frames, filter.columns()[part]);
    for t in filter.order()..frames {
        let (mean, covariance) = filter.latents(&belief(t)?, part, 0);
        columns.set_row(t, &filter.column_moments(part, &mean, &covariance)?.mean.transpose());
    }
    Ok(columns)
}
