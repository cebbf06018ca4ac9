//! The learned cycle: the phase of a part on it, and its distance from it.

use crate::models::rollout::request::{RolloutError, RolloutRequest};
use crate::models::variational::model::Vcgpdm;
use crate::motion::{RHYTHMIC, period};
use nalgebra::DMatrix;

/// Frames in which the learned rollout settles; its period is measured in the same number of frames after
/// them.
const SETTLING: usize = 300;

/// One period of the rollout as learned: the same frame of it for all parts, so that parts in step have the
/// same phase.
#[derive(Clone, Debug)]
pub struct Cycle {
    /// The histories of each part around the cycle [period x pQ_i].
    states: Vec<DMatrix<f64>>,
    /// Order p of the dynamics.
    order: usize,
    /// Root mean square distance of each part's states from their mean.
    radii: Vec<f64>,
}

/// The place of a part near the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CyclePlace {
    /// The nearest point of the cycle, in turns, 0 to 1.
    pub phase: f64,
    /// The distance of this point, in radii of the part's cycle.
    pub distance: f64,
}

impl Vcgpdm {
    /// The cycle in which the learned rollout from the start of `sequence` settles; absent when it does not
    /// repeat itself.
    ///
    /// # Errors
    ///
    /// When there is no such sequence, or a covariance cannot be factorised.
    pub fn cycle(&self, sequence: usize) -> Result<Option<Cycle>, RolloutError> {
        let request = RolloutRequest { frames: 2 * SETTLING, sequence, ..RolloutRequest::default() };
        let path = self.path(&request)?;
        let settled: Vec<_> = path.iter().map(|x| x.rows(SETTLING, SETTLING).into_owned()).collect();
        let width = settled.iter().map(|x| x.ncols()).sum();
        let mut all = DMatrix::zeros(SETTLING, width);
        let mut at = 0;
        for part in &settled {
            all.columns_mut(at, part.ncols()).copy_from(part);
            at += part.ncols();
        }
        let found = period(&[all]).filter(|found| found.correlation >= RHYTHMIC);
        Ok(found.and_then(|found| Cycle::new(&settled, self.order, found.frames)))
    }
}

impl Cycle {
    /// The last `period` frames of a settled path; `None` when a part does not move.
    fn new(path: &[DMatrix<f64>], order: usize, period: f64) -> Option<Self> {
        let count = period.round() as usize;
        let first = path.first()?.nrows().checked_sub(count)?;
        let part = |x: &DMatrix<f64>| {
            let q = x.ncols();
            DMatrix::from_fn(count, order * q, |t, n| x[(first + t + 1 + n / q - order, n % q)])
        };
        let states: Vec<_> = path.iter().map(part).collect();
        let radius = |states: &DMatrix<f64>| {
            let mean = states.row_mean();
            (states.row_iter().map(|row| (row - &mean).norm_squared()).sum::<f64>() / count as f64).sqrt()
        };
        let radii: Vec<f64> = states.iter().map(radius).collect();
        radii.iter().all(|radius| *radius > 1e-3).then_some(Self { states, order, radii })
    }

    /// Frames of one turn.
    pub fn period(&self) -> usize {
        self.states.first().map_or(1, DMatrix::nrows)
    }

    /// The place of a part with this `history` `[p Q_i]`, oldest frame first; `None` for a part that does not
    /// exist.
    pub fn place(&self, part: usize, history: &[f64]) -> Option<CyclePlace> {
        let (states, radius) = (self.states.get(part)?, self.radii.get(part)?);
        let count = states.nrows();
        let squared = |t: usize| -> f64 {
            states.row(t % count).iter().zip(history).map(|(a, b)| (a - b).powi(2)).sum()
        };
        let nearest = (0..count).min_by(|a, b| squared(*a).total_cmp(&squared(*b)))?;
        // The minimum of the parabola through the nearest state and its neighbours.
        let (before, at, after) = (squared(nearest + count - 1), squared(nearest), squared(nearest + 1));
        let bend = before - 2.0 * at + after;
        let shift = if bend > 0.0 { (0.5 * (before - after) / bend).clamp(-0.5, 0.5) } else { 0.0 };
        let square = (at - 0.25 * (before - after) * shift).max(0.0);
        let phase = ((nearest as f64 + shift) / count as f64).rem_euclid(1.0);
        Some(CyclePlace { phase, distance: square.sqrt() / radius })
    }

    /// The latents `[Q_i]` of a part at a phase of the cycle, in turns, by linear interpolation between its
    /// frames; `None` for a part that does not exist.
    pub fn latents(&self, part: usize, phase: f64) -> Option<Vec<f64>> {
        let states = self.states.get(part)?;
        let (count, q) = (states.nrows(), states.ncols() / self.order);
        // The oldest frame of a history comes first.
        let newest = states.columns(states.ncols() - q, q);
        let at = phase.rem_euclid(1.0) * count as f64;
        let (frame, share) = (at.floor() as usize, at.fract());
        let (before, after) = (newest.row(frame % count), newest.row((frame + 1) % count));
        Some(before.iter().zip(after.iter()).map(|(a, b)| a + share * (b - a)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::TAU;

    fn circle(radius: f64) -> Cycle {
        let path = DMatrix::from_fn(200, 2, |t, q| {
            let angle = TAU * t as f64 / 32.0;
            radius * if q == 0 { angle.cos() } else { angle.sin() }
        });
        Cycle::new(&[path.clone(), path * 2.0], 2, 32.0).unwrap()
    }

    fn history(radius: f64, frame: f64) -> Vec<f64> {
        let at = |t: f64| [radius * (TAU * t / 32.0).cos(), radius * (TAU * t / 32.0).sin()];
        [at(frame - 1.0), at(frame)].concat()
    }

    #[test]
    fn a_state_on_the_cycle_has_its_phase_and_no_distance() {
        let cycle = circle(1.5);
        // The cycle begins at frame 168 of the path, 8 frames past whole turns.
        for frame in [8.0, 10.5, 23.25, 39.75] {
            let place = cycle.place(0, &history(1.5, frame)).unwrap();
            let apart = (place.phase - (frame - 8.0) / 32.0 + 0.5).rem_euclid(1.0) - 0.5;
            assert!(apart.abs() < 2e-3, "{frame} {apart} {place:?}");
            assert!(place.distance < 2e-2, "{}", place.distance);
            let other = cycle.place(1, &history(3.0, frame)).unwrap();
            assert_relative_eq!(other.phase, place.phase, epsilon = 1e-12);
        }
        assert_eq!(cycle.place(2, &[]), None);
    }

    #[test]
    fn latents_at_a_phase_have_this_phase() {
        let cycle = circle(1.5);
        for phase in [0.0, 0.26, 0.999, 1.26, -0.4] {
            let step = 1.0 / 32.0;
            let history =
                [cycle.latents(0, phase - step).unwrap(), cycle.latents(0, phase).unwrap()].concat();
            let found = cycle.place(0, &history).unwrap();
            let apart = (found.phase - phase + 0.5).rem_euclid(1.0) - 0.5;
            assert!(apart.abs() < 2e-3 && found.distance < 2e-2, "{phase} {found:?}");
        }
        assert_eq!(cycle.latents(2, 0.0), None);
    }

    #[test]
    fn distance_counts_in_radii() {
        let cycle = circle(1.5);
        let place = cycle.place(0, &history(3.0, 12.5)).unwrap();
        assert_relative_eq!(place.distance, 1.0, epsilon = 5e-3);
        assert_relative_eq!(place.phase, 4.5 / 32.0, epsilon = 2e-3);
    }

    #[test]
    fn a_motionless_path_has_no_cycle() {
        assert!(Cycle::new(&[DMatrix::from_element(90, 2, 0.3)], 2, 30.0).is_none());
    }

    /// All states are equally near: the first one counts.
    #[test]
    fn the_middle_of_the_cycle_has_a_phase() {
        let square = DMatrix::from_row_slice(8, 1, &[1.0, 1.0, -1.0, -1.0, 1.0, 1.0, -1.0, -1.0]);
        let cycle = Cycle::new(&[square], 1, 4.0).unwrap();
        assert_eq!(cycle.place(0, &[0.0]), Some(CyclePlace { phase: 0.0, distance: 1.0 }));
    }
}
