//! The values of a comparison: its tables, and the claims of the papers.

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::details::{Bands, Compared};
use crate::evaluation::stats::{Interval, mean, standard_error};
use serde::Serialize;

/// A mean over folds; seeds of the same fold are averaged first.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// The mean.
    pub mean: f64,
    /// Its standard error; absent for a single fold.
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
pub struct ModelSummary {
    /// Its kind of model.
    pub model: CandidateKind,
    /// The kind with its settings.
    pub candidate: Candidate,
    /// The settings that differ from other candidates, in a few words.
    pub label: String,
    /// Mean squared error after dynamic time warping, in the squared units of the columns.
    pub mse: Spread,
    /// The median error over the folds, which a single bad rollout does not move.
    pub mse_median: f64,
    /// The same error on the training trials, if the results have it.
    pub training_mse: Option<Spread>,
    /// The error of a motionless prediction: the variance of the trial.
    pub variance: f64,
    /// The bound on the log evidence, in nats, if the model has one.
    pub bound: Option<Spread>,
    /// Seconds of a training.
    pub seconds: Spread,
    /// Numbers that a rollout needs.
    pub stored_numbers: Spread,
    /// The share of trainings that ended because their objective no longer changed, 0 to 1; absent for models
    /// without iterations.
    pub converged: Option<f64>,
    /// The terms of the bound, means over folds, if the results have them.
    pub terms: Option<TermMeans>,
    /// The mean error of each part, in the order of the setting's parts, after the same time warping; empty
    /// if the results do not have it.
    pub part_errors: Vec<f64>,
    /// More about its predictions, if results have it.
    pub details: Option<DetailMeans>,
    /// Number of trials held out.
    pub folds: usize,
    /// Number of trainings.
    pub runs: usize,
    /// Number of candidates that it represents: all that differ only in size, if claims choose it for most
    /// trials; else 0.
    pub stands_for: usize,
}

/// Means of [`Details`](crate::evaluation::Details) over the folds that have them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DetailMeans {
    /// Mean squared error of each part over the first half second, frame by frame.
    pub first_half_second: Vec<f64>,
    /// The error of each part after time warping along a path of its own.
    pub own_path: Vec<f64>,
    /// Speed of the prediction divided by that of the trial.
    pub speed: f64,
    /// Foot slide of the prediction, and of the trial; absent if the body hardly walks.
    pub foot_slide: Option<Compared<f64>>,
    /// The share of rollouts that stand still after 20 seconds, 0 to 1.
    pub still_at_20_s: f64,
    /// Coverage and density of the predicted bands; absent for models without variances.
    pub bands: Option<Bands>,
    /// Number of folds.
    pub folds: usize,
}

/// Means of the terms of a bound, in nats.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TermMeans {
    /// The kinematics terms of all parts: the pose maps.
    pub pose: f64,
    /// The dynamics terms of all parts, with initial states and entropy.
    pub dynamics: f64,
}

/// One candidate in figure 1 of the supplement of Velychko et al. (2017).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoundAndError {
    /// Its settings, in a few words.
    pub label: String,
    /// The mean bound, in nats.
    pub bound: f64,
    /// The mean error.
    pub mse: f64,
}

/// Bound and error of one kind of model over its inducing points (primitives of the TMP), all other settings
/// being the same: figure 1 of the supplement of Velychko et al. (2017).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Correlation {
    /// The kind of model.
    pub model: CandidateKind,
    /// The settings that the candidates share, in a few words, if the kind has several such groups; else
    /// empty.
    pub label: String,
    /// Number of candidates.
    pub settings: usize,
    /// Number of trials held out that all of these candidates have.
    pub folds: usize,
    /// Spearman's rank correlation of bound and error within each trial; the mean over the trials.
    pub rank: f64,
    /// Its 95 % interval by a bootstrap over the trials; absent for a single trial.
    pub interval: Option<Interval>,
    /// The candidates, with means over these trials.
    pub points: Vec<BoundAndError>,
}

/// Number of training frames, and time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FramesAndTime {
    /// Mean number of training frames.
    pub frames: f64,
    /// Mean seconds of an iteration.
    pub seconds: f64,
    /// Mean seconds of a whole training.
    pub training_seconds: f64,
}

/// Training time of one candidate over the training frames: figure 2 of the supplement of Velychko et al.
/// (2017).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Growth {
    /// The kind of model.
    pub model: CandidateKind,
    /// Its settings, in a few words.
    pub label: String,
    /// From few to many frames.
    pub points: Vec<FramesAndTime>,
    /// The exponent k, if the time of an iteration grows as frames to the power k; absent with too few
    /// points.
    pub exponent: Option<f64>,
    /// The 95 % interval of k, by Student's t of the slope.
    pub interval: Option<Interval>,
    /// The exponent for a whole training, which may need more iterations of more frames; absent with too few
    /// points.
    pub training_exponent: Option<f64>,
    /// The 95 % interval of this exponent.
    pub training_interval: Option<Interval>,
    /// The share of these trainings that ended because their objective no longer changed, 0 to 1; absent for
    /// models without iterations.
    pub converged: Option<f64>,
}

/// Bounds and errors of two splits of the body in one fold.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Evidence {
    /// The name of the trial held out.
    pub trial: String,
    /// The bound of the vCGPDM minus that of the vGPDM, in nats: the logarithm of a Bayes factor (2020,
    /// equation 2.12), as far as both bounds are tight.
    pub log_bayes_factor: f64,
    /// The error of the vCGPDM divided by that of the vGPDM.
    pub error_ratio: f64,
}

/// Whether results agree with a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ClaimAnswer {
    /// The whole interval agrees with it.
    Yes,
    /// The whole interval contradicts it.
    No,
    /// The interval has both sides, or there are too few trials for an interval.
    Undecided,
}

impl ClaimAnswer {
    /// The word for tables.
    pub fn word(self) -> &'static str {
        match self {
            ClaimAnswer::Yes => "yes",
            ClaimAnswer::No => "no",
            ClaimAnswer::Undecided => "undecided",
        }
    }
}

/// A claim of the papers, and whether these results agree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Claim {
    /// The sentence of the paper, or a question of ours.
    pub claim: String,
    /// Year and section of the paper; "not in the papers" for a question of ours.
    pub place: String,
    /// Our criterion of agreement.
    pub criterion: String,
    /// The effect that was found, with its interval.
    pub found: String,
    /// Whether the effect meets the criterion.
    pub answer: ClaimAnswer,
    /// Whether it is one of the claims that were named before any table was made. Their answers are corrected
    /// for their number.
    pub primary: bool,
}
