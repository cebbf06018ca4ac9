//! Imports: primitives of another library (the donor), learned again under the pose maps of this one.
//!
//! Two trainings share no latent space, so the predictions of a primitive are wrong under other pose maps. An
//! import learns its dynamics again from frames. Fixed are the pose maps of this library (the host) and its
//! primitives for parts without a new one (the companions). Learned are the latents of the frames, the
//! couplings, and the new primitives: inducing inputs, kernels and outputs.

mod frames;
mod request;
mod start;
mod trainer;

pub use request::{ImportError, ImportFrames, ImportRequest};
pub use trainer::ImportTrainer;

#[cfg(test)]
mod tests;
