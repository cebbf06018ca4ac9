//! Where a combination starts, and under which couplings, when nobody says.

use crate::models::library::{CombinationError, CouplingsFrom, LearnedMovement, Library};
use nalgebra::DMatrix;

impl Library {
    /// The couplings of a combination that nobody has fitted: how much a primitive's predictions are worth
    /// was learned in the movements that use it, so the couplings of each source are those of such a
    /// movement; of several, of the one that shares most primitives with `uses`, the first where several
    /// share as many; where none uses it, of one that the primitive keeps an excerpt of; else 1 each. Of a
    /// movement's own combination they are that movement's.
    pub fn nearest_couplings(&self, uses: &[usize]) -> DMatrix<f64> {
        let parts = self.part_count();
        let mut alpha = DMatrix::from_element(parts, parts, 1.0);
        for (source, primitive) in uses.iter().enumerate().take(parts) {
            if let Some(movement) = self.nearest_movement(uses, *primitive) {
                alpha.row_mut(source).copy_from(&movement.alpha.row(source));
            } else if let Some(excerpt) = self.primitives.get(*primitive).and_then(|p| p.excerpts.first()) {
                alpha.row_mut(source).copy_from_slice(&excerpt.alpha);
            }
        }
        alpha
    }

    /// Of the movements that use a primitive, the one that shares most primitives with `uses`.
    fn nearest_movement(&self, uses: &[usize], primitive: usize) -> Option<&LearnedMovement> {
        let using = || self.movements.iter().filter(|movement| movement.uses.contains(&primitive));
        let most = using().map(|movement| count_shared(&movement.uses, uses)).max()?;
        using().find(|movement| count_shared(&movement.uses, uses) == most)
    }

    /// A combination under the couplings of [`nearest_couplings`](Self::nearest_couplings), as a movement of
    /// that name.
    ///
    /// # Errors
    ///
    /// When a part is not given one of its primitives.
    pub fn nearest_combination(
        &self,
        name: &str,
        uses: &[usize],
    ) -> Result<LearnedMovement, CombinationError> {
        self.check_uses(uses)?;
        let mut nearest: Vec<&str> = Vec::new();
        for primitive in uses {
            let excerpt = || self.primitives[*primitive].excerpts.first().map(|excerpt| &excerpt.movement);
            let from = self.nearest_movement(uses, *primitive).map(|movement| &movement.name);
            if let Some(name) = from.or_else(excerpt).filter(|name| !nearest.contains(&name.as_str())) {
                nearest.push(name);
            }
        }
        Ok(LearnedMovement {
            name: name.to_owned(),
            uses: uses.to_vec(),
            alpha: self.nearest_couplings(uses),
            sums: None,
            starts: self.starts(uses),
            couplings: if nearest.is_empty() {
                CouplingsFrom::Nothing
            } else {
                CouplingsFrom::Movement(nearest.join("+"))
            },
        })
    }

    /// The sequences that a combination can start from, (movement, sequence of it): those of the movements
    /// that share most primitives with it.
    pub fn start_sequences(&self, uses: &[usize]) -> Vec<(usize, usize)> {
        let shared = |movement: &LearnedMovement| count_shared(&movement.uses, uses);
        let most = self.movements.iter().filter(|m| !m.starts.is_empty()).map(shared).max().unwrap_or(0);
        let chosen = self.movements.iter().enumerate().filter(|(_, movement)| shared(movement) == most);
        chosen.flat_map(|(m, movement)| (0..movement.starts.len()).map(move |s| (m, s))).collect()
    }

    /// The latents that a combination starts with, in the order of
    /// [`start_sequences`](Self::start_sequences). A part that keeps its primitive starts as in the sequence;
    /// one with another primitive starts where that is nearest to what the others do.
    pub(super) fn starts(&self, uses: &[usize]) -> Vec<Vec<DMatrix<f64>>> {
        let start = |(m, s): (usize, usize)| {
            let movement = &self.movements[m];
            if movement.uses == uses { movement.starts[s].clone() } else { self.window(uses, movement, s, 0) }
        };
        self.start_sequences(uses).into_iter().map(start).collect()
    }

    /// The p latents of each part [p x Q_i] that a combination starts with at a frame of a sequence: parts
    /// with another primitive than in the movement start where that is nearest to what the others do there.
    pub(super) fn window(
        &self,
        uses: &[usize],
        movement: &LearnedMovement,
        sequence: usize,
        frame: usize,
    ) -> Vec<DMatrix<f64>> {
        let rows = |x: &DMatrix<f64>| x.rows(frame, self.order.min(x.nrows() - frame)).into_owned();
        let mut window: Vec<DMatrix<f64>> = movement.starts[sequence].iter().map(rows).collect();
        let changed: Vec<bool> = movement.uses.iter().zip(uses).map(|(a, b)| a != b).collect();
        let states: Vec<_> = (0..window.len())
            .map(|part| if changed[part] { self.state_near(uses[part], &window, &changed) } else { None })
            .collect();
        for (own, state) in window.iter_mut().zip(states) {
            if let Some(state) = state {
                *own = state;
            }
        }
        window
    }

    /// The latents of all sequences of a primitive, those of its excerpts last: [T x Q_i] of each part.
    pub(super) fn starts_of(&self, primitive: usize) -> impl Iterator<Item = &Vec<DMatrix<f64>>> {
        let movements = self.movements.iter().filter(move |movement| movement.uses.contains(&primitive));
        let excerpts = self.primitives.get(primitive).into_iter().flat_map(|known| &known.excerpts);
        movements.flat_map(|movement| &movement.starts).chain(excerpts.flat_map(|excerpt| &excerpt.starts))
    }

    /// The p latents of each part [p x Q_i] where nothing is known: all 0.
    pub(super) fn at_rest(&self) -> Vec<DMatrix<f64>> {
        self.latent_dimensions().into_iter().map(|q| DMatrix::zeros(self.order, q)).collect()
    }

    /// The p latents of a primitive's part [p x Q] at the time of its movements when the other parts were
    /// nearest to `window` [p x Q_i each]; parts in `ignored` do not count, unless all do. `None` where no
    /// movement uses the primitive, and it keeps no excerpt of one.
    pub fn state_near(
        &self,
        primitive: usize,
        window: &[DMatrix<f64>],
        ignored: &[bool],
    ) -> Option<DMatrix<f64>> {
        let part = self.primitives.get(primitive)?.part;
        let counts = |k: usize| k != part && !ignored.get(k).copied().unwrap_or(false);
        let others: Vec<usize> = (0..window.len()).filter(|k| counts(*k)).collect();
        let compared = if others.is_empty() { (0..window.len()).collect() } else { others };
        let mut best: Option<(f64, DMatrix<f64>)> = None;
        for latents in self.starts_of(primitive) {
            let frames = latents.first().map_or(0, DMatrix::nrows);
            for t in 0..(frames + 1).saturating_sub(self.order) {
                let distance: f64 = compared
                    .iter()
                    .map(|k| (latents[*k].rows(t, self.order) - &window[*k]).norm_squared())
                    .sum();
                if best.as_ref().is_none_or(|(least, _)| distance < *least) {
                    best = Some((distance, latents[part].rows(t, self.order).into_owned()));
                }
            }
        }
        best.map(|(_, state)| state)
    }

    /// Latents [T x Q_i of each part] at which the pose maps come nearest to centred columns `y` [T x D_i of
    /// each part], frame by frame, among the latents of all movements and excerpts.
    pub(super) fn latents_near(&self, y: &[DMatrix<f64>]) -> Vec<DMatrix<f64>> {
        let of_part = |(part, y): (usize, &DMatrix<f64>)| {
            let excerpts =
                self.primitives.iter().flat_map(|p| &p.excerpts).flat_map(|excerpt| &excerpt.starts);
            let starts = self.movements.iter().flat_map(|m| &m.starts).chain(excerpts);
            let known: Vec<&DMatrix<f64>> = starts.map(|latents| &latents[part]).collect();
            let poses: Vec<DMatrix<f64>> = known.iter().map(|x| self.parts[part].observations(x)).collect();
            let mut out = DMatrix::zeros(y.nrows(), self.parts[part].r().ncols());
            for t in 0..y.nrows() {
                let mut least = f64::INFINITY;
                for (x, poses) in known.iter().zip(&poses) {
                    for s in 0..poses.nrows() {
                        let distance = (poses.row(s) - y.row(t)).norm_squared();
                        if distance < least {
                            least = distance;
                            out.row_mut(t).copy_from(&x.row(s));
                        }
                    }
                }
            }
            out
        };
        y.iter().enumerate().map(of_part).collect()
    }
}

fn count_shared(a: &[usize], b: &[usize]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a == b).count()
}
