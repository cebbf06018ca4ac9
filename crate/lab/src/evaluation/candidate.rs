//! The candidates of a comparison: models of the library, and rivals that only comparisons know.

use crate::evaluation::rivals::Rival;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use vcgpdm_core::models::{
    DmpSettings, MapSettings, ModelKind, Settings, TmpSettings, TrainingCost, VariationalSettings,
};

/// A model of a comparison with its settings. In files, the field `model` is the [id](CandidateKind::id).
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(untagged, from = "Named")]
pub enum Candidate {
    /// A model of the library.
    Model(Settings),
    /// Another model, to compare the models of the library with.
    Rival(Rival),
}

/// The ids of all kinds, in the order of tables.
const IDS: [&str; 9] =
    ["vcgpdm", "vgpdm", "map-gpdm", "map-cgpdm", "tmp", "dmp-discrete", "dmp-rhythmic", "promp", "ar"];

/// The kinds of candidates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CandidateKind {
    /// A kind of model of the library.
    Model(ModelKind),
    /// Probabilistic movement primitives.
    ProMp,
    /// An autoregression on principal components.
    Ar,
}

impl Candidate {
    /// The kind of the candidate.
    pub fn kind(&self) -> CandidateKind {
        match self {
            Candidate::Model(settings) => settings.kind().into(),
            Candidate::Rival(Rival::ProMp { .. }) => CandidateKind::ProMp,
            Candidate::Rival(Rival::Ar { .. }) => CandidateKind::Ar,
        }
    }

    /// The settings of a model of the library; `None` for a rival.
    pub fn settings(&self) -> Option<&Settings> {
        match self {
            Candidate::Model(settings) => Some(settings),
            Candidate::Rival(_) => None,
        }
    }

    /// Whether another seed gives another model.
    pub fn is_random(&self) -> bool {
        self.settings().is_some_and(Settings::is_random)
    }

    /// The estimated cost of its training on `frames` frames of parts with these numbers of `columns`; that of
    /// a rival is neglected.
    pub(super) fn cost(&self, frames: usize, columns: &[usize]) -> TrainingCost {
        self.settings().map_or_else(TrainingCost::default, |settings| settings.cost(frames, columns))
    }
}

impl From<Settings> for Candidate {
    fn from(settings: Settings) -> Self {
        Candidate::Model(settings)
    }
}

impl From<Rival> for Candidate {
    fn from(rival: Rival) -> Self {
        Candidate::Rival(rival)
    }
}

/// The candidates as files name them: serde reads and refuses all of them as one enum.
#[derive(Deserialize)]
#[serde(tag = "model", rename_all = "kebab-case", deny_unknown_fields)]
enum Named {
    Vcgpdm(VariationalSettings),
    Vgpdm(VariationalSettings),
    MapGpdm(MapSettings),
    MapCgpdm(MapSettings),
    Tmp(TmpSettings),
    DmpDiscrete(DmpSettings),
    DmpRhythmic(DmpSettings),
    Promp { bases: usize },
    Ar { components: usize, order: usize },
}

impl From<Named> for Candidate {
    fn from(named: Named) -> Self {
        let settings = match named {
            Named::Vcgpdm(settings) => Settings::Vcgpdm(settings),
            Named::Vgpdm(settings) => Settings::Vgpdm(settings),
            Named::MapGpdm(settings) => Settings::MapGpdm(settings),
            Named::MapCgpdm(settings) => Settings::MapCgpdm(settings),
            Named::Tmp(settings) => Settings::Tmp(settings),
            Named::DmpDiscrete(settings) => Settings::DmpDiscrete(settings),
            Named::DmpRhythmic(settings) => Settings::DmpRhythmic(settings),
            Named::Promp { bases } => return Rival::ProMp { bases }.into(),
            Named::Ar { components, order } => return Rival::Ar { components, order }.into(),
        };
        settings.into()
    }
}

impl CandidateKind {
    /// All kinds, in the order in which tables list them.
    pub fn all() -> impl Iterator<Item = Self> {
        ModelKind::ALL.into_iter().map(Self::Model).chain([Self::ProMp, Self::Ar])
    }

    /// The place in [`CandidateKind::all`].
    pub(super) fn place(self) -> Option<usize> {
        Self::all().position(|kind| kind == self)
    }

    /// The name in documents and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            CandidateKind::Model(kind) => kind.id(),
            CandidateKind::ProMp => "promp",
            CandidateKind::Ar => "ar",
        }
    }

    /// The name in sentences.
    pub fn title(self) -> &'static str {
        match self {
            CandidateKind::Model(kind) => kind.title(),
            CandidateKind::ProMp => "ProMP",
            CandidateKind::Ar => "AR",
        }
    }

    /// The kind of this name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::all().find(|kind| kind.id() == id)
    }

    /// Whether it couples the parts of a body.
    pub fn is_coupled(self) -> bool {
        matches!(self, CandidateKind::Model(kind) if kind.is_coupled())
    }
}

impl From<ModelKind> for CandidateKind {
    fn from(kind: ModelKind) -> Self {
        CandidateKind::Model(kind)
    }
}

impl PartialEq<ModelKind> for CandidateKind {
    fn eq(&self, other: &ModelKind) -> bool {
        *self == CandidateKind::Model(*other)
    }
}

impl Serialize for CandidateKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.id())
    }
}

impl<'de> Deserialize<'de> for CandidateKind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let id = String::deserialize(deserializer)?;
        Self::from_id(&id).ok_or_else(|| D::Error::unknown_variant(&id, &IDS))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_models_and_rivals_by_the_same_field() {
        let candidates: [(Candidate, &str); 3] = [
            (Settings::DmpRhythmic(DmpSettings { bases: 5 }).into(), r#"{"model":"dmp-rhythmic","bases":5}"#),
            (Rival::ProMp { bases: 9 }.into(), r#"{"model":"promp","bases":9}"#),
            (Rival::Ar { components: 6, order: 2 }.into(), r#"{"model":"ar","components":6,"order":2}"#),
        ];
        for (candidate, text) in candidates {
            assert_eq!(serde_json::to_string(&candidate).unwrap(), text);
            assert_eq!(serde_json::from_str::<Candidate>(text).unwrap(), candidate);
            let kind = serde_json::to_string(&candidate.kind()).unwrap();
            assert_eq!(serde_json::from_str::<CandidateKind>(&kind).unwrap(), candidate.kind());
        }
        let says = |text| serde_json::from_str::<Candidate>(text).unwrap_err().to_string();
        assert!(says(r#"{"model":"promp","bases":9,"order":2}"#).contains("unknown field `order`"));
        assert!(says(r#"{"model":"gplvm"}"#).contains("unknown variant `gplvm`"));
        let kind = serde_json::from_str::<CandidateKind>("\"gplvm\"").unwrap_err().to_string();
        assert!(kind.ends_with("`dmp-rhythmic`, `promp`, `ar`"), "{kind}");
        assert_eq!(CandidateKind::all().map(CandidateKind::id).collect::<Vec<_>>(), IDS);
    }
}
