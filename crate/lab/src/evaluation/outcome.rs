//! What came of one candidate in one fold of a cross-validation.

use crate::evaluation::dtw::Score;
use crate::evaluation::stats::mean;
use serde::{Deserialize, Serialize};
use vcgpdm::models::EndReason;
use vcgpdm::models::variational::BoundTerms;

/// What came of one candidate in one fold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Outcome {
    /// How far the prediction is from the trial.
    pub score: Score,
    /// The bound on the log evidence, where the model has one.
    pub bound: Option<f64>,
    /// What training maximised, at its best.
    pub objective: f64,
    /// Iterations of the training.
    pub iterations: usize,
    /// Seconds of the training.
    pub seconds: f64,
    /// Frames trained on.
    pub frames: usize,
    /// Numbers that must be kept to roll out.
    pub stored_numbers: usize,
    /// Why training ended.
    pub reason: Option<String>,
    /// The terms of the bound, where the model has a bound of such terms; absent in results of earlier
    /// programs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub terms: Option<BoundTerms>,
    /// The error of each part along the same warping path, in the order of the setting's parts; empty in
    /// results of earlier programs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub part_errors: Vec<f64>,
    /// The mean error over the trials trained on, each rolled out from its own beginning and scored in the
    /// same way; absent where one of them cannot be, and in results of earlier programs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub training_mse: Option<f64>,
}

impl Outcome {
    /// Whether the model of this seed stands for its candidate in the fold rather than that of another seed:
    /// what training maximised is higher.
    pub fn is_better_seed(&self, other: &Outcome) -> bool {
        self.objective > other.objective
    }

    /// Whether training ended because nothing changed any more; absent where that is not known.
    pub fn converged(&self) -> Option<bool> {
        let reason = self.reason.as_deref()?;
        if reason == EndReason::Iterations.to_string() {
            return Some(false);
        }
        let settled = [EndReason::BoundSettled, EndReason::DensitySettled];
        settled.iter().any(|end| reason == end.to_string()).then_some(true)
    }
}

/// The share of trainings that ended because nothing changed any more, of those about which that is known.
pub(super) fn share_converged<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> Option<f64> {
    let ends = outcomes.filter_map(Outcome::converged);
    let known: Vec<f64> = ends.map(|converged| f64::from(u8::from(converged))).collect();
    (!known.is_empty()).then(|| mean(&known))
}
