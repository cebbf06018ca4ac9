//! The jobs of a comparison.

use crate::evaluation::candidate::{Candidate, CandidateKind};
use crate::evaluation::job::Job;
use crate::evaluation::rivals::Rival;
use serde::Deserialize;
use std::collections::HashSet;
use thiserror::Error;
use vcgpdm_core::models::{
    DmpSettings, MapSettings, ModelKind, PoseWeight, Settings, TmpSettings, VariationalSettings,
};

/// The plan of a comparison: the trainings to run.
///
/// ```
/// use vcgpdm_lab::evaluation::Plan;
/// use vcgpdm_core::models::ModelKind;
///
/// let models = vec![ModelKind::Vgpdm.into(), ModelKind::DmpRhythmic.into()];
/// let plan = Plan { models, seeds: vec![0, 1], ..Plan::default() };
/// let jobs = plan.jobs(3)?;
/// // In each of three folds two vGPDMs, and one DMP because a DMP has no random start.
/// assert_eq!(jobs.len(), 9);
/// # Ok::<(), vcgpdm_lab::evaluation::ComparisonPlanError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Plan {
    /// The models to train. A body with one part has no coupled models.
    #[cfg_attr(feature = "types", ts(as = "Vec<vcgpdm_core::models::ModelKind>"))]
    pub models: Vec<CandidateKind>,
    /// Latent dimensions Q of every part.
    pub latent: usize,
    /// Order p of the dynamics and of the autoregression.
    pub order: usize,
    /// Most iterations of the optimiser.
    pub max_iterations: usize,
    /// Numbers of inducing points of each dynamics map of the variational models. Without `poseIps`, each
    /// pose map has the same number.
    pub ips: Vec<usize>,
    /// Numbers of inducing points of each pose map. Each number is combined with each number in `ips`.
    #[cfg_attr(feature = "types", ts(type = "number[]", optional))]
    pub pose_ips: Vec<usize>,
    /// Numbers of primitives of the TMP; null: the bound chooses the number.
    pub primitives: Vec<Option<usize>>,
    /// Whether the TMP is nearer to that of the papers: it uses normalised time, and all trials share its weights.
    #[cfg_attr(feature = "types", ts(type = "boolean", optional))]
    pub normalised_time: bool,
    /// Numbers of basis functions of the DMPs.
    pub bases: Vec<usize>,
    /// Numbers of principal components of the autoregression.
    #[cfg_attr(feature = "types", ts(skip))]
    pub components: Vec<usize>,
    /// Whether the dynamics of the MAP models are balanced.
    pub balanced: bool,
    /// The factor of the pose terms in the objective of the variational models; absent: 1.
    #[cfg_attr(feature = "types", ts(type = "number | \"balanced\"", optional))]
    pub pose_weight: PoseWeight,
    /// Whether the couplings between the parts of the vCGPDM are off; absent: no.
    #[cfg_attr(feature = "types", ts(type = "boolean", optional))]
    pub uncoupled: bool,
    /// Whether the kernels of the MAP models have a linear term.
    #[cfg_attr(feature = "types", ts(type = "boolean", optional))]
    pub linear: bool,
    /// The held-out trials, counted from 0; empty: each trial in turn.
    pub held_out: Vec<usize>,
    /// The seeds of the models with random starts. The other models get the seed 0.
    pub seeds: Vec<u32>,
    /// Numbers of other trials in the training set; empty: all other trials.
    pub training_trials: Vec<usize>,
    /// Whether the plan also trains the coupled models on 1, 2, ... trials. These trainings use the first
    /// fold, the first seed and the middle number of inducing points.
    pub growth: bool,
}

impl Default for Plan {
    /// All kinds of models of the library at the defaults of their settings, in each fold, with seed 0.
    fn default() -> Self {
        let VariationalSettings { latent, order, dynamics_ips, max_iterations, .. } =
            VariationalSettings::default();
        Self {
            models: ModelKind::ALL.map(CandidateKind::from).to_vec(),
            latent,
            order,
            max_iterations,
            ips: vec![dynamics_ips],
            pose_ips: Vec::new(),
            primitives: vec![TmpSettings::default().primitives],
            normalised_time: false,
            bases: vec![DmpSettings::default().bases],
            components: vec![6],
            balanced: false,
            pose_weight: PoseWeight::default(),
            uncoupled: false,
            linear: false,
            held_out: Vec::new(),
            seeds: vec![0],
            training_trials: Vec::new(),
            growth: false,
        }
    }
}

/// Why a plan has no jobs.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum ComparisonPlanError {
    /// The trial to hold out does not exist.
    #[error("expected a trial from 1 to {trials} to hold out, found {}", .found.saturating_add(1))]
    HeldOut {
        /// Number of trials.
        trials: usize,
        /// The trial found, counted from 0.
        found: usize,
    },
    /// There are fewer trials to train on.
    #[error("expected from 1 to {most} trials to train on, found {found}")]
    TrainingTrials {
        /// Number of the trials that are not held out.
        most: usize,
        /// The number found.
        found: usize,
    },
}

impl Plan {
    /// The plan without models that couple parts, for a body in one part.
    pub fn without_coupled(mut self) -> Self {
        self.models.retain(|kind| !kind.is_coupled());
        self
    }

    /// The models with all settings of the plan.
    pub fn candidates(&self) -> Vec<Candidate> {
        self.models.iter().flat_map(|kind| self.candidates_of(*kind)).collect()
    }

    fn candidates_of(&self, kind: CandidateKind) -> Vec<Candidate> {
        let rivals: Vec<Rival> = match kind {
            CandidateKind::Model(kind) => return self.models_of(kind).into_iter().map(Into::into).collect(),
            CandidateKind::ProMp => self.bases.iter().map(|&bases| Rival::ProMp { bases }).collect(),
            CandidateKind::Ar => {
                let order = self.order;
                self.components.iter().map(|&components| Rival::Ar { components, order }).collect()
            }
        };
        rivals.into_iter().map(Into::into).collect()
    }

    fn models_of(&self, kind: ModelKind) -> Vec<Settings> {
        let &Self { latent, order, max_iterations, pose_weight, .. } = self;
        let variational = |candidate: fn(VariationalSettings) -> Settings| {
            let settings = |(dynamics_ips, pose_ips)| VariationalSettings {
                latent,
                order,
                dynamics_ips,
                pose_ips,
                max_iterations,
                pose_weight,
                uncoupled: self.uncoupled && kind == ModelKind::Vcgpdm,
                own_rollouts: false,
            };
            let pairs = self.ips.iter().flat_map(|&dynamics| {
                let poses = if self.pose_ips.is_empty() { vec![dynamics] } else { self.pose_ips.clone() };
                poses.into_iter().map(move |pose| (dynamics, pose))
            });
            pairs.map(settings).map(candidate).collect()
        };
        let (balanced, linear) = (self.balanced, self.linear);
        let map = || MapSettings { latent, order, max_iterations, balanced, linear };
        let dmp = |candidate: fn(DmpSettings) -> Settings| {
            self.bases.iter().map(|&bases| candidate(DmpSettings { bases })).collect()
        };
        match kind {
            ModelKind::Vcgpdm => variational(Settings::Vcgpdm),
            ModelKind::Vgpdm => variational(Settings::Vgpdm),
            ModelKind::MapGpdm => vec![Settings::MapGpdm(map())],
            ModelKind::MapCgpdm => vec![Settings::MapCgpdm(map())],
            ModelKind::Tmp => {
                let primitives = self.primitives.iter();
                primitives
                    .map(|&primitives| {
                        Settings::Tmp(TmpSettings { primitives, normalised_time: self.normalised_time })
                    })
                    .collect()
            }
            ModelKind::DmpDiscrete => dmp(Settings::DmpDiscrete),
            ModelKind::DmpRhythmic => dmp(Settings::DmpRhythmic),
        }
    }

    /// The jobs on `trials` trials, each once. One fold comes after the other, so that the first tables come
    /// early.
    ///
    /// # Errors
    /// A trial to hold out does not exist, or a number of trials to train on is too large.
    pub fn jobs(&self, trials: usize) -> Result<Vec<Job>, ComparisonPlanError> {
        let most = trials.saturating_sub(1);
        let folds = if self.held_out.is_empty() { (0..trials).collect() } else { self.held_out.clone() };
        if let Some(&found) = folds.iter().find(|fold| **fold >= trials) {
            return Err(ComparisonPlanError::HeldOut { trials, found });
        }
        let counts = if self.training_trials.is_empty() { vec![most] } else { self.training_trials.clone() };
        if let Some(&found) = counts.iter().find(|count| !(1..=most).contains(*count)) {
            return Err(ComparisonPlanError::TrainingTrials { most, found });
        }
        let candidates = self.candidates();
        let mut jobs = Vec::new();
        for &held_out in &folds {
            for &training_trials in &counts {
                for candidate in &candidates {
                    let seeds = if candidate.is_random() { &self.seeds[..] } else { &[0] };
                    let job = |&seed| Job { candidate: candidate.clone(), held_out, training_trials, seed };
                    jobs.extend(seeds.iter().map(job));
                }
            }
        }
        if self.growth {
            let fewer = self.growth_jobs(&folds, most);
            jobs.extend(fewer);
        }
        let mut seen = HashSet::new();
        jobs.retain(|job| seen.insert(job.clone()));
        Ok(jobs)
    }

    /// The coupled models on one trial, on two, and so on, up to one less than `most`.
    fn growth_jobs(&self, folds: &[usize], most: usize) -> Vec<Job> {
        let (Some(&held_out), Some(&seed)) = (folds.first(), self.seeds.first()) else { return Vec::new() };
        let coupled = CandidateKind::all().filter(|kind| kind.is_coupled() && self.models.contains(kind));
        coupled
            .filter_map(|kind| {
                let candidates = self.candidates_of(kind);
                candidates.get(candidates.len() / 2).cloned()
            })
            .flat_map(|candidate| {
                (1..most).map(move |training_trials| Job {
                    candidate: candidate.clone(),
                    held_out,
                    training_trials,
                    seed,
                })
            })
            .collect()
    }
}

vcgpdm_core::coded!(ComparisonPlanError => Comparison);

#[cfg(test)]
mod tests {
    use super::*;

    fn plan() -> Plan {
        Plan {
            ips: vec![8, 12, 16],
            bases: vec![10, 20],
            seeds: vec![3, 4],
            max_iterations: 100,
            ..Plan::default()
        }
    }

    #[test]
    fn plans_every_candidate_in_every_fold_with_every_seed() {
        let jobs = plan().jobs(3).unwrap();
        // Three sizes of both variational models and one of both MAP models, twice each; the TMP; two sizes
        // of both DMPs.
        let fold = 2 * (2 * 3 + 2) + 1 + 2 * 2;
        assert_eq!(jobs.len(), 3 * fold);
        assert!(jobs.iter().all(|job| job.training_trials == 2));
        assert!(jobs[..fold].iter().all(|job| job.held_out == 0), "one fold after the other");
        let seeds = |kind: ModelKind| {
            let of_kind = jobs[..fold].iter().filter(|job| job.candidate.kind() == kind);
            of_kind.map(|job| job.seed).collect::<Vec<u32>>()
        };
        assert_eq!(seeds(ModelKind::MapGpdm), [3, 4]);
        assert_eq!(seeds(ModelKind::DmpDiscrete), [0, 0]);
        let some = Plan { held_out: vec![2, 0], training_trials: vec![1, 2], ..plan() };
        let jobs = some.jobs(3).unwrap();
        assert_eq!(jobs.len(), 4 * fold);
        assert_eq!((jobs[0].held_out, jobs[0].training_trials), (2, 1));
        assert_eq!((jobs[fold].held_out, jobs[fold].training_trials), (2, 2));
    }

    #[test]
    fn plans_each_job_once() {
        let once = Plan { held_out: vec![1, 0], training_trials: vec![2, 1], ..plan() };
        let twice = Plan {
            models: [once.models.clone(), once.models.clone()].concat(),
            ips: vec![8, 12, 8, 16],
            primitives: vec![None, None],
            seeds: vec![3, 4, 3],
            held_out: vec![1, 1, 0],
            training_trials: vec![2, 1, 2],
            ..once.clone()
        };
        assert_eq!(twice.jobs(3), once.jobs(3));
    }

    #[test]
    fn growth_trains_the_coupled_models_on_fewer_trials() {
        let whole = plan().jobs(5).unwrap();
        let jobs = Plan { growth: true, ..plan() }.jobs(5).unwrap();
        let (asked, fewer) = jobs.split_at(whole.len());
        assert_eq!(asked, whole);
        let found: Vec<_> = fewer.iter().map(|job| (job.candidate.kind(), job.training_trials)).collect();
        let kinds = [ModelKind::Vcgpdm, ModelKind::MapCgpdm];
        let kinds = kinds.map(CandidateKind::from).into_iter();
        let expected: Vec<_> = kinds.flat_map(|kind| (1..4).map(move |n| (kind, n))).collect();
        assert_eq!(found, expected);
        assert!(fewer.iter().all(|job| (job.held_out, job.seed) == (0, 3)));
        assert!(matches!(&fewer[0].candidate, Candidate::Model(Settings::Vcgpdm(s)) if s.dynamics_ips == 12));
        // No job is planned twice.
        let both = Plan { growth: true, training_trials: vec![1, 2, 3, 4], ..plan() };
        assert_eq!(both.jobs(5), Plan { growth: false, ..both }.jobs(5));
    }

    #[test]
    fn leaves_out_coupled_models_for_a_body_in_one_part() {
        let candidates = plan().without_coupled().candidates();
        let coupled = [ModelKind::Vcgpdm, ModelKind::MapCgpdm];
        assert!(candidates.iter().all(|candidate| coupled.iter().all(|kind| candidate.kind() != *kind)));
        assert_eq!(candidates.len(), 3 + 1 + 1 + 4);
    }

    #[test]
    fn refuses_trials_that_do_not_exist() {
        let error = |plan: Plan| plan.jobs(3).unwrap_err().to_string();
        let held_out = error(Plan { held_out: vec![0, 3], ..plan() });
        assert_eq!(held_out, "expected a trial from 1 to 3 to hold out, found 4");
        let training = error(Plan { training_trials: vec![3], ..plan() });
        assert_eq!(training, "expected from 1 to 2 trials to train on, found 3");
    }

    #[test]
    fn plans_rivals_with_their_sizes() {
        let models = vec![CandidateKind::ProMp, CandidateKind::Ar];
        let rivals = Plan { models, components: vec![4, 9], order: 3, ..plan() }.candidates();
        let expected = [
            Rival::ProMp { bases: 10 },
            Rival::ProMp { bases: 20 },
            Rival::Ar { components: 4, order: 3 },
            Rival::Ar { components: 9, order: 3 },
        ];
        assert_eq!(rivals, expected.map(Candidate::from));
        // They have no seed.
        let jobs = Plan { models: vec![CandidateKind::Ar], ..plan() }.jobs(3).unwrap();
        assert!(jobs.len() == 3 && jobs.iter().all(|job| job.seed == 0));
    }

    #[test]
    fn combines_inducing_points_of_dynamics_and_poses() {
        let grid = Plan { pose_ips: vec![10, 30], models: vec![ModelKind::Vgpdm.into()], ..plan() };
        let pairs: Vec<_> = (grid.candidates().iter())
            .map(|candidate| match candidate {
                Candidate::Model(Settings::Vgpdm(s)) => (s.dynamics_ips, s.pose_ips),
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(pairs, [(8, 10), (8, 30), (12, 10), (12, 30), (16, 10), (16, 30)]);
    }
}
