//! What answers say, as values: with everything that tables and figures show.

use crate::perception::beta::Rate;
use serde::Serialize;
use std::ops::RangeInclusive;
use vcgpdm::models::{ENGINE, ModelKind, Settings};

/// How answers are analysed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AnalysisOptions {
    /// The ceiling c of the logistic regression, above 0 up to 1.
    pub ceiling: f64,
    /// Blocks of the cross-validation.
    pub folds: usize,
    /// Draws from the posteriors for the order of the models.
    pub draws: usize,
    /// The seed of blocks and draws.
    pub seed: u32,
    /// Participants below this share of attention checks are left out.
    pub attention: f64,
}

impl AnalysisOptions {
    /// Blocks that there can be.
    pub const FOLDS: RangeInclusive<usize> = 2..=1000;
    /// Draws that there can be.
    pub const DRAWS: RangeInclusive<usize> = 1..=10_000_000;
}

impl Default for AnalysisOptions {
    fn default() -> Self {
        Self { ceiling: 0.5, folds: 10, draws: 200_000, seed: 1, attention: 0.85 }
    }
}

/// How often something happened, and what that says about its rate: beta(1 + hits, 1 + trials - hits).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Confusion {
    /// How often the movement was taken for the natural one.
    pub hits: usize,
    /// How often it was shown and an answer given.
    pub trials: usize,
    /// The posterior's mean.
    pub mean: f64,
    /// The posterior's standard deviation.
    pub deviation: f64,
    /// Below this with a posterior probability of 2.5 %.
    pub low: f64,
    /// Above this with a posterior probability of 2.5 %.
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
pub struct Participant {
    /// What the answers call them.
    pub name: String,
    /// Answered comparisons.
    pub comparisons: usize,
    /// Trials of any kind without an answer.
    pub unanswered: usize,
    /// Answered attention checks.
    pub attention_checks: usize,
    /// How many of these were seen through.
    pub attention_hits: usize,
    /// Whether they are left out, for too few of these.
    pub excluded: bool,
    /// The share of answers "left"; absent without answers.
    pub left: Option<f64>,
    /// The median time to an answer, in milliseconds, where it is known.
    pub median_rt: Option<f64>,
    /// How long after each other movements started at the most, in milliseconds, where it is known.
    pub started_apart_ms: Option<f64>,
}

/// What the scores of a setting's movements are on average.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct MeanScores {
    /// Mean squared error on the trial held out.
    pub mse: f64,
    /// The same after dynamic time warping.
    pub dtw_mse: f64,
    /// The bound, where the model has one, in nats.
    pub bound: Option<f64>,
    /// Its part about dynamics.
    pub dynamics: Option<f64>,
    /// Its part about poses.
    pub pose: Option<f64>,
}

/// How large a model is; what a kind does not have is absent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
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

/// A model with all its settings.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SettingResult {
    /// The kind of model.
    pub model: ModelKind,
    /// The kind with its settings.
    pub candidate: Settings,
    /// The settings that set it apart, in a few words.
    pub label: String,
    /// How large it is.
    pub size: Size,
    /// How many movements it made that have not failed.
    pub movements: usize,
    /// How many failed: where all did, the setting is an attention check and has no rate.
    pub failed: usize,
    /// Means over the movements that have not failed; absent where all did.
    pub scores: Option<MeanScores>,
    /// How often they were taken for the natural one; absent without an answer.
    pub confusion: Option<Confusion>,
}

/// What the rate is predicted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ScoreKind {
    /// Mean squared error on the trial held out.
    Mse,
    /// The same after dynamic time warping.
    DtwMse,
    /// The bound.
    Bound,
    /// Its part about dynamics.
    Dynamics,
    /// Its part about poses.
    Pose,
}

impl ScoreKind {
    /// All of them.
    pub const ALL: [ScoreKind; 5] =
        [ScoreKind::Mse, ScoreKind::DtwMse, ScoreKind::Bound, ScoreKind::Dynamics, ScoreKind::Pose];

    /// Its name in documents.
    pub fn id(self) -> &'static str {
        match self {
            ScoreKind::Mse => "mse",
            ScoreKind::DtwMse => "dtw-mse",
            ScoreKind::Bound => "bound",
            ScoreKind::Dynamics => "dynamics",
            ScoreKind::Pose => "pose",
        }
    }

    /// Its name for a person to read.
    pub fn title(self) -> &'static str {
        match self {
            ScoreKind::Mse => "test MSE",
            ScoreKind::DtwMse => "test MSE after time warping",
            ScoreKind::Bound => "bound",
            ScoreKind::Dynamics => "dynamics part of the bound",
            ScoreKind::Pose => "pose part of the bound",
        }
    }

    /// This score.
    pub fn value(self, scores: &MeanScores) -> Option<f64> {
        match self {
            ScoreKind::Mse => Some(scores.mse),
            ScoreKind::DtwMse => Some(scores.dtw_mse),
            ScoreKind::Bound => scores.bound,
            ScoreKind::Dynamics => scores.dynamics,
            ScoreKind::Pose => scores.pose,
        }
    }
}

/// How a score predicts the rate: p = ceiling / (1 + exp(w0 + w1 (score - centre) / scale)).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Regression {
    /// The kind of model; absent: all together.
    pub model: Option<ModelKind>,
    /// What the rate is predicted from.
    pub score: ScoreKind,
    /// How many settings have the score and answers.
    pub settings: usize,
    /// Their answers.
    pub trials: usize,
    /// The mean of the score over the settings.
    pub centre: f64,
    /// Its standard deviation.
    pub scale: f64,
    /// The ceiling c.
    pub ceiling: f64,
    /// The weights w0 and w1.
    pub weights: [f64; 2],
    /// Their standard errors; absent where the answers do not tell both.
    pub errors: Option<[f64; 2]>,
    /// The logarithm of the Bayes factor beside a constant, a block: the mean over the blocks left out;
    /// absent with fewer answers than blocks.
    pub log_bayes_factor: Option<f64>,
    /// Its standard error over the blocks.
    pub log_bayes_factor_error: Option<f64>,
    /// Blocks left out in turn.
    pub folds: usize,
    /// Scores and the rates that the curve predicts, from the lowest to the highest score.
    pub curve: Vec<(f64, f64)>,
}

/// The setting of a kind of model with the highest rate.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Best {
    /// The kind of model.
    pub model: ModelKind,
    /// Its place among the settings.
    pub setting: usize,
    /// Its settings, in a few words.
    pub label: String,
    /// How often its movements were taken for the natural one.
    pub confusion: Confusion,
}

/// An order of the kinds of models.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Order {
    /// The highest rate first.
    pub models: Vec<ModelKind>,
    /// Its posterior probability.
    pub probability: f64,
}

/// What the catch trials say.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Catch {
    /// How often the movement that was not seen before was taken for the more natural one.
    pub confusion: Confusion,
    /// The probability that this rate is one half, when that was as likely before as any other rate: nobody
    /// knows the seen ones by heart.
    pub is_half: f64,
}

/// How many trials a setting needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Needed {
    /// For the exact test to tell a rate 0.1 away from one half, with a power of 0.8, as Knopp et al. (2019).
    pub to_tell: Option<usize>,
    /// For a rate of one half to lie in [0.45, 0.55] with a posterior probability of 0.8.
    pub for_precision: Option<usize>,
}

/// What all answers to a study say.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PerceptionResults {
    /// "vcgpdm perception".
    pub format: &'static str,
    /// 1.
    pub version: usize,
    /// The program and its version.
    pub engine: &'static str,
    /// What the study is called.
    pub title: String,
    /// What was shown: the study's hash.
    pub study: String,
    /// How the answers were analysed.
    pub options: AnalysisOptions,
    /// Everybody who answered.
    pub participants: Vec<Participant>,
    /// Of all comparisons that count.
    pub all: Confusion,
    /// In the order of tables.
    pub settings: Vec<SettingResult>,
    /// For every kind of model, and all together, from every score that at least three settings have.
    pub regressions: Vec<Regression>,
    /// Of every kind of model with answers.
    pub best: Vec<Best>,
    /// Of the best settings: the likeliest first, down to one in a thousand.
    pub orders: Vec<Order>,
    /// `pairs[a][b]`: the probability that best setting a has a higher rate than best setting b.
    pub pairs: Vec<Vec<f64>>,
    /// Absent without catch trials.
    pub catch: Option<Catch>,
    /// How many trials a setting needs.
    pub needed: Needed,
}

impl PerceptionResults {
    /// What a document of results says that it is.
    pub const FORMAT: &'static str = "vcgpdm perception";
    /// Raised whenever an older program could no longer read the document.
    pub const VERSION: usize = 1;
    /// The program and its version.
    pub const ENGINE: &'static str = ENGINE;
}
