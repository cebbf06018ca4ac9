//! A study: its movements, their sources, and how they are displayed.

use crate::perception::design::{Design, Preset};
use crate::perception::error::{FORMAT, StudyError};
use crate::perception::record::{Written, record, short};
use crate::perception::stimulus::Stimulus;
use serde::Serialize;
use std::ops::RangeInclusive;
use vcgpdm_core::json::{Field, FieldError, Value};
use vcgpdm_core::motion::landmarks::Landmarks;

/// How the figures of a study are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "StudyLook"))]
pub enum Look {
    /// A grey figure.
    Figure,
    /// Point lights: dots at some joints without lines (Johansson 1973).
    Points,
}

impl Look {
    /// Its name in documents.
    pub fn id(self) -> &'static str {
        match self {
            Look::Figure => "figure",
            Look::Points => "points",
        }
    }

    /// The look of this name.
    pub fn from_id(id: &str) -> Option<Self> {
        [Look::Figure, Look::Points].into_iter().find(|look| look.id() == id)
    }
}

/// Most letters of a text to read.
const TEXT: usize = 20_000;

record! {
    /// The texts for participants: plain text, with an empty line between paragraphs.
    #[cfg_attr(feature = "types", ts(rename_all = "camelCase", rename = "StudyTexts"))]
    pub struct Texts {
        /// Consent to take part.
        consent: String = |field| short(&field, TEXT),
        /// Instructions.
        instructions: String = |field| short(&field, TEXT),
        /// The question of every trial.
        question: String = |field| short(&field, TEXT),
        /// Text between two blocks.
        pause: String = |field| short(&field, TEXT),
        /// Text after the last trial.
        end: String = |field| short(&field, TEXT),
    }
}

impl Default for Texts {
    fn default() -> Self {
        let text = str::to_owned;
        Self {
            consent: text(
                "You will see pairs of short movements and say which of the two looks more natural to you.\n\n\
                 Taking part is voluntary. You can stop at any time without giving a reason. Your answers are \
                 kept on this computer and are not sent anywhere. No name, picture or sound of you is recorded.",
            ),
            instructions: text(
                "In every trial a cross appears first: please look at it. Then two figures move side by side. \
                 One movement comes from a recording, the other from a computer model.\n\n\
                 When they have ended, say on which side you saw the more natural movement: press the left or \
                 the right arrow key, or tap on that side. There is no time limit, but answer with your first \
                 impression. If you cannot tell, guess.",
            ),
            question: text("On which side did you perceive the more natural movement?"),
            pause: text("Time for a pause. Rest your eyes for a moment."),
            end: text("That was all. Thank you for taking part!"),
        }
    }
}

/// The figure that moves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// The name of each node; joints first, then the ends of the last bones.
    pub names: Vec<String>,
    /// The parent of each node, with a smaller index; none for the root.
    pub parents: Vec<Option<usize>>,
    /// Number of nodes that are joints.
    pub joints: usize,
    /// Nodes with a special role in the picture.
    pub landmarks: Landmarks,
}

/// A study: its movements, their sources, and how they are displayed.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// The title.
    pub title: String,
    /// How the figures are drawn.
    pub look: Look,
    /// Frames a second of all movements.
    pub frames_per_second: usize,
    /// Seconds of each movement.
    pub seconds: f64,
    /// Seconds of the cross before each trial.
    pub cross_seconds: f64,
    /// Texts for the participant.
    pub texts: Texts,
    /// The numbers of trials.
    pub design: Design,
    /// The figure that moves.
    pub figure: Figure,
    /// Height of the figure, in metres.
    pub height: f64,
    /// Unit of the stored positions, in metres.
    pub unit: f64,
    /// The movements.
    pub stimuli: Vec<Stimulus>,
}

impl Study {
    /// The field "format" of a study's document.
    pub const FORMAT: &'static str = FORMAT;

    /// Range of the seconds of movements.
    pub const SECONDS: RangeInclusive<f64> = 0.1..=60.0;

    /// Number of frames of each movement in a trial.
    pub fn frames(&self) -> usize {
        (self.seconds * self.frames_per_second as f64).round() as usize
    }

    /// The seconds of the shortest stimulus; infinity without any.
    pub fn longest(&self) -> f64 {
        let frames = self.stimuli.iter().map(|stimulus| stimulus.movement.frames()).min();
        frames.map_or(f64::INFINITY, |frames| frames as f64 / self.frames_per_second as f64)
    }

    /// The positions of a movement's nodes in a trial [frames x nodes x 3]: y up, in metres, the ground at y
    /// = 0, the figure above the origin and moving along z.
    pub fn positions(&self, stimulus: usize) -> Option<Vec<f32>> {
        self.stimuli.get(stimulus).map(|stimulus| stimulus.movement.positions(self.frames(), self.unit))
    }

    /// The index of the stimulus of this id.
    pub fn find(&self, id: &str) -> Option<usize> {
        self.stimuli.iter().position(|stimulus| stimulus.id == id)
    }

    /// The same movements with the trials and times of a preset. Movements that are shorter than the preset's
    /// are displayed whole.
    pub fn with_preset(mut self, preset: Preset) -> Self {
        let (seconds, cross) = preset.seconds();
        (self.seconds, self.cross_seconds) = (seconds.min(self.longest()), cross);
        self.design = preset.design(self.design.seed);
        self
    }

    /// The same movements with exactly those of these ids marked as obvious failures.
    ///
    /// # Errors
    /// There is no generated movement of one of these ids.
    pub fn with_failed(mut self, ids: &[String]) -> Result<Self, StudyError> {
        let generated = |id: &&String| self.find(id).is_some_and(|k| self.stimuli[k].generated().is_some());
        if let Some(id) = ids.iter().find(|id| !generated(id)) {
            return Err(StudyError::Stimulus(id.chars().take(80).collect()));
        }
        for stimulus in &mut self.stimuli {
            stimulus.mark(ids.contains(&stimulus.id));
        }
        Ok(self)
    }
}
