//! One job of a comparison, its cost and its result.

use crate::evaluation::candidate::Candidate;
use crate::evaluation::candidate_text::every_setting;
use crate::evaluation::outcome::Outcome;
use serde::{Deserialize, Serialize};
use std::fmt::{Display, Formatter};
use vcgpdm_core::models::{ENGINE, TrainingCost};
use vcgpdm_core::motion::Clip;
use vcgpdm_core::motion::parts::PartSpec;

/// One candidate in one fold with one seed.
///
/// Its text is different for different jobs.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Job {
    /// The kind of model with its settings.
    #[cfg_attr(feature = "types", ts(as = "vcgpdm_core::models::Settings"))]
    pub candidate: Candidate,
    /// The held-out trial, counted from 0.
    pub held_out: usize,
    /// The number of other trials in the training set.
    pub training_trials: usize,
    /// The seed of everything random.
    pub seed: u32,
}

impl Job {
    /// Whether there are enough trials for the job.
    pub(super) fn fits(&self, trials: usize) -> bool {
        self.held_out < trials && (1..trials).contains(&self.training_trials)
    }
}

impl Display for Job {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let Job { candidate, held_out, training_trials, seed } = self;
        let (candidate, held_out) = (every_setting(candidate), held_out.saturating_add(1));
        write!(f, "{candidate}; trial {held_out} held out, {training_trials} trained on, seed {seed}")
    }
}

/// A finished job, with its outcome or the reason why it failed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "FinishedJob"))]
pub struct Finished {
    /// In files of the terminal program, the candidate can also be a `Rival`.
    #[serde(with = "job_in_files")]
    #[cfg_attr(feature = "types", ts(skip))]
    pub job: Job,
    /// The program that computed the outcome, and its version.
    pub engine: String,
    /// The outcome; absent after a failure.
    pub outcome: Option<Outcome>,
    /// The reason of a failure.
    pub failure: Option<String>,
}

/// For serde's `with`: files count the trial held out from 1.
pub mod job_in_files {
    use super::Job;
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    /// Writes the job for a file.
    ///
    /// # Errors
    /// The serializer fails.
    pub fn serialize<S: Serializer>(job: &Job, serializer: S) -> Result<S::Ok, S::Error> {
        Job { held_out: job.held_out.saturating_add(1), ..job.clone() }.serialize(serializer)
    }

    /// Reads the job of a file.
    ///
    /// # Errors
    /// The value is no job, or its trial is 0.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Job, D::Error> {
        let job = Job::deserialize(deserializer)?;
        let held_out = job.held_out.checked_sub(1);
        let held_out = held_out.ok_or_else(|| D::Error::custom("expected a trial from 1, found trial 0"))?;
        Ok(Job { held_out, ..job })
    }
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

    /// Takes the outcome of a later result of the same job after a failure.
    pub(super) fn complete_with(&mut self, later: Finished) {
        if let (None, Some(outcome)) = (&self.outcome, later.outcome) {
            *self = Finished { outcome: Some(outcome), ..later };
        }
    }
}

/// Columns of a joint: its rotation. The few columns of the root are neglected.
const COLUMNS: usize = 3;

impl Job {
    /// The estimated cost of its training on one core; that of a TMP, a DMP or a rival is neglected. `trials` are all
    /// clips of the comparison in their order.
    pub fn cost(&self, trials: &[Clip], parts: &[PartSpec], frames_per_second: f64) -> TrainingCost {
        let others = trials.iter().enumerate().filter(|(k, _)| *k != self.held_out);
        let seconds: f64 = others
            .take(self.training_trials)
            .map(|(_, clip)| clip.values.nrows() as f64 * clip.frame_time)
            .sum();
        let columns: Vec<usize> = parts.iter().map(|part| COLUMNS * part.joints.len()).collect();
        self.candidate.cost((seconds * frames_per_second).round() as usize, &columns)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::testing::{map, variational};
    use std::collections::BTreeSet;
    use vcgpdm_core::models::{DmpSettings, PoseWeight, Settings, TmpSettings, VariationalSettings};

    #[test]
    fn counts_the_trial_from_0_in_programs_and_from_1_in_files_and_texts() {
        let file = r#"{"job":{"candidate":{"model":"dmp-rhythmic","bases":5},"held_out":1,"training_trials":2,"seed":0},"engine":"vcgpdm 0.1.0","outcome":null,"failure":"no period was found"}"#;
        let finished: Finished = serde_json::from_str(file).unwrap();
        assert_eq!(finished.job.held_out, 0);
        assert!(finished.job.to_string().contains("trial 1 held out"), "{}", finished.job);
        assert_eq!(serde_json::to_string(&finished).unwrap(), file);
        let none = file.replace(r#""held_out":1"#, r#""held_out":0"#);
        let error = serde_json::from_str::<Finished>(&none).unwrap_err().to_string();
        assert!(error.starts_with("expected a trial from 1, found trial 0"), "{error}");
    }

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
            Vgpdm(VariationalSettings { max_iterations: 99, ..settings.clone() }),
            MapGpdm(map(false)),
            MapGpdm(map(true)),
            MapCgpdm(map(false)),
            Tmp(TmpSettings::default()),
            Tmp(TmpSettings { primitives: Some(4), ..TmpSettings::default() }),
            DmpDiscrete(DmpSettings { bases: 20 }),
            DmpRhythmic(DmpSettings { bases: 20 }),
            DmpRhythmic(DmpSettings { bases: 21 }),
            Vgpdm(VariationalSettings { pose_weight: PoseWeight::Balanced, ..settings.clone() }),
            Vgpdm(VariationalSettings { pose_weight: PoseWeight::Fixed(0.1), ..settings.clone() }),
            Vgpdm(VariationalSettings { uncoupled: true, ..settings }),
        ];
        let job = |candidate: &Settings| Job {
            candidate: candidate.clone().into(),
            held_out: 1,
            training_trials: 3,
            seed: 7,
        };
        let mut jobs: Vec<Job> = candidates.iter().map(job).collect();
        let last = job(&candidates[14]);
        jobs.push(Job { held_out: 0, ..last.clone() });
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

#[cfg(test)]
mod cost_tests {
    use super::*;
    use crate::evaluation::testing::{map, variational};
    use vcgpdm_core::models::Settings;
    use vcgpdm_core::motion::{parts, samples};

    #[test]
    fn the_cost_follows_the_training_trials() {
        let clips: Vec<Clip> = ["walk-1", "walk-2", "walk-3"].map(|id| samples::clip(id).unwrap()).into();
        let parts = parts::presets(&clips[0].skeleton).remove(1).parts;
        let cost = |candidate: &Settings, training_trials| {
            let job = Job { candidate: candidate.clone().into(), held_out: 0, training_trials, seed: 0 };
            job.cost(&clips, &parts, 30.0)
        };
        let variational = Settings::Vcgpdm(variational(12));
        let columns: Vec<usize> = parts.iter().map(|part| 3 * part.joints.len()).collect();
        let frames =
            |k: usize| (clips[k].values.nrows() as f64 * clips[k].frame_time * 30.0).round() as usize;
        assert_eq!(
            cost(&variational, 1),
            variational.cost(frames(1), &columns),
            "the first trial that is not held out"
        );
        let map = Settings::MapGpdm(map(false));
        for candidate in [&variational, &map] {
            assert!(cost(candidate, 2).seconds > 1.5 * cost(candidate, 1).seconds);
        }
    }
}
