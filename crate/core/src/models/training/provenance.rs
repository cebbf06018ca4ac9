//! Provenance of a model.

use crate::models::training::progress::Progress;
use crate::models::training::settings::Settings;
use crate::models::variational::BoundTerms;

/// The program and its version, as in documents and results.
pub const ENGINE: &str = concat!("vcgpdm ", env!("CARGO_PKG_VERSION"));

/// Provenance of a model: settings, seed and results of its training.
#[derive(Clone, Debug, PartialEq)]
pub struct Provenance {
    /// The program and its version.
    pub engine: String,
    /// The settings of the training.
    pub settings: Settings,
    /// The seed of everything random; 0 for a kind of model without randomness.
    pub seed: u32,
    /// The frame rate asked for, in frames a second.
    pub frames_per_second: f64,
    /// The highest value of the objective: the bound, the sum of its terms with weighted poses, or a log density in
    /// nats, or the negative of an error.
    pub objective: f64,
    /// The bound on the log evidence at that point, in nats, if the objective weights the pose terms; absent
    /// for all other objectives.
    pub plain_bound: Option<f64>,
    /// Iterations of the training.
    pub iterations: usize,
    /// Evaluations of the variational bound with its gradient; 0 for models without such a bound.
    pub evaluations: usize,
    /// Rounds of its own rollouts from which the model learned after the training; see
    /// [`Model::learn_from_own_rollouts`](crate::models::Model::learn_from_own_rollouts).
    pub rollout_rounds: usize,
    /// A note by the person who trained the model, such as an acknowledgement.
    pub note: Option<String>,
}

impl Provenance {
    /// The provenance of the model of a training that is this far.
    pub fn of_training(settings: Settings, seed: u32, frames_per_second: f64, progress: &Progress) -> Self {
        let weighted = settings.variational().is_some_and(|s| !s.pose_weight.is_plain());
        Self {
            engine: ENGINE.to_owned(),
            seed: if settings.is_random() { seed } else { 0 },
            settings,
            frames_per_second,
            objective: progress.best,
            plain_bound: progress.terms.as_ref().filter(|_| weighted).map(BoundTerms::total),
            iterations: progress.iteration,
            evaluations: progress.evaluations,
            rollout_rounds: 0,
            note: None,
        }
    }

    /// The bound on the log evidence that training reached, in nats; for a model without a bound, the
    /// objective.
    pub fn bound(&self) -> f64 {
        self.plain_bound.unwrap_or(self.objective)
    }

    /// The provenance of a variational model of one part, which is a vGPDM.
    pub(crate) fn of_one_part(self) -> Self {
        let settings = match self.settings {
            Settings::Vcgpdm(settings) => Settings::Vgpdm(settings),
            settings => settings,
        };
        Self { settings, ..self }
    }
}
