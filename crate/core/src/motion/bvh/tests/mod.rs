//! Reading of valid, unusual and broken files.

mod warnings;

use crate::motion::bvh::parse::{read, read_at};
use crate::motion::bvh::write::write;
use crate::motion::clip::Clip;
use crate::motion::pose::PoseMapping;
use crate::motion::recording::Recording;
use crate::motion::skeleton::{Channel, Joint, MAX_POSITIONS, Skeleton};
use crate::motion::testing::any_clip;
use nalgebra::DMatrix;
use proptest::prelude::*;

const SMALL: &str = "HIERARCHY
ROOT Hips
{
\tOFFSET 0 0 0
\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
\tJOINT Chest
\t{
\t\tOFFSET 0 5.21 0
\t\tCHANNELS 3 Zrotation Xrotation Yrotation
\t\tEnd Site
\t\t{
\t\t\tOFFSET 0 -7.5 1
\t\t}
\t}
}
MOTION
Frames: 3
Frame Time: 0.0333333
1 2 3 4 5 6 7 8 9
2 2 3 4 5 6 7 8 9
3 2 3 4 5 6 7 8 9.5
";

fn message(text: &str) -> String {
    read("walk.bvh", text.as_bytes()).unwrap_err().to_string()
}

/// The small file with one thing replaced.
fn with(from: &str, to: &str) -> String {
    assert!(SMALL.contains(from), "{from}");
    SMALL.replacen(from, to, 1)
}

fn read_as_small(text: &[u8]) -> Recording {
    let clip = read("walk.bvh", text).unwrap_or_else(|error| panic!("{error}"));
    let small = read("walk.bvh", SMALL.as_bytes()).unwrap();
    assert_eq!((&clip.skeleton, &clip.values), (&small.skeleton, &small.values));
    clip
}

#[test]
fn a_small_file_is_read_as_it_is_written() {
    let clip = read_as_small(SMALL.as_bytes());
    assert_eq!((clip.frames(), clip.frame_time), (3, 0.0333333));
    assert_eq!(clip.skeleton.joints[1].parent, Some(0));
    assert_eq!(
        clip.skeleton.joints[1].channels,
        [Channel::Zrotation, Channel::Xrotation, Channel::Yrotation]
    );
    assert_eq!(clip.skeleton.joints[1].end_sites, [[0.0, -7.5, 1.0]]);
    assert_eq!(clip.values[(2, 8)], 9.5);
    assert!(clip.warnings.is_empty());
    assert_eq!(clip.sha256, crate::motion::clip::sha256(SMALL.as_bytes()));
}

#[test]
fn line_ends_blanks_and_case_do_not_matter() {
    for text in [
        SMALL.replace('\n', "\r\n"),
        SMALL.replace('\n', "\r"),
        SMALL.replacen('\n', "\r\n", 9).replacen("\n2", "\r2", 1),
        SMALL.replace('\n', "\n\n \t\n"),
        SMALL.replace(' ', "\t"),
        SMALL.replace("\t", ""),
        SMALL.to_lowercase().replace("hips", "Hips").replace("chest", "Chest"),
        SMALL.to_uppercase().replace("HIPS", "Hips").replace("CHEST", "Chest"),
        SMALL.replace("Frame Time:", "Frames Time:"),
        SMALL.replace("Frame Time: 0.", "Frame Time:\t."),
        SMALL.replace("Frames: 3", "Frames:\t3 "),
        SMALL.replace("Frames: 3", "Frames 3"),
        SMALL.replace("Frames: 3\nFrame Time: 0.0333333", "Frame Time: 0.0333333\nFrames:\n3"),
        SMALL.replace("1 2 3 4", "1.0e0 +2 3E+0 40e-01"),
        SMALL.replace("\n\t{", " {").replace("\n{", "{"),
        SMALL.replace("4 5 6 7", "4 5\n6 7"),
        SMALL.replace("9\n2 2", "9 2 2"),
        SMALL.trim_end().to_owned(),
        format!("\u{FEFF}{SMALL}"),
        format!("{SMALL}\u{1A}"),
        SMALL.replace("JOINT Chest", "JOINT\nChest"),
    ] {
        read_as_small(text.as_bytes());
    }
    let utf16: Vec<u8> =
        [0xFEFF].into_iter().chain(SMALL.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    assert!(read_as_small(&utf16).warnings[0].contains("UTF-16"));
    for unit in [u16::to_le_bytes, u16::to_be_bytes] {
        let without_mark: Vec<u8> = SMALL.encode_utf16().flat_map(unit).collect();
        assert!(read_as_small(&without_mark).warnings[0].contains("UTF-16"));
    }
}

#[test]
fn errors_say_where_what_was_expected_and_what_was_found() {
    let name = "a channel name (Xposition … Zrotation)";
    let cases = [
        (with("3 Zrotation", "3 Wrotation"), format!(r#"line 9: expected {name}, found "Wrotation""#)),
        (
            with("5.21 0", "0.0-7.5"),
            r#"line 8: expected a number (is a blank missing?), found "0.0-7.5""#.into(),
        ),
        (with("HIERARCHY\n", ""), r#"line 1: expected HIERARCHY, found "ROOT""#.into()),
        (with("ROOT Hips", "JOINT Hips"), r#"line 2: expected ROOT, found "JOINT""#.into()),
        (String::new(), "line 1: expected HIERARCHY, found the end of the file".into()),
        (
            "time,knee\n0,1.5\n".to_owned(),
            "line 1: expected a BVH file, found a table of numbers, as CSV".into(),
        ),
        (
            "knee;hip\n1,5;2,5\n".to_owned(),
            "line 1: expected a BVH file, found a table of numbers, as CSV".into(),
        ),
        (with("MOTION", "ROOT Other\n{\n}\nMOTION"), "line 16: expected MOTION, found a second ROOT".into()),
        (with("}\nMOTION", "MOTION"), r#"line 15: expected JOINT, End Site or "}", found "MOTION""#.into()),
        (
            SMALL[..SMALL.find("6 X").unwrap()].to_owned(),
            r#"line 5: expected a number of channels from 0 to 6, found the end"#.into(),
        ),
        (with("CHANNELS 3", "CHANNELS 4"), format!(r#"line 10: expected {name}, found "End""#)),
        (
            with("CHANNELS 3", "CHANNELS 2"),
            r#"line 9: expected JOINT, End Site or "}", found "Yrotation""#.into(),
        ),
        (with("CHANNELS 3", "CHANNELS -1"), r#"from 0 to 6, found "-1""#.into()),
        (with("3 Zrotation X", "3 Xrotation X"), r#"line 9: expected each channel once in a joint"#.into()),
        (with("\t\tOFFSET 0 5.21 0\n", ""), r#"line 13: expected OFFSET, found "}""#.into()),
        (with("OFFSET 0 -7.5 1", "OFFSET 0 -7.5"), r#"line 13: expected a number, found "}""#.into()),
        (with("Frames: 3\n", ""), r#"line 18: expected Frames:, found "1 2 3"#.into()),
        (with("Frame Time: 0.0333333\n", ""), r#"line 18: expected Frame Time:, found "1 2 3"#.into()),
        (with("0.0333333", "0"), r#"line 18: expected the seconds of a frame"#.into()),
        (with("0.0333333", "NaN"), r#"line 18: expected the seconds of a frame"#.into()),
        (
            with("0.0333333", ""),
            r#"not a rate or milliseconds (--clip-fps F states a rate), found """#.into(),
        ),
        (
            with("0.0333333", "30"),
            r#"line 18: expected the seconds of a frame, from 0.00001 to 10, not"#.into(),
        ),
        (with("8 9\n2", "8 nan\n2"), r#"line 19: expected a number from -1e9 to 1e9, found "nan""#.into()),
        (
            with("8 9\n2", "8 1e999\n2"),
            r#"line 19: expected a number from -1e9 to 1e9, found "1e999""#.into(),
        ),
        (
            with("8 9\n2", "8 9,5\n2"),
            r#"line 19: expected a number with a decimal point, found "9,5""#.into(),
        ),
        (with("8 9\n2", "8 x9\n2"), r#"line 19: expected a number, found "x9""#.into()),
        (with("8 9\n2", "8\n2"), "line 19: expected 9 values in the row of frame 1, found 8".into()),
        (with("8 9\n2", "8 9 10\n2"), "line 19: expected 9 values in the row of frame 1, found 10".into()),
        (with(" 8 9.5", ""), "line 21: expected 9 values in the row of frame 3, found 7".into()),
        (with("Frames: 3", "Frames: 30"), r#"expected 30 rows as "Frames:" declares, found 3"#.into()),
        (with("Frames: 3", "Frames: 999999999"), "at most 1666666 frames of a body with 3 joints".into()),
        (SMALL[..SMALL.find("1 2 3").unwrap()].to_owned(), "expected at least one row of values".into()),
    ];
    for (text, wanted) in cases {
        let message = message(&text);
        assert!(
            message.starts_with("walk.bvh, line ") && message.contains(&wanted),
            "{message}\nwanted: {wanted}"
        );
    }
}

#[test]
fn lines_are_counted_alike_with_all_line_ends() {
    let broken = with("3 Zrotation", "3 Wrotation");
    for end in ["\n", "\r\n", "\r"] {
        assert!(message(&broken.replace('\n', end)).contains("line 9:"));
    }
}

#[test]
fn positions_of_a_joint_replace_its_offset() {
    let text = with("3 Zrotation", "6 Xposition Yposition Zposition Zrotation")
        .replace("7 8 9", "0 5.21 0 0 0 0")
        .replace("4 5 6", "0 0 0");
    let clip = read("a", text.as_bytes()).unwrap();
    let places = clip.into_clip().world_pose(0).positions;
    assert_eq!(places[1], nalgebra::Vector3::new(1.0, 7.21, 3.0));
}

#[test]
fn an_inner_joint_that_moves_along_one_axis_is_written_with_its_position() {
    let text =
        with("3 Zrotation", "6 Xposition Yposition Zposition Zrotation").replace("7 8 9", "0 5.21 0 7 8 9");
    let clip = read("a", text.replacen("0 5.21 0 7", "1.5 5.21 0 7", 1).as_bytes()).unwrap().with_all_rows();
    let again = read("a", write(&clip).as_bytes()).unwrap();
    assert_eq!(
        (&again.skeleton.joints[1].channels, &again.values),
        (&clip.skeleton.joints[1].channels, &clip.values)
    );
    // A change of a hundred thousandth of the body's height is rounding.
    let rounded = text.replacen("0 5.21 0 7", "5e-5 5.21 0 7", 1);
    let written = write(&read("a", rounded.as_bytes()).unwrap().with_all_rows());
    assert_eq!(read("a", written.as_bytes()).unwrap().skeleton.joints[1].channels.len(), 3);
}

#[test]
fn deep_and_large_hierarchies_do_not_crash_the_reader() {
    let deep: String = (0..1_999).map(|_| "JOINT a { OFFSET 0 1 0 CHANNELS 1 Xrotation ").collect();
    let rows = "0 ".repeat(2_000);
    let text = format!(
        "HIERARCHY ROOT r {{ OFFSET 0 0 0 CHANNELS 1 Yrotation {deep}{} MOTION\nFrames: 1\nFrame Time: \
         .1\n{rows}",
        "}".repeat(2_000)
    );
    let clip = read("deep", text.as_bytes()).unwrap().into_clip();
    assert_eq!(clip.skeleton.joints.len(), 2_000);
    assert_eq!(read("deep", write(&clip).as_bytes()).unwrap().skeleton, clip.skeleton);
    // The reader stops at the first joint too many, long before the end of the file.
    for more in [2_000, 200_000] {
        let endless = format!("HIERARCHY ROOT r {{ OFFSET 0 0 0 {}", "JOINT a { OFFSET 0 0 0 ".repeat(more));
        assert!(message(&endless).contains("at most 2000 joints"));
    }
    let ends = "End Site { OFFSET 0 1 0 } ".repeat(2_000);
    let text = format!("HIERARCHY ROOT r {{ OFFSET 0 0 0 CHANNELS 1 Yrotation {ends}}} MOTION\nFrames: 1\n");
    assert!(read("ends", format!("{text}Frame Time: .1\n1e9").as_bytes()).is_ok());
    assert!(read("ends", format!("{text}Frame Time: .1\n1.1e9").as_bytes()).is_err());
    let ends = "End Site { OFFSET 0 0 0 } ".repeat(200_000);
    assert!(message(&format!("HIERARCHY ROOT r {{ OFFSET 0 0 0 {ends}")).contains("at most 2000 joints"));
}

#[test]
fn characters_in_names_cannot_break_a_written_file() {
    let mut clip = read("a", SMALL.as_bytes()).unwrap().into_clip();
    clip.skeleton.joints[1].name = "x\n}{ MOTION".to_owned();
    let again = read("b", write(&clip).as_bytes()).unwrap();
    assert_eq!(again.skeleton.joints[1].name, "x___ MOTION");
    assert_eq!(again.values, clip.values);
}

#[test]
fn joints_out_of_depth_first_order_are_written_with_their_values() {
    let joint = |name: &str, parent, channels: &[Channel]| Joint {
        name: name.to_owned(),
        parent,
        offset: [0.0, 1.0, 0.0],
        channels: channels.to_vec(),
        end_sites: Vec::new(),
    };
    let skeleton = Skeleton {
        joints: vec![
            joint("root", None, &[Channel::Xrotation]),
            joint("a", Some(0), &[Channel::Yrotation]),
            joint("b", Some(0), &[Channel::Zrotation]),
            joint("a2", Some(1), &[Channel::Xrotation, Channel::Yrotation]),
        ],
    };
    let clip = Clip::new("tree", skeleton, 0.1, DMatrix::from_row_slice(1, 5, &[1.0, 2.0, 3.0, 4.0, 5.0]));
    let again = read("tree", write(&clip).as_bytes()).unwrap();
    let names: Vec<&str> = again.skeleton.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(names, ["root", "a", "a2", "b"]);
    assert_eq!(again.values.row(0).iter().copied().collect::<Vec<_>>(), [1.0, 2.0, 4.0, 5.0, 3.0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn any_clip_is_read_back_as_it_was_written(clip in any_clip()) {
        // Positions that do not change become offsets: see below.
        prop_assume!(clip.frames() > 1);
        let again = read("random.bvh", write(&clip).as_bytes()).unwrap();
        prop_assert_eq!(&again.values, &clip.values);
        // The offset of a root with position channels has no meaning and is written as zero.
        let mut skeleton = clip.skeleton.clone();
        let root = &mut skeleton.joints[0];
        if root.is_placed() {
            root.offset = [0.0; 3];
        }
        prop_assert_eq!(&again.skeleton, &skeleton);
        prop_assert_eq!(again.frame_time, clip.frame_time);
        prop_assert_eq!(again.sha256, clip.sha256);
    }

    /// Other readers add position channels of inner joints to the offsets.
    #[test]
    fn inner_joints_that_keep_their_position_are_written_with_rotations_alone(clip in any_clip()) {
        let mut clip = clip;
        for (start, joint) in clip.skeleton.channel_starts().into_iter().zip(&clip.skeleton.joints).skip(1) {
            for (column, channel) in (start..).zip(&joint.channels) {
                if !channel.is_rotation() {
                    let first = clip.values[(0, column)];
                    clip.values.column_mut(column).fill(first);
                }
            }
        }
        let again = read("random.bvh", write(&clip).as_bytes()).unwrap();
        let inner = again.skeleton.joints.iter().skip(1).flat_map(|joint| &joint.channels);
        prop_assert!(inner.into_iter().all(|channel| channel.is_rotation()));
        for frame in 0..clip.frames() {
            let local = again.skeleton.local_pose(&again.values, frame);
            let pose = again.skeleton.forward_kinematics(&local.rotations, &local.positions);
            for (old, new) in clip.world_pose(frame).positions.iter().zip(&pose.positions) {
                prop_assert!((old - new).norm() < 1e-9, "{} {}", old, new);
            }
        }
    }

    #[test]
    fn random_bytes_do_not_crash_the_reader(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let _ = read("noise", &bytes);
    }

    #[test]
    fn a_changed_file_crashes_neither_the_reader_nor_later_steps(
        at in 0..SMALL.len(), length in 0..40_usize, put in "[-0-9. {}\n\rA-Za-z]{0,12}"
    ) {
        let mut text = SMALL.to_owned();
        text.replace_range(at..(at + length).min(SMALL.len()), &put);
        match read("changed", text.as_bytes()) {
            Ok(recording) => {
                // A recording that was read can be used in all later steps.
                let clip = recording.into_clip();
                prop_assert!(clip.skeleton.validate().is_ok());
                prop_assert!(clip.stage_positions().iter().all(|x| x.is_finite()));
                let mapping = PoseMapping::new(&clip);
                let encoded = mapping.encode(&clip).unwrap();
                prop_assert!(encoded.y.iter().all(|x| x.is_finite()));
                mapping.decode(&encoded.y, &encoded.start, clip.frame_time).unwrap();
                clip.resample(30.0).unwrap();
            }
            Err(error) => {
                let lines = text.split(['\n', '\r']).count();
                prop_assert!(error.line >= 1 && error.line <= lines, "{}", error);
            }
        }
    }
}

/// A file of 150 kB once took a minute and 5 GB: joints without channels are short in the file, but have a
/// position in every frame.
#[test]
fn a_small_file_cannot_ask_for_much_memory() {
    let joints = 1_999;
    let inner = "JOINT j { OFFSET 0 1 0 ".repeat(joints) + &"}".repeat(joints);
    let header = format!("HIERARCHY ROOT r {{ OFFSET 0 0 0 CHANNELS 1 Xposition {inner} }} MOTION\n");
    let most = MAX_POSITIONS / (joints + 1);
    for declared in [50_000, 5] {
        let rows = "0\n".repeat(50_000);
        let found = message(&format!("{header}Frames: {declared}\nFrame Time: 0.01\n{rows}"));
        assert!(found.contains(&format!("at most {most} frames of a body with 2000 joints")), "{found}");
    }
    let rows = "0\n".repeat(most);
    let clip = read("walk.bvh", format!("{header}Frames: {most}\nFrame Time: 0.01\n{rows}").as_bytes())
        .unwrap()
        .into_clip();
    assert_eq!(clip.stage_positions().len(), most * 2000 * 3);
}

/// Every dash of the row was once tried as the blank that is missing: an hour for two megabytes.
#[test]
fn a_row_without_blanks_is_refused_at_once() {
    let row = "0".repeat(1_000_000) + &"-".repeat(1_000_000);
    let found = message(&with("1 2 3 4 5 6 7 8 9", &row));
    assert!(found.contains("line 19: expected a number, found \"0000"), "{found}");
}
