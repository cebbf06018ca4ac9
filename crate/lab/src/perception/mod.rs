//! The graphics Turing test (Velychko et al. 2018, section 5.4; Knopp et al. 2019): can people distinguish
//! the movement of a model from a natural one, and do the scores of the models predict this?
//!
//! A [`Study`] holds the movements and the design of an experiment, [`Study::trials`] are the trials of one
//! participant, [`read_answers`] reads answers, and [`PerceptionResults`] are the results: rates, curves over
//! the scores of the models, orders of the models.

mod analysis;
mod answers;
mod beta;
mod counts;
mod csv;
mod design;
mod document;
mod error;
mod error_curve;
mod figures;
mod make;
mod movement;
mod ordering;
mod paper;
mod read;
mod record;
mod regression;
mod results;
mod staging;
mod stimulus;
mod study;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod trials;
mod validation;
mod write;

pub use analysis::AnalysisError;
pub use answers::{Answer, AnswerFile, AnswersError, AnswersReason, read as read_answers};
pub use beta::Rate;
pub use csv::CsvError;
pub use design::{Design, Preset};
pub use error::StudyError;
pub use figures::FigureTable;
pub use make::{Maker, MakerError, MakerReason, StudyMovement};
pub use movement::{FigureMovement, MovementError};
pub use paper::{PaperCheck, paper_checks};
pub use paper::{trials_for_precision, trials_to_tell};
pub use results::{
    AnalysisOptions, Best, Catch, Confusion, ErrorCurve, MeanScores, Needed, Order, Participant,
    PerceptionResults, Regression, ScoreKind, SettingResult, Size,
};
pub use staging::{Staged, StagingError, staged};
pub use stimulus::{Generated, MovementSource, Scores, Stimulus};
pub use study::{Figure, Look, Study, Texts};
pub use trials::{NaturalSide, StudyTrial, TrialKind};
