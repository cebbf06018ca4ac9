//! Rollouts without an end: a few frames at a time, while couplings change and parts are pushed.

use crate::models::fitted::coupled::Coupled;
use crate::models::rollout::latent_dynamics::LatentDynamics;
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::rollout::movers::{Moved, Mover};
use crate::models::rollout::reach::Reach;
use crate::models::rollout::request::{Push, Rollout, RolloutError};
use crate::models::variational::{Cycle, CyclePlace, Familiarity};
use crate::motion::pose::{RootStart, RootTrack};
use nalgebra::{DMatrix, Matrix3, Vector3};

/// Step of the finite differences of a joint's place with respect to the latents.
const DIFFERENCE: f64 = 1e-4;
/// Regularisation of a pull, in metres squared: a joint that moves less than its root for a latent step of 1
/// is hardly pushed.
const STIFFNESS: f64 = 1e-4;
/// Turns of a drive at a time, forward or back.
const MOST_TURNS: f64 = 10.0;

/// A rollout without an end.
#[derive(Clone, Debug)]
pub struct LiveRollout {
    paths: LatentPaths,
    track: RootTrack,
    /// The track before the newest frame; `None` where this frame cannot be taken back.
    before: Option<RootTrack>,
    cycle: Option<Cycle>,
    /// The parts that the model does not move; each part once.
    moved: Vec<Moved>,
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
    /// The frame of the recording that moves each part [frames x M], frame by frame.
    pub recorded: Vec<Option<usize>>,
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
        Ok(Self { paths, track, before: None, cycle: model.model.cycle(sequence)?, moved: Vec::new() })
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
        let mut recorded = Vec::with_capacity(frames * self.paths.latent().len());
        for k in 0..frames {
            dynamics.extend(&mut self.paths, before + k + 1);
            for moved in &mut self.moved {
                moved.set_newest(&mut self.paths, model, self.cycle.as_ref(), frames - k);
            }
            recorded.extend((0..self.paths.latent().len()).map(|part| self.recorded_frame(part)));
        }
        let latents = self.paths.matrices(before..before + frames);
        let y = model.body.columns(&model.model.observations(&latents));
        let mapping = &model.body.mapping;
        let (earlier, newest) = (y.rows(0, frames - 1).into_owned(), y.rows(frames - 1, 1).into_owned());
        let mut positions = mapping.continue_positions(&earlier, &mut self.track)?;
        self.before = Some(self.track.clone());
        positions.extend(mapping.continue_positions(&newest, &mut self.track)?);
        let parts = 0..latents.len();
        let places =
            (before + 1..=before + frames).flat_map(|end| parts.clone().map(move |part| (end, part)));
        let place = |(end, part)| self.cycle.as_ref()?.place(part, self.paths.history_until(part, end));
        let places = places.filter_map(place).collect();
        Ok(LiveFrames { latents, positions, places, recorded })
    }

    /// Takes the newest frame back, so that the next frame replaces it. Changes stay: the turns of a wheel in that
    /// frame count for the next one. Returns whether there was such a frame: only one frame can be taken back.
    pub fn take_back(&mut self) -> bool {
        let Some(before) = self.before.take() else { return false };
        self.track = before;
        self.paths.drop_newest();
        self.moved.iter_mut().for_each(Moved::take_back);
        true
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
        self.check_part(part)?;
        let held = self.moved.iter_mut().find(|moved| moved.part == part);
        if let Some(Mover::Wheel { ahead, .. }) = held.map(|moved| &mut moved.by) {
            *ahead += turns;
            return Ok(());
        }
        let moved = Moved::by_wheel(part, &self.paths, cycle, turns);
        self.replace(moved);
        Ok(())
    }

    /// Lets a recording move a part: the part has the `latents` of the recording [frames x Q_i], again and
    /// again, until it is released. The recording begins, and begins again, in its first half, where it is most
    /// like the last frames of the part.
    ///
    /// # Errors
    ///
    /// When there is no such part, or the latents do not fit it, are not finite or have fewer than 2 p frames.
    pub fn record(&mut self, part: usize, latents: DMatrix<f64>) -> Result<(), RolloutError> {
        self.check_part(part)?;
        let (least, columns) = (2 * self.paths.order(), self.paths.latent()[part]);
        let found = match latents.iter().find(|x| !x.is_finite()) {
            Some(number) => number.to_string(),
            None if latents.nrows() >= least && latents.ncols() == columns => {
                self.replace(Moved::by_recording(part, &self.paths, latents));
                return Ok(());
            }
            None => format!("{} x {}", latents.nrows(), latents.ncols()),
        };
        Err(RolloutError::Recording { part, least, columns, found })
    }

    /// Lets the part of a node of the figure, counted as in its positions, follow a `place` until it is released:
    /// the node comes as near to it as poses like those of the training allow. The place is relative to the
    /// figure's root, in metres for a body 1.7 m tall, y up, in the directions of the positions. It turns with
    /// the figure.
    ///
    /// # Errors
    ///
    /// When there is no such node, the place is not finite, or a covariance cannot be factorised.
    pub fn reach(&mut self, model: Coupled, node: usize, place: [f64; 3]) -> Result<(), RolloutError> {
        if let Some(&found) = place.iter().find(|x| !x.is_finite()) {
            return Err(RolloutError::Place { found });
        }
        let part = part_of(model, node)?;
        let place = self.track.relative_to_heading(&place.into());
        let held = self.moved.iter_mut().find(|moved| moved.part == part);
        if let Some(Mover::Hand(reach)) = held.map(|moved| &mut moved.by) {
            (reach.node, reach.place) = (node, place);
            return Ok(());
        }
        let familiarity = Familiarity::new(&model.model.parts[part], model.model.jitter)?;
        self.replace(Moved::by_hand(part, Reach::new(node, place, familiarity)));
        Ok(())
    }

    /// Lets a part go: the model moves it from where it is.
    pub fn release(&mut self, part: usize) {
        self.moved.retain(|moved| moved.part != part);
    }

    fn replace(&mut self, moved: Moved) {
        self.release(moved.part);
        self.moved.push(moved);
    }

    fn check_part(&self, part: usize) -> Result<(), RolloutError> {
        let count = self.paths.latent().len();
        if part < count { Ok(()) } else { Err(RolloutError::Part { count, found: part }) }
    }

    /// The frame of the recording that moves a part in the newest frame.
    fn recorded_frame(&self, part: usize) -> Option<usize> {
        match self.moved.iter().find(|moved| moved.part == part)?.by {
            Mover::Recording { frame, .. } => Some(frame),
            Mover::Wheel { .. } | Mover::Hand(_) => None,
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
        let part = part_of(model, node)?;
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

/// The part of a node of the figure.
fn part_of(model: Coupled, node: usize) -> Result<usize, RolloutError> {
    let figure = model.body.mapping.skeleton().figure();
    let found = figure
        .get(node)
        .and_then(|node| model.body.layout.parts().iter().position(|part| part.joints.contains(&node.joint)));
    found.ok_or(RolloutError::Node { count: figure.len(), found: node })
}
