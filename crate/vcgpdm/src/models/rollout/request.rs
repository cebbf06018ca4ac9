//! What a rollout is asked for, what it gives, and why it may be refused.

use crate::gp::NumericsError;
use crate::json::rows;
use crate::models::data::sequences::MOST_FRAMES;
use crate::models::rollout::couplings::{CouplingsError, Reading};
use crate::motion::pose::PoseError;
use nalgebra::DMatrix;
use serde::Deserialize;
use thiserror::Error;

/// So many sampled rollouts can be asked for at once: more than anybody looks at.
pub const MOST_SAMPLES: u32 = 1000;

/// What a rollout of a model with couplings is asked for.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RolloutRequest {
    /// Frames in all, the start included.
    pub frames: usize,
    /// The training sequence whose start latents begin it, counted from 0.
    pub sequence: usize,
    /// The frame of the sequence that it begins with, counted from 0: a model may keep the latents of all of
    /// them.
    #[serde(default)]
    pub frame: usize,
    /// Coupling variances [M x M], row the source, column the target; absent: as learned.
    #[serde(default, deserialize_with = "rows::optional_matrix")]
    pub alpha: Option<DMatrix<f64>>,
    /// What changed couplings do to the experts.
    #[serde(default)]
    pub reading: Reading,
    /// Couplings that are cut for a while. JavaScript has live rollouts for that.
    #[serde(skip)]
    pub cuts: Vec<Cut>,
    /// Pushes that parts get on their way.
    #[serde(skip)]
    pub pushes: Vec<Push>,
}

impl RolloutRequest {
    /// The couplings that it asks for, where it asks for none those that were `learned`.
    pub fn alpha_or<'a>(&'a self, learned: &'a DMatrix<f64>) -> &'a DMatrix<f64> {
        self.alpha.as_ref().unwrap_or(learned)
    }
}

/// A coupling that is cut for a while: from frame `from` up to, not including, frame `to` the target does not
/// listen to the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cut {
    /// The source part, counted from 0.
    pub source: usize,
    /// The target part, counted from 0.
    pub target: usize,
    /// The first frame that is predicted without it.
    pub from: usize,
    /// The first frame that is predicted with it again.
    pub to: usize,
}

/// A push that a part gets: its last p latent states are moved together before the frame is predicted, so
/// that its place changes and its speed does not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Push {
    /// The part, counted from 0.
    pub part: usize,
    /// The first frame that feels it.
    pub frame: usize,
    /// By how much, in each latent dimension `[Q_i]`; empty: not at all.
    pub by: Vec<f64>,
    /// And so many of its last steps ahead on its own path; negative: back.
    pub ahead: f64,
}

/// A rolled-out motion of a model with couplings.
#[derive(Clone, Debug)]
pub struct Rollout {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// All columns, means included [frames x D].
    pub y: DMatrix<f64>,
    /// The weights of the experts under its couplings [M x M], row the source; those into each part sum to 1.
    pub weights: DMatrix<f64>,
}

/// Why a rollout could not be made.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RolloutError {
    /// The couplings do not fit the model.
    #[error(transparent)]
    Couplings(#[from] CouplingsError),
    /// There is no such training sequence.
    #[error("expected a training sequence from 0 to {}, found {found}", count - 1)]
    Sequence {
        /// How many there are, at least one.
        count: usize,
        /// The one asked for.
        found: usize,
    },
    /// The latents of such a frame are not there.
    #[error("expected a frame of the sequence from 0 to {most} to start from, found {found}")]
    StartFrame {
        /// The last one that can be started from.
        most: usize,
        /// The one asked for.
        found: usize,
    },
    /// There is no such part.
    #[error("expected a part from 0 to {}, found {found}", count - 1)]
    Part {
        /// How many there are, at least one.
        count: usize,
        /// The one asked for.
        found: usize,
    },
    /// The figure has no such node.
    #[error("expected a node of the figure from 0 to {}, found {found}", count - 1)]
    Node {
        /// How many there are, at least one.
        count: usize,
        /// The one asked for.
        found: usize,
    },
    /// A part would listen to nothing.
    #[error(
        "expected one coupling into part {target} that is not cut, found none: nothing would say where it goes"
    )]
    CutOff {
        /// The part, counted from 0.
        target: usize,
    },
    /// A push does not fit its part.
    #[error(
        "expected a push of part {part} by {expected} finite numbers, one for each latent dimension, found {found}"
    )]
    Push {
        /// The part, counted from 0.
        part: usize,
        /// The latent dimensions Q of the part.
        expected: usize,
        /// How many numbers there are.
        found: usize,
    },
    /// A push is not by numbers.
    #[error("expected a push of part {part} by finite numbers, found {found}")]
    PushNumber {
        /// The part, counted from 0.
        part: usize,
        /// What stands there.
        found: f64,
    },
    /// A cut or a push would not be felt.
    #[error(
        "expected a {what} in a frame that is predicted, from {first} on and before {end}, found {found}"
    )]
    Unfelt {
        /// A cut or a push.
        what: &'static str,
        /// The first frame that is predicted: the order p of the dynamics.
        first: usize,
        /// Frames of the rollout.
        end: usize,
        /// The frame asked for; of a cut the first one.
        found: usize,
    },
    /// Uncertain rollouts know no cuts and pushes.
    #[error("expected no cuts and pushes in a rollout with variances")]
    Disturbed,
    /// Too many frames, or none.
    #[error("expected from 1 to {most} frames, found {found}")]
    Frames {
        /// The most there can be.
        most: usize,
        /// The number asked for.
        found: usize,
    },
    /// The start latents do not fit the model.
    #[error(
        "the start latents of part {part} must be {rows} x {columns} numbers, found {found_rows} x {found_columns}"
    )]
    Start {
        /// The part, counted from 0.
        part: usize,
        /// Rows expected: the order p of the dynamics.
        rows: usize,
        /// Columns expected: the latent dimensions Q of the part.
        columns: usize,
        /// Rows found.
        found_rows: usize,
        /// Columns found.
        found_columns: usize,
    },
    /// There is no history to predict from.
    #[error("expected at least {least} frames before the predicted one, found {found}")]
    History {
        /// The order p of the dynamics.
        least: usize,
        /// Frames found.
        found: usize,
    },
    /// The columns cannot be turned into poses.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// A covariance could not be factorised.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

/// Checks that so many frames can be rolled out.
///
/// # Errors
///
/// When there are none, or more than [`MOST_FRAMES`].
pub(crate) fn check_frames(frames: usize) -> Result<(), RolloutError> {
    if (1..=MOST_FRAMES).contains(&frames) {
        return Ok(());
    }
    Err(RolloutError::Frames { most: MOST_FRAMES, found: frames })
}
