//! The results of a study, as values for tables and figures.

use crate::perception::beta::Rate;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;
use vcgpdm_core::elementary::Elementary;
use vcgpdm_core::models::{ENGINE, ModelKind, Settings};

/// The options that the analysis used.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "UsedOptions"))]
pub struct AnalysisOptions {
    /// The ceiling c of the logistic regression, above 0 up to 1.
    pub ceiling: f64,
    /// Blocks of the cross-validation.
    pub folds: usize,
    /// Draws from the posteriors for the order of the models.
    pub draws: usize,
    /// The seed of blocks and draws.
    pub seed: u32,
    /// Participants who pass less than this share of the attention checks are left out.
    pub attention: f64,
}

impl AnalysisOptions {
    /// Range of the number of blocks.
    pub const FOLDS: RangeInclusive<usize> = 2..=1000;
    /// Range of the number of draws.
    pub const DRAWS: RangeInclusive<usize> = 1..=10_000_000;
}

impl Default for AnalysisOptions {
    fn default() -> Self {
        Self { ceiling: 0.5, folds: 10, draws: 200_000, seed: 1, attention: 0.85 }
    }
}

/// How often participants took a movement for the natural one, and the posterior of this rate: beta(1 + hits,
/// 1 + trials - hits).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Confusion {
    /// How often the movement was taken for the natural one.
    pub hits: usize,
    /// Number of its trials with an answer.
    pub trials: usize,
    /// The posterior's mean.
    pub mean: f64,
    /// The posterior's standard deviation.
    pub deviation: f64,
    /// The rate is below this value with a posterior probability of 2.5 %.
    pub low: f64,
    /// The rate is above this value with a posterior probability of 2.5 %.
    pub high: f64,
    /// The posterior probability that the rate is above one half.
    pub above_half: f64,
}

impl Confusion {
    /// The posterior of this rate.
    pub fn new(rate: Rate) -> Self {
        Self {
            hits: rate.hits,
            trials: rate.trials,
            mean: rate.mean(),
            deviation: rate.deviation(),
            low: rate.quantile(0.025),
            high: rate.quantile(0.975),
            above_half: 1.0 - rate.below(0.5),
        }
    }
}

/// A participant.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Participant {
    /// The name in the answers.
    pub name: String,
    /// The number of answered comparisons.
    pub comparisons: usize,
    /// Trials of any kind without an answer.
    pub unanswered: usize,
    /// Answered attention checks.
    pub attention_checks: usize,
    /// The number of attention checks that the participant passed.
    pub attention_hits: usize,
    /// Whether the participant is excluded for passing too few attention checks.
    pub excluded: bool,
    /// The share of answers "left".
    pub left: Option<f64>,
    /// The median response time, in milliseconds.
    pub median_rt: Option<f64>,
    /// The longest time between the starts of the two movements of a trial, in milliseconds.
    pub started_apart_ms: Option<f64>,
}

/// Mean scores of the movements of a setting, and the score of its size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct MeanScores {
    /// Mean squared error on the trial held out.
    pub mse: f64,
    /// The same after dynamic time warping.
    pub dtw_mse: f64,
    /// The error of rollouts on the trials trained on, after dynamic time warping; null if a movement lacks it,
    /// as in studies of earlier versions.
    pub training_mse: Option<f64>,
    /// The bound in nats, if the model has one.
    pub bound: Option<f64>,
    /// The dynamics terms of the bound.
    pub dynamics: Option<f64>,
    /// The pose terms of the bound.
    pub pose: Option<f64>,
    /// The soft minimum of the numbers of dynamics and pose inducing points; null for a kind without both.
    pub points: Option<f64>,
}

/// Size of a model; numbers that the kind does not have are absent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Size {
    /// Inducing points of every dynamics map.
    pub dynamics_ips: Option<usize>,
    /// Inducing points of every pose map.
    pub pose_ips: Option<usize>,
    /// Primitives.
    pub primitives: Option<usize>,
    /// Basis functions.
    pub bases: Option<usize>,
}

impl Size {
    /// The soft minimum -ln(exp(-K) + exp(-L)) of the numbers K and L of dynamics and pose inducing points.
    pub fn points(&self) -> Option<f64> {
        let (k, l) = (self.dynamics_ips? as f64, self.pose_ips? as f64);
        Some(k.min(l) - (1.0 + (-(k - l).abs()).exponential()).logarithm())
    }
}

/// A model with all its settings.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct SettingResult {
    /// The kind of model.
    pub model: ModelKind,
    /// The kind with its settings.
    pub candidate: Settings,
    /// The settings that differ from those of other candidates, as a short text.
    pub label: String,
    /// The size.
    #[cfg_attr(feature = "types", ts(inline))]
    pub size: Size,
    /// The number of movements that are not marked as failures.
    pub movements: usize,
    /// The number of movements that are marked as failures. If all are, the setting is an attention check.
    pub failed: usize,
    /// Means over the movements that are not marked as failures; null if all are.
    #[cfg_attr(feature = "types", ts(inline))]
    pub scores: Option<MeanScores>,
    /// Null if there is no answer.
    pub confusion: Option<Confusion>,
}

/// The score that predicts the rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum ScoreKind {
    /// Mean squared error on the trial held out.
    Mse,
    /// The same after dynamic time warping.
    DtwMse,
    /// The error of rollouts on the trials trained on, after dynamic time warping.
    TrainingMse,
    /// The bound.
    Bound,
    /// The dynamics terms of the bound.
    Dynamics,
    /// The pose terms of the bound.
    Pose,
    /// The soft minimum of the numbers of dynamics and pose inducing points.
    Points,
}

impl ScoreKind {
    /// All scores.
    pub const ALL: [Self; 7] =
        [Self::Mse, Self::DtwMse, Self::TrainingMse, Self::Bound, Self::Dynamics, Self::Pose, Self::Points];

    /// Its name in documents.
    pub fn id(self) -> &'static str {
        self.names().0
    }

    /// Its name for a person to read.
    pub fn title(self) -> &'static str {
        self.names().1
    }

    fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Mse => ("mse", "test MSE"),
            Self::DtwMse => ("dtw-mse", "test MSE after time warping"),
            Self::TrainingMse => ("training-mse", "training MSE"),
            Self::Bound => ("bound", "bound"),
            Self::Dynamics => ("dynamics", "dynamics part of the bound"),
            Self::Pose => ("pose", "pose part of the bound"),
            Self::Points => ("points", "soft minimum of the inducing points"),
        }
    }

    /// This score.
    pub fn value(self, scores: &MeanScores) -> Option<f64> {
        match self {
            ScoreKind::Mse => Some(scores.mse),
            ScoreKind::DtwMse => Some(scores.dtw_mse),
            ScoreKind::TrainingMse => scores.training_mse,
            ScoreKind::Bound => scores.bound,
            ScoreKind::Dynamics => scores.dynamics,
            ScoreKind::Pose => scores.pose,
            ScoreKind::Points => scores.points,
        }
    }
}

/// How a score predicts the rate: p = ceiling / (1 + exp(w0 + w1 (score - centre) / scale)).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Regression {
    /// Null for all kinds of models together.
    pub model: Option<ModelKind>,
    /// A score that predicts the rate.
    pub score: ScoreKind,
    /// Number of settings with the score and answers.
    pub settings: usize,
    /// Number of their answers.
    pub trials: usize,
    /// The mean of the score over the settings.
    pub centre: f64,
    /// Its standard deviation.
    pub scale: f64,
    /// The ceiling c.
    pub ceiling: f64,
    /// w0 and w1.
    pub weights: [f64; 2],
    /// The standard errors of the weights; null if the answers do not determine both weights.
    pub errors: Option<[f64; 2]>,
    /// The log Bayes factor per block, compared with a constant rate: the mean over the blocks that were left
    /// out of the fit. Null if there are fewer answers than blocks.
    pub log_bayes_factor: Option<f64>,
    /// Its standard error over the blocks.
    pub log_bayes_factor_error: Option<f64>,
    /// The log Bayes factor of the data, compared with a constant rate: the share of hits among all answers of
    /// a setting predicts them, those of the block left out too. No score can have a higher one.
    pub data_log_bayes_factor: Option<f64>,
    /// Its standard error over the blocks.
    pub data_log_bayes_factor_error: Option<f64>,
    /// Number of blocks, left out in turn.
    pub folds: usize,
    /// Points of the curve: a score and the predicted rate.
    pub curve: Vec<(f64, f64)>,
}

/// For one kind of model, the error on the training trials over the bound: training MSE = exp(w0 + w1 (bound -
/// centre) / scale), by least squares of the logarithm of the error.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct ErrorCurve {
    /// The kind of model.
    pub model: ModelKind,
    /// Number of settings with both numbers and answers.
    pub settings: usize,
    /// The mean of the bound over the settings.
    pub centre: f64,
    /// Its standard deviation.
    pub scale: f64,
    /// w0 and w1.
    pub weights: [f64; 2],
    /// The standard error of each weight.
    pub error: f64,
    /// Points of the curve: a bound and the training MSE.
    pub curve: Vec<(f64, f64)>,
}

/// For one kind of model, the setting with the highest rate.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "BestSetting"))]
pub struct Best {
    /// The kind of model.
    pub model: ModelKind,
    /// The index of the setting in `settings`.
    pub setting: usize,
    /// Its settings, in a few words.
    pub label: String,
    /// How often its movements were taken for the natural one.
    pub confusion: Confusion,
}

/// An order of the kinds of models.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Order {
    /// The highest rate first.
    pub models: Vec<ModelKind>,
    /// Its posterior probability.
    pub probability: f64,
}

/// Result of the catch trials.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Catch {
    /// How often the unseen movement was taken for the more natural one.
    pub confusion: Confusion,
    /// The posterior probability that this rate is one half: participants do not recognise the seen
    /// movements.
    pub is_half: f64,
}

/// Number of trials that a setting needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Needed {
    /// For the exact test to detect a rate that is 0.1 away from one half, with a power of 0.8, as Knopp et
    /// al. (2019).
    pub to_tell: Option<usize>,
    /// For a rate of one half to lie in [0.45, 0.55] with a posterior probability of 0.8.
    pub for_precision: Option<usize>,
}

/// The results of the analysis of the answers to a study.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PerceptionResults {
    /// "vcgpdm perception".
    pub format: &'static str,
    /// 1.
    pub version: usize,
    /// The program that made the analysis, and its version.
    pub engine: &'static str,
    /// The title of the study.
    pub title: String,
    /// The hash of the study.
    pub study: String,
    /// The options of the analysis.
    pub options: AnalysisOptions,
    /// All participants.
    pub participants: Vec<Participant>,
    /// The rate over all comparisons that count.
    pub all: Confusion,
    /// All settings, in the order of tables.
    pub settings: Vec<SettingResult>,
    /// Predictions for every kind of model, and for all together, from every score of at least three
    /// settings.
    pub regressions: Vec<Regression>,
    /// The error on the training trials over the bound, for every kind of model of which at least three settings
    /// have both numbers and answers.
    pub error_curves: Vec<ErrorCurve>,
    /// The best setting of every kind of model with answers.
    pub best: Vec<Best>,
    /// Orders of the kinds of models, by falling rate. The most probable order comes first.
    #[cfg_attr(feature = "types", ts(inline))]
    pub orders: Vec<Order>,
    /// `pairs[a][b]`: the probability that best setting a has a higher rate than best setting b.
    pub pairs: Vec<Vec<f64>>,
    /// Null if there are no catch trials.
    #[cfg_attr(feature = "types", ts(inline))]
    pub catch: Option<Catch>,
    /// How many trials a setting needs to distinguish 0.6 from 0.5, and to estimate 0.5 within [0.45, 0.55].
    #[cfg_attr(feature = "types", ts(inline))]
    pub needed: Needed,
}

impl PerceptionResults {
    /// The field "format" of a document of results.
    pub const FORMAT: &'static str = "vcgpdm perception";
    /// The version of the document. It is raised when older programs cannot read the document any more.
    pub const VERSION: usize = 1;
    /// The program and its version.
    pub const ENGINE: &'static str = ENGINE;
}
