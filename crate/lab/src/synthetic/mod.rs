//! The synthetic experiment of Velychko et al. (2018, section 5.1, figure 3): two coupled systems, one of
//! which drives the other weakly. Does a training find out which?
//!
//! x^1_t = g^1(x^1_{t-1}) (18), x^2_t = 0.1 g^1(x^1_{t-1}) + 0.9 g^2(x^2_{t-1}) (19), 300 frames, both of
//! dimension 2; each part is seen through 10 functions of its latents. All functions are drawn from GPs with
//! an RBF kernel.
//!
//! The paper does not give its lengthscales, starts and noise, nor how it treats draws that come to rest.
//! Here g^1 and g^2 are draws that are conditioned on a few noisy transitions around the origin, each at its
//! own rate. So the movement goes on, and the parts do not synchronise: in synchrony, the phase of each part
//! determines that of the other, and the data do not show which part drives which.
//!
//! ```
//! use vcgpdm_core::models::VariationalSettings;
//! use vcgpdm_lab::synthetic::{DRIVE, Experiment, Synthetic};
//!
//! let data = Synthetic::draw(2, DRIVE)?;
//! assert_eq!((data.y.len(), data.y[0].shape()), (2, (300, 10)));
//!
//! // A few iterations only; `Synthetic::settings()` has 1500.
//! let settings = VariationalSettings { max_iterations: 5, ..Synthetic::settings() };
//! let mut experiment = Experiment::new(data, &settings, 2)?;
//! while !experiment.step().done {}
//! let findings = experiment.findings()?;
//! assert!(findings.now.fit.bound > experiment.start().fit.bound);
//! println!("alpha from part 1 to part 2: {}", findings.alpha[(0, 1)]);
//! # Ok::<(), vcgpdm_lab::synthetic::SyntheticError>(())
//! ```

mod alignment;
mod data;
mod experiment;
mod function;

pub use alignment::{LatentAlignment, align};
pub use data::{DRIVE, NOISE_VARIANCE, Synthetic, SyntheticError};
pub use experiment::{ALIKE, MUCH, Verdict};
pub use experiment::{Experiment, Findings, Fit, Snapshot};

#[cfg(test)]
mod tests;
