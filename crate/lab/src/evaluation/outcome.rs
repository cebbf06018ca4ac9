//! The outcome of one candidate in one fold of a cross-validation.

use crate::evaluation::details::Details;
use crate::evaluation::stats::mean;
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use vcgpdm_core::models::variational::BoundTerms;
use vcgpdm_core::models::{EndReason, Score};

/// The outcome of one model in one fold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Outcome {
    /// The error of the prediction.
    pub score: Score,
    /// The bound on the log evidence, in nats, where the model has one.
    pub bound: Option<f64>,
    /// What training maximised, at its best.
    pub objective: f64,
    /// Iterations of the training.
    pub iterations: usize,
    /// Seconds of the training.
    pub seconds: f64,
    /// Frames trained on.
    pub frames: usize,
    /// Numbers that must be kept to roll out.
    pub stored_numbers: usize,
    /// Why training ended, as a sentence.
    pub reason: Option<String>,
    /// The terms of the bound, in nats, of each part where they have parts; absent without such a bound, or
    /// in results of earlier programs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub terms: Option<BoundTerms>,
    /// The error of each part; absent in results of earlier programs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub part_errors: Vec<f64>,
    /// The mean error over the trials trained on; absent where one could not be scored, or in results of
    /// earlier programs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub training_mse: Option<f64>,
    /// More about the prediction; absent where a number is not finite, in results of the page, and of earlier
    /// versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(skip))]
    pub details: Option<Details>,
    /// Some results of earlier versions have a prediction from observed first frames; it is ignored.
    #[serde(default, skip_serializing, rename = "observed_start")]
    #[cfg_attr(feature = "types", ts(skip))]
    pub(crate) ignored: IgnoredAny,
}

/// Numbers that differ by less than this, relative to the larger, count as equal: the last digits of products
/// of large matrices depend on the processor.
const SAME: f64 = 1e-6;

/// A number in which two outcomes differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Which number.
    pub name: &'static str,
    /// The number of the one outcome.
    pub first: f64,
    /// The number of the other outcome.
    pub second: f64,
}

impl Outcome {
    /// The first number in which the outcomes of one job differ. Times and reasons may differ, and numbers
    /// that only one outcome has are not compared.
    pub fn difference(&self, other: &Outcome) -> Option<Difference> {
        let numbers = |outcome: &Outcome| {
            let parts = outcome.part_errors.iter().map(|error| ("error of a part", Some(*error)));
            let score = &outcome.score;
            [
                ("DTW MSE", Some(score.dtw_mse)),
                ("MSE", Some(score.mse)),
                ("variance", Some(score.variance)),
                ("bound", outcome.bound),
                ("objective", Some(outcome.objective)),
                ("frames", Some(outcome.frames as f64)),
                ("training MSE", outcome.training_mse),
            ]
            .into_iter()
            .chain(parts)
            .collect::<Vec<_>>()
        };
        numbers(self).into_iter().zip(numbers(other)).find_map(|((name, first), (_, second))| {
            let (first, second) = (first?, second?);
            let differ = (first - second).abs() > SAME * first.abs().max(second.abs());
            differ.then_some(Difference { name, first, second })
        })
    }

    /// Whether this seed represents its candidate in the fold better than another seed: its rollouts repeat the
    /// training trials with a smaller error. A seed without this error is worse. In results of earlier versions
    /// no seed has it, and the higher objective decides.
    pub fn is_better_seed(&self, other: &Outcome) -> bool {
        match (self.training_mse, other.training_mse) {
            (Some(error), Some(other)) => error < other,
            (Some(_), None) => true,
            (None, Some(_)) => false,
            (None, None) => self.objective > other.objective,
        }
    }

    /// Whether the training ended because its objective no longer changed; absent if the reason is unknown.
    pub fn converged(&self) -> Option<bool> {
        let reason = self.reason.as_deref()?;
        if reason == EndReason::Iterations.to_string() {
            return Some(false);
        }
        let settled = [EndReason::BoundSettled, EndReason::WeightedBoundSettled, EndReason::DensitySettled];
        // Files of earlier versions say it in other words.
        let settles = reason == "the weighted bound no longer rises";
        (settles || settled.iter().any(|end| reason == end.to_string())).then_some(true)
    }
}

/// The share of trainings that ended because their objective no longer changed, of those with a known reason.
pub(super) fn share_converged<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> Option<f64> {
    let ends = outcomes.filter_map(Outcome::converged);
    let shares: Vec<f64> = ends.map(|converged| f64::from(u8::from(converged))).collect();
    (!shares.is_empty()).then(|| mean(&shares))
}
