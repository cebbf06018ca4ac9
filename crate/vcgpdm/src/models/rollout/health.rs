//! Health of a rollout: whether it keeps moving, stands still, leaves the range of its training or breaks
//! down.

use crate::gp::NumericsError;
use crate::models::fitted::coupled::Coupled;
use crate::models::rollout::request::{Rollout, RolloutRequest};
use crate::motion::measures::still_from;
use std::cmp::Ordering;

/// A part is outside the range of its training when its inducing points explain less than this share of the
/// variance.
const FAMILIAR: f64 = 0.5;
/// A part has left the range when it is outside for at least this long until the end; in seconds.
const AWAY_FOR: f64 = 1.0;
/// A rollout rests as recorded when it rests at most this much earlier than its recording; in seconds.
const EARLY: f64 = 0.5;

/// How a rollout ends, in seconds from its first frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Health {
    /// It keeps moving, with every part in the range of its training.
    MovesOn,
    /// No joint moves from this time until the end; see `still_from`.
    StandsStill {
        /// Seconds.
        from: f64,
    },
    /// It stands still in the end, as does its recording at nearly the same time.
    RestsAsRecorded {
        /// Seconds.
        from: f64,
    },
    /// From this time until the end, the latents of a part are far from those of the training; see
    /// `Vcgpdm::familiarity`.
    LeavesTraining {
        /// Seconds.
        from: f64,
        /// The first part that leaves, counted from 0.
        part: usize,
    },
    /// A latent or position is not a finite number.
    NotFinite,
}

impl Health {
    /// Rank for the choice among several models of one data set; higher is better. The bound decides between
    /// models of the same rank.
    pub fn rank(&self) -> u8 {
        match self {
            Health::MovesOn | Health::RestsAsRecorded { .. } => 2,
            Health::StandsStill { .. } | Health::LeavesTraining { .. } => 1,
            Health::NotFinite => 0,
        }
    }
}

/// The model to show among several of one data set, each given as its [rank](Health::rank) and its bound in
/// nats: the highest bound of the highest rank, the first of equals. `None` without a model.
pub fn best_to_show(models: impl IntoIterator<Item = (u8, f64)>) -> Option<usize> {
    let better = |a: (u8, f64), b: (u8, f64)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1));
    let first = |best: (usize, (u8, f64)), next: (usize, (u8, f64))| {
        if better(next.1, best.1) == Ordering::Greater { next } else { best }
    };
    models.into_iter().enumerate().reduce(first).map(|(place, _)| place)
}

impl Coupled<'_> {
    /// The health of the rollout of `request`, with its positions from [`Coupled::positions`]. A rollout that
    /// both stands still and is far from its training counts as standing still, which a viewer can see.
    ///
    /// # Errors
    ///
    /// When a covariance of inducing points cannot be factorised.
    pub fn health(
        &self,
        rollout: &Rollout,
        request: &RolloutRequest,
        positions: &[f32],
    ) -> Result<Health, NumericsError> {
        let latents = &rollout.latents;
        if !latents.iter().all(|path| path.iter().all(|x| x.is_finite()))
            || !positions.iter().all(|place| place.is_finite())
        {
            return Ok(Health::NotFinite);
        }
        let frame_time = self.body.frame_time;
        if let Some(from) = still_from(self.body.mapping.skeleton(), positions, frame_time) {
            let recorded = self.body.sequences.get(request.sequence).and_then(|info| info.rests_from);
            // The rollout may start at a later frame of the recording.
            let start = request.frame as f64 * frame_time;
            let rests = recorded.is_some_and(|rest| start + from >= rest - EARLY);
            return Ok(if rests { Health::RestsAsRecorded { from } } else { Health::StandsStill { from } });
        }
        let familiarity = self.model.familiarity(latents)?;
        let away = familiarity.iter().enumerate().filter_map(|(part, shares)| {
            let frames = shares.iter().rev().take_while(|share| **share < FAMILIAR).count();
            let from = (shares.len() - frames) as f64 * frame_time;
            (frames as f64 * frame_time >= AWAY_FOR).then_some((from, part))
        });
        let first = away.min_by(|a, b| a.0.total_cmp(&b.0));
        Ok(first.map_or(Health::MovesOn, |(from, part)| Health::LeavesTraining { from, part }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::data::dataset::Dataset;
    use crate::models::fitted::model::Model;
    use crate::models::training::settings::VariationalSettings;
    use crate::models::training::trainer::Trainer;
    use crate::motion::{parts, samples};
    use nalgebra::DMatrix;

    /// A model, and a rollout of the recorded walk with its latents at the inducing points.
    fn walk() -> (Model, Rollout) {
        let clip = samples::clip("walk-1").unwrap();
        let parts = &parts::presets(&clip.skeleton)[1].parts;
        let dataset = Dataset::new(&[(&clip).into()], parts, 30.0).unwrap();
        let settings = VariationalSettings {
            latent: 2,
            order: 2,
            dynamics_ips: 4,
            pose_ips: 4,
            max_iterations: 1,
            ..Default::default()
        };
        let trainer = Trainer::new(&dataset, &settings.into(), 1).unwrap();
        let model = trainer.finish().unwrap();
        let y = model.body.columns(&dataset.y);
        let latents = model.coupled().unwrap().model.parts.iter().map(|part| {
            let r = part.r();
            DMatrix::from_fn(y.nrows(), r.ncols(), |t, q| r[(t % r.nrows(), q)])
        });
        let rollout = Rollout { latents: latents.collect(), y, weights: DMatrix::from_element(2, 2, 0.5) };
        (model, rollout)
    }

    fn health(model: &Model, rollout: &Rollout) -> Health {
        let model = model.coupled().unwrap();
        model.health(rollout, &RolloutRequest::default(), &model.positions(rollout).unwrap()).unwrap()
    }

    #[test]
    fn a_walk_moves_on_until_it_stands_still() {
        let (model, mut rollout) = walk();
        assert_eq!(health(&model, &rollout), Health::MovesOn);
        // From frame 60 on, the pose does not change.
        let pose = rollout.y.row(60).into_owned();
        for t in 60..rollout.y.nrows() {
            rollout.y.set_row(t, &pose);
        }
        let Health::StandsStill { from } = health(&model, &rollout) else { panic!("it stands still") };
        assert!((from - 2.0).abs() < 0.1, "{from}");
    }

    #[test]
    fn a_rollout_may_rest_where_its_recording_rests() {
        let (mut model, mut rollout) = walk();
        let pose = rollout.y.row(60).into_owned();
        for t in 60..rollout.y.nrows() {
            rollout.y.set_row(t, &pose);
        }
        for (recorded, rests) in [(None, false), (Some(1.5), true), (Some(2.3), true), (Some(3.0), false)] {
            model.body.sequences[0].rests_from = recorded;
            let found = health(&model, &rollout);
            assert_eq!(matches!(found, Health::RestsAsRecorded { .. }), rests, "{recorded:?} {found:?}");
        }
        // The same motion, started at a later frame of the recording.
        let request = RolloutRequest { frame: 30, ..RolloutRequest::default() };
        let model = model.coupled().unwrap();
        let found = model.health(&rollout, &request, &model.positions(&rollout).unwrap()).unwrap();
        assert!(matches!(found, Health::RestsAsRecorded { .. }), "{found:?}");
    }

    #[test]
    fn models_that_keep_moving_come_before_higher_bounds() {
        let (moves, still) = (Health::MovesOn.rank(), Health::StandsStill { from: 2.0 }.rank());
        let broken = Health::NotFinite.rank();
        assert_eq!(best_to_show([]), None);
        assert_eq!(best_to_show([(still, 30.0), (moves, 10.0), (moves, 20.0), (moves, 20.0)]), Some(2));
        assert_eq!(best_to_show([(broken, 90.0), (still, 10.0), (still, 20.0)]), Some(2));
    }

    #[test]
    fn a_part_that_leaves_its_training_is_named() {
        let (model, mut rollout) = walk();
        for t in 45..rollout.y.nrows() {
            rollout.latents[1][(t, 0)] += 1000.0;
        }
        let Health::LeavesTraining { from, part } = health(&model, &rollout) else { panic!("it leaves") };
        assert!((from - 1.5).abs() < 0.01 && part == 1, "{from} {part}");
        // The part returns at the end.
        let last = rollout.y.nrows() - 1;
        rollout.latents[1][(last, 0)] -= 1000.0;
        assert_eq!(health(&model, &rollout), Health::MovesOn);
    }

    #[test]
    fn reports_numbers_that_are_not_finite() {
        let (model, mut rollout) = walk();
        let positions = model.coupled().unwrap().positions(&rollout).unwrap();
        rollout.latents[0][(7, 0)] = f64::NAN;
        assert_eq!(
            model.coupled().unwrap().health(&rollout, &RolloutRequest::default(), &positions).unwrap(),
            Health::NotFinite
        );
    }
}
