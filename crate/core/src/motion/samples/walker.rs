//! Applies the gait curves to the body frame by frame. The root moves so that the standing foot stays in
//! place.

use crate::elementary::Elementary;
use crate::motion::samples::body::joint;
use crate::motion::samples::body::{Frames, RATE};
use crate::motion::samples::turns::{half, x, y, z};
use crate::motion::samples::variation::{Drift, between};
use crate::motion::samples::{body, gait};
use crate::motion::skeleton::Skeleton;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Steps of the integration in a frame.
const SUBSTEPS: usize = 4;
/// Scale of the soft minimum over the heights of the soles, centimetres.
const SOFTNESS: f64 = 0.7;

/// The movement of the arms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Arms {
    /// Swing against the legs.
    Swing,
    /// Are raised sideways and wave at a rate of their own.
    Wave,
}

/// The parameters of one trial, in which the legs stand still or walk. `STANDS` is a constant, so that a program
/// in which nobody stands has no code for it: the page's first visit.
struct Style<const STANDS: bool> {
    arms: Arms,
    period: f64,
    start: f64,
    stride: f64,
    swing: f64,
    /// Left minus right, as a fraction of the stride's size; and the delay of the right leg, in cycles.
    uneven: f64,
    late: f64,
    lean: f64,
    /// The phase of the waving at the start, in cycles; its cycles a second.
    wave_start: f64,
    wave_rate: f64,
    wave_size: f64,
    phase: Drift,
    size: Drift,
    knees: Drift,
    arm: [Drift; 2],
    elbow: [Drift; 2],
    trunk: Drift,
    head: Drift,
    heading: Drift,
    wave: Drift,
}

impl<const STANDS: bool> Style<STANDS> {
    fn new(arms: Arms, seed: u64) -> Self {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let waving = arms == Arms::Wave;
        Self {
            arms,
            period: between(random, 0.95, 1.15),
            start: between(random, 0.0, 1.0),
            stride: between(random, 0.94, 1.05),
            swing: between(random, 0.85, 1.15),
            uneven: between(random, -0.02, 0.02),
            late: between(random, -0.006, 0.006),
            lean: between(random, -1.0, 1.0),
            wave_start: between(random, 0.0, 1.0),
            wave_size: if waving { between(random, 0.9, 1.1) } else { 0.0 },
            phase: Drift::new(random),
            size: Drift::new(random),
            knees: Drift::new(random),
            arm: [Drift::new(random), Drift::new(random)],
            elbow: [Drift::new(random), Drift::new(random)],
            trunk: Drift::new(random),
            head: Drift::new(random),
            heading: Drift::new(random),
            wave: Drift::new(random),
            wave_rate: if waving { between(random, 1.1, 2.1) } else { 0.0 },
        }
    }

    /// The left leg's phase, in cycles: the clock of the whole body.
    fn clock(&self, seconds: f64) -> f64 {
        self.start + seconds / self.period + 0.012 * self.phase.at(seconds)
    }

    /// Local rotations of all joints at a time.
    fn pose(&self, seconds: f64) -> [UnitQuaternion<f64>; joint::COUNT] {
        let mut q = [UnitQuaternion::identity(); joint::COUNT];
        let clock = self.clock(seconds);
        // The feet of a standing body do not turn.
        let heading = y(if STANDS { 0.0 } else { 2.5 * self.heading.at(seconds) });

        let pelvis = if STANDS { gait::standing() } else { gait::pelvis(clock) };
        let pelvis_q = y(pelvis.yaw) * z(pelvis.obliquity) * x(pelvis.tilt);
        q[joint::HIPS] = heading * pelvis_q;

        let sway = if STANDS { 0.6 * self.phase.at(seconds) } else { gait::sway(clock) };
        for (side, first) in [(1.0, joint::LEFT_UP_LEG), (-1.0, joint::RIGHT_UP_LEG)] {
            let phase = if side > 0.0 { clock } else { clock + 0.5 + self.late };
            let leg = self.leg(phase, side, seconds);
            // The feet land nearer to the midline than the hip joints.
            let lean = sway - side * 2.3;
            // The hip curve is the angle of the thigh to the vertical, so the turn of the pelvis is removed.
            q[first] = pelvis_q.inverse() * z(lean) * x(-leg.hip);
            q[first + 1] = x(leg.knee);
            q[first + 2] = x(-leg.ankle) * y(side * 6.0) * z(-lean);
            q[first + 3] = x(-leg.toes);
        }

        let still = if self.arms == Arms::Wave { 0.35 } else { 1.0 };
        let chest = if STANDS { gait::standing() } else { gait::chest(clock) };
        let chest_q = y(still * chest.yaw + 0.6 * self.trunk.at(seconds))
            * z(still * chest.obliquity)
            * x(self.lean + chest.tilt);
        let spine = pelvis_q.inverse() * chest_q;
        q[joint::SPINE] = half(&spine);
        q[joint::SPINE1] = q[joint::SPINE].inverse() * spine;
        // The head faces the walking direction and nods a little against the chest.
        let gaze = y(0.15 * chest.yaw + 1.2 * self.head.at(seconds)) * x(1.0 - 0.4 * (chest.tilt - 4.5));
        let neck = chest_q.inverse() * gaze;
        q[joint::NECK] = half(&neck);
        q[joint::HEAD] = q[joint::NECK].inverse() * neck;

        for (k, (side, first)) in
            [(1.0, joint::LEFT_SHOULDER), (-1.0, joint::RIGHT_SHOULDER)].into_iter().enumerate()
        {
            let phase = if side > 0.0 { clock } else { clock + 0.5 + self.late };
            match self.arms {
                Arms::Swing => self.swinging(&mut q[first..first + 4], k, side, phase, seconds),
                Arms::Wave => self.waving(&mut q[first..first + 4], k, side, seconds),
            }
        }
        q
    }

    /// A leg of this trial: the curves are scaled so that the pitch of the foot scales with them.
    fn leg(&self, phase: f64, side: f64, seconds: f64) -> gait::Leg {
        if STANDS {
            let bend = 1.0 + 0.15 * self.knees.at(seconds);
            return gait::Leg { hip: 3.0 * bend, knee: 6.0 * bend, ankle: 3.0 * bend, toes: 0.0 };
        }
        let plain = gait::leg(phase);
        let size = (self.stride + 0.02 * self.size.at(seconds)) * (1.0 + 0.5 * side * self.uneven);
        let knees = size * (1.0 + 0.015 * self.knees.at(seconds));
        let (hip, knee) = (size * plain.hip, knees * plain.knee);
        gait::Leg { hip, knee, ankle: size * plain.foot_pitch() - hip + knee, toes: size * plain.toes }
    }

    /// Shoulder, upper arm, forearm and hand of a hanging arm.
    fn swinging(&self, q: &mut [UnitQuaternion<f64>], k: usize, side: f64, phase: f64, seconds: f64) {
        let (shoulder, elbow) = gait::arm(phase);
        let size = self.swing * (1.0 + 0.06 * self.arm[k].at(seconds));
        let shoulder = -5.0 + size * (shoulder + 5.0);
        let elbow = size * elbow + 1.5 * self.elbow[k].at(seconds);
        q[0] = y(-side * 0.12 * shoulder) * z(-side * 3.0);
        // From the T-pose: turned about its own axis, lowered to the side, then swung.
        q[1] = x(-shoulder) * z(-side * 80.0) * x(90.0 + 14.0);
        q[2] = z(side * elbow);
        q[3] = z(side * 0.15 * elbow);
    }

    /// Shoulder, upper arm, forearm and hand of a raised arm whose forearm waves.
    fn waving(&self, q: &mut [UnitQuaternion<f64>], k: usize, side: f64, seconds: f64) {
        let phase = self.wave_start
            + self.wave_rate * seconds
            + 0.06 * self.wave.at(seconds)
            + if side > 0.0 { 0.0 } else { 0.03 };
        let size = self.wave_size * (1.0 + 0.07 * self.arm[k].at(seconds));
        let wave = |late: f64| size * gait::wave(phase, late);
        q[0] = z(side * (7.0 + wave(0.0)));
        q[1] =
            z(side * (6.0 + 5.0 * wave(0.0) + 1.5 * self.elbow[k].at(seconds))) * y(-side * 12.0) * x(12.0);
        q[2] = z(side * (68.0 + 24.0 * wave(0.05)));
        q[3] = z(side * (4.0 + 10.0 * wave(0.14)));
    }
}

/// A walk of `seconds` seconds [frames x channels of the skeleton]: positions in centimetres, angles in
/// degrees.
pub(super) fn walk(skeleton: &Skeleton, arms: Arms, seed: u64, seconds: f64) -> DMatrix<f64> {
    trial(&Style::<false>::new(arms, seed), skeleton, seconds)
}

/// As [`walk`], for a person who stands and waves both arms.
pub(super) fn stand(skeleton: &Skeleton, seed: u64, seconds: f64) -> DMatrix<f64> {
    trial(&Style::<true>::new(Arms::Wave, seed), skeleton, seconds)
}

fn trial<const STANDS: bool>(style: &Style<STANDS>, skeleton: &Skeleton, seconds: f64) -> DMatrix<f64> {
    let frames = (seconds * RATE).round() as usize;
    let mut rows = Frames::new(frames);
    let step = 1.0 / (RATE * SUBSTEPS as f64);
    let mut place = Vector3::zeros();
    let mut before: Option<Ground> = None;
    for tick in 0..=(frames - 1) * SUBSTEPS {
        let q = style.pose(step * tick as f64);
        let ground = Ground::under(skeleton, &q);
        if let Some(before) = &before {
            place -= before.drag(&ground);
        }
        place.y = -ground.level;
        if tick % SUBSTEPS == 0 {
            rows.add(&place, &q);
        }
        before = Some(ground);
    }
    rows.values
}

/// Heels, balls and toes of both feet relative to the root (world axes), and the share of the weight on each.
struct Ground {
    points: [Vector3<f64>; 6],
    weights: [f64; 6],
    level: f64,
}

impl Ground {
    /// The level is the soft minimum of the heights, `-s log sum_k exp(-y_k / s)`: slightly below the lowest
    /// point, and smooth when the weight moves to the other foot. The weights are its derivatives.
    fn under(skeleton: &Skeleton, q: &[UnitQuaternion<f64>; joint::COUNT]) -> Ground {
        let mut points = [Vector3::zeros(); 6];
        for (foot, first) in points.chunks_exact_mut(3).zip([joint::LEFT_UP_LEG, joint::RIGHT_UP_LEG]) {
            let mut rotation = q[joint::HIPS];
            let mut place = Vector3::zeros();
            for (joint, turn) in skeleton.joints[first..first + 3].iter().zip(&q[first..]) {
                place += rotation * Vector3::from(joint.offset);
                rotation *= turn;
            }
            foot[0] = place + rotation * body::HEEL;
            foot[1] = place + rotation * body::BALL;
            foot[2] = foot[1] + rotation * q[first + 3] * body::TOE;
        }
        let lowest = points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
        let mut weights = points.map(|p| ((lowest - p.y) / SOFTNESS).exponential());
        let sum: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|w| *w /= sum);
        Ground { points, weights, level: lowest - SOFTNESS * sum.logarithm() }
    }

    /// The movement of the standing points relative to the root, which the root must compensate.
    fn drag(&self, next: &Ground) -> Vector3<f64> {
        let mut moved = Vector3::zeros();
        for k in 0..6 {
            moved += (next.points[k] - self.points[k]) * (0.5 * (self.weights[k] + next.weights[k]));
        }
        moved
    }
}
