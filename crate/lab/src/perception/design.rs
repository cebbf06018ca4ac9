//! The numbers of trials of a participant.

use crate::perception::record::{Written, record, whole};
use vcgpdm_core::json::{Field, FieldError, Value};

/// Most trials of a kind.
const MOST_TRIALS: usize = 10_000;

record! {
    /// The number of trials of each kind for a participant.
    #[cfg_attr(feature = "types", ts(rename_all = "camelCase", rename = "StudyDesign"))]
    pub struct Design {
        /// Number of blocks of about equal length, with pauses between them.
        blocks: usize = |field| whole(field, 1..=100),
        /// Trials of a generated and a natural movement, spread over the settings of the models as evenly as
        /// possible.
        comparisons: usize = |field| whole(field, 1..=MOST_TRIALS),
        /// A study without a failed movement has no attention checks.
        attention_checks: usize = |field| whole(field, 0..=MOST_TRIALS),
        /// A study without an unseen natural movement has no catch trials.
        catch_trials: usize = |field| whole(field, 0..=MOST_TRIALS),
        /// The shortest pause between blocks.
        pause_seconds: usize = |field| whole(field, 0..=3600),
        /// Whether a participant can answer while the figures move. The answer then ends the trial.
        answer_during_movement: bool = |field: Field| field.boolean(),
        /// Together with the participant's seed, the seed of everything random.
        seed: u32 = |field: Field| {
            u32::try_from(field.whole()?).map_err(|_| field.wrong("a whole number from 0 to 4294967295"))
        },
    }
}

/// Names of designs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "types",
    derive(ts_rs::TS),
    ts(rename = "StudyPreset", type = "\"class\" | \"p3-part-1\" | \"p3-part-2\" | \"p2\"")
)]
pub enum Preset {
    /// 60 trials, about 5 minutes: for a class.
    Class,
    /// The first part of Knopp et al. (2019): 620 + 17 + 6 trials in four blocks, about 90 minutes.
    P3Part1,
    /// The second part of Knopp et al. (2019): 629 trials, of which 29 are attention checks, in seven blocks.
    P3Part2,
    /// Velychko et al. (2018): 1170 trials, of which 10 are catch trials, with shorter movements.
    P2,
}

impl Preset {
    /// All of them.
    pub const ALL: [Preset; 4] = [Preset::Class, Preset::P3Part1, Preset::P3Part2, Preset::P2];

    /// Its name on the command line and in JavaScript.
    pub fn id(self) -> &'static str {
        match self {
            Preset::Class => "class",
            Preset::P3Part1 => "p3-part-1",
            Preset::P3Part2 => "p3-part-2",
            Preset::P2 => "p2",
        }
    }

    /// The preset of this name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|preset| preset.id() == id)
    }

    /// Its numbers of trials.
    pub fn design(self, seed: u32) -> Design {
        let (blocks, comparisons, attention_checks, catch_trials, pause_seconds) = match self {
            Preset::Class => (1, 52, 4, 4, 0),
            Preset::P3Part1 => (4, 620, 17, 6, 30),
            Preset::P3Part2 => (7, 600, 29, 0, 30),
            // The paper has neither blocks nor attention checks; nine blocks are 130 trials each.
            Preset::P2 => (9, 1160, 0, 10, 30),
        };
        Design {
            blocks,
            comparisons,
            attention_checks,
            catch_trials,
            pause_seconds,
            answer_during_movement: false,
            seed,
        }
    }

    /// Seconds of the movements, and of the cross before each trial.
    pub fn seconds(self) -> (f64, f64) {
        match self {
            Preset::P2 => (1.8, 1.0),
            _ => (3.5, 0.75),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gives_the_numbers_of_trials_of_the_papers() {
        let total = |preset: Preset| {
            let design = preset.design(0);
            assert_eq!(Preset::from_id(preset.id()), Some(preset));
            design.comparisons + design.attention_checks + design.catch_trials
        };
        assert_eq!(Preset::ALL.map(total), [60, 643, 629, 1170]);
        assert_eq!(Preset::from_id("p4"), None);
    }
}
