//! A motion that goes on without an end while primitives are exchanged, mixed and set to other tempos.

use crate::gp::KernelSum;
use crate::models::library::{CombinationError, Library, Misfit};
use crate::models::rollout::couplings::{CouplingsError, check_couplings, coupling_weights};
use crate::models::rollout::request::RolloutError;
use crate::motion::pose::PoseError;
use nalgebra::DMatrix;
use std::ops::RangeInclusive;
use thiserror::Error;

/// Tempos at which a step of the dynamics can still be divided or stretched.
pub const TEMPOS: RangeInclusive<f64> = 0.25..=2.0;

/// Why a walk cannot go on as asked.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WalkError {
    /// The primitives do not fit the parts.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// The couplings do not fit the parts.
    #[error(transparent)]
    Couplings(#[from] CouplingsError),
    /// A number that is out of its range.
    #[error("expected {what} from {lowest} to {highest}, found {found}")]
    Range {
        /// What it is.
        what: &'static str,
        /// Smallest value.
        lowest: f64,
        /// Largest value.
        highest: f64,
        /// The value asked for.
        found: f64,
    },
    /// A library that does not move this figure.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// A library with other primitives.
    #[error("expected a library with all primitives of the one before, in the same places")]
    Primitives,
    /// Phases have no meaning without a cycle.
    #[error("expected a combination that repeats itself, found one that does not settle in a cycle")]
    NoCycle,
    /// The learned motion cannot be made.
    #[error(transparent)]
    Rollout(#[from] RolloutError),
    /// The poses are no longer finite.
    #[error(transparent)]
    Pose(#[from] PoseError),
}

/// Another primitive of a part, and how far its predictions have taken the place of the first one's.
#[derive(Clone, Copy, Debug)]
struct Mix {
    other: usize,
    /// 0 to 1.
    share: f64,
    /// Where the share goes, and by how much at most in a frame.
    goal: f64,
    pace: f64,
}

impl Mix {
    /// A frame later; none any more when the first primitive has its place back.
    fn next(self) -> Option<Self> {
        let share = self.share + (self.goal - self.share).clamp(-self.pace, self.pace);
        (share > 0.0).then_some(Self { share, ..self })
    }
}

/// What one part does.
#[derive(Clone, Debug)]
struct PartWalk {
    primitive: usize,
    mix: Option<Mix>,
    /// Frames of its own time that pass in a frame.
    tempo: f64,
    /// Its latents [frames x Q], newest last.
    path: Vec<f64>,
}

/// The latents of a walk.
///
/// A part at tempo s goes through its own time s times as fast. Its history is read at whole frames of its
/// own time, between frames by a straight line, and of the step that is predicted for its next frame it makes
/// the part s:
///
/// x^i <- x^i + s_i ( sum_j w_{ji} f^{ji}(history of j) - x^i ).
///
/// At tempo 1 these are the dynamics as learned. The tempo is ours; the papers have none.
#[derive(Clone, Debug)]
pub struct LatentWalk {
    order: usize,
    latent: Vec<usize>,
    alpha: DMatrix<f64>,
    parts: Vec<PartWalk>,
}

impl LatentWalk {
    /// A combination from where it starts, under its nearest couplings.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives.
    pub fn new(library: &Library, uses: &[usize]) -> Result<Self, CombinationError> {
        library.check_uses(uses)?;
        let start = library.starts(uses).into_iter().next().unwrap_or_else(|| library.at_rest());
        Ok(Self::begin(library, uses, &start))
    }

    /// A combination from where the parts were at a frame of a sequence of a movement, all counted from 0;
    /// parts with another primitive than there start where that is nearest to what the others do.
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
            let (highest, asked) = (count.saturating_sub(1) as f64, found as f64);
            let refused = WalkError::Range { what, lowest: 0.0, highest, found: asked };
            if found < count { Ok(()) } else { Err(refused) }
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
            mix: None,
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

    /// The couplings now [M x M], row the source.
    pub fn alpha(&self) -> &DMatrix<f64> {
        &self.alpha
    }

    /// The primitive that each part uses now.
    pub fn uses(&self) -> Vec<usize> {
        self.parts.iter().map(|part| part.primitive).collect()
    }

    /// Other couplings [M x M], row the source.
    ///
    /// # Errors
    ///
    /// When they do not fit the parts.
    pub fn set_alpha(&mut self, alpha: DMatrix<f64>) -> Result<(), WalkError> {
        check_couplings(&alpha, self.parts.len())?;
        self.alpha = alpha;
        Ok(())
    }

    /// Gives a part another of its primitives, at the state that is nearest to what the other parts do; these
    /// go on as they are. No movement that uses it: the part goes on from its own state.
    ///
    /// # Errors
    ///
    /// When it is not a primitive of the part.
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
        if let Some(state) = library.state_near(primitive, &window, &[]) {
            self.parts[part].path = state.transpose().as_slice().to_vec();
        }
        self.parts[part].primitive = primitive;
        self.parts[part].mix = None;
        Ok(())
    }

    /// Mixes the predictions of a part's primitive with those of another one of the part: 1 - `share` of the
    /// first, `share` of the other. It gets there evenly, at the pace of a whole exchange in `frames`; with
    /// 0, at once. A mix with a third primitive begins anew.
    ///
    /// # Errors
    ///
    /// When the other is not a primitive of the part, or the share is not from 0 to 1.
    pub fn mix(
        &mut self,
        library: &Library,
        part: usize,
        other: usize,
        share: f64,
        frames: usize,
    ) -> Result<(), WalkError> {
        if library.primitives.get(other).is_none_or(|primitive| primitive.part != part) {
            return Err(CombinationError::Primitive { part, found: other }.into());
        }
        if !(0.0..=1.0).contains(&share) {
            return Err(WalkError::Range { what: "a share", lowest: 0.0, highest: 1.0, found: share });
        }
        let before = self.parts[part].mix.filter(|mix| mix.other == other).map_or(0.0, |mix| mix.share);
        let pace = if frames == 0 { 1.0 } else { 1.0 / frames as f64 };
        self.parts[part].mix = Some(Mix { other, share: before, goal: share, pace });
        Ok(())
    }

    /// Lets a part go through its own time at another tempo; 1 is as learned.
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
            for part in &mut self.parts {
                part.mix = part.mix.and_then(Mix::next);
            }
            let histories: Vec<Vec<f64>> = (0..m).map(|j| self.history(j)).collect();
            let next: Vec<Vec<f64>> = (0..m)
                .map(|i| {
                    let mut predicted = vec![0.0; self.latent[i]];
                    for ((part, history), w) in self.parts.iter().zip(&histories).zip(&weights[i]) {
                        let share = part.mix.map_or(0.0, |mix| mix.share);
                        let first = library.expert(part.primitive, i);
                        add(first, w * (1.0 - share), history, &mut scratch, &mut predicted);
                        if let Some(Mix { other, .. }) = part.mix {
                            add(library.expert(other, i), w * share, history, &mut scratch, &mut predicted);
                        }
                    }
                    let own = &self.parts[i];
                    let newest = &own.path[own.path.len() - self.latent[i]..];
                    let step = |(x, predicted): (&f64, f64)| {
                        // As learned to the bit.
                        if own.tempo == 1.0 { predicted } else { x + own.tempo * (predicted - x) }
                    };
                    newest.iter().zip(predicted).map(step).collect()
                })
                .collect();
            for (part, next) in self.parts.iter_mut().zip(next) {
                part.path.extend(next);
            }
        }
        let made =
            self.parts.iter().zip(&self.latent).map(|(part, &q)| {
                DMatrix::from_row_slice(frames, q, &part.path[part.path.len() - frames * q..])
            });
        let made = made.collect();
        // What no history reaches any more.
        let kept = (self.order as f64 / TEMPOS.start()).ceil() as usize + 1;
        for (part, q) in self.parts.iter_mut().zip(&self.latent) {
            part.path.drain(..part.path.len().saturating_sub(kept * q));
        }
        made
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

    /// Gives a part another primitive where it stands.
    #[cfg(test)]
    pub(super) fn parts_for_tests(&mut self, part: usize, primitive: usize) {
        self.parts[part].primitive = primitive;
    }

    fn window(&self, part: usize) -> DMatrix<f64> {
        DMatrix::from_row_slice(self.order, self.latent[part], &self.history(part))
    }
}

/// Adds f(x), times a weight, to `out`.
fn add(expert: &KernelSum, weight: f64, x: &[f64], scratch: &mut [f64], out: &mut [f64]) {
    let mut said = vec![0.0; out.len()];
    expert.add_to(x, scratch, &mut said);
    out.iter_mut().zip(said).for_each(|(out, said)| *out += weight * said);
}

impl Library {
    /// What a primitive predicts about part `i`.
    fn expert(&self, primitive: usize, i: usize) -> &KernelSum {
        self.primitives[primitive].experts[i].fitted.sum()
    }
}
