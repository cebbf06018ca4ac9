//! Which primitive each part of a body uses in a recording, moment by moment, and so which movement of a library
//! the recording shows.
//!
//! Each movement of the library is a model of the recording, and all share the pose maps, so their densities
//! can be compared. A window slides over the recording. In each window the columns of each part by themselves
//! are filtered under every movement from the likeliest place of its own training, as if the recording began
//! there; the other parts are not observed. The log density of a frame of a part under a primitive is that in
//! the window that contains the frame and is the likeliest in the mean of its frames, and under the likeliest
//! of the movements that use the primitive. A window across the border of two movements is unlikely under both,
//! so that it does not count.
//!
//! A state is a combination: one primitive of each part. Its log density is the sum over the parts, so that
//! parts may use primitives of several movements, at any phase. A hidden Markov chain with a sticky prior joins
//! the frames (Velychko et al. 2018, section 6, propose one): the combination changes with the probability
//! `1 / (frames of STAY)` from one frame to the next. The movements of the library share the prior probability
//! `1 - MIXED`, all other combinations `MIXED`: parts that look alike in two movements belong to the movement
//! that the other parts show. Errors of neighbouring frames are alike, because a pose map errs in the same way
//! where the poses are alike. So the frames of one window count as one observation: log densities are divided
//! by the frames of a window. Window, stay, starting points, `MIXED` and this division are choices of ours.

use crate::models::data::dataset::DatasetError;
use crate::models::kinds::model::Model;
use crate::models::library::movement_chain::MovementChain;
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
/// Seconds that a combination lasts under the prior, in the mean.
const STAY: f64 = 2.0;
/// The prior probability that a combination is not that of a movement of the library.
const MIXED: f64 = 0.001;
/// Combinations at most, beside those of the movements. Of more, the likeliest primitives of each part count.
const MOST_COMBINATIONS: usize = 1024;
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

/// The primitives of a recording.
#[derive(Clone, Debug)]
pub struct Recognition {
    /// The recording [frames x columns], at the frame rate of the library.
    pub y: DMatrix<f64>,
    /// The primitives of each part `[M]`, in the order of the library.
    pub primitives: Vec<Vec<usize>>,
    /// log p of the columns of each part by themselves in every frame under each of its primitives
    /// [frames x primitives] `[M]`, in nats, in the likeliest window.
    pub log_densities: Vec<DMatrix<f64>>,
    /// The combinations that were compared: the primitive of each part. Those of movements come first.
    pub combinations: Vec<Vec<usize>>,
    /// The probability of every combination in every frame given all frames [frames x combinations].
    pub posterior: DMatrix<f64>,
}

/// A time in which one combination is the likeliest.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// The primitive of each part `[M]`.
    pub uses: Vec<usize>,
    /// Its frames.
    pub frames: Range<usize>,
    /// The mean of its probability.
    pub probability: f64,
}

/// A filter, and the parts that it is a candidate for.
struct Candidate {
    filter: Filter,
    /// Part, and place of the primitive among those of the part.
    serves: Vec<(usize, usize)>,
}

/// A recognition under way: one step filters one window of each part under every movement.
pub struct Recogniser {
    candidates: Vec<Candidate>,
    primitives: Vec<Vec<usize>>,
    /// The combinations of the movements, each once.
    movements: Vec<Vec<usize>>,
    columns: DMatrix<f64>,
    y: Vec<DMatrix<f64>>,
    frame_time: f64,
    /// The first frames of the windows.
    starts: Vec<usize>,
    /// Frames of a window.
    window: usize,
    /// Windows that are filtered.
    done: usize,
    /// For each part, primitive and frame, the mean log density of the likeliest window, and that of the frame
    /// in this window.
    best: Vec<Vec<Vec<(f64, f64)>>>,
}

impl TrainedLibrary {
    /// The primitives of the parts in clips of this library's body. Several clips count as one recording: each
    /// begins where the one before ends, in the same direction.
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
        let filter_of = |model: &Model| {
            let view = model.coupled().ok_or(RecognitionError::NoMovement)?;
            let filter = view.filter(&RolloutRequest::default());
            filter.map_err(|reason| named(ObservationError::Rollout(reason)))
        };
        let mut movements: Vec<Vec<usize>> = Vec::new();
        for movement in &self.library.movements {
            if !movements.contains(&movement.uses) {
                movements.push(movement.uses.clone());
            }
        }
        let all = self.library.primitives.iter().enumerate();
        let of_part =
            |part: usize| all.clone().filter(move |(_, p)| p.part == part).map(|(a, _)| a).collect();
        let primitives: Vec<Vec<usize>> = (0..self.library.part_count()).map(of_part).collect();
        let candidates = self.candidates(&primitives, &filter_of)?;
        let first = candidates.first().map(|candidate| &candidate.filter);
        let first = first.ok_or(RecognitionError::NoMovement)?;
        let frames = first.check(&y).map_err(named)?;
        let frame_time = self.body.frame_time;
        let window = frames_of(WINDOW, frame_time).max(first.order() + 1).min(frames);
        let last = frames - window;
        let starts = (0..last).step_by(frames_of(HOP, frame_time)).chain([last]).collect();
        let unknown = vec![(f64::NEG_INFINITY, IMPOSSIBLE); frames];
        let best = primitives.iter().map(|of_part| vec![unknown.clone(); of_part.len()]).collect();
        Ok(Recogniser {
            candidates,
            primitives,
            movements,
            columns,
            y,
            frame_time,
            starts,
            window,
            done: 0,
            best,
        })
    }

    /// A filter of every movement, and of every primitive that no movement uses.
    fn candidates(
        &self,
        primitives: &[Vec<usize>],
        filter_of: &dyn Fn(&Model) -> Result<Filter, RecognitionError>,
    ) -> Result<Vec<Candidate>, RecognitionError> {
        let place = |part: usize, used: usize| primitives[part].iter().position(|a| *a == used);
        let mut candidates = Vec::new();
        for (m, movement) in self.library.movements.iter().enumerate() {
            let serves = movement.uses.iter().enumerate();
            let serves = serves.filter_map(|(part, used)| Some((part, place(part, *used)?))).collect();
            candidates.push(Candidate { filter: filter_of(&self.movement(m)?)?, serves });
        }
        let Some(first) = self.library.movements.first() else { return Ok(candidates) };
        for (part, of_part) in primitives.iter().enumerate() {
            for (place, &primitive) in of_part.iter().enumerate() {
                if self.library.movements.iter().any(|movement| movement.uses[part] == primitive) {
                    continue;
                }
                let mut uses = first.uses.clone();
                uses[part] = primitive;
                let model = self.combination(&uses, &self.library.nearest_couplings(&uses))?;
                candidates.push(Candidate { filter: filter_of(&model)?, serves: vec![(part, place)] });
            }
        }
        Ok(candidates)
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
            for part in 0..self.y.len() {
                let observed = self.window_of(part, start);
                for candidate in &self.candidates {
                    let Some(&(_, primitive)) = candidate.serves.iter().find(|(own, _)| *own == part) else {
                        continue;
                    };
                    let Some((_, run)) = candidate.filter.likeliest(&observed, STARTS) else { continue };
                    let mean = run.evidence() / self.window as f64;
                    let best = &mut self.best[part][primitive];
                    for (of_frame, density) in best[start..].iter_mut().zip(run.log_densities) {
                        if mean > of_frame.0 {
                            *of_frame = (mean, density.max(IMPOSSIBLE));
                        }
                    }
                }
            }
            self.done += 1;
        }
        self.done as f64 / self.starts.len() as f64
    }

    /// The columns of a part in a window, and missing numbers for the other parts.
    fn window_of(&self, part: usize, start: usize) -> Vec<DMatrix<f64>> {
        let piece = |(k, y): (usize, &DMatrix<f64>)| {
            if k == part {
                y.rows(start, self.window).into_owned()
            } else {
                DMatrix::from_element(self.window, y.ncols(), f64::NAN)
            }
        };
        self.y.iter().enumerate().map(piece).collect()
    }

    /// The primitives of the parts, after all windows are done.
    pub fn finish(self) -> Recognition {
        let frames = self.columns.nrows();
        let of_part = |best: &Vec<Vec<(f64, f64)>>| DMatrix::from_fn(frames, best.len(), |t, a| best[a][t].1);
        let log_densities: Vec<DMatrix<f64>> = self.best.iter().map(of_part).collect();
        let combinations = self.combinations(&log_densities);
        let mut together = DMatrix::zeros(frames, combinations.len());
        for (mut column, uses) in together.column_iter_mut().zip(&combinations) {
            for ((densities, primitives), used) in log_densities.iter().zip(&self.primitives).zip(uses) {
                if let Some(place) = primitives.iter().position(|a| a == used) {
                    column += densities.column(place);
                }
            }
        }
        let (known, others) = (self.movements.len(), combinations.len() - self.movements.len());
        let mixed = if others > 0 { MIXED } else { 0.0 };
        let prior = |state: usize| {
            if state < known { (1.0 - mixed) / known as f64 } else { mixed / others as f64 }
        };
        let chain = MovementChain {
            change: (self.frame_time / STAY).min(0.5),
            prior: (0..combinations.len()).map(prior).collect(),
        };
        let posterior = chain.posterior(&(together / self.window as f64));
        Recognition { y: self.columns, primitives: self.primitives, log_densities, combinations, posterior }
    }

    /// The combinations to compare: those of the movements, then those of the likeliest primitives of each part.
    fn combinations(&self, log_densities: &[DMatrix<f64>]) -> Vec<Vec<usize>> {
        let parts = self.primitives.len();
        let fits = |count: &usize| count.saturating_pow(parts as u32) <= MOST_COMBINATIONS;
        let most = (1..).take_while(fits).last().unwrap_or(1);
        let mut combinations = self.movements.clone();
        let mut all = vec![Vec::new()];
        for (primitives, densities) in self.primitives.iter().zip(log_densities) {
            let mut wins = vec![0_usize; primitives.len()];
            densities.row_iter().for_each(|row| wins[row.transpose().argmax().0] += 1);
            let mut likeliest: Vec<usize> = (0..primitives.len()).collect();
            likeliest.sort_by_key(|place| std::cmp::Reverse(wins[*place]));
            likeliest.truncate(most);
            let extended = |uses: &Vec<usize>| -> Vec<Vec<usize>> {
                likeliest.iter().map(|place| [&uses[..], &[primitives[*place]]].concat()).collect()
            };
            all = all.iter().flat_map(extended).collect();
        }
        combinations.extend(all.into_iter().filter(|uses| !self.movements.contains(uses)));
        combinations
    }
}

impl Recognition {
    /// The recording in pieces of one combination each.
    pub fn segments(&self) -> Vec<Segment> {
        let best = |frame: usize| self.posterior.row(frame).transpose().argmax().0;
        let mut segments: Vec<(usize, Range<usize>)> = Vec::new();
        for frame in 0..self.posterior.nrows() {
            let state = best(frame);
            match segments.last_mut() {
                Some((last, frames)) if *last == state => frames.end = frame + 1,
                _ => segments.push((state, frame..frame + 1)),
            }
        }
        let segment = |(state, frames): (usize, Range<usize>)| {
            let probability = self.posterior.column(state).rows(frames.start, frames.len()).mean();
            Segment { uses: self.combinations[state].clone(), frames, probability }
        };
        segments.into_iter().map(segment).collect()
    }

    /// The probability of each primitive of a part in every frame given all frames [frames x primitives]: the
    /// sum over the combinations that use the primitive.
    pub fn part_posterior(&self, part: usize) -> DMatrix<f64> {
        let primitives = &self.primitives[part];
        let mut posterior = DMatrix::zeros(self.posterior.nrows(), primitives.len());
        for (uses, column) in self.combinations.iter().zip(self.posterior.column_iter()) {
            if let Some(place) = primitives.iter().position(|a| *a == uses[part]) {
                let mut sum = posterior.column_mut(place);
                sum += column;
            }
        }
        posterior
    }
}

fn frames_of(seconds: f64, frame_time: f64) -> usize {
    ((seconds / frame_time).round() as usize).max(1)
}

crate::coded!(RecognitionError {
    Self::Combination(reason) => reason.code(),
    Self::Clip(reason) => reason.code(),
    Self::Observation { reason, .. } => reason.code(),
    _ => Clips,
});
