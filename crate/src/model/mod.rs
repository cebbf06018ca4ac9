//! The model: parameters, statistics, the bound and its gradient, and the posterior.

mod bound;
mod elbo;
mod exp;
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
pub use kernel::Kernel;
#[cfg(all(feature = "speed", not(target_arch = "wasm32")))]
pub(crate) use lanes::Lanes;
pub use params::{Expert, Group, Kind, Params, PartParams};
pub use posterior::{FittedExpert, FittedModel, PoseMap, Reading};
pub use psi::Gaussians;
pub use sequences::{Sequences, SequencesError};
