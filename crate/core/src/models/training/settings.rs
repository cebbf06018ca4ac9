//! Settings of a training without the seed: a type for each kind of model, and the enum of all of them.

use crate::models::data::column_mapping::ColumnMapping;
use crate::models::data::dataset::Dataset;
use crate::models::training::kind::ModelKind;
use crate::models::training::pose_weight::PoseWeight;
use serde::{Deserialize, Serialize};

/// The most latent dimensions of a part, and the highest order of the dynamics; more would not fit the memory
/// of a browser.
pub const MOST_DIMENSIONS: usize = 100;
/// The most inducing points of a map.
pub const MOST_INDUCING: usize = 1000;
/// The most primitives of a TMP; more would only be slow.
pub const MOST_PRIMITIVES: usize = 40;
/// The most basis functions of a DMP.
pub const MOST_BASES: usize = 200;

/// The size of a variational model, and how long it is trained.
///
/// Every setting has a default. Methods state those that differ, or a struct literal, as for all settings of
/// this crate:
///
/// ```
/// use vcgpdm::VariationalSettings;
///
/// let settings = VariationalSettings::default().with_latent(2).with_order(1);
/// assert_eq!(settings, VariationalSettings { latent: 2, order: 1, ..Default::default() });
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct VariationalSettings {
    /// Latent dimensions Q of every part, 1 to 100.
    pub latent: usize,
    /// Order p of the dynamics: how many earlier frames predict the next one, 1 to 100.
    pub order: usize,
    /// Dynamics inducing points K of every expert, 1 to 1000.
    pub dynamics_ips: usize,
    /// Pose inducing points L of every part, 1 to 1000.
    pub pose_ips: usize,
    /// Most iterations of the optimiser, all phases together.
    pub max_iterations: usize,
    /// The factor of the pose terms in the objective: a number from 0.001 to 1000, or "balanced" for Q_i /
    /// D_i (Urtasun, Fleet & Fua 2006). Absent: 1, and the objective is the bound on the log evidence.
    #[serde(default, skip_serializing_if = "PoseWeight::is_plain")]
    #[cfg_attr(feature = "types", ts(type = "number | \"balanced\""))]
    pub pose_weight: PoseWeight,
    /// Whether each part of a vCGPDM learns as if it were alone; absent: no.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub uncoupled: bool,
    /// Whether a model of a body whose rollouts do not move on learns from these at the end; absent: no.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub own_rollouts: bool,
}

/// As in the papers: training maximises the bound. [`VariationalSettings::for_dataset`] has the defaults of the
/// project's programs.
impl Default for VariationalSettings {
    fn default() -> Self {
        Self {
            latent: 3,
            order: 2,
            dynamics_ips: 12,
            pose_ips: 12,
            max_iterations: 250,
            pose_weight: PoseWeight::default(),
            uncoupled: false,
            own_rollouts: false,
        }
    }
}

/// A clip of this many seconds is long.
const LONG_CLIP: f64 = 8.0;
/// Inducing points of every map where a clip is long.
const POINTS_OF_LONG_CLIPS: usize = 30;

impl VariationalSettings {
    /// The settings for a data set, where nobody asks for others: on the page, in the terminal, in JavaScript and
    /// in Python alike. Those of clips are [`for_clips`](Self::for_clips), with the longest clip of the data set.
    /// Tables have the settings of the papers: for them nothing was measured.
    pub fn for_dataset<S: ColumnMapping>(dataset: &Dataset<S>) -> Self {
        if dataset.mapping.poses().is_none() {
            return Self::default();
        }
        let longest = dataset.lengths().into_iter().max().unwrap_or(0);
        Self::for_clips(longest as f64 * dataset.frame_time)
    }

    /// The settings for clips of which the longest has this many seconds:
    ///
    /// - the pose terms are balanced: on walks of six persons rollouts then had smaller errors (docs/training.md,
    ///   "The weight of the poses");
    /// - from 8 seconds on, every map has 30 inducing points instead of 12: more rollouts kept moving with them,
    ///   by a small and not certain margin ("Points by length");
    /// - the model learns from its own rollouts: fewer models come to rest ("Learning from own rollouts").
    pub fn for_clips(longest: f64) -> Self {
        let usual = Self::for_library().with_pose_weight(PoseWeight::Balanced);
        if longest < LONG_CLIP {
            return usual;
        }
        usual.with_points(POINTS_OF_LONG_CLIPS, POINTS_OF_LONG_CLIPS)
    }

    /// The settings for a library of several movements: those of the papers, and each movement learns from its
    /// own rollouts. No gain from balanced pose terms was seen (docs/training.md, "Libraries").
    pub fn for_library() -> Self {
        Self::default().with_own_rollouts(true)
    }

    /// Trained as in the papers: the objective is the bound on the log evidence, and the model does not learn from
    /// its own rollouts.
    #[must_use]
    pub fn as_in_papers(self) -> Self {
        self.with_pose_weight(PoseWeight::default()).with_own_rollouts(false)
    }

    /// With another number of latent dimensions of every part.
    #[must_use]
    pub fn with_latent(self, latent: usize) -> Self {
        Self { latent, ..self }
    }

    /// With another order of the dynamics.
    #[must_use]
    pub fn with_order(self, order: usize) -> Self {
        Self { order, ..self }
    }

    /// With other numbers of inducing points: of the dynamics of every expert, and of the poses of every part.
    #[must_use]
    pub fn with_points(self, dynamics_ips: usize, pose_ips: usize) -> Self {
        Self { dynamics_ips, pose_ips, ..self }
    }

    /// With another limit of the iterations.
    #[must_use]
    pub fn with_max_iterations(self, max_iterations: usize) -> Self {
        Self { max_iterations, ..self }
    }

    /// With another weight of the pose terms.
    #[must_use]
    pub fn with_pose_weight(self, pose_weight: PoseWeight) -> Self {
        Self { pose_weight, ..self }
    }

    /// With or without learning from its own rollouts.
    #[must_use]
    pub fn with_own_rollouts(self, own_rollouts: bool) -> Self {
        Self { own_rollouts, ..self }
    }

    /// With or without couplings between parts.
    #[must_use]
    pub fn with_uncoupled(self, uncoupled: bool) -> Self {
        Self { uncoupled, ..self }
    }
}

/// Settings of the models with point estimates of their latents, MAP GPDM and MAP CGPDM.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct MapSettings {
    /// Latent dimensions Q of every part, 1 to 100.
    pub latent: usize,
    /// Order p of the dynamics: how many earlier frames predict the next one, 1 to 100.
    pub order: usize,
    /// Most iterations of the optimiser.
    pub max_iterations: usize,
    /// Whether the log density of the dynamics into part i is multiplied by D_i / Q_i (Urtasun, Fleet & Fua
    /// 2006).
    pub balanced: bool,
    /// Whether the kernels of the dynamics have a linear term (Wang et al. 2008).
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub linear: bool,
}

impl Default for MapSettings {
    fn default() -> Self {
        Self { latent: 3, order: 2, max_iterations: 800, balanced: false, linear: false }
    }
}

/// Settings of temporal movement primitives.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct TmpSettings {
    /// Number of primitives Q, 1 to 40; absent: the number with the highest bound.
    pub primitives: Option<usize>,
    /// Whether the primitives are functions of normalised time, with weights that all trials share (Clever et
    /// al. 2016); false: functions of a phase that is learned for each trial, like its weights.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub normalised_time: bool,
}

/// Settings of dynamic movement primitives, discrete or rhythmic.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct DmpSettings {
    /// Basis functions B of every column, 1 to 200.
    pub bases: usize,
}

impl Default for DmpSettings {
    fn default() -> Self {
        Self { bases: 20 }
    }
}

/// A model with all of its settings but the seed.
///
/// In JSON, the field "model" names the kind, and the settings are fields of the same object.
///
/// ```
/// use vcgpdm_core::models::{DmpSettings, ModelKind, Settings};
///
/// let settings = Settings::DmpRhythmic(DmpSettings { bases: 25 });
/// assert_eq!(settings.kind(), ModelKind::DmpRhythmic);
/// assert_eq!(serde_json::to_string(&settings)?, r#"{"model":"dmp-rhythmic","bases":25}"#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(tag = "model", rename_all = "kebab-case", deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "Candidate"))]
pub enum Settings {
    /// The variational coupled GPDM.
    Vcgpdm(VariationalSettings),
    /// The variational GPDM: all columns are one part.
    Vgpdm(VariationalSettings),
    /// The GPDM with point estimates of its latents: all columns are one part.
    MapGpdm(MapSettings),
    /// The coupled GPDM with point estimates of its latents.
    MapCgpdm(MapSettings),
    /// Temporal movement primitives.
    Tmp(TmpSettings),
    /// Dynamic movement primitives towards a goal.
    DmpDiscrete(DmpSettings),
    /// Dynamic movement primitives around a centre.
    DmpRhythmic(DmpSettings),
}

impl From<VariationalSettings> for Settings {
    fn from(settings: VariationalSettings) -> Self {
        Settings::Vcgpdm(settings)
    }
}

impl Default for Settings {
    /// A vCGPDM.
    fn default() -> Self {
        Settings::Vcgpdm(VariationalSettings::default())
    }
}

impl From<ModelKind> for Settings {
    /// The defaults of a kind.
    fn from(kind: ModelKind) -> Self {
        match kind {
            ModelKind::Vcgpdm => Settings::Vcgpdm(VariationalSettings::default()),
            ModelKind::Vgpdm => Settings::Vgpdm(VariationalSettings::default()),
            ModelKind::MapGpdm => Settings::MapGpdm(MapSettings::default()),
            ModelKind::MapCgpdm => Settings::MapCgpdm(MapSettings::default()),
            ModelKind::Tmp => Settings::Tmp(TmpSettings::default()),
            ModelKind::DmpDiscrete => Settings::DmpDiscrete(DmpSettings::default()),
            ModelKind::DmpRhythmic => Settings::DmpRhythmic(DmpSettings::default()),
        }
    }
}

impl Settings {
    /// The kind of model.
    pub fn kind(&self) -> ModelKind {
        match self {
            Settings::Vcgpdm(_) => ModelKind::Vcgpdm,
            Settings::Vgpdm(_) => ModelKind::Vgpdm,
            Settings::MapGpdm(_) => ModelKind::MapGpdm,
            Settings::MapCgpdm(_) => ModelKind::MapCgpdm,
            Settings::Tmp(_) => ModelKind::Tmp,
            Settings::DmpDiscrete(_) => ModelKind::DmpDiscrete,
            Settings::DmpRhythmic(_) => ModelKind::DmpRhythmic,
        }
    }

    /// The settings of a vCGPDM or vGPDM; `None` for other kinds.
    pub fn variational(&self) -> Option<&VariationalSettings> {
        match self {
            Settings::Vcgpdm(settings) | Settings::Vgpdm(settings) => Some(settings),
            Settings::MapGpdm(_)
            | Settings::MapCgpdm(_)
            | Settings::Tmp(_)
            | Settings::DmpDiscrete(_)
            | Settings::DmpRhythmic(_) => None,
        }
    }

    /// Whether another seed gives another model.
    pub fn is_random(&self) -> bool {
        self.kind().is_random()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_settings_that_it_writes() {
        for (settings, text) in [
            (
                Settings::Vcgpdm(VariationalSettings::default()),
                r#"{"model":"vcgpdm","latent":3,"order":2,"dynamics_ips":12,"pose_ips":12,"max_iterations":250}"#,
            ),
            (
                Settings::MapGpdm(MapSettings::default()),
                r#"{"model":"map-gpdm","latent":3,"order":2,"max_iterations":800,"balanced":false}"#,
            ),
            (Settings::Tmp(TmpSettings::default()), r#"{"model":"tmp","primitives":null}"#),
            (Settings::DmpDiscrete(DmpSettings::default()), r#"{"model":"dmp-discrete","bases":20}"#),
        ] {
            assert_eq!(serde_json::to_string(&settings).unwrap(), text);
            assert_eq!(serde_json::from_str::<Settings>(text).unwrap(), settings);
            assert!(text.contains(settings.kind().id()));
        }
        let absent = serde_json::from_str::<Settings>(r#"{"model":"tmp"}"#).unwrap();
        assert_eq!(absent, Settings::Tmp(TmpSettings::default()));
    }

    #[test]
    fn balances_clips_and_gives_long_ones_more_inducing_points() {
        let clips = VariationalSettings::for_clips(1.0);
        assert!(clips.own_rollouts && clips.pose_weight == PoseWeight::Balanced);
        let points = |seconds| {
            let settings = VariationalSettings::for_clips(seconds);
            (settings.dynamics_ips, settings.pose_ips)
        };
        assert_eq!([points(0.0), points(7.9), points(8.0)], [(12, 12), (12, 12), (30, 30)]);
    }

    #[test]
    fn refuses_unknown_settings() {
        let error = |text| serde_json::from_str::<Settings>(text).unwrap_err().to_string();
        let unknown = error(r#"{"model":"dmp-rhythmic","bases":5,"primitives":2}"#);
        assert_eq!(unknown, "unknown field `primitives`, expected `bases`");
        assert!(error(r#"{"model":"gplvm"}"#).starts_with("unknown variant `gplvm`"));
    }
}
