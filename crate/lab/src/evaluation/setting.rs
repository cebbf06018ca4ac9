//! The setting of a comparison: its trials, parts and frame rate.

use serde::{Deserialize, Serialize};
use thiserror::Error;
use vcgpdm_core::motion::Clip;
use vcgpdm_core::motion::parts::PartSpec;

/// A trial, identified by the hash of its file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase", rename = "Trial"))]
pub struct TrialClip {
    /// The clip's name.
    pub name: String,
    /// SHA-256 of the clip's file, hexadecimal.
    pub sha256: String,
    /// The used frames of the clip, from the first up to but not including the end; null: all frames.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional = false))]
    pub piece: Option<(usize, usize)>,
}

impl TrialClip {
    /// Whether both are the same motion; the names do not count.
    fn is_same_motion(&self, other: &TrialClip) -> bool {
        (&self.sha256, self.piece) == (&other.sha256, other.piece)
    }

    fn frames(&self) -> String {
        self.piece.map_or("the whole".to_owned(), |(first, end)| format!("frames {first} to {end}"))
    }
}

/// Why trials cannot be used for a comparison.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SettingError {
    /// Too few trials to hold one out.
    #[error("expected at least two trials, found {0}")]
    Trials(usize),
    /// The same motion twice.
    #[error(
        "trials {} and {} are the same motion ({name}): the one held out would be trained on; leave one out",
        .first + 1, .second + 1
    )]
    Twice {
        /// The name of the first.
        name: String,
        /// Counted from 0.
        first: usize,
        /// Counted from 0.
        second: usize,
    },
    /// No frame rate.
    #[error("expected a positive number of frames a second, found {0}")]
    Rate(f64),
}

/// The setting that all results of a comparison share.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Setting {
    /// The trials; each is held out in turn.
    pub trials: Vec<TrialClip>,
    /// How the coupled models split the body.
    pub parts: Vec<PartSpec>,
    /// The clips were resampled to about this rate.
    pub frames_per_second: f64,
    /// Number of frames of the held-out trial that a prediction starts from.
    pub start_frames: usize,
}

impl Setting {
    /// The setting with these clips as trials.
    ///
    /// # Errors
    /// There are fewer than two trials, two of them are the same motion, or the rate is not positive.
    pub fn new(
        clips: &[Clip],
        parts: &[PartSpec],
        frames_per_second: f64,
        start_frames: usize,
    ) -> Result<Self, SettingError> {
        let trial = |clip: &Clip| TrialClip {
            name: clip.name.clone(),
            sha256: clip.sha256.clone(),
            piece: clip.piece,
        };
        let setting = Self {
            trials: clips.iter().map(trial).collect(),
            parts: parts.to_vec(),
            frames_per_second,
            start_frames,
        };
        setting.check()?;
        Ok(setting)
    }

    /// Makes the checks of [`Setting::new`].
    pub(crate) fn check(&self) -> Result<(), SettingError> {
        if self.trials.len() < 2 {
            return Err(SettingError::Trials(self.trials.len()));
        }
        if let Some((first, second)) = self.same_motions() {
            let name = self.trials[first].name.clone();
            return Err(SettingError::Twice { name, first, second });
        }
        if !self.frames_per_second.is_finite() || self.frames_per_second <= 0.0 {
            return Err(SettingError::Rate(self.frames_per_second));
        }
        Ok(())
    }

    /// Two trials that are the same motion. If one were held out, the other would be trained on.
    fn same_motions(&self) -> Option<(usize, usize)> {
        let trials = &self.trials;
        let later = |k: usize| (k + 1..trials.len()).find(|other| trials[k].is_same_motion(&trials[*other]));
        (0..trials.len()).find_map(|k| later(k).map(|other| (k, other)))
    }

    /// The first difference between the settings, as text; absent if their results can be merged. The names
    /// of trials and parts do not count.
    pub(crate) fn difference(&self, other: &Setting) -> Option<String> {
        let (trials, parts) = (&self.trials, &self.parts);
        if other.trials.len() != trials.len() {
            return Some(format!("other trials: expected {}, found {}", trials.len(), other.trials.len()));
        }
        if let Some(k) = (0..trials.len()).find(|&k| !trials[k].is_same_motion(&other.trials[k])) {
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
}

vcgpdm_core::coded!(SettingError => Comparison);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::testing::setting;

    #[test]
    fn names_of_trials_and_parts_do_not_count() {
        let difference = |change: &dyn Fn(&mut Setting)| {
            let mut other = setting(2);
            change(&mut other);
            setting(2).difference(&other)
        };
        // The page names a clip by its title, the terminal program by its file.
        assert_eq!(difference(&|other| other.trials[0].name = "a.bvh".to_owned()), None);
        assert_eq!(difference(&|other| other.parts[0].name = "legs".to_owned()), None);
        let differs = |change: &dyn Fn(&mut Setting), words: &str| {
            assert_eq!(difference(change).as_deref(), Some(words));
        };
        differs(
            &|other| other.trials[1].sha256 = "sha of another".to_owned(),
            "other trials: expected walk 2 as trial 2, found another file of that name",
        );
        differs(&|other| other.trials.truncate(1), "other trials: expected 2, found 1");
        differs(
            &|other| other.trials[0].piece = Some((0, 60)),
            "other trials: expected the whole of walk 1 as trial 1, found frames 0 to 60",
        );
        differs(&|other| other.parts.clear(), "other parts: expected 1, found 0");
        differs(&|other| other.parts[0].joints = vec![0], "other parts: lower has other joints");
        differs(
            &|other| other.frames_per_second = 25.0,
            "another frame rate: expected 30 frames a second, found 25",
        );
        differs(
            &|other| other.start_frames = 3,
            "predictions from another number of first frames: expected 5, found 3",
        );
        let text = serde_json::to_string(&setting(2)).unwrap();
        assert!(!text.contains("piece"), "as in files of earlier versions: {text}");
    }

    #[test]
    fn refuses_two_trials_of_the_same_motion() {
        let mut twice = setting(2);
        twice.trials.push(TrialClip { name: "again".to_owned(), ..twice.trials[1].clone() });
        let error = twice.check().unwrap_err().to_string();
        assert!(error.starts_with("trials 2 and 3 are the same motion (walk 2)"), "{error}");
        // Another piece of the same clip is another trial.
        twice.trials[2].piece = Some((10, 20));
        assert_eq!(twice.check(), Ok(()));
        twice.trials.truncate(1);
        assert_eq!(twice.check(), Err(SettingError::Trials(1)));
        let error = Setting { frames_per_second: 0.0, ..setting(2) }.check().unwrap_err().to_string();
        assert_eq!(error, "expected a positive number of frames a second, found 0");
    }
}
