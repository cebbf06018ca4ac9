//! Motions without an end of combinations of primitives, which are exchanged on the way.

use crate::models::errors::CouplingsError;
use crate::models::kinds::endless::Endless;
use crate::models::library::{CombinationError, Misfit, TrainedLibrary};
use crate::models::rollout::couplings::Reading;
use crate::models::rollout::request::RolloutError;
use nalgebra::DMatrix;
use std::sync::Arc;
use thiserror::Error;

/// Why a motion of primitives cannot begin or continue.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WalkError {
    /// The primitives do not fit the parts.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// The library moves another body.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// The library has other primitives.
    #[error("expected a library with all primitives of the one before, in the same places")]
    Primitives,
    /// The motion cannot begin there, or not continue so.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
}

impl From<CouplingsError> for WalkError {
    fn from(reason: CouplingsError) -> Self {
        Self::Rollout(reason.into())
    }
}

impl TrainedLibrary {
    /// A motion without an end of a combination under its nearest couplings, from its first start latents and
    /// from the origin.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives.
    pub fn endless(&self, uses: &[usize]) -> Result<Endless, WalkError> {
        let library = &self.library;
        library.check_uses(uses)?;
        let start = library.starts(uses).into_iter().next().unwrap_or_else(|| library.zero_start());
        self.begin(uses, &start)
    }

    /// As [`endless`](Self::endless), from a frame of a sequence of a movement: `place` is (movement, sequence,
    /// frame), counted from 0. A part with another primitive than in the movement starts at its
    /// [`nearest_state`](crate::models::library::Library::nearest_state).
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives, or there is no such movement, sequence or frame.
    pub fn endless_from(
        &self,
        uses: &[usize],
        (movement, sequence, frame): (usize, usize, usize),
    ) -> Result<Endless, WalkError> {
        let library = &self.library;
        library.check_uses(uses)?;
        let unknown = CombinationError::Movement { count: library.movements.len(), found: movement };
        let movement = library.movements.get(movement).ok_or(unknown)?;
        let within = |what: &'static str, count: usize, found: usize| {
            let highest = count.saturating_sub(1) as f64;
            let error = RolloutError::Range { what, lowest: 0.0, highest, found: found as f64 };
            if found < count { Ok(()) } else { Err(error) }
        };
        within("a sequence of the movement", movement.starts.len(), sequence)?;
        let rows = movement.starts[sequence].iter().map(DMatrix::nrows).min().unwrap_or(0);
        let frames = (rows + 1).saturating_sub(library.order);
        within("a frame of the sequence with a whole history", frames, frame)?;
        self.begin(uses, &library.window(uses, movement, sequence, frame))
    }

    fn begin(&self, uses: &[usize], start: &[DMatrix<f64>]) -> Result<Endless, WalkError> {
        let model = self.combination(uses, &self.library.nearest_couplings(uses))?;
        let start: Vec<_> = start.iter().map(|x| x.rows(0, self.library.order).into_owned()).collect();
        Ok(Endless::of_primitives(Arc::new(model), uses, &start)?)
    }

    /// Gives a part of a motion another of its primitives, at its [`nearest_state`](crate::models::library::Library::nearest_state);
    /// where there is none, the part continues from its own state. The other parts do not change. With `alpha`
    /// [M x M], also sets the couplings.
    ///
    /// # Errors
    ///
    /// When the primitive is not one of the part, or the couplings do not fit; nothing changes then.
    pub fn use_primitive(
        &self,
        endless: &mut Endless,
        part: usize,
        primitive: usize,
        alpha: Option<DMatrix<f64>>,
    ) -> Result<(), WalkError> {
        let mut uses = endless.uses().to_vec();
        let expected = uses.len();
        *uses.get_mut(part).ok_or(CombinationError::Count { expected, found: part + 1 })? = primitive;
        let model = self.combination(&uses, &self.library.nearest_couplings(&uses))?;
        let state = self.library.nearest_state(primitive, &endless.histories(), &[]);
        let mut next = endless.clone();
        next.use_primitives(Arc::new(model), uses, part, state.as_ref())?;
        if let Some(alpha) = alpha {
            next.set_couplings(alpha, Reading::AsLearned)?;
        }
        *endless = next;
        Ok(())
    }

    /// Checks that a motion of this library can continue in `grown`: that library must have the same body and
    /// pose maps, and begin with all primitives of this one.
    ///
    /// # Errors
    ///
    /// When the body, a pose map or a primitive differs.
    pub fn check_growth(&self, grown: &TrainedLibrary) -> Result<(), WalkError> {
        self.check_fit(grown)?;
        if grown.library.primitives.starts_with(&self.library.primitives) {
            return Ok(());
        }
        Err(WalkError::Primitives)
    }
}

crate::coded!(WalkError {
    Self::Combination(reason) => reason.code(),
    Self::Rollout(reason) => reason.code(),
    _ => Rollout,
});

#[cfg(test)]
mod tests {
    use crate::models::library::own_rollouts::tests::trained;

    #[test]
    fn a_motion_begins_at_the_latest_at_the_last_frame_with_a_whole_history() {
        let trained = trained(1, false);
        let (library, frames) = (&trained.library, trained.library.movements[0].starts[0][0].nrows());
        let last = frames - library.order;
        assert!(trained.endless_from(&[0, 2], (0, 0, last)).is_ok());
        let refused = trained.endless_from(&[0, 2], (0, 0, last + 1)).unwrap_err().to_string();
        assert!(refused.contains(&format!("from 0 to {last}, found {}", last + 1)), "{refused}");
    }
}
