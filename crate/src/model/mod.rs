//! The model: parameters, statistics, the bound and its gradient, and the posterior.

mod bound;
mod elbo;
mod exp;
mod flat;
mod kernel;
mod lanes;
mod params;
mod posterior;
mod psi;
mod sequences;
mod tall;
#[cfg(test)]
pub mod testing;

pub use bound::InducingPosterior;
pub use elbo::{BoundTerms, DynamicsSums, Objective, Posteriors, Workspace, coupling_weights};
pub(crate) use exp::exp;
pub(crate) use flat::{ALPHA, BETA, LAMBDA, MU, SIGNAL};
pub use flat::{Group, Kind, Parameters};
pub use kernel::Kernel;
pub use params::{Expert, Params, PartParams};
pub use posterior::{FittedExpert, FittedModel, PoseMap, Reading};
pub use psi::Gaussians;
pub use sequences::{Sequences, SequencesError};
