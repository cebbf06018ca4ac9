//! The inducing outputs of a process: at their optimum, so that they drop out of the bound, or as they were
//! learned before.

use crate::gp::beside::BesideStored;
use crate::gp::bound::{BoundAdjoint, BoundWorkspace, SparseGp};
use crate::gp::linalg::NumericsError;
use crate::gp::stored_outputs::StoredOutputs;

/// Where the inducing outputs of a process come from, with the room for its bound.
pub enum Outputs {
    /// Those that explain the rows best: the collapsed bound.
    Best(Box<BoundWorkspace>),
    /// Those of a stored process, which stay as they are.
    Stored(Box<StoredOutputs>),
    /// Those of a stored process and, after them in the stack, the best ones of new processes.
    Beside(Box<BesideStored>),
}

impl Outputs {
    /// Room for a stack of so many `points` with so many `columns`: of the best ones, but for the first ones
    /// of the stack where those are `stored`.
    pub fn new(stored: Option<&StoredOutputs>, points: usize, columns: usize) -> Self {
        match stored {
            None => Self::Best(Box::new(BoundWorkspace::new(points, columns))),
            Some(stored) if stored.points() < points => {
                Self::Beside(Box::new(BesideStored::new(stored.clone(), points, columns)))
            }
            Some(stored) => Self::Stored(Box::new(stored.clone())),
        }
    }

    /// The bound, in nats.
    pub fn bound(&mut self, gp: &SparseGp<'_>) -> Result<f64, NumericsError> {
        match self {
            Self::Best(workspace) => gp.bound(workspace),
            Self::Stored(stored) => Ok(stored.bound(gp)),
            Self::Beside(beside) => beside.bound(gp),
        }
    }

    /// The bound, in nats, and its adjoint, which stays here.
    pub fn bound_and_adjoint(&mut self, gp: &SparseGp<'_>) -> Result<f64, NumericsError> {
        match self {
            Self::Best(workspace) => gp.bound_and_adjoint(workspace),
            Self::Stored(stored) => Ok(stored.bound_and_adjoint(gp)),
            Self::Beside(beside) => beside.bound_and_adjoint(gp),
        }
    }

    /// The adjoint computed last.
    pub fn adjoint(&self) -> &BoundAdjoint {
        match self {
            Self::Best(workspace) => workspace.adjoint(),
            Self::Stored(stored) => stored.adjoint(),
            Self::Beside(beside) => beside.adjoint(),
        }
    }
}
