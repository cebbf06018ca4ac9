//! The graphics Turing test (Velychko et al. 2018, section 5.4; Knopp et al. 2019): can people tell a model's movement from a natural one, and do
//! the models' scores know?
//!
//! A [`Study`] holds the movements and the design of an experiment, and [`Study::trials`] what one participant is shown.

mod design;
mod draw;
mod error;
mod make;
mod movement;
mod read;
mod staging;
mod stimulus;
mod study;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod trials;
mod write;

pub use design::{Design, Preset};
pub use error::StudyError;
pub use make::{Maker, MakerError, MakerReason, Shown};
pub use movement::{Movement, MovementError};
pub use staging::{Staged, StagingError, staged};
pub use stimulus::{Generated, Scores, Source, Stimulus};
pub use study::{Figure, Look, Study, Texts};
pub use trials::{NaturalSide, StudyTrial, TrialKind};
