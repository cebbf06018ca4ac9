//! The movement primitives that the GP dynamical models are compared with.

mod period;
mod phase;

pub use period::{Period, period};
pub use phase::{Alignment, PhaseAxis, PhaseMap, Trial};
