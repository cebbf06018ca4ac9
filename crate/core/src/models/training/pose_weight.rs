//! The weight of the pose terms in the objective of a variational training.

use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::hash::{Hash, Hasher};
use std::ops::RangeInclusive;

/// The numbers that a weight of the pose terms can be.
pub const POSE_WEIGHTS: RangeInclusive<f64> = 1e-3..=1e3;
/// [`POSE_WEIGHTS`] as text.
pub const POSE_WEIGHTS_TEXT: &str = "a number from 0.001 to 1000";
/// [`PoseWeight::Balanced`] in files.
pub const BALANCED: &str = "balanced";

/// The factor gamma_i of the pose term of part i in the objective of a variational training,
///
/// F_gamma = sum_i gamma_i kinematics_i + sum_i dynamics_i + initial + entropy.
///
/// With the factor 1 this is the bound on the log evidence. A pose term counts D_i columns and a dynamics
/// term Q_i latent dimensions, so the bound prefers good poses to latents that are easy to predict. Smaller
/// factors prefer latents that are easy to predict.
///
/// F_gamma bounds log of the integral over X of p(X) prod_i p(Y^i | X^i)^gamma_i, with a power of the
/// likelihood. It is no bound on the evidence: two objectives are comparable only if weight and data are the
/// same. q(v) has the same closed form with every factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PoseWeight {
    /// The same factor for all parts, from 0.001 to 1000.
    Fixed(f64),
    /// Q_i / D_i: a pose term counts as much as a dynamics term. This is the variational form of the balanced
    /// GPDM (Urtasun, Fleet & Fua 2006).
    Balanced,
}

impl PoseWeight {
    /// Whether the objective is the bound on the log evidence.
    pub fn is_plain(&self) -> bool {
        *self == Self::default()
    }

    /// The factor of a part with Q_i = `latent` dimensions and D_i = `columns`.
    pub(crate) fn factor(self, latent: usize, columns: usize) -> f64 {
        match self {
            Self::Fixed(factor) => factor,
            Self::Balanced => latent as f64 / columns.max(1) as f64,
        }
    }
}

impl Default for PoseWeight {
    /// The factor 1.
    fn default() -> Self {
        Self::Fixed(1.0)
    }
}

// No training has NaN as its weight.
impl Eq for PoseWeight {}

impl Hash for PoseWeight {
    fn hash<H: Hasher>(&self, state: &mut H) {
        let number = match self {
            Self::Fixed(factor) => Some(factor.to_bits()),
            Self::Balanced => None,
        };
        number.hash(state);
    }
}

impl Serialize for PoseWeight {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Fixed(factor) => serializer.serialize_f64(*factor),
            Self::Balanced => serializer.serialize_str(BALANCED),
        }
    }
}

impl<'de> Deserialize<'de> for PoseWeight {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberOrBalanced)
    }
}

struct NumberOrBalanced;

impl Visitor<'_> for NumberOrBalanced {
    type Value = PoseWeight;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{BALANCED}, or {POSE_WEIGHTS_TEXT}")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<PoseWeight, E> {
        Ok(PoseWeight::Fixed(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<PoseWeight, E> {
        self.visit_f64(number as f64)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<PoseWeight, E> {
        self.visit_f64(number as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<PoseWeight, E> {
        if text == BALANCED {
            return Ok(PoseWeight::Balanced);
        }
        Err(E::invalid_value(serde::de::Unexpected::Str(text), &self))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{Settings, VariationalSettings};

    #[test]
    fn a_plain_weight_is_absent_in_json() {
        let json = |pose_weight| {
            let settings = VariationalSettings { pose_weight, ..Default::default() };
            let text = serde_json::to_string(&Settings::Vgpdm(settings.clone())).unwrap();
            assert_eq!(serde_json::from_str::<Settings>(&text).unwrap(), Settings::Vgpdm(settings));
            text
        };
        assert!(!json(PoseWeight::Fixed(1.0)).contains("pose_weight"));
        assert!(json(PoseWeight::Fixed(0.1)).contains(r#""pose_weight":0.1"#));
        assert!(json(PoseWeight::Fixed(2.0)).contains(r#""pose_weight":2.0"#));
        assert!(json(PoseWeight::Balanced).contains(r#""pose_weight":"balanced""#));
        let whole = serde_json::from_str::<PoseWeight>("2").unwrap();
        assert_eq!(whole, PoseWeight::Fixed(2.0));
    }

    #[test]
    fn refuses_other_values() {
        let error = |text| serde_json::from_str::<PoseWeight>(text).unwrap_err().to_string();
        let found = error(r#""even""#);
        assert!(found.contains("\"even\", expected balanced, or a number from 0.001 to 1000"), "{found}");
    }
}
