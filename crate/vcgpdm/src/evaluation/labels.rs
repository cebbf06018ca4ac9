//! What candidates are called beside others of their kind.

use crate::evaluation::results::Results;
use crate::models::{ModelKind, ModelSettings};
use std::collections::HashMap;

/// Names for the candidates of some results: their size, and every setting in which those of a kind differ.
pub struct Labels {
    varying: HashMap<ModelKind, Varying>,
}

/// The settings of a GPDM besides its size.
#[derive(Clone, Copy, PartialEq)]
struct Common {
    latent: usize,
    order: usize,
    max_iterations: usize,
    /// Of the variational models: false.
    balanced: bool,
}

/// In what the candidates of a kind differ.
#[derive(Clone, Copy, Default)]
struct Varying {
    latent: bool,
    order: bool,
    max_iterations: bool,
    balanced: bool,
}

fn common(candidate: &ModelSettings) -> Option<Common> {
    match *candidate {
        ModelSettings::Vcgpdm(ref s) | ModelSettings::Vgpdm(ref s) => Some(Common {
            latent: s.latent,
            order: s.order,
            max_iterations: s.max_iterations,
            balanced: false,
        }),
        ModelSettings::MapGpdm(ref s) | ModelSettings::MapCgpdm(ref s) => Some(Common {
            latent: s.latent,
            order: s.order,
            max_iterations: s.max_iterations,
            balanced: s.balanced,
        }),
        ModelSettings::Tmp(_) | ModelSettings::DmpDiscrete(_) | ModelSettings::DmpRhythmic(_) => None,
    }
}

fn size(candidate: &ModelSettings) -> Option<String> {
    match candidate {
        ModelSettings::Vcgpdm(s) | ModelSettings::Vgpdm(s) => {
            Some(format!("{} + {} inducing points", s.dynamics_ips, s.pose_ips))
        }
        ModelSettings::MapGpdm(_) | ModelSettings::MapCgpdm(_) => None,
        ModelSettings::Tmp(s) => Some(match s.primitives {
            None => "primitives by the bound".to_owned(),
            Some(count) => format!("{count} primitives"),
        }),
        ModelSettings::DmpDiscrete(s) | ModelSettings::DmpRhythmic(s) => Some(format!("{} bases", s.bases)),
    }
}

impl Labels {
    /// For all candidates of these results.
    pub fn of(results: &Results) -> Self {
        let mut first: HashMap<ModelKind, Common> = HashMap::new();
        let mut varying: HashMap<ModelKind, Varying> = HashMap::new();
        for candidate in results.finished.iter().map(|finished| &finished.job.candidate) {
            let Some(now) = common(candidate) else { continue };
            let first = *first.entry(candidate.kind()).or_insert(now);
            let differ = varying.entry(candidate.kind()).or_default();
            differ.latent |= now.latent != first.latent;
            differ.order |= now.order != first.order;
            differ.max_iterations |= now.max_iterations != first.max_iterations;
            differ.balanced |= now.balanced != first.balanced;
        }
        Self { varying }
    }

    /// What a candidate is called.
    pub fn label(&self, candidate: &ModelSettings) -> String {
        let words: Vec<String> = size(candidate).into_iter().chain(self.others(candidate)).collect();
        match common(candidate) {
            Some(settings) if words.is_empty() => format!("Q = {}", settings.latent),
            _ => words.join(", "),
        }
    }

    /// The same without its size.
    pub(super) fn besides_size(&self, candidate: &ModelSettings) -> String {
        self.others(candidate).join(", ")
    }

    fn others(&self, candidate: &ModelSettings) -> Vec<String> {
        let Some(settings) = common(candidate) else { return Vec::new() };
        let differ = self.varying.get(&candidate.kind()).copied().unwrap_or_default();
        let balance = match settings.balanced {
            // Not what the papers do: said even where all are.
            true => Some("balanced"),
            false => differ.balanced.then_some("not balanced"),
        };
        [
            differ.latent.then(|| format!("Q = {}", settings.latent)),
            differ.order.then(|| format!("order {}", settings.order)),
            differ.max_iterations.then(|| format!("{} iterations", settings.max_iterations)),
            balance.map(str::to_owned),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::results::{Finished, Job, Setting};
    use crate::models::{DmpSettings, MapSettings, TmpSettings, VariationalSettings};

    fn gpdm(max_iterations: usize, latent: usize) -> VariationalSettings {
        VariationalSettings { latent, order: 2, dynamics_ips: 12, pose_ips: 8, max_iterations }
    }

    fn point(order: usize, balanced: bool) -> MapSettings {
        MapSettings { latent: 3, order, max_iterations: 100, balanced }
    }

    fn labels(candidates: &[ModelSettings]) -> Vec<String> {
        let setting = Setting { trials: vec![], parts: vec![], frames_per_second: 30.0, start_frames: 5 };
        let mut results = Results::new(setting);
        for candidate in candidates {
            let job = Job { candidate: candidate.clone(), held_out: 1, training_trials: 1, seed: 0 };
            let failure = Some("a test".to_owned());
            results.finished.push(Finished { job, engine: String::new(), outcome: None, failure });
        }
        let labels = Labels::of(&results);
        candidates.iter().map(|candidate| labels.label(candidate)).collect()
    }

    #[test]
    fn labels_name_what_differs_within_a_kind() {
        use ModelSettings::{DmpRhythmic, MapCgpdm, MapGpdm, Tmp, Vcgpdm, Vgpdm};
        assert_eq!(
            labels(&[
                Vcgpdm(gpdm(800, 3)),
                Vcgpdm(gpdm(100, 3)),
                Vgpdm(gpdm(800, 3)),
                Vgpdm(gpdm(800, 2)),
                MapGpdm(point(2, false)),
                MapGpdm(point(1, true)),
                MapCgpdm(point(2, false)),
                Tmp(TmpSettings { primitives: None }),
                DmpRhythmic(DmpSettings { bases: 20 }),
            ]),
            [
                "12 + 8 inducing points, 800 iterations",
                "12 + 8 inducing points, 100 iterations",
                "12 + 8 inducing points, Q = 3",
                "12 + 8 inducing points, Q = 2",
                "order 2, not balanced",
                "order 1, balanced",
                "Q = 3",
                "primitives by the bound",
                "20 bases",
            ]
        );
        assert_eq!(labels(&[MapGpdm(point(2, true))]), ["balanced"]);
    }
}
