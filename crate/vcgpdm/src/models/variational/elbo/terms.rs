//! The terms of the bound.

use serde::{Deserialize, Serialize};

/// The terms of the bound, in nats.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BoundTerms {
    /// The pose map of each part `[M]`.
    pub kinematics: Vec<f64>,
    /// The dynamics into each part `[M]`.
    pub dynamics: Vec<f64>,
    /// The prior of the first p frames of every sequence.
    pub initial: f64,
    /// The entropy of q(x) over all frames.
    pub entropy: f64,
}

impl BoundTerms {
    /// The bound on the log evidence.
    pub fn total(&self) -> f64 {
        self.kinematics.iter().sum::<f64>() + self.dynamics.iter().sum::<f64>() + self.initial + self.entropy
    }
}
