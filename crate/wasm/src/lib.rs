//! The npm package `vcgpdm`: the library for JavaScript.
//!
//! Types are the library's own; `convert.rs` carries them over in camelCase, `error.rs` carries its errors.
//! The TypeScript of a function is declared next to it.

mod arguments;
mod body;
mod bvh;
#[cfg(feature = "speed")]
mod case;
mod clip;
#[cfg(feature = "training")]
mod completion;
mod convert;
mod document_kind;
mod error;
#[cfg(feature = "training")]
mod evaluation;
#[cfg(feature = "training")]
mod library;
#[cfg(feature = "training")]
mod library_trainers;
#[cfg(feature = "training")]
mod library_walk;
mod live;
#[cfg(feature = "training")]
mod maker;
mod model;
#[cfg(feature = "training")]
mod origin;
#[cfg(feature = "training")]
mod perception;
#[cfg(feature = "training")]
mod plane;
mod points;
mod predictions;
#[cfg(feature = "training")]
mod primitives;
mod read;
#[cfg(feature = "training")]
mod recognition;
#[cfg(test)]
mod refused_calls;
#[cfg(feature = "training")]
mod results;
mod rollout;
mod settings;
#[cfg(feature = "training")]
mod study;
#[cfg(feature = "training")]
mod synthetic;
#[cfg(feature = "training")]
mod tables;
mod trained;
#[cfg(feature = "training")]
mod trainer;
#[cfg(feature = "types")]
mod types;
mod wording;

use error::{ErrorCode, VcgpdmError};
#[cfg(feature = "types")]
pub use types::declarations;
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
