//! Coupled Gaussian process movement primitives: the vCGPDM of Velychko, Knopp and Endres (2017-2020).
//!
//! A body is split into parts; each part gets a small latent dynamical system, learned from motion capture; a product of
//! experts couples them, and the coupling variances alpha say how strongly each part drives each other part.

mod clip;
pub mod samples;
mod skeleton;

pub use clip::Clip;
pub use skeleton::{Channel, Joint, Skeleton};
