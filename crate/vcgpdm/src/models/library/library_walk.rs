//! A walk through a library with the body that it moves; it can go back by some frames.

use crate::models::library::{CombinationError, LatentWalk, TrainedLibrary, WalkError};
use crate::motion::pose::{RootStart, RootTrack};
use nalgebra::DMatrix;
use std::collections::VecDeque;

/// The most frames that a walk can go back: more than a page prepares in advance.
pub const REWINDS: usize = 64;

/// The next frames of a walk.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct WalkFrames {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub positions: Vec<f32>,
}

/// The state from which a walk continues.
#[derive(Clone, Debug)]
struct State {
    latents: LatentWalk,
    track: RootTrack,
}

/// A motion without an end, of the primitives of a library, with the body that it moves.
#[derive(Clone, Debug)]
pub struct LibraryWalk {
    /// The latents of the walk.
    pub latents: LatentWalk,
    track: RootTrack,
    /// The state before the newest frames, then the state after each of them, the newest last.
    states: VecDeque<State>,
}

impl TrainedLibrary {
    /// Checks that a walk in this library can continue in `grown`: that library must have the same body and
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

impl LibraryWalk {
    /// A walk of a combination under its nearest couplings, from the origin.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives.
    pub fn new(trained: &TrainedLibrary, uses: &[usize]) -> Result<Self, CombinationError> {
        Ok(Self::begin(trained, LatentWalk::new(&trained.library, uses)?))
    }

    /// A walk from the latents at `place`, a (movement, sequence, frame) counted from 0, and from the origin.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives, or there is no such movement, sequence or frame.
    pub fn from_sequence(
        trained: &TrainedLibrary,
        uses: &[usize],
        place: (usize, usize, usize),
    ) -> Result<Self, WalkError> {
        Ok(Self::begin(trained, LatentWalk::from_sequence(&trained.library, uses, place)?))
    }

    fn begin(trained: &TrainedLibrary, latents: LatentWalk) -> Self {
        let track = trained.body.mapping.track(&RootStart::default());
        let first = State { latents: latents.clone(), track: track.clone() };
        Self { latents, track, states: VecDeque::from([first]) }
    }

    /// The next frames.
    ///
    /// # Errors
    ///
    /// When the number of frames is 0 or too large, or the poses are no longer finite; the walk then stays as
    /// it is.
    pub fn advance(&mut self, trained: &TrainedLibrary, frames: usize) -> Result<WalkFrames, WalkError> {
        let dimensions = trained.library.latent_dimensions();
        trained.body.check_frames(frames, dimensions.iter().sum())?;
        let mut walk = self.latents.clone();
        let mut latents: Vec<_> = dimensions.iter().map(|q| DMatrix::zeros(frames, *q)).collect();
        let mut states = VecDeque::new();
        for t in 0..frames {
            for (path, next) in latents.iter_mut().zip(walk.advance(&trained.library, 1)) {
                path.rows_mut(t, 1).copy_from(&next);
            }
            if frames - t <= REWINDS + 1 {
                states.push_back(walk.clone());
            }
        }
        let parts = trained.library.parts.iter().zip(&latents);
        let observed: Vec<_> = parts.map(|(part, x)| part.observations(x)).collect();
        let y = trained.body.columns(&observed);
        let mapping = &trained.body.mapping;
        let (mut track, earlier) = (self.track.clone(), frames - states.len());
        let mut positions = mapping.continue_positions(&y.rows(0, earlier).into_owned(), &mut track)?;
        let mut newest = VecDeque::new();
        for (k, latents) in states.into_iter().enumerate() {
            let row = y.rows(earlier + k, 1).into_owned();
            positions.extend(mapping.continue_positions(&row, &mut track)?);
            newest.push_back(State { latents, track: track.clone() });
        }
        self.states.extend(newest);
        self.states.drain(..self.states.len().saturating_sub(REWINDS + 1));
        (self.latents, self.track) = (walk, track);
        Ok(WalkFrames { latents, positions })
    }

    /// Goes back by `frames` frames. Changes since then are undone too; 0 frames undo the changes since the
    /// newest frame.
    ///
    /// # Errors
    ///
    /// When the walk does not hold that many frames any more.
    pub fn rewind(&mut self, frames: usize) -> Result<(), WalkError> {
        let left = self.states.len().checked_sub(frames).filter(|left| *left > 0);
        let highest = self.states.len().saturating_sub(1) as f64;
        let error =
            || WalkError::Range { what: "frames to take back", lowest: 0.0, highest, found: frames as f64 };
        self.states.truncate(left.ok_or_else(error)?);
        if let Some(State { latents, track }) = self.states.back().cloned() {
            (self.latents, self.track) = (latents, track);
        }
        Ok(())
    }
}
