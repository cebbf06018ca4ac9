//! Requests for rollouts, rollouts, and errors.

use crate::gp::NumericsError;
use crate::json::rows;
use crate::models::data::sequences::MOST_FRAMES;
use crate::models::errors::CouplingsError;
use crate::models::rollout::couplings::Reading;
use crate::motion::pose::PoseError;
use nalgebra::{DMatrix, DVector};
use serde::Deserialize;
use std::ops::RangeInclusive;
use thiserror::Error;

/// The most sampled rollouts of one request.
pub const MOST_SAMPLES: u32 = 1000;
/// Tempos of a part; 1 is as learned.
pub const TEMPOS: RangeInclusive<f64> = 0.25..=2.0;

/// The options of a rollout of a model with couplings.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "RolloutOptions"))]
pub struct RolloutRequest {
    /// Frames in all, the start included; absent: 300.
    #[serde(default = "usual_frames")]
    #[cfg_attr(feature = "types", ts(type = "number", optional))]
    pub frames: usize,
    /// The training sequence whose start begins it, counted from 0; absent: the first.
    #[serde(default)]
    #[cfg_attr(feature = "types", ts(type = "number", optional))]
    pub sequence: usize,
    /// The frame of that sequence that begins the rollout, counted from 0; absent: its first.
    #[serde(default)]
    #[cfg_attr(feature = "types", ts(type = "number", optional))]
    pub frame: usize,
    /// Latents that begin the rollout in place of a training sequence, `[part][frame][dimension]`: `order`
    /// frames or more, such as those of a clip's first frames. Without `sequence` and `frame`.
    #[serde(default, deserialize_with = "rows::optional_matrices")]
    #[cfg_attr(feature = "types", ts(type = "number[][][] | null", optional))]
    pub start: Option<Vec<DMatrix<f64>>>,
    /// Coupling variances `alpha[source][target]`, also of a MAP CGPDM; absent: as learned.
    #[serde(default, deserialize_with = "rows::optional_matrix")]
    #[cfg_attr(feature = "types", ts(type = "number[][] | null", optional))]
    pub alpha: Option<DMatrix<f64>>,
    /// Effect of changed couplings on the experts; absent: as learned.
    #[serde(default)]
    #[cfg_attr(feature = "types", ts(as = "Option<_>", optional))]
    pub reading: Reading,
    /// Handles of a TMP or DMP; absent: none.
    #[serde(default)]
    #[cfg_attr(feature = "types", ts(as = "Option<_>", optional))]
    pub handles: Handles,
    /// Couplings that are cut for a while. In JavaScript, live rollouts do this.
    #[serde(skip)]
    pub cuts: Vec<Cut>,
    /// Pushes of parts.
    #[serde(skip)]
    pub pushes: Vec<Push>,
}

/// Ten seconds at 30 frames a second.
fn usual_frames() -> usize {
    300
}

impl RolloutRequest {
    /// The requested couplings, or else those that were `learned`.
    pub fn alpha_or<'a>(&'a self, learned: &'a DMatrix<f64>) -> &'a DMatrix<f64> {
        self.alpha.as_ref().unwrap_or(learned)
    }
}

/// A coupling that is cut for a while: from frame `from` up to, but not including, frame `to`, the source has
/// no weight in the prediction of the target.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cut {
    /// The source part, counted from 0.
    pub source: usize,
    /// The target part, counted from 0.
    pub target: usize,
    /// The first frame that is predicted without the coupling.
    pub from: usize,
    /// The first frame that is predicted with the coupling again.
    pub to: usize,
}

/// A push of a part: its last p latent states move together before a frame is predicted, so that the place of
/// the part changes and its speed does not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Push {
    /// The part, counted from 0.
    pub part: usize,
    /// The first frame that is predicted after the push.
    pub frame: usize,
    /// The displacement in each latent dimension `[Q_i]`; empty: none.
    pub by: Vec<f64>,
    /// An additional displacement along the part's own path, in multiples of its last step; negative: back.
    pub ahead: f64,
}

/// Changes of the rollout of a TMP or DMP. Displacements have one number for each column `[D]`, in its unit.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Handles {
    /// Multiplies the speed, of the way over the ground too, from 0.25 to 2; absent: 1.
    #[cfg_attr(feature = "types", ts(as = "Option<_>", optional))]
    pub tempo: f64,
    /// Displacement of the goal of a DMP, of the centre of a rhythmic one; absent: none.
    #[cfg_attr(feature = "types", ts(as = "Option<_>", optional))]
    pub goal: Option<Vec<f64>>,
    /// A push in one frame; in frame 0 it moves the start; absent: none.
    #[cfg_attr(feature = "types", ts(as = "Option<_>", optional))]
    pub push: Option<PosePush>,
}

/// A push of all columns. A DMP goes on from where it is then, without a change of its velocity; a TMP is a
/// function of time, and in the next frame it is where it would have been.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct PosePush {
    /// The frame, counted from 0.
    #[cfg_attr(feature = "types", ts(type = "number"))]
    pub frame: usize,
    /// The displacement.
    pub by: Vec<f64>,
}

impl Default for Handles {
    fn default() -> Self {
        Self { tempo: 1.0, goal: None, push: None }
    }
}

impl Handles {
    /// Checks the handles of a rollout of `frames` frames and `columns` columns.
    pub(crate) fn check(&self, frames: usize, columns: usize) -> Result<(), RolloutError> {
        if !TEMPOS.contains(&self.tempo) {
            let (lowest, highest) = (*TEMPOS.start(), *TEMPOS.end());
            return Err(RolloutError::Range { what: "a tempo", lowest, highest, found: self.tempo });
        }
        let push = self.push.as_ref();
        for (what, by) in [("goal", self.goal.as_ref()), ("push", push.map(|push| &push.by))] {
            if by.is_some_and(|by| by.len() != columns || by.iter().any(|number| !number.is_finite())) {
                return Err(RolloutError::Displacement { what, expected: columns });
            }
        }
        match push {
            Some(&PosePush { frame: found, .. }) if found >= frames => {
                Err(RolloutError::Unfelt { what: "push", first: 0, end: frames, found })
            }
            _ => Ok(()),
        }
    }

    /// The push of a frame `[D]`, if there is one.
    pub(crate) fn push_at(&self, frame: usize) -> Option<DVector<f64>> {
        let push = self.push.as_ref().filter(|push| push.frame == frame)?;
        Some(DVector::from_column_slice(&push.by))
    }

    /// The goal, moved.
    pub(crate) fn moved(&self, goal: &DVector<f64>) -> DVector<f64> {
        self.goal.as_ref().map_or_else(|| goal.clone(), |by| goal + DVector::from_column_slice(by))
    }
}

/// A rollout of a model with couplings.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Rollout {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// All columns, means included [frames x D].
    pub y: DMatrix<f64>,
    /// The weights of the experts under the couplings [M x M], row the source; those into each part sum to 1.
    pub weights: DMatrix<f64>,
}

impl Rollout {
    /// The rollout of a kind of model without latents and couplings: all columns [frames x D].
    #[doc(hidden)]
    pub fn of_columns(y: DMatrix<f64>) -> Self {
        Self { y, latents: Vec::new(), weights: DMatrix::zeros(0, 0) }
    }
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
        /// The number of them, at least 1.
        count: usize,
        /// The number asked for.
        found: usize,
    },
    /// The model does not store the latents of this frame.
    #[error("expected a frame of the sequence from 0 to {most} to start from, found {found}")]
    StartFrame {
        /// The last frame with stored latents.
        most: usize,
        /// The number asked for.
        found: usize,
    },
    /// The request has start latents, and a training sequence or a frame of one too.
    #[error(
        "expected start latents, or a training sequence and its frame, found both: sequence {sequence} and \
         frame {frame}"
    )]
    TwoStarts {
        /// The sequence asked for.
        sequence: usize,
        /// The frame asked for.
        frame: usize,
    },
    /// The start latents have another number of parts than the model.
    #[error("expected start latents of {expected} parts, found {found}")]
    StartParts {
        /// Parts of the model.
        expected: usize,
        /// Parts found.
        found: usize,
    },
    /// There is no such part.
    #[error("expected a part from 0 to {}, found {found}", count - 1)]
    Part {
        /// The number of them, at least 1.
        count: usize,
        /// The number asked for.
        found: usize,
    },
    /// A kind of model without couplings.
    #[error("expected a vcgpdm or vgpdm model, found a {found} model")]
    Kind {
        /// The kind of the model.
        found: &'static str,
    },
    /// A kind of model without handles.
    #[error("expected a tmp, dmp-discrete or dmp-rhythmic model for handles, found a {found} model")]
    Handles {
        /// The kind of the model.
        found: &'static str,
    },
    /// A TMP has no goal.
    #[error("expected a dmp model for another goal, found a tmp model, which is a function of time")]
    NoGoal,
    /// A displacement does not fit the columns.
    #[error("expected a displacement of the {what} by {expected} finite numbers, one for each column")]
    Displacement {
        /// "goal" or "push".
        what: &'static str,
        /// Columns D.
        expected: usize,
    },
    /// A number is out of its range.
    #[error("expected {what} from {lowest} to {highest}, found {found}")]
    Range {
        /// What the number is.
        what: &'static str,
        /// Smallest value.
        lowest: f64,
        /// Largest value.
        highest: f64,
        /// The value asked for.
        found: f64,
    },
    /// A part cannot be driven round a cycle that does not exist.
    #[error("expected a model whose learned rollout repeats itself, found one that does not")]
    NoCycle,
    /// A drive has too many turns.
    #[error("expected from -{most} to {most} turns, found {found}")]
    Turns {
        /// The largest number, forward or back.
        most: f64,
        /// The number asked for.
        found: f64,
    },
    /// The latents of a recording do not fit the part that it shall move.
    #[error(
        "expected latents of a recording for part {part}: {least} or more x {columns} finite numbers, found \
         {found}"
    )]
    Recording {
        /// The part, counted from 0.
        part: usize,
        /// The fewest frames: twice the order p of the dynamics.
        least: usize,
        /// The latent dimensions Q of the part.
        columns: usize,
        /// The shape found, or a number that is not finite.
        found: String,
    },
    /// The wanted place of a node is not finite.
    #[error("expected a place of three finite numbers, found {found}")]
    Place {
        /// The number found.
        found: f64,
    },
    /// The figure has no such node.
    #[error("expected a node of the figure from 0 to {}, found {found}", count - 1)]
    Node {
        /// The number of them, at least 1.
        count: usize,
        /// The number asked for.
        found: usize,
    },
    /// All couplings into a part are cut.
    #[error(
        "expected one coupling into part {target} that is not cut, found none: nothing \
         would say where it goes"
    )]
    CutOff {
        /// The part, counted from 0.
        target: usize,
    },
    /// A push does not fit its part.
    #[error(
        "expected a push of part {part} by {expected} finite numbers, one for each latent dimension, \
         found {found}"
    )]
    Push {
        /// The part, counted from 0.
        part: usize,
        /// The latent dimensions Q of the part.
        expected: usize,
        /// The number of numbers found.
        found: usize,
    },
    /// A push has a number that is not finite.
    #[error("expected a push of part {part} by finite numbers, found {found}")]
    PushNumber {
        /// The part, counted from 0.
        part: usize,
        /// The number found.
        found: f64,
    },
    /// A cut or a push is in no predicted frame.
    #[error(
        "expected a {what} in a frame that is predicted, from {first} on and before {end}, found {found}"
    )]
    Unfelt {
        /// "cut" or "push".
        what: &'static str,
        /// The first frame that is predicted: the order p of the dynamics.
        first: usize,
        /// Frames of the rollout.
        end: usize,
        /// The frame asked for; for a cut, its first frame.
        found: usize,
    },
    /// A rollout with variances cannot have cuts and pushes.
    #[error("expected no cuts and pushes in a rollout with variances")]
    Disturbed,
    /// The number of frames is 0 or too large.
    #[error("expected from 1 to {most} frames, found {found}")]
    Frames {
        /// The most frames.
        most: usize,
        /// The number asked for.
        found: usize,
    },
    /// The start latents do not fit the model.
    #[error(
        "the start latents of part {part} must be {rows} x {columns} numbers, found {found_rows} x \
         {found_columns}"
    )]
    Start {
        /// The part, counted from 0.
        part: usize,
        /// Rows expected: the order p of the dynamics, or as many as the first part has.
        rows: usize,
        /// Columns expected: the latent dimensions Q of the part.
        columns: usize,
        /// Rows found.
        found_rows: usize,
        /// Columns found.
        found_columns: usize,
    },
    /// The history of the predicted frame is not complete.
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

/// Checks that a rollout can have `frames` frames.
///
/// # Errors
///
/// When the number of frames is 0 or larger than [`MOST_FRAMES`].
pub(crate) fn check_frames(frames: usize) -> Result<(), RolloutError> {
    if (1..=MOST_FRAMES).contains(&frames) {
        return Ok(());
    }
    Err(RolloutError::Frames { most: MOST_FRAMES, found: frames })
}

crate::coded!(RolloutError {
    // Only a rollout that is not finite cannot be turned into poses.
    Self::Numerics(_) | Self::Pose(_) => Numerics,
    _ => Rollout,
});
