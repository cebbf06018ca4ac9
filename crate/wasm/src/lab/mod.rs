//! Comparisons, studies with people, experiments.

pub mod evaluation;
pub mod perception;
pub mod results;
pub mod study;
pub mod synthetic;
