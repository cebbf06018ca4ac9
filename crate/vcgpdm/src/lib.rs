//! Coupled Gaussian process movement primitives: the vCGPDM of Velychko, Knopp and Endres (2017-2020).
//!
//! A body is split into parts; each part gets a small latent dynamical system, learned from motion capture; a product of
//! experts couples them, and the coupling variances alpha say how strongly each part drives each other part.
//!
//! ```
//! use vcgpdm::models::variational::{Trainer, Vcgpdm};
//! use vcgpdm::models::{Dataset, RolloutRequest, Source, TrainedModel, VariationalSettings};
//! use vcgpdm::motion::{bvh, parts, samples};
//!
//! let clip = samples::clip("walk-1").ok_or("no such sample")?;
//! let parts = &parts::presets(&clip.skeleton)[1].parts; // lower and upper body
//! let dataset = Dataset::new(&[Source { clip: &clip, first_frames: None }], parts, 30.0)?;
//!
//! let settings = VariationalSettings { max_iterations: 20, ..VariationalSettings::default() };
//! let mut trainer = Trainer::new(dataset.y.clone(), dataset.lengths(), &settings, 0)?;
//! while !trainer.step().done {}
//!
//! let model = TrainedModel::<Vcgpdm>::trained(&dataset, &trainer, 30.0)?;
//! let rollout = model.rollout(&RolloutRequest { frames: 60, ..RolloutRequest::default() })?;
//! let motion = bvh::write(&model.clip(&rollout, "walk.bvh")?);
//! assert!(motion.starts_with("HIERARCHY"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod document;
pub mod evaluation;
pub mod golden;
pub mod gp;
mod json;
pub mod models;
pub mod motion;
#[cfg(feature = "speed")]
pub mod speed;
pub mod synthetic;
mod words;
