//! The search for the parameters of the largest objective.

pub(crate) mod ascent;
pub(crate) mod optimizer;

pub use ascent::{Phase, SearchEnd};
