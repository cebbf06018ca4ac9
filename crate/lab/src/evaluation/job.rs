//! One job of a comparison, and its result.

use crate::evaluation::candidate_text::every_setting;
use crate::evaluation::outcome::Outcome;
use serde::{Deserialize, Serialize};
use std::fmt::{Display, Formatter};
use vcgpdm::models::{ENGINE, Settings};

/// One candidate in one fold with one seed. Its text is different for different jobs.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// The kind of model with its settings.
    pub candidate: Settings,
    /// The trial held out, counted from 1.
    pub held_out: usize,
    /// Number of the other trials that are trained on.
    pub training_trials: usize,
    /// The seed of everything random.
    pub seed: u32,
}

impl Job {
    /// Whether there are enough trials for the job.
    pub(super) fn fits(&self, trials: usize) -> bool {
        (1..=trials).contains(&self.held_out) && (1..trials).contains(&self.training_trials)
    }
}

impl Display for Job {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let Job { candidate, held_out, training_trials, seed } = self;
        let candidate = every_setting(candidate);
        write!(f, "{candidate}; trial {held_out} held out, {training_trials} trained on, seed {seed}")
    }
}

/// A finished job: its outcome, or the reason of its failure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Finished {
    /// The job.
    pub job: Job,
    /// The program and its version that computed it.
    pub engine: String,
    /// The outcome; absent after a failure.
    pub outcome: Option<Outcome>,
    /// The reason of a failure.
    pub failure: Option<String>,
}

impl Finished {
    /// A job that this version has finished.
    pub fn new(job: Job, result: Result<Outcome, String>) -> Self {
        let (outcome, failure) = match result {
            Ok(outcome) => (Some(outcome), None),
            Err(failure) => (None, Some(failure)),
        };
        Self { job, engine: ENGINE.to_owned(), outcome, failure }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::testing::{map, variational};
    use std::collections::BTreeSet;
    use vcgpdm::models::{DmpSettings, TmpSettings, VariationalSettings};

    #[test]
    fn has_different_texts_for_different_jobs() {
        use Settings::{DmpDiscrete, DmpRhythmic, MapCgpdm, MapGpdm, Tmp, Vcgpdm, Vgpdm};
        let settings = variational(12);
        let candidates = [
            Vcgpdm(settings.clone()),
            Vgpdm(settings.clone()),
            Vgpdm(VariationalSettings { latent: 4, ..settings.clone() }),
            Vgpdm(VariationalSettings { order: 1, ..settings.clone() }),
            Vgpdm(VariationalSettings { dynamics_ips: 11, ..settings.clone() }),
            Vgpdm(VariationalSettings { pose_ips: 11, ..settings.clone() }),
            Vgpdm(VariationalSettings { max_iterations: 99, ..settings }),
            MapGpdm(map(false)),
            MapGpdm(map(true)),
            MapCgpdm(map(false)),
            Tmp(TmpSettings::default()),
            Tmp(TmpSettings { primitives: Some(4), ..TmpSettings::default() }),
            DmpDiscrete(DmpSettings { bases: 20 }),
            DmpRhythmic(DmpSettings { bases: 20 }),
            DmpRhythmic(DmpSettings { bases: 21 }),
        ];
        let job = |candidate: &Settings| Job {
            candidate: candidate.clone(),
            held_out: 2,
            training_trials: 3,
            seed: 7,
        };
        let mut jobs: Vec<Job> = candidates.iter().map(job).collect();
        let last = job(&candidates[14]);
        jobs.push(Job { held_out: 1, ..last.clone() });
        jobs.push(Job { training_trials: 2, ..last.clone() });
        jobs.push(Job { seed: 8, ..last });
        let ids: BTreeSet<String> = jobs.iter().map(Job::to_string).collect();
        assert_eq!(ids.len(), jobs.len(), "{ids:#?}");
        assert_eq!(
            jobs[7].to_string(),
            "map-gpdm, Q = 3, order 2, 100 iterations, not balanced; trial 2 held out, 3 trained on, seed 7"
        );
    }
}
