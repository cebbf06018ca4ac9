//! Why primitives cannot be combined.

use crate::gp::NumericsError;
use crate::models::rollout::couplings::CouplingsError;
use thiserror::Error;

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

crate::coded!(CombinationError { Self::Numerics(_) => Numerics, _ => Model });
