//! Gaussian processes with inducing points: the kernel, the psi statistics, the collapsed bound, and the
//! linear algebra under them.
//!
//! Symbols: P input dimensions, K inducing inputs z [K x P], N inputs (rows), C target columns. The glossary
//! of the project (`docs/glossary.md`) compares them with the symbols of the papers.

pub mod bound;
pub(crate) mod exp;
mod gaussians;
pub(crate) mod kernel;
mod kernel_sum;
pub(crate) mod lanes;
pub mod linalg;
pub mod moments;
pub mod outputs;
pub mod partially_fixed;
pub mod psi;
pub mod stored_outputs;
pub(crate) mod tall;
#[cfg(test)]
mod testing;

pub use gaussians::Gaussians;
pub use kernel::{Kernel, KernelAdjoint};
pub use kernel_sum::KernelSum;
pub use linalg::NumericsError;
