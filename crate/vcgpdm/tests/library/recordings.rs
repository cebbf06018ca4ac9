//! Reads recorded clips, writes them, and maps them to rows of Y and back.
//!
//! The clips are not part of the project: VCGPDM_CLIPS names their folder. `npm test -- --only recordings`
//! runs these tests.

use nalgebra::DMatrix;
use std::path::PathBuf;
use vcgpdm_core::motion::pose::PoseMapping;
use vcgpdm_core::motion::{Clip, Recording, bvh, parts};

fn folder() -> PathBuf {
    std::env::var_os("VCGPDM_CLIPS").expect("VCGPDM_CLIPS names the folder of the recordings").into()
}

/// All files with their paths relative to the folder.
fn recordings(folders: &[&str]) -> Vec<(String, Recording)> {
    let root = folder();
    let mut recordings = Vec::new();
    for folder in folders {
        let entries = std::fs::read_dir(root.join(folder)).unwrap();
        let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
        files.sort();
        for file in files {
            let name = file.file_name().unwrap().to_str().unwrap().to_owned();
            let bytes = std::fs::read(&file).unwrap();
            let recording = bvh::read(&name, &bytes).unwrap_or_else(|error| panic!("{error}"));
            recordings.push((format!("{folder}/{name}"), recording));
        }
    }
    assert!(!recordings.is_empty());
    recordings
}

/// The same files as clips.
fn clips(folders: &[&str]) -> Vec<(String, Clip)> {
    recordings(folders).into_iter().map(|(path, recording)| (path, recording.into_clip())).collect()
}

const ALL: [&str; 3] = ["cmu-walk", "varied", "tricky"];

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn written_clips_read_back_the_same() {
    for (path, clip) in clips(&ALL) {
        let again = bvh::read("again.bvh", bvh::write(&clip).as_bytes()).unwrap();
        // The offset of a root with position channels has no meaning and is written as zero.
        let mut skeleton = clip.skeleton.clone();
        let root = &mut skeleton.joints[0];
        if root.is_placed() {
            root.offset = [0.0; 3];
        }
        assert_eq!(again.frame_time, clip.frame_time, "{path}");
        if again.values.ncols() < clip.values.ncols() {
            // Positions of inner joints that do not change are offsets now. The file rounds them.
            assert!(skeleton.joints[1..].iter().any(|joint| joint.channels.len() > 3), "{path}");
            let (place, turn) = difference(&again.into_clip(), &clip, clip.skeleton.height());
            assert!(place < 1e-4 && turn < 1e-12, "{path}: {place} of its height, {turn} rad");
            continue;
        }
        assert_eq!(again.skeleton, skeleton, "{path}");
        assert_eq!(again.clone().into_clip().world_pose(0).positions, clip.world_pose(0).positions, "{path}");
        assert_eq!(again.values, clip.values, "{path}");
    }
}

/// The largest differences of node positions (in body heights) and of joint rotations (radians).
fn difference(a: &Clip, b: &Clip, height: f64) -> (f64, f64) {
    assert_eq!(a.frames(), b.frames());
    let (mut place, mut turn) = (0.0_f64, 0.0_f64);
    for frame in 0..a.frames() {
        let (p, q) = (a.world_pose(frame), b.world_pose(frame));
        for (x, y) in p.positions.iter().zip(&q.positions) {
            place = place.max((x - y).norm() / height);
        }
        for (x, y) in p.rotations.iter().zip(&q.rotations) {
            turn = turn.max((x.inverse() * y).angle());
        }
    }
    (place, turn)
}

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn decoded_rows_of_y_equal_the_motion() {
    for (path, clip) in clips(&ALL) {
        let mapping = PoseMapping::new(&clip);
        let encoded = mapping.encode(&clip).unwrap();
        let decoded = mapping.decode(&encoded.y, &encoded.start, clip.frame_time).unwrap();
        let (place, turn) = difference(&clip, &decoded, mapping.stage().height);
        let jump = (0..encoded.y.ncols())
            .map(|c| {
                encoded.y.column(c).as_slice().windows(2).map(|w| (w[1] - w[0]).abs()).fold(0.0, f64::max)
            })
            .fold(0.0, f64::max);
        let stage = clip.stage_positions();
        let fast = mapping.decode_positions(&encoded.y, &encoded.start).unwrap();
        let far = stage.iter().zip(&fast).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        println!("{path}: place {place:.1e}, turn {turn:.1e}, largest step {jump:.2}, stage {far:.1e}");
        assert!(place < 1e-9, "{path}: {place}");
        assert!(turn < 1e-9, "{path}: {turn}");
        assert!(far < 1e-5, "{path}: {far}");
    }
}

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn the_variance_of_the_walks_is_that_of_the_reference() {
    let clips = clips(&["cmu-walk"]);
    let slow: Vec<Clip> = clips.iter().map(|(_, clip)| clip.resample(30.0).unwrap()).collect();
    assert!(slow.iter().all(|clip| clip.warnings.iter().any(|warning| warning.contains("T-pose"))));
    let mapping = PoseMapping::new(&slow[0]);
    let rows: Vec<DMatrix<f64>> = slow.iter().map(|clip| mapping.encode(clip).unwrap().y).collect();
    let frames = rows[..5].iter().map(|y| y.nrows()).sum::<usize>() + 5;
    assert_eq!((frames, mapping.column_count()), (520, 96));
    // The reference's preprocessing of trial 35_06 has this mean variance over its columns.
    let variance = rows[5].row_variance().mean();
    println!("mean variance per column of trial 6: {variance:.6}");
    assert!((variance - 0.00586).abs() < 0.00001, "{variance}");
}

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn the_root_has_no_jumps_even_in_a_cartwheel() {
    for (path, clip) in clips(&["cmu-walk", "varied"]) {
        let y = PoseMapping::new(&clip).encode(&clip).unwrap().y;
        for column in 0..6 {
            let steps =
                y.column(column).as_slice().windows(2).map(|w| (w[1] - w[0]).abs()).fold(0.0, f64::max);
            // One body that bends to the ground comes near gimbal lock at 24 frames a second.
            let largest = if path.ends_with("49_06.bvh") { 0.3 } else { 0.6 };
            assert!(steps < largest, "{path}, column {column}: {steps}");
        }
    }
}

/// The entries of the index: path, up axis, body height if it was measured, and whether row 0 is an added
/// T-pose.
fn index() -> Vec<(String, String, Option<f64>, bool)> {
    let text = std::fs::read_to_string(folder().join("INDEX.tsv")).unwrap();
    let fields = text.lines().skip(1).map(|line| line.split('\t').collect::<Vec<_>>());
    let entry = |row: Vec<&str>| {
        (row[0].to_owned(), row[8].to_lowercase(), row[9].parse().ok(), row[1].contains("T-pose"))
    };
    fields.map(entry).collect()
}

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn up_axes_heights_and_parts_are_found() {
    let index = index();
    for (path, clip) in clips(&ALL) {
        let found = parts::presets(&clip.skeleton);
        let ids: Vec<&str> = found.iter().map(|preset| preset.id.as_str()).collect();
        let (up, height) = (clip.up_axis(), clip.height());
        println!("{path}: {ids:?}, up {}, height {height:.2}, {:?}", up.letter(), clip.warnings);
        let person = clip.skeleton.joints.len() > 10;
        assert_eq!(ids.len(), if person { 4 } else { 1 }, "{path}");
        for preset in &found {
            parts::check(&preset.parts, &clip.skeleton).unwrap();
        }
        let Some((_, listed_up, Some(listed), _)) = index.iter().find(|(listed, ..)| *listed == path) else {
            continue;
        };
        assert_eq!(up.letter(), listed_up.trim_end_matches('?'), "{path}");
        // The index has the extent in the motion, which is smaller than the height for a crouching body.
        let least = if person && !path.contains("mocapbank") { 0.88 } else { 0.5 };
        assert!((least..1.06).contains(&(listed / height)), "{path}: {height}, listed {listed}");
    }
}

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn only_clips_of_subject_35_have_its_body() {
    let clips = clips(&["cmu-walk", "varied"]);
    let first = &clips[0].1.skeleton;
    for (path, clip) in &clips {
        let same = first.same_body(&clip.skeleton);
        println!("{path}: {same:?}");
        assert_eq!(same.is_ok(), path.contains("/35_"), "{path}");
    }
}

#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn only_added_t_poses_are_dropped() {
    let index = index();
    for (path, Recording { name, skeleton, frame_time, values, .. }) in recordings(&ALL) {
        let Some((.., listed)) = index.iter().find(|(listed, ..)| *listed == path) else { continue };
        // All rows as a clip, to resample them as a file of another rate would have them.
        let rows = Clip::new(&name, skeleton, frame_time, values);
        for fps in [1.0 / frame_time, 60.0, 30.0, 10.0] {
            let rows = rows.resample(fps).unwrap();
            let recording = |rows: &Clip| {
                Recording::new(&name, rows.skeleton.clone(), rows.frame_time, rows.values.clone())
            };
            let clip = recording(&rows).into_clip();
            assert_eq!(
                clip.frames() + usize::from(*listed),
                rows.frames(),
                "{path} at {fps} frames a second"
            );
            // The rest does not begin with another T-pose.
            assert_eq!(recording(&clip).rows_before_motion(), 0, "{path}");
        }
    }
}

/// The files of subject 7 have one row at rest before the walk, the last file two.
#[test]
#[ignore = "needs recordings: set VCGPDM_CLIPS"]
fn every_row_before_a_walk_of_subject_7_is_dropped() {
    for (path, recording) in recordings(&["cmu-07"]) {
        let added = if path.contains("07_12") { 2 } else { 1 };
        assert_eq!(recording.rows_before_motion(), added, "{path}");
        let clip = recording.clone().into_clip();
        assert_eq!(clip.values, recording.values.rows(added, recording.frames() - added), "{path}");
    }
}
