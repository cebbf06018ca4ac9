//! Rows of Y compared with the motion that they encode.

use super::mapping::ROOT_COLUMNS;
use super::*;
use crate::json::Field;
use crate::motion::bvh;
use crate::motion::clip::Clip;
use crate::motion::rotation;
use crate::motion::skeleton::{Channel, Joint, Skeleton};
use crate::motion::stage::UpAxis;
use crate::motion::testing::any_clip;
use approx::assert_abs_diff_eq;
use nalgebra::{DMatrix, UnitQuaternion, Vector3};
use proptest::prelude::*;

/// A person with named legs and arms who walks round a circle, 40 frames at 30 a second; the root's angles in
/// the order y, x, z, the others' z, x, y.
fn walker() -> Clip {
    let (root, rest) = (
        [
            Channel::Xposition,
            Channel::Yposition,
            Channel::Zposition,
            Channel::Yrotation,
            Channel::Xrotation,
            Channel::Zrotation,
        ],
        [Channel::Zrotation, Channel::Xrotation, Channel::Yrotation],
    );
    let joint = |name: &str, parent: Option<usize>, offset| Joint {
        name: name.to_owned(),
        parent,
        offset,
        channels: if parent.is_none() { root.to_vec() } else { rest.to_vec() },
        end_sites: if name.ends_with("Foot") || name == "Head" { vec![[0.0, 0.1, 0.15]] } else { Vec::new() },
    };
    let skeleton = Skeleton {
        joints: vec![
            joint("Hips", None, [0.0; 3]),
            joint("LeftUpLeg", Some(0), [0.1, 0.0, 0.0]),
            joint("LeftLeg", Some(1), [0.0, -0.45, 0.0]),
            joint("LeftFoot", Some(2), [0.0, -0.45, 0.0]),
            joint("RightUpLeg", Some(0), [-0.1, 0.0, 0.0]),
            joint("RightLeg", Some(4), [0.0, -0.45, 0.0]),
            joint("RightFoot", Some(5), [0.0, -0.45, 0.0]),
            joint("Spine", Some(0), [0.0, 0.3, 0.0]),
            joint("Head", Some(7), [0.0, 0.4, 0.0]),
        ],
    };
    let channels = skeleton.channel_count();
    let mut values = DMatrix::zeros(40, channels);
    for t in 0..40 {
        let (phase, yaw) = (0.2 * t as f64, 0.03 * t as f64);
        let row = [-yaw.cos() * 2.0, 0.93 + 0.02 * (2.0 * phase).sin(), yaw.sin() * 2.0];
        for (column, value) in row.into_iter().enumerate() {
            values[(t, column)] = value;
        }
        values[(t, 3)] = yaw.to_degrees();
        values[(t, 4)] = 5.0;
        values[(t, 5)] = 3.0 * phase.sin();
        for joint in 1..9 {
            values[(t, 3 + 3 * joint)] = 4.0 * (phase + joint as f64).cos();
            values[(t, 4 + 3 * joint)] = 25.0 * (phase + joint as f64).sin();
        }
    }
    Clip::new("walker.bvh", skeleton, 1.0 / 30.0, values)
}

/// The clip with its world turned: root positions and orientations.
fn in_other_world(clip: &Clip, turn: UnitQuaternion<f64>, shift: Vector3<f64>) -> Clip {
    let mut values = clip.values.clone();
    for t in 0..clip.frames() {
        let pose = clip.local_pose(t);
        let place = turn * pose.positions[0] + shift;
        let angles = rotation::euler_near(&(turn * pose.rotations[0]), [1, 0, 2], [0.0; 3]);
        for axis in 0..3 {
            values[(t, axis)] = place[axis];
            values[(t, 3 + axis)] = angles[axis].to_degrees();
        }
    }
    Clip::new("turned.bvh", clip.skeleton.clone(), clip.frame_time, values)
}

#[test]
fn a_walk_round_a_circle_has_constant_rows() {
    let clip = walker();
    let mapping = PoseMapping::new(&clip);
    let y = mapping.encode(&clip).unwrap().y;
    assert_eq!(y.shape(), (40, 30));
    for t in 0..40 {
        assert_abs_diff_eq!(y[(t, 0)], 0.03, epsilon = 1e-12);
        // A chord of a circle of 2 m; legs of half of 1.75 m.
        assert_abs_diff_eq!(
            y[(t, 1)].hypot(y[(t, 2)]),
            4.0 * 0.015_f64.sin() / mapping.leg(),
            epsilon = 1e-12
        );
        assert!(y[(t, 1)] > 0.0 && y[(t, 2)].abs() < 0.1 * y[(t, 1)]);
        assert!(y[(t, 4)].abs() < 0.12 && y[(t, 5)].abs() < 0.12);
    }
    let columns = mapping.columns();
    assert_eq!(columns[9], Column { joint: 2, kind: ColumnKind::Rotation(0) });
}

#[test]
fn rows_do_not_depend_on_position_and_heading() {
    let clip = walker();
    let mapping = PoseMapping::new(&clip);
    let y = mapping.encode(&clip).unwrap().y;
    for yaw in [0.7, 2.9, -2.0] {
        let other = in_other_world(&clip, rotation::about_axis(1, yaw), Vector3::new(30.0, 0.0, -7.0));
        let encoded = mapping.encode(&other).unwrap();
        assert_abs_diff_eq!(encoded.y, y, epsilon = 1e-9);
        assert_abs_diff_eq!(rotation::wrapped(encoded.start.yaw - yaw), 0.0, epsilon = 0.1);
    }
}

#[test]
fn rows_do_not_depend_on_the_axes_of_the_world() {
    let clip = walker();
    let y = PoseMapping::new(&clip).encode(&clip).unwrap().y;
    for (turn, up) in [(rotation::about_axis(0, 0.5), UpAxis::Z), (rotation::about_axis(2, -0.5), UpAxis::X)]
    {
        // Quarter turns.
        let turn = turn.powf(std::f64::consts::PI);
        let other = in_other_world(&clip, turn, Vector3::zeros());
        let mapping = PoseMapping::new(&other);
        assert_eq!(mapping.stage().up, up);
        assert_abs_diff_eq!(mapping.encode(&other).unwrap().y, y, epsilon = 1e-9);
    }
}

#[test]
fn another_axis_than_that_of_the_mapping_is_found_or_stated() {
    let clip = walker();
    let mapping = PoseMapping::new(&clip);
    let rows = mapping.encode(&clip).unwrap();
    let turn = rotation::exp(&(Vector3::x() * std::f64::consts::FRAC_PI_2));
    let other = in_other_world(&clip, turn, Vector3::zeros());
    let stated = mapping.encode(&Clip { up: Some(UpAxis::Z), ..other.clone() }).unwrap();
    assert_abs_diff_eq!(stated.y, rows.y, epsilon = 1e-9);
    // The motion starts at the same height: the heading is a choice.
    assert_abs_diff_eq!(stated.start.position[1], rows.start.position[1], epsilon = 1e-9);
    let found = mapping.encode(&other).unwrap();
    assert_eq!(found.y, stated.y);
    assert!(found.warnings[0].starts_with("the up axis is z here and y in the body"), "{:?}", found.warnings);
    assert!(stated.warnings.is_empty() && rows.warnings.is_empty());
    // A stated axis counts even if the body lies then.
    let lying = mapping.encode(&Clip { up: Some(UpAxis::Z), ..clip }).unwrap();
    assert!((lying.y - rows.y).amax() > 0.1);
}

#[test]
fn the_axis_found_in_a_clip_counts_if_the_body_stands_along_it_alone() {
    let clip = walker();
    let mapping = PoseMapping::new(&clip);
    let warning = |lean: f64| {
        let leaning = in_other_world(&clip, rotation::about_axis(0, lean.to_radians()), Vector3::zeros());
        mapping.axis_warning(&Clip { found_up: Some(UpAxis::Z), ..leaning })
    };
    assert_eq!(warning(5.0), None);
    assert!(warning(60.0).unwrap().contains("the up axis is z here and y in the body"));
}

#[test]
fn rows_do_not_depend_on_the_axes_of_the_root() {
    // The same motion with a root whose y axis points ahead, as in files with bone-aligned joints.
    let clip = walker();
    let turn = rotation::exp(&(Vector3::x() * std::f64::consts::FRAC_PI_2));
    let mut skeleton = clip.skeleton.clone();
    for joint in skeleton.joints.iter_mut().filter(|joint| joint.parent == Some(0)) {
        joint.offset = (turn.inverse() * Vector3::from(joint.offset)).into();
    }
    let mut values = clip.values.clone();
    for t in 0..clip.frames() {
        let pose = clip.local_pose(t);
        let mut write = |column: usize, axes: [usize; 3], q: UnitQuaternion<f64>| {
            for (at, angle) in rotation::euler_near(&q, axes, [0.0; 3]).into_iter().enumerate() {
                values[(t, column + at)] = angle.to_degrees();
            }
        };
        write(3, [1, 0, 2], pose.rotations[0] * turn);
        for joint in [1, 4, 7] {
            write(3 + 3 * joint, [2, 0, 1], turn.inverse() * pose.rotations[joint]);
        }
    }
    let other = Clip::new("bones.bvh", skeleton, clip.frame_time, values);
    let (mapping, other_mapping) = (PoseMapping::new(&clip), PoseMapping::new(&other));
    let (y, turned) = (mapping.encode(&clip).unwrap().y, other_mapping.encode(&other).unwrap().y);
    for (column, kind) in ROOT_COLUMNS.into_iter().enumerate() {
        // The rest pose lies on its face, so the body's height is measured a little differently.
        let angle = matches!(kind, ColumnKind::YawRate | ColumnKind::Pitch | ColumnKind::Roll);
        let scale = if angle { 1.0 } else { other_mapping.leg() / mapping.leg() };
        assert_abs_diff_eq!(turned.column(column) * scale, y.column(column).into_owned(), epsilon = 1e-9);
    }
}

#[test]
fn one_frame_is_encoded_and_decoded() {
    let clip = walker().cut(7, 8).unwrap();
    let mapping = PoseMapping::new(&clip);
    let encoded = mapping.encode(&clip).unwrap();
    assert_eq!(encoded.y.row(0).iter().take(3).copied().collect::<Vec<_>>(), [0.0; 3]);
    let back = mapping.decode(&encoded.y, &encoded.start, clip.frame_time).unwrap();
    assert_abs_diff_eq!(back.values, clip.values, epsilon = 1e-9);
}

#[test]
fn a_spinning_joint_accumulates_turns_and_a_flipping_one_does_not() {
    let mut clip = walker();
    let column = 3 + 3 * 8;
    for t in 0..40 {
        clip.values.fixed_view_mut::<1, 3>(t, column).fill(0.0);
        clip.values[(t, column)] = 20.0 * t as f64;
    }
    let mapping = PoseMapping::new(&clip);
    let y = mapping.encode(&clip).unwrap().y;
    for t in 0..40 {
        assert_abs_diff_eq!(y[(t, 29)], (20.0 * t as f64).to_radians(), epsilon = 1e-9);
        clip.values[(t, column)] = if t % 2 == 0 { 10.0 } else { 185.0 };
    }
    let y = mapping.encode(&clip).unwrap().y;
    assert!(y.column(29).amax() < 3.2);
}

#[test]
fn joints_that_move_in_their_parents_frame_give_a_warning() {
    let mut clip = walker();
    clip.skeleton.joints[8].channels.insert(0, Channel::Yposition);
    let column = clip.skeleton.channel_starts()[8];
    clip.values = clip.values.insert_column(column, 0.4);
    let mapping = PoseMapping::new(&clip);
    assert!(mapping.encode(&clip).unwrap().warnings.is_empty());
    clip.values[(3, column)] = 0.5;
    let warnings = mapping.encode(&clip).unwrap().warnings;
    assert!(warnings[0].contains("\"Head\""), "{warnings:?}");
}

#[test]
fn wrong_bodies_widths_and_numbers_are_refused() {
    let clip = walker();
    let mapping = PoseMapping::new(&clip);
    let mut other = clip.clone();
    other.skeleton.joints[5].name = "Tail".to_owned();
    let message = mapping.encode(&other).unwrap_err().to_string();
    assert!(message.contains("walker.bvh") && message.contains("\"RightLeg\", found \"Tail\""), "{message}");
    let start = RootStart::default();
    let message = mapping.decode_positions(&DMatrix::zeros(2, 29), &start).unwrap_err().to_string();
    assert!(message.contains("expected 30 columns, found 29"));
    let mut y = DMatrix::zeros(3, 30);
    y[(2, 7)] = f64::NAN;
    let message = mapping.decode(&y, &start, 0.1).unwrap_err().to_string();
    assert!(message.contains("frame 2, column 7"), "{message}");
    let far = RootStart { position: [0.0, f64::INFINITY, 0.0], ..start };
    let message = mapping.decode(&DMatrix::zeros(3, 30), &far, 0.1).unwrap_err().to_string();
    assert!(message.contains("finite numbers"), "{message}");
}

/// A root whose steps were all small once moved so far that the written file could not be read back.
#[test]
fn a_walk_farther_than_a_file_can_store_is_refused() {
    let mapping = PoseMapping::new(&walker());
    let walked = |units: f64| {
        let mut y = DMatrix::zeros(40, mapping.column_count());
        // Straight ahead, in leg lengths a frame.
        y.column_mut(1).fill(units / mapping.leg() / 40.0);
        mapping.decode(&y, &RootStart::default(), 0.1)
    };
    let near = walked(0.9e9).unwrap();
    assert!(bvh::read("near.bvh", bvh::write(&near).as_bytes()).is_ok());
    let message = walked(1.1e9).err().unwrap().to_string();
    assert!(message.contains("a place from -1e9 to 1e9 in the units of the file"), "{message}");
}

#[test]
fn a_mapping_is_read_as_it_was_written() {
    let mapping = PoseMapping::new(&walker());
    assert_eq!(PoseMapping::from_field(Field::root(&mapping.to_value())).unwrap(), mapping);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn decoding_inverts_encoding(clip in any_clip()) {
        // Joints other than the root keep their place in their parent's frame.
        let mut clip = clip;
        let starts = clip.skeleton.channel_starts();
        for (joint, &start) in clip.skeleton.joints.iter().zip(&starts).skip(1) {
            for (at, channel) in joint.channels.iter().enumerate() {
                if !channel.is_rotation() {
                    let first = clip.values[(0, start + at)];
                    clip.values.column_mut(start + at).fill(first);
                }
            }
        }
        let mapping = PoseMapping::new(&clip);
        let encoded = mapping.encode(&clip).unwrap();
        prop_assert!(encoded.warnings.is_empty());
        let back = mapping.decode(&encoded.y, &encoded.start, clip.frame_time).unwrap();
        prop_assert_eq!(&back.skeleton, &clip.skeleton);
        let fast = mapping.decode_positions(&encoded.y, &encoded.start).unwrap();
        let mut fast = fast.chunks_exact(3);
        for t in 0..clip.frames() {
            let (was, is) = (clip.world_pose(t), back.world_pose(t));
            for (a, b) in was.positions.iter().zip(&is.positions) {
                prop_assert!((a - b).norm() < 1e-9 * (1.0 + a.norm()), "{} {}", a, b);
                let staged = mapping.stage().place(&(mapping.stage().up.to_y_up() * a));
                let fast = fast.next().unwrap();
                let size = staged.iter().fold(1.0_f32, |size, x| size.max(x.abs()));
                prop_assert!((0..3).all(|n| (fast[n] - staged[n]).abs() < 1e-5 * size), "{:?} {:?}", fast, staged);
            }
            for (a, b) in was.rotations.iter().zip(&is.rotations) {
                prop_assert!(rotation::angle_between(a, b) < 1e-9);
            }
        }
    }
}
