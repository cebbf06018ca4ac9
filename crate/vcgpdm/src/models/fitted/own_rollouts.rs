//! A model that learns from its own rollouts, and the choice of the round after which it is best.

use crate::models::fitted::coupled::Coupled;
use crate::models::fitted::fitted_model::FittedModel;
use crate::models::fitted::model::Model;
use crate::models::rollout::couplings::Reading;
use crate::models::rollout::dtw::dtw_mse;
use crate::models::rollout::health::{Health, best_to_show};
use crate::models::rollout::request::{RolloutError, RolloutRequest};
use crate::models::variational::Vcgpdm;
use nalgebra::DMatrix;

/// Rounds of rollouts, ...
const ROUNDS: usize = 20;
/// ... which have this many frames in the first round, ...
const FIRST_FRAMES: usize = 4;
/// ... and this many more in each further round.
const MORE_FRAMES: usize = 2;
/// A model moves on if a rollout of this many seconds does.
const SECONDS: f64 = 20.0;
/// Errors are those of rollouts of the first seconds of the sequences, ...
const SCORED_SECONDS: f64 = 10.0;
/// ... of at most this many sequences.
const SCORED_SEQUENCES: usize = 6;

impl Model {
    /// Lets the dynamics of a vCGPDM or vGPDM whose rollouts of 20 s do not move on learn from these rollouts,
    /// and keeps the best of the models before and after each of 20 rounds: of those whose rollouts move on, the
    /// one whose rollouts repeat the training sequences best (`best_to_show`). The provenance says after which
    /// round. A model that moves on, is of another kind, or has learned from its rollouts, stays as it is.
    ///
    /// Training infers the dynamics from recorded histories, but a rollout reads its own frames. In a round,
    /// rows that lead from the history of a rollout to the recorded frame that should come next have the same
    /// weight as the recorded rows (Venkatraman, Hebert & Bagnell 2015). Only the inducing outputs of the
    /// dynamics change. `docs/training.md` says what it does to models.
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised; the model then stays as it is.
    pub fn learn_from_own_rollouts(&mut self) -> Result<(), RolloutError> {
        let Some(coupled) = self.coupled().filter(|coupled| coupled.provenance.rollout_rounds == 0) else {
            return Ok(());
        };
        if let Some((rounds, model)) = coupled.after_own_rollouts()? {
            self.fitted = FittedModel::Vcgpdm(Box::new(model));
            self.provenance.rollout_rounds = rounds;
        }
        Ok(())
    }
}

impl Coupled<'_> {
    /// The best model after some rounds, with their number, if it is better than the model itself; see
    /// [`Model::learn_from_own_rollouts`].
    ///
    /// # Errors
    ///
    /// When a covariance cannot be factorised.
    pub(in crate::models) fn after_own_rollouts(self) -> Result<Option<(usize, Vcgpdm)>, RolloutError> {
        let judge = Judge::new(self);
        let before = judge.health(self.model)?;
        if before.as_ref().is_some_and(Health::is_good) {
            return Ok(None);
        }
        let rank = |health: Option<Health>| health.map_or(0, |health| health.rank);
        let mut judged = vec![(rank(before), judge.error(self.model)?)];
        let mut models = self.model.after_rounds(ROUNDS, |round| FIRST_FRAMES + MORE_FRAMES * round)?;
        for model in &models {
            judged.push((rank(judge.health(model)?), judge.error(model)?));
        }
        let best = best_to_show(judged).filter(|rounds| *rounds > 0);
        Ok(best.map(|rounds| (rounds, models.swap_remove(rounds - 1))))
    }
}

/// Judges models that have the pose maps and latents of one.
struct Judge<'a> {
    model: Coupled<'a>,
    /// Of the sequences that count, the number and all columns [frames x D] as the pose maps make them.
    sequences: Vec<(usize, DMatrix<f64>)>,
}

impl<'a> Judge<'a> {
    fn new(model: Coupled<'a>) -> Self {
        let most = (SCORED_SECONDS / model.body.frame_time) as usize;
        let whole = model.body.sequences.iter().enumerate().filter(|(_, info)| info.whole);
        let columns = |(sequence, _)| {
            let start: &Vec<DMatrix<f64>> = model.model.starts.get(sequence)?;
            let latents: Vec<_> = start.iter().map(|x| x.rows(0, x.nrows().min(most)).into_owned()).collect();
            Some((sequence, model.body.columns(&model.model.observations(&latents))))
        };
        let sequences = whole.filter_map(columns).take(SCORED_SEQUENCES).collect();
        Self { model, sequences }
    }

    /// The worse health of two rollouts, from the beginning and from the middle of the first sequence; `None`
    /// if a rollout has no poses.
    fn health(&self, model: &Vcgpdm) -> Result<Option<Health>, RolloutError> {
        let coupled = Coupled { model, ..self.model };
        let frames = (SECONDS / self.model.body.frame_time).max(1.0) as usize;
        let mut worse: Option<Health> = None;
        for frame in [0, model.start_frames(0) / 2] {
            let request = RolloutRequest { frames, frame, ..RolloutRequest::default() };
            let rollout = coupled.rollout(&request)?;
            let Ok(positions) = coupled.positions(&rollout) else { return Ok(None) };
            let health = coupled.health(&rollout, &request, &positions)?;
            worse = worse.filter(|worse| worse.rank <= health.rank).or(Some(health));
        }
        Ok(worse)
    }

    /// The sum of the errors of a model's rollouts.
    fn error(&self, model: &Vcgpdm) -> Result<f64, RolloutError> {
        let dynamics = model.dynamics(&model.alpha, Reading::AsLearned)?;
        let mut sum = 0.0;
        for (sequence, recorded) in &self.sequences {
            let path = dynamics.path(&model.start(*sequence, 0)?, recorded.nrows())?;
            let made = self.model.body.columns(&model.observations(&path));
            sum += dtw_mse(&made, recorded).map_or(f64::INFINITY, |score| score.dtw_mse);
        }
        Ok(sum)
    }
}

#[cfg(test)]
pub(in crate::models) mod tests {
    use super::*;
    use crate::models::data::dataset::Dataset;
    use crate::models::rollout::health::Ending;
    use crate::models::training::settings::VariationalSettings;
    use crate::motion::{parts, samples};

    fn trained(iterations: usize) -> Model {
        let clip = samples::clip("walk-1").unwrap();
        let parts = &parts::presets(&clip.skeleton)[1].parts;
        let dataset = Dataset::new(&[(&clip).into()], parts, 30.0).unwrap();
        let settings = VariationalSettings { max_iterations: iterations, ..Default::default() };
        Vcgpdm::fit(&dataset, &settings, 0).unwrap()
    }

    /// How a rollout of 20 s ends.
    pub(in crate::models) fn judged(model: &Model) -> Ending {
        let coupled = model.coupled().unwrap();
        let request = RolloutRequest { frames: 600, ..RolloutRequest::default() };
        let rollout = coupled.rollout(&request).unwrap();
        let positions = coupled.positions(&rollout).unwrap();
        coupled.health(&rollout, &request, &positions).unwrap().state
    }

    #[test]
    fn a_training_that_ended_too_soon_walks_after_it_learned_from_its_rollouts() {
        let mut model = trained(40);
        let before = model.clone();
        assert_ne!(judged(&before), Ending::MovesOn);
        model.learn_from_own_rollouts().unwrap();
        assert_eq!(judged(&model), Ending::MovesOn, "{}", model.provenance.rollout_rounds);
        assert!((1..=ROUNDS).contains(&model.provenance.rollout_rounds));
        // What the rollouts do not change.
        let [old, new] = [&before, &model].map(|model| model.coupled().unwrap().model);
        assert_eq!((&old.parts, &old.alpha, &old.starts), (&new.parts, &new.alpha, &new.starts));
        assert_eq!(old.bound(), new.bound());
        // It learns once, and a file tells so.
        let mut again = Model::from_json(&model.to_json().unwrap()).unwrap();
        assert_eq!(again.provenance, model.provenance);
        again.learn_from_own_rollouts().unwrap();
        assert_eq!(again.provenance, model.provenance);
    }

    #[test]
    fn a_model_that_walks_stays_as_it_is() {
        let mut model = trained(150);
        let before = model.clone();
        assert_eq!(judged(&model), Ending::MovesOn);
        model.learn_from_own_rollouts().unwrap();
        assert_eq!(model.to_json().unwrap(), before.to_json().unwrap());
    }
}
