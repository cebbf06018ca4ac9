//! The results of completing: each part of every trial held out, inferred from the other parts.

use crate::evaluation::document_head::DocumentHead;
use crate::evaluation::{Setting, SettingError};
use serde::{Deserialize, Serialize};
use thiserror::Error;
use vcgpdm::models::VariationalSettings;

/// A method that infers a part from the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// The vCGPDM, which sees the frames until now.
    Filter,
    /// The vCGPDM, which sees all frames.
    Smoother,
    /// The same, with the start under which all frames are the likeliest, not the first half second.
    LikeliestSmoother,
    /// A vGPDM of the whole body, which sees the frames until now.
    WholeFilter,
    /// Ridge regression on the last frames.
    Ridge,
    /// Sparse Gaussian process regression on the last frames.
    GaussianProcess,
    /// The training frame whose history is nearest.
    Nearest,
}

impl Method {
    /// All methods, in the order of tables.
    pub const ALL: [Self; 7] = [
        Self::Filter,
        Self::Smoother,
        Self::LikeliestSmoother,
        Self::WholeFilter,
        Self::Ridge,
        Self::GaussianProcess,
        Self::Nearest,
    ];

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Filter => "vCGPDM, filter",
            Self::Smoother => "vCGPDM, smoother",
            Self::LikeliestSmoother => "vCGPDM, smoother, start chosen by all frames",
            Self::WholeFilter => "vGPDM, filter",
            Self::Ridge => "ridge regression",
            Self::GaussianProcess => "sparse Gaussian process regression",
            Self::Nearest => "nearest neighbour",
        }
    }
}

/// How well a method infers a part. Errors are squared errors, as shares of those of the mean pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MethodScore {
    /// The method.
    pub method: Method,
    /// The error of the columns.
    pub error: f64,
    /// The error of joint positions relative to the hips, the other parts being as recorded.
    pub joints: f64,
    /// The share of the numbers within the 95 % band, of columns that change in training.
    pub coverage: f64,
    /// The log density of these columns of a frame together, in nats; the mean over the frames.
    pub log_density: f64,
    /// The error of the columns when frames of the given parts are missing.
    pub gaps: f64,
    /// The error of the columns in the frames after the given parts are cut off; absent where the trial has
    /// no such frames.
    pub after_cut: Vec<Option<f64>>,
}

/// What limits the vCGPDM in this part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Limits {
    /// The error when all parts are observed: what the model cannot represent.
    pub all_observed: f64,
    /// The coverage when all parts are observed.
    pub all_observed_coverage: f64,
    /// The mean of squared error : predicted variance when all parts are observed.
    pub all_observed_squares: f64,
    /// The same mean of the filter.
    pub filter_squares: f64,
    /// The same mean of the smoother.
    pub smoother_squares: f64,
    /// The coverage of the smoother when beta is the noise variance of all columns.
    pub beta_coverage: f64,
    /// The log density of the smoother with beta alone.
    pub beta_log_density: f64,
    /// The share of the mean pose's error that the mean posture of the trial makes.
    pub posture: f64,
    /// The share of the filter's error that a constant offset of every column makes.
    pub offset: f64,
    /// The same share of ridge regression.
    pub ridge_offset: f64,
    /// The coverage of the smoother in every column that changes in training.
    pub columns: Vec<ColumnCoverage>,
    /// The first training trial, completed.
    pub training: TrainingTrial,
}

/// The coverage of one column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ColumnCoverage {
    /// Joint and kind of the column.
    pub column: String,
    /// The share of its numbers within the 95 % band.
    pub coverage: f64,
}

/// Errors of this part in a training trial, as multiples of the model's own reconstruction from the latents
/// that it learned.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TrainingTrial {
    /// All parts are observed.
    pub all_observed: f64,
    /// The other parts are observed.
    pub completed: f64,
    /// The other parts have the latents that they learned.
    pub given_latents: f64,
    /// All parts have these latents until the last frame; this part is predicted one frame ahead.
    pub one_frame: f64,
}

/// One part inferred from the others, in one trial.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CompletedPart {
    /// The score of each method.
    pub scores: Vec<MethodScore>,
    /// What limits the vCGPDM.
    pub limits: Limits,
}

/// All parts of a trial, each inferred from the others by models of the other trials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CompletedTrial {
    /// The trial held out, counted from 0; in files from 1.
    #[serde(with = "number_in_files")]
    pub held_out: usize,
    /// In the order of the setting's parts.
    pub parts: Vec<CompletedPart>,
}

/// Numbers that files count from 1.
mod number_in_files {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer>(number: &usize, serializer: S) -> Result<S::Ok, S::Error> {
        number.saturating_add(1).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<usize, D::Error> {
        let number = usize::deserialize(deserializer)?.checked_sub(1);
        number.ok_or_else(|| D::Error::custom("expected a trial from 1, found trial 0"))
    }
}

/// Why results of completing cannot be used.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CompletingError {
    /// Not JSON of the expected form.
    #[error("expected the results of completing: {0}")]
    Json(String),
    /// Another document.
    #[error(
        "expected results of \"evaluate --task complete\" ({} version {}), found {format:?} version {version}",
        Completing::FORMAT,
        VERSION
    )]
    Format {
        /// What the document calls itself.
        format: String,
        /// Its version.
        version: u32,
    },
    /// Trials that cannot be compared.
    #[error(transparent)]
    Setting(#[from] SettingError),
    /// Other trials, parts or settings.
    #[error("these results are of {0}")]
    Differs(String),
    /// A trial that does not exist, is there twice, or has other parts.
    #[error(
        "expected each of {trials} trials at most once, with {parts} parts, found trial {} otherwise",
        .found.saturating_add(1)
    )]
    Trial {
        /// Number of trials.
        trials: usize,
        /// Number of parts.
        parts: usize,
        /// The trial, counted from 0.
        found: usize,
    },
}

const VERSION: u32 = 1;

/// All completed trials of a person or of made trials.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Completing {
    format: String,
    version: u32,
    /// The trials, parts and frame rate. Its number of first frames has no meaning.
    pub setting: Setting,
    /// The settings of both variational models.
    pub settings: VariationalSettings,
    /// The seed of their trainings.
    pub seed: u32,
    /// The completed trials so far.
    pub trials: Vec<CompletedTrial>,
}

impl Completing {
    /// The field "format" of the document.
    pub const FORMAT: &'static str = "vcgpdm-completing";

    /// Results without a completed trial.
    pub fn new(setting: Setting, settings: VariationalSettings, seed: u32) -> Self {
        let (format, version) = (Self::FORMAT.to_owned(), VERSION);
        Self { format, version, setting, settings, seed, trials: Vec::new() }
    }

    /// Reads a document.
    ///
    /// # Errors
    /// The text is another document, or its trials do not fit its setting.
    pub fn from_json(text: &str) -> Result<Self, CompletingError> {
        let found: Self = serde_json::from_str(text).map_err(|error| match DocumentHead::read(text) {
            // Another document, or a later version, has other fields.
            Some(DocumentHead { format, version }) if format != Self::FORMAT || version != VERSION => {
                CompletingError::Format { format, version }
            }
            _ => CompletingError::Json(error.to_string()),
        })?;
        if found.format != Self::FORMAT || found.version != VERSION {
            return Err(CompletingError::Format { format: found.format, version: found.version });
        }
        found.setting.check()?;
        let (trials, parts) = (found.setting.trials.len(), found.setting.parts.len());
        for (k, trial) in found.trials.iter().enumerate() {
            let twice = found.trials[..k].iter().any(|earlier| earlier.held_out == trial.held_out);
            if twice || trial.held_out >= trials || trial.parts.len() != parts {
                return Err(CompletingError::Trial { trials, parts, found: trial.held_out });
            }
        }
        Ok(found)
    }

    /// The document.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string(self)
    }

    /// Takes the trials of earlier results.
    ///
    /// # Errors
    /// The earlier results are of other trials, parts, settings or of another seed.
    pub fn take(&mut self, earlier: Completing) -> Result<(), CompletingError> {
        let difference = self.setting.difference(&earlier.setting);
        let difference = difference.or_else(|| {
            let same = (&self.settings, self.seed) == (&earlier.settings, earlier.seed);
            (!same).then(|| "other settings of the models, or of another seed".to_owned())
        });
        if let Some(difference) = difference {
            return Err(CompletingError::Differs(difference));
        }
        self.trials = earlier.trials;
        Ok(())
    }

    /// Whether a trial is completed.
    pub fn has(&self, held_out: usize) -> bool {
        self.trials.iter().any(|trial| trial.held_out == held_out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::completing::tables;
    use crate::evaluation::testing::setting;

    fn results() -> Completing {
        Completing::new(setting(3), VariationalSettings::default(), 0)
    }

    fn part() -> CompletedPart {
        let score = |method| MethodScore {
            method,
            error: 0.5,
            joints: 0.25,
            coverage: 0.9,
            log_density: 7.0,
            gaps: 0.625,
            after_cut: vec![Some(0.5), None, None],
        };
        let training =
            TrainingTrial { all_observed: 1.0, completed: 3.0, given_latents: 2.0, one_frame: 1.5 };
        let column = |column: &str, coverage| ColumnCoverage { column: column.to_owned(), coverage };
        let limits = Limits {
            all_observed: 0.125,
            all_observed_coverage: 0.95,
            all_observed_squares: 1.0,
            filter_squares: 2.0,
            smoother_squares: 3.0,
            beta_coverage: 0.75,
            beta_log_density: 9.0,
            posture: 0.5,
            offset: 0.5,
            ridge_offset: 0.25,
            columns: vec![column("Hips pitch", 0.5), column("Neck turn", 0.25)],
            training,
        };
        CompletedPart { scores: Method::ALL.map(score).to_vec(), limits }
    }

    #[test]
    fn reads_what_it_writes_and_refuses_trials_that_do_not_fit() {
        let with = |held_out: &[usize]| {
            let trial = |&held_out: &usize| CompletedTrial { held_out, parts: vec![part()] };
            Completing { trials: held_out.iter().map(trial).collect(), ..results() }
        };
        let written = with(&[0, 2]);
        assert_eq!(Completing::from_json(&written.to_json().unwrap()), Ok(written.clone()));
        assert!(written.has(2) && !written.has(1));
        for held_out in [&[3][..], &[1, 1]] {
            let error = Completing::from_json(&with(held_out).to_json().unwrap()).unwrap_err().to_string();
            assert!(error.starts_with("expected each of 3 trials at most once, with 1 parts"), "{error}");
        }
        let later = Completing { version: 2, ..results() }.to_json().unwrap();
        let error = Completing::from_json(&later).unwrap_err().to_string();
        let expected =
            "expected results of \"evaluate --task complete\" (vcgpdm-completing version 1), found ";
        assert_eq!(error, format!("{expected}\"vcgpdm-completing\" version 2"));
        // A later version has fields of its own.
        let unknown = "{\"format\":\"vcgpdm-evaluation\",\"version\":9,\"x\":{}}";
        let error = Completing::from_json(unknown).unwrap_err().to_string();
        assert_eq!(error, format!("{expected}\"vcgpdm-evaluation\" version 9"));
        let mut other = Completing { seed: 1, ..results() };
        let error = other.take(written.clone()).unwrap_err().to_string();
        assert_eq!(error, "these results are of other settings of the models, or of another seed");
        let mut same = results();
        same.take(written.clone()).unwrap();
        assert_eq!(same, written);
    }

    #[test]
    fn tables_have_medians_over_the_trials() {
        let mut second = part();
        second.scores[0].error = 0.75;
        let trials = [part(), second].into_iter().enumerate();
        let trials = trials.map(|(held_out, part)| CompletedTrial { held_out, parts: vec![part] });
        let results = Completing { trials: trials.collect(), ..results() };
        let text = tables(&[("walks".to_owned(), &results)]);
        for line in [
            "| walks | lower | vCGPDM, filter | 0.62 | 0.25 | 90 | 7 | 0.62 | 0.50 |  |  |",
            "| walks | lower | 0.12 | 0.62 | 0.31 | 0.50 | 0.38 | 0.50 |",
            "| walks | lower | 95 | 90 | 1.0 | 2.0 | 3.0 | 75 | 7 | 9 | Neck turn 25, Hips pitch 50 |",
            "| walks | lower | 1.50 | 2.00 | 3.00 | 1.00 |",
        ] {
            assert!(text.contains(line), "{line}\n{text}");
        }
    }
}
