//! What a comparison says, as values: its tables and the claims of the papers.

use crate::evaluation::stats::Interval;
use serde::Serialize;
use vcgpdm::models::{ModelKind, Settings};

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

/// One candidate: a row of figure 4 of Velychko et al. (2018).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModelSummary {
    /// Its kind of model.
    pub model: ModelKind,
    /// The kind with its settings.
    pub candidate: Settings,
    /// The settings that set it apart, in a few words.
    pub label: String,
    /// Mean squared error after dynamic time warping, in the squared units of the columns.
    pub mse: Spread,
    /// The median error over the folds: a single rollout that goes astray does not move it.
    pub mse_median: f64,
    /// The same error on the trials that were trained on, where the results hold it.
    pub training_mse: Option<Spread>,
    /// The error of a prediction that does not move.
    pub variance: f64,
    /// The bound on the log evidence, in nats, where the model has one.
    pub bound: Option<Spread>,
    /// Seconds of a training.
    pub seconds: Spread,
    /// Numbers that must be kept to roll out.
    pub stored_numbers: Spread,
    /// The share of trainings that ended because nothing changed any more, 0 to 1; absent for models without
    /// iterations.
    pub converged: Option<f64>,
    /// The terms of the bound, means over folds, where the results hold them.
    pub terms: Option<TermMeans>,
    /// The mean error of each part, in the order of the setting's parts, after the same time warping; empty
    /// where the results do not hold it.
    pub part_errors: Vec<f64>,
    /// Number of trials held out.
    pub folds: usize,
    /// Number of trainings.
    pub runs: usize,
    /// How many candidates it stands for: all that differ in size alone, where it is the one of them that
    /// claims choose for most trials; else 0.
    pub stands_for: usize,
}

/// Means of the terms of a bound, in nats.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TermMeans {
    /// Kinematics of all parts: the pose maps.
    pub pose: f64,
    /// Dynamics into all parts, initial states and entropy.
    pub dynamics: f64,
}

/// One candidate in figure 6B of Velychko et al. (2018).
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
/// being the same: figure 6B of Velychko et al. (2018).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Correlation {
    /// The kind of model.
    pub model: ModelKind,
    /// What the candidates have in common, in a few words, where the kind has several such groups; else
    /// empty.
    pub label: String,
    /// Number of candidates.
    pub settings: usize,
    /// Number of trials held out that all of these candidates have: bounds and errors are means over these.
    pub folds: usize,
    /// Spearman's rank correlation of bound and error.
    pub rank: f64,
    /// How likely chance alone makes it so low: the share of all orders of the settings that do.
    pub chance: f64,
    /// The candidates.
    pub points: Vec<BoundAndError>,
}

/// Frames trained on, and how long that took.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FramesAndTime {
    /// Mean number of frames trained on.
    pub frames: f64,
    /// Mean seconds of an iteration.
    pub seconds: f64,
    /// Mean seconds of a whole training.
    pub training_seconds: f64,
}

/// Learning time of one candidate over the frames trained on: figure 2 of the supplement of Velychko et al.
/// (2017).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Growth {
    /// The kind of model.
    pub model: ModelKind,
    /// Its settings, in a few words.
    pub label: String,
    /// From few to many frames.
    pub points: Vec<FramesAndTime>,
    /// k where the time of an iteration grows as frames to the power k; absent where it cannot be told.
    pub exponent: Option<f64>,
    /// Where k lies, 95 %, by Student's t of the slope.
    pub interval: Option<Interval>,
    /// The same power for a whole training, which may need more iterations of more frames; absent where it
    /// cannot be told.
    pub training_exponent: Option<f64>,
    /// Where that lies.
    pub training_interval: Option<Interval>,
    /// The share of these trainings that ended because nothing changed any more, 0 to 1; absent for models
    /// without iterations.
    pub converged: Option<f64>,
}

/// Two ways to split the body in one fold: what their bounds say, and what their errors say.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Evidence {
    /// The trial held out, by its name.
    pub trial: String,
    /// The bound of the vCGPDM minus that of the vGPDM, in nats: the logarithm of a Bayes factor (2020,
    /// equation 2.12), as far as both bounds are tight.
    pub log_bayes_factor: f64,
    /// The error of the vCGPDM over that of the vGPDM.
    pub error_ratio: f64,
}

/// What results say about a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ClaimAnswer {
    /// The whole interval agrees with it.
    Yes,
    /// The whole interval contradicts it.
    No,
    /// The interval reaches to both sides, or there are too few trials for one.
    Undecided,
}

impl ClaimAnswer {
    /// In a word, in sentence case of tables.
    pub fn word(self) -> &'static str {
        match self {
            ClaimAnswer::Yes => "yes",
            ClaimAnswer::No => "no",
            ClaimAnswer::Undecided => "undecided",
        }
    }
}

/// What the papers say, and what these results say about it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Claim {
    /// The sentence of the paper; where there is none, what we ask beside it.
    pub claim: String,
    /// Where it stands: year and section; "not in the papers" for what we ask ourselves.
    pub place: String,
    /// Our criterion: what it is held against.
    pub criterion: String,
    /// The effect that was found, with its interval.
    pub found: String,
    /// Whether that agrees.
    pub answer: ClaimAnswer,
}
