//! What a comparison says, as values: its tables and the claims of the papers.

use crate::models::{ModelKind, ModelSettings};
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

/// One candidate: a row of figure 4 of Velychko et al. (2018).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModelSummary {
    /// Its kind of model.
    pub model: ModelKind,
    /// The kind with its settings.
    pub candidate: ModelSettings,
    /// The settings that set it apart, in a few words.
    pub label: String,
    /// Mean squared error after dynamic time warping, in the squared units of the columns.
    pub mse: Spread,
    /// The median error over the folds: a single rollout that goes astray does not move it.
    pub mse_median: f64,
    /// The error of a prediction that does not move.
    pub variance: f64,
    /// The bound on the log evidence, in nats, where the model has one.
    pub bound: Option<Spread>,
    /// Seconds of a training.
    pub seconds: Spread,
    /// Numbers that must be kept to roll out.
    pub stored_numbers: Spread,
    /// Number of trials held out.
    pub folds: usize,
    /// Number of trainings.
    pub runs: usize,
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

/// Bound and error of one kind of model over its inducing points (primitives of the TMP), all other settings being the same:
/// figure 6B of Velychko et al. (2018).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Correlation {
    /// The kind of model.
    pub model: ModelKind,
    /// What the candidates have in common, in a few words, where the kind has several such groups; else empty.
    pub label: String,
    /// Number of candidates.
    pub settings: usize,
    /// Number of trials held out that all of these candidates have: bounds and errors are means over these.
    pub folds: usize,
    /// Spearman's rank correlation of bound and error.
    pub rank: f64,
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
}

/// Learning time of one candidate over the frames trained on: figure 2 of the supplement of Velychko et al. (2017).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Growth {
    /// The kind of model.
    pub model: ModelKind,
    /// Its settings, in a few words.
    pub label: String,
    /// From few to many frames.
    pub points: Vec<FramesAndTime>,
    /// k where time grows as frames to the power k; absent where it cannot be told.
    pub exponent: Option<f64>,
}

/// What the papers say, and what these results say about it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Claim {
    /// The claim and its year.
    pub claim: String,
    /// What was found.
    pub found: String,
    /// Whether that agrees.
    pub holds: bool,
}
