//! What an evaluation keeps: what was compared, and what came of it, job by job. The same in a file and on the page. No I/O.

use super::candidate::Candidate;
use super::cross_validation::{Outcome, START_FRAMES};
use crate::clip::Clip;
use crate::parts::PartSpec;
use serde::{Deserialize, Serialize};
use thiserror::Error;

const FORMAT: &str = "vcgpdm-evaluation";
const VERSION: u32 = 1;

/// A trial, by its content.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "comparison"), derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Trial {
    /// The clip's name.
    pub name: String,
    /// SHA-256 of the clip's file, hexadecimal.
    pub sha256: String,
}

/// A group of joints.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "comparison"), derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct ResultsPart {
    /// What it is called.
    pub name: String,
    /// Its joints, by their place in the skeleton.
    pub joints: Vec<usize>,
}

/// What all results of a file have in common.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "comparison"), derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Setting {
    /// The trials; each is held out in turn.
    pub trials: Vec<Trial>,
    /// How the coupled models split the body.
    pub parts: Vec<ResultsPart>,
    /// The clips were brought to about this rate.
    pub frames_per_second: f64,
    /// Frames of the trial held out that a prediction starts from.
    pub start_frames: usize,
}

impl Setting {
    /// Of these clips, split so, at this rate.
    pub fn new(clips: &[Clip], parts: &[PartSpec], frames_per_second: f64) -> Self {
        let trial = |clip: &Clip| Trial { name: clip.name.clone(), sha256: clip.sha256.clone() };
        let part = |part: &PartSpec| ResultsPart { name: part.name.clone(), joints: part.joints.clone() };
        Self {
            trials: clips.iter().map(trial).collect(),
            parts: parts.iter().map(part).collect(),
            frames_per_second,
            start_frames: START_FRAMES,
        }
    }
}

/// One model in one fold with one seed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "comparison"), derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// The model and its settings.
    pub candidate: Candidate,
    /// The trial held out, counted from 1.
    pub held_out: usize,
    /// How many of the others are trained on.
    pub training_trials: usize,
    /// The seed of everything random.
    pub seed: u32,
}

/// What came of a job: an outcome, or why there is none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "comparison"), derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(deny_unknown_fields)]
pub struct Finished {
    /// The job.
    pub job: Job,
    /// The program and its version that computed it.
    pub engine: String,
    /// What came of it.
    pub outcome: Option<Outcome>,
    /// Why nothing did.
    pub failure: Option<String>,
}

/// Why results cannot be used.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum ResultsError {
    /// Another document.
    #[error("expected {FORMAT} version {VERSION}, found {format:?} version {version}")]
    Format {
        /// What the document calls itself.
        format: String,
        /// Its version.
        version: u32,
    },
    /// A job that cannot be one of this setting.
    #[error(
        "result {index}: expected trials from 1 to {trials} and at least one to train on, found trial {held_out} held out of {training_trials} more"
    )]
    Job {
        /// Which result, counted from 1.
        index: usize,
        /// Trials there are.
        trials: usize,
        /// The trial held out.
        held_out: usize,
        /// Trials trained on.
        training_trials: usize,
    },
    /// Results of something else.
    #[error("these results are of {0}")]
    Differs(&'static str),
}

/// All of an evaluation so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "comparison"), derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(deny_unknown_fields)]
pub struct Results {
    format: String,
    version: u32,
    /// What was compared on what.
    pub setting: Setting,
    /// The jobs that are finished.
    pub finished: Vec<Finished>,
}

impl Results {
    /// Nothing finished yet.
    pub fn new(setting: Setting) -> Self {
        Self { format: FORMAT.to_owned(), version: VERSION, setting, finished: Vec::new() }
    }

    /// Whether this is a document of ours whose jobs fit its setting.
    pub fn check(&self) -> Result<(), ResultsError> {
        if self.format != FORMAT || self.version != VERSION {
            return Err(ResultsError::Format { format: self.format.clone(), version: self.version });
        }
        let trials = self.setting.trials.len();
        for (k, Finished { job, .. }) in self.finished.iter().enumerate() {
            let (held_out, training_trials) = (job.held_out, job.training_trials);
            if !(1..=trials).contains(&held_out) || !(1..trials).contains(&training_trials) {
                return Err(ResultsError::Job { index: k + 1, trials, held_out, training_trials });
            }
        }
        Ok(())
    }

    /// What is known of a job.
    pub fn find(&self, job: &Job) -> Option<&Finished> {
        self.finished.iter().find(|finished| finished.job == *job)
    }

    /// Takes over what the other knows and this one does not; both must be of the same setting.
    pub fn merge(&mut self, other: Results) -> Result<(), ResultsError> {
        if other.setting != self.setting {
            return Err(ResultsError::Differs(if other.setting.trials != self.setting.trials {
                "other trials"
            } else if other.setting.parts != self.setting.parts {
                "other parts"
            } else {
                "another frame rate"
            }));
        }
        for finished in other.finished {
            if self.find(&finished.job).is_none() {
                self.finished.push(finished);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setting() -> Setting {
        let trial = |name: &str| Trial { name: name.to_owned(), sha256: String::new() };
        Setting {
            trials: vec![trial("a"), trial("b")],
            parts: vec![],
            frames_per_second: 30.0,
            start_frames: START_FRAMES,
        }
    }

    fn finished(held_out: usize, training_trials: usize) -> Finished {
        let job = Job { candidate: Candidate::Tmp { primitives: None }, held_out, training_trials, seed: 0 };
        Finished { job, engine: String::new(), outcome: None, failure: Some("why".to_owned()) }
    }

    #[test]
    fn merging_keeps_what_was_known_first() {
        let mut results = Results::new(setting());
        results.finished.push(finished(1, 1));
        let mut other = results.clone();
        other.finished[0].failure = Some("another time".to_owned());
        other.finished.push(finished(2, 1));
        results.merge(other).unwrap();
        assert_eq!(results.finished.len(), 2);
        assert_eq!(results.finished[0].failure.as_deref(), Some("why"));
        let slower = Setting { frames_per_second: 25.0, ..setting() };
        let error = results.merge(Results::new(slower)).unwrap_err().to_string();
        assert_eq!(error, "these results are of another frame rate");
    }

    #[test]
    fn jobs_that_the_setting_has_no_trials_for_are_refused() {
        let mut results = Results::new(setting());
        assert_eq!(results.check(), Ok(()));
        for (held_out, training_trials) in [(0, 1), (3, 1), (1, 0), (1, 2)] {
            results.finished = vec![finished(held_out, training_trials)];
            let error = results.check().unwrap_err().to_string();
            assert!(error.starts_with("result 1: expected trials from 1 to 2"), "{error}");
        }
        results.version = 2;
        let error = results.check().unwrap_err().to_string();
        assert_eq!(error, "expected vcgpdm-evaluation version 1, found \"vcgpdm-evaluation\" version 2");
    }
}
