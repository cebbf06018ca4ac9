//! Health of a rollout: whether it keeps moving, keeps one pose, visits few of its clips' poses, leaves the
//! range of its training or breaks down.

use crate::gp::NumericsError;
use crate::gp::linalg::stacked;
use crate::models::kinds::coupled::Coupled;
use crate::models::rollout::pace::Pace;
use crate::models::rollout::request::{Rollout, RolloutRequest};
use crate::motion::measures::poses::Poses;
use nalgebra::DMatrix;
use serde::Serialize;
use std::cmp::Ordering;

/// A body or part keeps one pose while it differs from its last pose by at most this share of the spread of
/// the clips' poses.
const ONE_POSE: f64 = 0.1;
/// Shortest time of one pose until the end, in seconds.
const STILL_FOR: f64 = 1.0;
/// A body in one pose stands still if the root mean square speed of its nodes is less; in metres a second.
const TRAVELS: f64 = 0.1;
/// A rollout visits a pose when it comes nearer than this share of the spread of the clips' poses.
const NEAR: f64 = 0.5;
/// A viewer does not see smaller differences of poses, in metres.
const SEEN: f64 = 0.02;
/// A smaller share of the clips' way is few poses.
const FEW: f64 = 0.5;
/// The columns of the root's turn and steps.
const TRAVEL_COLUMNS: usize = 3;
/// A part is outside the range of its training when its inducing points explain less than this share of the
/// variance.
const FAMILIAR: f64 = 0.5;
/// A part has left the range when it is outside for at least this long until the end; in seconds.
const AWAY_FOR: f64 = 1.0;
/// A rollout rests as recorded when it rests at most this much earlier than its recording; in seconds.
const EARLY: f64 = 0.5;

/// Frames a second of a rollout that are compared with those of clips, so that the time does not grow with the
/// square of a high frame rate.
const JUDGED_RATE: f64 = 30.0;
/// How a rollout ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Ending {
    /// It keeps moving, with every part in the range of its training.
    MovesOn,
    /// The pose hardly changes until the end, and the body neither travels nor turns.
    StandsStill,
    /// The pose hardly changes until the end, but the body travels or turns.
    KeepsOnePose,
    /// It stands still in the end, as does its recording at nearly the same time.
    RestsAsRecorded,
    /// A part visits less than half of its clips' poses; see [`PartPoses::visited`].
    VisitsFewPoses,
    /// Until the end, the latents of a part are far from those of the training; see `Vcgpdm::familiarity`.
    LeavesTrainingRange,
    /// A part or the body is much faster than in its clips, or its steps turn back much more often; see [`Pace`].
    Shakes,
    /// A latent or position is not a finite number.
    NotFinite,
}

/// How a rollout ends, and its poses compared with those of the clips.
///
/// The distance of two poses is the root mean square distance of their nodes, relative to the root and with
/// heading 0, in metres for a body 1.7 m tall. For the pose of one part, the others keep their mean pose. The
/// spread of poses is their distance from their mean.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Health {
    /// It rests as recorded where the recording that it begins as comes to rest too, hardly later. It keeps
    /// one pose where the body travels or turns in that pose. It shakes where the body or a part is more than
    /// twice as fast as in its clips, or turns back in 30 per cent more of its steps: thresholds of this
    /// project.
    #[cfg_attr(feature = "types", ts(inline))]
    pub state: Ending,
    /// Seconds from the first frame until it keeps one pose or leaves the training range.
    pub from: Option<f64>,
    /// The part that leaves the training range, visits the smallest share of its poses, or shakes.
    pub part: Option<usize>,
    /// How good it is to show: 3 where it moves on or rests as recorded, 0 where it shakes or is not finite.
    pub rank: u8,
    /// The pace of the body as a whole; `None` for numbers that are not finite.
    pub pace: Option<Pace>,
    /// The poses of each part.
    pub parts: Vec<PartPoses>,
}

/// The poses of one part in a rollout.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct PartPoses {
    /// The share of the clips' poses that the second half of the rollout visits: that has a pose nearer than
    /// half of the spread of the clips' poses, or than 2 cm. A pose counts as far as the part has moved since
    /// the frame before, so that rests count nothing. `None`: the model has not kept the latents of its
    /// clips' frames.
    pub visited: Option<f64>,
    /// Seconds until it keeps one pose: from then to the end, and for at least one second, the pose differs
    /// from the last one by at most a tenth of the spread of the clips' poses. `None`: it moves on.
    pub still_from: Option<f64>,
    /// Its speed and smoothness.
    pub pace: Pace,
}

impl Health {
    /// Whether nothing is worse than before: neither the rank, nor the pace of the body or of a part, nor the
    /// share of the poses that a part visits: half of them are enough.
    pub(in crate::models) fn is_no_worse_than(&self, before: &Health) -> bool {
        let paces = |health: &Health| {
            health.pace.into_iter().chain(health.parts.iter().map(|part| part.pace)).collect::<Vec<_>>()
        };
        let calm =
            paces(self).iter().zip(&paces(before)).all(|(after, before)| after.is_no_worse_than(before));
        let visits =
            self.parts.iter().zip(&before.parts).all(|(after, before)| {
                after.visited.unwrap_or(1.0) >= before.visited.unwrap_or(1.0).min(FEW)
            });
        // A motion in one pose visits few poses as it is.
        self.rank >= before.rank && calm && (visits || before.rank < Ending::VisitsFewPoses.rank())
    }

    /// Whether it moves on, or rests as its recording does.
    pub fn is_good(&self) -> bool {
        self.rank == Ending::MovesOn.rank()
    }
}

impl Ending {
    fn rank(self) -> u8 {
        match self {
            Ending::MovesOn | Ending::RestsAsRecorded => 3,
            Ending::VisitsFewPoses => 2,
            Ending::StandsStill | Ending::KeepsOnePose | Ending::LeavesTrainingRange => 1,
            Ending::Shakes | Ending::NotFinite => 0,
        }
    }
}

/// The model to show among several of one data set, each given as its [rank](Health::rank) and the error of
/// its rollouts on the trials trained on, infinite if unknown: the smallest error of the highest rank, the
/// first of equals. `None` without a model.
pub fn best_to_show(models: impl IntoIterator<Item = (u8, f64)>) -> Option<usize> {
    let better = |a: (u8, f64), b: (u8, f64)| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1));
    let first = |best: (usize, (u8, f64)), next: (usize, (u8, f64))| {
        if better(next.1, best.1) == Ordering::Greater { next } else { best }
    };
    models.into_iter().enumerate().reduce(first).map(|(place, _)| place)
}

impl Coupled<'_> {
    /// The health of the rollout of `request`, with its positions from [`Coupled::positions`]. A rollout that
    /// both keeps one pose and is far from its training counts as keeping one pose, which a viewer can see.
    ///
    /// # Errors
    ///
    /// When a covariance of inducing points cannot be factorised.
    pub fn health(
        &self,
        rollout: &Rollout,
        request: &RolloutRequest,
        positions: &[f32],
    ) -> Result<Health, NumericsError> {
        let finite = rollout.latents.iter().all(|path| path.iter().all(|x| x.is_finite()))
            && positions.iter().all(|place| place.is_finite());
        let ends = |state: Ending, from, part, pace, parts| Health {
            state,
            from,
            part,
            rank: state.rank(),
            pace,
            parts,
        };
        let broken = ends(Ending::NotFinite, None, None, None, Vec::new());
        if !finite {
            return Ok(broken);
        }
        let seconds = |frames: usize| frames as f64 * self.body.frame_time;
        let still_from = |poses: &Poses, spread: f64| {
            let frames = poses.last_still(ONE_POSE * spread).saturating_sub(1);
            (seconds(frames) >= STILL_FOR).then(|| seconds(poses.frames() - 1 - frames))
        };
        let (clips, begins) = self.clip_columns();
        let mut parts = Vec::new();
        for part in 0..self.body.layout.parts().len() {
            let (Some(clips), Some(poses)) =
                (self.poses(&clips, Some(part)), self.poses(&rollout.y, Some(part)))
            else {
                return Ok(broken);
            };
            let spread = clips.spread();
            let second_half = (&poses, poses.frames() / 2, self.judged_stride());
            let visited = || clips.visited(&begins, second_half, (NEAR * spread).max(SEEN));
            parts.push(PartPoses {
                visited: (!begins.is_empty()).then(visited),
                still_from: still_from(&poses, spread),
                pace: Pace::of(&poses, &clips, &begins, self.body.frame_time),
            });
        }
        let (Some(clips), Some(body)) = (self.poses(&clips, None), self.poses(&rollout.y, None)) else {
            return Ok(broken);
        };
        let pace = Pace::of(&body, &clips, &begins, self.body.frame_time);
        let health = |state, from, part, parts| ends(state, from, part, Some(pace), parts);
        let times = |part: &usize| parts[*part].pace.times.unwrap_or(0.0);
        let shaking = (0..parts.len()).filter(|part| parts[*part].pace.shakes());
        let worst = shaking.max_by(|a, b| times(a).total_cmp(&times(b)));
        if worst.is_some() || pace.shakes() {
            return Ok(health(Ending::Shakes, None, worst, parts));
        }
        if let Some(from) = still_from(&body, clips.spread()) {
            let state = self.still_state(request, positions, from);
            return Ok(health(state, Some(from), None, parts));
        }
        let familiarity = self.model.familiarity(&rollout.latents)?;
        let away = familiarity.iter().enumerate().filter_map(|(part, shares)| {
            let frames = shares.iter().rev().take_while(|share| **share < FAMILIAR).count();
            (seconds(frames) >= AWAY_FOR).then_some((seconds(shares.len() - frames), part))
        });
        if let Some((from, part)) = away.min_by(|a, b| a.0.total_cmp(&b.0)) {
            return Ok(health(Ending::LeavesTrainingRange, Some(from), Some(part), parts));
        }
        let shares = parts.iter().enumerate().filter_map(|(part, poses)| Some((poses.visited?, part)));
        Ok(match shares.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((share, part)) if share < FEW => health(Ending::VisitsFewPoses, None, Some(part), parts),
            _ => health(Ending::MovesOn, None, None, parts),
        })
    }

    /// Of a rollout at a high frame rate, every second, third, ... frame is compared with the clips: about
    /// [`JUDGED_RATE`] frames a second.
    pub(in crate::models) fn judged_stride(&self) -> usize {
        (1.0 / (JUDGED_RATE * self.body.frame_time)).round().max(1.0) as usize
    }

    /// The state of a rollout that keeps one pose from this second on.
    fn still_state(&self, request: &RolloutRequest, positions: &[f32], from: f64) -> Ending {
        let frame_time = self.body.frame_time;
        let width = 3 * self.body.mapping.skeleton().figure().len();
        let first = (from / frame_time).round() as usize;
        let stretch = &positions[first * width..];
        let steps = stretch.iter().zip(&stretch[width..]);
        let squares: f64 = steps.clone().map(|(a, b)| f64::from((b - a) * (b - a))).sum();
        if (3.0 * squares / steps.len() as f64).sqrt() / frame_time >= TRAVELS {
            return Ending::KeepsOnePose;
        }
        // The rest of a sequence is not that of other start latents.
        let sequence = self.body.sequences.get(request.sequence).filter(|_| request.start.is_none());
        let recorded = sequence.and_then(|info| info.rests_from);
        // The rollout may start at a later frame of the recording.
        let start = request.frame as f64 * frame_time;
        if recorded.is_some_and(|rest| start + from >= rest - EARLY) {
            Ending::RestsAsRecorded
        } else {
            Ending::StandsStill
        }
    }

    /// The poses of the body in columns [frames x D], or those of one part while the others keep their mean
    /// pose; `None` if the numbers are too large.
    fn poses(&self, y: &DMatrix<f64>, part: Option<usize>) -> Option<Poses> {
        let mut y = y.clone();
        let own = part.map(|part| self.body.layout.columns(part));
        for (column, mean) in self.body.column_means.iter().enumerate() {
            if column < TRAVEL_COLUMNS {
                y.column_mut(column).fill(0.0);
            } else if own.is_some_and(|own| !own.contains(&column)) {
                y.column_mut(column).fill(*mean);
            }
        }
        let figure = self.body.mapping.skeleton().figure();
        let joints = part.map(|part| &self.body.layout.parts()[part].joints);
        let is_own = |&node: &usize| joints.is_none_or(|joints| joints.contains(&figure[node].joint));
        let nodes: Vec<usize> = (0..figure.len()).filter(is_own).collect();
        Some(Poses::new(&self.body.positions(&y).ok()?, 3 * figure.len(), &nodes))
    }

    /// The frames of the clips as the pose maps make them [frames x D], and which of them begin a sequence.
    /// Files of earlier versions have only the first latents of each sequence. For them, the inducing points
    /// of the pose maps, which training spreads over the clips, stand for the frames, and no sequence begins.
    fn clip_columns(&self) -> (DMatrix<f64>, Vec<usize>) {
        let (maps, starts) = (&self.model.parts, &self.model.starts);
        let least = maps.iter().map(|map| map.r().nrows()).min().unwrap_or(0);
        let (mut begins, mut frames) = (Vec::new(), 0);
        let is_kept = |start: &Vec<DMatrix<f64>>| start.iter().any(|x| x.nrows() > self.model.order);
        if starts.iter().any(is_kept) {
            for start in starts {
                begins.push(frames);
                frames += start.first().map_or(0, DMatrix::nrows);
            }
        }
        let mut latents = Vec::new();
        for (part, map) in maps.iter().enumerate() {
            latents.push(if begins.is_empty() {
                map.r().rows(0, least).into_owned()
            } else {
                stacked(starts.iter().map(|start| &start[part]))
            });
        }
        (self.body.columns(&self.model.observations(&latents)), begins)
    }
}

#[cfg(test)]
pub(super) mod tests;
