//! Who moves a part of a live rollout in place of the model: somebody's hand, or a recording.

use crate::models::kinds::coupled::Coupled;
use crate::models::kinds::reach::Reach;
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::variational::Cycle;
use nalgebra::DMatrix;
use std::sync::Arc;

/// A part that was elsewhere when its mover began keeps this share of the distance from one frame to the next.
const APPROACH: f64 = 0.8;

/// What moves a part.
#[derive(Clone, Debug)]
pub(super) enum Mover {
    /// Somebody who turns the part round its learned cycle.
    Wheel {
        /// The phase on the cycle, in turns.
        phase: f64,
        /// Turns that are left for the next frames.
        ahead: f64,
        /// Turns from the frame before to the newest frame.
        step: f64,
    },
    /// A recording, again and again.
    Recording {
        /// The latents of the part in all frames of the recording [frames x Q_i].
        latents: Arc<DMatrix<f64>>,
        /// The frame of the recording in the newest frame.
        frame: usize,
    },
    /// Somebody who drags a node of the figure.
    Hand(Reach),
}

/// A part that the model does not move.
#[derive(Clone, Debug)]
pub(super) struct Moved {
    pub(super) part: usize,
    pub(super) by: Mover,
    /// The rest of the distance from the place that the mover wants, which fades `[Q_i]`.
    beside: Vec<f64>,
}

impl Moved {
    pub(super) fn by_wheel(part: usize, paths: &LatentPaths, cycle: &Cycle, turns: f64) -> Self {
        let phase = cycle.place(part, &paths.history(part)).map_or(0.0, |place| place.phase);
        let on_cycle = cycle.latents(part, phase).unwrap_or_default();
        let beside = difference(paths.newest(part), &on_cycle);
        Self { part, by: Mover::Wheel { phase, ahead: turns, step: 0.0 }, beside }
    }

    /// The recording begins after its frame that is nearest to the part's last frames.
    pub(super) fn by_recording(part: usize, paths: &LatentPaths, latents: DMatrix<f64>) -> Self {
        let (frame, beside) = nearest(&latents, &paths.history(part));
        Self { part, by: Mover::Recording { latents: Arc::new(latents), frame }, beside }
    }

    pub(super) fn by_hand(part: usize, reach: Reach) -> Self {
        Self { part, by: Mover::Hand(reach), beside: Vec::new() }
    }

    /// Sets the newest latents of the part; `frames` frames are left for the turns of a wheel, this one included.
    pub(super) fn set_newest(
        &mut self,
        paths: &mut LatentPaths,
        model: Coupled,
        cycle: Option<&Cycle>,
        frames: usize,
    ) {
        let Mover::Hand(reach) = &self.by else { return self.follow(paths, cycle, frames) };
        let newest = paths.frames() - 1;
        let predicted = paths.matrices(newest..newest + 1);
        let before = paths.history_until(self.part, newest);
        let before = &before[before.len() - paths.latent()[self.part]..];
        let latents = reach.latents(model, self.part, &predicted, before);
        paths.set_newest(self.part, &latents);
    }

    /// The same for a wheel or a recording.
    fn follow(&mut self, paths: &mut LatentPaths, cycle: Option<&Cycle>, frames: usize) {
        let wanted = match &mut self.by {
            Mover::Wheel { phase, ahead, step } => {
                *step = *ahead / frames as f64;
                *ahead -= *step;
                *phase += *step;
                cycle.and_then(|cycle| cycle.latents(self.part, *phase)).unwrap_or_default()
            }
            Mover::Recording { latents, frame } => {
                if *frame + 1 == latents.nrows() {
                    let before = paths.history_until(self.part, paths.frames() - 1);
                    (*frame, self.beside) = nearest(latents, &before);
                }
                *frame += 1;
                latents.row(*frame).iter().copied().collect()
            }
            Mover::Hand(_) => return,
        };
        self.beside.iter_mut().for_each(|x| *x *= APPROACH);
        let latents: Vec<f64> = wanted.iter().zip(&self.beside).map(|(on, beside)| on + beside).collect();
        paths.set_newest(self.part, &latents);
    }
}

fn difference(now: &[f64], wanted: &[f64]) -> Vec<f64> {
    now.iter().zip(wanted).map(|(now, wanted)| now - wanted).collect()
}

/// The frame in the first half of a recording [frames x Q] whose last p frames are nearest to a history `[p Q]`,
/// and how far the end of the history is from this frame `[Q]`. The recording has 2 p frames or more, so that
/// another frame follows.
fn nearest(latents: &DMatrix<f64>, history: &[f64]) -> (usize, Vec<f64>) {
    let states = latents.transpose();
    let (q, states) = (latents.ncols(), states.as_slice());
    let state = |frame: usize| &states[((frame + 1) * q).saturating_sub(history.len())..(frame + 1) * q];
    let squared =
        |frame: &usize| -> f64 { state(*frame).iter().zip(history).map(|(a, b)| (a - b).powi(2)).sum() };
    let first = history.len() / q.max(1) - 1;
    let frames = first..latents.nrows() / 2;
    let frame = frames.min_by(|a, b| squared(a).total_cmp(&squared(b))).unwrap_or(first);
    (frame, difference(&history[history.len() - q..], &state(frame)[history.len() - q..]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Two dimensions that turn once in 20 frames.
    fn circle(frames: usize, begin: f64) -> DMatrix<f64> {
        DMatrix::from_fn(frames, 2, |t, q| {
            let angle = TAU * (begin + t as f64) / 20.0;
            if q == 0 { angle.cos() } else { angle.sin() }
        })
    }

    #[test]
    fn a_recording_begins_and_begins_again_where_it_resembles_the_part() {
        // The part stands at the phase of frame 13 of the recording, which has two turns and a half.
        let mut paths = LatentPaths::new(&[circle(2, 12.0)], 2, &[2]).unwrap();
        let recording = circle(50, 0.0);
        let mut moved = Moved::by_recording(0, &paths, recording.clone());
        let mut seen = Vec::new();
        for _ in 0..60 {
            paths.append(&[vec![9.0, 9.0]]);
            moved.follow(&mut paths, None, 1);
            let Mover::Recording { frame, .. } = moved.by else { panic!("not a recording") };
            assert!((DMatrix::from_row_slice(1, 2, paths.newest(0)) - recording.row(frame)).amax() < 1e-12);
            seen.push(frame);
        }
        // Frame 49 has the phase of frame 9.
        assert_eq!((seen[0], seen[35], seen[36], seen[59]), (14, 49, 10, 33));
    }

    #[test]
    fn a_distant_part_approaches_the_recording_without_a_jump() {
        let mut paths = LatentPaths::new(&[circle(2, 12.0) * 3.0], 2, &[2]).unwrap();
        let recording = circle(50, 0.0);
        let mut moved = Moved::by_recording(0, &paths, recording);
        let mut before = paths.newest(0).to_vec();
        for _ in 0..80 {
            paths.append(&[vec![9.0, 9.0]]);
            moved.follow(&mut paths, None, 1);
            let step = difference(paths.newest(0), &before).iter().map(|x| x * x).sum::<f64>();
            assert!(step < 0.6 * 0.6, "{step}");
            before = paths.newest(0).to_vec();
        }
        let radius = before.iter().map(|x| x * x).sum::<f64>();
        assert!((radius - 1.0).abs() < 1e-3, "{radius}");
    }
}
