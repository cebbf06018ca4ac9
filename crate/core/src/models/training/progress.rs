//! Progress of a training of any kind of model, and why it ended.

use crate::gp::NumericsError;
use crate::models::search::Setbacks;
use serde::{Deserialize, Serialize, Serializer};
use std::fmt;

/// The terms of the bound, in nats.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct BoundTerms {
    /// The pose map of each part.
    pub kinematics: Vec<f64>,
    /// The dynamics into each part.
    pub dynamics: Vec<f64>,
    /// The prior of the first frames.
    pub initial: f64,
    /// The entropy of q(x) over all frames.
    pub entropy: f64,
}

impl BoundTerms {
    /// The "dynamics ELBO" of Knopp et al. (2019, section 4.3): the bound without the pose maps. They found that it
    /// predicts how natural people find the walks of a model, and that the terms of the pose maps do not.
    pub fn dynamics_elbo(&self) -> f64 {
        self.dynamics.iter().sum::<f64>() + self.initial + self.entropy
    }

    /// The bound on the log evidence.
    pub fn total(&self) -> f64 {
        self.kinematics.iter().sum::<f64>() + self.dynamics.iter().sum::<f64>() + self.initial + self.entropy
    }
}

/// The progress of a training.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "TrainingProgress"))]
pub struct Progress {
    /// Iterations so far.
    pub iteration: usize,
    /// The most iterations.
    pub max_iterations: usize,
    /// Evaluations of the bound with its gradient; 0 for models that have none.
    pub evaluations: usize,
    /// Numerical failures so far that the training survived.
    pub setbacks: Setbacks,
    /// The current value of the objective, in nats: the bound, the sum of its terms with weighted poses, a log density, or
    /// the negative of an error.
    #[serde(rename = "bound")]
    pub objective: f64,
    /// The best value so far.
    pub best: f64,
    /// The terms of the bound at the best value, without weights; absent for models without such terms.
    #[cfg_attr(feature = "types", ts(as = "BoundTerms"))]
    pub terms: Option<BoundTerms>,
    /// The current phase; absent for models that are not trained in phases.
    #[cfg_attr(feature = "types", ts(as = "TrainingPhase"))]
    pub phase: Option<TrainingPhase>,
    /// Whether training has ended.
    pub done: bool,
    /// Why it ended; `None` before the end.
    #[cfg_attr(feature = "types", ts(type = "EndReason | null"))]
    pub reason: Option<EndReason>,
    /// Share of the work that is done, 0 to 1. The time left is at most elapsed * (1 - fraction) / fraction.
    pub fraction: f64,
}

/// The parameters that are optimised: first all but the latents, then everything. Then, if the settings say
/// so, the model is watched, and its dynamics learn from its own rollouts where these do not move on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum TrainingPhase {
    /// Couplings, kernels and inducing points are free, the latents fixed.
    CouplingsKernelsInducingPoints,
    /// All parameters are free.
    Everything,
    /// The parameters are found. The model is rolled out, and its dynamics learn from these rollouts where they do
    /// not move on.
    OwnRollouts,
}

impl fmt::Display for TrainingPhase {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            TrainingPhase::CouplingsKernelsInducingPoints => "couplings, kernels and inducing points",
            TrainingPhase::Everything => "everything together",
            TrainingPhase::OwnRollouts => "learning from its own rollouts",
        })
    }
}

/// Why a training ended, displayed in plain message in the terminal and in results files.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EndReason {
    /// The bound no longer rises.
    BoundSettled,
    /// The objective with weighted poses no longer rises.
    WeightedBoundSettled,
    /// The log density no longer rises.
    DensitySettled,
    /// All iterations are used.
    Iterations,
    /// More temporal primitives than the best number lower the bound.
    MorePrimitivesAreWorse {
        /// The number of primitives of the highest bound.
        best: usize,
    },
    /// The largest number of temporal primitives is reached.
    MostPrimitives {
        /// The number of primitives of the highest bound.
        best: usize,
    },
    /// The one regression that dynamic movement primitives need is done.
    Regression,
    /// A covariance could not be factorised; the best before that is kept.
    Failed {
        /// The number of temporal primitives that failed, for a TMP.
        primitives: Option<usize>,
        /// The error.
        error: NumericsError,
    },
}

/// Why the training of a variational model ended, in a word.
impl Serialize for EndReason {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(if *self == EndReason::Iterations { "iterations" } else { "settled" })
    }
}

impl fmt::Display for EndReason {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            EndReason::BoundSettled => f.write_str("the bound no longer rises"),
            EndReason::WeightedBoundSettled => f.write_str("the weighted objective no longer rises"),
            EndReason::DensitySettled => f.write_str("the density no longer rises"),
            EndReason::Iterations => f.write_str("all iterations used"),
            EndReason::MorePrimitivesAreWorse { best } => {
                write!(f, "more than {best} primitives lower the bound")
            }
            EndReason::MostPrimitives { best } => {
                write!(f, "the most primitives are tried; {best} are best")
            }
            EndReason::Regression => f.write_str("the regression is done"),
            EndReason::Failed { primitives: Some(count), error } => {
                write!(f, "stopped with {count} primitives: {error}")
            }
            EndReason::Failed { primitives: None, error } => write!(f, "stopped: {error}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Results files contain these sentences.
    #[test]
    fn displays_reasons_setbacks_and_phases() {
        let error = NumericsError::NotFinite { what: "bound" };
        let failed = |primitives| EndReason::Failed { primitives, error: error.clone() };
        for (reason, message) in [
            (EndReason::BoundSettled, "the bound no longer rises".to_owned()),
            (EndReason::DensitySettled, "the density no longer rises".to_owned()),
            (EndReason::WeightedBoundSettled, "the weighted objective no longer rises".to_owned()),
            (EndReason::Iterations, "all iterations used".to_owned()),
            (
                EndReason::MorePrimitivesAreWorse { best: 4 },
                "more than 4 primitives lower the bound".to_owned(),
            ),
            (EndReason::MostPrimitives { best: 11 }, "the most primitives are tried; 11 are best".to_owned()),
            (EndReason::Regression, "the regression is done".to_owned()),
            (failed(Some(3)), format!("stopped with 3 primitives: {error}")),
            (failed(None), format!("stopped: {error}")),
        ] {
            assert_eq!(reason.to_string(), message);
        }
        let setbacks = Setbacks { jittered: 3, turned_back: 1 };
        assert_eq!(
            setbacks.to_string(),
            "3 covariances needed jitter on the diagonal, and the search turned back from 1 point \
             that gave no finite number"
        );
        assert!(setbacks.any() && !Setbacks::default().any());
        assert_eq!(TrainingPhase::Everything.to_string(), "everything together");
    }
}
