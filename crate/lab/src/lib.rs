//! Measurements with the library `vcgpdm`: comparisons of models, studies with people, and the experiments
//! behind the pages of `docs/`. The page, the npm package and the terminal program use them. This crate is
//! not published.
//!
//! - [`evaluation`]: cross-validation, dynamic time warping, and the results of a comparison.
//! - [`perception`]: the graphics Turing test: studies of movements, and the analysis of answers.
//! - [`synthetic`]: the synthetic experiment: data with a known coupling.
//! - [`DocumentKind`]: which of the project's documents a JSON text is.
//! - [`golden`]: data, parameters and their bound, to compare other implementations with this one.

// A test may use any platform's sines.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

mod document_kind;
pub mod evaluation;
pub mod golden;
pub mod perception;
pub mod synthetic;

pub use document_kind::DocumentKind;
