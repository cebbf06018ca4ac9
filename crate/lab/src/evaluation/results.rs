//! The results of a comparison: its setting, and the outcome of each job. Files and the page have the same
//! document. No I/O.

use crate::evaluation::candidate::Candidate;
use crate::evaluation::candidate_text::size_numbers;
use crate::evaluation::job::{Finished, Job};
use crate::evaluation::outcome::{Difference, Outcome};
use crate::evaluation::plan::{ComparisonPlanError, Plan};
use crate::evaluation::results_error::{DocumentHead, FORMAT, ResultsError, VERSION, check_finished};
use crate::evaluation::setting::Setting;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

/// A job of a plan.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PlannedJob {
    /// The job.
    #[cfg_attr(feature = "types", ts(skip))]
    pub job: Job,
    /// Whether the results contain an outcome of the job.
    pub done: bool,
}

/// A job of which two files hold different outcomes.
#[derive(Clone, Debug, PartialEq)]
pub struct Disagreement {
    /// The job.
    pub job: Job,
    /// A number in which the outcomes differ.
    pub difference: Difference,
}

/// All results of a comparison so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Results {
    format: String,
    version: u32,
    setting: Setting,
    finished: Vec<Finished>,
}

impl Results {
    /// The field "format" of a document of results.
    pub const FORMAT: &'static str = FORMAT;

    /// Results without a finished job.
    pub fn new(setting: Setting) -> Self {
        Self { format: Self::FORMAT.to_owned(), version: VERSION, setting, finished: Vec::new() }
    }

    /// Reads a document.
    ///
    /// # Errors
    /// The text is another document, or its results do not fit its setting.
    pub fn from_json(text: &str) -> Result<Self, ResultsError> {
        let results: Self = serde_json::from_str(text).map_err(|error| match DocumentHead::read(text) {
            // Another document, or a later version, has other fields.
            Some(DocumentHead { format, version }) if format != FORMAT || version != VERSION => {
                ResultsError::Format { format, version }
            }
            _ => ResultsError::Json(error.to_string()),
        })?;
        results.check()?;
        Ok(results)
    }

    /// The document.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn to_json(&self) -> Result<String, ResultsError> {
        serde_json::to_string(self).map_err(|error| ResultsError::Json(error.to_string()))
    }

    /// Makes the checks of [`Results::from_json`], for documents that another parser has read.
    ///
    /// # Errors
    /// The document is another one, or its results do not fit its setting.
    pub fn check(&self) -> Result<(), ResultsError> {
        if self.format != Self::FORMAT || self.version != VERSION {
            return Err(ResultsError::Format { format: self.format.clone(), version: self.version });
        }
        self.setting.check()?;
        let mut indices = HashMap::new();
        for (k, finished) in self.finished.iter().enumerate() {
            check_finished(finished, k + 1, self.setting.trials.len())?;
            if let Some(before) = indices.insert(&finished.job, k) {
                return Err(ResultsError::Repeated { index: k + 1, before: before + 1 });
            }
        }
        Ok(())
    }

    /// The trials, parts and frames of the comparison.
    pub fn setting(&self) -> &Setting {
        &self.setting
    }

    /// The finished jobs, in the order in which they were added.
    pub fn finished(&self) -> &[Finished] {
        &self.finished
    }

    /// The finished jobs in the order of tables: by model, then by size, then by seed.
    pub fn in_order(&self) -> Vec<&Finished> {
        let mut finished: Vec<&Finished> = self.finished.iter().collect();
        finished.sort_by_key(|Finished { job, .. }| {
            (job.candidate.kind().place(), size_numbers(&job.candidate), job.seed)
        });
        finished
    }

    /// The jobs of a plan on these trials, and which of them are done. A failed job is not done: it may be
    /// tried again.
    ///
    /// # Errors
    /// The plan has trials that do not exist.
    pub fn jobs(&self, plan: &Plan) -> Result<Vec<PlannedJob>, ComparisonPlanError> {
        let jobs = plan.jobs(self.setting.trials.len())?.into_iter();
        Ok(jobs.map(|job| PlannedJob { done: self.has_outcome(&job), job }).collect())
    }

    /// The results of the candidates that all `others` have too.
    pub fn in_common(&self, others: &[&Results]) -> Self {
        let has = |results: &Results, candidate: &Candidate| {
            results.finished.iter().any(|f| f.job.candidate == *candidate)
        };
        let in_all = |f: &&Finished| others.iter().all(|other| has(other, &f.job.candidate));
        Self {
            finished: self.finished.iter().filter(in_all).cloned().collect(),
            format: self.format.clone(),
            setting: self.setting.clone(),
            ..*self
        }
    }

    fn find(&self, job: &Job) -> Option<&Finished> {
        self.finished.iter().find(|finished| finished.job == *job)
    }

    /// Whether a job has an outcome. A failed job has none: it may be tried again.
    pub fn has_outcome(&self, job: &Job) -> bool {
        self.find(job).is_some_and(|finished| finished.outcome.is_some())
    }

    /// The outcome of a job.
    pub fn outcome(&self, job: &Job) -> Option<&Outcome> {
        self.find(job)?.outcome.as_ref()
    }

    /// Whether both are of the same trials, parts, frame rate and number of first frames.
    pub fn has_same_setting(&self, other: &Results) -> bool {
        self.setting.difference(&other.setting).is_none()
    }

    /// The first job of which both hold an outcome, with different numbers.
    pub fn disagreement(&self, other: &Results) -> Option<Disagreement> {
        let outcomes = self.finished.iter().filter_map(|f| Some((&f.job, f.outcome.as_ref()?)));
        let outcomes: HashMap<_, _> = outcomes.collect();
        other.finished.iter().find_map(|finished| {
            let first = outcomes.get(&finished.job)?;
            let difference = first.difference(finished.outcome.as_ref()?)?;
            Some(Disagreement { job: finished.job.clone(), difference })
        })
    }

    /// Adds the results of the other that this one does not have. An outcome replaces a failure; of two
    /// outcomes of a job, this one's stays.
    ///
    /// # Errors
    /// The other is of another setting.
    pub fn merge(&mut self, other: Results) -> Result<(), ResultsError> {
        if let Some(difference) = self.setting.difference(&other.setting) {
            return Err(ResultsError::Differs(difference));
        }
        let jobs = self.finished.iter().enumerate().map(|(index, finished)| (finished.job.clone(), index));
        let indices: HashMap<Job, usize> = jobs.collect();
        for finished in other.finished {
            match indices.get(&finished.job).map(|index| &mut self.finished[*index]) {
                None => self.finished.push(finished),
                Some(earlier) => earlier.complete_with(finished),
            }
        }
        Ok(())
    }

    /// Adds a finished job. A later result replaces a failure, but never an outcome.
    ///
    /// # Errors
    /// The job does not fit the setting, or its outcome has an impossible number.
    pub fn add(&mut self, finished: Finished) -> Result<(), ResultsError> {
        check_finished(&finished, self.finished.len() + 1, self.setting.trials.len())?;
        match self.finished.iter_mut().find(|earlier| earlier.job == finished.job) {
            Some(earlier) => earlier.complete_with(finished),
            None => self.finished.push(finished),
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::candidate::Candidate;
    use crate::evaluation::setting::SettingError;
    use crate::evaluation::testing::{outcome, setting, variational};
    use std::collections::HashSet;
    use vcgpdm_core::models::{DmpSettings, ModelKind, Settings, TmpSettings};

    fn job(held_out: usize, training_trials: usize) -> Job {
        let candidate = Settings::Tmp(TmpSettings::default()).into();
        Job { candidate, held_out, training_trials, seed: 0 }
    }

    fn failed(held_out: usize, training_trials: usize) -> Finished {
        Finished::new(job(held_out, training_trials), Err("why".to_owned()))
    }

    fn done(mse: f64) -> Finished {
        Finished::new(job(0, 1), Ok(outcome(mse, Some(-10.0), 100, 1.0)))
    }

    /// Reads a document with these results.
    fn read(finished: Vec<Finished>) -> Result<Results, ResultsError> {
        let results = Results { finished, ..Results::new(setting(2)) };
        Results::from_json(&results.to_json().unwrap())
    }

    #[test]
    fn keeps_the_first_failure_of_a_job_when_files_are_merged() {
        let mut results = Results::new(setting(2));
        results.add(failed(0, 1)).unwrap();
        let mut other = results.clone();
        other.finished[0].failure = Some("another time".to_owned());
        other.add(failed(1, 1)).unwrap();
        results.merge(other).unwrap();
        assert_eq!(results.finished, [failed(0, 1), failed(1, 1)]);
        let error = results.merge(Results::new(setting(3))).unwrap_err().to_string();
        assert_eq!(error, "these results are of other trials: expected 2, found 3");
    }

    #[test]
    fn writes_a_file_of_an_earlier_version_with_the_same_bytes() {
        let file = include_str!("../../../../docs/comparison/walk-made.json").trim_end();
        let results = Results::from_json(file).unwrap();
        let trials: HashSet<usize> = results.finished().iter().map(|f| f.job.held_out).collect();
        assert_eq!(trials, HashSet::from_iter(0..6));
        assert!(results.to_json().unwrap() == file);
    }

    #[test]
    fn reads_a_file_with_an_observed_start() {
        let results = Results { finished: vec![done(0.5)], ..Results::new(setting(2)) };
        let text = results.to_json().unwrap();
        let start = r#","observed_start":{"dtw_mse":0.1,"seconds":0.2}"#;
        let earlier = text.replacen(r#"},"failure""#, &format!(r#"{start}}},"failure""#), 1);
        assert_ne!(earlier, text);
        assert!(Results::from_json(&earlier).unwrap() == results);
    }

    /// A hundred thousand results once took minutes to read and to merge.
    #[test]
    fn reads_and_merges_many_results_in_linear_time() {
        let many: Vec<Finished> =
            (0..30_000).map(|seed| Finished::new(Job { seed, ..job(0, 1) }, Err("why".to_owned()))).collect();
        let mut results = read(many.clone()).unwrap();
        results.merge(read(many.clone()).unwrap()).unwrap();
        assert_eq!(results.finished.len(), many.len());
        let twice = [many, vec![failed(0, 1)]].concat();
        assert_eq!(read(twice), Err(ResultsError::Repeated { index: 30_001, before: 1 }));
    }

    #[test]
    fn replaces_a_failure_but_never_an_outcome() {
        let mut results = Results::new(setting(2));
        results.add(failed(0, 1)).unwrap();
        assert!(!results.has_outcome(&job(0, 1)));
        results.add(done(0.5)).unwrap();
        assert_eq!(results.finished, [done(0.5)]);
        assert!(results.has_outcome(&job(0, 1)));
        for later in [done(0.7), failed(0, 1)] {
            results.add(later).unwrap();
            assert_eq!(results.finished, [done(0.5)]);
        }
        // What failed here has an outcome in the other file.
        let mut other = Results::new(setting(2));
        other.add(failed(0, 1)).unwrap();
        other.merge(results).unwrap();
        assert_eq!(other.finished, [done(0.5)]);
    }

    /// Once the outcome of the first file was kept, and nobody noticed that the second held another.
    #[test]
    fn finds_the_job_about_which_two_files_disagree() {
        let with = |change: &dyn Fn(&mut Outcome)| {
            let mut finished = done(0.5);
            finished.outcome.iter_mut().for_each(change);
            Results { finished: vec![failed(1, 1), finished], ..Results::new(setting(2)) }
        };
        let first = with(&|_| {});
        let found = |change: &dyn Fn(&mut Outcome)| {
            let found = first.disagreement(&with(change))?;
            assert_eq!(found.job, job(0, 1));
            Some((found.difference.name, found.difference.first, found.difference.second))
        };
        assert_eq!(found(&|outcome| outcome.score.dtw_mse = 0.25), Some(("DTW MSE", 0.5, 0.25)));
        assert_eq!(found(&|outcome| outcome.bound = Some(-11.0)), Some(("bound", -10.0, -11.0)));
        // Time, another ending of the same numbers, rounding, and numbers that earlier versions did not
        // write.
        let seconds = |outcome: &mut Outcome| {
            outcome.seconds = 9.0;
            outcome.reason = Some("stopped".to_owned());
            outcome.score.dtw_mse *= 1.0 + 1e-9;
            outcome.training_mse = None;
            outcome.part_errors.clear();
        };
        assert_eq!(found(&seconds), None);
        assert_eq!(first.disagreement(&Results::new(setting(2))), None);
    }

    #[test]
    fn counts_only_jobs_with_an_outcome_as_done() {
        let mut results = Results::new(setting(2));
        results.add(done(0.5)).unwrap();
        results.add(failed(1, 1)).unwrap();
        let plan = Plan { models: vec![ModelKind::Tmp.into()], ..Plan::default() };
        let planned = results.jobs(&plan).unwrap();
        assert_eq!(planned[0], PlannedJob { job: job(0, 1), done: true });
        assert_eq!(planned[1], PlannedJob { job: job(1, 1), done: false });
    }

    #[test]
    fn orders_jobs_by_model_then_size_then_seed() {
        let mut results = Results::new(setting(2));
        let dmp = |bases: usize| Candidate::from(Settings::DmpRhythmic(DmpSettings { bases }));
        let vgpdm = |ips: usize| Settings::Vgpdm(variational(ips)).into();
        let jobs = [(dmp(20), 0), (dmp(10), 0), (vgpdm(12), 1), (vgpdm(12), 0), (vgpdm(8), 5)];
        for (candidate, seed) in jobs.clone() {
            let job = Job { candidate, seed, ..job(0, 1) };
            results.add(Finished::new(job, Err("why".to_owned()))).unwrap();
        }
        let found: Vec<_> =
            results.in_order().iter().map(|f| (f.job.candidate.clone(), f.job.seed)).collect();
        let [dmp_20, dmp_10, vgpdm_12_1, vgpdm_12_0, vgpdm_8] = jobs;
        assert_eq!(found, [vgpdm_8, vgpdm_12_0, vgpdm_12_1, dmp_10, dmp_20]);
    }

    #[test]
    fn jobs_that_the_setting_has_no_trials_for_are_refused() {
        assert_eq!(read(vec![]), Ok(Results::new(setting(2))));
        for (held_out, training_trials) in [(2, 1), (0, 0), (0, 2)] {
            let error = read(vec![failed(held_out, training_trials)]).unwrap_err();
            assert!(error.to_string().starts_with("result 1: expected trials from 1 to 2"), "{error}");
            assert_eq!(Results::new(setting(2)).add(failed(held_out, training_trials)), Err(error));
        }
        let error = read(vec![failed(0, 1), failed(1, 1), failed(0, 1)]).unwrap_err().to_string();
        assert_eq!(error, "result 3: expected each job once, found the job of result 1 again");
        let neither = Finished { failure: None, ..failed(1, 1) };
        assert_eq!(read(vec![failed(0, 1), neither]), Err(ResultsError::Ending(2)));
    }

    #[test]
    fn other_documents_are_refused() {
        let later = Results { version: 2, ..Results::new(setting(2)) };
        let error = Results::from_json(&later.to_json().unwrap()).unwrap_err().to_string();
        let expected = "expected results of \"vcgpdm evaluate\" (vcgpdm-evaluation version 1), found ";
        assert_eq!(error, format!("{expected}\"vcgpdm-evaluation\" version 2"));
        let unknown = "{\"format\":\"vcgpdm-completing\",\"version\":1,\"settings\":{}}";
        let error = Results::from_json(unknown).unwrap_err().to_string();
        assert_eq!(error, format!("{expected}\"vcgpdm-completing\" version 1"));
        let error = Results::from_json("{}").unwrap_err().to_string();
        assert!(
            error.starts_with("expected the results of an evaluation: missing field `format`"),
            "{error}"
        );
        let alone = Results::new(setting(1)).to_json().unwrap();
        assert_eq!(Results::from_json(&alone), Err(ResultsError::Setting(SettingError::Trials(1))));
    }

    #[test]
    fn outcomes_that_cannot_be_are_refused() {
        let refused = |change: &dyn Fn(&mut Outcome)| {
            let mut outcome = outcome(0.5, Some(-10.0), 100, 1.0);
            change(&mut outcome);
            Results::new(setting(2)).add(Finished::new(job(0, 1), Ok(outcome)))
        };
        assert_eq!(refused(&|_| {}), Ok(()));
        for (change, words) in [
            (&(|o: &mut Outcome| o.seconds = -1.0) as &dyn Fn(&mut Outcome), "a time from 0 to 1e100"),
            (&|o| o.score.variance = f64::NAN, "a variance from"),
            (&|o| o.score.dtw_mse = 1e308, "an error from"),
            (&|o| o.score.mse = -0.1, "an error from"),
            (&|o| o.bound = Some(f64::NAN), "a bound that is finite"),
            (&|o| o.objective = f64::NEG_INFINITY, "an objective that is finite"),
        ] {
            let error = refused(change).unwrap_err().to_string();
            assert!(error.starts_with(&format!("result 1: expected {words}")), "{error}");
        }
    }
}
