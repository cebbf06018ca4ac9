//! How a model was made.

use crate::models::training::settings::ModelSettings;

/// The program and its version, as documents and results name what made them.
pub const ENGINE: &str = concat!("vcgpdm ", env!("CARGO_PKG_VERSION"));

/// How a model was made. `S` are its settings: those of one kind of model, or of any kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Provenance<S = ModelSettings> {
    /// The program and its version.
    pub engine: String,
    /// What training was asked to do.
    pub settings: S,
    /// The seed of everything random; 0 for a model that has nothing random.
    pub seed: u32,
    /// The frame rate that the clips were asked to be brought to, in frames a second.
    pub frames_per_second: f64,
    /// What training maximised, at its best: the bound or a log density in nats, or the negative of an error.
    pub objective: f64,
    /// Iterations of the training.
    pub iterations: usize,
    /// Evaluations of the variational bound with its gradient; 0 for models that have none.
    pub evaluations: usize,
    /// What a person wants to say about the model, such as an acknowledgement.
    pub note: Option<String>,
}

impl<S> Provenance<S> {
    /// The same with settings of another type.
    pub(crate) fn with_settings<T>(self, settings: impl FnOnce(S) -> T) -> Provenance<T> {
        let Self { engine, settings: old, seed, frames_per_second, objective, iterations, evaluations, note } =
            self;
        let settings = settings(old);
        Provenance { engine, settings, seed, frames_per_second, objective, iterations, evaluations, note }
    }
}
