//! Models that only comparisons know: what else one would try on the same trials. They learn in closed form
//! and have no file of their own.

mod autoregression;
mod promp;
mod sequences;
#[cfg(test)]
mod testing;

use crate::evaluation::predictor::Predictor;
use autoregression::Autoregression;
use promp::ProMp;
use serde::Serialize;
use vcgpdm_core::models::{MOST_BASES, MOST_DIMENSIONS, Movements, TrainingError};

/// A model that only files of results of the terminal program contain. It cannot be trained here.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(tag = "model", rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Rival {
    /// Probabilistic movement primitives (Paraschos et al. 2013).
    #[serde(rename = "promp")]
    ProMp {
        /// Basis functions over the phase, 1 to 200.
        bases: usize,
    },
    /// An autoregression on principal components.
    Ar {
        /// Principal components, 1 to 100.
        components: usize,
        /// Frames of history, 1 to 100.
        order: usize,
    },
}

impl Rival {
    /// Learns from the movements.
    ///
    /// # Errors
    /// A setting is out of its range, or a sequence is too short.
    pub fn fit(&self, movements: &Movements) -> Result<Box<dyn Predictor>, TrainingError> {
        let in_range = |name, found, highest| {
            let valid = (1..=highest).contains(&found);
            if valid { Ok(()) } else { Err(TrainingError::Setting { name, lowest: 1, highest, found }) }
        };
        match *self {
            Rival::ProMp { bases } => {
                in_range("the number of bases", bases, MOST_BASES)?;
                Ok(Box::new(ProMp::fit(movements, bases)?))
            }
            Rival::Ar { components, order } => {
                in_range("the number of principal components", components, MOST_DIMENSIONS)?;
                in_range("the order", order, MOST_DIMENSIONS)?;
                Ok(Box::new(Autoregression::fit(movements, components, order)?))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::cross_validation::{Fold, START_FRAMES};
    use vcgpdm_core::motion::{parts, samples};

    #[test]
    fn predicts_a_walk_with_every_rival() {
        let trials = ["walk-1", "walk-2", "walk-3"].map(|id| samples::clip(id).unwrap());
        let parts = parts::presets(&trials[0].skeleton).into_iter().find(|p| p.id == "lower-upper").unwrap();
        let fold = Fold::new(&trials, 1, 2, &parts.parts, 20.0, START_FRAMES).unwrap();
        let evaluate =
            |rival: Rival| fold.evaluate(&rival.into(), 0, &|| 0.0, &mut |_| true).map(Option::unwrap);
        for rival in [Rival::ProMp { bases: 12 }, Rival::Ar { components: 6, order: 2 }] {
            let outcome = evaluate(rival.clone()).unwrap();
            let (error, variance) = (outcome.score.dtw_mse, outcome.score.variance);
            assert!(error < 0.5 * variance, "{rival:?}: {outcome:?}");
            assert_eq!((outcome.part_errors.len(), outcome.bound), (2, None));
            assert_eq!(outcome.objective, -outcome.training_mse.unwrap());
        }
        let says = |rival| evaluate(rival).unwrap_err().to_string();
        assert_eq!(says(Rival::ProMp { bases: 0 }), "the number of bases must be from 1 to 200, found 0");
        let short = says(Rival::Ar { components: 6, order: 9 });
        assert!(short.contains("walk-2"), "the error names the clip: {short}");
    }
}
