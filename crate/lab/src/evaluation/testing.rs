//! Results for tests.

use crate::evaluation::candidate::Candidate;
use crate::evaluation::cross_validation::START_FRAMES;
use crate::evaluation::job::{Finished, Job};
use crate::evaluation::outcome::Outcome;
use crate::evaluation::results::Results;
use crate::evaluation::setting::{Setting, TrialClip};
use vcgpdm_core::models::Score;
use vcgpdm_core::models::{MapSettings, VariationalSettings};
use vcgpdm_core::motion::parts::PartSpec;

/// A setting of `trials` walks of a body with one named part.
pub fn setting(trials: usize) -> Setting {
    let trial =
        |k: usize| TrialClip { name: format!("walk {k}"), sha256: format!("sha of {k}"), piece: None };
    Setting {
        trials: (1..=trials).map(trial).collect(),
        parts: vec![PartSpec { name: "lower".to_owned(), joints: vec![0, 1] }],
        frames_per_second: 30.0,
        start_frames: START_FRAMES,
    }
}

/// Variational settings of this size.
pub fn variational(ips: usize) -> VariationalSettings {
    VariationalSettings {
        latent: 3,
        order: 2,
        dynamics_ips: ips,
        pose_ips: ips,
        max_iterations: 100,
        ..Default::default()
    }
}

/// Settings of a model with point latents.
pub fn map(balanced: bool) -> MapSettings {
    MapSettings { latent: 3, order: 2, max_iterations: 100, balanced, linear: false }
}

/// An outcome with these numbers, and the same error on the training trials as on the trial held out.
pub fn outcome(dtw_mse: f64, bound: Option<f64>, frames: usize, seconds: f64) -> Outcome {
    Outcome {
        score: Score { dtw_mse, mse: 2.0 * dtw_mse, variance: 0.05 },
        bound,
        objective: 0.0,
        iterations: 10,
        seconds,
        frames,
        stored_numbers: 700,
        reason: None,
        terms: None,
        part_errors: Vec::new(),
        training_mse: Some(dtw_mse),
        details: None,
        ignored: serde::de::IgnoredAny,
    }
}

/// A job that ended with this outcome.
pub fn finished(
    candidate: impl Into<Candidate>,
    held_out: usize,
    training_trials: usize,
    seed: u32,
    outcome: Outcome,
) -> Finished {
    let candidate = candidate.into();
    Finished::new(Job { candidate, held_out, training_trials, seed }, Ok(outcome))
}

/// Results on `trials` walks.
pub fn results(trials: usize, finished: &[Finished]) -> Results {
    let mut results = Results::new(setting(trials));
    for finished in finished {
        results.add(finished.clone()).unwrap();
    }
    results
}
