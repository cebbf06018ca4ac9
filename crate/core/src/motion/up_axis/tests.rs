use super::*;
use crate::motion::skeleton::Channel;
use crate::motion::{Recording, rotation, samples};
use nalgebra::{DMatrix, UnitQuaternion};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A motion of the sample body in a world with y up, from the angle about x that tilts the root, the place
/// of the root, its turn about its own length, and the rotation of each joint.
fn motion(
    tilt: f64,
    place: impl Fn(f64) -> Vector3<f64>,
    roll: impl Fn(f64) -> f64,
    joint: impl Fn(&str, f64) -> UnitQuaternion<f64>,
) -> Clip {
    let body = samples::clip("walk-1").unwrap().skeleton;
    let mut clip = Clip::new("made", body.clone(), 0.05, DMatrix::zeros(60, body.channel_count()));
    set(&mut clip, |frame, index, name| {
        let t = 0.05 * frame as f64;
        let root = rotation::about_axis(0, tilt) * rotation::about_axis(1, roll(t));
        (if index == 0 { root } else { joint(name, t) }, place(t))
    });
    clip
}

/// Sets the rotations of all joints and the place of the root.
fn set(clip: &mut Clip, pose: impl Fn(usize, usize, &str) -> (UnitQuaternion<f64>, Vector3<f64>)) {
    let starts = clip.skeleton.channel_starts();
    for frame in 0..clip.frames() {
        for (index, joint) in clip.skeleton.joints.iter().enumerate() {
            let (turn, place) = pose(frame, index, &joint.name);
            let axes: Vec<usize> = joint.rotation_axes().collect();
            let mut angles = rotation::angles_near(&turn, &axes, &[0.0; 3]).into_iter();
            for (column, channel) in (starts[index]..).zip(&joint.channels) {
                clip.values[(frame, column)] = if channel.is_rotation() {
                    angles.next().unwrap().to_degrees()
                } else {
                    place[channel.axis()]
                };
            }
        }
    }
}

/// The same motion in a turned world: by the root alone, or by the rest pose too.
pub(crate) fn in_world(clip: &Clip, turn: UnitQuaternion<f64>, with_rest: bool) -> Clip {
    let mut other = clip.clone();
    if with_rest {
        for joint in &mut other.skeleton.joints {
            joint.offset = (turn * Vector3::from(joint.offset)).into();
            joint.end_sites.iter_mut().for_each(|end| *end = (turn * Vector3::from(*end)).into());
        }
    }
    set(&mut other, |frame, index, _| {
        let pose = clip.local_pose(frame);
        let own = pose.rotations[index];
        let turned = match (with_rest, index) {
            (true, _) => turn * own * turn.inverse(),
            (false, 0) => turn * own,
            (false, _) => own,
        };
        (turned, turn * pose.positions[0])
    });
    other
}

fn about(axis: usize, degrees: f64) -> UnitQuaternion<f64> {
    rotation::about_axis(axis, degrees.to_radians())
}

fn swing(t: f64, side: f64) -> f64 {
    side * (TAU * t / 1.2).sin()
}

fn side(name: &str) -> f64 {
    if name.starts_with("Left") { 1.0 } else { -1.0 }
}

/// On hands and knees, at the place of the world where the recording began.
fn crawl(start: Vector3<f64>) -> Clip {
    motion(
        FRAC_PI_2,
        |t| start + Vector3::new(0.0, 75.0, 45.0 * t),
        |_| 0.0,
        |name, t| match name {
            "LeftArm" | "RightArm" => about(1, -side(name) * (90.0 + 20.0 * swing(t, side(name)))),
            "LeftUpLeg" | "RightUpLeg" => about(0, -90.0 + 15.0 * swing(t, side(name))),
            "LeftLeg" | "RightLeg" => about(0, 90.0),
            _ => UnitQuaternion::identity(),
        },
    )
}

fn swim(start: Vector3<f64>) -> Clip {
    motion(
        FRAC_PI_2,
        |t| start + Vector3::new(0.0, 100.0, 70.0 * t),
        |t| 0.3 * swing(t, 1.0),
        |name, t| match name {
            "LeftArm" | "RightArm" => about(2, side(name) * (80.0 + 40.0 * swing(t, side(name)))),
            "LeftUpLeg" | "RightUpLeg" => about(0, 12.0 * swing(t, side(name))),
            _ => UnitQuaternion::identity(),
        },
    )
}

fn roll(start: Vector3<f64>) -> Clip {
    motion(
        -FRAC_PI_2,
        |t| start + Vector3::new(30.0 * t, 14.0, 0.0),
        |t| -2.0 * t,
        |name, _| match name {
            "LeftArm" | "RightArm" => about(2, side(name) * -85.0),
            _ => UnitQuaternion::identity(),
        },
    )
}

/// On the back, with moving arms.
fn lie(place: Vector3<f64>) -> Clip {
    motion(
        -FRAC_PI_2,
        |_| place,
        |_| 0.0,
        |name, t| match name {
            "LeftArm" | "RightArm" => about(1, side(name) * (20.0 * swing(t, 1.0) - 90.0)),
            _ => UnitQuaternion::identity(),
        },
    )
}

#[test]
fn the_axis_is_found_in_every_world_or_named_as_possible() {
    let walk = samples::clip("walk-1").unwrap();
    let mut clips = vec![("walk", walk)];
    for (height, name) in [(60.0, "bench"), (10.0, "floor")] {
        // The second recording begins above the origin.
        clips.extend([150.0, 0.0].map(|x| (name, lie(Vector3::new(x, height, 1.5 * x)))));
    }
    for place in [Vector3::new(120.0, 0.0, 260.0), Vector3::new(-200.0, 0.0, -400.0)] {
        clips.extend([("crawl", crawl(place)), ("swim", swim(place)), ("roll", roll(place))]);
    }
    // In how many of the twelve worlds the axis is right, and certain.
    let mut counts = Vec::new();
    for (name, clip) in &clips {
        let mut count = [0, 0];
        for up in UpAxis::ALL {
            for with_rest in [false, true] {
                let turned = in_world(clip, up.to_y_up().inverse(), with_rest);
                let FoundAxis { axis, others, .. } = turned.search_up_axis();
                let is_right = match *name {
                    "walk" => axis == up && others.is_empty(),
                    "crawl" => axis == up,
                    _ => axis == up || others.contains(&up),
                };
                assert!(is_right, "{name}, {up:?}, {with_rest}: {axis:?} {others:?}");
                count[0] += usize::from(axis == up);
                count[1] += usize::from(others.is_empty());
            }
        }
        counts.push(count);
    }
    let moving = [[12, 12], [8, 0], [11, 7]];
    assert_eq!(counts, [&[[12, 12], [0, 0], [0, 0], [7, 7], [7, 7]][..], &moving, &moving].concat());
}

/// A chain of three bones with its root at `place` in the first of twenty frames, and moved by `way` in the last.
fn chain(bone: [f64; 3], place: [f64; 3], way: [f64; 3]) -> Clip {
    let mut body =
        crate::motion::testing::tree(&[("a", None), ("b", Some(0)), ("c", Some(1)), ("d", Some(2))]);
    body.joints.iter_mut().for_each(|joint| joint.offset = bone);
    body.joints[0].channels = Channel::ALL.to_vec();
    let values = DMatrix::from_fn(20, body.channel_count(), |frame, column| {
        if column < 3 { place[column] + way[column] * frame as f64 / 19.0 } else { 0.0 }
    });
    Clip::new("chain", body, 0.1, values)
}

#[test]
fn a_body_without_limbs_stands_along_its_longest_side_unless_it_travels_there() {
    let axis = |bone, place, way| chain(bone, place, way).search_up_axis().axis;
    for place in [[0.0; 3], [0.0, 90.0, 0.0], [0.0, 0.0, 90.0], [0.0, 0.0, -90.0]] {
        assert_eq!(axis([1.0, 2.0, 9.0], place, [0.0; 3]), UpAxis::Z, "{place:?}");
        assert_eq!(axis([1.0, 9.0, 9.0], place, [0.0; 3]), UpAxis::Y, "{place:?}");
        assert_eq!(axis([9.0, 1.0, 2.0], place, [0.0; 3]), UpAxis::X, "{place:?}");
        assert_eq!(axis([1.0, 2.0, 9.0], place, [0.0, 0.0, 40.0]), UpAxis::Y, "{place:?}");
    }
}

/// Some files give the place of the root beside its first place.
#[test]
fn a_path_that_begins_at_the_origin_hides_no_axis() {
    for id in ["walk-1", "stand-wave-1"] {
        let mut clip = samples::clip(id).unwrap();
        for column in 0..3 {
            let first = clip.values[(0, column)];
            clip.values.column_mut(column).add_scalar_mut(-first);
        }
        for up in UpAxis::ALL {
            for with_rest in [false, true] {
                let turned = in_world(&clip, up.to_y_up().inverse(), with_rest);
                let FoundAxis { axis, others, .. } = turned.search_up_axis();
                assert!(axis == up && others.is_empty(), "{id}, {up:?}, {with_rest}: {axis:?} {others:?}");
            }
        }
    }
}

#[test]
fn an_axis_that_is_not_certain_is_said_until_it_is_stated() {
    let turned = in_world(&swim(Vector3::zeros()), UpAxis::Z.to_y_up().inverse(), false);
    let clip = turned.with_checked_axis();
    assert!(clip.warnings[0].starts_with(UNCERTAIN), "{:?}", clip.warnings);
    let stated = clip.with_up(UpAxis::Z);
    assert_eq!((stated.up_axis(), stated.warnings.len()), (UpAxis::Z, 0));
    assert!(samples::clip("walk-1").unwrap().with_checked_axis().warnings.is_empty());
}

/// A plane through the hips is no floor: the body is not taken for one that lies there.
#[test]
fn a_body_above_no_floor_stands_or_its_axis_is_named() {
    let mut clip = samples::clip("stand-wave-1").unwrap();
    for (column, start) in [0.0, 120.0, 0.0].into_iter().enumerate() {
        let first = clip.values[(0, column)];
        clip.values.column_mut(column).add_scalar_mut(start - first);
    }
    for up in UpAxis::ALL {
        let turned = in_world(&clip, up.to_y_up().inverse(), false);
        let FoundAxis { axis, others, .. } = turned.search_up_axis();
        assert!(axis == up || others.contains(&up), "{up:?}: {axis:?} {others:?}");
    }
}

#[test]
fn a_crawl_whose_path_is_in_another_unit_is_named() {
    for (factor, text) in [(0.1, "10 times too short"), (1.0, ""), (10.0, "10 times too long")] {
        let mut clip = crawl(Vector3::new(120.0, 0.0, 260.0));
        (0..3).for_each(|axis| clip.values.column_mut(axis).apply(|x| *x *= factor));
        let read = Recording::new("crawl.bvh", clip.skeleton, clip.frame_time, clip.values).into_clip();
        let units = read.warnings.iter().find(|warning| warning.contains("times too"));
        assert!(units.map_or(text.is_empty(), |units| units.contains(text)), "{factor}: {:?}", read.warnings);
    }
}
