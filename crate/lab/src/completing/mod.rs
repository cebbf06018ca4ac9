//! Completing: each part of a trial held out is inferred from the other parts, by a filter of a trained
//! vCGPDM and by other methods (docs/completing.md).
//!
//! A [`CompletingFold`] trains the models of one fold and scores every method, [`Completing`] stores the
//! results, and [`tables`] writes them as Markdown.

mod answer;
mod fold;
mod results;
mod rivals;
mod tables;
mod training_trial;

pub use fold::CompletingFold;
pub use results::{
    ColumnCoverage, CompletedPart, CompletedTrial, Completing, CompletingError, Limits, Method, MethodScore,
    TrainingTrial,
};
pub use tables::tables;
