//! A motion that goes on without an end while primitives are exchanged, mixed and set to other tempos.

use crate::elementary::Elementary;
use crate::gp::KernelSum;
use crate::models::couplings::{CouplingsError, check_couplings, coupling_weights};
use crate::models::library::{CombinationError, Library, TrainedLibrary};
use crate::models::rollout::RolloutError;
use crate::motion::pose::{PoseError, RootStart, RootTrack};
use nalgebra::DMatrix;
use std::f64::consts::TAU;
use std::ops::RangeInclusive;
use thiserror::Error;

/// Tempos at which a step of the dynamics can still be divided or stretched.
pub const TEMPOS: RangeInclusive<f64> = 0.25..=2.0;

/// A map of locking that takes more frames in all would take minutes.
const MOST_LOCKING_FRAMES: usize = 2_000_000;

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

/// What one part does.
#[derive(Clone, Debug)]
struct PartWalk {
    primitive: usize,
    /// Another primitive of the part, and how far its predictions have taken the place of the first one's, 0 to 1.
    other: Option<(usize, f64)>,
    /// Frames of its own time that pass in a frame.
    tempo: f64,
    /// Its latents [frames x Q], newest last.
    path: Vec<f64>,
}

/// The latents of a walk.
///
/// A part at tempo s goes through its own time s times as fast. Its history is read at whole frames of its own time, between frames
/// by a straight line, and of the step that is predicted for its next frame it makes the part s:
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

/// The next frames of a walk.
#[derive(Clone, Debug)]
pub struct WalkFrames {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub positions: Vec<f32>,
}

impl LatentWalk {
    /// A combination from where it starts, under its nearest couplings.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives.
    pub fn new(library: &Library, uses: &[usize]) -> Result<Self, CombinationError> {
        library.check_uses(uses)?;
        let latent = library.latent_dimensions();
        let start = library.starts(uses).into_iter().next();
        let start =
            start.unwrap_or_else(|| latent.iter().map(|q| DMatrix::zeros(library.order, *q)).collect());
        let part = |(primitive, start): (&usize, &DMatrix<f64>)| PartWalk {
            primitive: *primitive,
            other: None,
            tempo: 1.0,
            path: start.rows(0, library.order).transpose().as_slice().to_vec(),
        };
        Ok(Self {
            order: library.order,
            alpha: library.nearest_couplings(uses),
            parts: uses.iter().zip(&start).map(part).collect(),
            latent,
        })
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

    /// Gives a part another of its primitives, at the state that is nearest to what the other parts do; these go on as they are. No
    /// movement that uses it: the part goes on from its own state.
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
        self.parts[part].other = None;
        Ok(())
    }

    /// Mixes the predictions of a part's primitive with those of another one of the part: 1 - `share` of the first, `share` of the other.
    ///
    /// # Errors
    ///
    /// When the other is not a primitive of the part, or the share is not from 0 to 1.
    pub fn mix(&mut self, library: &Library, part: usize, other: usize, share: f64) -> Result<(), WalkError> {
        if library.primitives.get(other).is_none_or(|primitive| primitive.part != part) {
            return Err(CombinationError::Primitive { part, found: other }.into());
        }
        if !(0.0..=1.0).contains(&share) {
            return Err(WalkError::Range { what: "a share", lowest: 0.0, highest: 1.0, found: share });
        }
        self.parts[part].other = (share > 0.0).then_some((other, share));
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
            let histories: Vec<Vec<f64>> = (0..m).map(|j| self.history(j)).collect();
            let next: Vec<Vec<f64>> = (0..m)
                .map(|i| {
                    let mut predicted = vec![0.0; self.latent[i]];
                    for ((part, history), w) in self.parts.iter().zip(&histories).zip(&weights[i]) {
                        let (other, share) = part.other.unwrap_or((part.primitive, 0.0));
                        let first = library.expert(part.primitive, i);
                        add(first, w * (1.0 - share), history, &mut scratch, &mut predicted);
                        if share > 0.0 {
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

    /// How firmly a target part is locked to a source part, for each tempo of the target and each strength of the coupling between
    /// them: the length of the mean of exp(2 pi i (phase of target - phase of source)) over the second half of `frames`, 1 locked, 0
    /// not at all [tempos x strengths]. A strength s divides alpha of the source about the target by s; phases are places on the cycle
    /// of the combination as learned, under its nearest couplings.
    ///
    /// # Errors
    ///
    /// When a part, primitive, tempo or strength does not fit, or the combination does not repeat itself.
    pub fn locking(
        &self,
        uses: &[usize],
        (source, target): (usize, usize),
        tempos: &[f64],
        strengths: &[f64],
        frames: usize,
    ) -> Result<DMatrix<f64>, WalkError> {
        let (walk, m) = (LatentWalk::new(self, uses)?, self.part_count());
        let work = tempos.len().saturating_mul(strengths.len()).saturating_mul(frames);
        if work > MOST_LOCKING_FRAMES {
            let (highest, found) = (MOST_LOCKING_FRAMES as f64, work as f64);
            return Err(WalkError::Range { what: "frames of the map in all", lowest: 0.0, highest, found });
        }
        if source >= m || target >= m {
            return Err(CombinationError::Count { expected: m, found: source.max(target) + 1 }.into());
        }
        let alpha = walk.alpha.clone();
        let cycle = self.combination(uses, &alpha)?.cycle(0)?.ok_or(WalkError::NoCycle)?;
        let mut map = DMatrix::zeros(tempos.len(), strengths.len());
        for (k, tempo) in tempos.iter().enumerate() {
            for (l, strength) in strengths.iter().enumerate() {
                let mut walk = walk.clone();
                walk.set_tempo(target, *tempo)?;
                let mut changed = alpha.clone();
                changed[(source, target)] /= strength;
                walk.set_alpha(changed)?;
                walk.advance(self, frames / 2);
                let (mut cosine, mut sine, mut count) = (0.0, 0.0, 0.0);
                for _ in frames / 2..frames {
                    walk.advance(self, 1);
                    let place = |part: usize| cycle.place(part, &walk.history(part));
                    if let (Some(a), Some(b)) = (place(source), place(target)) {
                        let (s, c) = (TAU * (b.phase - a.phase)).sine_cosine();
                        cosine += c;
                        sine += s;
                        count += 1.0;
                    }
                }
                map[(k, l)] = if count > 0.0 { cosine.hypotenuse(sine) / count } else { 0.0 };
            }
        }
        Ok(map)
    }
}

/// A walk with its body.
#[derive(Clone, Debug)]
pub struct LibraryWalk {
    /// Its latents.
    pub latents: LatentWalk,
    track: RootTrack,
}

impl LibraryWalk {
    /// As [`LatentWalk::new`], from the origin.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives.
    pub fn new(trained: &TrainedLibrary, uses: &[usize]) -> Result<Self, CombinationError> {
        let track = trained.body.mapping.track(&RootStart::default());
        Ok(Self { latents: LatentWalk::new(&trained.library, uses)?, track })
    }

    /// The next frames.
    ///
    /// # Errors
    ///
    /// When the poses are no longer finite.
    pub fn advance(&mut self, trained: &TrainedLibrary, frames: usize) -> Result<WalkFrames, WalkError> {
        trained.body.check_frames(frames, self.latents.latent.iter().sum())?;
        let latents = self.latents.advance(&trained.library, frames);
        let parts = trained.library.parts.iter().zip(&latents);
        let observed: Vec<_> = parts.map(|(part, x)| part.observations(x)).collect();
        let y = trained.body.columns(&observed);
        let positions = trained.body.mapping.decode_positions_on(&y, &mut self.track)?;
        Ok(WalkFrames { latents, positions })
    }
}
