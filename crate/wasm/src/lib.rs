//! The npm package `vcgpdm`: the library for JavaScript.
//!
//! Types are the library's own; `values` carries them and their errors over in camelCase. `types.rs` declares them
//! in TypeScript.

mod data;
#[cfg(feature = "training")]
mod lab;
#[cfg(feature = "training")]
mod library;
mod models;
#[cfg(test)]
mod refused_calls;
#[cfg(feature = "types")]
mod types;
mod values;

#[cfg(feature = "types")]
pub use types::declarations;
use values::error::{ErrorCode, VcgpdmError};
use wasm_bindgen::prelude::*;

/// A fresh seed from the machine's own randomness.
#[wasm_bindgen(js_name = freshSeed)]
pub fn fresh_seed() -> Result<u32, VcgpdmError> {
    getrandom::u32().map_err(|reason| VcgpdmError::new(ErrorCode::Numerics, &reason))
}

/// The version of this package.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
