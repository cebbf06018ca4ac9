//! Values between JavaScript and Rust: checked arguments, options, results, errors.

pub mod arguments;
pub mod convert;
pub mod error;
pub mod read;
pub mod wording;
