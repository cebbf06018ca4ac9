//! The candidates of a comparison: models of the library, and rivals that only comparisons know.

use crate::evaluation::rivals::Rival;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};
use vcgpdm::models::{ModelKind, Settings, TrainingCost};

/// A model of a comparison with its settings. In files, the field `model` is the [id](CandidateKind::id).
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(untagged)]
pub enum Candidate {
    /// A model of the library.
    Model(Settings),
    /// Another model, to compare the models of the library with.
    Rival(Rival),
}

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

impl<'de> Deserialize<'de> for Candidate {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let fields = Map::<String, Value>::deserialize(deserializer)?;
        let kind = fields.get("model").and_then(Value::as_str).and_then(CandidateKind::from_id);
        let value = Value::Object(fields);
        let candidate = match kind {
            Some(CandidateKind::ProMp | CandidateKind::Ar) => Rival::deserialize(value).map(Candidate::Rival),
            Some(CandidateKind::Model(_)) | None => Settings::deserialize(value).map(Candidate::Model),
        };
        candidate.map_err(D::Error::custom)
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
        Self::from_id(&id).ok_or_else(|| {
            let ids: Vec<&str> = Self::all().map(Self::id).collect();
            D::Error::custom(format!("unknown model `{id}`, expected one of {}", ids.join(", ")))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm::models::DmpSettings;

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
        assert!(kind.starts_with("unknown model `gplvm`, expected one of vcgpdm,"), "{kind}");
    }
}
