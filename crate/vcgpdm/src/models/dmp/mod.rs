//! Dynamic movement primitives (Ijspeert et al. 2013): one damped spring for each column, pushed by a learned
//! force.
//!
//! tau z' = alpha_z (beta_z (g - y) - z) + f, tau y' = z, with alpha_z = 25 and beta_z = alpha_z / 4. Without
//! f, y goes to the goal g. Two canonical systems stand for time:
//!
//! - discrete: tau x' = -alpha_x x, x(0) = 1; f = s x sum_b psi_b(x) w_b / sum_b psi_b(x), psi Gaussian in x.
//!   x fades out, so g is reached. s = g - y(0) lets the whole movement grow with its distance. Where a
//!   movement ends near where it began this divides by about nothing: a column whose training trials do not
//!   all go the same way, and by a good part of its range, has s = 1 instead: its movement keeps its size,
//!   and a moved goal only shifts it.
//! - rhythmic: tau phi' = 1; f = r sum_b psi_b(phi) w_b / sum_b psi_b(phi), psi von Mises in phi, g the
//!   centre of the cycle, r the amplitude, 1 in the training trials. 2 pi tau is the period.
//!
//! t / tau is the phase of the trial, phi / 2 pi that of its cycle, both after an
//! [alignment](crate::models::data::phase::Alignment) of the trials.
//!
//! The weights are one ridge regression of the forces that the training trials would have needed, over all
//! frames of all trials. A new trial gives y(0) and y'(0) by its first frames; the rhythmic system is started
//! in the phase, and with the amplitude, at which its limit cycle is nearest to them. There is no noise
//! model, hence no bound.

mod discrete;
mod learner;
mod rhythmic;
mod spring;
mod stored;
#[cfg(test)]
mod tests;

pub use discrete::{DiscreteStart, DmpDiscrete};
pub use learner::DmpLearner;
pub use rhythmic::{DmpRhythmic, RhythmicStart};

use nalgebra::DVector;

/// Neighbouring bases overlap: their width is this part of their distance.
const OVERLAP: f64 = 0.65;

/// Which canonical system stands for time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Canonical {
    /// Towards a goal.
    Discrete,
    /// Around a centre.
    Rhythmic,
}

/// Position and velocity at the first frame of a sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringStart {
    /// y(0) `[D]`.
    pub position: DVector<f64>,
    /// y'(0), per frame `[D]`.
    pub velocity: DVector<f64>,
}
