//! Why primitives cannot be combined.

use crate::gp::NumericsError;
use crate::models::rollout::couplings::CouplingsError;
use thiserror::Error;

/// Why primitives cannot be combined as asked.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CombinationError {
    /// Not one primitive for each part.
    #[error("expected a primitive for each of {expected} parts, found {found}")]
    Count {
        /// Parts there are.
        expected: usize,
        /// Primitives named.
        found: usize,
    },
    /// A part is given what is not one of its primitives.
    #[error("expected a primitive of part {part}, found primitive {found}")]
    Primitive {
        /// The part, counted from 0.
        part: usize,
        /// What it was given, counted from 0.
        found: usize,
    },
    /// There is no such primitive, or none is named at all.
    #[error("expected primitives from 0 to {}, one or more, found {found}", count.saturating_sub(1))]
    Unknown {
        /// Primitives there are.
        count: usize,
        /// What was named.
        found: String,
    },
    /// There is no such movement.
    #[error("expected a movement from 0 to {}, found {found}", count.saturating_sub(1))]
    Movement {
        /// Movements there are.
        count: usize,
        /// The one asked for, counted from 0.
        found: usize,
    },
    /// A combination would take the place of a movement that primitives learned from.
    #[error("expected a name that no learned movement has, found {found:?}")]
    Learned {
        /// The name asked for.
        found: String,
    },
    /// The couplings do not fit the parts.
    #[error(transparent)]
    Couplings(#[from] CouplingsError),
    /// The primitives cannot be solved for.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}
