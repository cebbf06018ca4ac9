//! Rollouts without an end: a few frames at a time, while couplings change and parts are pushed.

use crate::models::fitted::coupled::Coupled;
use crate::models::rollout::latent_dynamics::LatentDynamics;
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::rollout::request::{Push, Rollout, RolloutError};
use crate::models::variational::{Cycle, CyclePlace};
use crate::motion::pose::{RootStart, RootTrack};
use nalgebra::{DMatrix, Matrix3, Vector3};

/// Step of the finite differences of a joint's place with respect to the latents.
const DIFFERENCE: f64 = 1e-4;
/// Regularisation of a pull, in metres squared: a joint that moves less than its root for a latent step of 1
/// is hardly pushed.
const STIFFNESS: f64 = 1e-4;
/// A driven part that was beside its cycle keeps this share of the distance from one frame to the next.
const APPROACH: f64 = 0.8;
/// Turns of a drive at a time, forward or back.
const MOST_TURNS: f64 = 10.0;

/// A part that somebody drives round its learned cycle.
#[derive(Clone, Debug)]
struct Drive {
    part: usize,
    /// In turns.
    phase: f64,
    /// Turns that are left for the next frames.
    ahead: f64,
    /// The rest of the distance from the cycle at the beginning `[Q_i]`.
    beside: Vec<f64>,
}

/// A rollout without an end.
#[derive(Clone, Debug)]
pub struct LiveRollout {
    paths: LatentPaths,
    track: RootTrack,
    cycle: Option<Cycle>,
    drives: Vec<Drive>,
}

/// The next frames of a live rollout.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct LiveFrames {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub positions: Vec<f32>,
    /// The place of each part on the learned cycle [frames x M], frame by frame; empty when the learned
    /// rollout does not repeat itself.
    pub places: Vec<CyclePlace>,
}

impl LiveRollout {
    /// Continues a rollout of the model after `frame`, counted from 0, or after its first p frames. The
    /// learned cycle is that of the training sequence `sequence`.
    ///
    /// # Errors
    ///
    /// When the rollout is of another model, or has no such frame.
    pub fn after(
        model: Coupled,
        rollout: &Rollout,
        frame: usize,
        sequence: usize,
    ) -> Result<Self, RolloutError> {
        let order = model.model.order;
        let newest = frame.max(order - 1);
        if newest >= rollout.y.nrows() {
            return Err(RolloutError::Frames { most: rollout.y.nrows(), found: newest + 1 });
        }
        let history = |x: &DMatrix<f64>| x.rows(newest + 1 - order, order).into_owned();
        let start: Vec<_> = rollout.latents.iter().map(history).collect();
        let mut track = model.body.mapping.track(&RootStart::default());
        model.body.mapping.continue_positions(&rollout.y.rows(0, newest + 1).into_owned(), &mut track)?;
        let paths = LatentPaths::new(&start, order, &model.model.latent_dimensions())?;
        Ok(Self { paths, track, cycle: model.model.cycle(sequence)?, drives: Vec::new() })
    }

    /// The next `frames` frames under these dynamics of the model.
    ///
    /// # Errors
    ///
    /// When the number of frames is 0 or too large, or the poses are no longer finite.
    pub fn advance(
        &mut self,
        model: Coupled,
        dynamics: &LatentDynamics,
        frames: usize,
    ) -> Result<LiveFrames, RolloutError> {
        model.check_frames(frames)?;
        self.paths.forget();
        let before = self.paths.frames();
        for k in 0..frames {
            dynamics.extend(&mut self.paths, before + k + 1);
            self.drive_newest(frames - k);
        }
        let latents = self.paths.matrices(before..before + frames);
        let y = model.body.columns(&model.model.observations(&latents));
        let positions = model.body.mapping.continue_positions(&y, &mut self.track)?;
        let parts = 0..latents.len();
        let places =
            (before + 1..=before + frames).flat_map(|end| parts.clone().map(move |part| (end, part)));
        let place = |(end, part)| self.cycle.as_ref()?.place(part, self.paths.history_until(part, end));
        let places = places.filter_map(place).collect();
        Ok(LiveFrames { latents, positions, places })
    }

    /// Pushes a part before the next frame, whatever the `frame` of the push.
    ///
    /// # Errors
    ///
    /// When the push does not fit the part.
    pub fn push(&mut self, push: &Push) -> Result<(), RolloutError> {
        push.check(self.paths.latent())?;
        self.paths.push(push);
        Ok(())
    }

    /// Drives a part round its learned cycle, by `turns` within the next frames that are asked for; with 0 it
    /// stands still. The other parts see it and go on by themselves. It is driven until it is released.
    ///
    /// # Errors
    ///
    /// When there is no such part, the learned rollout does not repeat itself, or there are more than 10 turns.
    pub fn drive(&mut self, part: usize, turns: f64) -> Result<(), RolloutError> {
        if turns.is_nan() || turns.abs() > MOST_TURNS {
            return Err(RolloutError::Turns { most: MOST_TURNS, found: turns });
        }
        let cycle = self.cycle.as_ref().ok_or(RolloutError::NoCycle)?;
        if let Some(drive) = self.drives.iter_mut().find(|drive| drive.part == part) {
            drive.ahead += turns;
            return Ok(());
        }
        let count = self.paths.latent().len();
        if part >= count {
            return Err(RolloutError::Part { count, found: part });
        }
        let phase = cycle.place(part, self.paths.history(part)).map_or(0.0, |place| place.phase);
        let on_cycle = cycle.latents(part, phase).unwrap_or_default();
        let beside = self.paths.newest(part).iter().zip(on_cycle).map(|(x, on)| x - on).collect();
        self.drives.push(Drive { part, phase, ahead: turns, beside });
        Ok(())
    }

    /// Lets a driven part go: it goes on by itself from where it is.
    pub fn release(&mut self, part: usize) {
        self.drives.retain(|drive| drive.part != part);
    }

    /// Puts driven parts where they have to be in the newest frame; `frames` frames are left for its turns, this one included.
    fn drive_newest(&mut self, frames: usize) {
        for drive in &mut self.drives {
            let step = drive.ahead / frames as f64;
            drive.ahead -= step;
            drive.phase += step;
            drive.beside.iter_mut().for_each(|x| *x *= APPROACH);
            let on_cycle = self.cycle.as_ref().and_then(|cycle| cycle.latents(drive.part, drive.phase));
            let latents = on_cycle.into_iter().flatten().zip(&drive.beside).map(|(on, beside)| on + beside);
            self.paths.set_newest(drive.part, &latents.collect::<Vec<_>>());
        }
    }

    /// The push that moves a node of the figure, counted as in its positions, by about `by` metres: the
    /// smallest latent displacement d of the node's part with J d = `by`, where J is the derivative of the
    /// node's place with respect to the part's latents. The place and the heading of the figure stay as they
    /// are.
    ///
    /// # Errors
    ///
    /// When there is no such node, or the poses are no longer finite.
    pub fn pull(&self, model: Coupled, node: usize, by: [f64; 3]) -> Result<Push, RolloutError> {
        let figure = model.body.mapping.skeleton().figure();
        let found = figure.get(node).and_then(|node| {
            model.body.layout.parts().iter().position(|part| part.joints.contains(&node.joint))
        });
        let part = found.ok_or(RolloutError::Node { count: figure.len(), found: node })?;
        let last = self.paths.frames();
        let newest = self.paths.matrices(last - 1..last);
        let q = newest[part].ncols();
        let place = |latents: &[DMatrix<f64>]| -> Result<Vector3<f64>, RolloutError> {
            let y = model.body.columns(&model.model.observations(latents));
            let positions = model.body.mapping.continue_positions(&y, &mut self.track.clone())?;
            Ok(Vector3::from_fn(|axis, _| f64::from(positions[3 * node + axis])))
        };
        let mut slopes: Vec<Vector3<f64>> = Vec::with_capacity(q);
        for k in 0..q {
            let (mut up, mut down) = (newest.clone(), newest.clone());
            up[part][(0, k)] += DIFFERENCE;
            down[part][(0, k)] -= DIFFERENCE;
            slopes.push((place(&up)? - place(&down)?) / (2.0 * DIFFERENCE));
        }
        // d = J^T (J J^T + s I)^-1 by.
        let mut squares = Matrix3::identity() * STIFFNESS;
        for slope in &slopes {
            squares += slope * slope.transpose();
        }
        let solved = squares.try_inverse().unwrap_or_else(Matrix3::zeros) * Vector3::from(by);
        let by = slopes.iter().map(|slope| slope.dot(&solved)).collect();
        Ok(Push { part, by, ..Push::default() })
    }
}
