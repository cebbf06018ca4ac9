//! The synthetic experiment of Velychko et al. (2018, section 5.1, figure 3): two coupled systems of which one drives the
//! other weakly. Does training find who drives whom?
//!
//! x^1_t = g^1(x^1_{t-1}) (18), x^2_t = 0.1 g^1(x^1_{t-1}) + 0.9 g^2(x^2_{t-1}) (19), 300 frames, both of dimension 2; each
//! part is seen through 10 functions of its latents. All functions are drawn from GPs with an RBF kernel.
//!
//! The paper does not say its lengthscales, starts, noise or what it did with draws that come to rest. Here g^1 and g^2 are
//! draws given a few noisy transitions that turn about the origin, each at its own rate, so that the movement goes on and the
//! parts do not fall into step: in step, either one's phase tells the other's, and the data do not say who drives whom.

mod alignment;
mod data;
mod experiment;
mod function;
mod verdict;

pub use alignment::{Alignment, align};
pub use data::{DRIVE, NOISE_VARIANCE, Synthetic, SyntheticError};
pub use experiment::{Experiment, Findings, Fit};
pub use verdict::{ALIKE, MUCH, Verdict};

#[cfg(test)]
mod tests;
