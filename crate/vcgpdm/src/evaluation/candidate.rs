//! A model with its settings, as it enters a comparison.

use crate::models::dmp::{Canonical, DmpLearner, DmpSettings};
use crate::models::map::{MapLearner, MapSettings};
use crate::models::tmp::{TmpLearner, TmpSettings};
use crate::models::variational::{TrainingSettings, VariationalLearner};
use crate::models::{Learner, ModelKind, Movements, TrainingError};
use serde::{Deserialize, Serialize};

/// A model with all of its settings but the seed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "model", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Candidate {
    /// The variational coupled GPDM.
    Vcgpdm(GpdmSettings),
    /// The variational GPDM: all columns are one part.
    Vgpdm(GpdmSettings),
    /// The GPDM with point latents.
    MapGpdm(PointSettings),
    /// The coupled GPDM with point latents.
    MapCgpdm(PointSettings),
    /// Temporal movement primitives.
    Tmp {
        /// How many; absent: chosen by the bound.
        primitives: Option<usize>,
    },
    /// Dynamic movement primitives towards a goal.
    DmpDiscrete {
        /// Basis functions of each column.
        bases: usize,
    },
    /// Dynamic movement primitives around a centre.
    DmpRhythmic {
        /// Basis functions of each column.
        bases: usize,
    },
}

/// Settings of the variational models.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GpdmSettings {
    /// Q of every part.
    pub latent: usize,
    /// Order p of the dynamics.
    pub order: usize,
    /// Dynamics inducing points of every expert.
    pub dynamics_ips: usize,
    /// Pose inducing points of every part.
    pub pose_ips: usize,
    /// Most iterations of the optimiser.
    pub max_iterations: usize,
}

/// Settings of the models with point latents.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointSettings {
    /// Q of every part.
    pub latent: usize,
    /// Order p of the dynamics.
    pub order: usize,
    /// Most iterations of the optimiser.
    pub max_iterations: usize,
    /// Whether the dynamics weigh D / Q times as much (Urtasun, Fleet & Fua 2006).
    pub balanced: bool,
}

impl Candidate {
    /// Which kind of model it is.
    pub fn kind(&self) -> ModelKind {
        match self {
            Candidate::Vcgpdm(_) => ModelKind::Vcgpdm,
            Candidate::Vgpdm(_) => ModelKind::Vgpdm,
            Candidate::MapGpdm(_) => ModelKind::MapGpdm,
            Candidate::MapCgpdm(_) => ModelKind::MapCgpdm,
            Candidate::Tmp { .. } => ModelKind::Tmp,
            Candidate::DmpDiscrete { .. } => ModelKind::DmpDiscrete,
            Candidate::DmpRhythmic { .. } => ModelKind::DmpRhythmic,
        }
    }

    /// The same without its size (inducing points, primitives, bases): equal for candidates that differ in size alone.
    pub(super) fn of_any_size(&self) -> Candidate {
        let mut all = self.clone();
        match &mut all {
            Candidate::Vcgpdm(s) | Candidate::Vgpdm(s) => (s.dynamics_ips, s.pose_ips) = (0, 0),
            Candidate::MapGpdm(_) | Candidate::MapCgpdm(_) => {}
            Candidate::Tmp { primitives } => *primitives = None,
            Candidate::DmpDiscrete { bases } | Candidate::DmpRhythmic { bases } => *bases = 0,
        }
        all
    }

    /// Whether another seed gives another model.
    pub fn is_random(&self) -> bool {
        !matches!(self, Candidate::Tmp { .. } | Candidate::DmpDiscrete { .. } | Candidate::DmpRhythmic { .. })
    }

    /// A training of it, ready to begin. Models of the whole body see the columns of all parts as one part.
    pub fn learner(&self, movements: &Movements, seed: u32) -> Result<Box<dyn Learner>, TrainingError> {
        let variational =
            |s: &GpdmSettings, movements: Movements| -> Result<Box<dyn Learner>, TrainingError> {
                let settings = TrainingSettings {
                    latent: s.latent,
                    dynamics_ips: s.dynamics_ips,
                    pose_ips: s.pose_ips,
                    order: s.order,
                    seed,
                    max_iterations: s.max_iterations,
                };
                Ok(Box::new(VariationalLearner::new(movements, settings)?))
            };
        let point = |s: &PointSettings, movements: Movements| -> Result<Box<dyn Learner>, TrainingError> {
            let settings = MapSettings {
                latent: s.latent,
                order: s.order,
                seed,
                max_iterations: s.max_iterations,
                balanced: s.balanced,
            };
            Ok(Box::new(MapLearner::new(movements, settings)?))
        };
        match self {
            Candidate::Vcgpdm(s) => variational(s, movements.clone()),
            Candidate::Vgpdm(s) => variational(s, movements.as_one_part()),
            Candidate::MapGpdm(s) => point(s, movements.as_one_part()),
            Candidate::MapCgpdm(s) => point(s, movements.clone()),
            Candidate::Tmp { primitives } => {
                let settings = TmpSettings { primitives: *primitives, ..TmpSettings::default() };
                Ok(Box::new(TmpLearner::new(movements, settings)?))
            }
            Candidate::DmpDiscrete { bases } => dmp(movements, Canonical::Discrete, *bases),
            Candidate::DmpRhythmic { bases } => dmp(movements, Canonical::Rhythmic, *bases),
        }
    }
}

fn dmp(movements: &Movements, canonical: Canonical, bases: usize) -> Result<Box<dyn Learner>, TrainingError> {
    Ok(Box::new(DmpLearner::new(movements, DmpSettings { bases, ..DmpSettings::new(canonical) })?))
}
