//! Dynamic movement primitives (Ijspeert et al. 2013): a damped spring for each column, driven by a learned
//! force.
//!
//! tau z' = alpha_z (beta_z (g - y) - z) + f, tau y' = z, with alpha_z = 25 and beta_z = alpha_z / 4. Without
//! f, y goes to the goal g. There are two canonical systems for time:
//!
//! - discrete: tau x' = -alpha_x x, x(0) = 1; f = s x sum_b psi_b(x) w_b / sum_b psi_b(x), psi Gaussian in x.
//!   x goes to 0, so g is reached. s = g - y(0) scales the whole movement with its distance. For a movement
//!   that ends near its start, this would divide by nearly 0. So s = 1 for a column whose training trials do
//!   not all go the same way by a clear part of its range: then another goal shifts the movement without
//!   changing its size.
//! - rhythmic: tau phi' = 1; f = r sum_b psi_b(phi) w_b / sum_b psi_b(phi), psi von Mises in phi, g the
//!   centre of the cycle, r the amplitude, 1 in the training trials. 2 pi tau is the period.
//!
//! t / tau is the phase of the trial, phi / 2 pi that of its cycle, both after an
//! [alignment](crate::models::data::phase::Alignment) of the trials.
//!
//! The weights are a ridge regression of the forces of the training trials, over all frames of all trials.
//! The first frames of a new trial give y(0) and y'(0); the rhythmic system starts with the phase and the
//! amplitude at which its limit cycle is nearest to them. There is no noise model, and so no bound.

mod discrete;
mod json;
mod learner;
mod model;
mod rhythmic;
mod spring;
#[cfg(test)]
mod tests;

pub use learner::DmpLearner;
pub use model::{Canonical, Dmp, DmpStart};
pub use spring::SpringStart;
