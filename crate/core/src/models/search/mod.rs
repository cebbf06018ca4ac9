//! The search for the parameters of the largest objective.

pub(crate) mod ascent;
pub(crate) mod optimizer;
pub(crate) mod parameters;

use crate::plural::counted;
use serde::Serialize;
use std::fmt;

pub use ascent::{Phase, SearchEnd};

/// Numerical failures that a training survived.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Setbacks {
    /// Factorisations of a covariance that failed, and were tried again with jitter on its diagonal.
    pub jittered: usize,
    /// Evaluations that gave no finite number even so: the search turned back there.
    pub turned_back: usize,
}

impl Setbacks {
    /// Whether there were any.
    pub fn any(self) -> bool {
        self != Self::default()
    }
}

impl fmt::Display for Setbacks {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { jittered, turned_back } = *self;
        write!(
            f,
            "{} needed jitter on the diagonal, and the search turned back from {} that gave no finite number",
            counted(jittered, "covariance"),
            counted(turned_back, "point")
        )
    }
}
