//! Default couplings and start latents of a new combination.

use crate::models::library::{CombinationError, CouplingsFrom, LearnedMovement, Library};
use crate::models::search::parameters::LARGEST_COUPLING;
use nalgebra::DMatrix;

impl Library {
    /// Default couplings of a combination [M x M]. A source part has the coupling to a target part of the
    /// movement that uses the primitives of both; of several, of the one that shares most primitives with
    /// `uses`. Where the source never met the target's primitive, its predictions are about other movements:
    /// the coupling is the largest variance that training allows, so that the target hardly listens. Where no
    /// movement uses the source's primitive, the couplings are those of its first excerpt, or else 1. The
    /// couplings of a movement's own combination are those of the movement.
    pub fn nearest_couplings(&self, uses: &[usize]) -> DMatrix<f64> {
        let mut alpha = self.couplings_of_sources(uses);
        for (source, primitive) in uses.iter().enumerate().take(self.part_count()) {
            if self.nearest_movement(uses, &[*primitive]).is_none() {
                continue;
            }
            for (target, other) in uses.iter().enumerate().take(self.part_count()) {
                let both = self.nearest_movement(uses, &[*primitive, *other]);
                alpha[(source, target)] =
                    both.map_or(LARGEST_COUPLING, |movement| movement.alpha[(source, target)]);
            }
        }
        alpha
    }

    /// The couplings of each source as its primitive learned them, whatever the primitives of the targets are
    /// [M x M].
    pub(super) fn couplings_of_sources(&self, uses: &[usize]) -> DMatrix<f64> {
        let parts = self.part_count();
        let mut alpha = DMatrix::from_element(parts, parts, 1.0);
        for (source, primitive) in uses.iter().enumerate().take(parts) {
            if let Some(movement) = self.nearest_movement(uses, &[*primitive]) {
                alpha.row_mut(source).copy_from(&movement.alpha.row(source));
            } else if let Some(excerpt) = self.primitives.get(*primitive).and_then(|p| p.excerpts.first()) {
                alpha.row_mut(source).copy_from_slice(&excerpt.alpha);
            }
        }
        alpha
    }

    /// The movement that uses all these primitives and shares most primitives with `uses`.
    fn nearest_movement(&self, uses: &[usize], primitives: &[usize]) -> Option<&LearnedMovement> {
        let using = || {
            let has_all = |movement: &&LearnedMovement| primitives.iter().all(|p| movement.uses.contains(p));
            self.movements.iter().filter(has_all)
        };
        let most = using().map(|movement| count_shared(&movement.uses, uses)).max()?;
        using().find(|movement| count_shared(&movement.uses, uses) == most)
    }

    /// A combination under its [`nearest_couplings`](Self::nearest_couplings), as a movement of this name.
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
        let mut names: Vec<&str> = Vec::new();
        for primitive in uses {
            let excerpt = || self.primitives[*primitive].excerpts.first().map(|excerpt| &excerpt.movement);
            let from = self.nearest_movement(uses, &[*primitive]).map(|movement| &movement.name);
            if let Some(name) = from.or_else(excerpt).filter(|name| !names.contains(&name.as_str())) {
                names.push(name);
            }
        }
        Ok(LearnedMovement {
            name: name.to_owned(),
            uses: uses.to_vec(),
            alpha: self.nearest_couplings(uses),
            sums: None,
            starts: self.starts(uses),
            couplings: if names.is_empty() {
                CouplingsFrom::Nothing
            } else {
                CouplingsFrom::Movement { movement: names.join("+") }
            },
            rollout_rounds: 0,
        })
    }

    /// The sequences that a combination can start from, as (movement, sequence of the movement): those of the
    /// movements that share most primitives with the combination.
    pub fn start_sequences(&self, uses: &[usize]) -> Vec<(usize, usize)> {
        let shared = |movement: &LearnedMovement| count_shared(&movement.uses, uses);
        let most = self.movements.iter().filter(|m| !m.starts.is_empty()).map(shared).max().unwrap_or(0);
        let chosen = self.movements.iter().enumerate().filter(|(_, movement)| shared(movement) == most);
        chosen.flat_map(|(m, movement)| (0..movement.starts.len()).map(move |s| (m, s))).collect()
    }

    /// The latents that a combination starts with, in the order of
    /// [`start_sequences`](Self::start_sequences). A part with the primitive of the movement starts as in the
    /// sequence; a part with another primitive starts at its [`nearest_state`](Self::nearest_state).
    pub(super) fn starts(&self, uses: &[usize]) -> Vec<Vec<DMatrix<f64>>> {
        let start = |(m, s): (usize, usize)| {
            let movement = &self.movements[m];
            if movement.uses == uses { movement.starts[s].clone() } else { self.window(uses, movement, s, 0) }
        };
        self.start_sequences(uses).into_iter().map(start).collect()
    }

    /// The p latents of each part [p x Q_i] that a combination starts with at a frame of a sequence. A part
    /// with another primitive than in the movement starts at its [`nearest_state`](Self::nearest_state).
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
            .map(|part| if changed[part] { self.nearest_state(uses[part], &window, &changed) } else { None })
            .collect();
        for (own, state) in window.iter_mut().zip(states) {
            if let Some(state) = state {
                *own = state;
            }
        }
        window
    }

    /// The latents of all sequences of a primitive [T x Q_i] by part, with those of its excerpts last.
    pub(super) fn starts_of(&self, primitive: usize) -> impl Iterator<Item = &Vec<DMatrix<f64>>> {
        let movements = self.movements.iter().filter(move |movement| movement.uses.contains(&primitive));
        let excerpts = self.primitives.get(primitive).into_iter().flat_map(|own| &own.excerpts);
        movements.flat_map(|movement| &movement.starts).chain(excerpts.flat_map(|excerpt| &excerpt.starts))
    }

    /// p latents 0 of each part [p x Q_i], for a library without start latents.
    pub(super) fn zero_start(&self) -> Vec<DMatrix<f64>> {
        self.latent_dimensions().into_iter().map(|q| DMatrix::zeros(self.order, q)).collect()
    }

    /// The p latents of a primitive's part [p x Q] at the moment of its movements and excerpts when the other
    /// parts were nearest to `window` [p x Q_i each]. Parts with `ignored` true do not count, unless no other
    /// part is left. `None` where the primitive has neither a movement nor an excerpt.
    pub fn nearest_state(
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

    /// For each frame of the centred columns `y` [T x D_i of each part], the latents of a movement or excerpt
    /// whose pose is nearest [T x Q_i of each part].
    pub(super) fn nearest_latents(&self, y: &[DMatrix<f64>]) -> Vec<DMatrix<f64>> {
        let nearest = |(part, y): (usize, &DMatrix<f64>)| {
            let excerpts =
                self.primitives.iter().flat_map(|p| &p.excerpts).flat_map(|excerpt| &excerpt.starts);
            let starts = self.movements.iter().flat_map(|m| &m.starts).chain(excerpts);
            let stored: Vec<&DMatrix<f64>> = starts.map(|latents| &latents[part]).collect();
            let poses: Vec<DMatrix<f64>> = stored.iter().map(|x| self.parts[part].observations(x)).collect();
            let mut out = DMatrix::zeros(y.nrows(), self.parts[part].r().ncols());
            for t in 0..y.nrows() {
                let mut least = f64::INFINITY;
                for (x, poses) in stored.iter().zip(&poses) {
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
        y.iter().enumerate().map(nearest).collect()
    }
}

fn count_shared(a: &[usize], b: &[usize]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a == b).count()
}
