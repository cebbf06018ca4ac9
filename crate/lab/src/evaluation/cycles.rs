//! Cuts trials of a periodic movement to whole cycles from the same phase, so that models of goal-directed
//! movements can learn it (Velychko et al. 2019, section 3.2: every trial has three gait cycles).

use nalgebra::DMatrix;
use thiserror::Error;
use vcgpdm_core::models::{Alignment, Dataset, DatasetError, PhaseAxis, PhaseMap, Source, Trial};
use vcgpdm_core::motion::parts::PartSpec;
use vcgpdm_core::motion::{Clip, ClipError};

/// Number of phases of the cycle where cuts can begin.
const PHASES: usize = 32;

/// Why trials cannot be cut to whole cycles.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CyclesError {
    /// The trials cannot be used together.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// A trial cannot be cut.
    #[error(transparent)]
    Clip(#[from] ClipError),
    /// The movement is not periodic.
    #[error("expected a periodic movement to cut to whole cycles, found none in these trials")]
    NoCycle,
    /// A trial has no whole cycle.
    #[error("expected a whole cycle in every trial, from the same phase; found none in trial {}", .trial + 1)]
    Short {
        /// Counted from 0.
        trial: usize,
    },
}

/// The trials cut to the same number of whole cycles, as many as all have, and this number.
///
/// # Errors
/// The trials cannot be used together at this frame rate, are not periodic, or one is shorter than a cycle.
pub fn whole_cycles(trials: &[Clip], frames_per_second: f64) -> Result<(Vec<Clip>, usize), CyclesError> {
    let whole: Vec<Source> = trials.iter().map(|clip| Source { clip, first_frames: None }).collect();
    let joints = trials.first().map_or(0, |clip| clip.skeleton.joints.len());
    let body = PartSpec { name: "body".to_owned(), joints: (0..joints).collect() };
    let dataset = Dataset::new(&whole, &[body], frames_per_second)?;
    let mut movements: Vec<DMatrix<f64>> = Vec::new();
    let mut at = 0;
    for frames in dataset.lengths() {
        movements.push(dataset.y[0].rows(at, frames).into_owned());
        at += frames;
    }
    let aligned: Vec<Trial> = movements.into_iter().map(|y| Trial { y, whole: true }).collect();
    let Alignment { axis, maps } = Alignment::new(&aligned, None);
    if axis != PhaseAxis::Cycle {
        return Err(CyclesError::NoCycle);
    }
    let counts = |place: f64| -> Vec<usize> {
        maps.iter().zip(&aligned).map(|(map, trial)| cycles(map, trial.y.nrows(), place)).collect()
    };
    // The place from which the trial with the fewest has most, then from which all have most.
    let worth = |place: f64| {
        let counts = counts(place);
        (counts.iter().min().copied().unwrap_or(0), counts.iter().sum::<usize>())
    };
    let places = || (0..PHASES).map(|k| k as f64 / PHASES as f64);
    let place = places().rev().max_by_key(|place| worth(*place)).unwrap_or(0.0);
    let count = worth(place).0;
    if count == 0 {
        let trial = counts(place).iter().position(|count| *count == 0).unwrap_or(0);
        return Err(CyclesError::Short { trial });
    }
    let cut = |(clip, map): (&Clip, &PhaseMap)| {
        let frame = |phase: f64| {
            let seconds = (phase - map.start) / map.rate * dataset.frame_time;
            (seconds / clip.frame_time).round().max(0.0) as usize
        };
        let first = first_at(map, place);
        let end = (frame(first + count as f64) + 1).min(clip.frames());
        Ok(clip.cut(frame(first), end)?)
    };
    let clips: Result<Vec<Clip>, CyclesError> = trials.iter().zip(&maps).map(cut).collect();
    Ok((clips?, count))
}

/// The first phase of a trial at which the cycle is at `place`.
fn first_at(map: &PhaseMap, place: f64) -> f64 {
    place + (map.start - place).ceil()
}

/// The number of whole cycles of a trial of `frames` frames, counted from `place` on.
fn cycles(map: &PhaseMap, frames: usize, place: f64) -> usize {
    (map.at(frames.saturating_sub(1)) - first_at(map, place)).max(0.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use vcgpdm_core::motion::samples;

    #[test]
    fn walks_hold_equally_many_cycles_from_the_same_place() {
        let trials: Vec<Clip> =
            samples::list().iter().take(3).map(|s| samples::clip(s.id).unwrap()).collect();
        let (cut, count) = whole_cycles(&trials, 30.0).unwrap();
        assert!(count >= 1, "{count}");
        for (clip, trial) in cut.iter().zip(&trials) {
            let (first, end) = clip.piece.unwrap();
            assert!(end <= trial.frames() && clip.frames() == end - first);
        }
        // Cut again, nothing but the rounding of a frame is lost: first and last frame are at the same place.
        let sources: Vec<Source> = cut.iter().map(|clip| Source { clip, first_frames: None }).collect();
        let joints = (0..cut[0].skeleton.joints.len()).collect();
        let dataset = Dataset::new(&sources, &[PartSpec { name: "body".to_owned(), joints }], 30.0).unwrap();
        let (mut at, mut firsts) = (0, Vec::new());
        for frames in dataset.lengths() {
            let y = dataset.y[0].rows(at, frames);
            let spread = y.row_variance().sum();
            let apart = (y.row(0) - y.row(frames - 1)).norm_squared();
            assert!(apart < 0.5 * spread, "{apart} of {spread}");
            firsts.push(y.row(0).into_owned());
            at += frames;
        }
        let spread = dataset.y[0].row_variance().sum();
        assert!((&firsts[0] - &firsts[1]).norm_squared() < 0.5 * spread);
    }

    #[test]
    fn what_is_shorter_than_a_cycle_is_refused() {
        let trials: Vec<Clip> =
            samples::list().iter().take(2).map(|s| samples::clip(s.id).unwrap()).collect();
        let short = [trials[0].clone(), trials[1].cut(0, 20).unwrap()];
        let error = whole_cycles(&short, 30.0).unwrap_err().to_string();
        assert!(error.contains("found none in trial 2"), "{error}");
    }
}
