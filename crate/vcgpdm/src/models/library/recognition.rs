//! Which movement of a library a recording shows, moment by moment.
//!
//! Each movement of the library is a model of the recording, and all share the pose maps, so their densities
//! can be compared. A window slides over the recording. In each window every movement is filtered from the
//! likeliest place of its own training, as if the recording began there. The log density of a frame under a
//! movement is that in the window that contains the frame and is the likeliest in the mean of its frames. A
//! window across the border of two movements is unlikely under both, so that it does not count.
//!
//! A hidden Markov chain with a sticky prior joins the frames (Velychko et al. 2018, section 6, propose one):
//! the movement changes with the probability `1 / (frames of STAY)` from one frame to the next, to all
//! others alike. Errors of neighbouring frames are alike, because a pose map errs in the same way where the
//! poses are alike. So the frames of one window count as one observation: log densities are divided by the
//! frames of a window. Window, stay, starting points and this division are choices of ours.

use crate::elementary::Elementary;
use crate::models::data::dataset::DatasetError;
use crate::models::library::{CombinationError, TrainedLibrary};
use crate::models::rollout::request::RolloutRequest;
use crate::models::variational::{Filter, ObservationError};
use crate::motion::Clip;
use nalgebra::DMatrix;
use std::ops::Range;
use thiserror::Error;

/// Seconds of a window.
const WINDOW: f64 = 0.5;
/// Seconds from one window to the next.
const HOP: f64 = 0.1;
/// Seconds that a movement lasts under the prior, in the mean.
const STAY: f64 = 2.0;
/// Starting points that are tried for a window.
const STARTS: usize = 3;
/// The log density of a frame whose filter fails, in nats.
const IMPOSSIBLE: f64 = -1e4;

/// Why a recording cannot be recognised.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RecognitionError {
    /// A movement of the library is no model.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// The library has no movement.
    #[error("expected a library of one movement or more, found none")]
    NoMovement,
    /// There is no clip.
    #[error("expected one clip or more, found none")]
    NoClip,
    /// The clip does not fit the body.
    #[error(transparent)]
    Clip(#[from] DatasetError),
    /// The columns cannot be filtered.
    #[error("{clips}: {reason}")]
    Observation {
        /// The clips.
        clips: String,
        /// The reason.
        reason: Box<ObservationError>,
    },
}

/// The movements of a recording.
#[derive(Clone, Debug)]
pub struct Recognition {
    /// The recording [frames x columns], at the frame rate of the library.
    pub y: DMatrix<f64>,
    /// log p of every frame under every movement [frames x movements], in nats, in the likeliest window.
    pub log_densities: DMatrix<f64>,
    /// The probability of every movement in every frame given all frames [frames x movements].
    pub posterior: DMatrix<f64>,
}

/// A time in which one movement is the likeliest.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// The movement, counted from 0.
    pub movement: usize,
    /// Its frames.
    pub frames: Range<usize>,
    /// The mean of its probability.
    pub probability: f64,
}

/// A recognition under way: one step filters one window under every movement.
pub struct Recogniser {
    filters: Vec<Filter>,
    columns: DMatrix<f64>,
    y: Vec<DMatrix<f64>>,
    frame_time: f64,
    /// The first frames of the windows.
    starts: Vec<usize>,
    /// Frames of a window.
    window: usize,
    /// Windows that are filtered.
    done: usize,
    /// For each movement and frame, the mean log density of the likeliest window, and that of the frame in it.
    best: Vec<Vec<(f64, f64)>>,
}

impl TrainedLibrary {
    /// The movements of this library in clips of its body. Several clips count as one recording: each begins
    /// where the one before ends, in the same direction.
    ///
    /// # Errors
    ///
    /// When there is no clip, a clip has another body, all have fewer frames than one history, or a covariance
    /// cannot be factorised.
    pub fn recognise(&self, clips: &[&Clip]) -> Result<Recognition, RecognitionError> {
        let mut recogniser = self.recogniser(clips)?;
        while recogniser.step() < 1.0 {}
        Ok(recogniser.finish())
    }

    /// The same step by step.
    ///
    /// # Errors
    ///
    /// As [`recognise`](Self::recognise).
    pub fn recogniser(&self, clips: &[&Clip]) -> Result<Recogniser, RecognitionError> {
        let columns = self.joined(clips)?;
        let y = self.body.centred(&columns);
        let named = |reason| {
            let names: Vec<&str> = clips.iter().map(|clip| clip.name.as_str()).collect();
            RecognitionError::Observation { clips: names.join(", "), reason: Box::new(reason) }
        };
        let filter = |movement: usize| {
            let model = self.movement(movement)?;
            let view = model.coupled().ok_or(RecognitionError::NoMovement)?;
            let filter = view.filter(&RolloutRequest::default());
            filter.map_err(|reason| named(ObservationError::Rollout(reason)))
        };
        let filters = (0..self.library.movements.len()).map(filter).collect::<Result<Vec<_>, _>>()?;
        let first = filters.first().ok_or(RecognitionError::NoMovement)?;
        let frames = first.check(&y).map_err(named)?;
        let frame_time = self.body.frame_time;
        let window = frames_of(WINDOW, frame_time).max(first.order() + 1).min(frames);
        let last = frames - window;
        let starts = (0..last).step_by(frames_of(HOP, frame_time)).chain([last]).collect();
        let best = vec![vec![(f64::NEG_INFINITY, IMPOSSIBLE); frames]; filters.len()];
        Ok(Recogniser { filters, columns, y, frame_time, starts, window, done: 0, best })
    }

    /// The columns of the clips one after the other. Columns hold the speed of the body, not its place, so it
    /// does not jump from one clip to the next.
    fn joined(&self, clips: &[&Clip]) -> Result<DMatrix<f64>, RecognitionError> {
        let pieces = clips.iter().map(|clip| self.body.encode(clip)).collect::<Result<Vec<_>, _>>()?;
        let width = pieces.first().ok_or(RecognitionError::NoClip)?.ncols();
        let mut columns = DMatrix::zeros(pieces.iter().map(DMatrix::nrows).sum(), width);
        let mut row = 0;
        for piece in &pieces {
            columns.rows_mut(row, piece.nrows()).copy_from(piece);
            row += piece.nrows();
        }
        Ok(columns)
    }
}

impl Recogniser {
    /// Filters the next window; returns the share of the windows that are done.
    pub fn step(&mut self) -> f64 {
        if let Some(&start) = self.starts.get(self.done) {
            let piece: Vec<DMatrix<f64>> =
                self.y.iter().map(|y| y.rows(start, self.window).into_owned()).collect();
            for (filter, best) in self.filters.iter().zip(&mut self.best) {
                let Some((_, run)) = filter.likeliest(&piece, STARTS) else { continue };
                let mean = run.evidence() / self.window as f64;
                for (of_frame, density) in best[start..].iter_mut().zip(run.log_densities) {
                    if mean > of_frame.0 {
                        *of_frame = (mean, density.max(IMPOSSIBLE));
                    }
                }
            }
            self.done += 1;
        }
        self.done as f64 / self.starts.len() as f64
    }

    /// The movements, after all windows are done.
    pub fn finish(self) -> Recognition {
        let (frames, movements) = (self.columns.nrows(), self.filters.len());
        let log_densities = DMatrix::from_fn(frames, movements, |t, movement| self.best[movement][t].1);
        let switch = (self.frame_time / STAY).min(0.5);
        let posterior = smoothed(&(&log_densities / self.window as f64), switch);
        Recognition { y: self.columns, log_densities, posterior }
    }
}

impl Recognition {
    /// The recording in pieces of one movement each.
    pub fn segments(&self) -> Vec<Segment> {
        let best = |frame: usize| self.posterior.row(frame).transpose().argmax().0;
        let mut segments: Vec<Segment> = Vec::new();
        for frame in 0..self.posterior.nrows() {
            let movement = best(frame);
            match segments.last_mut() {
                Some(last) if last.movement == movement => last.frames.end = frame + 1,
                _ => segments.push(Segment { movement, frames: frame..frame + 1, probability: 0.0 }),
            }
        }
        for segment in &mut segments {
            let rows = self.posterior.rows(segment.frames.start, segment.frames.len());
            segment.probability = rows.column(segment.movement).mean();
        }
        segments
    }

    /// The share of the frames in which each movement is the likeliest.
    pub fn shares(&self) -> Vec<f64> {
        let (all, movements) = self.posterior.shape();
        let mut counts = vec![0; movements];
        for Segment { movement, frames, .. } in self.segments() {
            counts[movement] += frames.len();
        }
        counts.into_iter().map(|count| count as f64 / all as f64).collect()
    }
}

fn frames_of(seconds: f64, frame_time: f64) -> usize {
    ((seconds / frame_time).round() as usize).max(1)
}

/// The probability of each state in each row given all rows, from the log density of each row under each state
/// [rows x states] (the forward-backward algorithm).
fn smoothed(log_densities: &DMatrix<f64>, switch: f64) -> DMatrix<f64> {
    let (rows, states) = log_densities.shape();
    let likelihood = |t: usize, s: usize| (log_densities[(t, s)] - log_densities.row(t).max()).exponential();
    // A step of the chain: stay, or change to any other state.
    let stepped = |p: &[f64]| -> Vec<f64> {
        let (all, other) = (p.iter().sum::<f64>(), switch / (states.max(2) - 1) as f64);
        p.iter()
            .map(|own| if states < 2 { *own } else { (1.0 - switch) * own + other * (all - own) })
            .collect()
    };
    let mut forward = DMatrix::from_element(rows, states, 1.0 / states.max(1) as f64);
    let mut now = vec![1.0 / states.max(1) as f64; states];
    for t in 0..rows {
        let prior = if t == 0 { now.clone() } else { stepped(&now) };
        now = normalised((0..states).map(|s| prior[s] * likelihood(t, s)).collect());
        forward.row_mut(t).copy_from_slice(&now);
    }
    let mut posterior = forward.clone();
    let mut later = vec![1.0; states];
    for t in (0..rows.saturating_sub(1)).rev() {
        later =
            normalised(stepped(&(0..states).map(|s| later[s] * likelihood(t + 1, s)).collect::<Vec<f64>>()));
        let both = normalised((0..states).map(|s| forward[(t, s)] * later[s]).collect());
        posterior.row_mut(t).copy_from_slice(&both);
    }
    posterior
}

fn normalised(mut p: Vec<f64>) -> Vec<f64> {
    let sum: f64 = p.iter().sum();
    p.iter_mut().for_each(|value| *value /= sum);
    p
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_burst_changes_nothing_and_a_lasting_change_is_found() {
        // Two states; the second is likelier in the frames 40 to 79, and for two frames before.
        let of = |t: usize, s: usize| {
            let second = (40..80).contains(&t) || (20..22).contains(&t);
            if (s == 1) == second { 0.0 } else { -1.5 }
        };
        let log_densities = DMatrix::from_fn(120, 2, of);
        let posterior = smoothed(&log_densities, 1.0 / 60.0);
        let found = Recognition { y: DMatrix::zeros(120, 0), log_densities, posterior };
        let pieces: Vec<_> = found.segments().into_iter().map(|s| (s.movement, s.frames)).collect();
        assert_eq!(pieces, [(0, 0..40), (1, 40..80), (0, 80..120)]);
        assert!(found.posterior.row_iter().all(|row| (row.sum() - 1.0).abs() < 1e-12));
    }

    #[test]
    fn the_posterior_is_that_of_all_paths() {
        // Three states and four frames: the sum over all 81 paths.
        let log_densities = DMatrix::from_fn(4, 3, |t, s| ((7 * t + 5 * s) % 4) as f64 - 1.5);
        let switch = 0.2;
        let mut expected = DMatrix::<f64>::zeros(4, 3);
        for path in 0..81_usize {
            let states = [path % 3, path / 3 % 3, path / 9 % 3, path / 27];
            let mut weight = 1.0 / 3.0;
            for t in 0..4 {
                weight *= log_densities[(t, states[t])].exponential();
                if t > 0 {
                    weight *= if states[t] == states[t - 1] { 1.0 - switch } else { switch / 2.0 };
                }
            }
            (0..4).for_each(|t| expected[(t, states[t])] += weight);
        }
        let total = expected.row(0).sum();
        assert!((expected / total - smoothed(&log_densities, switch)).amax() < 1e-12);
    }
}
