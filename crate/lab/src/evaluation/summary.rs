//! The values of a comparison: its tables, and the claims of the papers.

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::details::{Bands, Compared};
use crate::evaluation::stats::{Interval, mean, standard_error};
use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::Not;

/// A mean over folds. The seeds of a fold are averaged first.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Spread {
    /// The mean.
    pub mean: f64,
    /// Null for a single fold.
    pub standard_error: Option<f64>,
    /// Number of folds.
    pub count: usize,
}

impl Spread {
    /// The spread of these values, one a fold; absent without values.
    pub(super) fn new(values: &[f64]) -> Option<Self> {
        let (mean, standard_error, count) = (mean(values), standard_error(values), values.len());
        (count > 0).then_some(Self { mean, standard_error, count })
    }
}

/// One candidate: a row of figure 4 of Velychko et al. (2018).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct ModelSummary {
    /// Its kind of model.
    #[cfg_attr(feature = "types", ts(type = "ModelKind | \"promp\" | \"ar\""))]
    pub model: CandidateKind,
    /// The kind with its settings.
    #[cfg_attr(feature = "types", ts(type = "Candidate | Rival"))]
    pub candidate: Candidate,
    /// The settings that differ from those of other candidates, as a short text.
    pub label: String,
    /// Mean squared error after dynamic time warping.
    pub mse: Spread,
    /// The median error over the folds. A single bad rollout hardly changes it.
    pub mse_median: f64,
    /// The same error on the training trials; null if the results do not contain it.
    pub training_mse: Option<Spread>,
    /// The error of a constant prediction.
    pub variance: f64,
    /// The bound on the log evidence, in nats; null for a model without a bound.
    pub bound: Option<Spread>,
    /// Seconds of a training.
    pub seconds: Spread,
    /// How many numbers a rollout needs from the model.
    pub stored_numbers: Spread,
    /// The share of trainings that ended because they converged; null if unknown.
    pub converged: Option<f64>,
    /// Means of the terms of the bound, in nats; null if the results do not contain them.
    #[cfg_attr(feature = "types", ts(inline))]
    pub terms: Option<TermMeans>,
    /// The mean error of each part; empty if the results do not contain it.
    pub part_errors: Vec<f64>,
    /// More about the predictions; null if the results do not contain it, as those computed here.
    pub details: Option<DetailMeans>,
    /// Number of held-out trials.
    pub folds: usize,
    /// Number of trainings.
    pub runs: usize,
    /// Candidates that differ only in size form a group. For each held-out trial, the claims choose one
    /// candidate of the group. For the candidate that they choose most often, this is the number of
    /// candidates in its group; for the others it is 0.
    pub stands_for: usize,
}

/// Means over folds: more about predictions than their error.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "PredictionDetails"))]
pub struct DetailMeans {
    /// Mean squared error of each part over the first half second, frame by frame.
    pub first_half_second: Vec<f64>,
    /// The error of each part after time warping along a path of its own.
    pub own_path: Vec<f64>,
    /// Speed of the prediction divided by that of the trial.
    pub speed: f64,
    /// Horizontal speed of the standing foot, in walking speeds; null if the body hardly walks.
    #[cfg_attr(feature = "types", ts(inline))]
    pub foot_slide: Option<Compared<f64>>,
    /// How many of the rollouts no longer move after 20 seconds, divided by their number.
    pub still_at_20_s: f64,
    /// Shares of recorded numbers in the predicted bands, and their mean log density; null without variances.
    #[cfg_attr(feature = "types", ts(inline))]
    pub bands: Option<Bands>,
    /// Number of folds.
    pub folds: usize,
}

/// Means of the terms of a bound, in nats.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct TermMeans {
    /// The kinematics terms of all parts: the pose maps.
    pub pose: f64,
    /// The dynamics terms of all parts, with initial states and entropy.
    pub dynamics: f64,
}

/// One candidate in figure 1 of the supplement of Velychko et al. (2017).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct BoundAndError {
    /// Its settings, in a few words.
    pub label: String,
    /// The mean bound, in nats.
    pub bound: f64,
    /// The mean error.
    pub mse: f64,
}

/// Bounds and errors of one kind of model in several sizes. All other settings are the same.
///
/// Figure 1 of the supplement of Velychko et al. (2017).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Correlation {
    /// The kind of model.
    #[cfg_attr(feature = "types", ts(as = "vcgpdm_core::models::ModelKind"))]
    pub model: CandidateKind,
    /// The settings that the candidates share; empty if the kind of model has only one group.
    pub label: String,
    /// Number of candidates.
    pub settings: usize,
    /// Number of held-out trials for which all candidates have results.
    pub folds: usize,
    /// Spearman's rank correlation within each trial; the mean over the trials.
    pub rank: f64,
    /// Its 95 % interval over the trials by Student's t; null where there is none.
    pub interval: Option<Interval>,
    /// The candidates, with means over these trials.
    pub points: Vec<BoundAndError>,
    /// The correlation within each trial.
    #[serde(skip)]
    #[cfg_attr(feature = "types", ts(skip))]
    pub trials: BTreeMap<usize, f64>,
}

/// Mean number of training frames, and mean seconds of an iteration.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct FramesAndTime {
    /// Mean number of training frames.
    pub frames: f64,
    /// Mean seconds of an iteration.
    pub seconds: f64,
    /// Mean seconds of a whole training.
    pub training_seconds: f64,
}

/// Training time of one candidate against the number of training frames.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Growth {
    /// The kind of model.
    #[cfg_attr(feature = "types", ts(as = "vcgpdm_core::models::ModelKind"))]
    pub model: CandidateKind,
    /// Its settings, in a few words.
    pub label: String,
    /// Sorted by the number of frames, the lowest first.
    pub points: Vec<FramesAndTime>,
    /// The exponent k if the time of an iteration grows as frames to the power k; null if it cannot be
    /// estimated.
    pub exponent: Option<f64>,
    /// The 95 % interval of the exponent; null if it cannot be estimated.
    pub interval: Option<Interval>,
    /// The same exponent for a whole training; null if it cannot be estimated.
    pub training_exponent: Option<f64>,
    /// The 95 % interval of `trainingExponent`.
    pub training_interval: Option<Interval>,
    /// The share of these trainings that ended because they converged; null if unknown.
    pub converged: Option<f64>,
}

/// Compares the bounds and errors of the models with one part and with several parts in one fold.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Evidence {
    /// The held-out trial.
    pub trial: String,
    /// The bound of the vCGPDM minus the bound of the vGPDM, in nats.
    pub log_bayes_factor: f64,
    /// The error of the vCGPDM divided by the error of the vGPDM.
    pub error_ratio: f64,
}

/// Whether results agree with a claim.
/// The answer to a claim in several parts is the largest: yes if all are, no if one is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum ClaimAnswer {
    /// The whole interval agrees with it.
    Yes,
    /// The interval has both sides, or there are too few trials for an interval.
    Undecided,
    /// The whole interval contradicts it.
    No,
}

impl ClaimAnswer {
    /// Whether what has this interval is below a value.
    pub fn below(interval: Option<Interval>, value: f64) -> Self {
        match interval {
            Some(interval) if interval.high < value => ClaimAnswer::Yes,
            Some(interval) if interval.low > value => ClaimAnswer::No,
            _ => ClaimAnswer::Undecided,
        }
    }

    /// The word for tables.
    pub fn word(self) -> &'static str {
        match self {
            ClaimAnswer::Yes => "yes",
            ClaimAnswer::No => "no",
            ClaimAnswer::Undecided => "undecided",
        }
    }
}

/// The answer to the contrary.
impl Not for ClaimAnswer {
    type Output = Self;

    fn not(self) -> Self {
        match self {
            ClaimAnswer::Yes => ClaimAnswer::No,
            ClaimAnswer::No => ClaimAnswer::Yes,
            ClaimAnswer::Undecided => ClaimAnswer::Undecided,
        }
    }
}

/// A claim of the papers, and whether these results agree with it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Claim {
    /// The sentence of the paper, or a related question of ours.
    pub claim: String,
    /// Where the claim is in the papers: year and section.
    pub place: String,
    /// Our criterion for the claim.
    pub criterion: String,
    /// The measured effect, with its interval.
    pub found: String,
    /// Whether the results agree with the claim. It is "undecided" unless the whole interval is on one side.
    #[cfg_attr(feature = "types", ts(inline))]
    pub answer: ClaimAnswer,
    /// Whether it is one of the claims that were named beforehand. Their answers are corrected for their
    /// number.
    pub primary: bool,
    /// Of a primary claim over several persons: the ratio of the errors in the median trial of each person, `null`
    /// without a common trial.
    pub persons: Vec<Option<f64>>,
}
