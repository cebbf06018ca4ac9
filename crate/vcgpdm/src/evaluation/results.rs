//! What an evaluation keeps: what was compared, and what came of it, job by job. The same in a file and on the page. No I/O.

use crate::evaluation::cross_validation::{Outcome, START_FRAMES};
use crate::models::ModelSettings;
use crate::motion::Clip;
use crate::motion::parts::PartSpec;
use serde::{Deserialize, Serialize};
use thiserror::Error;

const FORMAT: &str = "vcgpdm-evaluation";
const VERSION: u32 = 1;

/// A trial, by its content.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trial {
    /// The clip's name.
    pub name: String,
    /// SHA-256 of the clip's file, hexadecimal.
    pub sha256: String,
    /// The frames of the clip that were used, from the first up to but not including the end; absent: all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub piece: Option<(usize, usize)>,
}

impl Trial {
    /// Whether it is the same motion, whatever it is called.
    fn is(&self, other: &Trial) -> bool {
        (&self.sha256, self.piece) == (&other.sha256, other.piece)
    }

    fn frames(&self) -> String {
        self.piece.map_or("the whole".to_owned(), |(first, end)| format!("frames {first} to {end}"))
    }
}

/// A group of joints.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ResultsPart {
    /// What it is called.
    pub name: String,
    /// Its joints, by their place in the skeleton.
    pub joints: Vec<usize>,
}

/// What all results of a file have in common.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
        let trial =
            |clip: &Clip| Trial { name: clip.name.clone(), sha256: clip.sha256.clone(), piece: clip.piece };
        let part = |part: &PartSpec| ResultsPart { name: part.name.clone(), joints: part.joints.clone() };
        Self {
            trials: clips.iter().map(trial).collect(),
            parts: parts.iter().map(part).collect(),
            frames_per_second,
            start_frames: START_FRAMES,
        }
    }

    /// In what the other is not of the same; absent when results of both go together. What trials and parts are called does
    /// not count.
    fn difference(&self, other: &Setting) -> Option<String> {
        let (trials, parts) = (&self.trials, &self.parts);
        if other.trials.len() != trials.len() {
            return Some(format!("other trials: expected {}, found {}", trials.len(), other.trials.len()));
        }
        if let Some(k) = (0..trials.len()).find(|&k| !trials[k].is(&other.trials[k])) {
            let (number, expected, found) = (k + 1, &trials[k], &other.trials[k]);
            return Some(if expected.sha256 == found.sha256 {
                let (a, b) = (expected.frames(), found.frames());
                format!("other trials: expected {a} of {} as trial {number}, found {b}", expected.name)
            } else {
                let same_name = expected.name == found.name;
                let b = if same_name { "another file of that name" } else { &found.name };
                format!("other trials: expected {} as trial {number}, found {b}", expected.name)
            });
        }
        if other.parts.len() != parts.len() {
            return Some(format!("other parts: expected {}, found {}", parts.len(), other.parts.len()));
        }
        if let Some((part, _)) = parts.iter().zip(&other.parts).find(|(a, b)| a.joints != b.joints) {
            return Some(format!("other parts: {} has other joints", part.name));
        }
        let (a, b) = (self.frames_per_second, other.frames_per_second);
        if a != b {
            return Some(format!("another frame rate: expected {a} frames a second, found {b}"));
        }
        let (a, b) = (self.start_frames, other.start_frames);
        (a != b).then(|| format!("predictions from another number of first frames: expected {a}, found {b}"))
    }

    /// Two trials that are the same motion: whichever is held out, the other would be trained on. Counted from 1.
    fn twice(&self) -> Option<(usize, usize)> {
        let trials = &self.trials;
        let later = |k: usize| (k + 1..trials.len()).find(|other| trials[k].is(&trials[*other]));
        (0..trials.len()).find_map(|k| later(k).map(|other| (k + 1, other + 1)))
    }

    /// Whether models can be compared so.
    pub fn check(&self) -> Result<(), ResultsError> {
        if self.trials.len() < 2 {
            return Err(ResultsError::Trials(self.trials.len()));
        }
        if let Some((first, second)) = self.twice() {
            let name = self.trials[first - 1].name.clone();
            return Err(ResultsError::Twice { name, first, second });
        }
        if !self.frames_per_second.is_finite() || self.frames_per_second <= 0.0 {
            return Err(ResultsError::Rate(self.frames_per_second));
        }
        Ok(())
    }
}

/// One model in one fold with one seed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// The model and its settings.
    pub candidate: ModelSettings,
    /// The trial held out, counted from 1.
    pub held_out: usize,
    /// How many of the others are trained on.
    pub training_trials: usize,
    /// The seed of everything random.
    pub seed: u32,
}

/// What came of a job: an outcome, or why there is none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
#[derive(Debug, Error, PartialEq)]
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
    Differs(String),
    /// Too few trials to hold one out.
    #[error("expected at least two trials, found {0}")]
    Trials(usize),
    /// The same motion twice.
    #[error(
        "trials {first} and {second} are the same motion ({name}): the one held out would be trained on; leave one out"
    )]
    Twice {
        /// What the first is called.
        name: String,
        /// Counted from 1.
        first: usize,
        /// Counted from 1.
        second: usize,
    },
    /// No rate.
    #[error("expected a positive number of frames a second, found {0}")]
    Rate(f64),
    /// The same job twice.
    #[error("result {index}: the same training stands there twice, found before as result {before}")]
    Repeated {
        /// Which result, counted from 1.
        index: usize,
        /// Where it was before.
        before: usize,
    },
    /// Neither an outcome nor a failure, or both.
    #[error("result {0}: expected an outcome or the reason why there is none, found both or neither")]
    Ending(usize),
    /// A bound or an objective that went astray.
    #[error("result {index}: expected {what} that is finite, found {found}")]
    NotFinite {
        /// Which result, counted from 1.
        index: usize,
        /// Which number.
        what: &'static str,
        /// What stands there.
        found: f64,
    },
    /// A number that none can be.
    #[error("result {index}: expected {what} that is finite and not negative, found {found}")]
    Number {
        /// Which result, counted from 1.
        index: usize,
        /// Which number.
        what: &'static str,
        /// What stands there.
        found: f64,
    },
}

/// All of an evaluation so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
        self.setting.check()?;
        let trials = self.setting.trials.len();
        for (k, Finished { job, outcome, failure, .. }) in self.finished.iter().enumerate() {
            let index = k + 1;
            let (held_out, training_trials) = (job.held_out, job.training_trials);
            if !(1..=trials).contains(&held_out) || !(1..trials).contains(&training_trials) {
                return Err(ResultsError::Job { index, trials, held_out, training_trials });
            }
            if let Some(before) = self.finished[..k].iter().position(|other| other.job == *job) {
                return Err(ResultsError::Repeated { index, before: before + 1 });
            }
            if outcome.is_some() == failure.is_some() {
                return Err(ResultsError::Ending(index));
            }
            let Some(outcome) = outcome else { continue };
            for (what, found) in [
                ("an error", outcome.score.dtw_mse),
                ("an error", outcome.score.mse),
                ("a variance", outcome.score.variance),
                ("a time", outcome.seconds),
            ] {
                if !found.is_finite() || found < 0.0 {
                    return Err(ResultsError::Number { index, what, found });
                }
            }
            for (what, found) in [("a bound", outcome.bound), ("an objective", Some(outcome.objective))] {
                if let Some(found) = found.filter(|found| !found.is_finite()) {
                    return Err(ResultsError::NotFinite { index, what, found });
                }
            }
        }
        Ok(())
    }

    /// What is known of a job: its outcome, or why it failed when it was last tried.
    pub fn find(&self, job: &Job) -> Option<&Finished> {
        self.finished.iter().find(|finished| finished.job == *job)
    }

    /// Whether there is nothing left to do for a job: a failure may be tried again.
    pub fn has_outcome(&self, job: &Job) -> bool {
        self.find(job).is_some_and(|finished| finished.outcome.is_some())
    }

    /// Takes over what the other knows and this one does not; both must be of the same setting.
    pub fn merge(&mut self, other: Results) -> Result<(), ResultsError> {
        if let Some(difference) = self.setting.difference(&other.setting) {
            return Err(ResultsError::Differs(difference));
        }
        for finished in other.finished {
            if self
                .find(&finished.job)
                .is_none_or(|known| known.outcome.is_none() && finished.outcome.is_some())
            {
                self.add(finished);
            }
        }
        Ok(())
    }

    /// Keeps what came of a job, in place of what is known of the same job; only an outcome stays what it is.
    pub fn add(&mut self, finished: Finished) {
        match self.finished.iter_mut().find(|known| known.job == finished.job) {
            Some(known) if known.outcome.is_none() => *known = finished,
            Some(_) => {}
            None => self.finished.push(finished),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::dtw::Score;
    use crate::models::TmpSettings;

    fn setting() -> Setting {
        let trial =
            |name: &str| Trial { name: name.to_owned(), sha256: format!("sha of {name}"), piece: None };
        Setting {
            trials: vec![trial("a"), trial("b")],
            parts: vec![ResultsPart { name: "lower".to_owned(), joints: vec![0, 1] }],
            frames_per_second: 30.0,
            start_frames: START_FRAMES,
        }
    }

    fn finished(held_out: usize, training_trials: usize) -> Finished {
        let job = Job {
            candidate: ModelSettings::Tmp(TmpSettings { primitives: None }),
            held_out,
            training_trials,
            seed: 0,
        };
        Finished { job, engine: String::new(), outcome: None, failure: Some("why".to_owned()) }
    }

    fn outcome(dtw_mse: f64) -> Outcome {
        Outcome {
            score: Score { dtw_mse, mse: dtw_mse, variance: 0.05 },
            bound: Some(-10.0),
            objective: -10.0,
            iterations: 10,
            seconds: 1.0,
            frames: 100,
            stored_numbers: 700,
            reason: None,
        }
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
    }

    #[test]
    fn a_failure_is_replaced_and_an_outcome_stays() {
        let mut results = Results::new(setting());
        let of = |mse: f64| Finished { outcome: Some(outcome(mse)), failure: None, ..finished(1, 1) };
        results.add(finished(1, 1));
        assert!(!results.has_outcome(&finished(1, 1).job));
        results.add(of(0.5));
        assert_eq!(results.finished, [of(0.5)]);
        assert!(results.has_outcome(&finished(1, 1).job));
        for later in [of(0.7), finished(1, 1)] {
            results.add(later);
            assert_eq!(results.finished, [of(0.5)]);
        }
        // What failed here has an outcome in the other file.
        let mut failed = Results::new(setting());
        failed.add(finished(1, 1));
        failed.merge(results).unwrap();
        assert_eq!(failed.finished, [of(0.5)]);
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
        results.finished = vec![finished(1, 1), finished(2, 1), finished(1, 1)];
        let error = results.check().unwrap_err().to_string();
        assert_eq!(error, "result 3: the same training stands there twice, found before as result 1");
        results.finished[1].failure = None;
        assert_eq!(results.check(), Err(ResultsError::Ending(2)));
        results.version = 2;
        let error = results.check().unwrap_err().to_string();
        assert_eq!(error, "expected vcgpdm-evaluation version 1, found \"vcgpdm-evaluation\" version 2");
    }

    #[test]
    fn numbers_that_are_none_are_refused() {
        let refused = |change: &dyn Fn(&mut Outcome)| {
            let mut odd = outcome(0.5);
            change(&mut odd);
            let mut results = Results::new(setting());
            results.add(Finished { outcome: Some(odd), failure: None, ..finished(1, 1) });
            results.check().map_err(|error| error.to_string())
        };
        assert_eq!(refused(&|_| {}), Ok(()));
        for (change, words) in [
            (&(|o: &mut Outcome| o.seconds = -1.0) as &dyn Fn(&mut Outcome), "a time"),
            (&|o| o.score.variance = f64::NAN, "a variance"),
            (&|o| o.score.dtw_mse = f64::INFINITY, "an error"),
            (&|o| o.score.mse = -0.1, "an error"),
            (&|o| o.bound = Some(f64::NAN), "a bound"),
            (&|o| o.objective = f64::NEG_INFINITY, "an objective"),
        ] {
            let error = refused(change).unwrap_err();
            assert!(error.starts_with(&format!("result 1: expected {words} that is finite")), "{error}");
        }
    }

    #[test]
    fn trials_are_what_they_are_not_what_they_are_called() {
        let mut results = Results::new(setting());
        let mut merge = |change: &dyn Fn(&mut Setting)| {
            let mut other = setting();
            change(&mut other);
            results.merge(Results::new(other)).map_err(|error| error.to_string())
        };
        // A page calls a clip by its title, the terminal by its file.
        assert_eq!(merge(&|other| other.trials[0].name = "a.bvh".to_owned()), Ok(()));
        assert_eq!(merge(&|other| other.parts[0].name = "legs".to_owned()), Ok(()));
        let mut refused = |change: &dyn Fn(&mut Setting), why: &str| {
            assert_eq!(merge(change), Err(format!("these results are of {why}")));
        };
        refused(
            &|other| other.trials[1].sha256 = "sha of c".to_owned(),
            "other trials: expected b as trial 2, found another file of that name",
        );
        refused(&|other| other.trials.truncate(1), "other trials: expected 2, found 1");
        refused(
            &|other| other.trials[0].piece = Some((0, 60)),
            "other trials: expected the whole of a as trial 1, found frames 0 to 60",
        );
        refused(&|other| other.parts.clear(), "other parts: expected 1, found 0");
        refused(&|other| other.parts[0].joints = vec![0], "other parts: lower has other joints");
        refused(
            &|other| other.frames_per_second = 25.0,
            "another frame rate: expected 30 frames a second, found 25",
        );
        refused(
            &|other| other.start_frames = 3,
            "predictions from another number of first frames: expected 5, found 3",
        );
        let text = serde_json::to_string(&setting()).unwrap();
        assert!(!text.contains("piece"), "as in files before there were pieces: {text}");
    }

    #[test]
    fn a_trial_cannot_be_held_out_and_trained_on() {
        let mut twice = setting();
        twice.trials.push(Trial { name: "again".to_owned(), ..twice.trials[1].clone() });
        let error = twice.check().unwrap_err().to_string();
        assert!(error.starts_with("trials 2 and 3 are the same motion (b)"), "{error}");
        // Another piece of the same clip is another trial.
        twice.trials[2].piece = Some((10, 20));
        assert_eq!(twice.check(), Ok(()));
        twice.trials.truncate(1);
        assert_eq!(twice.check(), Err(ResultsError::Trials(1)));
    }
}
