//! A walk with its body, which can go back to what it was a moment ago.

use crate::models::library::{CombinationError, LatentWalk, TrainedLibrary, WalkError};
use crate::motion::pose::{RootStart, RootTrack};
use nalgebra::DMatrix;
use std::collections::VecDeque;

/// So many frames can be taken back: more than a page has ready before its clock needs them.
pub const REWINDS: usize = 64;

/// The next frames of a walk.
#[derive(Clone, Debug)]
pub struct WalkFrames {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub positions: Vec<f32>,
}

/// What a walk goes on from.
#[derive(Clone, Debug)]
struct State {
    latents: LatentWalk,
    track: RootTrack,
}

/// A walk with its body.
#[derive(Clone, Debug)]
pub struct LibraryWalk {
    /// Its latents.
    pub latents: LatentWalk,
    track: RootTrack,
    /// As it was when each of its last frames had been made, the newest last; before them the one that they
    /// go on from.
    states: VecDeque<State>,
}

impl TrainedLibrary {
    /// Checks that a walk in this library can go on in one that it has grown into: with the same body, pose
    /// maps and primitives, and more.
    ///
    /// # Errors
    ///
    /// When something of this library is not in the other as it was.
    pub fn check_growth(&self, grown: &TrainedLibrary) -> Result<(), WalkError> {
        self.check_fit(grown)?;
        if grown.library.primitives.starts_with(&self.library.primitives) {
            return Ok(());
        }
        Err(WalkError::Primitives)
    }
}

impl LibraryWalk {
    /// As `LatentWalk::new`, from the origin.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives.
    pub fn new(trained: &TrainedLibrary, uses: &[usize]) -> Result<Self, CombinationError> {
        Ok(Self::begin(trained, LatentWalk::new(&trained.library, uses)?))
    }

    /// As `LatentWalk::from_sequence`, from the origin.
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
    /// When the poses are no longer finite; the walk then stays where it is.
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
        let mut made = VecDeque::new();
        for (k, latents) in states.into_iter().enumerate() {
            let row = y.rows(earlier + k, 1).into_owned();
            positions.extend(mapping.continue_positions(&row, &mut track)?);
            made.push_back(State { latents, track: track.clone() });
        }
        self.states.extend(made);
        self.states.drain(..self.states.len().saturating_sub(REWINDS + 1));
        (self.latents, self.track) = (walk, track);
        Ok(WalkFrames { latents, positions })
    }

    /// Takes the last frames back: the walk is what it was when the frame before them had been made. What was
    /// changed since is taken back as well, also with 0 frames.
    ///
    /// # Errors
    ///
    /// When so many frames are not known any more.
    pub fn rewind(&mut self, frames: usize) -> Result<(), WalkError> {
        let kept = self.states.len().checked_sub(frames).filter(|kept| *kept > 0);
        let highest = self.states.len().saturating_sub(1) as f64;
        let refused =
            || WalkError::Range { what: "frames to take back", lowest: 0.0, highest, found: frames as f64 };
        self.states.truncate(kept.ok_or_else(refused)?);
        if let Some(State { latents, track }) = self.states.back().cloned() {
            (self.latents, self.track) = (latents, track);
        }
        Ok(())
    }
}
