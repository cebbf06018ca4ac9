//! The inducing outputs of a process: optimal ones, which drop out of the bound, or stored ones.

use crate::gp::bound::{BoundAdjoint, BoundWorkspace, SparseGp};
use crate::gp::linalg::NumericsError;
use crate::gp::partially_fixed::PartiallyFixed;
use crate::gp::stored_outputs::StoredOutputs;

/// The source of the inducing outputs of a process, with memory for its bound.
pub enum Outputs {
    /// The optimal ones for the rows: the collapsed bound.
    Best(Box<BoundWorkspace>),
    /// Those of a stored process, which are fixed.
    Stored(Box<StoredOutputs>),
    /// The fixed ones of a stored process and, after them in the stack, the optimal ones of new processes.
    PartiallyFixed(Box<PartiallyFixed>),
}

impl Outputs {
    /// For a stack of K = `points` inducing points and C = `columns` target columns. The first outputs of the
    /// stack are those of `stored`, if there is any; all others are optimal.
    pub fn new(stored: Option<&StoredOutputs>, points: usize, columns: usize) -> Self {
        match stored {
            None => Self::Best(Box::new(BoundWorkspace::new(points, columns))),
            Some(stored) if stored.points() < points => {
                Self::PartiallyFixed(Box::new(PartiallyFixed::new(stored.clone(), points, columns)))
            }
            Some(stored) => Self::Stored(Box::new(stored.clone())),
        }
    }

    /// The bound, in nats.
    pub fn bound(&mut self, gp: &SparseGp<'_>) -> Result<f64, NumericsError> {
        match self {
            Self::Best(workspace) => gp.bound(workspace),
            Self::Stored(stored) => Ok(stored.bound(gp)),
            Self::PartiallyFixed(stack) => stack.bound(gp),
        }
    }

    /// The bound, in nats. Its adjoint is then [`adjoint`](Self::adjoint).
    pub fn bound_and_adjoint(&mut self, gp: &SparseGp<'_>) -> Result<f64, NumericsError> {
        match self {
            Self::Best(workspace) => gp.bound_and_adjoint(workspace),
            Self::Stored(stored) => Ok(stored.bound_and_adjoint(gp)),
            Self::PartiallyFixed(stack) => stack.bound_and_adjoint(gp),
        }
    }

    /// Multiplies the adjoint by `factor`, for a sum in which the bound has this weight.
    pub fn weight_adjoint(&mut self, factor: f64) {
        let adjoint = match self {
            Self::Best(workspace) => &mut workspace.adjoint,
            Self::Stored(stored) => &mut stored.adjoint,
            Self::PartiallyFixed(stack) => &mut stack.adjoint,
        };
        adjoint.k *= factor;
        adjoint.psi2 *= factor;
        adjoint.b *= factor;
        for number in [&mut adjoint.psi0, &mut adjoint.second_moment, &mut adjoint.noise] {
            *number *= factor;
        }
    }

    /// The adjoint of the last [`bound_and_adjoint`](Self::bound_and_adjoint).
    pub fn adjoint(&self) -> &BoundAdjoint {
        match self {
            Self::Best(workspace) => workspace.adjoint(),
            Self::Stored(stored) => stored.adjoint(),
            Self::PartiallyFixed(stack) => stack.adjoint(),
        }
    }
}
