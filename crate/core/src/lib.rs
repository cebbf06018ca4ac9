//! What the library `vcgpdm` is made of: use `vcgpdm`, which gives these items short names and keeps them.
//!
//! Here everything is public, for the npm package, the terminal program, the Python package and the measurements of this
//! project. Any version may change it.

// Tests need not give the same bits on every platform.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod coded;
pub mod document;
pub mod elementary;
mod encoding;
pub mod gp;
pub mod json;
pub mod models;
pub mod motion;
pub mod plural;
pub mod series;
