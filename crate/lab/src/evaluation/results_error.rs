//! Why results cannot be used, the check of each, and the head of a document.

use crate::evaluation::details::Details;
use crate::evaluation::job::Finished;
use crate::evaluation::setting::SettingError;
use serde::Deserialize;
use thiserror::Error;

/// The field "format" of a document of results.
pub(super) const FORMAT: &str = "vcgpdm-evaluation";
/// The version of the documents that this program writes.
pub(super) const VERSION: u32 = 1;

/// Why results cannot be used.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ResultsError {
    /// Not JSON of the expected form.
    #[error("expected the results of an evaluation: {0}")]
    Json(String),
    /// Another document.
    #[error(
        "expected results of \"vcgpdm evaluate\" ({} version {}), found {format:?} version {version}",
        FORMAT,
        VERSION
    )]
    Format {
        /// What the document calls itself.
        format: String,
        /// Its version.
        version: u32,
    },
    /// Trials that cannot be used for a comparison.
    #[error(transparent)]
    Setting(#[from] SettingError),
    /// A job for which the setting has no trials.
    #[error(
        "result {index}: expected trials from 1 to {trials} and at least one to train on, found trial {} held out of {training_trials} more",
        .held_out.saturating_add(1)
    )]
    Job {
        /// Which result, counted from 1.
        index: usize,
        /// Number of trials.
        trials: usize,
        /// The trial held out, counted from 0.
        held_out: usize,
        /// Trials trained on.
        training_trials: usize,
    },
    /// Results of another setting.
    #[error("these results are of {0}")]
    Differs(String),
    /// The same job twice.
    #[error("result {index}: expected each job once, found the job of result {before} again")]
    Repeated {
        /// Which result, counted from 1.
        index: usize,
        /// The earlier result, counted from 1.
        before: usize,
    },
    /// Neither an outcome nor a failure, or both.
    #[error("result {0}: expected an outcome or the reason of a failure, found both or neither")]
    Ending(usize),
    /// A bound or an objective that is not finite.
    #[error("result {index}: expected {what} that is finite, found {found}")]
    NotFinite {
        /// Which result, counted from 1.
        index: usize,
        /// Which number.
        what: &'static str,
        /// The value found.
        found: f64,
    },
    /// An error, a variance or a time that is not finite, negative, or so large that sums would not be finite.
    #[error("result {index}: expected {what} from 0 to 1e100, found {found:?}")]
    Number {
        /// Which result, counted from 1.
        index: usize,
        /// Which number.
        what: &'static str,
        /// The value found.
        found: f64,
    },
}

/// Checks the result number `index`, counted from 1, of a comparison on `trials` trials.
pub(super) fn check_finished(finished: &Finished, index: usize, trials: usize) -> Result<(), ResultsError> {
    let Finished { job, outcome, failure, .. } = finished;
    if !job.fits(trials) {
        let (held_out, training_trials) = (job.held_out, job.training_trials);
        return Err(ResultsError::Job { index, trials, held_out, training_trials });
    }
    if outcome.is_some() == failure.is_some() {
        return Err(ResultsError::Ending(index));
    }
    let Some(outcome) = outcome else { return Ok(()) };
    for (what, found) in [
        ("an error", outcome.score.dtw_mse),
        ("an error", outcome.score.mse),
        ("a variance", outcome.score.variance),
        ("a time", outcome.seconds),
    ]
    .into_iter()
    .chain(outcome.part_errors.iter().map(|error| ("the error of a part", *error)))
    .chain(outcome.training_mse.map(|error| ("the error of the trials trained on", error)))
    {
        if !(0.0..=1e100).contains(&found) {
            return Err(ResultsError::Number { index, what, found });
        }
    }
    let details = outcome.details.iter().flat_map(Details::numbers);
    for (what, found) in [
        ("a bound", outcome.bound),
        ("an objective", Some(outcome.objective)),
        ("a term of the bound", outcome.terms.as_ref().map(|terms| terms.total())),
    ]
    .into_iter()
    .chain(details.map(|number| ("a detail of the prediction", Some(number))))
    {
        if let Some(found) = found.filter(|found| !found.is_finite()) {
            return Err(ResultsError::NotFinite { index, what, found });
        }
    }
    Ok(())
}

vcgpdm_core::coded!(ResultsError => Results);

/// The format and version of a document.
#[derive(Deserialize)]
pub(crate) struct DocumentHead {
    pub(crate) format: String,
    pub(crate) version: u32,
}

impl DocumentHead {
    /// Reads the head of a document, whose other fields may be of any kind.
    pub(crate) fn read(text: &str) -> Option<Self> {
        serde_json::from_str(text).ok()
    }
}
