//! Whether a rollout is still a motion: what a page may show as a success, and what it must say otherwise.

use crate::gp::NumericsError;
use crate::models::rollout::Rollout;
use crate::models::trained::TrainedModel;
use crate::models::variational::Vcgpdm;
use crate::motion::measures::still_from;

/// A part has left the range of its training where its inducing points explain less than this share of the variance.
const FAMILIAR: f64 = 0.5;
/// A part has left for good when it is away for at least this long, to the end; in seconds.
const AWAY_FOR: f64 = 1.0;

/// How a rollout ends, in seconds from its first frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Health {
    /// It keeps moving, in every part like what the model was trained on.
    MovesOn,
    /// No joint moves any more from here to the end; see [`still_from`](crate::motion::measures::still_from).
    StandsStill {
        /// Seconds.
        from: f64,
    },
    /// From here to the end the latents of a part are far from those of the training; see [`Vcgpdm::familiarity`].
    LeavesTraining {
        /// Seconds.
        from: f64,
        /// The first part that leaves, counted from 0.
        part: usize,
    },
    /// It has latents or places that are not finite numbers.
    NotFinite,
}

impl TrainedModel<Vcgpdm> {
    /// How a rollout of this model ends, where `positions` are those that [`TrainedModel::positions`] gives for it. A rollout that
    /// both stands still and is far from its training is said to stand still, for this can be seen.
    ///
    /// # Errors
    ///
    /// When a covariance of inducing points cannot be factorised.
    pub fn health(&self, rollout: &Rollout, positions: &[f32]) -> Result<Health, NumericsError> {
        let latents = &rollout.latents;
        if !latents.iter().all(|path| path.iter().all(|x| x.is_finite()))
            || !positions.iter().all(|place| place.is_finite())
        {
            return Ok(Health::NotFinite);
        }
        let frame_time = self.body.frame_time;
        if let Some(from) = still_from(self.body.mapping.skeleton(), positions, frame_time) {
            return Ok(Health::StandsStill { from });
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
