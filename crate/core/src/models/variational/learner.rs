//! Training of the vCGPDM and, with one part, of the vGPDM through the interface of all models.

use crate::models::data::movements::Movements;
use crate::models::errors::TrainingError;
use crate::models::training::interface::Training;
use crate::models::training::progress::Progress;
use crate::models::training::settings::VariationalSettings;
use crate::models::variational::trainer::VariationalTrainer;
use nalgebra::DMatrix;

/// A training of the variational model. The parts are those of the movements: one for the vGPDM.
pub struct VariationalLearner {
    pub(in crate::models) trainer: VariationalTrainer,
}

impl VariationalLearner {
    /// Ready to train. A sequence that is not whole is treated as a short sequence.
    ///
    /// # Errors
    ///
    /// When a setting is out of its range, or the movements cannot be learned from.
    pub fn new(
        movements: Movements,
        settings: &VariationalSettings,
        seed: u32,
    ) -> Result<Self, TrainingError> {
        let lengths = movements.lengths();
        Ok(Self { trainer: VariationalTrainer::new(movements.y, lengths, settings, seed)? })
    }
}

impl Training for VariationalLearner {
    fn step(&mut self) -> Progress {
        self.trainer.step()
    }

    #[cfg(feature = "threads")]
    fn use_threads(&mut self, threads: usize) {
        self.trainer.use_threads(threads);
    }

    fn progress(&self) -> Progress {
        self.trainer.progress()
    }

    fn extend(&mut self, iterations: usize) {
        self.trainer.extend(iterations);
    }

    fn latents(&self, part: usize) -> Option<DMatrix<f64>> {
        self.trainer.best().parts.get(part).map(|part| part.latents.mean.clone())
    }

    fn notices(&self) -> &[String] {
        self.trainer.notices()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::data::movements::Sequence;
    use crate::models::training::kind::ModelKind;
    use crate::models::{FittedModel, Learner};

    fn movements() -> Movements {
        let wave = |lag: f64| {
            let y = DMatrix::from_fn(60, 3, |t, d| (0.4 * t as f64 + lag + d as f64).sin());
            let mean = y.row_mean();
            DMatrix::from_fn(60, 3, |t, d| y[(t, d)] - mean[d])
        };
        let sequences = [(55, true), (5, false)].map(|(frames, whole)| Sequence { frames, whole }).to_vec();
        Movements { y: vec![wave(0.0), wave(1.0)], sequences }
    }

    fn learned(movements: Movements) -> FittedModel {
        let settings = VariationalSettings {
            latent: 2,
            order: 2,
            dynamics_ips: 6,
            pose_ips: 5,
            max_iterations: 60,
            ..Default::default()
        };
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
