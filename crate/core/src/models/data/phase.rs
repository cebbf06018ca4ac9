//! Alignment of trials to a common phase: recordings start anywhere in a gait cycle and have their own speed.
//!
//! The phase of frame t of a trial is start + rate t. In turns, each trial is fitted to the mean of all
//! trials (the template), and the template is computed again. The map from time to phase is a straight line
//! and not a free warp: a line can be found from the first frames of a trial, and it cannot hide differences
//! of shape.

use crate::elementary::Elementary;
use crate::motion::{Period, RHYTHMIC, period};
use nalgebra::DMatrix;

/// Number of places of the template along the axis.
const TEMPLATE: usize = 64;
/// Number of rounds of fits.
const ROUNDS: usize = 4;
/// A period with a smaller correlation than this is ignored when a cycle was asked for.
const FAINT: f64 = 0.3;
/// In a movement that is not a cycle, the largest change of a trial's start, and the largest factor of its
/// rate: such trials are cut at similar places.
const MOST_SHIFT: f64 = 0.25;
const MOST_STRETCH: f64 = 1.25;
/// A partial trial starts at most this share of a movement after all whole trials start, and not before the
/// first of them, where no trial shows how it continues.
const START_MARGIN: f64 = 0.1;
/// Number of stretches to try in each direction: a movement of several similar swings has several local
/// minima.
const STRETCHES: i32 = 6;
/// The largest ratio between the period of a trial and the common period.
const MOST_PACE: f64 = 1.5;
/// How often the steps of the search for a start are halved.
const HALVINGS: usize = 6;

/// Meaning of the phases from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseAxis {
    /// One cycle of a movement that repeats: phases are modulo 1.
    Cycle,
    /// A whole movement, from its start to its end.
    Trial,
}

/// Map from the frames of a trial to phases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhaseMap {
    /// Phase of its first frame.
    pub start: f64,
    /// Change of phase from one frame to the next, positive.
    pub rate: f64,
}

impl PhaseMap {
    /// The phase of frame `t`; on a cycle, it can exceed 1.
    pub fn at(&self, t: usize) -> f64 {
        self.start + self.rate * t as f64
    }

    /// The map with the phase in the middle of `frames` frames moved by `shift`, and the change of phase over
    /// all frames larger by `stretch`.
    pub fn moved(&self, frames: usize, shift: f64, stretch: f64) -> Self {
        let length = frames.saturating_sub(1).max(1) as f64;
        Self { start: self.start + shift - 0.5 * stretch, rate: self.rate + stretch / length }
    }
}

/// A trial to be aligned.
#[derive(Clone, Debug)]
pub struct Trial {
    /// All columns [T x D].
    pub y: DMatrix<f64>,
    /// Whether it is a whole trial; false: only its first frames, and its rate is the mean rate.
    pub whole: bool,
}

/// All trials on one axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Alignment {
    /// Meaning of the phase.
    pub axis: PhaseAxis,
    /// The map of each trial.
    pub maps: Vec<PhaseMap>,
}

impl Alignment {
    /// The mean rate of the whole `trials`.
    pub fn mean_rate(trials: &[Trial], maps: &[PhaseMap]) -> f64 {
        let whole = || trials.iter().zip(maps).filter(|(trial, _)| trial.whole);
        whole().map(|(_, map)| map.rate).sum::<f64>() / whole().count().max(1) as f64
    }

    /// Normalised time: every whole trial has phases from 0 to 1, every partial trial the mean rate.
    pub fn normalised_time(trials: &[Trial]) -> Self {
        let rate = |trial: &Trial| 1.0 / trial.y.nrows().saturating_sub(1).max(1) as f64;
        let mut maps: Vec<PhaseMap> =
            trials.iter().map(|trial| PhaseMap { start: 0.0, rate: rate(trial) }).collect();
        let mean = Self::mean_rate(trials, &maps);
        for (map, _) in maps.iter_mut().zip(trials).filter(|(_, trial)| !trial.whole) {
            map.rate = mean;
        }
        Self { axis: PhaseAxis::Trial, maps }
    }

    /// Fits every trial to the `axis`; without one, the axis is a cycle if the whole trials repeat
    /// themselves. At least one trial must be whole.
    pub fn new(trials: &[Trial], axis: Option<PhaseAxis>) -> Self {
        let whole: Vec<DMatrix<f64>> = trials.iter().filter(|t| t.whole).map(|t| t.y.clone()).collect();
        let longest = whole.iter().map(|y| y.nrows()).max().unwrap_or(1);
        let found = common_period(&whole);
        let axis = axis.unwrap_or(match found {
            Some(p) if p.correlation >= RHYTHMIC => PhaseAxis::Cycle,
            _ => PhaseAxis::Trial,
        });
        // Without a period, a cycle is as long as the longest trial.
        let common = found.filter(|p| p.correlation >= FAINT).map_or(longest as f64, |p| p.frames);
        let frames: Vec<DMatrix<f64>> = trials.iter().map(|t| t.y.transpose()).collect();
        let mut maps: Vec<PhaseMap> = trials
            .iter()
            .map(|trial| match axis {
                PhaseAxis::Cycle => PhaseMap { start: 0.0, rate: 1.0 / own_period(&trial.y, common) },
                PhaseAxis::Trial => {
                    let frames = if trial.whole { trial.y.nrows() } else { longest };
                    PhaseMap { start: 0.0, rate: 1.0 / frames.saturating_sub(1).max(1) as f64 }
                }
            })
            .collect();
        let reference = trials.iter().position(|t| t.whole && t.y.nrows() == longest).unwrap_or(0);
        let mut template = Template::new(axis, [(&frames[reference], maps[reference])]);
        let whole = || (0..trials.len()).filter(|&s| trials[s].whole);
        for round in 0..ROUNDS {
            for s in whole().filter(|&s| round > 0 || s != reference) {
                maps[s] = template.fit(&frames[s], maps[s], MOST_SHIFT, round == 0, true);
            }
            if axis == PhaseAxis::Trial {
                normalise(trials, &mut maps);
            }
            template = Template::new(axis, whole().map(|s| (&frames[s], maps[s])));
        }
        let rate = Self::mean_rate(trials, &maps);
        for s in (0..trials.len()).filter(|&s| !trials[s].whole) {
            let (first, last) = start_range(axis, trials, &maps);
            let middle = PhaseMap { start: 0.5 * (first + last), rate };
            maps[s] = template.fit(&frames[s], middle, 0.5 * (last - first), true, false);
        }
        if axis == PhaseAxis::Cycle {
            for map in &mut maps {
                map.start -= map.start.floor();
            }
        }
        Self { axis, maps }
    }

    /// The mean of the whole trials at the phases 0, 1/G, ... (a cycle) or 0, 1/(G-1), ..., 1 (a movement):
    /// [G x D].
    pub fn template(&self, trials: &[Trial]) -> DMatrix<f64> {
        let frames: Vec<(DMatrix<f64>, PhaseMap)> = (trials.iter().zip(&self.maps))
            .filter(|(trial, _)| trial.whole)
            .map(|(trial, map)| (trial.y.transpose(), *map))
            .collect();
        Template::new(self.axis, frames.iter().map(|(y, map)| (y, *map))).mean.transpose()
    }
}

/// Scales the maps so that the phases of all whole trials together are from 0 to 1.
fn normalise(trials: &[Trial], maps: &mut [PhaseMap]) {
    let (first, last) = phase_range(trials, maps);
    for map in maps {
        *map = PhaseMap { start: (map.start - first) / (last - first), rate: map.rate / (last - first) };
    }
}

/// The lowest and highest phase of the whole trials.
pub fn phase_range(trials: &[Trial], maps: &[PhaseMap]) -> (f64, f64) {
    let whole = || trials.iter().zip(maps).filter(|(trial, _)| trial.whole);
    let first = whole().map(|(_, map)| map.start).fold(f64::INFINITY, f64::min);
    let last =
        whole().map(|(t, map)| map.at(t.y.nrows().saturating_sub(1))).fold(f64::NEG_INFINITY, f64::max);
    (first, last)
}

/// The range of the start of a partial trial.
fn start_range(axis: PhaseAxis, trials: &[Trial], maps: &[PhaseMap]) -> (f64, f64) {
    if axis == PhaseAxis::Cycle {
        return (0.0, 1.0);
    }
    let starts = || trials.iter().zip(maps).filter(|(trial, _)| trial.whole).map(|(_, map)| map.start);
    (starts().fold(f64::INFINITY, f64::min), starts().fold(f64::NEG_INFINITY, f64::max) + START_MARGIN)
}

/// The period of all trials together. Walks of several speeds have no common period; then it is the median
/// of the periods of single trials, if most of them repeat within half of their length.
fn common_period(trials: &[DMatrix<f64>]) -> Option<Period> {
    let together = period(trials);
    if together.is_some_and(|p| p.correlation >= RHYTHMIC) {
        return together;
    }
    let own = trials.iter().filter_map(|y| {
        let own = period(std::slice::from_ref(y))?;
        (own.correlation >= RHYTHMIC && 2.0 * own.frames <= y.nrows() as f64).then_some(own)
    });
    let mut own: Vec<Period> = own.collect();
    own.sort_by(|a, b| a.frames.total_cmp(&b.frames));
    if 2 * own.len() > trials.len() { own.get(own.len() / 2).copied() } else { together }
}

/// The period of one trial if it is clear and near the `common` period, neither half nor twice as long.
fn own_period(y: &DMatrix<f64>, common: f64) -> f64 {
    match period(std::slice::from_ref(y)) {
        Some(p) if p.frames < MOST_PACE * common && common < MOST_PACE * p.frames => p.frames,
        _ => common,
    }
}

struct Template {
    axis: PhaseAxis,
    /// [D x G].
    mean: DMatrix<f64>,
}

impl Template {
    fn new<'a>(axis: PhaseAxis, trials: impl IntoIterator<Item = (&'a DMatrix<f64>, PhaseMap)>) -> Self {
        let mut mean = DMatrix::zeros(0, TEMPLATE);
        let mut weights = [0.0; TEMPLATE];
        for (frames, map) in trials {
            if mean.nrows() == 0 {
                mean = DMatrix::zeros(frames.nrows(), TEMPLATE);
            }
            for (t, frame) in frames.column_iter().enumerate() {
                for (place, weight) in places(axis, map.at(t)) {
                    mean.column_mut(place).axpy(weight, &frame, 1.0);
                    weights[place] += weight;
                }
            }
        }
        // A place without a frame has the mean of the nearest place with one.
        let filled: Vec<usize> = (0..TEMPLATE).filter(|&g| weights[g] > 1e-6).collect();
        for &g in &filled {
            mean.column_mut(g).scale_mut(1.0 / weights[g]);
        }
        let distance = |a: usize, b: usize| match axis {
            PhaseAxis::Cycle => a.abs_diff(b).min(TEMPLATE - a.abs_diff(b)),
            PhaseAxis::Trial => a.abs_diff(b),
        };
        for g in (0..TEMPLATE).filter(|g| weights[*g] <= 1e-6) {
            if let Some(&near) = filled.iter().min_by_key(|&&f| distance(f, g)) {
                let column = mean.column(near).into_owned();
                mean.set_column(g, &column);
            }
        }
        Self { axis, mean }
    }

    /// Mean squared distance of the frames [D x T] from the template.
    fn error(&self, frames: &DMatrix<f64>, map: PhaseMap) -> f64 {
        let mut sum = 0.0;
        for (t, frame) in frames.column_iter().enumerate() {
            let [(a, wa), (b, wb)] = places(self.axis, map.at(t));
            let (a, b) = (self.mean.column(a), self.mean.column(b));
            sum += (frame.iter().zip(a.iter()).zip(b.iter()))
                .map(|((y, a), b)| (y - wa * a - wb * b).powi(2))
                .sum::<f64>();
        }
        sum / frames.ncols().max(1) as f64
    }

    /// The map near `map` with the least error. `anywhere`: starts along the whole axis are tried first. In a
    /// movement that is not a cycle, the start moves by at most `reach`. `stretch`: the rate is fitted too.
    fn fit(
        &self,
        frames: &DMatrix<f64>,
        map: PhaseMap,
        reach: f64,
        anywhere: bool,
        stretch: bool,
    ) -> PhaseMap {
        let count = frames.ncols();
        let allowed = |m: &PhaseMap| match self.axis {
            PhaseAxis::Cycle => m.rate > 0.5 * map.rate && m.rate < 2.0 * map.rate,
            PhaseAxis::Trial => {
                let ratio = m.rate / map.rate;
                (m.start - map.start).abs() <= reach && ratio <= MOST_STRETCH && ratio * MOST_STRETCH >= 1.0
            }
        };
        let mut best = map;
        let mut least = self.error(frames, best);
        let mut consider = |m: PhaseMap, best: &mut PhaseMap| {
            let error = if allowed(&m) { self.error(frames, m) } else { f64::INFINITY };
            let better = error < least;
            if better {
                (*best, least) = (m, error);
            }
            better
        };
        let step = 1.0 / TEMPLATE as f64;
        if anywhere {
            let half = TEMPLATE as i32 / 2;
            let looks = if stretch && self.axis == PhaseAxis::Trial { STRETCHES } else { 0 };
            for stretch in -looks..=looks {
                let rate = map.rate * MOST_STRETCH.power(f64::from(stretch) / f64::from(STRETCHES));
                for k in -half..half {
                    consider(PhaseMap { start: map.start + step * f64::from(k), rate }, &mut best);
                }
            }
        }
        let mut step = step;
        for _ in 0..HALVINGS {
            let mut moves = 0;
            loop {
                let mut better = consider(best.moved(count, step, 0.0), &mut best);
                better |= consider(best.moved(count, -step, 0.0), &mut best);
                if stretch {
                    better |= consider(best.moved(count, 0.0, 2.0 * step), &mut best);
                    better |= consider(best.moved(count, 0.0, -2.0 * step), &mut best);
                }
                moves += 1;
                if !better || moves > TEMPLATE {
                    break;
                }
            }
            step *= 0.5;
        }
        best
    }
}

/// The two places of the template next to a phase, with their weights.
fn places(axis: PhaseAxis, phase: f64) -> [(usize, f64); 2] {
    match axis {
        PhaseAxis::Cycle => {
            let x = (phase - phase.floor()) * TEMPLATE as f64;
            let (low, part) = (x as usize % TEMPLATE, x - x.floor());
            [(low, 1.0 - part), ((low + 1) % TEMPLATE, part)]
        }
        PhaseAxis::Trial => {
            let x = phase.clamp(0.0, 1.0) * (TEMPLATE - 1) as f64;
            let low = (x as usize).min(TEMPLATE - 2);
            [(low, 1.0 - (x - low as f64)), (low + 1, x - low as f64)]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn walk(frames: usize, period: f64, start: f64) -> DMatrix<f64> {
        DMatrix::from_fn(frames, 3, |t, d| {
            let phase = TAU * (t as f64 / period + start);
            (phase + d as f64).sin() + 0.3 * (2.0 * phase + 0.5 * d as f64).cos()
        })
    }

    #[test]
    fn finds_starts_and_rates_of_walks() {
        let truth = [(110, 34.0, 0.1), (95, 36.0, 0.85), (101, 35.0, 0.4)];
        let mut trials: Vec<Trial> =
            truth.map(|(t, p, s)| Trial { y: walk(t, p, s), whole: true }).into_iter().collect();
        trials.push(Trial { y: walk(5, 35.0, 0.6), whole: false });
        let found = Alignment::new(&trials, None);
        assert_eq!(found.axis, PhaseAxis::Cycle);
        let origin = found.maps[0].start - 0.1;
        for (map, (_, period, start)) in found.maps.iter().zip(truth) {
            let off = map.start - start - origin;
            assert!((off - off.round()).abs() < 0.01, "{found:?}");
            assert!((map.rate * period - 1.0).abs() < 0.005, "{found:?}");
        }
        let off = found.maps[3].start - 0.6 - origin;
        assert!((off - off.round()).abs() < 0.02, "{found:?}");
    }

    #[test]
    fn phases_are_scaled_from_zero_to_one() {
        let trials = [11, 8].map(|frames| Trial { y: DMatrix::zeros(frames, 1), whole: true });
        let mut maps = [0.5, 0.3].map(|start| PhaseMap { start, rate: 0.1 });
        normalise(&trials, &mut maps);
        let (first, last) = phase_range(&trials, &maps);
        assert!(first.abs() < 1e-12 && (last - 1.0).abs() < 1e-12, "{maps:?}");
    }

    #[test]
    fn aligns_reaches_of_different_lengths() {
        let reach = |frames: usize, early: f64| {
            DMatrix::from_fn(frames, 2, |t, d| {
                let phase = early + t as f64 / (frames - 1) as f64;
                (8.0 * (phase - 0.5 + 0.1 * d as f64)).tanh()
            })
        };
        let trials: Vec<Trial> = [(60, 0.0), (90, 0.05), (75, -0.04)]
            .map(|(frames, early)| Trial { y: reach(frames, early), whole: true })
            .into();
        let found = Alignment::new(&trials, None);
        assert_eq!(found.axis, PhaseAxis::Trial);
        let middle = |s: usize| found.maps[s].at(trials[s].y.nrows() / 2);
        assert!((middle(1) - middle(0) - 0.05).abs() < 0.02, "{found:?}");
        assert!((middle(2) - middle(0) + 0.04).abs() < 0.02, "{found:?}");
    }

    #[test]
    fn walks_at_several_speeds_are_cycles() {
        let truth =
            [(112, 34.0, 0.1), (118, 44.0, 0.85), (66, 26.0, 0.4), (105, 35.0, 0.2), (120, 46.0, 0.6)];
        let trials: Vec<Trial> =
            truth.map(|(t, p, s)| Trial { y: walk(t, p, s), whole: true }).into_iter().collect();
        let found = Alignment::new(&trials, None);
        assert_eq!(found.axis, PhaseAxis::Cycle);
        let origin = found.maps[0].start - 0.1;
        for (map, (_, period, start)) in found.maps.iter().zip(truth) {
            let off = map.start - start - origin;
            assert!((off - off.round()).abs() < 0.03, "{found:?}");
            assert!((map.rate * period - 1.0).abs() < 0.02, "{found:?}");
        }
    }

    #[test]
    fn the_longest_walk_starts_at_phase_0() {
        let trials = [(90, 0.1), (110, 0.4), (95, 0.85)]
            .map(|(frames, start)| Trial { y: walk(frames, 35.0, start), whole: true });
        let found = Alignment::new(&trials, None);
        let start = found.maps[1].start;
        assert!((start - start.round()).abs() < 0.02, "{found:?}");
        assert!(found.maps.iter().all(|map| (0.0..1.0).contains(&map.start)), "{found:?}");
    }

    #[test]
    fn still_trials_have_normalised_time() {
        let trials = [20, 31].map(|frames| Trial { y: DMatrix::zeros(frames, 2), whole: true });
        assert_eq!(Alignment::new(&trials, None), Alignment::normalised_time(&trials));
    }

    /// Its frames show the middle of the movement; but no trial begins there.
    #[test]
    fn a_partial_trial_starts_at_most_a_tenth_after_the_others() {
        let y = DMatrix::from_fn(60, 2, |t, d| (8.0 * (t as f64 / 59.0 - 0.5 + 0.1 * d as f64)).tanh());
        let start = |first: usize| {
            let part = Trial { y: y.rows(first, 6).into_owned(), whole: false };
            let trials = [Trial { y: y.clone(), whole: true }, part];
            Alignment::new(&trials, Some(PhaseAxis::Trial)).maps[1].start
        };
        assert!((start(4) - 4.0 / 59.0).abs() < 5e-3, "{}", start(4));
        assert!(start(25) <= 0.1 && start(25) > 0.09, "{}", start(25));
    }

    #[test]
    fn the_largest_stretch_is_reached_and_not_exceeded() {
        let shape = |phase: f64, d: usize| (8.0 * (phase - 0.5 + 0.1 * d as f64)).tanh();
        let y = |pace: f64| DMatrix::from_fn(2, 65, |d, t| shape(0.5 + pace * (t as f64 / 64.0 - 0.5), d));
        let map = PhaseMap { start: 0.0, rate: 1.0 / 64.0 };
        let template = Template::new(PhaseAxis::Trial, [(&y(1.0), map)]);
        for (pace, expected, off) in [(0.6, 0.8, 1e-9), (0.9, 0.9, 0.01), (1.6, 1.25, 1e-9)] {
            let ratio = template.fit(&y(pace), map, MOST_SHIFT, true, true).rate / map.rate;
            assert!((ratio - expected).abs() < off, "{pace}: {ratio}");
        }
    }
}
