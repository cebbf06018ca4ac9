//! Latents of a motion without an end, while primitives are exchanged and set to other tempos.

use crate::gp::KernelSum;
use crate::models::library::{CombinationError, Library, Misfit};
use crate::models::rollout::couplings::{CouplingsError, check_couplings, coupling_weights};
use crate::models::rollout::request::RolloutError;
use crate::motion::pose::PoseError;
use nalgebra::DMatrix;
use std::ops::RangeInclusive;
use thiserror::Error;

/// Tempos of a part; 1 is as learned.
pub const TEMPOS: RangeInclusive<f64> = 0.25..=2.0;

/// Why a walk cannot begin or continue.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WalkError {
    /// The primitives do not fit the parts.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// The couplings do not fit the parts.
    #[error(transparent)]
    Couplings(#[from] CouplingsError),
    /// A number is out of its range.
    #[error("expected {what} from {lowest} to {highest}, found {found}")]
    Range {
        /// What the number is.
        what: &'static str,
        /// Smallest value.
        lowest: f64,
        /// Largest value.
        highest: f64,
        /// The value asked for.
        found: f64,
    },
    /// The library moves another body.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// The library has other primitives.
    #[error("expected a library with all primitives of the one before, in the same places")]
    Primitives,
    /// The rollout of the combination cannot be made.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
    /// The poses are no longer finite.
    #[error(transparent)]
    Pose(#[from] PoseError),
}

/// The walk of one part.
#[derive(Clone, Debug)]
struct PartWalk {
    primitive: usize,
    /// Frames of the part's own time in a frame.
    tempo: f64,
    /// Its latents [frames x Q], newest last.
    path: Vec<f64>,
}

/// The latents of a walk.
///
/// A part at tempo s moves s times as fast. Its history is read at whole frames of its own time, with
/// straight lines between frames, and each frame makes the share s of the predicted step:
///
/// x^i <- x^i + s_i ( sum_j w_{ji} f^{ji}(history of j) - x^i ).
///
/// At tempo 1 these are the dynamics as learned. The papers have no tempo.
#[derive(Clone, Debug)]
pub struct LatentWalk {
    order: usize,
    latent: Vec<usize>,
    alpha: DMatrix<f64>,
    parts: Vec<PartWalk>,
}

impl LatentWalk {
    /// A walk of a combination under its nearest couplings, from its first start latents.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives.
    pub fn new(library: &Library, uses: &[usize]) -> Result<Self, CombinationError> {
        library.check_uses(uses)?;
        let start = library.starts(uses).into_iter().next().unwrap_or_else(|| library.zero_start());
        Ok(Self::begin(library, uses, &start))
    }

    /// A walk of a combination from a frame of a sequence of a movement, all counted from 0. A part with
    /// another primitive than in the movement starts at its [`nearest_state`](Library::nearest_state).
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives, or there is no such movement, sequence or frame.
    pub fn from_sequence(
        library: &Library,
        uses: &[usize],
        (movement, sequence, frame): (usize, usize, usize),
    ) -> Result<Self, WalkError> {
        library.check_uses(uses)?;
        let unknown = CombinationError::Movement { count: library.movements.len(), found: movement };
        let movement = library.movements.get(movement).ok_or(unknown)?;
        let within = |what: &'static str, count: usize, found: usize| {
            let highest = count.saturating_sub(1) as f64;
            let error = WalkError::Range { what, lowest: 0.0, highest, found: found as f64 };
            if found < count { Ok(()) } else { Err(error) }
        };
        within("a sequence of the movement", movement.starts.len(), sequence)?;
        let rows = movement.starts[sequence].iter().map(DMatrix::nrows).min().unwrap_or(0);
        within(
            "a frame of the sequence with a whole history",
            (rows + 1).saturating_sub(library.order),
            frame,
        )?;
        Ok(Self::begin(library, uses, &library.window(uses, movement, sequence, frame)))
    }

    fn begin(library: &Library, uses: &[usize], start: &[DMatrix<f64>]) -> Self {
        let part = |(primitive, start): (&usize, &DMatrix<f64>)| PartWalk {
            primitive: *primitive,
            tempo: 1.0,
            path: start.rows(0, library.order).transpose().as_slice().to_vec(),
        };
        Self {
            order: library.order,
            alpha: library.nearest_couplings(uses),
            parts: uses.iter().zip(start).map(part).collect(),
            latent: library.latent_dimensions(),
        }
    }

    /// The current couplings [M x M], row the source.
    pub fn alpha(&self) -> &DMatrix<f64> {
        &self.alpha
    }

    /// The current primitive of each part.
    pub fn uses(&self) -> Vec<usize> {
        self.parts.iter().map(|part| part.primitive).collect()
    }

    /// Sets the couplings [M x M], row the source.
    ///
    /// # Errors
    ///
    /// When they do not fit the parts.
    pub fn set_alpha(&mut self, alpha: DMatrix<f64>) -> Result<(), WalkError> {
        check_couplings(&alpha, self.parts.len())?;
        self.alpha = alpha;
        Ok(())
    }

    /// Gives a part another of its primitives, at its [`nearest_state`](Library::nearest_state); where there
    /// is none, the part continues from its own state. The other parts do not change.
    ///
    /// # Errors
    ///
    /// When the primitive is not one of the part.
    pub fn use_primitive(
        &mut self,
        library: &Library,
        part: usize,
        primitive: usize,
    ) -> Result<(), WalkError> {
        let mut uses = self.uses();
        let expected = uses.len();
        *uses.get_mut(part).ok_or(CombinationError::Count { expected, found: part + 1 })? = primitive;
        library.check_uses(&uses)?;
        let window: Vec<DMatrix<f64>> = (0..self.parts.len()).map(|k| self.window(k)).collect();
        if let Some(state) = library.nearest_state(primitive, &window, &[]) {
            self.parts[part].path = state.transpose().as_slice().to_vec();
        }
        self.parts[part].primitive = primitive;
        Ok(())
    }

    /// Sets the tempo of a part; 1 is as learned.
    ///
    /// # Errors
    ///
    /// When there is no such part, or the tempo is not from a quarter to 2.
    pub fn set_tempo(&mut self, part: usize, tempo: f64) -> Result<(), WalkError> {
        let expected = self.parts.len();
        let own = self.parts.get_mut(part).ok_or(CombinationError::Count { expected, found: part + 1 })?;
        if !TEMPOS.contains(&tempo) {
            let (lowest, highest) = (*TEMPOS.start(), *TEMPOS.end());
            return Err(WalkError::Range { what: "a tempo", lowest, highest, found: tempo });
        }
        own.tempo = tempo;
        Ok(())
    }

    /// The next frames of all parts [frames x Q_i].
    pub fn advance(&mut self, library: &Library, frames: usize) -> Vec<DMatrix<f64>> {
        let m = self.parts.len();
        let weights: Vec<Vec<f64>> =
            (0..m).map(|i| coupling_weights(self.alpha.column(i).as_slice()).1).collect();
        let widest = self.latent.iter().max().copied().unwrap_or(0);
        let mut scratch = vec![0.0; self.order * widest];
        for _ in 0..frames {
            let histories: Vec<Vec<f64>> = (0..m).map(|j| self.history(j)).collect();
            let next: Vec<Vec<f64>> = (0..m)
                .map(|i| {
                    let mut predicted = vec![0.0; self.latent[i]];
                    for ((part, history), w) in self.parts.iter().zip(&histories).zip(&weights[i]) {
                        add(library.expert(part.primitive, i), *w, history, &mut scratch, &mut predicted);
                    }
                    let own = &self.parts[i];
                    let newest = &own.path[own.path.len() - self.latent[i]..];
                    let step = |(x, predicted): (&f64, f64)| {
                        // The same bits as a rollout.
                        if own.tempo == 1.0 { predicted } else { x + own.tempo * (predicted - x) }
                    };
                    newest.iter().zip(predicted).map(step).collect()
                })
                .collect();
            for (part, next) in self.parts.iter_mut().zip(next) {
                part.path.extend(next);
            }
        }
        let newest =
            self.parts.iter().zip(&self.latent).map(|(part, &q)| {
                DMatrix::from_row_slice(frames, q, &part.path[part.path.len() - frames * q..])
            });
        let newest = newest.collect();
        // No history reaches further back than this.
        let longest = (self.order as f64 / TEMPOS.start()).ceil() as usize + 1;
        for (part, q) in self.parts.iter_mut().zip(&self.latent) {
            part.path.drain(..part.path.len().saturating_sub(longest * q));
        }
        newest
    }

    /// The last p states of a part at whole frames of its own time, oldest first [p Q].
    pub fn history(&self, part: usize) -> Vec<f64> {
        let (own, q) = (&self.parts[part], self.latent[part]);
        let newest = own.path.len() / q - 1;
        let mut history = Vec::with_capacity(self.order * q);
        for k in (0..self.order).rev() {
            let back = (k as f64 / own.tempo).min(newest as f64);
            let (whole, between) = (back.floor() as usize, back.fract());
            let at = |frames: usize| &own.path[(newest - frames.min(newest)) * q..][..q];
            let (later, earlier) = (at(whole), at(whole + 1));
            history.extend(later.iter().zip(earlier).map(|(a, b)| a + between * (b - a)));
        }
        history
    }

    fn window(&self, part: usize) -> DMatrix<f64> {
        DMatrix::from_row_slice(self.order, self.latent[part], &self.history(part))
    }
}

/// Adds f(x), times a weight, to `out`.
fn add(expert: &KernelSum, weight: f64, x: &[f64], scratch: &mut [f64], out: &mut [f64]) {
    let mut prediction = vec![0.0; out.len()];
    expert.add_to(x, scratch, &mut prediction);
    out.iter_mut().zip(prediction).for_each(|(out, f)| *out += weight * f);
}

impl Library {
    /// The expert of a primitive about part `i`.
    fn expert(&self, primitive: usize, i: usize) -> &KernelSum {
        self.primitives[primitive].experts[i].fitted.sum()
    }
}

crate::coded!(WalkError {
    Self::Combination(reason) => reason.code(),
    Self::Rollout(reason) => reason.code(),
    Self::Pose(_) => Numerics,
    _ => Rollout,
});
