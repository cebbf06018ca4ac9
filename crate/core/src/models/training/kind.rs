//! Kinds of models.

use serde::{Deserialize, Serialize};

/// The kinds of models, in the order of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum ModelKind {
    /// Variational coupled GPDM, two parts or more (Velychko et al. 2018).
    Vcgpdm,
    /// Variational GPDM: all columns are one part.
    Vgpdm,
    /// GPDM with point estimates of the latents, all columns one part (Wang et al. 2008).
    MapGpdm,
    /// Coupled GPDM with point estimates of the latents (Velychko et al. 2014).
    MapCgpdm,
    /// Temporal movement primitives (Clever et al. 2016).
    Tmp,
    /// Dynamic movement primitives towards a goal (Ijspeert et al. 2013).
    DmpDiscrete,
    /// Dynamic movement primitives around a centre (Ijspeert et al. 2013).
    DmpRhythmic,
}

impl ModelKind {
    /// All kinds, in the order in which tables list them.
    pub const ALL: [ModelKind; 7] = [
        ModelKind::Vcgpdm,
        ModelKind::Vgpdm,
        ModelKind::MapGpdm,
        ModelKind::MapCgpdm,
        ModelKind::Tmp,
        ModelKind::DmpDiscrete,
        ModelKind::DmpRhythmic,
    ];

    /// The name in documents and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            ModelKind::Vcgpdm => "vcgpdm",
            ModelKind::Vgpdm => "vgpdm",
            ModelKind::MapGpdm => "map-gpdm",
            ModelKind::MapCgpdm => "map-cgpdm",
            ModelKind::Tmp => "tmp",
            ModelKind::DmpDiscrete => "dmp-discrete",
            ModelKind::DmpRhythmic => "dmp-rhythmic",
        }
    }

    /// The name as the papers write it.
    pub fn title(self) -> &'static str {
        match self {
            ModelKind::Vcgpdm => "vCGPDM",
            ModelKind::Vgpdm => "vGPDM",
            ModelKind::MapGpdm => "MAP GPDM",
            ModelKind::MapCgpdm => "MAP CGPDM",
            ModelKind::Tmp => "TMP",
            ModelKind::DmpDiscrete => "DMP (discrete)",
            ModelKind::DmpRhythmic => "DMP (rhythmic)",
        }
    }

    /// The kind of this name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.id() == id)
    }

    /// Whether the model couples the parts of a body.
    pub fn is_coupled(self) -> bool {
        matches!(self, ModelKind::Vcgpdm | ModelKind::MapCgpdm)
    }

    /// Whether training starts with random numbers, so that another seed gives another model.
    pub fn is_random(self) -> bool {
        match self {
            ModelKind::Vcgpdm | ModelKind::Vgpdm | ModelKind::MapGpdm | ModelKind::MapCgpdm => true,
            ModelKind::Tmp | ModelKind::DmpDiscrete | ModelKind::DmpRhythmic => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_every_id() {
        for kind in ModelKind::ALL {
            assert_eq!(ModelKind::from_id(kind.id()), Some(kind));
            assert_eq!(serde_json::to_string(&kind).unwrap(), format!("\"{}\"", kind.id()));
        }
        assert_eq!(ModelKind::from_id("gplvm"), None);
    }
}
