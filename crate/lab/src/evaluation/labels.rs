//! Short names of candidates among others of their kind.

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::candidate_text::{Common, LINEAR, UNCOUPLED, balance, common, size, weight};
use crate::evaluation::results::Results;
use std::collections::HashMap;

/// Short names of candidates: their size, and every setting in which candidates of a kind differ.
pub struct Labels {
    varying: HashMap<CandidateKind, Varying>,
}

/// The settings in which the candidates of a kind differ.
#[derive(Clone, Copy, Default)]
struct Varying {
    latent: bool,
    order: bool,
    max_iterations: bool,
    balanced: bool,
}

impl Labels {
    /// Names for all candidates of these results.
    pub fn new(results: &Results) -> Self {
        Self::of_several(&[results])
    }

    /// Names for all candidates of several comparisons.
    pub(super) fn of_several(several: &[&Results]) -> Self {
        let finished = several.iter().flat_map(|results| results.finished());
        Self::of_candidates(finished.map(|finished| &finished.job.candidate))
    }

    /// Names for these candidates.
    pub fn of_candidates<'a>(candidates: impl Iterator<Item = &'a Candidate>) -> Self {
        let mut first: HashMap<CandidateKind, Common> = HashMap::new();
        let mut varying: HashMap<CandidateKind, Varying> = HashMap::new();
        for candidate in candidates {
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

    /// The short name of a candidate.
    pub fn label(&self, candidate: &Candidate) -> String {
        let words: Vec<String> = size(candidate).into_iter().chain(self.others(candidate)).collect();
        match common(candidate) {
            Some(settings) if words.is_empty() => format!("Q = {}", settings.latent),
            _ => words.join(", "),
        }
    }

    /// The short name without the size.
    pub(super) fn without_size(&self, candidate: &Candidate) -> String {
        self.others(candidate).join(", ")
    }

    fn others(&self, candidate: &Candidate) -> Vec<String> {
        let Some(settings) = common(candidate) else { return Vec::new() };
        let differ = self.varying.get(&candidate.kind()).copied().unwrap_or_default();
        // The papers do not balance: a balanced model is named even if all are balanced.
        let balanced = settings.balanced.filter(|balanced| *balanced || differ.balanced);
        [
            differ.latent.then(|| format!("Q = {}", settings.latent)),
            differ.order.then(|| format!("order {}", settings.order)),
            differ.max_iterations.then(|| format!("{} iterations", settings.max_iterations)),
            balanced.map(|balanced| balance(balanced).to_owned()),
            weight(settings.pose_weight),
            settings.uncoupled.then(|| UNCOUPLED.to_owned()),
            settings.linear.then(|| LINEAR.to_owned()),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::job::{Finished, Job};
    use crate::evaluation::testing::setting;
    use vcgpdm_core::models::{
        DmpSettings, MapSettings, PoseWeight, Settings, TmpSettings, VariationalSettings,
    };

    fn gpdm(max_iterations: usize, latent: usize) -> VariationalSettings {
        VariationalSettings {
            latent,
            order: 2,
            dynamics_ips: 12,
            pose_ips: 8,
            max_iterations,
            ..Default::default()
        }
    }

    fn point(order: usize, balanced: bool) -> MapSettings {
        MapSettings { latent: 3, order, max_iterations: 100, balanced, linear: false }
    }

    fn labels(candidates: &[Settings]) -> Vec<String> {
        let candidates: Vec<Candidate> = candidates.iter().cloned().map(Candidate::from).collect();
        let mut results = Results::new(setting(2));
        for candidate in &candidates {
            let job = Job { candidate: candidate.clone(), held_out: 0, training_trials: 1, seed: 0 };
            results.add(Finished::new(job, Err("a test".to_owned()))).unwrap();
        }
        let labels = Labels::new(&results);
        candidates.iter().map(|candidate| labels.label(candidate)).collect()
    }

    #[test]
    fn names_the_settings_that_differ_within_a_kind() {
        use Settings::{DmpRhythmic, MapCgpdm, MapGpdm, Tmp, Vcgpdm, Vgpdm};
        assert_eq!(
            labels(&[
                Vcgpdm(gpdm(800, 3)),
                Vcgpdm(gpdm(100, 3)),
                Vgpdm(gpdm(800, 3)),
                Vgpdm(gpdm(800, 2)),
                MapGpdm(point(2, false)),
                MapGpdm(point(1, true)),
                MapCgpdm(point(2, false)),
                Tmp(TmpSettings::default()),
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
        let weighted = |pose_weight| Vgpdm(VariationalSettings { pose_weight, ..gpdm(800, 3) });
        assert_eq!(
            labels(&[weighted(PoseWeight::Balanced), weighted(PoseWeight::Fixed(0.1)), Vgpdm(gpdm(800, 3))]),
            [
                "12 + 8 inducing points, balanced",
                "12 + 8 inducing points, pose weight 0.1",
                "12 + 8 inducing points",
            ]
        );
    }
}
