//! What is read with a warning: odd counts, rates, names and rows.

use super::*;

#[test]
fn row_counts_that_are_a_little_off_are_read_with_a_warning() {
    for declared in [2, 4, 1] {
        let clip = read("walk.bvh", with("Frames: 3", &format!("Frames: {declared}")).as_bytes()).unwrap();
        assert_eq!(clip.frames(), 3);
        assert!(clip.warnings[0].contains(&format!("declares {declared} rows, the file has 3")));
    }
}

/// Recorders that were ended leave such headers.
#[test]
fn a_number_of_frames_that_was_never_filled_in_is_read_with_a_warning() {
    for text in ["", "   ", "0", "-1", "%d", "4294967295"] {
        let clip = read("walk.bvh", with("Frames: 3", &format!("Frames:{text}")).as_bytes()).unwrap();
        assert_eq!((clip.frames(), clip.frame_time), (3, 0.0333333));
        let warning = format!("line 17: the number of frames is missing (found {:?}): all 3", text.trim());
        assert!(clip.warnings[0].starts_with(&warning), "{:?}", clip.warnings);
    }
    let next_line = read("walk.bvh", with("Frames: 3", "Frames:\n3").as_bytes()).unwrap();
    assert!(next_line.warnings.is_empty());
}

#[test]
fn a_stated_rate_replaces_the_frame_time() {
    for time in ["30", "0", "0.0333333", ""] {
        let clip = read_at("walk.bvh", with("0.0333333", time).as_bytes(), Some(120.0)).unwrap();
        assert_eq!((clip.frame_time, clip.warnings.len()), (1.0 / 120.0, 0));
    }
    let error = read_at("walk.bvh", SMALL.as_bytes(), Some(0.0)).unwrap_err().to_string();
    assert!(error.contains("expected a stated rate from 0.1 to 10000 frames a second, found \"0\""));
    for seconds in ["1", "2"] {
        let slow = read("walk.bvh", with("0.0333333", seconds).as_bytes()).unwrap();
        assert!(slow.warnings[0].starts_with(&format!("line 18: a frame lasts {seconds} s; is that a rate")));
    }
}

#[test]
fn odd_names_are_kept_with_a_warning() {
    let clip = read("a", with("Chest", "mixamorig:Left Arm").as_bytes()).unwrap();
    assert_eq!(clip.skeleton.joints[1].name, "mixamorig:Left Arm");
    assert!(clip.warnings[0].contains("blanks"));
    let clip = read("a", with("Chest", "Hips").as_bytes()).unwrap();
    assert!(clip.warnings[0].contains("2 joints share their names"));
    let clip = read("a", with("Chest", "").as_bytes()).unwrap();
    assert!(clip.skeleton.joints[1].name.is_empty() && clip.warnings.len() == 1);
    let latin1: Vec<u8> = with("Chest", "Br#st").bytes().map(|b| if b == b'#' { 0xFC } else { b }).collect();
    let clip = read("a", &latin1).unwrap();
    assert_eq!(clip.skeleton.joints[1].name, "Brüst");
    assert!(clip.warnings[0].contains("Latin-1"));
}

#[test]
fn a_warning_quotes_three_names() {
    let quoted = |count: usize| {
        let joint = |k| format!("JOINT a:{k} {{ OFFSET 0 1 0 CHANNELS 0 }} ");
        let joints: String = (0..count).map(joint).collect();
        let text = format!("HIERARCHY ROOT r {{ OFFSET 0 0 0 CHANNELS 1 Yrotation {joints}}}");
        let warnings =
            read("a", format!("{text} MOTION\nFrames: 1\nFrame Time: .1\n0").as_bytes()).unwrap().warnings;
        warnings[0].split(['(', ')']).nth(1).unwrap().to_owned()
    };
    assert_eq!(quoted(3), "\"a:0\", \"a:1\", \"a:2\"");
    assert_eq!(quoted(4), "\"a:0\", \"a:1\", \"a:2\", …");
}

#[test]
fn an_error_quotes_forty_characters_of_a_word() {
    let found = |count: usize| message(&with("5.21", &"x".repeat(count)));
    assert!(found(40).contains(&format!("found \"{}\"", "x".repeat(40))), "{}", found(40));
    assert!(found(41).contains(&format!("found \"{}…\"", "x".repeat(40))), "{}", found(41));
}

#[test]
fn frozen_and_empty_rows_give_a_warning() {
    let rows = "2 2 3 4 5 6 7 8 9\n";
    let clip = read("a", (with("Frames: 3", "Frames: 7") + &rows.repeat(4)).as_bytes()).unwrap();
    assert!(clip.warnings[0].contains("the last 4 rows are the same"), "{:?}", clip.warnings);
    let clip = read("a", with("2 2 3 4 5 6 7 8 9", "0 0 0 0 0 0 0 0 0").as_bytes()).unwrap();
    assert!(clip.warnings[0].contains("1 of 3 rows hold only zeros"), "{:?}", clip.warnings);
    let clip = read("a", with("2 2 3 4 5 6 7 8 9", "2 0 3 4 5 6 7 8 9").as_bytes()).unwrap();
    assert!(clip.warnings.is_empty(), "{:?}", clip.warnings);
    // A body at rest in all rows is no fault of the recorder.
    let header = &SMALL[..SMALL.find("1 2 3").unwrap()];
    let still = read("a", (header.to_owned() + &"0 0 0 0 0 0 0 0 0\n".repeat(3)).as_bytes()).unwrap();
    assert!(still.warnings.is_empty(), "{:?}", still.warnings);
}
