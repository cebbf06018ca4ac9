//! The vCGPDM and, of one part, the vGPDM among the other models.

use crate::gp::NumericsError;
use crate::models::kind::ModelKind;
use crate::models::learner::{Learner, LearningProgress, MovementModel};
use crate::models::movements::Movements;
use crate::models::rollout::{Poser, Roller, RolloutError, check_frames};
use crate::models::settings::VariationalSettings;
use crate::models::training_error::TrainingError;
use crate::models::variational::posterior::{FittedModel, Reading};
use crate::models::variational::trainer::{Trainer, TrainingProgress};
use nalgebra::DMatrix;

/// A training of the variational model. The parts are those of the movements: one for the vGPDM.
pub struct VariationalLearner {
    trainer: Trainer,
}

impl VariationalLearner {
    /// Ready to train. A sequence that is not whole is a short one like any other.
    pub fn new(
        movements: Movements,
        settings: &VariationalSettings,
        seed: u32,
    ) -> Result<Self, TrainingError> {
        let lengths = movements.lengths();
        Ok(Self { trainer: Trainer::new(movements.y, lengths, settings, seed)? })
    }

    /// The training itself, which knows more than all models have in common.
    pub fn trainer(&self) -> &Trainer {
        &self.trainer
    }
}

impl Learner for VariationalLearner {
    fn step(&mut self) -> LearningProgress {
        self.trainer.step().into()
    }

    fn progress(&self) -> LearningProgress {
        self.trainer.progress().into()
    }

    fn model(&self) -> Result<Box<dyn MovementModel>, NumericsError> {
        let fitted = self.trainer.model()?;
        Ok(Box::new(VariationalModel::new(fitted, self.trainer.progress().best)?))
    }
}

impl From<TrainingProgress> for LearningProgress {
    fn from(p: TrainingProgress) -> Self {
        Self {
            iteration: p.iteration,
            max_iterations: p.max_iterations,
            objective: p.bound,
            best: p.best,
            done: p.done,
            reason: p.reason.map(|reason| reason.words("bound")),
            fraction: p.fraction,
        }
    }
}

/// A fitted variational model under its learned couplings.
#[derive(Clone, Debug)]
pub struct VariationalModel {
    fitted: FittedModel,
    poser: Poser,
    bound: f64,
}

impl VariationalModel {
    /// `bound` is the one that `fitted` reached, in nats.
    pub fn new(fitted: FittedModel, bound: f64) -> Result<Self, NumericsError> {
        let poser = Poser::new(&fitted)?;
        Ok(Self { fitted, poser, bound })
    }
}

impl MovementModel for VariationalModel {
    fn kind(&self) -> ModelKind {
        if self.fitted.part_count() == 1 { ModelKind::Vgpdm } else { ModelKind::Vcgpdm }
    }

    fn rollout(&self, sequence: usize, frames: usize) -> Result<Vec<DMatrix<f64>>, RolloutError> {
        check_frames(frames)?;
        let roller = Roller::new(&self.fitted, &self.fitted.alpha, Reading::AsLearned)?;
        let latents = roller.latents(self.fitted.start(sequence)?, frames)?;
        let parts = latents.iter().enumerate();
        Ok(parts.map(|(part, x)| self.poser.observations(part, x)).collect())
    }

    fn stored_numbers(&self) -> usize {
        self.fitted.stored_numbers()
    }

    fn bound(&self) -> Option<f64> {
        Some(self.bound)
    }
}

impl FittedModel {
    /// Inducing inputs, posterior means and kernels of all maps, couplings, and one start.
    pub fn stored_numbers(&self) -> usize {
        let poses = self.parts.iter().map(|p| p.r.len() + p.mean.len() + p.kernel.lambda.len() + 1);
        let experts = self.experts.iter().flatten().map(|e| e.z.len() + e.mean.len() + e.kernel.lambda.len());
        let start = self.parts.iter().map(|p| self.order * p.r.ncols());
        poses.sum::<usize>() + experts.sum::<usize>() + self.alpha.len() + start.sum::<usize>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::movements::Sequence;

    fn movements() -> Movements {
        let wave = |lag: f64| {
            let y = DMatrix::from_fn(60, 3, |t, d| (0.4 * t as f64 + lag + d as f64).sin());
            let mean = y.row_mean();
            DMatrix::from_fn(60, 3, |t, d| y[(t, d)] - mean[d])
        };
        let sequences = [(55, true), (5, false)].map(|(frames, whole)| Sequence { frames, whole }).to_vec();
        Movements { y: vec![wave(0.0), wave(1.0)], sequences }
    }

    fn learned(movements: Movements) -> Box<dyn MovementModel> {
        let settings =
            VariationalSettings { latent: 2, order: 2, dynamics_ips: 6, pose_ips: 5, max_iterations: 60 };
        let mut learner = VariationalLearner::new(movements, &settings, 1).unwrap();
        let mut best = learner.progress().best;
        while !learner.progress().done {
            let progress = learner.step();
            assert!(progress.best >= best && progress.fraction <= 1.0);
            best = progress.best;
        }
        let model = learner.model().unwrap();
        assert_eq!(model.bound(), Some(best));
        model
    }

    #[test]
    fn coupled_and_whole_models_roll_out_from_the_partial_sequence() {
        for (movements, kind, numbers) in [
            // Each pose map: r, E[v], lambda, variance; each expert: z, E[u], lambda; couplings; starts.
            (movements(), ModelKind::Vcgpdm, 2 * (10 + 15 + 2 + 1) + 4 * (24 + 12 + 4) + 4 + 8),
            (movements().as_one_part(), ModelKind::Vgpdm, (10 + 30 + 2 + 1) + (24 + 12 + 4) + 1 + 4),
        ] {
            let model = learned(movements.clone());
            assert_eq!((model.kind(), model.stored_numbers()), (kind, numbers));
            let y = model.rollout(1, 40).unwrap();
            for (rolled, trained) in y.iter().zip(&movements.y) {
                assert_eq!(rolled.shape(), (40, trained.ncols()));
                let start = rolled.rows(0, 2) - trained.rows(55, 2);
                assert!(start.amax() < 0.5, "{start}");
            }
            assert!(model.rollout(2, 40).is_err() && model.rollout(0, 0).is_err());
        }
    }
}
