//! Primitives of another training, learned again under the pose maps of this library.
//!
//! Two trainings share no latent space: what a primitive predicts means nothing under other pose maps. So its
//! dynamics are learned again: new frames get latents under the pose maps of this library, which stay as they
//! are, as do the primitives that stand in for parts that bring none of their own; inducing inputs, kernels
//! and outputs of the new primitives, couplings and latents are learned.

mod frames;
mod request;
mod start;
mod trainer;

pub use request::{ImportError, ImportFrames, ImportRequest};
pub use trainer::ImportTrainer;

#[cfg(test)]
mod tests;
