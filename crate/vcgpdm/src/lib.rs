//! Coupled Gaussian process movement primitives: the vCGPDM of Velychko, Knopp and Endres (2017-2020).
//!
//! A body is split into parts. Each part gets a small latent dynamical system, which is learned from motion
//! capture; a product of experts couples the parts, and the coupling variances alpha say how strongly each
//! part drives each other part.
//!
//! From a clip to a new motion:
//!
//! ```
//! use vcgpdm::motion::{bvh, parts, samples};
//! use vcgpdm::{Dataset, RolloutRequest, Settings, Trainer, VariationalSettings};
//!
//! let clip = samples::clip("walk-1").ok_or("no such sample")?;
//! let parts = &parts::presets(&clip.skeleton)[1].parts; // lower and upper body
//! let dataset = Dataset::new(&[(&clip).into()], parts, 30.0)?;
//!
//! let settings = VariationalSettings { max_iterations: 20, ..VariationalSettings::default() };
//! let mut trainer = Trainer::new(&dataset, &Settings::Vcgpdm(settings), 0)?;
//! trainer.run();
//! let model = trainer.finish()?;
//!
//! let coupled = model.coupled().ok_or("a vCGPDM has couplings")?;
//! let rollout = coupled.rollout(&RolloutRequest { frames: 60, ..RolloutRequest::default() })?;
//! let motion = bvh::write(&coupled.clip(&rollout, "walk.bvh")?);
//! assert!(motion.starts_with("HIERARCHY"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The rooms
//!
//! A module uses only modules that stand before it in this list.
//!
//! - [`motion`]: skeletons, clips, BVH files, sample walks; poses as rows of numbers; the parts of a body.
//! - [`series`]: tables of numbers that are no body's, from CSV; their columns and parts.
//! - [`gp`]: the kernel, the psi statistics and the collapsed bound of a Gaussian process with inducing
//!   points.
//! - [`models`]: the vCGPDM ([`models::variational`]) and the models that it is compared with
//!   ([`models::map`], [`models::tmp`], [`models::dmp`]); data sets, trainings, rollouts, couplings.
//! - [`document`]: trained models as versioned JSON documents.
//!
//! The library reads and writes no files. Matrices are nalgebra's; their shapes stand in brackets, as [frames
//! x columns]. ([`nalgebra`] is exported, so that a program need not name it and cannot name another
//! version.) Training without optimisation takes a hundred times as long: build with `--release`, or give the
//! development profile of your program `opt-level = 1` and its packages `[profile.dev.package."*"] opt-level
//! = 3`. Everything random follows from a seed. The symbols are those of the papers; `docs/glossary.md` in
//! the repository sets them beside the names in the code, and gives the meaning of every word that the
//! project uses in a sense of its own.
//!
//! The examples `train`, `rollout`, `couplings` and `own_data` show the usual tasks, each in one short
//! program.

// A test may use any platform's sines.
#![cfg_attr(test, allow(clippy::disallowed_methods))]

pub mod document;
mod elementary;
pub mod gp;
mod json;
pub mod models;
pub mod motion;
pub mod series;
#[cfg(feature = "speed")]
pub mod speed;
mod words;

pub use models::{
    Coupled, Dataset, DatasetError, Model, ModelKind, Progress, Provenance, Rollout, RolloutError,
    RolloutRequest, SeriesModel, Settings, Source, Trainer, TrainingError, VariationalSettings,
};
pub use motion::Clip;

/// For the other crates of this project: semantic versioning does not cover it, and any version may change it.
#[cfg(feature = "internals")]
#[doc(hidden)]
#[allow(missing_docs)]
pub mod internals {
    pub use crate::document::{settings_of, settings_value};
    pub use crate::elementary::Elementary;
    pub use crate::gp::linalg::{Factor, block_diagonal};
    pub use crate::models::search::optimizer::Optimizer;
    pub use crate::motion::clip::sha256;
    pub use crate::words::counted;

    use crate::models::{DatasetError, SequenceInfo, TrainingError};

    pub mod json {
        pub use crate::json::*;
    }

    /// Why these sequences cannot be trained on, with the clip's name where the reason is in one of them.
    pub fn dataset_error(reason: TrainingError, sequences: &[SequenceInfo]) -> DatasetError {
        DatasetError::about(reason, sequences)
    }
}

/// Matrices go in and out as this version of nalgebra has them.
pub use nalgebra;
