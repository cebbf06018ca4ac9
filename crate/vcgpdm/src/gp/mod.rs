//! Gaussian processes with inducing points: linear algebra, the kernel, psi statistics, the collapsed bound. Knows no motion.

pub(crate) mod bound;
pub(crate) mod exp;
pub(crate) mod kernel;
mod kernel_sum;
pub(crate) mod lanes;
pub(crate) mod linalg;
pub(crate) mod psi;
pub(crate) mod tall;

pub use kernel::Kernel;
pub use kernel_sum::KernelSum;
pub use linalg::NumericsError;
pub use psi::Gaussians;
