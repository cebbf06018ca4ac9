//! More about a prediction than its error after time warping.

use crate::evaluation::predictor::{Forecast, Predictor};
use crate::evaluation::training_trials::TrainingTrials;
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use vcgpdm_core::elementary::Elementary;
use vcgpdm_core::models::dtw_mse;
use vcgpdm_core::motion::measures::measures;

/// The time after the given frames over which frames are compared one by one, in seconds.
const SOON: f64 = 0.5;
/// The time after the given frames over which bands are compared, in seconds.
const BANDS: f64 = 2.0;
/// A rollout is watched for this time, in seconds.
const LONG: f64 = 20.0;
/// It stands still if its columns keep their last values for this time, in seconds, ...
const STILL: f64 = 1.0;
/// ... up to this share of the root mean square deviation of the trial's columns from their means.
const ONE_POSE: f64 = 0.1;
/// Half widths of the bands that hold 50 and 95 % of a standard Gaussian.
const HALF_50: f64 = 0.674_489_750_196_081_7;
const HALF_95: f64 = 1.959_963_984_540_054;

/// Numbers about the prediction of one trial held out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Details {
    /// Mean squared difference of each part frame by frame over the first half second after the given frames,
    /// not centred, in the squared units of the columns.
    pub first_half_second: Vec<f64>,
    /// The error of each part after time warping along a path of its own.
    pub own_path: Vec<f64>,
    /// Mean speed of the body's nodes relative to the root, in metres a second.
    pub speed: Compared<f64>,
    /// Horizontal speed of the standing foot divided by the walking speed; absent if the body hardly walks.
    pub foot_slide: Compared<Option<f64>>,
    /// Whether a rollout of 20 seconds stands still at its end: all columns keep their last values for a
    /// second, up to a tenth of the spread of the trial.
    pub still_at_20_s: bool,
    /// How good the predicted variances are; absent for models without them.
    pub bands: Option<Bands>,
}

/// A number of the prediction and of the trial held out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Compared<T> {
    /// In the prediction.
    pub predicted: T,
    /// In the trial held out.
    pub recorded: T,
}

/// Predicted Gaussians of single columns and frames, over the first two seconds after the given frames,
/// observation noise included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Bands {
    /// The share of recorded numbers in the bands that should hold 50 %.
    pub within_50: f64,
    /// The share of recorded numbers in the bands that should hold 95 %.
    pub within_95: f64,
    /// Mean log density of a recorded number, in nats.
    pub log_density: f64,
}

/// What is predicted: the trial held out, of which the first frames are given as the last training sequence.
pub(super) struct Predicted<'a> {
    pub training: &'a TrainingTrials,
    /// All columns of the trial held out [T x D].
    pub actual: &'a DMatrix<f64>,
}

impl Predicted<'_> {
    /// The details of a model's prediction; `None` if it cannot be rolled out for 20 seconds, or a number is
    /// not finite.
    pub fn details(&self, model: &dyn Predictor) -> Option<Details> {
        let (body, sequences) = (self.training.body(), &self.training.movements().sequences);
        let (last, given) = (sequences.len() - 1, sequences.last()?.frames);
        let frames = |seconds: f64| (seconds / body.frame_time).round() as usize;
        let made = self.training.by_part(model.rollout(last, self.actual.nrows()).ok()?);
        let actual = body.centred(self.actual);
        let end = |seconds: f64| (given + frames(seconds)).min(self.actual.nrows());
        let soon = given.min(end(SOON))..end(SOON);
        let difference = |(made, actual): (&DMatrix<f64>, &DMatrix<f64>)| {
            let apart = made.rows_range(soon.clone()) - actual.rows_range(soon.clone());
            apart.norm_squared() / apart.len().max(1) as f64
        };
        let first_half_second = made.iter().zip(&actual).map(difference).collect();
        let own_path =
            made.iter().zip(&actual).map(|(made, actual)| Some(dtw_mse(made, actual).ok()?.dtw_mse));
        let skeleton = body.mapping.skeleton();
        let measured = |y: &DMatrix<f64>| Some(measures(skeleton, &body.positions(y).ok()?, body.frame_time));
        let (predicted, recorded) = (measured(&body.columns(&made))?, measured(self.actual)?);
        let long = self.training.by_part(model.rollout(last, frames(LONG)).ok()?);
        let bands = match model.forecast(last, end(BANDS)).ok()? {
            Some(forecast) => Some(bands(&self.split(forecast), &actual, given)?),
            None => None,
        };
        let details = Details {
            first_half_second,
            own_path: own_path.collect::<Option<_>>()?,
            speed: Compared { predicted: predicted.joint_speed, recorded: recorded.joint_speed },
            foot_slide: Compared { predicted: predicted.foot_slide, recorded: recorded.foot_slide },
            still_at_20_s: is_still(&long, &actual, frames(STILL)),
            bands,
        };
        details.is_finite().then_some(details)
    }

    /// The forecast of a model of the whole body, divided into parts.
    fn split(&self, forecast: Forecast) -> Forecast {
        let (means, variances) = (self.training.by_part(forecast.means), forecast.variances);
        Forecast { means, variances: self.training.by_part(variances) }
    }
}

impl Details {
    /// Every number, for checks.
    pub(super) fn numbers(&self) -> impl Iterator<Item = f64> {
        let bands = self.bands.map(|bands| [bands.within_50, bands.within_95, bands.log_density]);
        let speeds = [self.speed.predicted, self.speed.recorded];
        let slides = [self.foot_slide.predicted, self.foot_slide.recorded].into_iter().flatten();
        let errors = self.first_half_second.iter().chain(&self.own_path).copied();
        errors.chain(speeds).chain(slides).chain(bands.into_iter().flatten())
    }

    /// Whether every number is finite: JSON has no others.
    pub(super) fn is_finite(&self) -> bool {
        self.numbers().all(f64::is_finite)
    }
}

/// Coverage and density over the frames of the forecast after the given ones; `None` without such a frame.
fn bands(forecast: &Forecast, actual: &[DMatrix<f64>], given: usize) -> Option<Bands> {
    let (mut within_50, mut within_95, mut density, mut count) = (0.0, 0.0, 0.0, 0.0);
    for ((mean, variance), actual) in forecast.means.iter().zip(&forecast.variances).zip(actual) {
        for t in given..mean.nrows() {
            for d in 0..mean.ncols() {
                let (variance, apart) = (variance[(t, d)], actual[(t, d)] - mean[(t, d)]);
                let squares = apart * apart / variance;
                within_50 += f64::from(u8::from(squares <= HALF_50 * HALF_50));
                within_95 += f64::from(u8::from(squares <= HALF_95 * HALF_95));
                density -= 0.5 * ((std::f64::consts::TAU * variance).logarithm() + squares);
                count += 1.0;
            }
        }
    }
    let bands =
        Bands { within_50: within_50 / count, within_95: within_95 / count, log_density: density / count };
    (count > 0.0).then_some(bands)
}

/// Whether the columns of all parts keep their last values for this number of frames.
fn is_still(motion: &[DMatrix<f64>], trial: &[DMatrix<f64>], frames: usize) -> bool {
    let spread: f64 = trial.iter().flat_map(|y| y.column_iter()).map(|column| column.variance()).sum();
    let rows = motion.first().map_or(0, DMatrix::nrows);
    (rows.saturating_sub(frames + 1)..rows).all(|t| {
        let apart = motion.iter().map(|y| (y.row(t) - y.row(rows - 1)).norm_squared()).sum::<f64>();
        apart <= ONE_POSE * ONE_POSE * spread
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::cross_validation::{Fold, START_FRAMES};
    use crate::evaluation::rivals::Rival;
    use approx::assert_relative_eq;
    use vcgpdm_core::models::{DmpSettings, Settings, VariationalSettings};
    use vcgpdm_core::motion::{parts, samples};

    #[test]
    fn knows_more_of_a_prediction_than_its_error() {
        let trials = ["walk-1", "walk-2", "walk-3"].map(|id| samples::clip(id).unwrap());
        let parts = parts::presets(&trials[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap();
        let fold = Fold::new(&trials, 1, 2, &parts.parts, 20.0, START_FRAMES).unwrap();
        let settings = VariationalSettings::default().with_points(6, 6).with_max_iterations(60);
        for (candidate, has_bands) in [
            (Settings::Vcgpdm(settings.clone()).into(), true),
            (Settings::Vgpdm(settings).into(), true),
            (Settings::DmpRhythmic(DmpSettings { bases: 20 }).into(), false),
            (Rival::ProMp { bases: 12 }.into(), true),
            (Rival::Ar { components: 4, order: 2 }.into(), true),
        ] {
            let outcome = fold.evaluate(&candidate, 0, &|| 0.0, &mut |_| true).unwrap().unwrap();
            let details = outcome.details.unwrap();
            assert_eq!((details.first_half_second.len(), details.bands.is_some()), (2, has_bands));
            // A path of its own costs a part no more than the path of the whole body, but for the penalty.
            for (own, shared) in details.own_path.iter().zip(&outcome.part_errors) {
                assert!(*own < 1.3 * shared, "{candidate:?}: {own} {shared}");
            }
            assert!(
                details.speed.recorded > 0.3 && details.foot_slide.recorded.unwrap() < 0.3,
                "{details:?}"
            );
            if let Some(bands) = details.bands {
                assert!(
                    bands.within_50 < bands.within_95 && bands.within_95 > 0.3,
                    "{candidate:?} {bands:?}"
                );
            }
        }
    }

    #[test]
    fn counts_recorded_numbers_within_bands() {
        let forecast =
            Forecast { means: vec![DMatrix::zeros(3, 2)], variances: vec![DMatrix::from_element(3, 2, 4.0)] };
        // The first frame is given. Half widths: 1.35 and 3.92.
        let actual = [DMatrix::from_row_slice(3, 2, &[99.0, 99.0, 1.3, -1.4, 3.9, -4.0])];
        let found = bands(&forecast, &actual, 1).unwrap();
        assert_eq!((found.within_50, found.within_95), (0.25, 0.75));
        let squares = (1.3 * 1.3 + 1.4 * 1.4 + 3.9 * 3.9 + 16.0) / 4.0 / 4.0;
        let expected = -0.5 * ((std::f64::consts::TAU * 4.0).ln() + squares);
        assert_relative_eq!(found.log_density, expected, epsilon = 1e-12);
        assert_eq!(bands(&forecast, &actual, 3), None);
    }

    #[test]
    fn a_motion_that_comes_to_rest_stands_still() {
        let trial = [DMatrix::from_fn(60, 2, |t, _| (0.3 * t as f64).sin())];
        let motion = |moves: usize| {
            [DMatrix::from_fn(400, 2, |t, _| if t < moves { (0.3 * t as f64).sin() } else { 0.2 })]
        };
        assert!(!is_still(&motion(400), &trial, 20));
        assert!(!is_still(&motion(390), &trial, 20));
        assert!(is_still(&motion(370), &trial, 20));
    }
}
