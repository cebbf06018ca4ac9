//! Motions without an end: a few frames at a time, which can be taken back, while couplings, tempos and
//! primitives change, and parts are pushed or moved by a hand or a recording.

use crate::models::kinds::coupled::Coupled;
use crate::models::kinds::model::Model;
use crate::models::kinds::movers::{Moved, Mover};
use crate::models::kinds::reach::Reach;
use crate::models::rollout::couplings::Reading;
use crate::models::rollout::latent_dynamics::LatentDynamics;
use crate::models::rollout::latent_paths::LatentPaths;
use crate::models::rollout::request::{Push, Rollout, RolloutError, TEMPOS};
use crate::models::variational::{Cycle, CyclePlace, Familiarity};
use crate::motion::pose::{RootStart, RootTrack};
use nalgebra::{DMatrix, Matrix3, Vector3};
use std::sync::Arc;

/// Step of the finite differences of a joint's place with respect to the latents.
const DIFFERENCE: f64 = 1e-4;
/// Regularisation of a pull, in metres squared: a joint that moves less than its root for a latent step of 1
/// is hardly pushed.
const STIFFNESS: f64 = 1e-4;
/// Turns of a drive at a time, forward or back.
const MOST_TURNS: f64 = 10.0;
/// The most frames that can be taken back: more than a page prepares in advance.
pub const REWINDS: usize = 64;

/// A motion without an end, of a model or of a combination of primitives.
#[derive(Clone, Debug)]
pub struct Endless {
    now: State,
    /// The state before the newest frames, then the state after each of them, the newest last.
    states: Vec<State>,
}

/// The state from which the motion continues.
#[derive(Clone, Debug)]
struct State {
    course: Arc<Course>,
    paths: LatentPaths,
    track: RootTrack,
    /// The parts that the model does not move; each part once.
    moved: Vec<Moved>,
}

/// What moves the parts, until couplings or primitives change.
#[derive(Clone, Debug)]
struct Course {
    model: Arc<Model>,
    /// The primitive of each part, for a combination of primitives.
    uses: Vec<usize>,
    alpha: DMatrix<f64>,
    reading: Reading,
    /// (source, target).
    cuts: Vec<(usize, usize)>,
    dynamics: Arc<LatentDynamics>,
    cycle: Option<Arc<Cycle>>,
}

/// The next frames of a motion without an end.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct EndlessFrames {
    /// The latent path of each part [frames x Q_i].
    pub latents: Vec<DMatrix<f64>>,
    /// World positions of the figure's nodes [frames x nodes x 3], y up, in metres for a body 1.7 m tall.
    pub positions: Vec<f32>,
    /// The place of each part on the learned cycle [frames x M], frame by frame; empty when the learned
    /// rollout does not repeat itself.
    pub places: Vec<CyclePlace>,
    /// All columns, means included [frames x D].
    pub y: DMatrix<f64>,
    /// The frame of the recording that moves each part [frames x M], frame by frame.
    pub recorded: Vec<Option<usize>>,
}

fn coupled(model: &Model) -> Result<Coupled<'_>, RolloutError> {
    model.coupled().ok_or(RolloutError::Kind { found: model.kind().id() })
}

impl State {
    /// One frame more; `frames` frames are left for the turns of a wheel, this one included.
    fn step(&mut self, model: Coupled, frames: usize) {
        self.paths.forget();
        let frames_before = self.paths.frames();
        self.course.dynamics.extend(&mut self.paths, frames_before + 1);
        for moved in &mut self.moved {
            moved.set_newest(&mut self.paths, model, self.course.cycle.as_deref(), frames);
        }
    }

    /// The columns [1 x D] of the newest frame. The root travels at the tempo of its part, or as fast as a wheel turns
    /// it: with the legs it stands still, and goes back with them.
    fn columns(&self, model: Coupled) -> DMatrix<f64> {
        let last = self.paths.frames();
        let newest = self.paths.matrices(last - 1..last);
        let mut y = model.body.columns(&model.model.observations(&newest));
        let has_root = |part: usize| model.body.layout.columns(part).contains(&0);
        let by_wheel = |moved: &Moved| match moved.by {
            Mover::Wheel { step, .. } if has_root(moved.part) => Some(step),
            _ => None,
        };
        let speed = match (&self.course.cycle, self.moved.iter().find_map(by_wheel)) {
            (Some(cycle), Some(step)) => step * cycle.period() as f64,
            _ => (0..newest.len()).find(|part| has_root(*part)).map_or(1.0, |part| self.paths.tempo(part)),
        };
        model.body.scale_rates(&mut y, speed);
        y
    }

    /// The frame of the recording that moves a part in the newest frame.
    fn recorded_frame(&self, part: usize) -> Option<usize> {
        match self.moved.iter().find(|moved| moved.part == part)?.by {
            Mover::Recording { frame, .. } => Some(frame),
            Mover::Wheel { .. } | Mover::Hand(_) => None,
        }
    }
}

impl Endless {
    /// Continues a rollout of the model after `frame`, counted from 0, or after its first p frames, under its
    /// learned couplings. The learned cycle is that of the training sequence `sequence`.
    ///
    /// # Errors
    ///
    /// When the model has no couplings, the rollout is of another model, or has no such frame.
    pub fn after(
        model: Arc<Model>,
        rollout: &Rollout,
        frame: usize,
        sequence: usize,
    ) -> Result<Self, RolloutError> {
        let order = coupled(&model)?.model.order;
        let newest = frame.max(order - 1);
        if newest >= rollout.y.nrows() {
            return Err(RolloutError::Frames { most: rollout.y.nrows(), found: newest + 1 });
        }
        let history = |x: &DMatrix<f64>| x.rows(newest + 1 - order, order).into_owned();
        let start: Vec<_> = rollout.latents.iter().map(history).collect();
        let mapping = &model.body.mapping;
        let mut track = mapping.track(&RootStart::default());
        mapping.continue_positions(&rollout.y.rows(0, newest + 1).into_owned(), &mut track)?;
        let cycle = coupled(&model)?.model.cycle(sequence)?;
        Self::begin(model, &[], &start, track, cycle)
    }

    /// Begins at the origin, after the p latents `start` [p x Q_i] of each part, with a combination of the
    /// primitives `uses`.
    pub(crate) fn of_primitives(
        model: Arc<Model>,
        uses: &[usize],
        start: &[DMatrix<f64>],
    ) -> Result<Self, RolloutError> {
        let track = model.body.mapping.track(&RootStart::default());
        let cycle = coupled(&model)?.model.cycle(0).unwrap_or_default();
        Self::begin(model, uses, start, track, cycle)
    }

    fn begin(
        model: Arc<Model>,
        uses: &[usize],
        start: &[DMatrix<f64>],
        track: RootTrack,
        cycle: Option<Cycle>,
    ) -> Result<Self, RolloutError> {
        let fitted = coupled(&model)?.model;
        let (alpha, reading) = (fitted.alpha.clone(), Reading::AsLearned);
        let paths = LatentPaths::new(start, fitted.order, &fitted.latent_dimensions())?;
        let dynamics = Arc::new(fitted.dynamics(&alpha, reading)?);
        let (uses, cuts, cycle) = (uses.to_vec(), Vec::new(), cycle.map(Arc::new));
        let course = Arc::new(Course { model, uses, alpha, reading, cuts, dynamics, cycle });
        let now = State { course, paths, track, moved: Vec::new() };
        Ok(Self { states: vec![now.clone()], now })
    }

    /// The next `frames` frames.
    ///
    /// # Errors
    ///
    /// When the number of frames is 0 or too large, or the poses are no longer finite; the motion then stays as
    /// it is.
    pub fn advance(&mut self, frames: usize) -> Result<EndlessFrames, RolloutError> {
        let owner = Arc::clone(&self.now.course.model);
        let model = coupled(&owner)?;
        model.check_frames(frames)?;
        let zeros = |q: usize| DMatrix::zeros(frames, q);
        let mut latents: Vec<_> = model.model.latent_dimensions().into_iter().map(zeros).collect();
        let (mut positions, mut places, mut recorded) = (Vec::new(), Vec::new(), Vec::new());
        let mut y = DMatrix::zeros(frames, model.body.column_means.len());
        let (mut next, mut states) = (self.now.clone(), Vec::new());
        for t in 0..frames {
            next.step(model, frames - t);
            for (part, path) in latents.iter_mut().enumerate() {
                path.row_mut(t).iter_mut().zip(next.paths.newest(part)).for_each(|(to, x)| *to = *x);
                if let Some(cycle) = &next.course.cycle {
                    places.extend(cycle.place(part, &next.paths.history(part)));
                }
                recorded.push(next.recorded_frame(part));
            }
            let columns = next.columns(model);
            y.row_mut(t).copy_from(&columns.row(0));
            positions.extend(model.body.mapping.continue_positions(&columns, &mut next.track)?);
            if states.len() > REWINDS {
                states.remove(0);
            }
            states.push(next.clone());
        }
        self.now = next;
        self.states.append(&mut states);
        self.states.drain(..self.states.len().saturating_sub(REWINDS + 1));
        Ok(EndlessFrames { latents, positions, places, y, recorded })
    }

    /// Takes the last `frames` frames back. Changes since then are undone too; 0 frames undo the changes since
    /// the newest frame.
    ///
    /// # Errors
    ///
    /// When that many frames are not stored any more.
    pub fn rewind(&mut self, frames: usize) -> Result<(), RolloutError> {
        let highest = self.states.len().saturating_sub(1) as f64;
        if frames as f64 > highest {
            let (what, found) = ("frames to take back", frames as f64);
            return Err(RolloutError::Range { what, lowest: 0.0, highest, found });
        }
        self.states.truncate(self.states.len() - frames);
        if let Some(state) = self.states.last() {
            self.now = state.clone();
        }
        Ok(())
    }

    /// The current couplings [M x M], row the source.
    pub fn alpha(&self) -> &DMatrix<f64> {
        &self.now.course.alpha
    }

    /// Latent dimensions Q of each part `[M]`.
    pub fn latent_dimensions(&self) -> &[usize] {
        self.now.paths.latent()
    }

    /// The current primitive of each part, for a combination of primitives.
    pub fn uses(&self) -> &[usize] {
        &self.now.course.uses
    }

    /// Sets the couplings [M x M], row the source, from the next frame on, and whether the experts are inferred
    /// again under them.
    ///
    /// # Errors
    ///
    /// When they do not fit the parts; nothing changes then.
    pub fn set_couplings(&mut self, alpha: DMatrix<f64>, reading: Reading) -> Result<(), RolloutError> {
        let cuts = self.now.course.cuts.clone();
        self.set_dynamics(alpha, reading, cuts)
    }

    /// Cuts a coupling from the next frame on, or restores it.
    ///
    /// # Errors
    ///
    /// When there is no such part, or no coupling into the target would be left.
    pub fn cut(&mut self, source: usize, target: usize, is_cut: bool) -> Result<(), RolloutError> {
        let mut cuts = self.now.course.cuts.clone();
        cuts.retain(|other| *other != (source, target));
        if is_cut {
            cuts.push((source, target));
        }
        let course = Arc::clone(&self.now.course);
        self.set_dynamics(course.alpha.clone(), course.reading, cuts)
    }

    fn set_dynamics(
        &mut self,
        alpha: DMatrix<f64>,
        reading: Reading,
        cuts: Vec<(usize, usize)>,
    ) -> Result<(), RolloutError> {
        let course = &mut self.now.course;
        let dynamics = coupled(&course.model)?.model.dynamics_without(&cuts, &alpha, reading)?;
        let (dynamics, cycle) = (Arc::new(dynamics), course.cycle.clone());
        let (model, uses) = (Arc::clone(&course.model), course.uses.clone());
        *course = Arc::new(Course { model, uses, alpha, reading, cuts, dynamics, cycle });
        Ok(())
    }

    /// Sets the tempo of a part; 1 is as learned.
    ///
    /// # Errors
    ///
    /// When there is no such part, or the tempo is not from a quarter to 2.
    pub fn set_tempo(&mut self, part: usize, tempo: f64) -> Result<(), RolloutError> {
        self.check_part(part)?;
        if !TEMPOS.contains(&tempo) {
            let (lowest, highest) = (*TEMPOS.start(), *TEMPOS.end());
            return Err(RolloutError::Range { what: "a tempo", lowest, highest, found: tempo });
        }
        self.now.paths.set_tempo(part, tempo);
        Ok(())
    }

    /// Continues with the combination `uses`; `part` continues from a state [p x Q] of its own. The couplings
    /// stay.
    pub(crate) fn use_primitives(
        &mut self,
        model: Arc<Model>,
        uses: Vec<usize>,
        part: usize,
        state: Option<&DMatrix<f64>>,
    ) -> Result<(), RolloutError> {
        let (now, fitted) = (&mut self.now, coupled(&model)?.model);
        let mut course = Course::clone(&now.course);
        course.dynamics = Arc::new(fitted.dynamics_without(&course.cuts, &course.alpha, course.reading)?);
        course.cycle = fitted.cycle(0).unwrap_or_default().map(Arc::new);
        (course.model, course.uses) = (model, uses);
        if let Some(state) = state {
            now.paths.set_history(part, state);
        }
        // A wheel turns a part round the cycle of these primitives; without one it lets the part go.
        let (wheels, others): (Vec<Moved>, _) =
            now.moved.drain(..).partition(|moved| matches!(moved.by, Mover::Wheel { .. }));
        now.moved = others;
        if let Some(cycle) = &course.cycle {
            now.moved.extend(wheels.iter().map(|wheel| Moved::by_wheel(wheel.part, &now.paths, cycle, 0.0)));
        }
        now.course = Arc::new(course);
        Ok(())
    }

    /// The last p states of each part in its own time, oldest first [p x Q_i].
    pub(crate) fn histories(&self) -> Vec<DMatrix<f64>> {
        let paths = &self.now.paths;
        let history =
            |(part, q): (usize, &usize)| DMatrix::from_row_slice(paths.order(), *q, &paths.history(part));
        paths.latent().iter().enumerate().map(history).collect()
    }

    /// Pushes a part before the next frame, whatever the `frame` of the push.
    ///
    /// # Errors
    ///
    /// When the push does not fit the part.
    pub fn push(&mut self, push: &Push) -> Result<(), RolloutError> {
        push.check(self.now.paths.latent())?;
        self.now.paths.push(push);
        Ok(())
    }

    /// Drives a part round its learned cycle, by `turns` within the next frames that are asked for; with 0 it
    /// stands still. The other parts see it and go on by themselves. The body travels as fast as its legs turn. The
    /// part is driven until it is released.
    ///
    /// # Errors
    ///
    /// When there is no such part, the learned rollout does not repeat itself, or there are more than 10 turns.
    pub fn drive(&mut self, part: usize, turns: f64) -> Result<(), RolloutError> {
        if turns.is_nan() || turns.abs() > MOST_TURNS {
            return Err(RolloutError::Turns { most: MOST_TURNS, found: turns });
        }
        let cycle = self.now.course.cycle.as_ref().ok_or(RolloutError::NoCycle)?;
        self.check_part(part)?;
        let held = self.now.moved.iter_mut().find(|moved| moved.part == part);
        if let Some(Mover::Wheel { ahead, .. }) = held.map(|moved| &mut moved.by) {
            *ahead += turns;
            return Ok(());
        }
        let moved = Moved::by_wheel(part, &self.now.paths, cycle, turns);
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
        let (least, columns) = (2 * self.now.paths.order(), self.now.paths.latent()[part]);
        let found = match latents.iter().find(|x| !x.is_finite()) {
            Some(number) => number.to_string(),
            None if latents.nrows() >= least && latents.ncols() == columns => {
                self.replace(Moved::by_recording(part, &self.now.paths, latents));
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
    pub fn reach(&mut self, node: usize, place: [f64; 3]) -> Result<(), RolloutError> {
        if let Some(&found) = place.iter().find(|x| !x.is_finite()) {
            return Err(RolloutError::Place { found });
        }
        let model = coupled(&self.now.course.model)?;
        let part = part_of(model, node)?;
        let place = self.now.track.relative_to_heading(&place.into());
        let held = self.now.moved.iter_mut().find(|moved| moved.part == part);
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
        self.now.moved.retain(|moved| moved.part != part);
    }

    fn replace(&mut self, moved: Moved) {
        self.release(moved.part);
        self.now.moved.push(moved);
    }

    fn check_part(&self, part: usize) -> Result<(), RolloutError> {
        let count = self.now.paths.latent().len();
        if part < count { Ok(()) } else { Err(RolloutError::Part { count, found: part }) }
    }

    /// The push that moves a node of the figure, counted as in its positions, by about `by` metres: the
    /// smallest latent displacement d of the node's part with J d = `by`, where J is the derivative of the
    /// node's place with respect to the part's latents. The place and the heading of the figure stay as they
    /// are.
    ///
    /// # Errors
    ///
    /// When there is no such node, or the poses are no longer finite.
    pub fn pull(&self, node: usize, by: [f64; 3]) -> Result<Push, RolloutError> {
        let model = coupled(&self.now.course.model)?;
        let part = part_of(model, node)?;
        let last = self.now.paths.frames();
        let newest = self.now.paths.matrices(last - 1..last);
        let q = newest[part].ncols();
        let place = |latents: &[DMatrix<f64>]| -> Result<Vector3<f64>, RolloutError> {
            let y = model.body.columns(&model.model.observations(latents));
            let positions = model.body.mapping.continue_positions(&y, &mut self.now.track.clone())?;
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

#[cfg(test)]
mod tests;
