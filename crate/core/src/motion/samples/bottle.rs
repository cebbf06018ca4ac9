//! Passing a bottle from hand to hand on a chair: the right hand takes the bottle at the right side, passes it
//! to the left hand in front of the body, and the left hand puts it down at the left side.
//!
//! The hands follow paths of minimum jerk between the places of a trial (Flash and Hogan 1985), the arms
//! follow the hands, and trunk and head turn to the bottle.

use crate::elementary::Elementary;
use crate::motion::samples::body::{Frames, RATE};
use crate::motion::samples::body::{HEIGHT, joint};
use crate::motion::samples::turns::{half, x, y, z};
use crate::motion::samples::variation::{Drift, between};
use crate::motion::skeleton::Skeleton;
use nalgebra::{DMatrix, Matrix3, Rotation3, UnitQuaternion, Vector3};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// From the wrist to the middle of the hand, which holds the bottle, centimetres.
const GRIP: f64 = 0.054 * HEIGHT;
/// Height of the right hand above the left one on the bottle when both hold it, centimetres.
const APART: f64 = 9.0;
/// The arms: sign of the side, index of the first joint.
const ARMS: [(f64, usize); 2] = [(1.0, joint::LEFT_SHOULDER), (-1.0, joint::RIGHT_SHOULDER)];

/// A movement from one place to the next: from the second `start` to the second `end`, with an arch upwards.
#[derive(Clone, Copy)]
struct Stroke {
    start: f64,
    end: f64,
    to: Vector3<f64>,
    arch: f64,
}

/// A path in space: at rest at `from`, then along the strokes, at rest in between.
struct Path {
    from: Vector3<f64>,
    strokes: Vec<Stroke>,
}

impl Path {
    /// The place at a time.
    fn at(&self, seconds: f64) -> Vector3<f64> {
        let mut place = self.from;
        for stroke in &self.strokes {
            let u = ((seconds - stroke.start) / (stroke.end - stroke.start)).clamp(0.0, 1.0);
            let share = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
            place += (stroke.to - place) * share;
            place.y += stroke.arch * 16.0 * (u * (1.0 - u)).powi(2);
        }
        place
    }

    /// The same path, earlier by some seconds.
    fn earlier(&self, seconds: f64) -> Path {
        let earlier = |s: &Stroke| Stroke { start: s.start - seconds, end: s.end - seconds, ..*s };
        Path { from: self.from, strokes: self.strokes.iter().map(earlier).collect() }
    }
}

/// The parameters of one trial. Places are relative to the hips.
struct Style {
    /// The middle of the left and of the right hand.
    hands: [Path; 2],
    /// Where trunk and head turn to: the bottle, a little ahead of the hands.
    attention: Path,
    seconds: f64,
    slouch: f64,
    turning: f64,
    hip: f64,
    splay: f64,
    tremor: [Drift; 2],
    elbow: [Drift; 2],
    trunk: Drift,
    head: Drift,
    legs: Drift,
}

impl Style {
    fn new(seed: u64) -> Style {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let mut place = |middle: [f64; 3], spread: [f64; 3]| {
            Vector3::from(middle) + Vector3::from(spread.map(|s| between(random, -s, s)))
        };
        let rest = [place([15.0, 9.0, 26.0], [2.0, 1.0, 3.0]), place([-15.0, 9.0, 26.0], [2.0, 1.0, 3.0])];
        let bottle = place([-46.0, 8.0, 27.0], [6.0, 7.0, 7.0]);
        let meeting = place([0.0, 27.0, 35.0], [5.0, 9.0, 5.0]);
        let goal = place([46.0, 8.0, 27.0], [6.0, 7.0, 7.0]);
        let back = place([-15.0, 9.0, 26.0], [2.0, 1.0, 3.0]);
        // The clip begins when the right hand moves.
        let start = -between(random, 0.08, 0.14);
        let tempo = between(random, 0.88, 1.12);
        let mut time = start;
        let mut after = |seconds: [f64; 2]| {
            time += tempo * between(random, seconds[0], seconds[1]);
            time
        };
        let taken = after([0.75, 0.95]);
        let lifted = after([0.12, 0.22]);
        let met = after([0.8, 1.0]);
        let given = after([0.18, 0.3]);
        let put_down = after([0.8, 1.05]);
        let seconds = put_down + 0.15;
        let left_start = met - tempo * between(random, 0.65, 0.8);
        let returned = given + tempo * between(random, 0.75, 0.9);
        let arches = [6.0, 5.0, 3.0].map(|arch| arch * between(random, 0.6, 1.4));
        let above = Vector3::new(0.0, 0.5 * APART, 0.0);
        let stroke = |start, end, to, arch| Stroke { start, end, to, arch };
        let (carry, put) =
            (stroke(lifted, met, meeting, arches[1]), stroke(given, put_down, goal, arches[1]));
        let left = vec![stroke(left_start, met, meeting - above, arches[2]), put];
        let right = vec![
            stroke(start, taken, bottle, arches[0]),
            Stroke { to: meeting + above, ..carry },
            stroke(given, returned, back, arches[2]),
        ];
        let front = Vector3::new(0.0, 15.0, 35.0);
        let seen = Path { from: front, strokes: vec![stroke(start, taken, bottle, 0.0), carry, put] };
        Style {
            hands: [Path { from: rest[0], strokes: left }, Path { from: rest[1], strokes: right }],
            attention: seen.earlier(0.12),
            seconds,
            slouch: between(random, 2.0, 7.0),
            turning: between(random, 0.24, 0.32),
            hip: between(random, 84.0, 88.0),
            splay: between(random, 6.0, 11.0),
            tremor: [Drift::new(random), Drift::new(random)],
            elbow: [Drift::new(random), Drift::new(random)],
            trunk: Drift::new(random),
            head: Drift::new(random),
            legs: Drift::new(random),
        }
    }

    /// The place of the root and the local rotations of all joints at a time.
    fn pose(&self, skeleton: &Skeleton, seconds: f64) -> (Vector3<f64>, [UnitQuaternion<f64>; joint::COUNT]) {
        let mut q = [UnitQuaternion::identity(); joint::COUNT];
        let attention = self.attention.at(seconds);
        let turn = self.turning * attention.x;
        let reach = 0.12 * attention.x.abs() + 0.8 * self.trunk.at(seconds);

        let pelvis = y(0.15 * turn) * x(-4.0 + 0.2 * reach);
        q[joint::HIPS] = pelvis;
        for (side, first) in [(1.0, joint::LEFT_UP_LEG), (-1.0, joint::RIGHT_UP_LEG)] {
            let splay = y(side * (self.splay + 0.4 * self.legs.at(seconds)));
            q[first] = pelvis.inverse() * splay * x(-self.hip);
            q[first + 1] = x(self.hip);
        }
        let chest = y(turn) * z(-0.35 * turn) * x(self.slouch + reach);
        let spine = pelvis.inverse() * chest;
        q[joint::SPINE] = half(&spine);
        q[joint::SPINE1] = q[joint::SPINE].inverse() * spine;
        let gaze = y(2.0 * turn + 1.5 * self.head.at(seconds)) * x(14.0 - 0.3 * (attention.y - 15.0));
        let neck = chest.inverse() * gaze;
        q[joint::NECK] = half(&neck);
        q[joint::HEAD] = q[joint::NECK].inverse() * neck;

        let bears_arms = pelvis * offset(skeleton, joint::SPINE)
            + pelvis * q[joint::SPINE] * offset(skeleton, joint::SPINE1);
        for (k, (side, first)) in ARMS.into_iter().enumerate() {
            let hand = self.hands[k].at(seconds) + Vector3::repeat(0.3 * self.tremor[k].at(seconds));
            let far = (hand - bears_arms).norm() - 50.0;
            q[first] = y(-side * 0.3 * far) * z(-side * 3.0);
            let girdle = chest * q[first];
            let shoulder =
                bears_arms + chest * offset(skeleton, first) + girdle * offset(skeleton, first + 1);
            let lengths = [offset(skeleton, first + 2).norm(), offset(skeleton, first + 3).norm() + GRIP];
            let out = 0.5 + 0.06 * self.elbow[k].at(seconds);
            let (upper, bend) = arm(side, &(hand - shoulder), lengths, out);
            q[first + 1] = girdle.inverse() * upper;
            q[first + 2] = bend;
            // The palm turns from the thigh to the bottle. This turn about the forearm moves no grip.
            q[first + 3] = x(10.0 + 1.5 * (hand.y - 9.0));
        }

        // The feet stay on the floor.
        let sole = |first: usize| {
            let thigh = pelvis * q[first];
            pelvis * offset(skeleton, first)
                + thigh * offset(skeleton, first + 1)
                + thigh * q[first + 1] * offset(skeleton, first + 2)
                + offset(skeleton, first + 3)
        };
        let soles = 0.5 * (sole(joint::LEFT_UP_LEG) + sole(joint::RIGHT_UP_LEG));
        (-soles, q)
    }
}

#[inline(never)]
fn offset(skeleton: &Skeleton, joint: usize) -> Vector3<f64> {
    Vector3::from(skeleton.joints[joint].offset)
}

/// The rotation of an upper arm in the world and the bend of the elbow for a hand at `to` from the shoulder.
///
/// `lengths`: upper arm; forearm up to the grip. The elbow points down, and `out` to its side.
fn arm(
    side: f64,
    to: &Vector3<f64>,
    lengths: [f64; 2],
    out: f64,
) -> (UnitQuaternion<f64>, UnitQuaternion<f64>) {
    let [a, b] = lengths;
    let distance = to.norm().min(0.999 * (a + b));
    let along = to.normalize();
    let pole = Vector3::new(side * out, -1.0, -0.15);
    let across = (pole - along * along.dot(&pole)).normalize();
    let near = (a * a + distance * distance - b * b) / (2.0 * distance);
    let elbow = along * near + across * (a * a - near * near).max(0.0).sqrt();
    let (u, forearm) = (elbow / a, (along * distance - elbow) / b);
    let cosine = u.dot(&forearm);
    let v = (forearm - u * cosine).normalize();
    let axes = Matrix3::from_columns(&[side * u, v, side * u.cross(&v)]);
    let upper = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    (upper, z(side * forearm.dot(&v).arctangent(cosine).to_degrees()))
}

/// A trial [frames x channels of the skeleton]: positions in centimetres, angles in degrees.
pub(super) fn pass(skeleton: &Skeleton, seed: u64) -> DMatrix<f64> {
    let style = Style::new(seed);
    let frames = (style.seconds * RATE).round() as usize;
    let mut rows = Frames::new(frames);
    for frame in 0..frames {
        let (place, q) = style.pose(skeleton, frame as f64 / RATE);
        rows.add(&place, &q);
    }
    rows.values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::samples::{self, body};
    use crate::motion::{Clip, RHYTHMIC, period};

    const SECONDS: f64 = 1.0 / RATE;

    fn clips() -> Vec<Clip> {
        let bottles = samples::list().into_iter().filter(|info| info.movement == "pass a bottle");
        bottles.map(|info| samples::clip(info.id).unwrap()).collect()
    }

    /// The middle of the left and of the right hand in every frame, from the hips.
    fn hands(clip: &Clip) -> Vec<[Vector3<f64>; 2]> {
        let middle = |frame: usize, first: usize| {
            let pose = clip.world_pose(frame);
            let hand = first + 3;
            let finger = Vector3::from(clip.skeleton.joints[hand].end_sites[0]);
            pose.positions[hand] + pose.rotations[hand] * (0.5 * finger) - pose.positions[joint::HIPS]
        };
        (0..clip.frames()).map(|frame| ARMS.map(|(_, first)| middle(frame, first))).collect()
    }

    fn distances(clip: &Clip) -> Vec<f64> {
        hands(clip).iter().map(|[left, right]| (left - right).norm()).collect()
    }

    /// The frame in which the hands are nearest to each other.
    fn meeting(clip: &Clip) -> usize {
        let distances = distances(clip);
        (0..distances.len()).min_by(|a, b| distances[*a].total_cmp(&distances[*b])).unwrap()
    }

    #[test]
    fn the_hands_meet_on_the_bottle_and_only_there() {
        for clip in clips() {
            let (apart, met) = (distances(&clip), meeting(&clip));
            assert!((6.5..11.5).contains(&apart[met]), "{}: {} cm", clip.name, apart[met]);
            let [left, right] = hands(&clip)[met];
            let beside = (left.x - right.x).hypot(left.z - right.z);
            assert!(beside < 4.0, "{}: one above the other, {beside} cm apart", clip.name);
            let frames = apart.iter().filter(|distance| **distance < 12.0).count();
            let seconds = frames as f64 * SECONDS;
            assert!((0.2..0.9).contains(&seconds), "{}: together for {seconds} s", clip.name);
            assert!(apart[0] > 22.0 && apart[apart.len() - 1] > 45.0, "{}", clip.name);
        }
    }

    #[test]
    fn the_bottle_goes_from_the_right_side_to_the_left() {
        for clip in clips() {
            let (hands, met) = (hands(&clip), meeting(&clip));
            let right = hands[..met].iter().map(|[_, right]| right.x).fold(0.0, f64::min);
            assert!((-54.0..-38.0).contains(&right), "{}: taken at {right}", clip.name);
            let [left, other] = hands[hands.len() - 1];
            assert!((38.0..54.0).contains(&left.x), "{}: put down at {}", clip.name, left.x);
            assert!(other.y < 14.0 && other.x < -10.0, "{}: the right hand is on the thigh", clip.name);
            assert!(hands[met].iter().all(|hand| hand.z > 25.0 && hand.y > 10.0), "{}", clip.name);
        }
    }

    #[test]
    fn trials_differ_in_height_place_and_timing() {
        let spread = |values: Vec<f64>| {
            let (low, high) = (
                values.iter().copied().fold(f64::MAX, f64::min),
                values.iter().copied().fold(f64::MIN, f64::max),
            );
            high - low
        };
        let of = |value: &dyn Fn(&Clip) -> f64| spread(clips().iter().map(value).collect());
        assert!(of(&|clip| hands(clip)[meeting(clip)][0].y) > 8.0, "height of the meeting");
        assert!(of(&|clip| hands(clip)[clip.frames() - 1][0].z) > 6.0, "place of the bottle");
        assert!(of(&|clip| meeting(clip) as f64 * SECONDS) > 0.2, "time of the meeting");
        assert!(of(&|clip| clip.frames() as f64 * SECONDS) > 0.3, "length");
    }

    #[test]
    fn the_head_looks_down_to_the_hands() {
        for clip in clips() {
            for frame in 0..clip.frames() {
                let gaze = clip.world_pose(frame).rotations[joint::HEAD] * Vector3::z();
                assert!((-0.4..-0.02).contains(&gaze.y), "{}: {gaze}", clip.name);
            }
        }
    }

    #[test]
    fn the_body_sits_on_a_chair_with_its_feet_on_the_floor() {
        for clip in clips() {
            let first = clip.world_pose(0).positions;
            for frame in 0..clip.frames() {
                let places = clip.world_pose(frame).positions;
                for foot in [joint::LEFT_UP_LEG + 3, joint::RIGHT_UP_LEG + 3] {
                    let moved = places[foot] - first[foot];
                    assert!(places[foot].y.abs() < 1.0 && moved.norm() < 2.0, "{}: {moved}", clip.name);
                }
                let [knee, hip] = [joint::LEFT_UP_LEG + 1, joint::LEFT_UP_LEG].map(|j| places[j].y);
                assert!((hip - knee).abs() < 0.05 * body::HEIGHT, "{}: the thighs are level", clip.name);
            }
        }
    }

    #[test]
    fn the_movement_is_smooth_natural_and_not_periodic() {
        for clip in clips() {
            let cycle = period(std::slice::from_ref(&clip.values));
            assert!(cycle.is_none_or(|period| period.correlation < RHYTHMIC), "{}", clip.name);
            let hands = hands(&clip);
            for (k, three) in hands.windows(3).enumerate() {
                for hand in 0..2 {
                    let speed = (three[1][hand] - three[0][hand]).norm() / SECONDS;
                    assert!(speed < 200.0, "{}: frame {k}, {speed} cm/s", clip.name);
                    let change = (three[2][hand] - 2.0 * three[1][hand] + three[0][hand]).norm() / SECONDS;
                    assert!(change < 25.0, "{}: frame {k}, speed changes by {change} cm/s", clip.name);
                }
            }
            // Every elbow bends by 15 to 140 degrees, to one side only.
            for (side, first) in ARMS {
                let column = 3 + 3 * (first + 2);
                let bends = clip.values.column(column).map(|bend| side * bend);
                assert!(
                    bends.min() > 15.0 && bends.max() < 140.0,
                    "{}: {} to {}",
                    clip.name,
                    bends.min(),
                    bends.max()
                );
            }
        }
    }
}
