//! How firmly the phases of two parts are locked, at several tempos and couplings.

use crate::elementary::Elementary;
use crate::models::library::{CombinationError, LatentWalk, Library, WalkError};
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// The most frames of all rollouts of a map together; more would take minutes.
const MOST_FRAMES: usize = 2_000_000;

impl Library {
    /// How firmly a target part is locked to a source part [tempos x strengths]: 1 locked, 0 not at all.
    ///
    /// This is the length of the mean of exp(2 pi i (phase of target - phase of source)) over the second half
    /// of `frames` frames, for each tempo of the target and each strength of the coupling. A strength s
    /// divides alpha of the source about the target by s. Phases are places on the cycle of the combination
    /// under `alpha` [M x M].
    ///
    /// # Errors
    ///
    /// When a part, primitive, coupling, tempo or strength does not fit, or the combination does not repeat
    /// itself.
    pub fn locking(
        &self,
        uses: &[usize],
        alpha: &DMatrix<f64>,
        (source, target): (usize, usize),
        tempos: &[f64],
        strengths: &[f64],
        frames: usize,
    ) -> Result<DMatrix<f64>, WalkError> {
        let (walk, m) = (LatentWalk::new(self, uses)?, self.part_count());
        let work = tempos.len().saturating_mul(strengths.len()).saturating_mul(frames);
        if work > MOST_FRAMES {
            let (highest, found) = (MOST_FRAMES as f64, work as f64);
            return Err(WalkError::Range { what: "frames of the map in all", lowest: 0.0, highest, found });
        }
        if source >= m || target >= m {
            return Err(CombinationError::Count { expected: m, found: source.max(target) + 1 }.into());
        }
        let cycle = self.combination(uses, alpha)?.cycle(0)?.ok_or(WalkError::NoCycle)?;
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
