//! Coupled Gaussian process movement primitives: the vCGPDM of Velychko, Knopp and Endres (2017-2020).
//!
//! A body is split into parts. Each part gets a small latent dynamical system, which is learned from motion
//! capture; a product of experts couples the parts, and the coupling variances alpha say how strongly each
//! part drives each other part.
//!
//! From a clip to a new motion:
//!
//! ```
//! use vcgpdm::{
//!     Dataset, RolloutRequest, VariationalSettings, Vcgpdm, part_presets, sample_clip, write_bvh,
//! };
//!
//! let clip = sample_clip("walk-1").ok_or("no such sample")?;
//! let parts = &part_presets(&clip.skeleton)[1].parts; // lower and upper body
//! let dataset = Dataset::new(&[(&clip).into()], parts, 30.0)?;
//!
//! let settings = VariationalSettings::default().with_max_iterations(20);
//! let model = Vcgpdm::fit(&dataset, &settings, 0)?;
//!
//! let coupled = model.coupled().ok_or("a vCGPDM has couplings")?;
//! let rollout = coupled.rollout(&RolloutRequest { frames: 60, ..RolloutRequest::default() })?;
//! let motion = write_bvh(&coupled.clip(&rollout, "walk.bvh")?);
//! assert!(motion.starts_with("HIERARCHY"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # From data to a model
//!
//! | step | of a body | of tables of numbers |
//! |---|---|---|
//! | data | [`read_bvh`] or [`read_asf`], then [`Clip`] | [`read_csv`], [`Table`] |
//! | parts | [`part_presets`] or own [`PartSpec`]s | [`column_parts`] |
//! | data set | [`Dataset::new`] | [`Dataset::of_tables`] |
//! | training | [`Vcgpdm::fit`]; or [`Settings`], [`Trainer`], [`Progress`] | the same |
//! | model | [`Model`], [`Coupled`], [`Rollout`] | [`SeriesModel`], the same |
//! | file | [`Document`], [`write_bvh`] | [`Document`], [`write_csv`] |
//!
//! [`LibraryTrainer`] learns primitives that several movements share, and [`TrainedLibrary`] combines them.
//!
//! The library reads and writes no files. Matrices are nalgebra's; their shapes stand in brackets, as [frames
//! x columns]. [`nalgebra`] is exported, so that a program need not depend on it; a new minor version of it
//! makes a new major version of this crate. Training without optimisation takes a hundred times as long:
//! build with `--release`, or give the development profile of your program `opt-level = 1` and its packages
//! `[profile.dev.package."*"] opt-level = 3`. Everything random follows from a seed. The symbols are those of
//! the papers; `docs/glossary.md` in the repository lists them with the names in the code.
//!
//! The examples `train`, `rollout`, `couplings` and `own_data` are short programs for the usual tasks.

#[doc(inline)]
pub use vcgpdm_core::{
    document::{Document, DocumentError},
    gp::NumericsError,
    json::JsonError,
    models::library::{
        CombinationError, CouplingTrainer, CouplingsFrom, EncodedClip, Leader, LearnedMovement, Library,
        LibraryError, LibraryPlan, LibraryTrainer, MergeError, Misfit, PartMotion, PlanError,
        PlannedMovement, Primitive, Recogniser, Recognition, RecognitionError, Segment, TrainedLibrary,
        WalkError,
    },
    models::variational::{
        BoundTerms, LatentMoments, PartPredictions, Prediction, PredictiveDynamics, VariationalTrainer,
        Vcgpdm,
    },
    models::{
        Body, ColumnMapping, Coupled, CouplingsError, Cut, Dataset, DatasetError, DmpSettings, EndReason,
        Ending, Endless, EndlessFrames, Handles, Health, MapSettings, Model, ModelKind, Pace, PartPoses,
        PosePush, PoseWeight, Progress, Provenance, Push, Reading, Rollout, RolloutError, RolloutRequest,
        SequenceInfo, SequencesError, SeriesModel, Setbacks, Settings, Source, TmpSettings, Trainer,
        TrainingCost, TrainingError, TrainingPhase, VariationalSettings, coupling_weight_matrix,
    },
    motion::asf::{AsfError, File as AsfFile, read as read_asf},
    motion::bvh::{BvhError, BvhProblem, read as read_bvh, write as write_bvh},
    motion::parts::{PartSpec, PartsError, PartsLayout, PartsPreset, presets as part_presets},
    motion::pose::{Column, ColumnKind, PoseError, PoseMapping},
    motion::samples::{SampleInfo, clip as sample_clip, list as sample_clips},
    motion::skeleton::{Channel, FigureNode, Joint, LocalPose, Skeleton, SkeletonError, WorldPose},
    motion::stage::UpAxis,
    motion::{BodyMismatch, Clip, ClipError, Recording, UnknownJoint},
    series::{
        Columns, SeriesError, Table, parse_parts as column_parts, read as read_csv, write as write_csv,
    },
};

/// The version of nalgebra whose matrices are in the signatures.
pub use nalgebra;

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
