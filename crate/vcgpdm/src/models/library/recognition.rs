//! Which movement of a library a recording shows, moment by moment.
//!
//! Each movement of the library is a model of the recording, and all share the pose maps, so their densities
//! can be compared. A window slides over the recording. In each window every movement is filtered from the
//! likeliest place of its own training, as if the recording began there. The log density of a frame under a
//! movement is the mean over the windows that contain the frame.
//!
//! A hidden Markov chain with a sticky prior joins the frames (Velychko et al. 2018, section 6, propose one):
//! the movement changes with the probability `1 / (frames of STAY)` from one frame to the next, to all
//! others alike. Errors of neighbouring frames are alike, because a pose map errs in the same way where the
//! poses are alike. So the frames of one window count as one observation: log densities are divided by the
//! frames of a window. Window, stay and this division are choices of ours.

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
/// The log density of a frame whose filter fails, in nats.
const IMPOSSIBLE: f64 = -1e4;

/// Why a recording cannot be recognised.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RecognitionError {
    /// A movement of the library is no model.
    #[error(transparent)]
    Combination(#[from] CombinationError),
    /// The clip does not fit the body.
    #[error(transparent)]
    Clip(#[from] DatasetError),
    /// The columns cannot be filtered.
    #[error("{clip}: {reason}")]
    Observation {
        /// The clip.
        clip: String,
        /// The reason.
        reason: Box<ObservationError>,
    },
}

/// The movements of a recording.
#[derive(Clone, Debug)]
pub struct Recognition {
    /// log p of every frame under every movement [frames x movements], in nats; means over windows.
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

impl TrainedLibrary {
    /// The movements of this library in a clip of its body.
    ///
    /// # Errors
    ///
    /// When the clip has another body or fewer frames than one history, or a covariance cannot be factorised.
    pub fn recognise(&self, clip: &Clip) -> Result<Recognition, RecognitionError> {
        let columns = self.body.encode(clip)?;
        let y = self.body.centred(&columns);
        let named =
            |reason| RecognitionError::Observation { clip: clip.name.clone(), reason: Box::new(reason) };
        let mut log_densities = DMatrix::zeros(columns.nrows(), self.library.movements.len());
        for movement in 0..log_densities.ncols() {
            let model = self.movement(movement)?;
            let Some(coupled) = model.coupled() else { continue };
            let filter = coupled
                .filter(&RolloutRequest::default())
                .map_err(|reason| named(ObservationError::Rollout(reason)))?;
            let found = in_windows(&filter, &y, self.body.frame_time).map_err(named)?;
            log_densities.column_mut(movement).copy_from_slice(&found);
        }
        let window = frames_of(WINDOW, self.body.frame_time) as f64;
        let switch = (self.body.frame_time / STAY).min(0.5);
        let posterior = smoothed(&(&log_densities / window), switch);
        Ok(Recognition { log_densities, posterior })
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

/// The log density of each frame: the mean over the windows that contain it.
fn in_windows(filter: &Filter, y: &[DMatrix<f64>], frame_time: f64) -> Result<Vec<f64>, ObservationError> {
    let frames = filter.check(y)?;
    let window = frames_of(WINDOW, frame_time).max(filter.order() + 1).min(frames);
    let last = frames - window;
    let starts = (0..last).step_by(frames_of(HOP, frame_time)).chain([last]);
    let (mut sums, mut counts) = (vec![0.0; frames], vec![0.0_f64; frames]);
    for start in starts {
        let piece: Vec<DMatrix<f64>> = y.iter().map(|y| y.rows(start, window).into_owned()).collect();
        let found = filter.run_from_best(&piece, window).map(|run| run.log_densities);
        for k in 0..window {
            let density = found.as_ref().map_or(IMPOSSIBLE, |found| found[k]);
            sums[start + k] += if density.is_finite() { density.max(IMPOSSIBLE) } else { IMPOSSIBLE };
            counts[start + k] += 1.0;
        }
    }
    Ok(sums.iter().zip(counts).map(|(sum, count)| sum / count).collect())
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
        let found = Recognition { log_densities, posterior };
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
