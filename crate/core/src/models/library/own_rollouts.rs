//! Primitives that learn from rollouts of the movements that use them.

use crate::gp::NumericsError;
use crate::gp::linalg::{Factor, block_diagonal, symmetric};
use crate::gp::tall::product;
use crate::models::kinds::own_rollouts::{OwnRollouts, is_no_worse};
use crate::models::library::{Library, TrainedLibrary};
use crate::models::variational::FittedExpert;
use std::sync::OnceLock;

impl TrainedLibrary {
    /// Lets the primitives of each learned movement whose rollouts of 20 s do not move on learn from these
    /// rollouts, as [`Model::learn_from_own_rollouts`](crate::models::Model::learn_from_own_rollouts) does.
    /// One movement learns after the other; each keeps the number of its rounds. A movement that moves on, or
    /// has learned from its rollouts, keeps its rows as they are. What makes another movement worse is not kept.
    /// A [`LibraryTrainer`](crate::models::library::LibraryTrainer) does the same in steps.
    pub fn learn_from_own_rollouts(&mut self) {
        let mut rounds = LibraryRollouts::new(self.clone());
        while !rounds.is_done() {
            rounds.step();
        }
        *self = rounds.library;
    }
}

/// A library whose movements learn from their own rollouts, round by round. After each step the best library so far
/// is known.
pub(super) struct LibraryRollouts {
    library: TrainedLibrary,
    /// The movement that learns, or will learn next.
    movement: usize,
    rounds: Option<OwnRollouts>,
    /// The library with the best rounds so far, once it was asked for: to judge all movements takes long.
    judged: OnceLock<TrainedLibrary>,
}

impl LibraryRollouts {
    pub(super) fn new(library: TrainedLibrary) -> Self {
        Self { library, movement: 0, rounds: None, judged: OnceLock::new() }
    }

    /// Judges the next movement, or takes a round with the movement that learns. After the end it does nothing.
    pub(super) fn step(&mut self) {
        let Some(movement) = self.library.library.movements.get(self.movement) else { return };
        if self.rounds.is_none() && movement.sums.is_some() && movement.rollout_rounds == 0 {
            self.rounds = self.library.movement(self.movement).ok().and_then(OwnRollouts::new);
        }
        if let Some(rounds) = &mut self.rounds {
            let best = |rounds: &OwnRollouts| rounds.best().map(|(rounds, _)| rounds);
            let before = best(rounds);
            rounds.step();
            if best(rounds) != before {
                self.judged.take();
            }
            if !rounds.is_done() {
                return;
            }
        }
        if self.rounds.is_some() {
            self.library = self.best().clone();
        }
        self.judged.take();
        self.rounds = None;
        self.movement += 1;
    }

    pub(super) fn is_done(&self) -> bool {
        self.movement >= self.library.library.movements.len()
    }

    /// The share of the work that is done, 0 to 1.
    pub(super) fn fraction(&self) -> f64 {
        let rounds = self.rounds.as_ref().map_or(0.0, OwnRollouts::fraction);
        (self.movement as f64 + rounds) / self.library.library.movements.len().max(1) as f64
    }

    /// The library with the best rounds so far of the movement that learns, if no movement is worse with them.
    pub(super) fn best(&self) -> &TrainedLibrary {
        let learned = || {
            let (rounds, model) = self.rounds.as_ref()?.best()?;
            let mut learned = self.library.clone();
            let movement = &mut learned.library.movements[self.movement];
            movement.sums = Some(model.sums.clone());
            movement.rollout_rounds = rounds;
            learned.library.infer_experts().ok()?;
            let is_no_worse = |index: usize| {
                let [before, after] = [&self.library, &learned].map(|library| library.movement(index).ok());
                before.is_none_or(|before| after.is_some_and(|after| is_no_worse(&after, &before)))
            };
            (0..learned.library.movements.len()).all(is_no_worse).then_some(learned)
        };
        self.judged.get_or_init(|| learned().unwrap_or_else(|| self.library.clone()))
    }
}

impl Library {
    /// Infers the experts of all primitives from the rows of all movements, under their couplings.
    fn infer_experts(&mut self) -> Result<(), NumericsError> {
        for i in 0..self.part_count() {
            let offsets = self.offsets(i);
            let information = self.information_of_all(i, &|_| false);
            let k = block_diagonal(self.primitives.iter().map(|primitive| primitive.experts[i].fitted.k()));
            let a = &k + information.precision;
            let factor = Factor::new(&a, "covariance of the data at the dynamics inducing points")?;
            let mean = product(&k, &factor.solve(&information.b));
            let covariance = symmetric(product(&k, &factor.solve(&k)));
            for (primitive, &at) in self.primitives.iter_mut().zip(&offsets) {
                let expert = &mut primitive.experts[i];
                let (z, kernel) = (expert.fitted.z().clone(), expert.fitted.kernel().clone());
                let points = z.nrows();
                let mean = mean.rows(at, points).into_owned();
                expert.covariance = symmetric(covariance.view((at, at), (points, points)).into_owned());
                expert.fitted = FittedExpert::new(z, kernel, mean, self.jitter)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::models::data::dataset::Dataset;
    use crate::models::kinds::health::Ending;
    use crate::models::kinds::own_rollouts::tests::judged;
    use crate::models::library::{LibraryPlan, LibraryTrainer, PlannedMovement};
    use crate::models::rollout::couplings::Reading;
    use crate::models::training::settings::VariationalSettings;
    use crate::motion::{parts, samples};
    use approx::assert_relative_eq;

    /// A library of walking and of waving while standing.
    pub(in crate::models::library) fn trained(iterations: usize, share_lower: bool) -> TrainedLibrary {
        let clips = ["walk-1", "stand-wave-1"].map(|id| samples::clip(id).unwrap());
        let parts = &parts::presets(&clips[0].skeleton)[1].parts;
        let sources: Vec<_> = clips.iter().map(Into::into).collect();
        let dataset = Dataset::new(&sources, parts, 30.0).unwrap();
        let movements = ["walk", "wave"].map(|name| PlannedMovement { name: name.to_owned(), sequences: 1 });
        let plan = LibraryPlan::new(movements.into(), vec![share_lower, false]).unwrap();
        let settings = VariationalSettings {
            dynamics_ips: 8,
            pose_ips: 8,
            max_iterations: iterations,
            ..Default::default()
        };
        let mut trainer = LibraryTrainer::new(&dataset, &plan, &settings, 0).unwrap();
        trainer.run();
        trainer.finish().unwrap()
    }

    fn endings(library: &TrainedLibrary) -> [Ending; 2] {
        [0, 1].map(|index| judged(&library.movement(index).unwrap()))
    }

    #[test]
    fn movements_that_would_stop_move_on_after_they_learned_from_their_rollouts() {
        let mut library = trained(20, false);
        assert_eq!(endings(&library), [Ending::KeepsOnePose, Ending::StandsStill]);
        // Movements that have learned do not learn again.
        let mut learned = library.clone();
        learned.library.movements.iter_mut().for_each(|movement| movement.rollout_rounds = 1);
        learned.learn_from_own_rollouts();
        assert_eq!(endings(&learned), endings(&library));
        library.learn_from_own_rollouts();
        assert_eq!(endings(&library), [Ending::MovesOn; 2]);
        let rounds = |library: &TrainedLibrary| {
            library.library.movements.iter().map(|movement| movement.rollout_rounds).collect::<Vec<_>>()
        };
        assert!(rounds(&library).iter().all(|rounds| *rounds > 0), "{:?}", rounds(&library));
        let again = TrainedLibrary::from_json(&library.to_json().unwrap()).unwrap();
        assert_eq!(rounds(&again), rounds(&library));
    }

    #[test]
    fn the_best_library_so_far_is_known_after_every_step() {
        let mut library = trained(20, false);
        // Five frames a second: rollouts of 20 s are soon made.
        library.body.frame_time = 0.2;
        let mut rounds = LibraryRollouts::new(library);
        let learned = |rounds: &LibraryRollouts| rounds.best().library.movements[0].rollout_rounds;
        let mut fraction = 0.0;
        while rounds.rounds.as_ref().and_then(OwnRollouts::best).is_none() {
            assert_eq!(learned(&rounds), 0);
            rounds.step();
            assert!((fraction..0.5).contains(&rounds.fraction()), "{fraction} {}", rounds.fraction());
            fraction = rounds.fraction();
        }
        assert!(learned(&rounds) > 0 && fraction > 0.0);
        // Rows with which the other movement would shake: what makes a movement worse is not kept.
        for sums in rounds.library.library.movements[1].sums.iter_mut().flatten() {
            sums.psi1_mu *= 100.0;
        }
        rounds.judged.take();
        assert_eq!(learned(&rounds), 0);
    }

    #[test]
    fn a_library_whose_movements_move_on_stays_as_it_is() {
        let mut library = trained(50, false);
        let before = library.to_json().unwrap();
        assert_eq!(endings(&library), [Ending::MovesOn; 2]);
        library.learn_from_own_rollouts();
        assert_eq!(library.to_json().unwrap(), before);
    }

    #[test]
    fn recorded_rows_alone_give_the_primitives_that_training_gave() {
        let TrainedLibrary { library, .. } = trained(50, true);
        let mut again = library.clone();
        again.infer_experts().unwrap();
        for (found, expected) in again.primitives.iter().zip(&library.primitives) {
            for (found, expected) in found.experts.iter().zip(&expected.experts) {
                assert_relative_eq!(found.fitted.mean(), expected.fitted.mean(), epsilon = 1e-6);
                assert_relative_eq!(found.covariance, expected.covariance, epsilon = 1e-6);
            }
        }
        // So do the rows of a movement, with what the rows of the other one say about a shared primitive.
        let movement = library.movement(0).unwrap();
        let mut again = movement.clone();
        again.infer_experts().unwrap();
        for (found, expected) in again.experts.iter().flatten().zip(movement.experts.iter().flatten()) {
            assert_relative_eq!(found.mean(), expected.mean(), epsilon = 1e-6);
        }
    }

    /// Two movements share the legs, and what one learned changes the other's primitives. Rows, primitives and
    /// couplings of a movement still belong together.
    #[test]
    fn a_movement_inferred_again_after_its_rollouts_is_as_learned() {
        let mut library = trained(20, true);
        library.learn_from_own_rollouts();
        for (index, movement) in library.library.movements.iter().enumerate() {
            assert!(movement.rollout_rounds > 0, "{}", movement.name);
            let model = library.library.movement(index).unwrap();
            let path = |reading| {
                model.dynamics(&model.alpha, reading).unwrap().path(&model.start(0, 0).unwrap(), 30).unwrap()
            };
            for (learned, inferred) in path(Reading::AsLearned).iter().zip(&path(Reading::ReInferred)) {
                assert_relative_eq!(learned, inferred, epsilon = 1e-5);
            }
        }
    }
}
