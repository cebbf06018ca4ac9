//! Why a training cannot start, and why movements, primitives and couplings are refused.

use crate::gp::NumericsError;
use crate::plural::counted;
use thiserror::Error;

/// Why couplings do not fit a model.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CouplingsError {
    /// The couplings are not one for each pair of parts.
    #[error("expected coupling variances for {parts} x {parts} parts, found {rows} x {columns}")]
    Shape {
        /// Number of parts M.
        parts: usize,
        /// Rows found.
        rows: usize,
        /// Columns found.
        columns: usize,
    },
    /// A coupling is not a positive variance.
    #[error(
        "expected a positive coupling variance from part {source_part} to part {target}, 1e-100 to 1e100, \
         found {value:?}"
    )]
    Variance {
        /// The source part, counted from 0.
        source_part: usize,
        /// The target part, counted from 0.
        target: usize,
        /// The value found.
        value: f64,
    },
}

/// Why primitives cannot be combined as asked.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CombinationError {
    /// The number of primitives is not the number of parts.
    #[error("expected a primitive for each of {expected} parts, found {found}")]
    Count {
        /// Number of parts.
        expected: usize,
        /// Number of primitives.
        found: usize,
    },
    /// A part is given a primitive that belongs to another part or does not exist.
    #[error("expected a primitive of part {part}, found primitive {found}")]
    Primitive {
        /// The part, counted from 0.
        part: usize,
        /// The primitive, counted from 0.
        found: usize,
    },
    /// There is no such primitive, or no primitive is chosen.
    #[error("expected primitives from 0 to {}, one or more, found {found}", count.saturating_sub(1))]
    Unknown {
        /// Number of primitives.
        count: usize,
        /// The primitive found.
        found: String,
    },
    /// There is no such movement.
    #[error("expected a movement from 0 to {}, found {found}", count.saturating_sub(1))]
    Movement {
        /// Number of movements.
        count: usize,
        /// The movement asked for, counted from 0.
        found: usize,
    },
    /// A combination would replace a movement that primitives learned from.
    #[error("expected a name that no learned movement has, found {found:?}")]
    Learned {
        /// The name asked for.
        found: String,
    },
    /// The couplings do not fit the parts.
    #[error(transparent)]
    Couplings(#[from] CouplingsError),
    /// A covariance of the primitives cannot be factorised.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

/// Why a plan is not valid.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// A movement has no name, or a name with other characters than those allowed.
    #[error(
        "expected a name for each movement, of letters, digits, spaces, \"-\", \"_\" or \".\", found {0:?}"
    )]
    Name(String),
    /// Two movements have the same name.
    #[error("expected a name of its own for each movement, found {0:?} twice")]
    Twice(String),
    /// The plan does not say of each part whether its primitive is shared.
    #[error("expected shared or not for each of {expected} parts, found {found}")]
    Parts {
        /// Number of parts.
        expected: usize,
        /// Number of parts of the plan.
        found: usize,
    },
}

/// Why primitives and movements do not fit each other.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RepertoireError {
    /// There is nothing to learn from.
    #[error("expected at least one movement, found none")]
    NoMovement,
    /// The movements do not have all the sequences between them.
    #[error("expected movements of {expected} sequences in all, one or more each, found {found}")]
    Sequences {
        /// Sequences there are.
        expected: usize,
        /// Sequences of the movements, as far as they were counted.
        found: usize,
    },
    /// A primitive belongs to a part that is not there.
    #[error("expected primitive {primitive} to belong to a part from 0 to {}, found {found}", parts.saturating_sub(1))]
    Part {
        /// Which primitive, counted from 0.
        primitive: usize,
        /// Parts there are.
        parts: usize,
        /// Its part, counted from 0.
        found: usize,
    },
    /// A movement does not name one primitive for each part.
    #[error("expected movement {movement} to name a primitive for each of {parts} parts, found {found}")]
    Uses {
        /// Which movement, counted from 0.
        movement: usize,
        /// Parts there are.
        parts: usize,
        /// How many it names.
        found: usize,
    },
    /// A part uses a primitive that is not its own.
    #[error(
        "expected movement {movement} to give part {part} a primitive of that part, found primitive {found}"
    )]
    Primitive {
        /// Which movement, counted from 0.
        movement: usize,
        /// Which part, counted from 0.
        part: usize,
        /// The primitive it names, counted from 0.
        found: usize,
    },
}

crate::coded!(CombinationError { Self::Numerics(_) => Numerics, _ => Model });

/// Why sequences of these lengths cannot be trained on.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SequencesError {
    /// There is no sequence.
    #[error("expected at least one sequence, found none")]
    Empty,
    /// The order of the dynamics is zero.
    #[error("expected dynamics of order 1 or more, found 0")]
    Order,
    /// There are more frames in all than can be trained on.
    #[error("expected at most {most} frames in all, found more")]
    TooLong {
        /// The limit.
        most: usize,
    },
    /// A sequence is shorter than the history of a frame, or no sequence is longer, so that there is no
    /// transition to learn from.
    #[error("sequence {index} {}", too_few_for_order(*frames, *order))]
    TooShort {
        /// The sequence, counted from 0.
        index: usize,
        /// Its number of frames.
        frames: usize,
        /// Order of the dynamics.
        order: usize,
    },
}

/// The problem of a sequence with too few frames, to follow its name in a message.
fn too_few_for_order(frames: usize, order: usize) -> String {
    format!("has {}; dynamics of order {order} need at least {}", counted(frames, "frame"), order + 1)
}

/// Why a training could not start.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TrainingError {
    /// A setting is out of its range.
    #[error("{name} must be from {lowest} to {highest}, found {found}")]
    Setting {
        /// The name of the setting.
        name: &'static str,
        /// Smallest value.
        lowest: usize,
        /// Largest value.
        highest: usize,
        /// The value asked for.
        found: usize,
    },
    /// The weight of the pose terms is out of its range.
    #[error("the weight of the pose terms must be {expected}, found {found}")]
    PoseWeight {
        /// The weights that are allowed.
        expected: &'static str,
        /// The weight asked for.
        found: f64,
    },
    /// The schedule is empty.
    #[error("expected at least one phase in the schedule, found none")]
    NoPhases,
    /// There is no part.
    #[error("expected at least one part, found none")]
    NoParts,
    /// Observations and sequences do not fit each other.
    #[error(
        "part {part} has {} of observations, but the sequences have {expected}",
        counted(*found, "frame")
    )]
    Frames {
        /// The part, counted from 0.
        part: usize,
        /// Frames of the sequences.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// The number of parts is not that of the model.
    #[error("expected observations of {expected} parts, found {found}")]
    Parts {
        /// Number of parts of the model.
        expected: usize,
        /// Number of parts found.
        found: usize,
    },
    /// A part does not have the columns that were learned.
    #[error("part {part} has {}, expected {expected}", counted(*found, "column"))]
    Columns {
        /// The part, counted from 0.
        part: usize,
        /// Columns that were learned.
        expected: usize,
        /// Columns found.
        found: usize,
    },
    /// The primitives cannot be combined.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// No sequence is a whole movement.
    #[error("expected at least one whole movement to learn from, found none")]
    NoWhole,
    /// A sequence has too few frames.
    #[error("sequence {sequence} {}", too_few(*found, *expected))]
    Short {
        /// The sequence, counted from 0.
        sequence: usize,
        /// The fewest frames.
        expected: usize,
        /// Frames found.
        found: usize,
    },
    /// The sequences cannot be trained on.
    #[error(transparent)]
    Sequences(#[from] SequencesError),
    /// Movements and primitives do not fit each other.
    #[error(transparent)]
    Repertoire(#[from] RepertoireError),
    /// The plan of a library does not fit the data.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The bound cannot be computed at the starting point.
    #[error("training could not start: {0}")]
    Numerics(#[from] NumericsError),
}

impl TrainingError {
    /// The sequence that causes the error, counted from 0; `None` when it is not a single sequence.
    pub fn sequence(&self) -> Option<usize> {
        self.sequence_problem().map(|(sequence, _)| sequence)
    }

    /// The sequence that causes the error, and its problem, to follow its name in a message.
    pub(crate) fn sequence_problem(&self) -> Option<(usize, String)> {
        match self {
            TrainingError::Short { sequence, expected, found } => {
                Some((*sequence, too_few(*found, *expected)))
            }
            TrainingError::Sequences(SequencesError::TooShort { index, frames, order }) => {
                Some((*index, too_few_for_order(*frames, *order)))
            }
            _ => None,
        }
    }
}

fn too_few(found: usize, expected: usize) -> String {
    format!("has {}; expected at least {expected}", counted(found, "frame"))
}

/// Checks that a setting of the given name is from 1 to `highest`.
pub(crate) fn in_range(name: &'static str, found: usize, highest: usize) -> Result<(), TrainingError> {
    if (1..=highest).contains(&found) {
        return Ok(());
    }
    Err(TrainingError::Setting { name, lowest: 1, highest, found })
}

crate::coded!(TrainingError {
    Self::Setting { .. } | Self::PoseWeight { .. } => Settings,
    Self::Numerics(_) => Numerics,
    _ => Training,
});
