//! What the project measures with the library `vcgpdm`: comparisons of models, studies with people, and the
//! experiments behind the pages of `docs/`. The page, the npm package and the terminal program show the
//! results. This crate is not published.
//!
//! - [`evaluation`]: cross-validation, dynamic time warping, and the results of a comparison.
//! - [`perception`]: the graphics Turing test: studies of movements, and what people's answers say.
//! - [`synthetic`]: the synthetic experiment: data with a known truth about who drives whom.
//! - [`DocumentKind`]: which of the project's documents a JSON text is.
//! - [`golden`]: problems and their numbers, to hold other implementations against this one.

// A test may use any platform's sines.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

mod document_kind;
pub mod evaluation;
pub mod golden;
pub mod perception;
pub mod synthetic;

pub use document_kind::DocumentKind;
